/// \file
/// The evaluation of a homotopy by loops over the tables of its terms: H(q, t), its Jacobian in q, its Taylor
/// coefficients along a path.
///
/// What the target's terms and their law of time give is summed here; what the start adds in a form of its own, here
/// (1-t) G, is evaluated by StartFormSeries.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/aligned_vector.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/static_for.hpp>
#include <equilibria/evaluation/factor_series.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/evaluation/start_form_series.hpp>
#include <equilibria/evaluation/term_tables.hpp>

namespace equilibria::detail {

/// H: `tables()`, `forms()`, `symmetric()`, `target(term)` at t = 1 (`complex_target(term)` of a Laurent system), and
/// where the coefficients are `moving()`, as those of a Laurent system are, `law<l>(term, t)`, the Taylor coefficient l
/// in t of the term's coefficient, l up to H::law_order.
template <class H, class R, class Time>
class TableEvaluation {
public:
    using Z = Complex<R>;
    static constexpr int order = FactorSeries<R>::order;
    static constexpr bool keeps_laws = H::law_order > 1;
    /// Whether R has more digits than the coefficients. Then the Jacobian of a gradient has all its entries: from
    /// rounded coefficients it is symmetric to double precision alone.
    static constexpr bool more_digits = !std::is_floating_point_v<typename LaneTraits<R>::Scalar>;

    explicit TableEvaluation(const H& h)
        : h_(&h), tables_(&h.tables()), n_(tables_->sizes.unknowns), moving_(h.moving()),
          symmetric_(h.symmetric() && !more_digits), factors_(*tables_), form_(h.forms(), *tables_),
          groups_(tables_->groups.size()), start_(groups_),
          sum_(static_cast<std::size_t>(moving_ ? H::law_order + 1 : 1) * (order + 1) * groups_),
          blend_((order + 1) * groups_), current_(moving_ ? tables_->operand.size() : 0),
          higher_(keeps_laws ? H::law_order * current_.size() : 0) {
        by_share_.reserve(tables_->shares.size());
        for (const auto& share : tables_->shares) by_share_.push_back(static_cast<Constant>(h.target(share.term)));
        for (const auto& t : h.forms().terms) {
            const int own = tables_->factor(t.equation, t.code);
            for (int g = first_group(t.equation); g < first_group(t.equation + 1); ++g)
                if (group(g).own_factor == own)
                    start_[static_cast<std::size_t>(g)] += std::complex<Constant>(t.coefficient);
        }
        if (form_.empty()) return;
        for (auto& g : products_) g = SizedArray<Z, at_run_time>(n_);
    }

    /// H(q, t).
    void value(const RuntimePoint<R>& q, const Time& t, auto& f) {
        begin<0>(q, t, f, [&]<bool moving>(std::bool_constant<moving>, int g, const Sums<moving>& sums) {
            return blended<moving>(0, g, sums);
        });
    }

    /// Whether the Jacobian is symmetric, and only its entries on and above the diagonal are set.
    bool symmetric() const { return symmetric_; }

    /// H(q, t) and its Jacobian.
    void jacobian(const RuntimePoint<R>& q, const Time& t, auto& f, auto& j) {
        set_higher_laws(t);
        begin<H::law_order>(q, t, f, [&]<bool moving>(std::bool_constant<moving>, int g, const Sums<moving>& sums) {
            return keep<moving>(0, g, sums);
        });
        factors_.begin_slopes();
        if (moving_)
            set_slopes(blends(0), current(), [](const Z& z) -> const Z& { return z; }, j);
        else
            set_slopes(blends(0), target(), [this](const Z& z) { return Z(time_ * z); }, j);
        if (form_.empty()) return;
        RuntimeMatrix<Z> of_form(n_);
        form_.slopes(factors_, of_form);
        for (int i = 0; i < n_; ++i)
            for (int u = symmetric_ ? i : 0; u < n_; ++u) j[i][u] += (1.0 - time_) * of_form[i][u];
    }

    /// F(q), what H(q, 1) is; nothing along a path may follow.
    void target_value(const RuntimePoint<R>& q, auto& f) {
        if (!tables_->laurent)
            return target_value(q, f, target(),
                                [this](int term) { return number(static_cast<Constant>(h_->target(term))); });
        for (std::size_t k = 0; k < current_.size(); ++k)
            current_[k] = broadcast_complex<R>(h_->complex_target(static_cast<int>(k)));
        target_value(q, f, current(),
                     [this](int term) -> const Z& { return current_[static_cast<std::size_t>(term)]; });
    }
    /// And its Jacobian, as of `jacobian`.
    void target_jacobian(const RuntimePoint<R>& q, auto& f, auto& j) {
        target_value(q, f);
        factors_.begin_slopes();
        const auto as_it_is = [](const Z& z) -> const Z& { return z; };
        if (tables_->laurent)
            set_slopes(kept_sums(0, 0), current(), as_it_is, j);
        else
            set_slopes(kept_sums(0, 0), target(), as_it_is, j);
    }

    /// The Taylor coefficient k of -H(q(t), t), given those of q(t) below k and taking its k-th as zero: the
    /// right-hand side of J q_k = ... Call with k = 1, 2, ... after `jacobian`, and `set_coefficient` in between.
    void taylor_right_side(int k, auto& f) {
        factors_.extend(k);
        for_equations([&](int i, auto moving) {
            Z y = zero();
            for (int g = first_group(i); g < first_group(i + 1); ++g) {
                // the path rests at order 1, and so do the factors
                const auto sum = k == 1 ? Sums<moving>() : sums<moving>(k, group(g));
                const Z blend = blended<moving>(k, g, sum);
                const int own = group(g).own_factor;
                if (own < 0) {
                    y -= blend;
                    continue;
                }
                const Z *factor = factors_.values(0) + own, *other = blends(k) + g;
                Z z = *factor * blend;
                for (int l = 1; l <= k; ++l) {
                    factor += factors_.size();
                    other -= groups_;
                    z += *factor * *other;
                }
                y -= z;
            }
            f[i] = y;
        });
        if (form_.empty()) return;
        const auto order_k = static_cast<std::size_t>(k);
        form_.series(k, factors_, products_[order_k]);
        for (int i = 0; i < n_; ++i) f[i] -= (1.0 - time_) * products_[order_k][i] - products_[order_k - 1][i];
    }
    /// Tells the k-th Taylor coefficient of q(t), once solved for.
    void set_coefficient(int k, const auto& d) {
        factors_.complete(k, d);
        for_equations([&](int i, auto moving) {
            for (int g = first_group(i); g < first_group(i + 1); ++g) keep<moving>(k, g, sums<moving>(k, group(g)));
        });
        if (!form_.empty()) form_.series(k, factors_, products_[static_cast<std::size_t>(k)]);
    }

private:
    using Group = TermTables::Group;
    using Constant = std::conditional_t<is_single<R>, float, double>;  // which the tables hold
    /// Of a group: the sums over its terms of the Taylor coefficients 0, 1, .. of the term's coefficient, each times
    /// the same Taylor coefficient of the operand. Where coefficients do not move, there is the target's alone.
    template <bool Moving>
    using Sums = std::array<Z, Moving ? H::law_order + 1 : 1>;

    static Z zero() { return {broadcast<R>(0.0), broadcast<R>(0.0)}; }
    static auto number(Constant a) { return broadcast<R>(a); }
    template <class A>
    static auto number(const std::complex<A>& a) {
        return broadcast_complex<R>(a);
    }
    static Z number(const Z& a) { return a; }

    int first_group(int equation) const { return tables_->first_group[static_cast<std::size_t>(equation)]; }
    const Group& group(int g) const { return tables_->groups[static_cast<std::size_t>(g)]; }
    /// Calls work(i, std::bool_constant<whether the coefficients move>) for each equation.
    void for_equations(auto&& work) const {
        if (moving_)
            for (int i = 0; i < n_; ++i) work(i, std::true_type());
        else
            for (int i = 0; i < n_; ++i) work(i, std::false_type());
    }

    /// The Taylor coefficients of the laws, where there are several: each is used at every order of the path.
    void set_higher_laws(const Time& t) {
        if constexpr (keeps_laws)
            static_for<H::law_order>([&](auto law) {
                Z* const of = higher_.data() + law * current_.size();
                for (std::size_t k = 0; k < current_.size(); ++k)
                    of[k] = number(h_->template law<law + 1, R>(static_cast<int>(k), t));
            });
    }

    /// H(q, t); blend(moving, g, sums) gives the blend of group g, of which the sums up to that law are set.
    template <int Laws>
    void begin(const RuntimePoint<R>& q, const Time& t, auto& f, const auto& blend) {
        time_ = t;
        factors_.begin(q);
        for (std::size_t k = 0; k < current_.size(); ++k) current_[k] = h_->template law<0, R>(static_cast<int>(k), t);
        for_equations([&](int i, auto moving) {
            Z y = zero();
            for (int g = first_group(i); g < first_group(i + 1); ++g)
                y += with_own_factor(group(g), blend(moving, g, sums<moving, Laws>(0, group(g))));
            f[i] = y;
        });
        if (form_.empty()) return;
        form_.series(0, factors_, products_[0]);
        for (int i = 0; i < n_; ++i) f[i] += (1.0 - time_) * products_[0][i];
    }

    void target_value(const RuntimePoint<R>& q, auto& f, const auto& of_share, const auto& of_term) {
        factors_.begin(q);
        Z* const sum = kept_sums(0, 0);
        for (int i = 0; i < n_; ++i) {
            f[i] = zero();
            for (int g = first_group(i); g < first_group(i + 1); ++g) {
                sum[g] = total(group(g), factors_.values(0), of_share);
                if (group(g).constant >= 0) sum[g] = sum[g] + of_term(group(g).constant);
                f[i] += with_own_factor(group(g), sum[g]);
            }
        }
    }

    /// The sums of each group, by law and order.
    Z* kept_sums(int law, int k) {
        return sum_.data() + (static_cast<std::size_t>(law) * (order + 1) + static_cast<std::size_t>(k)) * groups_;
    }
    /// The Taylor coefficient k of what multiplies each group's own factor.
    Z* blends(int k) { return blend_.data() + static_cast<std::size_t>(k) * groups_; }
    /// Times the group's own factor, where it has one.
    Z with_own_factor(const Group& group, const Z& z) const {
        return group.own_factor < 0 ? z : Z(factors_(0, group.own_factor) * z);
    }

    /// Of the shares of a group, or of a derivative: the sum of coefficient(share) times the factor.
    Z total(const auto& of, const Z* factor, const auto& coefficient) const {
        const TermTables::Share* const share = tables_->shares.data();
        const auto summand = [&](int m) { return Z(coefficient(m) * factor[share[m].factor]); };
        int m = of.first;
        if (m == of.last) return zero();
        Z y = summand(m);
        if (++m == of.last) return y;
        Z z = summand(m);  // two sums: each addition waits for the one before it
        for (++m; m + 1 < of.last; m += 2) {
            y += summand(m);
            z += summand(m + 1);
        }
        if (m < of.last) y += summand(m);
        return y + z;
    }
    /// Coefficients of shares, by their numbers.
    auto target() const {
        return [of = by_share_.data()](int share) { return number(of[share]); };
    }
    auto current() const {
        return
            [of = current_.data(), at = tables_->shares.data()](int share) -> const Z& { return of[at[share].term]; };
    }

    template <bool Moving, int Laws = H::law_order>
    Sums<Moving> sums(int k, const Group& group) const {
        if constexpr (!Moving) {
            Z y = total(group, factors_.values(k), target());
            if (k == 0 && group.constant >= 0) y = y + number(static_cast<Constant>(h_->target(group.constant)));
            return {y};
        } else {
            return [&]<int... law>(std::integer_sequence<int, law...>) -> Sums<Moving> {
                const auto coefficient = [&]<int of>(std::integral_constant<int, of>, int term) -> decltype(auto) {
                    if constexpr (of == 0)
                        return current_[static_cast<std::size_t>(term)];
                    else if constexpr (keeps_laws)
                        return static_cast<const Z&>(
                            higher_[(of - 1) * current_.size() + static_cast<std::size_t>(term)]);
                    else
                        return number(h_->template law<of, R>(term, time_));
                };
                Sums<Moving> y{};
                ((y[law] = zero()), ...);
                const TermTables::Share* const last = tables_->shares.data() + group.last;
                for (const auto* share = tables_->shares.data() + group.first; share != last; ++share) {
                    const Z& factor = factors_(k, share->factor);
                    ((y[law] += coefficient(std::integral_constant<int, law>(), share->term) * factor), ...);
                }
                if (k == 0 && group.constant >= 0)
                    ((y[law] = y[law] + coefficient(std::integral_constant<int, law>(), group.constant)), ...);
                return y;
            }(std::make_integer_sequence<int, Laws + 1>());
        }
    }
    /// The blend of order k: with those sums, and what is kept of lower orders.
    template <bool Moving>
    Z blended(int k, int g, const Sums<Moving>& sums) {
        Z y;
        if constexpr (Moving) {
            y = sums[0];
            for (int l = 1; l <= std::min(k, H::law_order); ++l) y += kept_sums(l, k - l)[g];
        } else {
            y = time_ * sums[0];
            if (k > 0) y += kept_sums(0, k - 1)[g];
        }
        if (k > 1) return y;
        const std::complex<Constant>& start = start_[static_cast<std::size_t>(g)];
        if (start == std::complex<Constant>()) return y;
        if (k == 0)
            y += (1.0 - time_) * broadcast_complex<R>(start);
        else
            y -= broadcast_complex<R>(start);
        return y;
    }
    /// And keeps both.
    template <bool Moving>
    Z keep(int k, int g, const Sums<Moving>& sums) {
        for (std::size_t l = 0; l < sums.size(); ++l) kept_sums(static_cast<int>(l), k)[g] = sums[l];
        return blends(k)[g] = blended<Moving>(k, g, sums);
    }

    /// The Jacobian. sum: of each group, of its terms at the time; at_time(z): times what the sums of their slopes,
    /// which are by `coefficient`, have to be multiplied by.
    void set_slopes(const Z* sum, const auto& coefficient, const auto& at_time, auto& j) const {
        for (int i = 0; i < n_; ++i) {
            Z y = zero();
            for (int g = first_group(i); g < first_group(i + 1); ++g)
                if (const int own = group(g).own_factor; own >= 0) y += factors_.slope(own) * sum[g];
            j[i][i] = y;
        }
        const auto* entry = tables_->entries.data();
        const auto* const last =
            entry + (symmetric_ ? tables_->entries_above : static_cast<int>(tables_->entries.size()));
        for (; entry != last; ++entry) {
            Z y = zero();
            for (int m = entry->first; m < entry->last; ++m) {
                const auto& by = tables_->derivatives[static_cast<std::size_t>(m)];
                const Z slope = total(by, factors_.slopes(), coefficient);
                if (by.own_factor < 0)
                    y += at_time(slope);
                else
                    y += at_time(factors_(0, by.own_factor)) * slope;
            }
            j[entry->equation][entry->unknown] = y;
        }
    }

    const H* h_;
    const TermTables* tables_;
    int n_;
    bool moving_, symmetric_;
    Time time_;
    FactorSeries<R> factors_;
    StartFormSeries<R> form_;
    std::size_t groups_;
    std::vector<std::complex<Constant>> start_;  // of each group: the coefficient of its own factor in G
    std::vector<Constant> by_share_;             // of each share: the target's coefficient
    AlignedVector<Z> sum_, blend_;
    AlignedVector<Z> current_;                                    // where coefficients move
    AlignedVector<Z> higher_;                                     // the laws 1, 2, .. at the time, by term
    std::array<SizedArray<Z, at_run_time>, order + 1> products_;  // the Taylor coefficients of the products of G
};

}  // namespace equilibria::detail
