/// \file
/// Degenerate equilibria of a model as the solutions of polynomial systems, models of their own: what `enumerate` does
/// for equilibria it does for folds, cusps and the extremal points of a locus, all of them, every path accounted for.
///
/// Unknowns: the model's q, then w (n - 1 numbers), then the active parameters x. Equations:
///     F(q, p) = 0,    J(q, p) v = 0,    v = B (1, w),                        and with two active parameters
///     slice + sum_k extremal_k v . dF/dx_k + cusp V'''[v, v, v] = 0,         slice = s_0 + s_1 x_1 + s_2 x_2,
/// with a random basis B, so that no null vector is at infinity in w. The weights in the last equation, parameters of
/// the system, choose what is solved for: the folds of a line of the plane (slice); the points at which the locus has a
/// tangent normal to x_1 (extremal_2 = 1: there v . dF/dx_2 = 0), folds of the fold curve over the axis of x_1; or its
/// cusps. A parameter that enters by even powers alone is replaced by its square, which halves degrees and solutions, and
/// equations are divided by powers of active parameters that all their terms have: solutions at 0 of such a parameter,
/// where that equation would vanish identically, are left out.
///
/// Pitchforks on symmetric branches are singular solutions; they are found on those branches (symmetric_branches.hpp,
/// symmetric_system.hpp). Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 4.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/algebra/symbolic.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

namespace detail {

/// T holds S with derivatives along one direction, nested: a constant.
template <class T, class S>
constexpr T constant_along(const S& value) {
    if constexpr (std::is_same_v<T, S>)
        return value;
    else
        return T(constant_along<decltype(T{}.value)>(value));
}
/// The coordinate `value` that moves by `slope`.
template <class T, class S>
constexpr T coordinate_along(const S& value, const S& slope) {
    if constexpr (std::is_same_v<T, S>) {
        return value;
    } else {
        using Inner = decltype(T{}.value);
        T y(coordinate_along<Inner>(value, slope));
        y.derivative[0] = constant_along<Inner>(slope);
        return y;
    }
}
/// The angle with cosine c and sine s that moves by `slope`.
template <class T, class S>
constexpr CircleAngle<T> angle_along(const S& c, const S& s, const S& slope) {
    if constexpr (std::is_same_v<T, S>) {
        return {c, s};
    } else {
        using Inner = decltype(T{}.value);
        const CircleAngle<Inner> inner = angle_along<Inner>(c, s, slope);
        const Inner by = constant_along<Inner>(slope);
        CircleAngle<T> y{T(inner.c), T(inner.s)};
        y.c.derivative[0] = -(inner.s * by);
        y.s.derivative[0] = inner.c * by;
        return y;
    }
}

}  // namespace detail

/// Active: the numbers of one or two parameters of M that become unknowns. Parameters p: the model's own (the active
/// ones are not read), then the scales of the active ones, for unknowns of the size of 1; then the n x n entries of B,
/// row by row; then, with two, the weights of the last equation.
template <Model M, int... Active>
struct CriticalSystem {
    static constexpr int n = n_unknowns<M>, actives = sizeof...(Active);
    static_assert(actives == 1 || actives == 2, "equilibria: a critical system has one or two active parameters");
    static_assert(((Active >= 0 && Active < equilibria::n_parameters<M>)&&...), "equilibria: no such parameter");
    static constexpr Array<int, actives> active{Active...};
    static constexpr int n_angles = equilibria::n_angles<M>;
    static constexpr int first_null = equilibria::n_coordinates<M>;  ///< the coordinate w_1
    static constexpr int first_active = first_null + n - 1;          ///< the coordinate x_1
    /// With two active parameters symmetric branches hold curves of solutions, the pitchforks. They are sent to
    /// infinity by one more unknown and equation, y sum_i r_i sin theta_i = 1.
    static constexpr bool off_symmetric_branches = actives == 2 && Formulation<M>::reflection_symmetric;
    static constexpr int reciprocal = first_active + actives;  ///< the coordinate y
    static constexpr int n_coordinates = reciprocal + off_symmetric_branches;

    static constexpr int scale = equilibria::n_parameters<M>;
    static constexpr int first_basis = scale + actives;
    static constexpr int slice = first_basis + n * n;  ///< s_1, s_2, s_0
    static constexpr int extremal = slice + 3;         ///< two weights
    static constexpr int cusp = extremal + 2;
    static constexpr int first_sine = cusp + 1;  ///< r_1 .. r_n
    static constexpr int n_parameters =
        actives == 1 ? slice : off_symmetric_branches ? first_sine + n_angles : first_sine;
    /// Left null vectors would be needed without one.
    static constexpr bool derivatives = actives == 2 && PotentialModel<M>;

    /// {q}, {w}, {x_1}, {x_2}
    static constexpr Array<int, n_angles + n_coordinates> grouping = [] {
        Array<int, n_angles + n_coordinates> y{};
        for (int k = 0; k < n - 1; ++k) y[n_angles + first_null + k] = 1;
        for (int k = first_active; k < n_coordinates; ++k) y[n_angles + k] = (n > 1 ? 2 : 1) + k - first_active;
        return y;
    }();

    template <class C>
    using Polynomial = TrigonometricPolynomial<n_angles, n_coordinates, C>;

private:
    template <class C>
    static constexpr Polynomial<C> coordinate(int j) {
        return {Polynomial<C>::Basis::single(n_angles + j, 1), C(1)};
    }
    /// F with the active parameters for unknowns, as the model has it.
    template <class C>
    static constexpr std::vector<Polynomial<C>> raw_equations(const auto& p) {
        using Scalar = SymbolicScalar<n_angles, n_coordinates, C>;
        using Angle = SymbolicAngle<n_angles, n_coordinates, C>;
        typename Scalar::Pool pool;
        Array<Angle, n_angles> theta;
        Array<Scalar, equilibria::n_coordinates<M>> x;
        Array<Scalar, equilibria::n_parameters<M>> q;
        for (int i = 0; i < n_angles; ++i) theta[i] = Angle(&pool, i);
        for (int j = 0; j < x.size(); ++j) x[j] = Scalar(&pool, coordinate<C>(j));
        for (int k = 0; k < q.size(); ++k) q[k] = Scalar(p[k]);
        for (int k = 0; k < actives; ++k)
            q[active[k]] = Scalar(&pool, coordinate<C>(first_active + k) * Polynomial<C>(p[scale + k]));
        std::vector<Polynomial<C>> f;
        if constexpr (PotentialModel<M>) {
            const Polynomial<C> v = Scalar(detail::call_potential(M{}, theta, x, q)).polynomial();
            for (int i = 0; i < n; ++i) f.push_back(derivative(v, i));
        } else {
            const auto values = detail::call_equations(M{}, theta, x, q);
            for (const auto& value : values) f.push_back(Scalar(value).polynomial());
        }
        return f;
    }
    /// At generic parameters.
    static constexpr std::vector<Polynomial<double>> raw_equations_pruned() {
        const auto generic = detail::generic_parameters<M>();
        Array<double, first_basis> p;
        for (int k = 0; k < p.size(); ++k) p[k] = k < scale ? generic[k] : 1;
        auto f = raw_equations<double>(p);
        for (auto& equation : f) equation = equation.pruned();
        return f;
    }
    template <class C>
    static constexpr Polynomial<C> with_monomials(const Polynomial<C>& f, const auto& change) {
        Polynomial<C> y;
        for (const auto& term : f.terms()) {
            auto monomial = term.monomial;
            for (int k = 0; k < actives; ++k) {
                const int u = n_angles + first_active + k;
                monomial.set_code(u, change(k, monomial.code(u)));
            }
            y += Polynomial<C>(monomial, term.coefficient);
        }
        return y;
    }

public:
    /// x_k is the power[k]-th power (1 or 2) of the parameter active[k] over its scale.
    static constexpr Array<int, actives> power = [] {
        Array<int, actives> y{};
        for (const auto& equation : raw_equations_pruned())
            for (const auto& term : equation.terms())
                for (int k = 0; k < actives; ++k) y[k] = std::gcd(y[k], term.monomial.code(n_angles + first_active + k));
        for (int& g : y) g = g > 0 && g % 2 == 0 ? 2 : 1;
        return y;
    }();
    /// The highest power of the parameter active[k] in F.
    static constexpr Array<int, actives> degree = [] {
        Array<int, actives> y{};
        for (const auto& equation : raw_equations_pruned())
            for (const auto& term : equation.terms())
                for (int k = 0; k < actives; ++k) y[k] = std::max(y[k], term.monomial.code(n_angles + first_active + k));
        return y;
    }();
    /// Equations i of F and of J v are divided by prod_k x_k^content[i][k].
    static constexpr Array<Array<int, actives>, n> content = [] {
        Array<Array<int, actives>, n> y;
        const auto f = raw_equations_pruned();
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < actives; ++k) {
                y[i][k] = 127;
                for (const auto& term : f[static_cast<std::size_t>(i)].terms())
                    y[i][k] = std::min(y[i][k], term.monomial.code(n_angles + first_active + k) / power[k]);
            }
        return y;
    }();

    /// The system's parameters for those of M: random B and r, weights 0. scales: of the active parameters, positive.
    static Array<double, n_parameters> parameters(const Parameters<M>& p, const Array<double, actives>& scales,
                                                  Generator& generator) {
        Array<double, n_parameters> y;
        for (int k = 0; k < p.size(); ++k) y[k] = p[k];
        for (int k = 0; k < actives; ++k) y[scale + k] = scales[k];
        for (int k = 0; k < n * n; ++k) y[first_basis + k] = uniform(generator, -1, 1);
        if constexpr (off_symmetric_branches)
            for (int i = 0; i < n_angles; ++i) y[first_sine + i] = uniform(generator, -1, 1);
        return y;
    }

    /// The active parameter number k from its unknown, and back.
    template <class S>
    static constexpr S parameter(int k, const S& x, const auto& size) {
        using std::sqrt;
        return power[k] == 2 ? S(size * sqrt(x)) : S(size * x);
    }
    static constexpr double unknown(int k, double parameter, double size) {
        const double x = parameter / size;
        return power[k] == 2 ? x * x : x;
    }
    /// The derivative of the parameter by its unknown.
    template <class S>
    static constexpr S slope(int k, const S& parameter, const auto& size) {
        return power[k] == 2 ? S(0.5 * size * size / parameter) : S(size);
    }

    constexpr auto equations(const auto& theta, const auto& x, const auto& p) const {
        using S = scalar_of<decltype(theta)>;
        using D = Dual<S, 1>;
        Array<S, n> v;
        for (int i = 0; i < n; ++i) {
            v[i] = S(p[first_basis + i * n]);
            for (int k = 1; k < n; ++k) v[i] = v[i] + p[first_basis + i * n + k] * x[first_null + k - 1];
        }
        Parameters<M, S> q;
        for (int k = 0; k < q.size(); ++k) q[k] = S(p[k]);
        for (int k = 0; k < actives; ++k) q[active[k]] = parameter<S>(k, x[first_active + k], p[scale + k]);

        // along v, twice where the last equation wants V'''
        using T = std::conditional_t<derivatives, Dual<D, 1>, D>;
        detail::AnglesOf<M, T> angle;
        detail::CoordinatesOf<M, T> coordinate;
        Parameters<M, T> lifted;
        for (int i = 0; i < n_angles; ++i)
            angle[i] = detail::angle_along<T, S>(cos(theta[i]), sin(theta[i]), v[i]);
        for (int j = 0; j < coordinate.size(); ++j)
            coordinate[j] = detail::coordinate_along<T, S>(x[j], v[n_angles + j]);
        for (int k = 0; k < q.size(); ++k) lifted[k] = detail::constant_along<T, S>(q[k]);
        const Unknowns<M, T> f = detail::equations_at<M, T>(angle, coordinate, lifted);

        Array<S, n_angles + n_coordinates> y;
        for (int i = 0; i < n; ++i) {
            S value, slope;
            if constexpr (derivatives)
                value = f[i].value.value, slope = f[i].value.derivative[0];
            else
                value = f[i].value, slope = f[i].derivative[0];
            for (int k = 0; k < actives; ++k)
                for (int m = 0; m < content[i][k]; ++m) {
                    value = value / x[first_active + k];
                    slope = slope / x[first_active + k];
                }
            y[i] = value;
            y[n + i] = slope;
        }
        if constexpr (actives == 2) {
            S last = p[slice] * x[first_active] + p[slice + 1] * x[first_active + 1] + S(p[slice + 2]);
            if constexpr (derivatives) {
                for (int i = 0; i < n; ++i) last = last + p[cusp] * v[i] * f[i].derivative[0].derivative[0];
                for (int k = 0; k < 2; ++k) {
                    detail::AnglesOf<M, D> still;
                    detail::CoordinatesOf<M, D> at;
                    for (int i = 0; i < n_angles; ++i) still[i] = {D(S(cos(theta[i]))), D(S(sin(theta[i])))};
                    for (int j = 0; j < at.size(); ++j) at[j] = D(S(x[j]));
                    Parameters<M, D> moving;
                    for (int m = 0; m < q.size(); ++m) moving[m] = D(q[m]);
                    moving[active[k]].derivative[0] = slope<S>(k, q[active[k]], p[scale + k]);
                    const Unknowns<M, D> g = detail::equations_at<M, D>(still, at, moving);
                    for (int i = 0; i < n; ++i) last = last + p[extremal + k] * v[i] * g[i].derivative[0];
                }
            }
            y[2 * n] = last;
        }
        if constexpr (off_symmetric_branches) {
            S sum = p[first_sine] * sin(theta[0]);
            for (int i = 1; i < n_angles; ++i) sum = sum + p[first_sine + i] * sin(theta[i]);
            y[2 * n + 1] = x[reciprocal] * sum - S(1.0);
        }
        return y;
    }

    /// F in the unknowns of the system. p: at least the parameters of M.
    template <class C>
    static constexpr std::vector<Polynomial<C>> model_equations(const auto& p) {
        auto f = raw_equations<C>(p);
        for (auto& equation : f)
            equation = with_monomials(equation, [](int k, int code) { return code / power[k]; });
        return f;
    }

    /// The same equations as polynomials, by symbolic differentiation of the model's own.
    template <class C>
    static constexpr auto polynomials(const Array<C, n_parameters>& p) {
        std::vector<Polynomial<C>> f = model_equations<C>(p), v, y;
        for (int i = 0; i < n; ++i) {
            Polynomial<C> entry(p[first_basis + i * n]);
            for (int k = 1; k < n; ++k)
                entry += Polynomial<C>(p[first_basis + i * n + k]) * coordinate<C>(first_null + k - 1);
            v.push_back(entry);
        }
        const auto at = [](const std::vector<Polynomial<C>>& list, int i) -> const Polynomial<C>& {
            return list[static_cast<std::size_t>(i)];
        };
        std::vector<Polynomial<C>> jv;
        for (int i = 0; i < n; ++i) {
            Polynomial<C> row;
            for (int k = 0; k < n; ++k) row += derivative(at(f, i), k) * at(v, k);
            jv.push_back(row);
        }
        const auto divided = [](const Polynomial<C>& equation, int i) {
            return with_monomials(equation, [i](int k, int code) { return code - content[i][k]; });
        };
        for (int i = 0; i < n; ++i) y.push_back(divided(at(f, i), i));
        for (int i = 0; i < n; ++i) y.push_back(divided(at(jv, i), i));
        if constexpr (actives == 2) {
            Polynomial<C> last(p[slice + 2]);
            for (int k = 0; k < 2; ++k) last += Polynomial<C>(p[slice + k]) * coordinate<C>(first_active + k);
            if constexpr (derivatives) {
                Polynomial<C> third;
                for (int i = 0; i < n; ++i) {
                    Polynomial<C> entry;
                    for (int k = 0; k < n; ++k) entry += derivative(at(jv, i), k) * at(v, k);
                    third += entry * at(v, i);
                }
                last += Polynomial<C>(p[cusp]) * third;
                for (int k = 0; k < 2; ++k) {
                    Polynomial<C> sum;
                    for (int i = 0; i < n; ++i)
                        sum += derivative(at(f, i), n_angles + first_active + k) * at(v, i);
                    last += Polynomial<C>(p[extremal + k]) * sum;
                }
            }
            y.push_back(last);
        }
        if constexpr (off_symmetric_branches) {
            Polynomial<C> sum;
            for (int i = 0; i < n_angles; ++i)
                sum += Polynomial<C>(Polynomial<C>::Basis::single(i, -1), p[first_sine + i]);
            y.push_back(sum * coordinate<C>(reciprocal) - Polynomial<C>(1));
        }
        return y;
    }
};

}  // namespace equilibria
