/// \file
/// The model as a Laurent system: with z = exp(i theta), cos(k theta) = (z^k + z^-k) / 2 and sin(k theta) =
/// (z^k - z^-k) / 2i, n equations in z_1 .. z_n and the coordinates, half the unknowns of the system in (cos, sin) and
/// no circle equations. Its solutions with every z_i nonzero are the equilibria, so that its mixed volume bounds their
/// number.
///
/// The support is found at generic parameters in a constant expression, as the support in (cos, sin) is, and with the
/// coefficients: cos(theta_1 - theta_2) = c1 c2 + s1 s2 has four monomials as a sum of products, and two when they are
/// added up. A support without that would give far too large a mixed volume.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// prod_u z_u^exponents[u] in one equation, x_j for z_u where u is a coordinate. Terms are sorted by equation, then by
/// exponents.
template <class M>
struct LaurentTerm {
    int equation;                         ///< from 0
    Array<int, n_unknowns<M>> exponents;  ///< of each unknown, of either sign

    /// The order of the support.
    /// \{
    friend constexpr bool operator==(const LaurentTerm&, const LaurentTerm&) = default;
    friend constexpr bool operator<(const LaurentTerm& a, const LaurentTerm& b) {
        if (a.equation != b.equation) return a.equation < b.equation;
        return std::lexicographical_compare(a.exponents.begin(), a.exponents.end(), b.exponents.begin(),
                                            b.exponents.end());
    }
    /// \}
};

namespace detail {

template <class C>
struct ComplexOf {
    using type = std::conditional_t<std::is_floating_point_v<C>, std::complex<C>, Complex<C>>;
};
template <class R>
struct ComplexOf<std::complex<R>> {
    using type = std::complex<R>;
};

/// Calls visit(exponents, quarter turns, factor) for each Laurent monomial of a product of cosines, sines and powers:
/// its coefficient there is factor * i^(quarter turns).
template <class M, class Visit>
constexpr void expand_laurent(const Monomial<n_angles<M>, n_coordinates<M>>& monomial, Visit visit) {
    constexpr int n = n_unknowns<M>;
    Array<int, n> involved{};
    int count = 0, turns = 0;
    double factor = 1;
    LaurentTerm<M> t{0, {}};
    for (int u = 0; u < n; ++u) {
        const int code = monomial.code(u);
        t.exponents[u] = code < 0 ? -code : code;
        if (u >= n_angles<M> || code == 0) continue;
        involved[count++] = u;
        factor *= 0.5;
        turns += code < 0 ? 3 : 0;  // 1/i = i^3
    }
    for (int signs = 0; signs < 1 << count; ++signs) {
        LaurentTerm<M> term = t;
        double signed_factor = factor;
        for (int k = 0; k < count; ++k) {
            if (!(signs >> k & 1)) continue;
            term.exponents[involved[k]] *= -1;
            if (monomial.code(involved[k]) < 0) signed_factor = -signed_factor;
        }
        visit(term.exponents, turns % 4, signed_factor);
    }
}

template <class M>
constexpr std::vector<LaurentTerm<M>> laurent_terms() {
    struct Summand {
        LaurentTerm<M> term;
        double re, im;
    };
    std::vector<LaurentTerm<M>> kept;
    if constexpr (!usable<M>) return kept;  // one sentence says why, and no other error should follow
    int equation = 0;
    const auto equations = generic_equations<M>();
    for (const auto& f : equations) {
        std::vector<Summand> sums;
        for (const auto& t : f.terms())
            expand_laurent<M>(t.monomial, [&](const auto& exponents, int turns, double factor) {
                const double value = (turns < 2 ? factor : -factor) * t.coefficient;
                sums.push_back({{equation, exponents}, turns % 2 ? 0 : value, turns % 2 ? value : 0});
            });
        std::sort(sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.term < b.term; });
        const double smallest = 1e-13 * f.scale();
        for (std::size_t i = 0; i < sums.size();) {
            double re = 0, im = 0;
            const std::size_t first = i;
            for (; i < sums.size() && sums[i].term == sums[first].term; ++i) re += sums[i].re, im += sums[i].im;
            if (re * re + im * im > smallest * smallest) kept.push_back(sums[first].term);
        }
        ++equation;
    }
    return kept;
}
template <class M>
inline constexpr int laurent_size = static_cast<int>(laurent_terms<M>().size());

}  // namespace detail

/// The support of a model's Laurent system, at compile time. Exponents are symmetric, z^k beside z^-k.
template <Model M>
struct LaurentFormulation {
    static constexpr int unknowns = n_unknowns<M>;         ///< number of unknowns and of equations
    static constexpr int terms = detail::laurent_size<M>;  ///< number of terms of all equations together

    /// All terms, in their order.
    static constexpr Array<LaurentTerm<M>, terms> support = [] {
        Array<LaurentTerm<M>, terms> y;
        const auto found = detail::laurent_terms<M>();
        for (int k = 0; k < terms; ++k) y[k] = found[static_cast<std::size_t>(k)];
        return y;
    }();

    /// First and past-the-end term of equation i.
    static constexpr Array<int, unknowns + 1> first = [] {
        Array<int, unknowns + 1> y{};
        for (const auto& t : support) ++y[t.equation + 1];
        for (int i = 1; i < y.size(); ++i) y[i] += y[i - 1];
        return y;
    }();

    /// lowest[i][u]: the least exponent of unknown u in equation i. Divided by the monomial with these exponents, the
    /// equation is a polynomial.
    static constexpr Array<Array<int, unknowns>, unknowns> lowest = [] {
        Array<Array<int, unknowns>, unknowns> y;
        for (auto& row : y)
            for (int& e : row) e = std::numeric_limits<int>::max();
        for (const auto& t : support)
            for (int u = 0; u < unknowns; ++u) y[t.equation][u] = std::min(y[t.equation][u], t.exponents[u]);
        return y;
    }();
};

/// The coefficients of the support's terms for given parameters: std::complex for double, long double and std::complex,
/// Complex<C> for any other real type C. Errors: as `coefficients`.
template <Model M, class C = double>
auto laurent_coefficients(const Parameters<M, C>& p) {
    using F = Formulation<M>;
    using L = LaurentFormulation<M>;
    using Z = typename detail::ComplexOf<C>::type;
    Array<Z, L::terms> y;
    for (Z& z : y) z = Z(0.0);
    const auto coefficient = coefficients<M, C>(p);
    for (int k = 0; k < F::terms; ++k)
        detail::expand_laurent<M>(F::support[k].monomial, [&](const auto& exponents, int turns, double factor) {
            const LaurentTerm<M> key{F::support[k].equation, exponents};
            const auto at = std::lower_bound(L::support.begin(), L::support.end(), key);
            if (at == L::support.end() || !(*at == key)) return;  // it cancels for all parameters
            Z& z = y[at - L::support.begin()];
            const Z value = Z(C((turns < 2 ? factor : -factor) * coefficient[k]));
            z = z + (turns % 2 ? Z(0.0, 1.0) * value : value);
        });
    return y;
}

/// Whether exponents may be negative.
enum class LaurentForm {
    symmetric,    ///< as it comes from exp(i theta)
    non_negative  ///< each equation multiplied by the least monomial that makes it a polynomial
};

/// The Laurent system of a model for the parameters p, in the variables z1 .. zn, then x1, ..
template <Model M, class C = double>
auto laurent_system(const Parameters<M, C>& p, LaurentForm form = LaurentForm::symmetric) {
    using L = LaurentFormulation<M>;
    using Z = typename detail::ComplexOf<C>::type;
    PolynomialSystem<Z> system;
    for (int i = 1; i <= n_angles<M>; ++i) system.variables.push_back("z" + std::to_string(i));
    for (int j = 1; j <= n_coordinates<M>; ++j) system.variables.push_back("x" + std::to_string(j));
    const auto coefficient = laurent_coefficients<M, C>(p);
    for (int i = 0; i < L::unknowns; ++i) {
        std::vector<PolynomialTerm<Z>> equation;
        for (int k = L::first[i]; k < L::first[i + 1]; ++k) {
            PolynomialTerm<Z> t{coefficient[k], {}};
            for (int u = 0; u < L::unknowns; ++u)
                t.exponents.push_back(L::support[k].exponents[u] -
                                      (form == LaurentForm::non_negative ? L::lowest[i][u] : 0));
            equation.push_back(t);
        }
        system.equations.push_back(equation);
    }
    return system;
}

}  // namespace equilibria
