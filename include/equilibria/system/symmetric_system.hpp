/// \file
/// Special pitchforks of the symmetric branches in a plane of two parameters, as solutions of a polynomial system:
/// where a curve of pitchforks has an extremal parameter, and where its pitchforks turn from super- to subcritical
/// (degenerate pitchforks, in which fold curves end).
///
/// On a branch theta in {0, pi}^n the equations are fulfilled. Unknowns: w (n - 1 numbers), then the active parameters
/// x, as in critical_system.hpp. Equations:
///     J v = 0,    v = B (1, w),    slice + sum_k extremal_k v . dJ/dx_k v + fourth V''''[v, v, v, v] = 0,
/// slice = s_0 + s_1 x_1 + s_2 x_2. The third derivatives of V vanish there, so that V'''' is the reduced fourth
/// derivative. At extremal_2 = 1 x_1 is extremal on the curve; the slice alone gives the pitchforks of a line.
#pragma once

#include <cmath>
#include <vector>

#include <equilibria/core/array.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

template <PotentialModel M, int X, int Y>
struct SymmetricSystem {
    using Plane = CriticalSystem<M, X, Y>;
    static constexpr int n = n_unknowns<M>;
    static constexpr int n_angles = 0;
    static constexpr int first_active = n - 1;
    static constexpr int n_coordinates = n + 1;

    template <class C>
    using Polynomial = TrigonometricPolynomial<0, n_coordinates, C>;
    template <class C>
    using Polynomials = std::vector<Polynomial<C>>;

    /// What the equations depend on.
    struct Numbers {
        typename Plane::Numbers plane;  ///< parameters, scales and basis
        Array<double, n> cosine;        ///< of the branch: 1 or -1
        Array<double, 3> slice{};       ///< s_1, s_2, s_0
        Array<double, 2> extremal{};
        double fourth = 0;
    };

    /// {w}, {x_1}, {x_2}
    static constexpr Array<int, n_coordinates> grouping = [] {
        Array<int, n_coordinates> y{};
        for (int k = 0; k < 2; ++k) y[first_active + k] = (n > 1 ? 1 : 0) + k;
        return y;
    }();

    static Numbers numbers(const Parameters<M>& p, const Array<double, 2>& scales, const Unknowns<M>& branch,
                           Generator& generator) {
        Numbers y{.plane = {.p = p, .scale = scales, .basis = {}}, .cosine = {}};
        for (auto& row : y.plane.basis)
            for (double& number : row) number = uniform(generator, -1, 1);
        for (int i = 0; i < n; ++i) y.cosine[i] = std::cos(branch[i]) < 0 ? -1 : 1;
        return y;
    }

    /// The equations over the numbers C.
    template <class C>
    static Polynomials<C> equations(const Numbers& numbers) {
        const Polynomials<C> v = Plane::template combination<Polynomial<C>, C>(numbers.plane.basis, 0);
        const auto f = Plane::template model_equations<C>(numbers.plane);
        Polynomials<C> y;
        Polynomial<C> last(C(numbers.slice[2]));
        for (int k = 0; k < 2; ++k)
            if (numbers.slice[k] != 0) last += Polynomial<C>(C(numbers.slice[k])) * coordinate<C>(first_active + k);
        for (int i = 0; i < n; ++i) {
            const auto& equation = f[at(i)];
            const auto times_v = [&](const auto& g, int order) {
                return order_along<C>(g, order, numbers.cosine, v) * v[at(i)];
            };
            y.push_back(divided(order_along<C>(equation, 1, numbers.cosine, v), i));
            if (numbers.fourth != 0) last += Polynomial<C>(C(6 * numbers.fourth)) * times_v(equation, 3);
            for (int k = 0; k < 2; ++k)
                if (numbers.extremal[k] != 0)
                    last += Polynomial<C>(C(numbers.extremal[k])) *
                            times_v(derivative(equation, n + Plane::first_active + k), 1);
        }
        y.push_back(last);
        return y;
    }

    /// The system to be solved.
    static SparseSystem system(const Numbers& numbers) { return SparseSystem(equations<double>(numbers)); }

private:
    static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

    template <class C>
    static Polynomial<C> coordinate(int j) {
        return {Polynomial<C>::Basis::single(j, 1), C(1)};
    }

    /// The coefficient of t^order of f at the branch + t v.
    template <class C>
    static Polynomial<C> order_along(const typename Plane::template Polynomial<C>& f, int order,
                                     const Array<double, n>& cosine, const Polynomials<C>& v) {
        Polynomial<C> sum;
        for (const auto& term : f.terms()) {
            Polynomials<C> series(at(order + 1));
            series[0] = Polynomial<C>(term.coefficient);
            for (int k = 0; k < 2; ++k)
                for (int m = 0; m < term.monomial.code(n + Plane::first_active + k); ++m)
                    series[0] *= coordinate<C>(first_active + k);
            for (int i = 0; i < n; ++i)
                if (const int code = term.monomial.code(i); code != 0)
                    series = times_factor<C>(series, code, cosine[i], v[at(i)]);
            sum += series.back();
        }
        return sum;
    }
    /// The series in t times cos k(theta + v t), or sin, k = |code|, theta being 0 or pi with the given cosine.
    template <class C>
    static Polynomials<C> times_factor(const Polynomials<C>& series, int code, double cosine, const Polynomial<C>& v) {
        const int k = code < 0 ? -code : code, order = static_cast<int>(series.size()) - 1;
        Polynomials<C> product(series.size());
        Polynomial<C> power(C(cosine < 0 && k % 2 == 1 ? -1.0 : 1.0));
        for (int m = 0; m <= order; ++m) {
            if (m > 0) power = power * v * Polynomial<C>(C(k) / C(m));
            if ((m % 2 == 1) != (code < 0)) continue;
            for (int l = 0; l + m <= order; ++l) {
                const Polynomial<C> part = series[at(l)] * power;
                product[at(l + m)] += m / 2 % 2 == 1 ? -part : part;
            }
        }
        return product;
    }
    template <class C>
    static Polynomial<C> divided(const Polynomial<C>& row, int i) {
        Polynomial<C> y;
        for (const auto& term : row.terms()) {
            auto monomial = term.monomial;
            for (int k = 0; k < 2; ++k)
                monomial.set_code(first_active + k, monomial.code(first_active + k) - Plane::entry().content[i][k]);
            y += Polynomial<C>(monomial, term.coefficient);
        }
        return y;
    }
};

}  // namespace equilibria
