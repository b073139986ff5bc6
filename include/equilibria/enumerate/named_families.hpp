/// \file
/// Curves and surfaces of solutions of a system, named by dimension, degree and a point of each.
///
/// Paths of the total degree lead to every curve, or to a point of it at infinity. Its degree is the number of points
/// in which a generic hyperplane meets it: the solutions of generic combinations of the equations and of that
/// hyperplane, among which those count that fulfil all equations. Source: A. J. Sommese, C. W. Wampler, The Numerical
/// Solution of Systems of Polynomials Arising in Engineering and Science, World Scientific (2005), chapters 13 and 15.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/families.hpp>
#include <equilibria/homotopy/tracker_options.hpp>
#include <equilibria/paths/root.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria::detail {

/// Exponentials of the angles, which are complex and in radians, and the coordinates.
[[nodiscard]] std::vector<std::complex<double>> laurent_point(const auto& q, const RuntimeSizes& sizes) {
    std::vector<std::complex<double>> z(q.begin(), q.end());
    for (int i = 0; i < sizes.angles; ++i) {
        auto& at = z[static_cast<std::size_t>(i)];
        at = std::exp(std::complex<double>(0, 1) * at);
    }
    return z;
}

/// Whether coefficients of an equation are within 1e24 of each other: of others 31 digits do not see every term, and do
/// not tell a curve from roots that are near to each other.
bool digits_tell_families(const SparseSystem& system);

/// Families of which a second point is a solution to 31 digits, as a near miss is not; the others are dropped, and
/// on_one says so. All are, where digits do not tell. roots: those that `found` is of.
void keep_families(const SparseSystem& system, const std::vector<Root<RuntimeUnknowns>>& roots, FoundFamilies& found);

/// The families that these suspects, singular ends of paths from the total degree, and points on generic planes lie on;
/// on_one: of the suspects. None where digits do not tell. most_paths: above so many paths the total degree is not
/// tracked. Planes are for systems without angles: of others no degrees are counted, and a curve may not be found that
/// paths meet at infinity.
FoundFamilies name_families(const SparseSystem& system, const std::vector<Root<RuntimeUnknowns>>& suspects,
                            const RunOptions& run, const TrackerOptions& options, std::uint64_t most_paths);

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/named_families_definitions.hpp>
#endif
