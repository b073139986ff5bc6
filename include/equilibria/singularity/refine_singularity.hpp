/// \file
/// Folds, cusps, swallowtails, butterflies (A_{k+1}), pitchforks to the tetracritical one (B_{k+1}) and extremal points
/// of curves of folds, to as many digits as the scalar has, by Newton's method in (q, p_1 .. p_k)
///
///     A_{k+1}: F(q, p) = 0,  g_1 = .. = g_k = 0             extremal: F(q, p) = 0,  g_1 = 0,  v . dF/dp_2 = 0
///
/// and, where F = 0 whatever the parameters, on a branch that the mirror image theta -> -theta leaves as it is, in the
/// parameters alone
///
///     B_{k+1}: g_1 = g_3 = .. = g_{2k-1} = 0,
///
/// g the coefficients of the reduced gradient along the null vector v (reduced_series.hpp), with the border of the last
/// iterate; symmetry makes the even ones 0. Derivatives are duals through that series. Give parameters to all digits of
/// a multiprecision scalar, 3/10 as S(3) / 10.
/// Where it fails: singularity_newton.hpp; and on a branch without the symmetry, where the kind is `undecided`.
/// Sources: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8; Arnold, Gusein-Zade and
/// Varchenko, Singularities of Differentiable Maps I (A_k, B_k).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/singularity/singularity.hpp>
#include <equilibria/singularity/singularity_kind.hpp>

namespace equilibria {

/// The singularity of the given kind near q and p, of a model whose numbers of unknowns and parameters are known at run
/// time; arguments and result as of the function for a model below. locate_singularity: by Newton's method alone, its
/// kind left undecided.
/// \{
template <class S>
RuntimeSingularity<S> locate_singularity(const ModelFunctions<S>& functions, SingularityKind kind,
                                         std::span<const int> active, const RuntimeArray<double>& q,
                                         const RuntimeArray<S>& p,
                                         const std::optional<RuntimeArray<double>>& v = std::nullopt);
template <class S>
RuntimeSingularity<S> refine_singularity(const ModelFunctions<S>& functions, SingularityKind kind,
                                         std::span<const int> active, const RuntimeArray<double>& q,
                                         const RuntimeArray<S>& p,
                                         const std::optional<RuntimeArray<double>>& v = std::nullopt);
/// \}

/// The singularity of the given kind near q (radians, coordinates) and p, in the parameters number Active.., as many as
/// the table of kinds says: fold and pitchfork one, cusp, tricritical pitchfork and extremal fold two, swallowtail and
/// tetracritical pitchfork three, butterfly four. Of an extremal fold the first one is extremal on the curve of folds
/// in the plane of both. Pitchforks are sought on the symmetric branch nearest to q, every angle 0 or pi, which must be
/// one of equilibria. v: about the null vector, of any length; else what J shortens most.
///
/// The result is of the kind if it says so; else `undecided`, `converged` or not. Throws InvalidArgument for arguments
/// that are not finite. Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 6 to 8.
template <Model M, SingularityKind Kind, int... Active, class S = double>
Singularity<M, S> refine_singularity(const Unknowns<M>& q, const Parameters<M, S>& p,
                                     const std::optional<Unknowns<M>>& v = std::nullopt) {
    constexpr SingularityClass row = class_of(Kind);
    static_assert(row.by_series(),
                  "equilibria: umbilics, lips and beak-to-beak have a refinement of their own, "
                  "refine_umbilic and refine_cusp_tangency; other kinds none");
    static_assert(sizeof...(Active) == static_cast<std::size_t>(row.parameters),
                  "equilibria: this kind of singularity has another number of active parameters");
    static_assert(!row.symmetric || n_coordinates<M> == 0, "equilibria: symmetric branches are those of angles alone");
    static_assert(Kind != SingularityKind::extremal_fold || PotentialModel<M>,
                  "equilibria: extremal points are refined for models with a potential");
    detail::check_active<M, Active...>();
    constexpr int active[] = {Active...};
    std::optional<RuntimeArray<double>> null;
    if (v) null = runtime_array(*v);
    return typed<M>(refine_singularity(functions_of<M, S>(), Kind, active, runtime_array(q), runtime_array(p), null));
}

}  // namespace equilibria

#include <equilibria/singularity/detail/refine_singularity_definitions.hpp>
