/// \file
/// See homotopy/polynomial_homotopy.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <equilibria/evaluation/term_tables.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>

namespace equilibria {

EQUILIBRIA_INLINE PolynomialHomotopy::PolynomialHomotopy(Parts parts)
    : sizes_(parts.sizes), laurent_(std::move(parts.laurent)), from_(std::move(parts.from)),
      forms_(std::move(parts.forms)), scale_(std::move(parts.scale)), symmetric_(parts.symmetric),
      own_(std::move(parts.own)) {
    parts.degrees.resize(static_cast<std::size_t>(sizes_.unknowns));
    std::vector<detail::TermTables::OwnFactor> own_factors;
    for (const auto& t : forms_.terms) own_factors.push_back({t.equation, t.code});
    tables_ = std::make_shared<detail::TermTables>(sizes_, parts.terms, parts.degrees, own_factors, !laurent_.empty());
    for (const SparseTerm& t : parts.terms) target_.push_back(t.coefficient);
}

EQUILIBRIA_INLINE PolynomialHomotopy PolynomialHomotopy::scaled() const {
    std::vector<double> by = scale_;
    if (symmetric_) std::fill(by.begin(), by.end(), *std::max_element(by.begin(), by.end()));
    for (double& b : by) b = std::isnormal(b) ? std::ldexp(1.0, -std::ilogb(b)) : 1.0;
    PolynomialHomotopy y = *this;
    const auto of_term = [&](int term, double factor) {
        const auto at = static_cast<std::size_t>(term);
        y.target_[at] *= factor;
        if (!laurent_.empty()) y.laurent_[at] *= factor;
        if (!from_.empty()) y.from_[at] *= factor;
    };
    for (std::size_t i = 0; i < by.size(); ++i) {
        y.scale_[i] *= by[i];
        for (int g = tables_->first_group[i]; g < tables_->first_group[i + 1]; ++g) {
            const auto& group = tables_->groups[static_cast<std::size_t>(g)];
            for (int k = group.first; k < group.last; ++k)
                of_term(tables_->shares[static_cast<std::size_t>(k)].term, by[i]);
            if (group.constant >= 0) of_term(group.constant, by[i]);
        }
    }
    for (auto& term : y.forms_.terms) term.coefficient *= by[static_cast<std::size_t>(term.equation)];
    for (auto& product : y.forms_.products) product.weight *= by[static_cast<std::size_t>(product.equation)];
    y.own_ = nullptr;
    return y;
}

}  // namespace equilibria
