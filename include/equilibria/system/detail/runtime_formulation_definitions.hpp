/// \file
/// See system/runtime_formulation.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <equilibria/system/runtime_formulation.hpp>

namespace equilibria {

namespace detail {
/// Why a model's equation is no polynomial, as an error says it.
EQUILIBRIA_INLINE const char* sentence(NotPolynomial fault) {
    switch (fault) {
        case NotPolynomial::function_of_angle:
            return "must be a trigonometric polynomial: it takes sqrt, exp, log, sin or cos of something that depends "
                   "on the angles or coordinates";
        case NotPolynomial::divisor_not_constant:
            return "must be a trigonometric polynomial: it divides by something that depends on the angles or "
                   "coordinates";
        case NotPolynomial::degree_too_high:
            return "must not have a multiple of an angle, or a power of a coordinate, above 1000";
        default: return "must be a trigonometric polynomial";
    }
}
/// True if the polynomial has no such term, or one whose coefficient is 0.
bool vanishes(const RuntimePolynomial<ExactBall>& f, const auto& monomial) {
    const auto& terms = f.terms();
    const auto at = std::ranges::find_if(terms, [&](const auto& t) { return t.monomial == monomial; });
    return at == terms.end() || !may_differ_from_zero(at->coefficient);
}
EQUILIBRIA_INLINE std::string equation_name(int i) { return "equation " + std::to_string(i + 1); }
}  // namespace detail

EQUILIBRIA_INLINE RuntimeFormulation::RuntimeFormulation(const RuntimeSizes& sizes, bool has_potential,
                                                         RuntimePolynomials<> generic,
                                                         const std::function<RuntimePolynomials<ExactBall>()>& exactly)
    : sizes_(sizes), has_potential_(has_potential), reflection_symmetric_(sizes.coordinates == 0) {
    // a small coefficient may be the rounding of terms that cancel, or a small coefficient: exact numbers know
    std::optional<RuntimePolynomials<ExactBall>> exact;
    int i = 0;
    for (auto& f : generic) {
        require(f.fault() == NotPolynomial::no, "model", detail::equation_name(i), detail::sentence(f.fault()));
        const double suspicious = 1e-10 * f.scale();
        int degree = 0;
        for (const auto& t : f.terms()) {
            if (std::abs(t.coefficient) < suspicious) {
                if (!exact) exact = exactly();
                if (detail::vanishes((*exact)[static_cast<std::size_t>(i)], t.monomial)) continue;
            }
            const auto codes = codes_of(t.monomial, sizes);
            support_.push_back({i, SparseMonomial(codes), 0});
            degree = std::max(degree, support_.back().monomial.degree());
            if (std::ranges::count_if(codes, [](int code) { return code < 0; }) % 2 == 0) reflection_symmetric_ = false;
        }
        require(degree > 0, "model", detail::equation_name(i),
                "must depend on the unknowns (with a potential: the potential on each of them)");
        degrees_.push_back(degree);
        ++i;
    }
    std::ranges::sort(support_, [](const auto& a, const auto& b) { return before(a, b); });
}

EQUILIBRIA_INLINE std::vector<SparseTerm> RuntimeFormulation::with_coefficients(
    const RuntimePolynomials<>& equations) const {
    std::vector<SparseTerm> y = support_;
    int i = 0;
    for (const auto& f : equations) {
        const double negligible = 1e-12 * f.scale();
        for (const auto& t : f.terms()) {
            require(std::abs(t.coefficient) < std::numeric_limits<double>::infinity(), "model",
                    detail::equation_name(i), "has a coefficient that is not finite at these parameters");
            const SparseTerm key{i, SparseMonomial(codes_of(t.monomial, sizes_)), 0};
            const auto at = std::ranges::lower_bound(y, key, [](const auto& a, const auto& b) { return before(a, b); });
            if (at != y.end() && at->equation == i && at->monomial == key.monomial)
                at->coefficient = t.coefficient;
            else
                require(std::abs(t.coefficient) <= negligible, "model", detail::equation_name(i),
                        "must have the same terms for all parameters: do not branch on their values");
        }
        ++i;
    }
    return y;
}

}  // namespace equilibria
