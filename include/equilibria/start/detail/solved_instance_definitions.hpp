/// \file
/// See start/solved_instance.hpp.
#pragma once

#include <algorithm>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/start/solved_instance.hpp>

namespace equilibria {

EQUILIBRIA_INLINE SolvedInstance::SolvedInstance(const SparseSystem& from, const SparseSystem& to,
                                                 std::complex<double> gamma, Points points)
    : sizes_(to.sizes()), points_(std::move(points)), terms_(to.terms()) {
    require(from.sizes().angles == sizes_.angles && from.sizes().coordinates == sizes_.coordinates, "from",
            from.sizes().unknowns, "must have the unknowns of the target");
    const auto in_order = [](const SparseTerm& a, const SparseTerm& b) { return before(a, b); };
    const auto find = [&](const std::vector<SparseTerm>& terms, const SparseTerm& t) {
        const auto at = std::lower_bound(terms.begin(), terms.end(), t, in_order);
        return at != terms.end() && !before(t, *at) ? at : terms.end();
    };
    std::vector<SparseTerm> others;
    for (SparseTerm t : from.terms())
        if (find(terms_, t) == terms_.end()) t.coefficient = 0, others.push_back(t);
    terms_.insert(terms_.end(), others.begin(), others.end());
    std::sort(terms_.begin(), terms_.end(), in_order);
    from_.resize(terms_.size());
    for (const SparseTerm& t : from.terms())
        from_[static_cast<std::size_t>(find(terms_, t) - terms_.begin())] = gamma * t.coefficient;
}

}  // namespace equilibria
