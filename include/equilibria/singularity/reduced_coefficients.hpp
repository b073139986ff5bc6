/// \file
/// The two coefficients that tell a fold from a cusp and from a pitchfork: the reduced series (reduced_series.hpp) to
/// its third order, at a degenerate equilibrium whose null vector is known.
#pragma once

#include <limits>

#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_series.hpp>

namespace equilibria {

/// The derivatives of the reduced potential along the null vector v at a degenerate equilibrium:
///
///     third = phi'''   = V'''[v, v, v],
///     fourth = phi'''' = V''''[v^4] - 3 <V'''[v, v, .], J^+ V'''[v, v, .]>.
///
/// For models with equations only, the same with F and the unit left null vector in place of the last v.
///
/// third != 0: fold (A2). third = 0, fourth != 0: cusp (A3), or pitchfork where v is odd on a symmetric branch.
struct ReducedCoefficients {
    double third = 0, fourth = 0;
};

/// At q, an equilibrium at the parameters p whose J has the unit null vector v. Where there is a second null vector
/// `fourth` is infinite, and NaN here.
template <Model M>
ReducedCoefficients reduced_coefficients(const Unknowns<M>& q, const Unknowns<M>& v, const Parameters<M>& p) {
    const Unknowns<M> u = left_null_vector<M>(jacobian<M, double>(q, p), v);
    const auto series = reduced_series<M, 3>(q, v, u, p);
    if (series.regular) return {series.derivative(3), series.derivative(4)};
    double third = 0;
    const auto second = directional_derivative<2, M, double>(q, v, p);
    for (int i = 0; i < n_unknowns<M>; ++i) third += u[i] * second[i];
    return {third, std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace equilibria
