/// \file
/// See system/system_family.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/system/system_family.hpp>

namespace equilibria {

namespace detail {

EQUILIBRIA_INLINE std::vector<std::complex<double>> coefficients_on(
    const std::vector<SparseTerm>& support, const RuntimeSizes& sizes,
    const RuntimePolynomials<std::complex<double>>& equations) {
    std::vector<std::complex<double>> y(support.size());
    int i = 0;
    for (const auto& f : equations) {
        const double negligible = 1e-12 * f.scale();
        for (const auto& t : f.terms()) {
            const SparseTerm key{i, SparseMonomial(codes_of(t.monomial, sizes)), 0};
            const auto at =
                std::ranges::lower_bound(support, key, [](const auto& a, const auto& b) { return before(a, b); });
            if (at != support.end() && at->equation == i && at->monomial == key.monomial)
                y[static_cast<std::size_t>(at - support.begin())] = t.coefficient;
            else
                require(std::abs(t.coefficient) <= negligible, "model", "equation " + std::to_string(i + 1),
                        "must have the same terms for all parameters: do not branch on their values");
        }
        ++i;
    }
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE SystemFamily::SystemFamily(const RuntimeSizes& sizes, std::vector<SparseTerm> support, int parameters,
                                             Coefficients coefficients)
    : sizes_(sizes), support_(std::move(support)), parameters_(parameters), coefficients_(std::move(coefficients)) {
    require(parameters >= 0, "parameters", parameters, "must not be negative");
    for (const SparseTerm& t : support_) {
        require(t.equation >= 0 && t.equation < sizes.unknowns, "equation of a term", t.equation,
                "must be below the number of unknowns");
        require(t.monomial.size() == sizes.unknowns, "codes of a term", t.monomial.size(),
                "must be as many as there are unknowns");
    }
}

EQUILIBRIA_INLINE std::vector<std::complex<double>> SystemFamily::coefficients(Parameters p) const {
    require(static_cast<int>(p.size()) == parameters_, "parameters", p.size(),
            "must be as many as the family's, " + std::to_string(parameters_));
    auto y = coefficients_(p);
    require(y.size() == support_.size(), "coefficients", y.size(),
            "must be as many as the family's terms, " + std::to_string(support_.size()));
    return y;
}

EQUILIBRIA_INLINE SparseSystem SystemFamily::system(std::span<const double> p) const {
    const auto a = coefficients(complex_parameters(p));
    std::vector<SparseTerm> terms;
    for (std::size_t k = 0; k < a.size(); ++k) {
        require(!(std::abs(a[k].imag()) > 1e-12 * std::abs(a[k])), "coefficient", a[k],
                "must be real at real parameters");
        if (a[k] != 0.0) terms.push_back({support_[k].equation, support_[k].monomial, a[k].real()});
    }
    return {sizes_, std::move(terms)};
}

EQUILIBRIA_INLINE SystemFamily constants_family(const SparseSystem& system) {
    const RuntimeSizes& sizes = system.sizes();
    const SparseMonomial one(std::vector<int>(static_cast<std::size_t>(sizes.unknowns)));
    std::vector<SparseTerm> support;
    std::vector<std::complex<double>> fixed(static_cast<std::size_t>(sizes.unknowns));  // the constants come first
    for (int i = 0; i < sizes.unknowns; ++i) support.push_back({i, one, 0});
    for (const SparseTerm& term : system.terms())
        if (term.monomial != one) support.push_back(term), fixed.emplace_back(term.coefficient);
    return {sizes, std::move(support), sizes.unknowns, [fixed](SystemFamily::Parameters p) {
                auto y = fixed;
                std::copy(p.begin(), p.end(), y.begin());
                return y;
            }};
}

EQUILIBRIA_INLINE std::vector<double> constants_of(const SparseSystem& system) {
    const SparseMonomial one(std::vector<int>(static_cast<std::size_t>(system.sizes().unknowns)));
    std::vector<double> y(static_cast<std::size_t>(system.sizes().unknowns));
    for (const SparseTerm& term : system.terms())
        if (term.monomial == one) y[static_cast<std::size_t>(term.equation)] += term.coefficient;
    return y;
}

EQUILIBRIA_INLINE bool SystemFamily::is_affine_between(Parameters from, Parameters to) const {
    const auto a = coefficients(from), b = coefficients(to);
    std::vector<double> scale(static_cast<std::size_t>(sizes_.unknowns));
    for (std::size_t k = 0; k < a.size(); ++k) {
        double& largest = scale[static_cast<std::size_t>(support_[k].equation)];
        largest = std::max({largest, std::abs(a[k]), std::abs(b[k])});
    }
    std::vector<Number> p(from.size());
    for (const double t : {0.1387, 0.3812, 0.6243, 0.8591}) {
        for (std::size_t k = 0; k < p.size(); ++k) p[k] = from[k] + t * (to[k] - from[k]);
        std::vector<Number> c;
        try {
            c = coefficients(p);
        } catch (const InvalidArgument&) {  // not finite there: a pole
            return false;
        }
        for (std::size_t k = 0; k < c.size(); ++k) {
            const double largest = std::max(std::abs(a[k]), std::abs(b[k]));
            const double negligible = 1e-12 * largest + 1e-15 * scale[static_cast<std::size_t>(support_[k].equation)];
            if (!(std::abs(c[k] - a[k] - t * (b[k] - a[k])) <= negligible)) return false;
        }
    }
    return true;
}

}  // namespace equilibria
