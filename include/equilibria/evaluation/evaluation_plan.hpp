/// \file
/// How a homotopy of a model is evaluated, worked out at compile time from the support of its equations.
///
/// The values cos k theta_u, sin k theta_u, x_u^k that the terms need are the factors; products of two or more of them
/// are nodes, each computed once. The terms of equation i are grouped by their factor in unknown i, its own one:
///     F_i = sum over groups  own factor * P,      P = sum over terms  coefficient * (product of the other factors).
/// P serves three times: for F_i, for dF_i/dtheta_i (the own factor's derivative times P), and for dH/dt. For a chain
/// of n links this is the evaluation that one would write by hand, with n^2 products.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/array.hpp>

namespace equilibria::detail {

template <class M, class Start>
struct EvaluationPlan {
    using F = Formulation<M>;
    static constexpr int n = n_unknowns<M>;

    /// The highest multiple or power of unknown u that is needed.
    static constexpr int highest(int u) { return std::max({F::degree_in(u), F::degrees[u], 1}); }
    static constexpr Array<int, n + 1> factor_offset = [] {
        Array<int, n + 1> y;
        for (int u = 0; u < n; ++u) y[u + 1] = y[u] + (u < n_angles<M> ? 2 : 1) * highest(u);
        return y;
    }();
    static constexpr int factors = factor_offset[n];

    /// The factor with a code (see Monomial) of unknown u; -1 for the constant 1.
    static constexpr int factor(int u, int code) {
        if (code == 0) return -1;
        if (u >= n_angles<M>) return factor_offset[u] + code - 1;
        return factor_offset[u] + (code > 0 ? 2 * (code - 1) : 2 * (-code - 1) + 1);
    }
    static constexpr int unknown_of(int factor) {
        int u = 0;
        while (factor >= factor_offset[u + 1]) ++u;
        return u;
    }
    static constexpr int code_of(int factor) {
        const int u = unknown_of(factor), k = factor - factor_offset[u];
        if (u >= n_angles<M>) return k + 1;
        return k % 2 == 0 ? k / 2 + 1 : -(k / 2 + 1);
    }

    /// A product of an earlier operand (a factor, or a node) and a factor. Operands: factors, then nodes; -1 is 1.
    struct Node {
        int left, right;
        friend constexpr bool operator==(const Node&, const Node&) = default;
    };
    struct Products {
        std::vector<Node> nodes;
        std::vector<int> operand;  // of each term: the product of its factors other than the own one
    };
    static constexpr Products products() {
        Products y;
        for (const auto& t : F::support) {
            int product = -1;
            for (int u = 0; u < n; ++u) {
                const int f = u == t.equation ? -1 : factor(u, t.monomial.code(u));
                if (f < 0) continue;
                if (product < 0) {
                    product = f;
                    continue;
                }
                const Node node{product, f};
                const auto at = std::find(y.nodes.begin(), y.nodes.end(), node);
                product = factors + static_cast<int>(at - y.nodes.begin());
                if (at == y.nodes.end()) y.nodes.push_back(node);
            }
            y.operand.push_back(product);
        }
        return y;
    }
    static constexpr int n_nodes = static_cast<int>(products().nodes.size());
    static constexpr Array<Node, n_nodes> nodes = [] {
        Array<Node, n_nodes> y;
        if constexpr (n_nodes > 0) {
            const auto p = products();
            for (int k = 0; k < n_nodes; ++k) y[k] = p.nodes[static_cast<std::size_t>(k)];
        }
        return y;
    }();
    static constexpr Array<int, F::terms> operand = [] {
        Array<int, F::terms> y;
        const auto p = products();
        for (int k = 0; k < F::terms; ++k) y[k] = p.operand[static_cast<std::size_t>(k)];
        return y;
    }();

    /// The terms of one equation with one own factor, and whether the start system has that own factor too.
    struct Group {
        int equation, own_code, first, last;
        bool in_start;
    };
    static constexpr std::vector<Group> find_groups() {
        std::vector<Group> y;
        for (int i = 0; i < n; ++i) {
            int at = F::first[i];
            for (int code = -highest(i); code <= highest(i); ++code) {
                int last = at;
                while (last < F::first[i + 1] && F::support[last].own_code() == code) ++last;
                if (last > at || Start::has_term(i, code)) y.push_back({i, code, at, last, Start::has_term(i, code)});
                at = last;
            }
        }
        return y;
    }
    static constexpr int n_groups = static_cast<int>(find_groups().size());
    static constexpr Array<Group, n_groups> groups = [] {
        Array<Group, n_groups> y;
        const auto found = find_groups();
        for (int k = 0; k < n_groups; ++k) y[k] = found[static_cast<std::size_t>(k)];
        return y;
    }();
};

}  // namespace equilibria::detail
