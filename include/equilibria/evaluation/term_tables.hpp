/// \file
/// How the terms of a system are evaluated by loops, worked out at run time: what evaluation_plan.hpp is for code that
/// is unrolled.
///
/// The values cos k theta_u, sin k theta_u, x_u^k that the terms need are the factors; products of two or more of them
/// are nodes, each computed once. The terms of equation i are grouped by their factor in unknown i, its own one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <equilibria/model/sizes.hpp>
#include <equilibria/system/sparse_term.hpp>

namespace equilibria::detail {

class TermTables {
public:
    /// A product of an earlier operand (a factor, or a node) and a factor. Operands: factors, then nodes; -1 is 1.
    struct Node {
        int left, right;
        friend auto operator<=>(const Node&, const Node&) = default;
    };
    /// The terms first .. last-1 of one equation, with one own factor (-1: the constant 1).
    struct Group {
        int equation, own_factor, first, last;
        std::vector<int> unknowns;  ///< that the other factors depend on
    };

    /// terms: sorted by equation, then by the code of the equation's own unknown. degrees: of each unknown, at least,
    /// for what a start adds.
    TermTables(const RuntimeSizes& numbers, const std::vector<SparseTerm>& terms, const std::vector<int>& degrees)
        : sizes(numbers), highest(degrees), offset(at(numbers.unknowns + 1)) {
        for (int& degree : highest) degree = std::max(1, degree);
        for (const auto& t : terms)
            for (int u = 0; u < sizes.unknowns; ++u) highest[at(u)] = std::max(highest[at(u)], t.monomial.degree(u));
        for (int u = 0; u < sizes.unknowns; ++u)
            offset[at(u + 1)] = offset[at(u)] + (u < sizes.angles ? 2 : 1) * highest[at(u)];
        factors = offset.back();
        unknowns.resize(at(factors));
        for (int u = 0; u < sizes.unknowns; ++u)
            for (int f = offset[at(u)]; f < offset[at(u + 1)]; ++f) unknowns[at(f)] = {u};
        std::map<Node, int> known;
        for (const auto& t : terms) operand.push_back(product(t, known));
        find_groups(terms);
    }

    /// The factor with a code (see Monomial) of unknown u; -1 for the constant 1.
    int factor(int u, int code) const {
        if (code == 0) return -1;
        if (u >= sizes.angles) return offset[at(u)] + code - 1;
        return offset[at(u)] + (code > 0 ? 2 * (code - 1) : 2 * (-code - 1) + 1);
    }
    int operands() const { return factors + static_cast<int>(nodes.size()); }

    RuntimeSizes sizes;
    std::vector<int> highest;  ///< multiple or power of each unknown
    std::vector<int> offset;   ///< of each unknown's factors
    int factors = 0;
    std::vector<Node> nodes;
    std::vector<int> operand;                ///< of each term: the product of its factors other than the own one
    std::vector<Group> groups;               ///< by equation
    std::vector<std::vector<int>> unknowns;  ///< of each operand, ascending

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    int product(const SparseTerm& term, std::map<Node, int>& known) {
        int y = -1;
        for (int u = 0; u < sizes.unknowns; ++u) {
            const int f = u == term.equation ? -1 : factor(u, term.monomial.code(u));
            if (f < 0) continue;
            if (y < 0) {
                y = f;
                continue;
            }
            const Node node{y, f};
            const auto [place, fresh] = known.try_emplace(node, operands());
            if (fresh) {
                std::vector<int> depends = unknowns[at(node.left)];
                depends.push_back(u);  // the highest so far
                nodes.push_back(node);
                unknowns.push_back(std::move(depends));
            }
            y = place->second;
        }
        return y;
    }

    void find_groups(const std::vector<SparseTerm>& terms) {
        const int size = static_cast<int>(operand.size());
        for (int first = 0, last; first < size; first = last) {
            const auto& t = terms[at(first)];
            last = first;
            std::vector<bool> used(at(sizes.unknowns));
            for (; last < size && terms[at(last)].equation == t.equation && terms[at(last)].own_code() == t.own_code();
                 ++last)
                if (operand[at(last)] >= 0)
                    for (const int u : unknowns[at(operand[at(last)])]) used[at(u)] = true;
            Group group{t.equation, factor(t.equation, t.own_code()), first, last, {}};
            for (int u = 0; u < sizes.unknowns; ++u)
                if (used[at(u)]) group.unknowns.push_back(u);
            groups.push_back(std::move(group));
        }
    }
};

}  // namespace equilibria::detail
