/// \file
/// The equilibrium equations of a model as trigonometric polynomials: their support in a constant expression, found at
/// generic values of the parameters, and their coefficients for given ones.
///
/// Why generic values and not symbols: a coefficient that is not identically zero in the parameters vanishes at a
/// generic point with probability zero, and one that is vanishes to rounding, so support and degrees are exact with no
/// algebra in the parameters at all; they may enter by any function.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/algebra/symbolic.hpp>
#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/splitmix.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// The polynomials in the unknowns of the model M with coefficients of type C.
template <class M, class C = double>
using PolynomialOf = TrigonometricPolynomial<n_angles<M>, n_coordinates<M>, C>;

namespace detail {

/// The equations as polynomials, their coefficients for the parameters p.
template <class M, class C>
constexpr std::vector<PolynomialOf<M, C>> symbolic_equations(const Parameters<M, C>& p) {
    using Polynomial = PolynomialOf<M, C>;
    using Scalar = SymbolicScalar<n_angles<M>, n_coordinates<M>, C>;
    using Angle = SymbolicAngle<n_angles<M>, n_coordinates<M>, C>;
    typename Scalar::Pool pool;
    Array<Angle, n_angles<M>> theta;
    Array<Scalar, n_coordinates<M>> x;
    Parameters<M, Scalar> q;
    for (int i = 0; i < theta.size(); ++i) theta[i] = Angle(&pool, i);
    for (int j = 0; j < x.size(); ++j)
        x[j] = Scalar(&pool, Polynomial(Polynomial::Basis::single(n_angles<M> + j, 1), C(1)));
    for (int k = 0; k < q.size(); ++k) q[k] = Scalar(p[k]);
    std::vector<Polynomial> f;
    f.reserve(n_unknowns<M>);
    if constexpr (PotentialModel<M>) {
        const Polynomial v = Scalar(call_potential(M{}, theta, x, q)).polynomial();
        for (int i = 0; i < n_unknowns<M>; ++i) f.push_back(derivative(v, i));
    } else {
        const auto values = call_equations(M{}, theta, x, q);
        for (const auto& value : values) f.push_back(Scalar(value).polynomial());
    }
    return f;
}

/// Generic parameters: in [0.25, 1), 53 random bits each (splitmix64), so that no relation with small integers holds,
/// as p_0 - 2 p_1 + p_2 = 0 does for any arithmetic sequence.
constexpr void set_generic(std::span<double> parameters) {
    std::uint64_t state = 0;
    for (double& value : parameters) value = 0.25 + 0.75 * unit_interval(splitmix64(state));
}
template <class M>
constexpr Parameters<M> generic_parameters() {
    Parameters<M> p;
    set_generic({p.begin(), p.end()});
    return p;
}

template <class M>
constexpr std::vector<PolynomialOf<M>> generic_equations() {
    auto f = symbolic_equations<M, double>(generic_parameters<M>());
    for (auto& g : f) g = g.pruned();
    return f;
}

template <class M>
constexpr NotPolynomial fault_of_equations() {
    NotPolynomial fault = NotPolynomial::no;
    const auto equations = generic_equations<M>();
    for (const auto& g : equations) fault = std::max(fault, g.fault());
    return fault;
}

template <class M>
concept ConstantExpression = requires { typename std::integral_constant<NotPolynomial, fault_of_equations<M>()>; };
template <ConstantExpression M>
inline constexpr NotPolynomial fault = fault_of_equations<M>();

/// The sentences for a model that cannot be turned into polynomials; true where it can.
template <class M>
constexpr bool is_trigonometric() {
    check_model<M>();
    if constexpr (Model<M>) {
        static_assert(ConstantExpression<M>,
                      "equilibria: the model's potential or equations must be declared constexpr, and call only "
                      "functions that are: its algebra is computed at compile time (if it is large: within the "
                      "compiler's limit, -fconstexpr-ops-limit of g++, -fconstexpr-steps of clang)");
        if constexpr (ConstantExpression<M>) {
            static_assert(fault<M> != NotPolynomial::function_of_angle,
                          "equilibria: the model is not a trigonometric polynomial: it takes sqrt, exp, log, sin or "
                          "cos of something that depends on the angles or coordinates");
            static_assert(fault<M> != NotPolynomial::divisor_not_constant,
                          "equilibria: the model is not a trigonometric polynomial: it divides by something that "
                          "depends on the angles or coordinates");
            static_assert(fault<M> != NotPolynomial::degree_too_high,
                          "equilibria: the model has a multiple of an angle, or a power of a coordinate, above 1000");
            return fault<M> == NotPolynomial::no;
        }
    }
    return false;
}
template <class M>
inline constexpr bool usable = is_trigonometric<M>();

}  // namespace detail

/// One term of one equation. Terms are sorted by equation, then by the code of the equation's own unknown.
template <class M>
struct SupportTerm {
    int equation;                                      ///< from 0
    Monomial<n_angles<M>, n_coordinates<M>> monomial;  ///< product of factors, one an unknown

    /// The factor in unknown number `equation`: terms of an equation that share it are summed before it is multiplied.
    constexpr int own_code() const { return monomial.code(equation); }

    /// The order of the support.
    /// \{
    friend constexpr bool operator==(const SupportTerm&, const SupportTerm&) = default;
    friend constexpr bool operator<(const SupportTerm& a, const SupportTerm& b) {
        if (a.equation != b.equation) return a.equation < b.equation;
        if (a.own_code() != b.own_code()) return a.own_code() < b.own_code();
        return a.monomial < b.monomial;
    }
    /// \}
};

namespace detail {

/// Without terms where the model was refused: one sentence says why, and no other error should follow.
template <class M>
constexpr std::vector<SupportTerm<M>> support_terms() {
    std::vector<SupportTerm<M>> terms;
    if constexpr (usable<M>) {
        int equation = 0;
        const auto equations = generic_equations<M>();
        for (const auto& f : equations) {
            for (const auto& t : f.terms()) terms.push_back({equation, t.monomial});
            ++equation;
        }
        std::sort(terms.begin(), terms.end());
    }
    return terms;
}
template <class M>
inline constexpr int support_size = static_cast<int>(support_terms<M>().size());

}  // namespace detail

/// The support of a model's equations and what follows from it, all at compile time.
template <class M>
struct Formulation {
    static constexpr int unknowns = n_unknowns<M>;         ///< number of unknowns and of equations
    static constexpr int angles = n_angles<M>;             ///< how many of them are angles
    static constexpr int terms = detail::support_size<M>;  ///< number of terms of all equations together

    /// All terms, in their order.
    static constexpr Array<SupportTerm<M>, detail::support_size<M>> support = [] {
        Array<SupportTerm<M>, detail::support_size<M>> y;
        const auto found = detail::support_terms<M>();
        for (int k = 0; k < y.size(); ++k) y[k] = found[static_cast<std::size_t>(k)];
        return y;
    }();

    /// First and past-the-end term of equation i.
    static constexpr Array<int, unknowns + 1> first = [] {
        Array<int, unknowns + 1> y{};
        for (const auto& t : support) ++y[t.equation + 1];
        for (int i = 1; i < y.size(); ++i) y[i] += y[i - 1];
        return y;
    }();

    /// Total degree of each equation in the (cos, sin) of the angles and the coordinates.
    static constexpr Array<int, unknowns> degrees = [] {
        Array<int, unknowns> y{};
        for (const auto& t : support) y[t.equation] = std::max(y[t.equation], t.monomial.degree());
        return y;
    }();

    /// The highest degree in which unknown u appears.
    static constexpr int degree_in(int u) {
        int d = 0;
        for (const auto& t : support) d = std::max(d, t.monomial.degree(u));
        return d;
    }

    static constexpr bool has_potential = PotentialModel<M>;  ///< whether the equations are the gradient of a potential

    /// Whether F(-theta) = -F(theta): every term has an odd number of sines. Then theta -> -theta maps equilibria to
    /// equilibria. (Angles only: with plain coordinates the library does not use the reflection.)
    static constexpr bool reflection_symmetric = [] {
        if (n_coordinates<M> != 0) return false;
        for (const auto& t : support) {
            int sines = 0;
            for (int u = 0; u < unknowns; ++u) sines += t.monomial.code(u) < 0;
            if (sines % 2 == 0) return false;
        }
        return true;
    }();

    static_assert(
        [] {
            for (int d : degrees)
                if (d == 0 && detail::usable<M>) return false;
            return true;
        }(),
        "equilibria: one of the model's equations does not depend on its unknowns (with a potential: the potential "
        "does not depend on one of them)");
};

namespace detail {

/// The equations for the parameters p at run time: polynomials of one type, or of the model's own where it has more
/// unknowns than those may have.
template <class M, class C>
auto equations_at_run_time(const Parameters<M, C>& p) {
    if constexpr (n_angles<M> <= most_angles && n_coordinates<M> <= most_coordinates)
        return symbolic_equations_of<M, C>([&](const RuntimePool<C>&) {
            Parameters<M, RuntimeScalar<C>> q;
            for (int k = 0; k < q.size(); ++k) q[k] = p[k];
            return q;
        });
    else
        return symbolic_equations<M, C>(p);
}
/// Their monomials in the model's unknowns.
template <class M, int Angles, int Coordinates>
Monomial<n_angles<M>, n_coordinates<M>> own_monomial(const Monomial<Angles, Coordinates>& of) {
    Monomial<n_angles<M>, n_coordinates<M>> y;
    for (int u = 0; u < n_unknowns<M>; ++u) y.set_code(u, of.code(u < n_angles<M> ? u : Angles + u - n_angles<M>));
    return y;
}

}  // namespace detail

/// The coefficients of the support's terms for given parameters. C: double, std::complex<double>, or wider.
/// Throws InvalidArgument if a coefficient is not finite at p, or if the model has a term at p that it lacks at generic
/// parameters (it branches on values).
template <class M, class C = double>
Array<C, detail::support_size<M>> coefficients(const Parameters<M, C>& p) {
    using F = Formulation<M>;
    Array<C, detail::support_size<M>> y;
    for (C& c : y) c = C(0);
    const auto f = detail::equations_at_run_time<M, C>(p);
    int i = 0;
    for (const auto& equation : f) {
        const double negligible = 1e-12 * equation.scale();
        for (const auto& t : equation.terms()) {
            const SupportTerm<M> key{i, detail::own_monomial<M>(t.monomial)};
            const auto at = std::lower_bound(F::support.begin(), F::support.end(), key);
            using std::abs;
            require(static_cast<double>(abs(t.coefficient)) < std::numeric_limits<double>::infinity(), "model",
                    "equation " + std::to_string(i + 1), "has a coefficient that is not finite at these parameters");
            if (at != F::support.end() && *at == key)
                y[at - F::support.begin()] = t.coefficient;
            else
                require(abs(t.coefficient) <= negligible, "model", "equation " + std::to_string(i + 1),
                        "must have the same terms for all parameters: do not branch on their values");
        }
        ++i;
    }
    return y;
}

}  // namespace equilibria
