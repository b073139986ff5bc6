/// \file
/// See system/sparse_system.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

EQUILIBRIA_INLINE SparseSystem::SparseSystem(const RuntimeSizes& sizes, std::vector<Term> terms)
    : sizes_(sizes), terms_(std::move(terms)), scale_(at(sizes.unknowns)), degrees_(at(sizes.unknowns)) {
    std::vector<bool> has_terms(at(sizes.unknowns));
    for (const Term& t : terms_) {
        require(t.equation >= 0 && t.equation < sizes.unknowns, "equation of a term", t.equation,
                "must be below the number of unknowns");
        require(t.monomial.size() == sizes.unknowns, "codes of a term", t.monomial.size(),
                "must be as many as there are unknowns");
        require(std::isfinite(t.coefficient), "equations", "equation " + std::to_string(t.equation + 1),
                "has a coefficient that is not finite");
        has_terms[at(t.equation)] = true;
        scale_[at(t.equation)] = std::max(scale_[at(t.equation)], std::abs(t.coefficient));
        degrees_[at(t.equation)] = std::max(degrees_[at(t.equation)], t.monomial.degree());
    }
    for (int i = 0; i < sizes.unknowns; ++i)
        require(has_terms[at(i)], "equations", "equation " + std::to_string(i + 1), "must not be 0");
    std::sort(terms_.begin(), terms_.end(), [](const Term& a, const Term& b) { return before(a, b); });
}

EQUILIBRIA_INLINE SparseSystem SparseSystem::with_constants(std::span<const double> constants) const {
    require(static_cast<int>(constants.size()) == sizes_.unknowns, "constants", constants.size(),
            "must be as many as there are equations");
    const SparseMonomial one(std::vector<int>(at(sizes_.unknowns)));
    std::vector<Term> terms = terms_;
    for (int i = 0; i < sizes_.unknowns; ++i) {
        const auto same = [&](const Term& t) { return t.equation == i && t.monomial == one; };
        if (const auto found = std::find_if(terms.begin(), terms.end(), same); found != terms.end())
            found->coefficient += constants[at(i)];
        else
            terms.push_back({i, one, constants[at(i)]});
    }
    return {sizes_, std::move(terms)};
}

EQUILIBRIA_INLINE PolynomialSystem<double> polynomial_system(const SparseSystem& system) {
    return detail::polynomial_system_of<double>(
        system.sizes().angles, system.sizes().coordinates, system.terms(),
        [&](int k) { return system.terms()[static_cast<std::size_t>(k)].coefficient; });
}

}  // namespace equilibria
