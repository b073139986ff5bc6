/// \file
/// Degenerate equilibria of a model as the solutions of polynomial systems: what `enumerate` does for equilibria is
/// done for folds, cusps and the extremal points of a locus, all of them, every path accounted for.
///
/// Unknowns: the model's q, then w (n - 1 numbers), then the active parameters x. Equations:
///     F(q, p) = 0,    J(q, p) v = 0,    v = B (1, w),                        and with two active parameters
///     slice + sum_k extremal_k v . dF/dx_k + cusp V'''[v, v, v] = 0,         slice = s_0 + s_1 x_1 + s_2 x_2,
/// with a random basis B, so that no null vector is at infinity in w. The weights in the last equation choose what is
/// solved for: the folds of a line of the plane (slice); the points at which the locus has a tangent normal to x_1
/// (extremal_2 = 1: there v . dF/dx_2 = 0), folds of the fold curve over the axis of x_1; or its cusps. A parameter
/// that enters by even powers alone is replaced by its square, which halves degrees and solutions, and equations are
/// divided by powers of active parameters that all their terms have: solutions at 0 of such a parameter, where that
/// equation would vanish identically, are left out.
///
/// The systems are data, made at run time by symbolic differentiation of the model's own equations, over doubles to be
/// solved and over exact numbers to be proved. Pitchforks on symmetric branches are singular solutions; they are found
/// on those branches (symmetric_branches.hpp, symmetric_system.hpp). Source: Govaerts, Numerical Methods for
/// Bifurcations of Dynamical Equilibria, SIAM, 2000, chapter 4.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/symbolic.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// Active: the numbers of one or two parameters of M that become unknowns.
template <Model M, int... Active>
struct CriticalSystem {
    static constexpr int n = n_unknowns<M>, actives = sizeof...(Active);
    static_assert(actives == 1 || actives == 2, "equilibria: a critical system has one or two active parameters");
    static_assert(((Active >= 0 && Active < equilibria::n_parameters<M>) && ...), "equilibria: no such parameter");
    static constexpr Array<int, actives> active{Active...};
    static constexpr int n_angles = equilibria::n_angles<M>;
    static constexpr int first_null = equilibria::n_coordinates<M>;  ///< the coordinate w_1
    static constexpr int first_active = first_null + n - 1;          ///< the coordinate x_1
    /// With two active parameters symmetric branches hold curves of solutions, the pitchforks. They are sent to
    /// infinity by one more unknown and equation, y sum_i r_i sin theta_i = 1.
    static constexpr bool off_symmetric_branches = actives == 2 && Formulation<M>::reflection_symmetric;
    static constexpr int reciprocal = first_active + actives;  ///< the coordinate y
    static constexpr int n_coordinates = reciprocal + off_symmetric_branches;
    /// Left null vectors would be needed without one.
    static constexpr bool has_last_derivatives = actives == 2 && PotentialModel<M>;

    template <class C>
    using Polynomial = TrigonometricPolynomial<n_angles, n_coordinates, C>;
    template <class C>
    using Polynomials = std::vector<Polynomial<C>>;

    /// What the equations depend on.
    struct Numbers {
        Parameters<M> p;                   ///< of the model; the active ones are not read
        Array<double, actives> scale;      ///< of the active ones: x_k is of the size of 1
        Array<Array<double, n>, n> basis;  ///< B, row by row
        // with two active parameters, of the last equation:
        Array<double, 3> slice{};  ///< s_1, s_2, s_0
        Array<double, 2> extremal{};
        double cusp = 0;
        Array<double, n_angles> sine{};  ///< r
    };

    /// {q}, {w}, {x_1}, {x_2}
    static constexpr Array<int, n_angles + n_coordinates> grouping = [] {
        Array<int, n_angles + n_coordinates> y{};
        for (int k = 0; k < n - 1; ++k) y[n_angles + first_null + k] = 1;
        for (int k = first_active; k < n_coordinates; ++k) y[n_angles + k] = (n > 1 ? 2 : 1) + k - first_active;
        return y;
    }();

    /// How the active parameters enter the model's equations.
    struct Entry {
        /// x_k is the power[k]-th power (1 or 2) of the parameter active[k] over its scale.
        Array<int, actives> power{};
        /// The highest power of the parameter active[k] in F.
        Array<int, actives> degree{};
        /// Equations i of F and of J v are divided by prod_k x_k^content[i][k].
        Array<Array<int, actives>, n> content;
    };
    static const Entry& entry() {
        static const Entry entry = find_entry();
        return entry;
    }

    /// The numbers for those of M: random B and r, weights 0. scales: of the active parameters, positive.
    static Numbers numbers(const Parameters<M>& p, const Array<double, actives>& scales, Generator& generator) {
        Numbers y{.p = p, .scale = scales, .basis = {}};
        for (auto& row : y.basis)
            for (double& number : row) number = uniform(generator, -1, 1);
        if constexpr (off_symmetric_branches)
            for (double& r : y.sine) r = uniform(generator, -1, 1);
        return y;
    }

    /// The active parameter number k from its unknown, and back.
    static double parameter(int k, double x, double scale) {
        return scale * (entry().power[k] == 2 ? std::sqrt(x) : x);
    }
    static double unknown(int k, double parameter, double scale) {
        const double x = parameter / scale;
        return entry().power[k] == 2 ? x * x : x;
    }

    /// F in the unknowns of the system, not divided.
    template <class C>
    static Polynomials<C> model_equations(const Numbers& numbers) {
        auto f = raw_equations<C>(numbers.p, numbers.scale);
        for (auto& equation : f)
            equation = with_exponents(equation, [](int k, int code) { return code / entry().power[k]; });
        return f;
    }

    /// The equations over the numbers C.
    template <class C>
    static Polynomials<C> equations(const Numbers& numbers) {
        const Polynomials<C> f = model_equations<C>(numbers);
        const Polynomials<C> v = combination<Polynomial<C>, C>(numbers.basis, first_null);
        Polynomials<C> jv, y;
        for (const auto& equation : f) jv.push_back(along(equation, v));
        for (int i = 0; i < n; ++i) y.push_back(divided(f[at(i)], i));
        for (int i = 0; i < n; ++i) y.push_back(divided(jv[at(i)], i));
        if constexpr (actives == 2) y.push_back(last_equation(numbers, f, jv, v));
        if constexpr (off_symmetric_branches) {
            Polynomial<C> sum;
            for (int i = 0; i < n_angles; ++i)
                sum += Polynomial<C>(Polynomial<C>::Basis::single(i, -1), C(numbers.sine[i]));
            y.push_back(sum * coordinate<C>(reciprocal) - Polynomial<C>(1));
        }
        return y;
    }

    /// The system to be solved.
    static SparseSystem system(const Numbers& numbers) { return SparseSystem(equations<double>(numbers)); }

    /// v = B (1, w), w being the coordinates from number `first` on.
    template <class P, class C>
    static std::vector<P> combination(const Array<Array<double, n>, n>& basis, int first) {
        std::vector<P> v;
        for (int i = 0; i < n; ++i) {
            P sum = P(C(basis[i][0]));
            for (int k = 1; k < n; ++k) sum += P(P::Basis::single(P::Basis::angles + first + k - 1, 1), C(basis[i][k]));
            v.push_back(sum);
        }
        return v;
    }

private:
    static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

    template <class C>
    static Polynomial<C> coordinate(int j) {
        return {Polynomial<C>::Basis::single(n_angles + j, 1), C(1)};
    }
    /// F with the active parameters, over their scales, for unknowns, as the model has it.
    template <class C>
    static Polynomials<C> raw_equations(const Parameters<M>& p, const Array<double, actives>& scale) {
        using Scalar = SymbolicScalar<n_angles, n_coordinates, C>;
        using Angle = SymbolicAngle<n_angles, n_coordinates, C>;
        typename Scalar::Pool pool;
        Array<Angle, n_angles> theta;
        Array<Scalar, equilibria::n_coordinates<M>> x;
        Array<Scalar, equilibria::n_parameters<M>> q;
        for (int i = 0; i < n_angles; ++i) theta[i] = Angle(&pool, i);
        for (int j = 0; j < x.size(); ++j) x[j] = Scalar(&pool, coordinate<C>(j));
        for (int k = 0; k < q.size(); ++k) q[k] = Scalar(C(p[k]));
        for (int k = 0; k < actives; ++k)
            q[active[k]] = Scalar(&pool, coordinate<C>(first_active + k) * Polynomial<C>(C(scale[k])));
        Polynomials<C> f;
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
    static Entry find_entry() {
        Array<double, actives> one;
        for (double& scale : one) scale = 1;
        auto f = raw_equations<double>(detail::generic_parameters<M>(), one);
        for (auto& equation : f) equation = equation.pruned();
        const auto for_each_exponent = [&](const auto& take) {
            for (int i = 0; i < n; ++i)
                for (const auto& term : f[at(i)].terms())
                    for (int k = 0; k < actives; ++k) take(i, k, term.monomial.code(n_angles + first_active + k));
        };
        Entry y;
        for_each_exponent([&](int, int k, int code) { y.power[k] = std::gcd(y.power[k], code); });
        for (int& g : y.power) g = g > 0 && g % 2 == 0 ? 2 : 1;
        for (auto& row : y.content)
            for (int& c : row) c = Polynomial<double>::Basis::highest;
        for_each_exponent([&](int i, int k, int code) {
            y.degree[k] = std::max(y.degree[k], code);
            y.content[i][k] = std::min(y.content[i][k], code / y.power[k]);
        });
        return y;
    }
    template <class C>
    static Polynomial<C> with_exponents(const Polynomial<C>& f, const auto& change) {
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
    template <class C>
    static Polynomial<C> divided(const Polynomial<C>& equation, int i) {
        return with_exponents(equation, [i](int k, int code) { return code - entry().content[i][k]; });
    }
    /// The derivative by q along v.
    template <class C>
    static Polynomial<C> along(const Polynomial<C>& f, const Polynomials<C>& v) {
        Polynomial<C> y;
        for (int k = 0; k < n; ++k) y += derivative(f, k) * v[at(k)];
        return y;
    }
    template <class C>
    static Polynomial<C> last_equation(const Numbers& numbers, const Polynomials<C>& f, const Polynomials<C>& jv,
                                       const Polynomials<C>& v) {
        Polynomial<C> y(C(numbers.slice[2]));
        for (int k = 0; k < 2; ++k)
            if (numbers.slice[k] != 0) y += Polynomial<C>(C(numbers.slice[k])) * coordinate<C>(first_active + k);
        if constexpr (has_last_derivatives) {
            if (numbers.cusp != 0)
                for (int i = 0; i < n; ++i) y += Polynomial<C>(C(numbers.cusp)) * (along(jv[at(i)], v) * v[at(i)]);
            for (int k = 0; k < 2; ++k)
                if (numbers.extremal[k] != 0)
                    for (int i = 0; i < n; ++i)
                        y += Polynomial<C>(C(numbers.extremal[k])) *
                             (derivative(f[at(i)], n_angles + first_active + k) * v[at(i)]);
        }
        return y;
    }
};

}  // namespace equilibria
