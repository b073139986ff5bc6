/// \file
/// Every isolated solution of a system that is data, every path accounted for.
///
/// What comes back are complex roots. They are not classified as equilibria are: the systems are systems of equations,
/// and their users know what a real root means.
#pragma once

#include <complex>
#include <cstdint>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/homotopy/sparse_homotopy.hpp>
#include <equilibria/paths/merge.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/start/linear_product.hpp>
#include <equilibria/start/solved_instance.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// All complex solutions of a system. Unknowns: UnknownsOf<angles, coordinates>.
template <class Unknowns>
struct ComplexRoots {
    PathCounts paths;
    std::vector<Root<Unknowns>> roots;  ///< distinct, by path number
    std::vector<FailedPath<Unknowns>> failures;
};

/// How paths of a multihomogeneous homotopy that fail in double are tracked with more digits: more_digits<Unknowns>
/// (enumerate/more_digits.hpp), or not at all.
template <int Angles, int Coordinates>
using MultihomogeneousHomotopy = SparseHomotopy<Angles, Coordinates, LinearProduct<Angles, Coordinates>>;
template <class System>
using MoreDigitsOf = MoreDigits<MultihomogeneousHomotopy<System::n_angles, System::n_coordinates>>;

/// Tracks all paths of a homotopy and merges what they end at: the driver of every search for complex roots.
template <class H, class StartSystem>
ComplexRoots<typename H::System> complex_roots(const H& homotopy, const StartSystem& start, const RunOptions& run = {},
                                               const TrackerOptions& options = {},
                                               MoreDigits<H> more_digits = nullptr) {
    PathSet<typename H::System> paths = track(homotopy, start, run, options, more_digits);
    auto [counts, failures] = account_for(paths);
    return {counts, merge(paths), std::move(failures)};
}

/// Every isolated solution of the system, by paths from a linear-product start for the groups of unknowns: as many
/// paths as the multihomogeneous number of Bezout of the terms that the system has. With `more_digits` paths that fail
/// in double are tracked again before they count as failed; paths.more_digits says how many were.
///
/// grouping: the group of each unknown, numbers from 0, none left out. Throws InvalidArgument where the run names a
/// checkpoint or options are out of range.
template <int Angles, int Coordinates>
ComplexRoots<UnknownsOf<Angles, Coordinates>> solve_multihomogeneous(
    const SparseSystem<Angles, Coordinates>& system, const Array<int, Angles + Coordinates>& grouping,
    const RunOptions& run = {}, const TrackerOptions& options = {},
    MoreDigits<MultihomogeneousHomotopy<Angles, Coordinates>> more_digits = nullptr) {
    options.validate();
    Generator generator(run.seed), forms(run.seed);
    const LinearProduct<Angles, Coordinates> start(system, grouping, unit_complex(generator), forms);
    return complex_roots(MultihomogeneousHomotopy<Angles, Coordinates>(system, start), start, run, options,
                         more_digits);
}

/// The same for a model's equations at the parameters p; the model names the groups, `static constexpr Grouping<M>
/// grouping`.
template <Model M>
auto solve_multihomogeneous(const Parameters<M>& p, const RunOptions& run = {}, const TrackerOptions& options = {},
                            MoreDigitsOf<M> more_digits = nullptr) {
    require_finite(p, "parameters");
    return solve_multihomogeneous(sparse_system<M>(p), M::grouping, run, options, more_digits);
}

/// The solutions of the system `to` from regular solutions of `from`, along a line in the space of coefficients:
/// complete if `roots` are as many as a generic system on that line has.
template <int Angles, int Coordinates>
ComplexRoots<UnknownsOf<Angles, Coordinates>> solve_from(
    const std::vector<Root<UnknownsOf<Angles, Coordinates>>>& roots, const SparseSystem<Angles, Coordinates>& from,
    const SparseSystem<Angles, Coordinates>& to, const RunOptions& run = {}, const TrackerOptions& options = {}) {
    using Instance = SolvedInstance<Angles, Coordinates>;
    options.validate();
    typename Instance::Points points;
    points.reserve(roots.size());
    for (const auto& root : roots) points.push_back(root.q);
    Generator generator(run.seed);
    const Instance start(from, to, unit_complex(generator), std::move(points));
    return complex_roots(SparseHomotopy<Angles, Coordinates, Instance>(to, start), start, run, options);
}

/// Start systems are a choice: where one leaves paths undecided, another may not. The first attempt has the seed
/// itself.
inline std::uint64_t seed_of_attempt(std::uint64_t seed, std::uint64_t attempt) {
    return seed + 0x9e3779b97f4a7c15 * attempt;
}

}  // namespace equilibria
