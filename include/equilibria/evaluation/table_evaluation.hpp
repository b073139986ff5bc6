/// \file
/// The evaluation of a homotopy by loops over the tables of its terms: for systems that are data, and for those with
/// too many terms to be unrolled (unrolled_evaluation.hpp). H(q, t), its Jacobian in q, its Taylor coefficients along a
/// path.
///
/// What the target's terms and their law of time give is summed here; what the start adds in a form of its own, here
/// (1-t) G, is asked of `Form`: `series(k, factors, g)`, the Taylor coefficients of G, and `slopes(factors, j)`, its
/// Jacobian.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include <equilibria/core/complex.hpp>
#include <equilibria/evaluation/factor_series.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/term_tables.hpp>

namespace equilibria::detail {

/// H: `tables()`, `target(term)` at t = 1, and where the coefficients move `law<l>(term, t)`, the Taylor coefficient l
/// in t of the term's coefficient, l up to H::law_order.
template <class H, class R, class Time>
class TableEvaluation {
public:
    using S = typename H::System;
    using Z = Complex<R>;
    using Form = typename H::template Form<R>;
    static constexpr int n = n_unknowns<S>;
    static constexpr int order = FactorSeries<S, R>::order;
    static constexpr bool symmetric = H::symmetric;
    static constexpr int laws = H::moving ? H::law_order + 1 : 2;

    explicit TableEvaluation(const H& h)
        : h_(&h), tables_(&h.tables()), factors_(*tables_), form_(h), groups_(tables_->groups.size()),
          sum_(static_cast<std::size_t>(laws) * (order + 1) * groups_), blend_((order + 1) * groups_),
          node_slope_(tables_->nodes.size()), current_(H::moving ? tables_->operand.size() : 0) {}

    /// H(q, t).
    void value(const Point<S, R>& q, const Time& t, Z (&f)[n]) {
        time_ = t;
        factors_.begin(q);
        if constexpr (H::moving)
            for (std::size_t k = 0; k < current_.size(); ++k)
                current_[k] = h_->template law<0, R>(static_cast<int>(k), t);
        for (Z& entry : f) entry = zero();
        for (std::size_t g = 0; g < groups_; ++g) {
            const auto& group = tables_->groups[g];
            sum_terms(0, g);
            f[group.equation] += group.own_factor < 0 ? blend(0, g) : Z(factors_(0, group.own_factor) * blend(0, g));
        }
        form_.series(0, factors_, start_[0]);
        for (int i = 0; i < n; ++i) f[i] += (1.0 - time_) * start_[0][i];
    }

    /// H(q, t) and its Jacobian; with a potential only the entries on and above the diagonal are set.
    void jacobian(const Point<S, R>& q, const Time& t, Z (&f)[n], Z (&j)[n][n]) {
        value(q, t, f);
        factors_.begin_slopes();
        for (auto& row : j)
            for (Z& entry : row) entry = zero();
        form_.slopes(factors_, j);
        for (auto& row : j)
            for (Z& entry : row) entry = (1.0 - time_) * entry;
        multiply_slopes();
        for (std::size_t g = 0; g < groups_; ++g) add_slopes(g, j);
    }

    /// The Taylor coefficient k of -H(q(t), t), given those of q(t) below k and taking its k-th as zero: the
    /// right-hand side of J q_k = ... Call with k = 1, 2, ... after `jacobian`, and `set_coefficient` in between.
    void taylor_right_side(int k, Z (&f)[n]) {
        factors_.extend(k);
        for (Z& entry : f) entry = zero();
        for (std::size_t g = 0; g < groups_; ++g) {
            const auto& group = tables_->groups[g];
            sum_terms(k, g);
            if (group.own_factor < 0)
                f[group.equation] -= blend(k, g);
            else
                for (int l = 0; l <= k; ++l) f[group.equation] -= factors_(l, group.own_factor) * blend(k - l, g);
        }
        form_.series(k, factors_, start_[k]);
        for (int i = 0; i < n; ++i) f[i] -= (1.0 - time_) * start_[k][i] - start_[k - 1][i];
    }
    /// Tells the k-th Taylor coefficient of q(t), once solved for.
    void set_coefficient(int k, const Z (&d)[n]) {
        factors_.complete(k, d);
        for (std::size_t g = 0; g < groups_; ++g) sum_terms(k, g);
        form_.series(k, factors_, start_[k]);
    }

private:
    static Z zero() { return {broadcast<R>(0.0), broadcast<R>(0.0)}; }
    static auto number(double a) { return broadcast<R>(a); }
    static auto number(const std::complex<double>& a) { return broadcast_complex<R>(a); }
    static const Z& number(const Z& a) { return a; }

    /// Of a group: the sum over its terms of the coefficient's Taylor coefficient `law` times the operand's k-th.
    Z& sum(int law, int k, std::size_t g) {
        return sum_[(static_cast<std::size_t>(law) * (order + 1) + static_cast<std::size_t>(k)) * groups_ + g];
    }
    Z& blend(int k, std::size_t g) { return blend_[static_cast<std::size_t>(k) * groups_ + g]; }

    template <int Law>
    auto coefficient(int term) const {
        if constexpr (!H::moving)
            return number(h_->target(term));
        else if constexpr (Law == 0)
            return current_[static_cast<std::size_t>(term)];
        else
            return number(h_->template law<Law, R>(term, time_));
    }
    template <int Law>
    Z summed(int k, const typename TermTables<S>::Group& group) const {
        Z y = zero();
        for (int term = group.first; term < group.last; ++term) {
            const int operand = tables_->operand[static_cast<std::size_t>(term)];
            if (operand >= 0)
                y += coefficient<Law>(term) * factors_(k, operand);
            else if (k == 0)
                y = y + coefficient<Law>(term);
        }
        return y;
    }
    /// The group's share of order k, before it is multiplied by its own factor.
    void sum_terms(int k, std::size_t g) {
        const auto& group = tables_->groups[g];
        if constexpr (H::moving) {
            sum(0, k, g) = blend(k, g) = summed<0>(k, group);
            add_laws<1>(k, g);
        } else {
            sum(0, k, g) = summed<0>(k, group);
            blend(k, g) = time_ * sum(0, k, g);
            if (k > 0) blend(k, g) += sum(0, k - 1, g);
        }
    }
    template <int Law>
    void add_laws(int k, std::size_t g) {
        if constexpr (Law <= H::law_order) {
            sum(Law, k, g) = summed<Law>(k, tables_->groups[g]);
            if (k >= Law) blend(k, g) += sum(Law, k - Law, g);
            add_laws<Law + 1>(k, g);
        }
    }

    const Z& slope_of(int operand, int u) const {
        return operand < tables_->factors
                   ? factors_.slope(operand)
                   : node_slope_[static_cast<std::size_t>(operand - tables_->factors)][static_cast<std::size_t>(u)];
    }
    void multiply_slopes() {
        std::size_t m = 0;
        for (const auto& node : tables_->nodes) {
            auto& slope = node_slope_[m];
            for (const int u : tables_->unknowns[static_cast<std::size_t>(node.left)])
                slope[static_cast<std::size_t>(u)] = slope_of(node.left, u) * factors_(0, node.right);
            slope[static_cast<std::size_t>(tables_->unknowns[static_cast<std::size_t>(node.right)].front())] =
                factors_(0, node.left) * factors_.slope(node.right);
            ++m;
        }
    }
    void add_slopes(std::size_t g, Z (&j)[n][n]) {
        const auto& group = tables_->groups[g];
        const int i = group.equation;
        if (group.own_factor >= 0) j[i][i] += factors_.slope(group.own_factor) * blend(0, g);
        if (group.unknowns.empty()) return;
        Z row[n];
        for (const int u : group.unknowns) row[u] = zero();
        for (int term = group.first; term < group.last; ++term) {
            const int operand = tables_->operand[static_cast<std::size_t>(term)];
            if (operand < 0) continue;
            for (const int u : tables_->unknowns[static_cast<std::size_t>(operand)])
                row[u] += coefficient<0>(term) * slope_of(operand, u);
        }
        for (const int u : group.unknowns) {
            if (symmetric && u < i) continue;
            Z entry = group.own_factor < 0 ? row[u] : Z(factors_(0, group.own_factor) * row[u]);
            if constexpr (!H::moving) entry = time_ * entry;
            j[i][u] += entry;
        }
    }

    const H* h_;
    const TermTables<S>* tables_;
    Time time_;
    FactorSeries<S, R> factors_;
    Form form_;
    std::size_t groups_;
    std::vector<Z> sum_, blend_;
    std::vector<std::array<Z, static_cast<std::size_t>(n)>> node_slope_;
    std::vector<Z> current_;  // where coefficients move
    Z start_[order + 1][n];   // the Taylor coefficients of G
};

}  // namespace equilibria::detail
