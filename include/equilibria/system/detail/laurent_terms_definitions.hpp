/// \file
/// See system/laurent_terms.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <equilibria/algebra/laurent_products.hpp>
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

EQUILIBRIA_INLINE std::vector<PolynomialTerm<std::complex<double>>> laurent_products(const SparseMonomial& monomial,
                                                                                     const RuntimeSizes& sizes) {
    std::vector<int> codes;
    for (int u = 0; u < sizes.unknowns; ++u) codes.push_back(monomial.code(u));
    return laurent_products(codes, sizes.angles);
}

}  // namespace detail

EQUILIBRIA_INLINE std::vector<std::vector<PolynomialTerm<std::complex<double>>>> laurent_terms(
    const SparseSystem& system) {
    using Number = std::complex<double>;
    const RuntimeSizes& sizes = system.sizes();
    std::vector<detail::PolynomialSum<Number>> sums(static_cast<std::size_t>(sizes.unknowns));
    for (const SparseTerm& term : system.terms())
        for (const auto& product : detail::laurent_products(term.monomial, sizes))
            sums[static_cast<std::size_t>(term.equation)].add(product.exponents,
                                                              term.coefficient * product.coefficient);
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
