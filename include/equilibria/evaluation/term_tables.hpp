/// \file
/// How the terms of a system are evaluated by loops, worked out once.
///
/// The values cos k theta_u, sin k theta_u, x_u^k that the terms need are the factors, or, of a Laurent system, exp(i k
/// theta_u), exp(-i k theta_u), x_u^k; products of two or more of them are nodes, each computed once. The terms of
/// equation i are grouped by their factor in unknown i, its own one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
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
    /// A term and what multiplies its coefficient: an operand, or the slope of one by an unknown (see slope_place).
    struct Share {
        int term, factor;
    };
    /// The terms of one equation with one own factor (-1: the constant 1): shares first .. last-1, and the term that
    /// has no other factor (-1: none).
    struct Group {
        int own_factor, first, last, constant;
    };
    /// The derivative of a group by an unknown other than the equation's own: shares first .. last-1 times the own
    /// factor.
    struct Derivative {
        int own_factor, first, last;
    };
    /// An entry of the Jacobian beside its diagonal: the sum of derivatives first .. last-1.
    struct Entry {
        int equation, unknown, first, last;
    };

    /// A factor of an equation's own unknown.
    struct OwnFactor {
        int equation, code;
        friend auto operator<=>(const OwnFactor&, const OwnFactor&) = default;
    };

    /// terms: sorted by equation, then by the code of the equation's own unknown. degrees: of each unknown, at least,
    /// for what a start adds. more: own factors of which there are to be groups, without terms perhaps.
    /// in_exponentials: codes of angles are powers of exp(i theta).
    TermTables(const RuntimeSizes& numbers, const std::vector<SparseTerm>& terms, const std::vector<int>& degrees,
               const std::vector<OwnFactor>& more = {}, bool in_exponentials = false)
        : sizes(numbers), laurent(in_exponentials), highest(degrees), offset(at(numbers.unknowns + 1)) {
        for (int& degree : highest) degree = std::max(1, degree);
        for (const auto& t : terms)
            for (int u = 0; u < sizes.unknowns; ++u) highest[at(u)] = std::max(highest[at(u)], t.monomial.degree(u));
        for (int u = 0; u < sizes.unknowns; ++u)
            offset[at(u + 1)] = offset[at(u)] + (u < sizes.angles ? 2 : 1) * highest[at(u)];
        factors = offset.back();
        unknowns_.resize(at(factors));
        for (int u = 0; u < sizes.unknowns; ++u)
            for (int f = offset[at(u)]; f < offset[at(u + 1)]; ++f) unknowns_[at(f)] = u;
        first_unknown_.resize(at(factors + 1));
        std::iota(first_unknown_.begin(), first_unknown_.end(), std::size_t(0));
        operand.reserve(terms.size());
        std::map<Node, int> known;
        for (const auto& t : terms) operand.push_back(product(t, known));
        find_groups(terms, more);
    }

    /// The factor with a code (see Monomial) of unknown u; -1 for the constant 1.
    int factor(int u, int code) const {
        if (code == 0) return -1;
        if (u >= sizes.angles) return offset[at(u)] + code - 1;
        return offset[at(u)] + (code > 0 ? 2 * (code - 1) : 2 * (-code - 1) + 1);
    }
    /// That an operand depends on, ascending.
    std::span<const int> unknowns(int of) const {
        return {unknowns_.data() + first_unknown_[at(of)], first_unknown_[at(of + 1)] - first_unknown_[at(of)]};
    }
    int operands() const { return factors + static_cast<int>(nodes.size()); }
    /// Where the slope of an operand by an unknown has its place: factors first, which depend on one, then a row a
    /// node.
    int slope_place(int of, int unknown) const {
        return of < factors ? of : factors + (of - factors) * sizes.unknowns + unknown;
    }
    int slope_places() const { return factors + static_cast<int>(nodes.size()) * sizes.unknowns; }

    RuntimeSizes sizes;
    bool laurent = false;      ///< factors of angles are exponentials
    std::vector<int> highest;  ///< multiple or power of each unknown
    std::vector<int> offset;   ///< of each unknown's factors
    int factors = 0;
    std::vector<Node> nodes;
    std::vector<int> operand;             ///< of each term: the product of its factors other than the own one
    std::vector<Group> groups;            ///< by equation
    std::vector<int> first_group;         ///< of each equation, and one past the last group
    std::vector<Entry> entries;           ///< all of them, those above the diagonal first
    int entries_above = 0;                ///< the diagonal
    std::vector<Derivative> derivatives;  ///< of the entries
    std::vector<Share> shares;            ///< of the groups, and of the derivatives

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
                nodes.push_back(node);
                for (std::size_t k = first_unknown_[at(y)]; k < first_unknown_[at(y + 1)]; ++k) {
                    const int of_left = unknowns_[k];
                    unknowns_.push_back(of_left);
                }
                unknowns_.push_back(u);  // the highest so far
                first_unknown_.push_back(unknowns_.size());
            }
            y = place->second;
        }
        return y;
    }

    void find_groups(const std::vector<SparseTerm>& terms, const std::vector<OwnFactor>& more) {
        std::vector<std::pair<OwnFactor, int>> members;  // and the term, -1 for none
        members.reserve(terms.size() + more.size());
        for (const auto& own : more) members.push_back({own, -1});
        for (int k = 0; k < static_cast<int>(terms.size()); ++k)
            members.push_back({{terms[at(k)].equation, terms[at(k)].own_code()}, k});
        std::sort(members.begin(), members.end());
        first_group.assign(at(sizes.unknowns + 1), 0);
        shares.reserve(2 * terms.size());
        for (auto member = members.begin(); member != members.end();) {
            const OwnFactor own = member->first;
            Group group{factor(own.equation, own.code), static_cast<int>(shares.size()), 0, -1};
            for (; member != members.end() && member->first == own; ++member) {
                const int term = member->second;
                if (term < 0) continue;
                if (operand[at(term)] < 0)
                    group.constant = term;
                else
                    shares.push_back({term, operand[at(term)]});
            }
            group.last = static_cast<int>(shares.size());
            groups.push_back(group);
            ++first_group[at(own.equation + 1)];
        }
        for (int i = 0; i < sizes.unknowns; ++i) first_group[at(i + 1)] += first_group[at(i)];
        for (int i = 0; i < sizes.unknowns; ++i)
            for (int u = i + 1; u < sizes.unknowns; ++u) add_entry(i, u);
        entries_above = static_cast<int>(entries.size());
        for (int i = 0; i < sizes.unknowns; ++i)
            for (int u = 0; u < i; ++u) add_entry(i, u);
    }
    void add_entry(int i, int u) {
        const int first = static_cast<int>(derivatives.size());
        for (int g = first_group[at(i)]; g < first_group[at(i + 1)]; ++g) {
            const Group& group = groups[at(g)];
            Derivative by{group.own_factor, static_cast<int>(shares.size()), 0};
            for (int k = group.first; k < group.last; ++k) {
                const auto [term, of] = shares[at(k)];
                if (std::ranges::count(unknowns(of), u) > 0) shares.push_back({term, slope_place(of, u)});
            }
            by.last = static_cast<int>(shares.size());
            if (by.last > by.first) derivatives.push_back(by);
        }
        entries.push_back({i, u, first, static_cast<int>(derivatives.size())});
    }

    std::vector<int> unknowns_;  // of each operand, from first_unknown_ on
    std::vector<std::size_t> first_unknown_;
};

}  // namespace equilibria::detail
