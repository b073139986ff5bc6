/// \file
/// See homotopy/polynomial_homotopy.hpp.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <equilibria/evaluation/term_tables.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>

namespace equilibria {

EQUILIBRIA_INLINE PolynomialHomotopy::PolynomialHomotopy(Parts parts)
    : sizes_(parts.sizes), from_(std::move(parts.from)), forms_(std::move(parts.forms)), scale_(std::move(parts.scale)),
      symmetric_(parts.symmetric), own_(std::move(parts.own)) {
    parts.degrees.resize(static_cast<std::size_t>(sizes_.unknowns));
    std::vector<detail::TermTables::OwnFactor> own_factors;
    for (const auto& t : forms_.terms) own_factors.push_back({t.equation, t.code});
    tables_ = std::make_shared<detail::TermTables>(sizes_, parts.terms, parts.degrees, own_factors);
    for (const SparseTerm& t : parts.terms) target_.push_back(t.coefficient);
}

}  // namespace equilibria
