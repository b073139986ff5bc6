/// \file
/// The two coefficients that tell a fold from a cusp and from a pitchfork: the reduced series (reduced_series.hpp) to
/// its third order, at a degenerate equilibrium whose null vector is known.
#pragma once

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/model_functions.hpp>

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
    double third = 0;   ///< phi'''
    double fourth = 0;  ///< phi''''
};

/// At q, an equilibrium at the parameters p whose J has the unit null vector v. Where there is a second null vector
/// `fourth` is infinite, and NaN here.
ReducedCoefficients reduced_coefficients(const ModelFunctions<>& functions, const RuntimeArray<double>& q,
                                         const RuntimeArray<double>& v, const RuntimeArray<double>& p);
/// The same of a model.
template <Model M>
ReducedCoefficients reduced_coefficients(const Unknowns<M>& q, const Unknowns<M>& v, const Parameters<M>& p) {
    return reduced_coefficients(functions_of<M>(), runtime_array(q), runtime_array(v), runtime_array(p));
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/singularity/detail/reduced_coefficients_definitions.hpp>
#endif
