/// \file
/// See start/linear_product.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/start/linear_product.hpp>

namespace equilibria {

EQUILIBRIA_INLINE LinearProduct::LinearProduct(const SparseSystem& target, std::span<const int> grouping, Number gamma,
                                               Generator& generator)
    : sizes_(target.sizes()), chosen_(target.scale().size()) {
    require(grouping.size() == target.scale().size(), "grouping", grouping.size(),
            "must have a group for each unknown");
    for (int u = 0; u < sizes_.unknowns; ++u) {
        const int group = grouping[at(u)];
        require(group >= 0 && group < sizes_.unknowns, "grouping", group, "must be a number from 0");
        members_.resize(std::max(members_.size(), at(group) + 1));
        members_[at(group)].push_back(u);
    }
    const std::size_t groups = members_.size();
    std::vector<std::vector<int>> degrees(grouping.size(), std::vector<int>(groups));
    for (const auto& term : target.terms()) {
        std::vector<int> d(groups);
        for (int u = 0; u < sizes_.unknowns; ++u) d[at(grouping[at(u)])] += term.monomial.degree(u);
        auto& most = degrees[at(term.equation)];
        for (std::size_t g = 0; g < groups; ++g) most[g] = std::max(most[g], d[g]);
    }
    for (int i = 0; i < sizes_.unknowns; ++i) {
        forms_.products.push_back({i, 0, {}});
        groups_.emplace_back();
        for (std::size_t g = 0; g < groups; ++g)
            for (int k = 0; k < degrees[at(i)][g]; ++k) {
                forms_.products.back().forms.push_back(draw(members_[g], generator));
                groups_.back().push_back(g);
            }
    }
    for (auto& product : forms_.products)
        product.weight = gamma * target.scale()[at(product.equation)] / largest_coefficient(product);
    std::vector<std::size_t> left;
    for (const auto& members : members_) left.push_back(members.size());
    choose(0, left);
    chosen_.clear();
}

EQUILIBRIA_INLINE LinearProduct::LinearForm LinearProduct::draw(const std::vector<int>& members, Generator& generator) {
    LinearForm form{0, {}};
    double norm2 = 0;
    const auto number = [&](Number& z) {
        const double size = uniform(generator, 0.5, 1);
        z = size * unit_complex(generator);
        norm2 += size * size;
    };
    number(form.constant);
    for (const int u : members) number(form.parts.emplace_back(LinearForm::Part{u, 0}).factor);
    form.constant /= std::sqrt(norm2);
    for (auto& part : form.parts) part.factor /= std::sqrt(norm2);
    return form;
}

EQUILIBRIA_INLINE double LinearProduct::largest_coefficient(const StartForms::Product& product) const {
    using Codes = std::vector<int>;
    std::map<Codes, Number> sum{{Codes(at(sizes_.unknowns)), 1}};
    for (const LinearForm& form : product.forms) {
        std::map<Codes, Number> next;
        for (const auto& term : sum) {  // no structured binding: clang++ 14 cannot capture one
            const Codes& codes = term.first;
            const Number& coefficient = term.second;
            next[codes] += form.constant * coefficient;
            for (const auto& part : form.parts) {
                const auto add = [&](int change, double share) {
                    Codes other = codes;
                    other[at(part.unknown)] += change;
                    next[other] += share * part.factor * coefficient;
                };
                const bool two = part.unknown < sizes_.angles && codes[at(part.unknown)] > 0;
                add(1, two ? 0.5 : 1);
                if (two) add(-1, 0.5);
            }
        }
        sum = std::move(next);
    }
    double largest = 0;
    for (const auto& [codes, coefficient] : sum) largest = std::max(largest, std::abs(coefficient));
    return largest;
}

EQUILIBRIA_INLINE void LinearProduct::choose(int i, std::vector<std::size_t>& left) {
    if (i == sizes_.unknowns) return solve();
    const auto& forms = forms_.products[at(i)].forms;
    for (std::size_t k = 0; k < forms.size(); ++k) {
        std::size_t& here = left[groups_[at(i)][k]];
        if (here == 0) continue;
        --here;
        chosen_[at(i)] = {&forms[k], groups_[at(i)][k]};
        choose(i + 1, left);
        ++here;
    }
}

EQUILIBRIA_INLINE void LinearProduct::solve() {
    Solution q(sizes_.unknowns);
    for (std::size_t g = 0; g < members_.size(); ++g) {
        const auto size = static_cast<Eigen::Index>(members_[g].size());
        Eigen::MatrixXcd a(size, size);
        Eigen::VectorXcd right(size);
        Eigen::Index row = 0;
        for (const auto& [form, group] : chosen_) {
            if (group != g) continue;
            right(row) = -form->constant;
            for (Eigen::Index m = 0; m < size; ++m) a(row, m) = form->parts[static_cast<std::size_t>(m)].factor;
            ++row;
        }
        const Eigen::VectorXcd root = a.partialPivLu().solve(right);
        for (Eigen::Index m = 0; m < size; ++m) {
            const int u = members_[g][static_cast<std::size_t>(m)];
            q[u] = u < sizes_.angles ? std::acos(root(m)) : root(m);
        }
    }
    for (std::uint64_t signs = 0; signs < std::uint64_t{1} << sizes_.angles; ++signs) {
        Solution signed_root = q;
        for (int u = 0; u < sizes_.angles; ++u)
            if (signs >> u & 1) signed_root[u] = -signed_root[u];
        solutions_.push_back(signed_root);
    }
}

}  // namespace equilibria
