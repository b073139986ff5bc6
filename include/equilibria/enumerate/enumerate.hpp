/// \file
/// The front door: every equilibrium of a model, by homotopy continuation, with every path accounted for.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include <equilibria/enumerate/alarms.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/paths/collect.hpp>
#include <equilibria/paths/path_solver.hpp>

namespace equilibria {

namespace detail {

/// The start points of a total-degree start system, numbered in mixed radix: digit i chooses the start of unknown i.
template <Model M>
class StartPoints {
public:
    explicit StartPoints(const TotalDegreeStart<M>& start) : start_(&start) {}

    int radix(int i) const { return static_cast<int>(start_->points(i).size()); }

    Point<M, double> operator()(std::uint64_t path) const {
        Point<M, double> q;
        for (int i = 0; i < n_unknowns<M>; ++i) {
            const auto size = static_cast<std::uint64_t>(radix(i));
            const StartCoordinate& at = start_->points(i)[path % size];
            path /= size;
            if (i < n_angles<M>) {
                set_lane(q.c[i], 0, at.c);
                set_lane(q.s[i], 0, at.s);
            } else {
                set_lane(q.x[i - n_angles<M>], 0, at.c);
            }
        }
        return q;
    }

    /// The path of the mirror image theta -> -theta, with a reflected start: digits 0 and 1 rest, 2k and 2k+1 change.
    std::uint64_t mirror(std::uint64_t path) const {
        std::uint64_t image = 0, weight = 1;
        for (int i = 0; i < n_unknowns<M>; ++i) {
            const auto size = static_cast<std::uint64_t>(radix(i)), digit = path % size;
            path /= size;
            image += weight * (digit < 2 ? digit : digit ^ 1);
            weight *= size;
        }
        return image;
    }

    /// With a reflected start: how many paths rest, and how many mirror pairs there are.
    std::uint64_t resting() const { return std::uint64_t{1} << n_unknowns<M>; }
    std::uint64_t pairs() const { return (static_cast<std::uint64_t>(total_degree<M>()) - resting()) / 2; }
    /// The k-th path that rests: the digits of k in base 2.
    std::uint64_t resting_path(std::uint64_t k) const {
        std::uint64_t path = 0, weight = 1;
        for (int i = 0; i < n_unknowns<M>; ++i, k >>= 1) {
            path += weight * (k & 1);
            weight *= static_cast<std::uint64_t>(radix(i));
        }
        return path;
    }
    /// The k-th of the paths that are less than their mirror image: the highest digit that is not 0 or 1 is even.
    std::uint64_t pair_path(std::uint64_t k) const {
        std::uint64_t weight = static_cast<std::uint64_t>(total_degree<M>()), rest = resting(), path = 0;
        for (int i = n_unknowns<M> - 1; i >= 0; --i) {
            weight /= static_cast<std::uint64_t>(radix(i));
            rest /= 2;
            const std::uint64_t below = (weight - rest) / 2;  // pairs of the lower digits alone
            if (k >= 2 * below) {                             // this digit decides, the lower ones are free
                k -= 2 * below;
                return path + (2 + 2 * (k / weight)) * weight + k % weight;
            }
            path += k / below * weight;
            k %= below;
        }
        return path;
    }

private:
    const TotalDegreeStart<M>* start_;
};

/// Tracks all paths from a total-degree start, fills in what `set` says of them, calls take(root) as `collect` does,
/// and in the end done(polisher).
template <Model M, StartKind Kind, class Set, class Take, class Done>
void solve_total_degree(Set& set, const Parameters<M>& p, const EnumerateOptions& options, bool streamed,
                        Rescue<M, Kind, double> rescue, Take&& take, Done&& done) {
    constexpr bool symmetric = Kind == StartKind::reflected;
    set.parameters = p;
    set.seed = options.seed;
    Generator generator(options.seed);
    const auto target = coefficients<M, double>(p);
    const auto scale = equation_scales<M, double>(target);
    const TotalDegreeStart<M> start(Kind, scale, generator);
    const StartPoints<M> points(start);
    PathSolver<M, Kind, double> solver(Homotopy<M, Kind, double>::total_degree(target, start), p, scale, options,
                                       rescue);

    const auto path_of = [&](std::uint64_t k) { return symmetric ? points.pair_path(k) : k; };
    const auto start_of = [&](std::uint64_t k) { return points(path_of(k)); };
    const auto resting_path = [&](std::uint64_t k) { return points.resting_path(k); };
    std::vector<Endpoint<M>> resting(symmetric ? points.resting() : 0);
    for (std::size_t k = 0; k < resting.size(); ++k) {
        resting[k].q = points(resting_path(k));
        resting[k].arrival = Arrival::end;
        solver.polisher().assess(resting[k].q, &resting[k].evidence);
        resting[k].status =
            resting[k].evidence.condition < regular_condition ? PathStatus::finite : PathStatus::singular;
    }
    const std::uint64_t tracked = symmetric ? points.pairs() : static_cast<std::uint64_t>(total_degree<M>());
    auto ends = solver.store(tracked, start_of, symmetric ? "reflected" : "total degree", streamed);
    solver.run(ends, start_of, resting, symmetric, set.paths);
    set.tracking_seconds = solver.tracking_seconds();
    collect<M>(
        set.paths, set.failures, ends, path_of, resting, resting_path, symmetric,
        [&](std::uint64_t path) { return points.mirror(path); }, take);
    done(solver.polisher());
}

template <Model M, StartKind Kind>
RootSet<M> enumerate_total_degree(const Parameters<M>& p, const EnumerateOptions& options,
                                  Rescue<M, Kind, double> rescue = nullptr) {
    const auto begin = std::chrono::steady_clock::now();
    RootSet<M> set;
    solve_total_degree<M, Kind>(
        set, p, options, false, rescue, [&](const Root<M>& root) { set.roots.push_back(root); },
        [&](const auto& polisher) {
            sort_by_path(set.roots);
            find_families(set, polisher, options.threads);
        });
    find_equilibria(set, options.threads);
    set.alarms = check_alarms(set, options.threads);
    set.seconds = seconds_since(begin);
    return set;
}

template <Model M, StartKind Kind>
void check_arguments(const Parameters<M>& p, const EnumerateOptions& options) {
    static_assert(Kind != StartKind::reflected || Formulation<M>::reflection_symmetric,
                  "equilibria: the reflected start needs equations that are odd under theta -> -theta");
    require_finite(p, "parameters");
    options.validate();
}

template <Model M>
void check_arguments(const RootSet<M>& solved, const Parameters<M>& p, const EnumerateOptions& options) {
    require_finite(p, "parameters");
    options.validate();
    require(solved.paths.failed == 0 && solved.paths.singular == 0, "solved.paths",
            std::to_string(solved.paths.failed) + " failed, " + std::to_string(solved.paths.singular) + " singular",
            "a start instance must have regular roots only");
}

/// Follows regular roots at parameters `from` to the roots at p, along a line in the space of coefficients.
template <Model M>
RootSet<M> enumerate_from(const std::vector<Root<M>>& roots, const Parameters<M>& from, const Parameters<M>& p,
                          const EnumerateOptions& options, Rescue<M, StartKind::parameter, double> rescue = nullptr) {
    const auto begin = std::chrono::steady_clock::now();
    RootSet<M> set;
    set.parameters = p;
    set.seed = options.seed;
    Generator generator(options.seed);
    const auto target = coefficients<M, double>(p);
    const auto scale = equation_scales<M, double>(target);
    using H = Homotopy<M, StartKind::parameter, double>;
    PathSolver<M, StartKind::parameter, double> solver(
        H::parameter(coefficients<M, double>(from), target, unit_complex(generator)), p, scale, options, rescue);
    const auto start = [&](std::uint64_t path) { return start_point<M>(roots[path].q); };
    auto ends = solver.store(roots.size(), start, "a solved instance", false);
    solver.run(ends, start, {}, false, set.paths);
    set.tracking_seconds = solver.tracking_seconds();
    const auto same = [](std::uint64_t path) { return path; };
    collect<M>(set.paths, set.failures, ends, same, {}, same, false, same,
               [&](const Root<M>& root) { set.roots.push_back(root); });
    sort_by_path(set.roots);
    find_families(set, solver.polisher(), options.threads);
    find_equilibria(set, options.threads);
    set.alarms = check_alarms(set, options.threads);
    set.seconds = seconds_since(begin);
    return set;
}

}  // namespace detail

/// The start system that suits the model: reflected where it has the symmetry theta -> -theta (a model may decline
/// with `static constexpr bool use_reflection = false`, or insist with `true`, which is checked).
template <Model M>
constexpr StartKind natural_start() {
    if constexpr (requires { M::use_reflection; }) {
        static_assert(!M::use_reflection || Formulation<M>::reflection_symmetric,
                      "equilibria: the model declares use_reflection, but its equations are not odd under "
                      "theta -> -theta (or it has plain coordinates, with which the library does not use it)");
        return M::use_reflection ? StartKind::reflected : StartKind::general;
    }
    return Formulation<M>::reflection_symmetric ? StartKind::reflected : StartKind::general;
}

/// Every isolated equilibrium of the model at the parameters p, from a total-degree start.
///
/// Reaches every isolated solution of the polynomial system with probability one over the seed; paths at infinity,
/// singular and failed ones are counted, not hidden. Kind: the start system, if not the natural one (`parameter`: the
/// general one, compiled together with the parameter homotopies).
/// Throws InvalidArgument for parameters that are not finite and for options out of range, CheckpointError (one of
/// them) for a checkpoint that cannot be used.
template <Model M, StartKind Kind = natural_start<M>()>
RootSet<M> enumerate(const Parameters<M>& p, const EnumerateOptions& options = {}) {
    detail::check_arguments<M, Kind>(p, options);
    return detail::enumerate_total_degree<M, Kind>(p, options);
}

/// The equilibria at p, from those of a solved instance: as many paths as `solved` has roots, not the whole bound.
///
/// The homotopy is a line in the space of coefficients. Complete if `solved` has as many regular roots as a generic
/// system on that line: certainly where it reaches the bound, as the chain does. A line between models whose parameters
/// enter the coefficients nonlinearly leaves the model, and systems on it may have more roots. Throws InvalidArgument
/// where `solved` has failed or singular paths.
template <Model M>
RootSet<M> enumerate(const RootSet<M>& solved, const Parameters<M>& p, const EnumerateOptions& options = {}) {
    detail::check_arguments<M>(solved, p, options);
    return detail::enumerate_from<M>(solved.roots, solved.parameters, p, options);
}

}  // namespace equilibria
