/// \file
/// The evaluation of a homotopy by loops over the tables of its terms, for systems that are data: H(q, t), its Jacobian
/// in q, its Taylor coefficients along a path. Unrolled, for a model whose terms are known at compile time:
/// unrolled_evaluation.hpp.
///
/// What the target's terms and their law of time give is summed here; what the start adds in a form of its own, here
/// (1-t) G, is evaluated by StartFormSeries.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include <equilibria/core/complex.hpp>
#include <equilibria/evaluation/factor_series.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/start_form_series.hpp>
#include <equilibria/evaluation/term_tables.hpp>

namespace equilibria::detail {

/// H: `tables()`, `forms()`, `symmetric()`, `target(term)` at t = 1, and where the coefficients are `moving()`
/// `law<l>(term, t)`, the Taylor coefficient l in t of the term's coefficient, l up to H::law_order.
template <class H, class R, class Time>
class TableEvaluation {
public:
    using Z = Complex<R>;
    static constexpr int order = FactorSeries<R>::order;

    explicit TableEvaluation(const H& h)
        : h_(&h), tables_(&h.tables()), n_(tables_->sizes.unknowns), moving_(h.moving()), symmetric_(h.symmetric()),
          factors_(*tables_), form_(h.forms(), *tables_), groups_(tables_->groups.size()),
          sum_(static_cast<std::size_t>(moving_ ? H::law_order + 1 : 1) * (order + 1) * groups_),
          blend_((order + 1) * groups_), node_slope_(tables_->nodes.size() * static_cast<std::size_t>(n_)),
          current_(moving_ ? tables_->operand.size() : 0), row_(n_) {
        if (form_.empty()) return;
        for (auto& g : start_) g = SizedArray<Z, at_run_time>(n_);
    }

    /// H(q, t).
    void value(const RuntimePoint<R>& q, const Time& t, auto& f) {
        time_ = t;
        factors_.begin(q);
        for (std::size_t k = 0; k < current_.size(); ++k) current_[k] = h_->template law<0, R>(static_cast<int>(k), t);
        for (int i = 0; i < n_; ++i) f[i] = zero();
        for (std::size_t g = 0; g < groups_; ++g) {
            const auto& group = tables_->groups[g];
            sum_terms(0, g);
            f[group.equation] += with_own_factor(group, blend(0, g));
        }
        if (form_.empty()) return;
        form_.series(0, factors_, start_[0]);
        for (int i = 0; i < n_; ++i) f[i] += (1.0 - time_) * start_[0][i];
    }

    /// H(q, t) and its Jacobian; with a potential only the entries on and above the diagonal are set.
    void jacobian(const RuntimePoint<R>& q, const Time& t, auto& f, auto& j) {
        value(q, t, f);
        factors_.begin_slopes();
        for (int i = 0; i < n_; ++i)
            for (int u = 0; u < n_; ++u) j[i][u] = zero();
        if (!form_.empty()) {
            form_.slopes(factors_, j);
            for (int i = 0; i < n_; ++i)
                for (int u = 0; u < n_; ++u) j[i][u] = (1.0 - time_) * j[i][u];
        }
        multiply_slopes();
        for (std::size_t g = 0; g < groups_; ++g) {
            const auto& group = tables_->groups[g];
            if (moving_)
                add_slopes(group, blend(0, g), current(), [](const Z& entry) { return entry; }, j);
            else
                add_slopes(group, blend(0, g), target(), [this](const Z& entry) { return Z(time_ * entry); }, j);
        }
    }

    /// F(q), what H(q, 1) is, and its Jacobian, as of `jacobian`; nothing along a path may follow.
    void target_jacobian(const RuntimePoint<R>& q, auto& f, auto& j) {
        factors_.begin(q);
        factors_.begin_slopes();
        multiply_slopes();
        for (int i = 0; i < n_; ++i) {
            f[i] = zero();
            for (int u = 0; u < n_; ++u) j[i][u] = zero();
        }
        for (const auto& group : tables_->groups) {
            const Z sum = summed(0, group, target());
            f[group.equation] += with_own_factor(group, sum);
            add_slopes(group, sum, target(), [](const Z& entry) { return entry; }, j);
        }
    }

    /// The Taylor coefficient k of -H(q(t), t), given those of q(t) below k and taking its k-th as zero: the
    /// right-hand side of J q_k = ... Call with k = 1, 2, ... after `jacobian`, and `set_coefficient` in between.
    void taylor_right_side(int k, auto& f) {
        factors_.extend(k);
        for (int i = 0; i < n_; ++i) f[i] = zero();
        for (std::size_t g = 0; g < groups_; ++g) {
            const auto& group = tables_->groups[g];
            sum_terms(k, g);
            if (group.own_factor < 0)
                f[group.equation] -= blend(k, g);
            else
                for (int l = 0; l <= k; ++l) f[group.equation] -= factors_(l, group.own_factor) * blend(k - l, g);
        }
        if (form_.empty()) return;
        const auto order_k = static_cast<std::size_t>(k);
        form_.series(k, factors_, start_[order_k]);
        for (int i = 0; i < n_; ++i) f[i] -= (1.0 - time_) * start_[order_k][i] - start_[order_k - 1][i];
    }
    /// Tells the k-th Taylor coefficient of q(t), once solved for.
    void set_coefficient(int k, const auto& d) {
        factors_.complete(k, d);
        for (std::size_t g = 0; g < groups_; ++g) sum_terms(k, g);
        if (!form_.empty()) form_.series(k, factors_, start_[static_cast<std::size_t>(k)]);
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
    /// Times the group's own factor, where it has one.
    Z with_own_factor(const TermTables::Group& group, const Z& z) const {
        return group.own_factor < 0 ? z : Z(factors_(0, group.own_factor) * z);
    }
    Z& blend(int k, std::size_t g) { return blend_[static_cast<std::size_t>(k) * groups_ + g]; }

    /// Of the terms of a group: coefficient(term) times the operand's k-th.
    Z summed(int k, const TermTables::Group& group, const auto& coefficient) const {
        Z y = zero();
        for (int term = group.first; term < group.last; ++term) {
            const int operand = tables_->operand[static_cast<std::size_t>(term)];
            if (operand >= 0)
                y += coefficient(term) * factors_(k, operand);
            else if (k == 0)
                y = y + coefficient(term);
        }
        return y;
    }
    auto target() const {
        return [this](int term) { return number(h_->target(term)); };
    }
    auto current() const {
        return [this](int term) -> const Z& { return current_[static_cast<std::size_t>(term)]; };
    }
    template <int Law>
    auto law() const {
        return [this](int term) { return number(h_->template law<Law, R>(term, time_)); };
    }
    /// The group's share of order k, before it is multiplied by its own factor.
    void sum_terms(int k, std::size_t g) {
        const auto& group = tables_->groups[g];
        if (moving_) {
            sum(0, k, g) = blend(k, g) = summed(k, group, current());
            add_laws<1>(k, g);
        } else {
            sum(0, k, g) = summed(k, group, target());
            blend(k, g) = time_ * sum(0, k, g);
            if (k > 0) blend(k, g) += sum(0, k - 1, g);
        }
    }
    template <int Law>
    void add_laws(int k, std::size_t g) {
        if constexpr (Law <= H::law_order) {
            sum(Law, k, g) = summed(k, tables_->groups[g], law<Law>());
            if (k >= Law) blend(k, g) += sum(Law, k - Law, g);
            add_laws<Law + 1>(k, g);
        }
    }

    const Z& slope_of(int operand, int u) const {
        return operand < tables_->factors
                   ? factors_.slope(operand)
                   : node_slope_[static_cast<std::size_t>((operand - tables_->factors) * n_ + u)];
    }
    void multiply_slopes() {
        Z* slope = node_slope_.data();
        for (const auto& node : tables_->nodes) {
            for (const int u : tables_->unknowns[static_cast<std::size_t>(node.left)])
                slope[u] = slope_of(node.left, u) * factors_(0, node.right);
            slope[tables_->unknowns[static_cast<std::size_t>(node.right)].front()] =
                factors_(0, node.left) * factors_.slope(node.right);
            slope += n_;
        }
    }
    /// Adds a group's share of the Jacobian. sum: of its terms at the time, without their own factor; scaled: brings
    /// the sum of their slopes, which are by `coefficient`, to the time.
    void add_slopes(const TermTables::Group& group, const Z& sum, const auto& coefficient, const auto& scaled,
                    auto& j) {
        const int i = group.equation;
        if (group.own_factor >= 0) j[i][i] += factors_.slope(group.own_factor) * sum;
        if (group.unknowns.empty()) return;
        for (const int u : group.unknowns) row_[u] = zero();
        for (int term = group.first; term < group.last; ++term) {
            const int operand = tables_->operand[static_cast<std::size_t>(term)];
            if (operand < 0) continue;
            for (const int u : tables_->unknowns[static_cast<std::size_t>(operand)])
                row_[u] += coefficient(term) * slope_of(operand, u);
        }
        for (const int u : group.unknowns)
            if (!symmetric_ || u >= i) j[i][u] += scaled(with_own_factor(group, row_[u]));
    }

    const H* h_;
    const TermTables* tables_;
    int n_;
    bool moving_, symmetric_;
    Time time_;
    FactorSeries<R> factors_;
    StartFormSeries<R> form_;
    std::size_t groups_;
    std::vector<Z> sum_, blend_, node_slope_;
    std::vector<Z> current_;                                   // where coefficients move
    SizedArray<Z, at_run_time> row_;                           // of the Jacobian, of one group
    std::array<SizedArray<Z, at_run_time>, order + 1> start_;  // the Taylor coefficients of G
};

}  // namespace equilibria::detail
