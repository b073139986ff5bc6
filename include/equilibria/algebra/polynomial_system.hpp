/// \file
/// A model at given parameters as a system of polynomials at run time: for other programs, and for whoever wants to see
/// it. The variables are c1, s1, .., cn, sn (cosines and sines of the angles), then the coordinates x1, ..; the
/// equations are the model's, then c_i^2 + s_i^2 - 1 = 0.
///
/// cos(k theta) is T_k(c) and sin(k theta) is s U_(k-1)(c), Chebyshev polynomials: of degree k, and no expansion of
/// lower degree exists on the circle. Their coefficients grow as 2^k: above k = 40 or so doubles lose digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// coefficient * prod_v variable_v^exponents[v]; one exponent a variable, negative ones in Laurent systems alone.
template <class C>
struct PolynomialTerm {
    C coefficient;               ///< a real or complex number
    std::vector<int> exponents;  ///< one a variable, in the system's order
};

/// Equations are sums of terms that vanish.
template <class C>
struct PolynomialSystem {
    std::vector<std::string> variables;                     ///< names, in the order of the exponents
    std::vector<std::vector<PolynomialTerm<C>>> equations;  ///< one sum of terms each
};

/// The total degree; of a Laurent polynomial the largest sum of exponents. -1 of no terms.
template <class C>
int degree(const std::vector<PolynomialTerm<C>>& equation) {
    int highest = equation.empty() ? -1 : std::numeric_limits<int>::min();
    for (const auto& t : equation) {
        int d = 0;
        for (int e : t.exponents) d += e;
        highest = std::max(highest, d);
    }
    return highest;
}

/// The value of each equation. Throws InvalidArgument unless the point has one value a variable.
template <class C, class S>
auto evaluate(const PolynomialSystem<C>& system, const std::vector<S>& point) {
    using Value = std::decay_t<decltype(std::declval<C>() * std::declval<S>())>;
    require(point.size() == system.variables.size(), "point", point.size(), "must have one value for each variable");
    std::vector<Value> values;
    for (const auto& equation : system.equations) {
        Value sum(0.0);
        for (const auto& t : equation) {
            Value product(t.coefficient);
            for (std::size_t v = 0; v < point.size(); ++v) {
                for (int k = 0; k < t.exponents[v]; ++k) product = product * point[v];
                for (int k = 0; k > t.exponents[v]; --k) product = product / point[v];
            }
            sum = sum + product;
        }
        values.push_back(sum);
    }
    return values;
}

namespace detail {

/// A polynomial while it is put together: the coefficient of each exponent vector, and the sum of the absolute values
/// that went into it, which tells a coefficient from the rounding error of cancelled ones.
template <class C>
class PolynomialSum {
public:
    void add(const std::vector<int>& exponents, const C& coefficient) {
        using std::abs;
        const auto [at, is_new] = terms_.try_emplace(exponents, coefficient, 0.0);
        if (!is_new) at->second.first = at->second.first + coefficient;
        at->second.second += static_cast<double>(abs(coefficient));
    }
    std::vector<PolynomialTerm<C>> terms() const {
        using std::abs;
        using Real = typename RealPart<C>::type;
        const double rounding = 8 * static_cast<double>(std::numeric_limits<Real>::epsilon());
        std::vector<PolynomialTerm<C>> y;
        for (const auto& [exponents, sum] : terms_) {
            const double size = static_cast<double>(abs(sum.first));
            if (size != 0 && !(size < rounding * sum.second)) y.push_back({sum.first, exponents});
        }
        const auto total = [](const PolynomialTerm<C>& t) {
            int d = 0;
            for (int e : t.exponents) d += e;
            return d;
        };
        std::stable_sort(y.begin(), y.end(), [&](const auto& a, const auto& b) { return total(a) > total(b); });
        return y;
    }

private:
    std::map<std::vector<int>, std::pair<C, double>, std::greater<>> terms_;
};

/// T_k(c) or U_k(c): coefficients by the recurrence P_(k+1) = 2 c P_k - P_(k-1), P_0 = 1, P_1 = c or 2 c.
inline std::vector<double> chebyshev(int k, bool first_kind) {
    std::vector<double> p{1}, q{0, first_kind ? 1.0 : 2.0};
    for (int j = 0; j < k; ++j) {
        std::vector<double> next(q.size() + 1);
        for (std::size_t i = 0; i < q.size(); ++i) next[i + 1] += 2 * q[i];
        for (std::size_t i = 0; i < p.size(); ++i) next[i] -= p[i];
        p = std::exchange(q, next);
    }
    return p;
}

/// The system in (c, s) of the angles and the coordinates, with the circles. terms: entries with `equation` and
/// `monomial.code(unknown)`; coefficient(k) is that of the k-th.
template <class C>
PolynomialSystem<C> polynomial_system_of(int angles, int coordinates, const auto& terms, auto coefficient) {
    const auto variables = static_cast<std::size_t>(2 * angles + coordinates);
    PolynomialSystem<C> system;
    for (int i = 1; i <= angles; ++i) {
        system.variables.push_back("c" + std::to_string(i));
        system.variables.push_back("s" + std::to_string(i));
    }
    for (int j = 1; j <= coordinates; ++j) system.variables.push_back("x" + std::to_string(j));

    std::vector<PolynomialSum<C>> sums(static_cast<std::size_t>(angles + coordinates));
    int number = 0;
    for (const auto& term : terms) {
        std::vector<PolynomialTerm<C>> product{{coefficient(number++), std::vector<int>(variables)}};
        for (int u = 0; u < angles + coordinates; ++u) {
            const int code = term.monomial.code(u);
            const std::size_t v = static_cast<std::size_t>(u < angles ? 2 * u : angles + u);
            if (u >= angles || code == 0) {
                for (auto& t : product) t.exponents[v] = code;
                continue;
            }
            const auto cosines = chebyshev(code > 0 ? code : -code - 1, code > 0);
            std::vector<PolynomialTerm<C>> next;
            for (const auto& t : product)
                for (std::size_t d = 0; d < cosines.size(); ++d) {
                    if (cosines[d] == 0) continue;
                    next.push_back({C(cosines[d] * t.coefficient), t.exponents});
                    next.back().exponents[v] = static_cast<int>(d);
                    next.back().exponents[v + 1] = code < 0;
                }
            product = std::move(next);
        }
        for (const auto& t : product) sums[static_cast<std::size_t>(term.equation)].add(t.exponents, t.coefficient);
    }
    for (const auto& sum : sums) system.equations.push_back(sum.terms());
    for (std::size_t v = 0; v < static_cast<std::size_t>(2 * angles); v += 2) {
        PolynomialSum<C> circle;
        std::vector<int> exponents(variables);
        circle.add(exponents, C(-1.0));
        exponents[v] = 2;
        circle.add(exponents, C(1.0));
        exponents[v] = 0, exponents[v + 1] = 2;
        circle.add(exponents, C(1.0));
        system.equations.push_back(circle.terms());
    }
    return system;
}

}  // namespace detail

/// The system of a model for the parameters p; terms come by falling degree, then by falling exponents. C: double,
/// std::complex<double>, or wider. Errors: as `coefficients`.
template <Model M, class C = double>
PolynomialSystem<C> polynomial_system(const Parameters<M, C>& p) {
    const auto coefficient = coefficients<M, C>(p);
    return detail::polynomial_system_of<C>(n_angles<M>, n_coordinates<M>, Formulation<M>::support,
                                           [&](int k) { return coefficient[k]; });
}

}  // namespace equilibria
