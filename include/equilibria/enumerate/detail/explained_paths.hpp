/// \file
/// The paths of a polyhedral start, one by one: proved roots, multiple roots, curves, roots of face systems at
/// infinity, and what none of these explains. See enumerate/every_root.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <equilibria/enumerate/detail/root_attempt.hpp>
#include <equilibria/enumerate/every_root_options.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/enumerate/named_families.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/local_multiplicity.hpp>
#include <equilibria/homotopy/path_limit.hpp>
#include <equilibria/homotopy/polish.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/system/path_bounds.hpp>
#include <equilibria/system/unit_scaling.hpp>

namespace equilibria::detail {

/// The paths of a polyhedral start, each explained or not.
class ExplainedPaths {
public:
    using Point = std::vector<std::complex<double>>;

    ExplainedPaths(const SparseSystem& system, const std::vector<ProvedBound>& bounds, const RunOptions& run,
                   const EveryRootOptions& options)
        : system_(system), bounds_(bounds), run_(run), options_(options), sizes_(system.sizes()),
          instance_(system, {.seed = run.seed, .executor = run.executor, .ranks = run.ranks, .cancel = run.cancel},
                    options.tracker),
          homotopy_(instance_.homotopy(system)), columns_(instance_.columns(system)) {}

    RootAttempt run() {
        const Stopwatch clock;
        const GenericInstance::Start start(instance_);
        PathSet paths = track(homotopy_, start, run_, options_.tracker, &track_with_more_digits_but_ends);
        y_.tracking_seconds = clock.seconds();
        y_.found.start = std::string(GenericInstance::Start::name());
        auto account = account_for(paths);
        y_.found.paths = account.counts;
        const std::size_t size = paths.size();
        std::vector<std::size_t> of_candidate;
        for (std::size_t k = 0; k < size; ++k)
            if (!paths.finished(k)) {
                ++stopped_;
            } else if (paths.status(k) == PathStatus::finite) {
                y_.found.roots.push_back(root_of(paths.point(k), paths.record(k), k));
                of_candidate.push_back(k);
            }
        prove_roots();
        std::vector<char> settled(size);
        for (std::size_t m = 0; m < of_candidate.size(); ++m)
            settled[of_candidate[m]] = y_.proof.certificates[m].exists && y_.proof.certificates[m].distinct;
        if (y_.proof.duplicates > 0) unsettle_duplicates(of_candidate, settled);
        std::vector<std::size_t> open;
        for (std::size_t k = 0; k < size; ++k)
            if (!settled[k] && paths.finished(k)) open.push_back(k);
        if (!open.empty()) {
            std::vector<Root<RuntimeUnknowns>> kept;
            for (std::size_t m = 0; m < of_candidate.size(); ++m)
                if (settled[of_candidate[m]]) kept.push_back(std::move(y_.found.roots[m]));
            y_.found.roots = std::move(kept);
            explain(open, paths);
        }
        count(size);
        return std::move(y_);
    }

private:
    void prove_roots() { y_.proof = prove_and_refine(system_, y_.found, bounds_, run_); }

    /// Two paths at one root: one of them jumped, and it is not known which.
    void unsettle_duplicates(const std::vector<std::size_t>& of_candidate, std::vector<char>& settled) const {
        for (std::size_t m = 0; m < of_candidate.size(); ++m) {
            if (settled[of_candidate[m]]) continue;
            for (std::size_t l = 0; l < of_candidate.size(); ++l)
                if (l != m && distance(y_.found.roots[l].q, y_.found.roots[m].q) < 1e-6) settled[of_candidate[l]] = 0;
        }
    }
    double distance(const auto& a, const auto& b) const {
        double y = 0;
        for (int u = 0; u < sizes_.unknowns; ++u) {
            std::complex<double> d = a[u] - b[u];
            if (u < sizes_.angles) d.real(std::remainder(d.real(), 2 * std::numbers::pi));
            y = std::max(y, std::abs(d) / (u < sizes_.angles ? 1 : 1e-300 + std::abs(a[u]) + std::abs(b[u])));
        }
        return y;
    }
    Point exponentials(const auto& q) const { return laurent_point(q, sizes_); }
    UnknownArray<RuntimeUnknowns, std::complex<double>> unknowns(const Point& z) const {
        UnknownArray<RuntimeUnknowns, std::complex<double>> q(sizes_.unknowns);
        for (int u = 0; u < sizes_.unknowns; ++u) {
            const auto& at = z[static_cast<std::size_t>(u)];
            q[u] = u < sizes_.angles ? std::complex<double>(0, -1) * std::log(at) : at;
        }
        return q;
    }

    /// Whether what one process does alone is to end.
    bool stopped() const { return !run_.ranks.several() && run_.cancelled(); }
    static bool is_decided(const PathLimit& y) {
        return y.kind == LimitKind::finite || y.kind == LimitKind::at_infinity;
    }
    /// The limit of path k with sums of two doubles: from where the tracker left it, else from its start.
    PathLimit first_limit(std::size_t k, PathSet& paths) const {
        const EndpointRecord end = paths.record(k);
        if (end.t > 0.5 && end.t < 1 && end.status != PathStatus::finite && end.status != PathStatus::singular) {
            auto y = follow_to_limit(sizes_, columns_, exponentials(root_of(paths.point(k), end, k).q), 1 - end.t, 31);
            if (is_decided(y) || y.to_multiple_root) return y;
        }
        return follow_to_limit(sizes_, columns_, exponentials(instance_.roots()[k]), 1, 31);
    }
    /// The limit of path k with 64 digits: from where sums of two doubles left it, if that was near the end.
    PathLimit exact_limit(std::size_t k, const PathLimit& first, int most_steps) const {
        // no digits come far enough to tell
        if (first.to_multiple_root) return first;
        if (first.r < 1e-3) {
            auto y = follow_to_limit(sizes_, columns_, last_point(first), first.r, 64, most_steps);
            // a path that was lost so near to its end is lost there from its start as well
            if (y.kind != LimitKind::open || y.r < 1e-30) return y;
        }
        return follow_to_limit(sizes_, columns_, exponentials(instance_.roots()[k]), 1, 64, most_steps);
    }
    static Point last_point(const PathLimit& limit) {
        Point z = limit.z;
        if (!limit.points.empty())
            for (std::size_t u = 0; u < z.size(); ++u)
                z[u] = {limit.points.back().z[u][0][0], limit.points.back().z[u][1][0]};
        return z;
    }

    void explain(const std::vector<std::size_t>& open, PathSet& paths) {
        if (open.size() > options_.most_explained) {
            y_.unexplained = open.size();
            y_.left = std::to_string(open.size()) + " paths are too many to be explained one by one";
            prove_roots();
            y_.confirmed.assign(y_.found.roots.size(), 0);
            return;
        }
        std::vector<PathLimit> limits(open.size());
        // what the store hands out is valid until the next call: points are read by one thread
        run_.executor.for_blocks(open.size(), open.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t m = first; m < last && !stopped(); ++m) limits[m] = first_limit(open[m], paths);
        });
        auto on_curves = find_curves(open, limits);
        Members doubtful;
        for (std::size_t m = 0; m < open.size(); ++m)
            if (!is_decided(limits[m]) && !on_curves[m]) doubtful.push_back(m);
        // some seconds' worth of steps for all of them, whatever the number of threads
        const std::size_t work = columns_.size() * static_cast<std::size_t>(sizes_.unknowns) * (doubtful.size() + 1);
        const auto most_steps = static_cast<int>(std::clamp<std::size_t>(300'000 / work, 30, 300));
        run_.executor.for_blocks(doubtful.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last && !stopped(); ++k) {
                const std::size_t m = doubtful[k];
                limits[m] = exact_limit(open[m], limits[m], most_steps);
            }
        });
        // where curves cross, all derivatives vanish: 31 digits tell too little of the place
        if (std::ranges::any_of(doubtful, [&](std::size_t m) { return limits[m].kind == LimitKind::singular; }))
            on_curves = find_curves(open, limits);
        std::vector<std::size_t> singular;
        std::map<std::string, std::uint64_t> reasons;
        for (std::size_t m = 0; m < open.size(); ++m) {
            if (on_curves[m]) continue;
            const PathLimit& limit = limits[m];
            switch (limit.kind) {
                case LimitKind::finite: add_regular(limit, open[m]); break;
                case LimitKind::singular: singular.push_back(m); break;
                case LimitKind::at_infinity: add_infinite(limit); break;
                case LimitKind::open:
                    if (limit.z.empty()) {
                        ++stopped_;
                        break;
                    }
                    y_.hidden += limit.to_multiple_root;
                    ++reasons[limit.reason];
                    y_.found.failures.push_back({open[m], FailureReason::endgame_undecided, unknowns(limit.z)});
                    break;
            }
        }
        prove_roots();
        // of two paths at one root one is lost
        const std::uint64_t lost = y_.proof.certificates.size() - y_.proof.distinct;
        drop_unproved();
        y_.confirmed.assign(y_.found.roots.size(), 0);
        explain_singular(singular, limits, open, reasons);
        if (lost > 0) reasons["ended on another's root, or at one that could not be proved"] += lost;
        for (const auto& [reason, number] : reasons) {
            y_.unexplained += number;
            y_.left += (y_.left.empty() ? "" : "; ") + std::to_string(number) + (number == 1 ? " path: " : " paths: ") +
                       reason;
        }
    }
    /// Only roots that are proved to differ stay.
    void drop_unproved() {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < y_.found.roots.size(); ++k) {
            if (!(y_.proof.certificates[k].exists && y_.proof.certificates[k].distinct)) continue;
            if (kept != k) {
                y_.found.roots[kept] = std::move(y_.found.roots[k]);
                y_.proof.certificates[kept] = y_.proof.certificates[k];
            }
            ++kept;
        }
        y_.found.roots.resize(kept);
        y_.proof.certificates.resize(kept);
        y_.proof.undecided = 0;
        for (const Certificate& c : y_.proof.certificates) y_.proof.undecided += c.reality == Reality::undecided;
        y_.proof.duplicates = 0;
    }
    Root<RuntimeUnknowns> root_at(const Point& z, std::size_t path) const {
        Root<RuntimeUnknowns> root;
        root.q = unknowns(z);
        root.path = path;
        const auto point = point_of<RuntimeUnknowns>(root.q, sizes_);
        Polisher<PolynomialHomotopy>::Workspace<double> with(homotopy_);
        PolishedEvidence evidence;
        Polisher(homotopy_).assess(point, &evidence, with);
        root.residual = evidence.residual;
        root.condition = evidence.condition;
        return root;
    }
    void add_regular(const PathLimit& limit, std::size_t path) { y_.found.roots.push_back(root_at(limit.z, path)); }
    void add_infinite(const PathLimit& limit) {
        for (DivergingPaths& known : y_.at_infinity) {
            double apart = 0;
            for (std::size_t u = 0; u < known.direction.size(); ++u)
                apart = std::max(apart, std::abs(known.direction[u] - limit.direction[u]));
            if (apart > 1e-6) continue;
            ++known.paths;
            known.residual = std::max(known.residual, limit.residual);
            return;
        }
        y_.at_infinity.push_back({limit.direction, 1, limit.residual});
    }

    using Members = std::vector<std::size_t>;

    /// Confirms what ends at multiple roots, group by group; what is left may lie on curves.
    void explain_singular(const Members& singular, const std::vector<PathLimit>& limits,
                          const std::vector<std::size_t>& open, std::map<std::string, std::uint64_t>& reasons) {
        Members left = singular;
        std::set<std::pair<std::size_t, Members>> tried;
        // roots near to each other are parted by smaller groups, nearer to t = 1
        for (std::size_t level = 0; level < 3; ++level)
            for (const double apart : {1e-3, 1e-6, 1e-9, 1e-12}) {
                Members again;
                for (const Members& group : groups_of(left, limits, apart))
                    if (!tried.insert({level, group}).second || !confirm(group, limits, level, open))
                        again.insert(again.end(), group.begin(), group.end());
                left = std::move(again);
            }
        if (left.empty()) return;
        for (const Members& group : groups_of(left, limits, 1e-6)) {
            y_.found.roots.push_back(singular_root(group, limits, open));
            y_.confirmed.push_back(0);
            reasons["end at singular points whose multiplicity could not be confirmed"] += group.size();
        }
    }
    Root<RuntimeUnknowns> singular_root(const Members& group, const std::vector<PathLimit>& limits,
                                        const std::vector<std::size_t>& open) const {
        auto root = root_at(limits[group.front()].z, open[group.front()]);
        root.status = PathStatus::singular;
        root.paths = static_cast<std::int32_t>(group.size());
        return root;
    }
    /// Which of the paths end on curves or surfaces of solutions.
    std::vector<char> find_curves(const std::vector<std::size_t>& open, const std::vector<PathLimit>& limits) {
        std::vector<char> y(limits.size());
        Members singular;
        for (std::size_t m = 0; m < limits.size(); ++m)
            if (limits[m].kind == LimitKind::singular) singular.push_back(m);
        if (singular.empty()) return y;
        const auto groups = groups_of(singular, limits, 1e-6);
        std::vector<Root<RuntimeUnknowns>> suspects;
        for (const Members& group : groups) suspects.push_back(singular_root(group, limits, open));
        auto found = find_families(homotopy_, suspects, run_.executor);
        keep_families(system_, suspects, found);
        for (std::size_t k = 0; k < groups.size(); ++k)
            if (found.on_one[k])
                for (const std::size_t m : groups[k]) y[m] = 1;
        y_.families = std::move(found.families);
        return y;
    }
    std::vector<Members> groups_of(const Members& members, const std::vector<PathLimit>& limits, double apart) const {
        std::vector<Members> groups;
        for (const std::size_t m : members) {
            const auto near = std::ranges::find_if(groups, [&](const Members& group) {
                return std::ranges::any_of(group,
                                           [&](std::size_t l) { return is_near(limits[l].z, limits[m].z, apart); });
            });
            if (near == groups.end())
                groups.push_back({m});
            else
                near->push_back(m);
        }
        return groups;
    }
    bool confirm(const Members& group, const std::vector<PathLimit>& limits, std::size_t level,
                 const std::vector<std::size_t>& open) {
        std::vector<const PathLimit*> of_group;
        for (const std::size_t m : group) {
            of_group.push_back(&limits[m]);
            if (limits[m].digits < 64 || level >= limits[m].points.size()) return false;
        }
        const auto paths = static_cast<int>(group.size());
        const LocalMultiplicity local = local_multiplicity(sizes_, columns_, of_group, level, paths);
        if (local.multiplicity != paths || !local.confirmed) return false;
        auto root = root_at(mean(of_group), open[group.front()]);
        root.status = PathStatus::singular;
        root.paths = paths;
        y_.found.roots.push_back(std::move(root));
        y_.confirmed.push_back(1);
        return true;
    }
    static bool is_near(const Point& a, const Point& b, double apart) {
        for (std::size_t u = 0; u < a.size(); ++u)
            if (!(std::abs(a[u] - b[u]) <= apart * std::max(std::abs(a[u]), std::abs(b[u])))) return false;
        return true;
    }
    static Point mean(const std::vector<const PathLimit*>& group) {
        Point z(group.front()->z.size());
        for (const PathLimit* limit : group)
            for (std::size_t u = 0; u < z.size(); ++u) z[u] += limit->z[u] / static_cast<double>(group.size());
        return z;
    }

    void count(std::size_t size) {
        PathCounts& c = y_.found.paths;
        c.total = size, c.finite = y_.proof.distinct, c.cancelled = stopped_;
        c.singular = c.at_infinity = c.failed = 0;
        instance_.add_unsolved_to(c);
        y_.confirmed.resize(y_.found.roots.size());
        for (std::size_t k = 0; k < y_.found.roots.size(); ++k)
            if (y_.confirmed[k]) c.singular += static_cast<std::uint64_t>(y_.found.roots[k].paths);
        for (const auto& family : y_.families) c.singular += family.paths();
        for (const auto& away : y_.at_infinity) c.at_infinity += away.paths;
        const auto leave = [this](std::uint64_t number, const std::string& why) {
            y_.unexplained += number;
            if (number > 0) y_.left += (y_.left.empty() ? "" : "; ") + std::to_string(number) + why;
        };
        leave(c.failed, " paths of the start itself failed");
        leave(c.cancelled, " paths were not followed to their ends, since the run was stopped");
        c.failed = c.total - c.finite - c.singular - c.at_infinity - c.cancelled;
        std::sort(y_.found.failures.begin(), y_.found.failures.end(),
                  [](const auto& a, const auto& b) { return a.path < b.path; });
    }

    const SparseSystem& system_;
    const std::vector<ProvedBound>& bounds_;
    const RunOptions& run_;
    const EveryRootOptions& options_;
    RuntimeSizes sizes_;
    GenericInstance instance_;
    PolynomialHomotopy homotopy_;
    std::vector<LaurentColumn> columns_;
    RootAttempt y_;
    std::uint64_t stopped_ = 0;  ///< paths that a cancelled run left
};

}  // namespace equilibria::detail
