/// \file
/// Folds, pitchforks, cusps and extremal points of fold curves to as many digits as the scalar has, by Newton's method on the augmented systems
///
///     fold, y = (q, v, p_x):     pitchfork, y = (v, p_x):     cusp, y = (q, v, p_x, p_y):
///     [ F(q, p)          ]       [ J(q, p) v        ]         [ F(q, p)          ]
///     [ J(q, p) v        ] = 0   [ (v . v - 1) / 2  ] = 0     [ J(q, p) v        ] = 0
///     [ (v . v - 1) / 2  ]                                    [ (v . v - 1) / 2  ]
///                                                             [ V'''[v, v, v]    ]
/// and with v . dF/dp_y = 0 for the last row, where p_x is extremal on the fold curve,
/// whose Jacobians are exact (automatic differentiation) and regular at generic points of each kind. The scalar is
/// double or a multiprecision float (core/multiprecision.hpp); give parameters to all its digits, 3/10 as S(3) / 10.
/// Where it fails: at points of a higher kind (a fold system at a cusp of the line of p_x, a cusp system at a
/// swallowtail) convergence is linear or absent, and `converged` false.
/// Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 4.1 and 8.
#pragma once

#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/model/derivatives.hpp>

namespace equilibria {

/// A degenerate equilibrium in the digits of S.
template <Model M, class S>
struct RefinedPoint {
    Parameters<M, S> p;      ///< the active ones refined, the others as given
    Unknowns<M, S> q;        ///< the equilibrium
    Unknowns<M, S> v;        ///< its unit null vector
    S residual{};            ///< the largest |equation| of the augmented system
    S correction{};          ///< the last Newton step, largest entry: about the error
    int steps = 0;           ///< of Newton's method
    bool converged = false;  ///< the correction is a few thousand roundings, or less
};

namespace detail {

enum class Degeneracy { fold, pitchfork, cusp, extremal };

/// The augmented system of a kind. Unknowns y: q (but for a pitchfork, whose q is fixed), v, the active parameters.
template <Model M, Degeneracy Kind, int... Active>
struct AugmentedSystem {
    static constexpr int n = n_unknowns<M>;
    static constexpr bool moves = Kind != Degeneracy::pitchfork;
    static constexpr int active = sizeof...(Active);
    static constexpr int unknowns = (moves ? 2 * n : n) + active;

    template <class S>
    static Array<S, unknowns> packed(const RefinedPoint<M, S>& at) {
        Array<S, unknowns> y;
        int k = 0;
        if (moves)
            for (const S& x : at.q) y[k++] = x;
        for (const S& x : at.v) y[k++] = x;
        ((y[k++] = at.p[Active]), ...);
        return y;
    }
    template <class S>
    static void unpack(const Array<S, unknowns>& y, RefinedPoint<M, S>& at) {
        int k = 0;
        if (moves)
            for (S& x : at.q) x = y[k++];
        for (S& x : at.v) x = y[k++];
        ((at.p[Active] = y[k++]), ...);
    }

    template <class S>
    static Array<S, unknowns> residual(const RefinedPoint<M, S>& at) {
        Array<S, unknowns> r;
        int k = 0;
        if constexpr (moves)
            for (const S& f : equations<M, S>(at.q, at.p)) r[k++] = f;
        for (const S& f : directional_derivative<1, M, S>(at.q, at.v, at.p)) r[k++] = f;
        S square(-1.0);
        for (const S& x : at.v) square = square + x * x;
        r[k++] = 0.5 * square;
        if constexpr (Kind == Degeneracy::cusp) r[k++] = third_derivative<M, S>(at.q, at.v, at.p);
        if constexpr (Kind == Degeneracy::extremal) {
            constexpr int parameters[] = {Active...};
            const auto f_p = parameter_derivative<M, S>(at.q, at.p, parameters[1]);
            r[k] = S(0.0);
            for (int i = 0; i < n; ++i) r[k] = r[k] + at.v[i] * f_p[i];
        }
        return r;
    }

    template <class S>
    static RefinedPoint<M, S> refined(RefinedPoint<M, S> at) {
        using std::abs;
        using D = Dual<S, unknowns>;
        const S rounding = std::numeric_limits<S>::epsilon();
        const auto largest = [](const Array<S, unknowns>& r) {
            S y(0);
            for (const S& x : r)
                if (!(abs(x) <= y)) y = abs(x);
            return y;
        };
        while (at.steps < 50) {
            const Array<S, unknowns> y = packed(at);
            Array<D, unknowns> variables;
            for (int k = 0; k < unknowns; ++k) variables[k] = D::variable(y[k], k);
            RefinedPoint<M, D> lifted;
            for (int i = 0; i < n; ++i) lifted.q[i] = at.q[i];
            for (int k = 0; k < lifted.p.size(); ++k) lifted.p[k] = at.p[k];
            unpack(variables, lifted);
            const Array<D, unknowns> r = residual(lifted);
            Array<Array<S, unknowns>, unknowns> jacobian;
            Array<S, unknowns> step;
            for (int i = 0; i < unknowns; ++i) jacobian[i] = r[i].derivative, step[i] = r[i].value;
            ++at.steps;
            const DenseFactorization<S, unknowns> factors(jacobian);
            if (!factors.regular()) break;
            step = factors.solve(step);
            Array<S, unknowns> next = y;
            for (int k = 0; k < unknowns; ++k) next[k] -= step[k];
            unpack(next, at);
            const S before = at.correction;
            at.correction = largest(step);
            at.converged = at.correction <= 4096 * rounding;
            // once more after the last digit, while it still helps
            if (at.converged && (at.correction <= 16 * rounding || (at.steps > 1 && !(at.correction < before / 2))))
                break;
            if (!(at.correction < S(1e3))) break;
        }
        at.residual = largest(residual(at));
        return at;
    }

    /// A first guess of v: the right singular vector of the smallest singular value of J in double.
    template <class S>
    static RefinedPoint<M, S> begin(const Unknowns<M, S>& q, const Parameters<M, S>& p) {
        RefinedPoint<M, S> at;
        at.p = p;
        at.q = q;
        Unknowns<M> near;
        Parameters<M> rounded;
        for (int i = 0; i < n; ++i) near[i] = static_cast<double>(q[i]);
        for (int k = 0; k < rounded.size(); ++k) rounded[k] = static_cast<double>(p[k]);
        const auto j = jacobian<M, double>(near, rounded);
        SingularValues::Vector a;
        for (int c = 0; c < n; ++c)
            for (int r = 0; r < n; ++r) a.emplace_back(j(r, c));
        const auto v = SingularValues(n, n, std::move(a)).right(n - 1);
        for (int i = 0; i < n; ++i) at.v[i] = S(v[static_cast<std::size_t>(i)].real());
        return at;
    }
};

template <class M, class S>
Unknowns<M, S> widened(const Unknowns<M>& q) {
    Unknowns<M, S> y;
    for (int i = 0; i < q.size(); ++i) y[i] = S(q[i]);
    return y;
}

}  // namespace detail

/// The fold near q and p on the line of the parameter number X, in the digits of S.
template <Model M, int X, class S = double>
RefinedPoint<M, S> refine_fold(const Unknowns<M>& q, const Parameters<M, S>& p) {
    static_assert(X >= 0 && X < n_parameters<M>, "equilibria: no such parameter");
    using System = detail::AugmentedSystem<M, detail::Degeneracy::fold, X>;
    return System::refined(System::begin(detail::widened<M, S>(q), p));
}

/// The pitchfork near p on the line of the parameter number X, from the symmetric equilibrium nearest to q: every angle
/// 0 or pi, which must be an equilibrium for all parameters.
template <Model M, int X, class S = double>
requires(n_coordinates<M> == 0) RefinedPoint<M, S> refine_pitchfork(const Unknowns<M>& q, const Parameters<M, S>& p) {
    static_assert(X >= 0 && X < n_parameters<M>, "equilibria: no such parameter");
    using std::atan;
    using System = detail::AugmentedSystem<M, detail::Degeneracy::pitchfork, X>;
    Unknowns<M, S> branch;
    for (int i = 0; i < branch.size(); ++i) branch[i] = std::cos(q[i]) < 0 ? S(4 * atan(S(1))) : S(0);
    return System::refined(System::begin(branch, p));
}

/// The cusp near q and p in the plane of the parameters number X and Y, in the digits of S.
template <PotentialModel M, int X, int Y, class S = double>
RefinedPoint<M, S> refine_cusp(const Unknowns<M>& q, const Parameters<M, S>& p) {
    static_assert(X >= 0 && X < n_parameters<M> && Y >= 0 && Y < n_parameters<M> && X != Y,
                  "equilibria: a cusp needs two different parameters");
    using System = detail::AugmentedSystem<M, detail::Degeneracy::cusp, X, Y>;
    return System::refined(System::begin(detail::widened<M, S>(q), p));
}

/// The point of the fold curve near q and p at which the parameter number X is extremal, in the plane of X and Y.
template <PotentialModel M, int X, int Y, class S = double>
RefinedPoint<M, S> refine_extremal(const Unknowns<M>& q, const Parameters<M, S>& p) {
    static_assert(X >= 0 && X < n_parameters<M> && Y >= 0 && Y < n_parameters<M> && X != Y,
                  "equilibria: an extremal point needs two different parameters");
    using System = detail::AugmentedSystem<M, detail::Degeneracy::extremal, X, Y>;
    return System::refined(System::begin(detail::widened<M, S>(q), p));
}

}  // namespace equilibria
