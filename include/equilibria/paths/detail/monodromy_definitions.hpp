/// \file
/// See paths/monodromy.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/homotopy/arc_homotopy.hpp>
#include <equilibria/paths/coincidence.hpp>
#include <equilibria/paths/detail/family_newton.hpp>
#include <equilibria/paths/monodromy.hpp>
#include <equilibria/paths/path_set.hpp>
#include <equilibria/paths/solve_along.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/start/coefficient_path.hpp>

namespace equilibria {

namespace detail {

/// Sums over points of exp(i theta), exp(-i theta) and the coordinates, and of their absolute values.
class RootTrace {
public:
    explicit RootTrace(const RuntimeSizes& sizes)
        : sizes_(sizes), sum_(static_cast<std::size_t>(2 * sizes.angles + sizes.coordinates)), size_(sum_.size()) {}

    void add(double weight, const UnknownArray<RuntimeUnknowns, std::complex<double>>& q) {
        std::size_t at = 0;
        const auto add = [&](const std::complex<double>& z) {
            sum_[at] += weight * z;
            size_[at++] += std::abs(weight) * std::abs(z);
        };
        for (int u = 0; u < sizes_.unknowns; ++u)
            if (u < sizes_.angles) {
                const std::complex<double> z = std::exp(std::complex<double>(-q[u].imag(), q[u].real()));
                add(z);
                add(1.0 / z);
            } else {
                add(q[u]);
            }
    }
    /// The largest sum, relative to its terms.
    double largest() const {
        double y = 0;
        for (std::size_t k = 0; k < sum_.size(); ++k)
            if (size_[k] > 0) y = std::max(y, std::abs(sum_[k]) / size_[k]);
        return y;
    }

private:
    RuntimeSizes sizes_;
    std::vector<std::complex<double>> sum_;
    std::vector<double> size_;
};

/// One search.
class MonodromySearch {
public:
    using Number = std::complex<double>;

    MonodromySearch(const SystemFamily& family, std::span<const double> typical, const RunOptions& run,
                    const MonodromyOptions& options, const TrackerOptions& tracker)
        : family_(&family), typical_(typical.begin(), typical.end()), run_(run), options_(&options), tracker_(tracker),
          generator_(run.seed), newton_(family, {}) {
        require(static_cast<int>(typical.size()) == family.parameters(), "typical", typical.size(),
                "must have as many parameters as the family");
        require_finite(typical_, "typical");
        for (const double p : typical_) sizes_.push_back(p == 0 ? 1 : std::abs(p));
        for (const int k : options.fixed) {
            require(k >= 0 && k < family.parameters(), "fixed", k, "must be the number of a parameter");
            sizes_[static_cast<std::size_t>(k)] = 0;
        }
        require(std::any_of(sizes_.begin(), sizes_.end(), [](double s) { return s > 0; }), "fixed",
                options.fixed.size(), "must leave a parameter free");
        newton_ = FamilyNewton(family, sizes_);
        y_.seed = run.seed;
        y_.trace = std::numeric_limits<double>::quiet_NaN();
        run_.progress = nullptr;
    }

    MonodromyRoots roots(const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
        const Stopwatch clock;
        if (find_first()) {
            std::size_t decided = 0;  // how many roots the last trace test was of
            while (y_.end == MonodromyEnd::no_root) {
                const std::size_t before = known_.size();
                go_round();
                ++y_.loops;
                if (progress) progress(static_cast<std::uint64_t>(y_.loops), 0);
                if (known_.size() == before) probe();  // for what no loop leads to
                y_.quiet_loops = known_.size() > before ? 0 : y_.quiet_loops + 1;
                if (y_.quiet_loops > 0 && decided < known_.size() && traced()) decided = known_.size();
                if (run_.cancelled())
                    y_.end = MonodromyEnd::cancelled;
                else if (decided == known_.size() && y_.trace < 1e-8)
                    y_.end = MonodromyEnd::trace_test;
                else if (y_.quiet_loops >= options_->quiet_loops)
                    y_.end = MonodromyEnd::quiet_loops;
                else if (y_.loops >= options_->most_loops)
                    y_.end = MonodromyEnd::most_loops;
            }
        }
        y_.roots = std::move(found_);
        y_.seconds = clock.seconds();
        return std::move(y_);
    }

private:
    /// Of the typical sizes, turned by less than a right angle or by any where the typical value is 0: functions of
    /// parameters with a cut have it where these are negative.
    std::vector<Number> random_parameters() {
        std::vector<Number> p;
        for (std::size_t k = 0; k < sizes_.size(); ++k) {
            const double size = uniform(generator_, 0.5, 1.5), turn = uniform(generator_, -1.5, 1.5);
            if (sizes_[k] == 0)
                p.emplace_back(typical_[k]);
            else if (typical_[k] == 0)
                p.push_back(std::polar(size, 2 * turn));
            else
                p.push_back(typical_[k] * std::polar(size, turn));
        }
        return p;
    }

    /// The generic member, and a root of it.
    bool find_first() {
        while (y_.newton_starts < options_->newton_starts && !run_.cancelled()) {
            ++y_.newton_starts;
            y_.parameters = random_parameters();
            if (seek()) return true;
        }
        if (run_.cancelled()) y_.end = MonodromyEnd::cancelled;
        return false;
    }
    /// A root of another member, at parameters of its own, followed to the generic one; returns whether it is new
    /// there.
    bool seek() {
        FamilyNewton::Pair at{newton_.random_unknowns(generator_), random_parameters()};
        if (!newton_.solve(at)) return false;
        try {
            return add(follow(CoefficientPath::between(*family_, at.p, y_.parameters, generator_), {at.q})) > 0;
        } catch (const InvalidArgument&) {  // poles around it
            return false;
        }
    }
    /// What no loop leads to: roots of the generic member, and of others, by Newton's method from random points.
    void probe() {
        const auto coefficients = family_->coefficients(y_.parameters);
        std::vector<Root<RuntimeUnknowns>> roots;
        for (int k = 0; k < options_->newton_starts; ++k) {
            Root<RuntimeUnknowns> root;
            root.q = newton_.random_unknowns(generator_);
            if (newton_.solve(root.q, coefficients)) roots.push_back(std::move(root));
        }
        y_.found_by_newton += add(roots);
        for (int k = 0; k < options_->newton_starts / 10 && !run_.cancelled(); ++k) y_.found_by_newton += seek();
    }

    /// Along a path of coefficients; what reaches no regular root is left out.
    std::vector<Root<RuntimeUnknowns>> follow(const CoefficientPath& path, const KnownRoots::Points& points) {
        PathSet paths = track(ArcHomotopy(path), KnownRoots(family_->sizes(), points), run_, tracker_);
        std::vector<Root<RuntimeUnknowns>> y;
        for (std::size_t k = 0; k < paths.size(); ++k)
            if (paths.finished(k) && paths.status(k) == PathStatus::finite)
                y.push_back(root_of(paths.point(k), paths.record(k), k));
        y_.paths += points.size();
        y_.lost += points.size() - y.size();
        return y;
    }
    /// A triangle of arcs, from the generic member by two others back to it; draws others where poles are in the way.
    std::array<CoefficientPath, 3> triangle() {
        for (int draw = 1;; ++draw) {
            const auto one = random_parameters(), other = random_parameters();
            try {
                auto a = CoefficientPath::between(*family_, y_.parameters, one, generator_);
                auto b = CoefficientPath::between(*family_, one, other, generator_);
                auto c = CoefficientPath::between(*family_, other, y_.parameters, generator_);
                return {std::move(a), std::move(b), std::move(c)};
            } catch (const InvalidArgument&) {
                if (draw == 20) throw;
            }
        }
    }
    /// All known roots; what fails on a way is tracked no further.
    void go_round() {
        std::vector<Root<RuntimeUnknowns>> ends;
        KnownRoots::Points points = known_;
        for (const CoefficientPath& way : triangle()) {
            ends = follow(way, points);
            if (run_.cancelled()) return;
            points.clear();
            for (const auto& root : ends) points.push_back(root.q);
        }
        add(ends);
    }
    /// Takes those that are not known; returns how many.
    std::uint64_t add(const std::vector<Root<RuntimeUnknowns>>& roots) {
        std::vector<RuntimePoint<double>> points = places_;
        for (const auto& root : roots) points.push_back(point_of<RuntimeUnknowns>(root.q, family_->sizes()));
        std::vector<bool> fresh(points.size(), true);
        for (const auto& group : coincident(points, 1e-8))
            for (const std::size_t k : group) {
                fresh[k] = k == group.front();
                if (k < places_.size() || group.front() >= places_.size()) continue;
                Root<RuntimeUnknowns>& known = found_[group.front()];  // Newton's method measures nothing
                const Root<RuntimeUnknowns>& again = roots[k - places_.size()];
                if (known.condition == 0) known.residual = again.residual, known.condition = again.condition;
            }
        std::uint64_t y = 0;
        for (std::size_t k = places_.size(), m = 0; m < roots.size(); ++k, ++m) {
            if (!fresh[k]) continue;
            found_.push_back(roots[m]);
            found_.back().path = found_.size() - 1;
            known_.push_back(roots[m].q);
            ++y;
        }
        places_.clear();
        for (const auto& q : known_) places_.push_back(point_of<RuntimeUnknowns>(q, family_->sizes()));
        return y;
    }

    /// The trace test; false where it is undecided.
    bool traced() {
        const RuntimeSizes& sizes = family_->sizes();
        auto support = family_->support();
        auto a = family_->coefficients(y_.parameters);
        std::vector<double> scale(static_cast<std::size_t>(sizes.unknowns));
        for (std::size_t k = 0; k < a.size(); ++k) {
            double& largest = scale[static_cast<std::size_t>(support[k].equation)];
            largest = std::max(largest, std::abs(a[k]));
        }
        std::vector<std::pair<std::size_t, Number>> constants;
        const SparseMonomial one(std::vector<int>(static_cast<std::size_t>(sizes.unknowns)));
        for (int i = 0; i < sizes.unknowns; ++i) {
            const double size = uniform(generator_, 0.1, 0.3) * scale[static_cast<std::size_t>(i)];
            const Number constant = size * unit_complex(generator_);
            std::size_t k = 0;
            while (k < support.size() && !(support[k].equation == i && support[k].monomial == one)) ++k;
            if (k == support.size()) support.push_back({i, one, 0}), a.emplace_back(0);
            constants.emplace_back(k, constant);
        }
        const SystemFamily line(sizes, support, 1, [&](SystemFamily::Parameters s) {
            auto y = a;
            for (const auto& [k, constant] : constants) y[k] += s[0] * constant;
            return y;
        });
        RootTrace difference(sizes);
        y_.trace = std::numeric_limits<double>::quiet_NaN();
        for (const double s : {1.0, -1.0}) {
            const Number from[] = {0.0}, to[] = {s};
            const auto ends = follow(CoefficientPath::between(line, from, to, generator_), known_);
            if (ends.size() < known_.size()) return false;
            for (const auto& root : ends) difference.add(1, root.q);
        }
        for (const auto& q : known_) difference.add(-2, q);
        y_.trace = difference.largest();
        return true;
    }

    const SystemFamily* family_;
    std::vector<double> typical_, sizes_;
    RunOptions run_;
    const MonodromyOptions* options_;
    TrackerOptions tracker_;
    Generator generator_;
    FamilyNewton newton_;
    KnownRoots::Points known_;
    std::vector<RuntimePoint<double>> places_;
    std::vector<Root<RuntimeUnknowns>> found_;
    MonodromyRoots y_;
};

}  // namespace detail

EQUILIBRIA_INLINE void MonodromyOptions::validate() const {
    require(quiet_loops > 0, "quiet_loops", quiet_loops, "must be positive");
    require(most_loops > 0, "most_loops", most_loops, "must be positive");
    require(newton_starts > 0, "newton_starts", newton_starts, "must be positive");
}

EQUILIBRIA_INLINE std::string_view to_string(MonodromyEnd end) {
    switch (end) {
        case MonodromyEnd::trace_test: return "trace test";
        case MonodromyEnd::quiet_loops: return "quiet loops";
        case MonodromyEnd::most_loops: return "most loops";
        case MonodromyEnd::no_root: return "no root";
        default: return "cancelled";
    }
}

EQUILIBRIA_INLINE std::string MonodromyRoots::sentence() const {
    const auto number = [](auto n, const char* of) { return std::to_string(n) + " " + of + (n == 1 ? "" : "s"); };
    std::string y = number(roots.size(), "root") + " after " + number(loops, "loop") + " and " + number(paths, "path") +
                    ", " + std::to_string(lost) + " of them lost: ";
    char value[32];
    std::snprintf(value, sizeof value, "%.1e", trace);
    switch (end) {
        case MonodromyEnd::trace_test:
            return y + "the sums over the roots have a second difference of " + value +
                   " along a line of constants; evidence that none is missing, no proof";
        case MonodromyEnd::quiet_loops:
            return y + "the last " + number(quiet_loops, "loop") + " found no other" +
                   (std::isnan(trace)
                        ? std::string()
                        : std::string(", but a trace test found sums that are not affine (") + value + ")") +
                   "; evidence, no proof";
        case MonodromyEnd::most_loops: return y + "the loops ran out, and roots may be missing";
        case MonodromyEnd::no_root: return "no first root was found from " + number(newton_starts, "random point");
        default: return y + "cancelled";
    }
}

EQUILIBRIA_INLINE MonodromyRoots monodromy(const SystemFamily& family, std::span<const double> typical,
                                           const RunOptions& run, const MonodromyOptions& options,
                                           const TrackerOptions& tracker) {
    options.validate();
    tracker.validate();
    require(run.checkpoint.empty(), "checkpoint", run.checkpoint, "must be empty: it keeps the enumeration of a model");
    return detail::MonodromySearch(family, typical, run, options, tracker).roots(run.progress);
}

EQUILIBRIA_INLINE ComplexRoots<> solve_from(const MonodromyRoots& generic, const SystemFamily& family,
                                            std::span<const double> p, const RunOptions& run,
                                            const TrackerOptions& options) {
    return solve_along(generic.roots, family, generic.parameters, complex_parameters(p), run, options);
}

}  // namespace equilibria
