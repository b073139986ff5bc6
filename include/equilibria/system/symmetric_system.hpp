/// \file
/// Special pitchforks of the symmetric branches in a plane of two parameters, as solutions of a polynomial system: where a
/// curve of pitchforks has an extremal parameter, and where its pitchforks turn from super- to subcritical (degenerate
/// pitchforks, in which fold curves end).
///
/// On a branch theta in {0, pi}^n the equations are fulfilled. Unknowns: w (n - 1 numbers), then the active parameters x, as
/// in critical_system.hpp. Equations:
///     J v = 0,    v = B (1, w),    slice + sum_k extremal_k v . dJ/dx_k v + fourth V''''[v, v, v, v] = 0,
/// slice = s_0 + s_1 x_1 + s_2 x_2. The third derivatives of V vanish there, so that V'''' is the reduced fourth derivative.
/// At extremal_2 = 1 x_1 is extremal on the curve; the slice alone gives the pitchforks of a line.
#pragma once

#include <vector>

#include <equilibria/system/critical_system.hpp>

namespace equilibria {

/// Parameters p: the model's own (the active ones are not read), their scales, the n x n entries of B, the cosines of the branch (1 or
/// -1), and the weights of the last equation.
template <PotentialModel M, int X, int Y>
struct SymmetricSystem {
    using Plane = CriticalSystem<M, X, Y>;
    static constexpr int n = n_unknowns<M>;
    static constexpr int n_angles = 0;
    static constexpr int first_active = n - 1;
    static constexpr int n_coordinates = n + 1;
    static constexpr int scale = Plane::scale;
    static constexpr int first_basis = Plane::first_basis;
    static constexpr int cosine = first_basis + n * n;
    static constexpr int extremal = cosine + n;
    static constexpr int fourth = extremal + 2;
    static constexpr int slice = fourth + 1;  ///< s_1, s_2, s_0
    static constexpr int n_parameters = slice + 3;

    /// {w}, {x_1}, {x_2}
    static constexpr Array<int, n_coordinates> grouping = [] {
        Array<int, n_coordinates> y{};
        for (int k = 0; k < 2; ++k) y[first_active + k] = (n > 1 ? 1 : 0) + k;
        return y;
    }();

    static Array<double, n_parameters> parameters(const Parameters<M>& p, const Array<double, 2>& scales,
                                                  const Unknowns<M>& branch, Generator& generator) {
        Array<double, n_parameters> y;
        for (int k = 0; k < p.size(); ++k) y[k] = p[k];
        for (int k = 0; k < 2; ++k) y[scale + k] = scales[k];
        for (int k = 0; k < n * n; ++k) y[first_basis + k] = uniform(generator, -1, 1);
        for (int i = 0; i < n; ++i) y[cosine + i] = std::cos(branch[i]) < 0 ? -1 : 1;
        return y;
    }

    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(x[0])>;
        Array<S, n> v;
        for (int i = 0; i < n; ++i) {
            v[i] = S(p[first_basis + i * n]);
            for (int k = 1; k < n; ++k) v[i] = v[i] + p[first_basis + i * n + k] * x[k - 1];
        }
        Parameters<M, S> q;
        for (int k = 0; k < q.size(); ++k) q[k] = S(p[k]);
        for (int k = 0; k < 2; ++k) q[Plane::active[k]] = Plane::template parameter<S>(k, x[first_active + k], p[scale + k]);

        using D = Dual<S, 1>;
        using T = Dual<Dual<D, 1>, 1>;
        detail::AnglesOf<M, T> moving;
        Parameters<M, T> constant;
        for (int i = 0; i < n; ++i) moving[i] = detail::angle_along<T, S>(S(p[cosine + i]), S(0.0), v[i]);
        for (int k = 0; k < q.size(); ++k) constant[k] = detail::constant_along<T, S>(q[k]);
        const Unknowns<M, T> f = detail::equations_at<M, T>(moving, detail::CoordinatesOf<M, T>{}, constant);
        Array<S, n_coordinates> y;
        S last = p[slice] * x[first_active] + p[slice + 1] * x[first_active + 1] + S(p[slice + 2]);
        for (int i = 0; i < n; ++i) {
            y[i] = f[i].value.value.derivative[0];
            for (int k = 0; k < 2; ++k)
                for (int m = 0; m < Plane::content[i][k]; ++m) y[i] = y[i] / x[first_active + k];
            last = last + p[fourth] * v[i] * f[i].derivative[0].derivative[0].derivative[0];
        }
        for (int k = 0; k < 2; ++k) {
            // the outer derivative is by the parameter, the inner one along v
            using A = Dual<D, 1>;
            detail::AnglesOf<M, A> angle;
            Parameters<M, A> lifted;
            for (int i = 0; i < n; ++i) {
                const auto inner = detail::angle_along<D, S>(S(p[cosine + i]), S(0.0), v[i]);
                angle[i] = {A(inner.c), A(inner.s)};
            }
            for (int m = 0; m < q.size(); ++m) lifted[m] = detail::constant_along<A, S>(q[m]);
            lifted[Plane::active[k]].derivative[0] =
                D(Plane::template slope<S>(k, q[Plane::active[k]], p[scale + k]));
            const Unknowns<M, A> g = detail::equations_at<M, A>(angle, detail::CoordinatesOf<M, A>{}, lifted);
            for (int i = 0; i < n; ++i) last = last + p[extremal + k] * v[i] * g[i].derivative[0].derivative[0];
        }
        y[n] = last;
        return y;
    }

    template <class C>
    static constexpr auto polynomials(const Array<C, n_parameters>& p) {
        using Polynomial = TrigonometricPolynomial<0, n_coordinates, C>;
        const auto coordinate = [](int j) { return Polynomial(Polynomial::Basis::single(j, 1), C(1)); };
        std::vector<Polynomial> v, y;
        for (int i = 0; i < n; ++i) {
            Polynomial entry(p[first_basis + i * n]);
            for (int k = 1; k < n; ++k) entry += Polynomial(p[first_basis + i * n + k]) * coordinate(k - 1);
            v.push_back(entry);
        }
        // the coefficient of t^order of f at the branch + t v
        const auto coefficient = [&](const auto& f, int order) {
            Polynomial sum;
            for (const auto& term : f.terms()) {
                std::vector<Polynomial> series(static_cast<std::size_t>(order + 1));
                Polynomial constant(term.coefficient);
                for (int k = 0; k < 2; ++k)
                    for (int m = 0; m < term.monomial.code(n + Plane::first_active + k); ++m)
                        constant *= coordinate(first_active + k);
                series[0] = constant;
                for (int i = 0; i < n; ++i) {
                    const int code = term.monomial.code(i), multiple = code < 0 ? -code : code;
                    if (code == 0) continue;
                    C sign(1);
                    for (int m = 0; m < multiple; ++m) sign = sign * p[cosine + i];
                    // cos or sin of multiple v_i t, times the sign
                    std::vector<Polynomial> product(series.size());
                    Polynomial power(sign);
                    for (int m = 0; m <= order; ++m) {
                        if (m > 0) power = power * v[static_cast<std::size_t>(i)] * Polynomial(C(multiple) / C(m));
                        if ((m % 2 == 1) != (code < 0)) continue;
                        const bool negative = m / 2 % 2 == 1;
                        for (int l = 0; l + m <= order; ++l) {
                            Polynomial part = series[static_cast<std::size_t>(l)] * power;
                            if (negative) part = -part;
                            product[static_cast<std::size_t>(l + m)] += part;
                        }
                    }
                    series.swap(product);
                }
                sum += series.back();
            }
            return sum;
        };
        const auto f = Plane::template model_equations<C>(p);
        Polynomial last(p[slice + 2]);
        for (int k = 0; k < 2; ++k) last += Polynomial(p[slice + k]) * coordinate(first_active + k);
        for (int i = 0; i < n; ++i) {
            const auto& equation = f[static_cast<std::size_t>(i)];
            const Polynomial row = coefficient(equation, 1);
            Polynomial divided;
            for (const auto& term : row.terms()) {
                auto monomial = term.monomial;
                for (int k = 0; k < 2; ++k)
                    monomial.set_code(first_active + k, monomial.code(first_active + k) - Plane::content[i][k]);
                divided += Polynomial(monomial, term.coefficient);
            }
            y.push_back(divided);
            last += Polynomial(p[fourth] * 6.0) * coefficient(equation, 3) * v[static_cast<std::size_t>(i)];
            for (int k = 0; k < 2; ++k)
                last += Polynomial(p[extremal + k]) *
                        coefficient(derivative(equation, n + Plane::first_active + k), 1) * v[static_cast<std::size_t>(i)];
        }
        y.push_back(last);
        return y;
    }
};

}  // namespace equilibria
