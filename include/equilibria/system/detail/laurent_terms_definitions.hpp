/// \file
/// See system/laurent_terms.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <equilibria/polyhedral/affine_supports.hpp>
#include <equilibria/system/laurent_terms.hpp>

namespace equilibria {

namespace detail {

EQUILIBRIA_INLINE std::vector<std::vector<Supports::Point>> exponents_of(const SparseSystem& system) {
    std::vector<std::vector<Supports::Point>> y;
    for (const auto& equation : laurent_terms(system)) {
        y.emplace_back();
        for (const auto& term : equation) y.back().push_back(term.exponents);
    }
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE std::vector<std::vector<PolynomialTerm<std::complex<double>>>> laurent_terms(
    const SparseSystem& system) {
    using Number = std::complex<double>;
    const RuntimeSizes& sizes = system.sizes();
    std::vector<detail::PolynomialSum<Number>> sums(static_cast<std::size_t>(sizes.unknowns));
    for (const SparseTerm& term : system.terms()) {
        std::vector<std::pair<std::vector<int>, Number>> products{
            {std::vector<int>(static_cast<std::size_t>(sizes.unknowns)), Number(term.coefficient)}};
        for (int u = 0; u < sizes.unknowns; ++u) {
            const int code = term.monomial.code(u);
            const auto at = static_cast<std::size_t>(u);
            const std::size_t before = products.size();
            for (std::size_t k = 0; code != 0 && k < before; ++k) {
                products[k].first[at] = std::abs(code);
                if (u >= sizes.angles) continue;
                // cos k = (z^k + z^-k) / 2, sin k = (z^k - z^-k) / 2i
                products[k].second *= code > 0 ? Number(0.5) : Number(0, -0.5);
                auto other = products[k];
                other.first[at] = -std::abs(code);
                if (code < 0) other.second = -other.second;
                products.push_back(std::move(other));
            }
        }
        for (const auto& [exponents, coefficient] : products)
            sums[static_cast<std::size_t>(term.equation)].add(exponents, coefficient);
    }
    std::vector<std::vector<PolynomialTerm<Number>>> y;
    for (const auto& sum : sums) y.push_back(sum.terms());
    return y;
}

EQUILIBRIA_INLINE Supports laurent_supports(const SparseSystem& system) {
    return Supports(system.sizes().unknowns, detail::exponents_of(system));
}

EQUILIBRIA_INLINE Supports affine_supports(const SparseSystem& system) {
    auto equations = detail::exponents_of(system);
    add_origin(system.sizes().angles, equations);
    return Supports(system.sizes().unknowns, std::move(equations));
}

}  // namespace equilibria
