/// \file
/// Degenerate equilibria of every kind that three or four parameters meet: their names, and what decided.
///
///     A_{k+1}, k parameters    g_1 = .. = g_k = 0: fold, cusp, swallowtail, butterfly (refine_singularity.hpp)
///     B_{k+1}, k parameters    g_1 = g_3 = .. = g_{2k-1} = 0 on a symmetric branch: pitchfork, tricritical,
///                              tetracritical (refine_symmetric_singularity.hpp)
///     D_4, three parameters    corank 2: hyperbolic, elliptic umbilic (refine_umbilic.hpp)
///     tangencies               a curve of cusps touches a plane z = const: lips, beak-to-beak
///                              (refine_cusp_tangency.hpp)
///
/// with F(q, p) = 0 each, and g_k the coefficients of the reduced gradient along the null vector (reduced_series.hpp).
/// Sources: Arnold, Gusein-Zade and Varchenko, Singularities of Differentiable Maps I (A_k, D_k; B_k for the symmetric
/// ones); Arnold, Catastrophe Theory, chapter 9 (lips and beak-to-beak).
#pragma once

#include <equilibria/core/array.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

enum class SingularityKind {
    undecided,                ///< not converged, or a coefficient that decides is 0 to rounding: a higher kind
    fold,                     ///< A2
    cusp,                     ///< A3
    swallowtail,              ///< A4
    butterfly,                ///< A5
    hyperbolic_umbilic,       ///< D4+: corank 2, the cubic has one real root line
    elliptic_umbilic,         ///< D4-: corank 2, the cubic has three real root lines
    pitchfork,                ///< B2 of a symmetric branch: phi'' = 0
    tricritical_pitchfork,    ///< B3: phi'' = phi'''' = 0, where a pitchfork turns from super- to subcritical
    tetracritical_pitchfork,  ///< B4: phi'' = phi'''' = phi^(6) = 0, where two mirror-image curves of cusps meet
    lips,                     ///< A3, two cusps meet as a third parameter moves: the second-order form is definite
    beak_to_beak              ///< the same with an indefinite form: two fold curves meet and reconnect
};

constexpr const char* to_string(SingularityKind kind) {
    switch (kind) {
        case SingularityKind::undecided: return "undecided";
        case SingularityKind::fold: return "fold";
        case SingularityKind::cusp: return "cusp";
        case SingularityKind::swallowtail: return "swallowtail";
        case SingularityKind::butterfly: return "butterfly";
        case SingularityKind::hyperbolic_umbilic: return "hyperbolic umbilic";
        case SingularityKind::elliptic_umbilic: return "elliptic umbilic";
        case SingularityKind::pitchfork: return "pitchfork";
        case SingularityKind::tricritical_pitchfork: return "tricritical pitchfork";
        case SingularityKind::tetracritical_pitchfork: return "tetracritical pitchfork";
        case SingularityKind::lips: return "lips";
        case SingularityKind::beak_to_beak: return "beak-to-beak";
    }
    return "unknown";
}

/// A degenerate equilibrium in the digits of S, with what decided its kind.
template <PotentialModel M, class S = double>
struct Singularity {
    SingularityKind kind = SingularityKind::undecided;
    Parameters<M, S> p;       ///< the active ones refined, the others as given
    Unknowns<M, S> q;         ///< the equilibrium
    Unknowns<M, S> v;         ///< a unit null vector
    Unknowns<M, S> w;         ///< corank 2: the other one, orthogonal to v; else 0
    S residual{};             ///< the largest |equation|
    S correction{};           ///< the last Newton step, largest entry over the unknown's size or 1: about the error
    int steps = 0;            ///< of Newton's method
    bool converged = false;   ///< the correction is a few thousand roundings, or less
    int nullity = 0;          ///< eigenvalues of J below 1e-8 of the largest derivative, in double
    Array<S, 6> derivatives;  ///< corank 1: of the reduced potential along v, phi''' .. phi^(8)
    Array<S, 4> cubic;        ///< corank 2: V'''[vvv], V'''[vvw], V'''[vww], V'''[www]
    /// Corank 2: the discriminant of the cubic over 27 and the fourth power of its norm: above 0 elliptic, below
    /// hyperbolic, within 1e-8 of 0 undecided (parabolic, D5 or higher).
    double discriminant = 0;
    /// Lips and beak-to-beak: the eigenvalues, ascending, of the Hessian of z as a function on the surface of folds in
    /// (q, v, x, y, z), on the tangent plane with the metric of (q, v, x, y).
    Array<double, 2> form;
    /// How far the active parameters unfold the singularity: the smallest singular value of the derivatives of the
    /// unfolding's coefficients by the parameters, each by its effect on all equations together. 0: not versal. Not of
    /// lips and beak-to-beak, whose x and y do not unfold the cusp.
    double versality = 0;
    bool versal() const { return versality > 1e-8; }

    /// phi^(k), k = 3..8.
    const S& derivative(int k) const { return derivatives[k - 3]; }
};

}  // namespace equilibria
