/// \file
/// Every isolated solution of a system that is data, every path accounted for.
///
/// What comes back are complex roots. They are not classified as equilibria are: the systems are systems of equations,
/// and their users know what a real root means.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/paths/merge.hpp>
#include <equilibria/paths/track.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

class TotalDegreeStart;

/// All complex solutions of a system. M: its unknowns.
template <class M = RuntimeUnknowns>
struct ComplexRoots {
    PathCounts paths;                     ///< how many ended how
    std::vector<Root<M>> roots;           ///< distinct, by path number
    std::vector<FailedPath<M>> failures;  ///< by path number
    std::string start;                    ///< its name: total degree, linear product, polyhedral, ..
    std::string caution;  ///< of a start from which not every solution need be reached: what speaks for it, in words
};

/// What all paths end at, merged.
ComplexRoots<> complex_roots(PathSet paths);

/// Tracks all paths of a homotopy and merges what they end at: the driver of every search for complex roots.
/// Homotopies of a type of one's own: own_homotopy.hpp.
template <std::same_as<PolynomialHomotopy> H, class StartSystem>
ComplexRoots<> complex_roots(const H& homotopy, const StartSystem& start, const RunOptions& run = {},
                             const TrackerOptions& options = {}, MoreDigits<> resort = nullptr) {
    auto found = complex_roots(track(homotopy, start, run, options, resort));
    found.start = start.name();
    return found;
}

namespace detail {
/// The homotopy from a total-degree start to a system. degrees: those of the start, one an equation.
PolynomialHomotopy total_degree_homotopy(const SparseSystem& system, const TotalDegreeStart& start,
                                         const std::vector<int>& degrees);
}  // namespace detail

/// Every isolated solution of the system, by as many paths as its total degree (the product of the equations' degrees,
/// times 2 an angle). With a `resort` as solve_multihomogeneous. Throws InvalidArgument where an equation is a
/// constant, where there are more paths than can be numbered, where the run names a checkpoint or options are out of
/// range.
ComplexRoots<> solve_total_degree(const SparseSystem& system, const RunOptions& run = {},
                                  const TrackerOptions& options = {}, MoreDigits<> resort = nullptr);

/// Every isolated solution of the system, by paths from a linear-product start for the groups of unknowns: as many
/// paths as the multihomogeneous number of Bezout of the terms that the system has. With a `resort` (more_digits of
/// enumerate/more_digits.hpp) paths that fail in double are tracked again before they count as failed;
/// paths.more_digits says how many were.
///
/// grouping: the group of each unknown, numbers from 0, none left out. Throws InvalidArgument where the run names a
/// checkpoint or options are out of range.
ComplexRoots<> solve_multihomogeneous(const SparseSystem& system, std::span<const int> grouping,
                                      const RunOptions& run = {}, const TrackerOptions& options = {},
                                      MoreDigits<> resort = nullptr);

/// The same for a model's equations at the parameters p; the model names the groups, `static constexpr Grouping<M>
/// grouping`.
template <Model M>
ComplexRoots<> solve_multihomogeneous(const Parameters<M>& p, const RunOptions& run = {},
                                      const TrackerOptions& options = {}, MoreDigits<> resort = nullptr) {
    require_finite(p, "parameters");
    return solve_multihomogeneous(sparse_system<M>(p), M::grouping, run, options, resort);
}

/// The solutions of the system `to` from regular solutions of `from`, along a line in the space of coefficients:
/// complete if `roots` are as many as a generic system on that line has.
ComplexRoots<> solve_from(const std::vector<Root<RuntimeUnknowns>>& roots, const SparseSystem& from,
                          const SparseSystem& to, const RunOptions& run = {}, const TrackerOptions& options = {});

/// Whether no unknown has an imaginary part of 1e-8 (1 + |x|) or more. Not proved: see
/// enumerate/prove_complex_roots.hpp.
template <class M>
bool is_real(const Root<M>& root) {
    for (const std::complex<double>& x : root.q)
        if (!(std::abs(x.imag()) < 1e-8 * (1 + std::abs(x)))) return false;
    return true;
}

/// Whether another root is nearer to root k's complex conjugate than root k is: then it is not real, however small its
/// imaginary parts are. angles: how many unknowns are angles, in radians.
template <class M>
bool conjugate_is_another(std::span<const Root<M>> roots, std::size_t k, int angles) {
    const auto& q = roots[k].q;
    double imaginary = 0;
    for (const std::complex<double>& z : q) imaginary = std::max(imaginary, std::abs(z.imag()));
    for (std::size_t j = 0; j < roots.size(); ++j) {
        double apart = 0;
        for (int u = 0; u < q.size() && apart < imaginary; ++u) {
            std::complex<double> d = roots[j].q[u] - std::conj(q[u]);
            if (u < angles) d.real(std::remainder(d.real(), 2 * std::numbers::pi));
            apart = std::max(apart, std::abs(d));
        }
        if (j != k && apart < imaginary) return true;
    }
    return false;
}

/// Start systems are a choice: where one leaves paths undecided, another may not. The first attempt has the seed
/// itself.
inline std::uint64_t seed_of_attempt(std::uint64_t seed, std::uint64_t attempt) {
    return seed + 0x9e3779b97f4a7c15 * attempt;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/complex_roots_definitions.hpp>
#endif
