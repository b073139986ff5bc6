/// \file
/// A degenerate equilibrium: where it is, of what kind (singularity_kind.hpp), and what decided that. One type for the
/// points of curves, for what Newton's method found, and for cusps, extremal points and the higher kinds alike.
///
/// q are the angles in radians and the coordinates, p the parameters; phi is the reduced potential along the null
/// vector, V'''[v, v, v] + .. its derivatives (reduced_series.hpp). For models without a potential they are those of
/// the reduced equation, one order lower: phi''' is u . F''[v, v] with the unit left null vector u, u . v > 0.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/equations.hpp>
#include <equilibria/model/model_functions.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/singularity/singularity_kind.hpp>

namespace equilibria {

/// A degenerate equilibrium in the digits of S. The coefficients are there if `nullity` is not 0. M: the model, or
/// RuntimeUnknowns.
template <class M, class S = double>
struct Singularity {
    /// Undecided where Newton's method did not converge, or came to another kind.
    SingularityKind kind = SingularityKind::undecided;
    ParameterArray<M, S> p;  ///< the active ones as refined or traced, the others as given
    UnknownArray<M, S> q;    ///< the equilibrium
    UnknownArray<M, S> v;    ///< a unit null vector
    UnknownArray<M, S> w;    ///< corank 2: the other one, orthogonal to v; else 0
    /// The numbers of the active parameters, in the order in which they were named: x, y, z, ..; -1 beyond.
    std::array<int, 4> active{-1, -1, -1, -1};
    int extremal = -1;  ///< of extremal points the number of the parameter that turns back on its curve; else -1

    S residual{};            ///< the largest |equation|
    S correction{};          ///< the last Newton step, largest entry over the unknown's size or 1: about the error
    int steps = 0;           ///< of Newton's method
    bool converged = false;  ///< the correction is a few thousand roundings, or less
    /// Newton's method came to rest: it converged, or the corrections are the roundings of a badly conditioned point.
    bool settled() const { return converged || (correction > S(0.0) && correction < S(1e-10)); }

    int nullity = 0;          ///< singular values of J below 1e-8 of the largest derivative, in double
    Array<S, 6> derivatives;  ///< corank 1: of the reduced potential along v, phi''' .. phi^(8)
    Array<S, 4> cubic;        ///< corank 2: V'''[vvv], V'''[vvw], V'''[vww], V'''[www]
    /// Corank 2: the discriminant of the cubic over 27 and the fourth power of its norm: above 0 elliptic, below
    /// hyperbolic, within 1e-8 of 0 undecided (parabolic, D5 or higher).
    double discriminant = 0;
    /// Lips and beak-to-beak: the eigenvalues, ascending, of the Hessian of z as a function on the surface of folds in
    /// (q, v, x, y, z), on the tangent plane with the metric of (q, v, x, y).
    Array<double, 2> form;
    /// How far the active parameters unfold the singularity: the smallest singular value of the derivatives of the
    /// unfolding's coefficients by the parameters, each by its effect on all equations together. 0: not versal. Of the
    /// kinds A, B and D; of the others not computed.
    double versality = 0;
    bool versal() const { return versality > 1e-8; }  ///< whether the active parameters unfold it to first order

    /// phi^(k), k = 3..8.
    const S& derivative(int k) const { return derivatives[k - 3]; }

    /// The active parameters, of which there must be so many.
    /// \{
    S& x() { return p[active[0]]; }
    S& y() { return p[active[1]]; }
    S& z() { return p[active[2]]; }
    const S& x() const { return p[active[0]]; }
    const S& y() const { return p[active[1]]; }
    const S& z() const { return p[active[2]]; }
    /// \}
};

/// The equilibrium q at p with the null vector v, the parameters number Active.. being active; the rest as by default.
template <Model M, int... Active, class S = double>
Singularity<M, S> singularity_at(SingularityKind kind, const Unknowns<M, S>& q, const Parameters<M, S>& p,
                                 const Unknowns<M, S>& v = Unknowns<M, S>()) {
    static_assert(sizeof...(Active) <= 4, "equilibria: at most four active parameters");
    detail::check_active<M, Active...>();
    Singularity<M, S> at;
    at.kind = kind;
    at.p = p;
    at.q = q;
    at.v = v;
    std::size_t k = 0;
    ((at.active[k++] = Active), ...);
    return at;
}

/// The same of a model whose numbers of unknowns and parameters are known at run time.
template <class S = double>
using RuntimeSingularity = Singularity<RuntimeUnknowns, S>;

namespace detail {

/// `to`, which has p, q, v and w, with everything else of `from`.
template <class To, class From>
To with_evidence_of(const From& from, To to) {
    to.kind = from.kind;
    to.active = from.active;
    to.extremal = from.extremal;
    to.residual = from.residual;
    to.correction = from.correction;
    to.steps = from.steps;
    to.converged = from.converged;
    to.nullity = from.nullity;
    to.derivatives = from.derivatives;
    to.cubic = from.cubic;
    to.discriminant = from.discriminant;
    to.form = from.form;
    to.versality = from.versality;
    return to;
}

}  // namespace detail

/// The same point, its numbers in arrays of a size known at run time, and back.
/// \{
template <Model M, class S>
RuntimeSingularity<S> runtime_singularity(const Singularity<M, S>& at) {
    RuntimeSingularity<S> y;
    y.p = runtime_array(at.p);
    y.q = runtime_array(at.q);
    y.v = runtime_array(at.v);
    y.w = runtime_array(at.w);
    return detail::with_evidence_of(at, std::move(y));
}
template <Model M, class S>
Singularity<M, S> typed(const RuntimeSingularity<S>& at) {
    Singularity<M, S> y;
    y.p = parameters_from<M>(at.p);
    y.q = unknowns_from<M>(at.q);
    y.v = unknowns_from<M>(at.v);
    if (at.w.size() > 0) y.w = unknowns_from<M>(at.w);
    return detail::with_evidence_of(at, y);
}
/// \}

/// The equilibrium q at p with the null vector v, the parameters number `active` being active; the rest as by default.
template <class S>
RuntimeSingularity<S> singularity_at(SingularityKind kind, std::span<const int> active, const RuntimeArray<S>& q,
                                     const RuntimeArray<S>& p, const RuntimeArray<S>& v = {}) {
    RuntimeSingularity<S> at;
    at.kind = kind;
    at.p = p;
    at.q = q;
    at.v = v;
    std::copy(active.begin(), active.end(), at.active.begin());
    return at;
}

}  // namespace equilibria
