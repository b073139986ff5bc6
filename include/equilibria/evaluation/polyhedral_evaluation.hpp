/// \file
/// The evaluation of a polyhedral homotopy in complex angles,
///     H_i(theta, t) = sum_a c_ia exp(i a.theta + w_ia s(t)),
/// w being weights of the path's mixed cell, so that each lane has its own. Values, Jacobian and Taylor coefficients of
/// a term come from those of its exponent: m' = (exponent)' m.
///
/// The weights of a cell are scaled to the largest one, and s runs from -(e^rate - 1) to 0 as
///     s(t) = 1 - e^(rate (1 - t)):
/// a path's singularities are as far from s as the reciprocal of the largest weight whose term still acts there, about
/// |s| where s is large and 1 at the end, which are even steps of t.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <equilibria/core/aligned_vector.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/exponential.hpp>
#include <equilibria/core/lanes.hpp>
#include <equilibria/evaluation/laurent_tables.hpp>
#include <equilibria/evaluation/point.hpp>

namespace equilibria::detail {

/// H: `tables()`, a LaurentTables; of each path `weights(path)`, one a term, in [0, 1], and `rate(path)`.
template <class H, class R, class Time>
class PolyhedralEvaluation {
public:
    using Z = Complex<R>;
    static constexpr int order = 3;

    explicit PolyhedralEvaluation(const H& h)
        : h_(&h), tables_(&h.tables()), n_(tables_->unknowns()), weight_(terms()), coefficient_(terms()),
          current_(terms()), monomial_(static_cast<std::size_t>(tables_->monomials())), slope_(monomial_.size()) {
        for (int u = 0; u < n_; ++u) {
            first_power_.push_back(powers_.size());
            powers_.resize(powers_.size() + at(tables_->highest[at(u)] - tables_->lowest[at(u)] + 1));
        }
        for (auto& coefficient : term_) coefficient.resize(terms());
        for (auto& coefficient : exponent_) coefficient.resize(terms());
        for (std::size_t k = 0; k < terms(); ++k) {
            const std::complex<double> c = tables_->terms[k].coefficient;
            coefficient_[k] = std::complex<Scalar>(static_cast<Scalar>(c.real()), static_cast<Scalar>(c.imag()));
        }
    }

    /// As of TableEvaluation.
    static constexpr bool symmetric() { return false; }

    /// The lane goes along this path from now on.
    void enter(int lane, std::uint64_t path) {
        const auto weights = h_->weights(path);
        for (std::size_t k = 0; k < terms(); ++k) set_lane(weight_[k], lane, static_cast<Scalar>(weights[k]));
        set_lane(rate_, lane, static_cast<Scalar>(h_->rate(path)));
        stale_ = true;
    }
    /// The lane goes with another.
    void repeat(int lane, int other) {
        for (R& w : weight_) set_lane(w, lane, equilibria::lane(w, other));
        set_lane(rate_, lane, equilibria::lane(rate_, other));
        stale_ = true;
    }

    /// H(q, t).
    void value(const RuntimePoint<R>& q, const Time& t, auto& f) {
        set_time(t);
        set_terms(q, current_);
        sum(term_[0], f, 1);
    }
    /// H(q, t) and its Jacobian.
    void jacobian(const RuntimePoint<R>& q, const Time& t, auto& f, auto& j) {
        value(q, t, f);
        set_jacobian(j);
    }
    /// At t = 1.
    void target_value(const RuntimePoint<R>& q, auto& f) {
        set_terms(q, coefficient_);
        sum(term_[0], f, 1);
    }
    void target_jacobian(const RuntimePoint<R>& q, auto& f, auto& j) {
        target_value(q, f);
        set_jacobian(j);
    }

    /// The Taylor coefficient k of -H(q(t), t), given those of q(t) below k and taking its k-th as zero. Call with k =
    /// 1, 2, 3 after `jacobian`, and `set_coefficient` in between.
    void taylor_right_side(int k, auto& f) {
        // s_k = -(-rate)^k / k! * e^(rate (1 - t))
        slowness_ = k == 1 ? growth_ * rate_ : (-1.0 / k) * (slowness_ * rate_);
        auto& last = term_[at(k)];
        for (std::size_t m = 0; m < terms(); ++m) {
            const R own = weight_[m] * slowness_;
            Z y = own * term_[0][m];
            if (k > 1) {
                Z before = exponent_[0][m] * term_[at(k - 1)][m];
                if (k == 3) before += 2.0 * (exponent_[1][m] * term_[1][m]);
                y += (1.0 / k) * before;
            }
            last[m] = y;
            if (k < order) exponent_[at(k - 1)][m] = Z(own, R{});
        }
        sum(last, f, -1);
    }
    /// Tells the k-th Taylor coefficient of q(t), once solved for.
    void set_coefficient(int k, const auto& d) {
        for (std::size_t m = 0; m < monomial_.size(); ++m) {
            Z y = Z(R{}, R{});
            for (const auto& f : tables_->factors_of(static_cast<int>(m)))
                y += static_cast<double>(f.power) * d[f.unknown];
            slope_[m] = Z(-y.im, y.re);
        }
        for (std::size_t m = 0; m < terms(); ++m) {
            const Z& by = slope_[at(tables_->terms[m].monomial)];
            exponent_[at(k - 1)][m] += by;
            term_[at(k)][m] += by * term_[0][m];
        }
    }

private:
    using Scalar = typename LaneTraits<R>::Scalar;
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    std::size_t terms() const { return tables_->terms.size(); }

    void set_time(const R& t) {
        if (!stale_ && all_lanes(mask_and(mask_not(t < time_), mask_not(time_ < t)))) return;
        time_ = t;
        stale_ = false;
        growth_ = exponential(R(rate_ * (1.0 - t)));
        const R s = 1.0 - growth_;
        for (std::size_t k = 0; k < terms(); ++k) {
            const R size = exponential(R(weight_[k] * s));
            current_[k] = Z(size * coefficient_[k].real(), size * coefficient_[k].imag());
        }
    }
    void set_monomials(const RuntimePoint<R>& q) {
        for (int u = 0; u < n_; ++u) {
            const auto [z, by] = exponentials(q.c[u], q.s[u]);
            Z* const power = powers_.data() + first_power_[at(u)] - tables_->lowest[at(u)];
            power[0] = Z(broadcast<R>(1.0), R{});
            for (int k = 1; k <= tables_->highest[at(u)]; ++k) power[k] = k == 1 ? z : Z(power[k - 1] * z);
            for (int k = -1; k >= tables_->lowest[at(u)]; --k) power[k] = k == -1 ? by : Z(power[k + 1] * by);
        }
        for (std::size_t m = 0; m < monomial_.size(); ++m) {
            const auto factors = tables_->factors_of(static_cast<int>(m));
            if (factors.empty()) {
                monomial_[m] = Z(broadcast<R>(1.0), R{});
                continue;
            }
            monomial_[m] = power_of(factors[0]);
            for (std::size_t k = 1; k < factors.size(); ++k) monomial_[m] *= power_of(factors[k]);
        }
    }
    const Z& power_of(const LaurentTables::Factor& f) const {
        return powers_[first_power_[at(f.unknown)] + at(f.power - tables_->lowest[at(f.unknown)])];
    }
    void set_terms(const RuntimePoint<R>& q, const auto& coefficients) {
        set_monomials(q);
        for (std::size_t k = 0; k < terms(); ++k) {
            const Z& monomial = monomial_[at(tables_->terms[k].monomial)];
            if constexpr (std::is_same_v<std::decay_t<decltype(coefficients[k])>, Z>)
                term_[0][k] = coefficients[k] * monomial;
            else
                term_[0][k] = Z(monomial.re * coefficients[k].real() - monomial.im * coefficients[k].imag(),
                                monomial.re * coefficients[k].imag() + monomial.im * coefficients[k].real());
        }
    }
    /// The sums of the terms of each equation, times a sign.
    void sum(const AlignedVector<Z>& of, auto& f, int sign) const {
        for (int i = 0; i < n_; ++i) {
            Z y = of[at(tables_->first_term[at(i)])];
            for (int k = tables_->first_term[at(i)] + 1; k < tables_->first_term[at(i + 1)]; ++k) y += of[at(k)];
            f[i] = sign < 0 ? Z(-y) : y;
        }
    }
    void set_jacobian(auto& j) const {
        for (int i = 0; i < n_; ++i) {
            for (int u = 0; u < n_; ++u) j[i][u] = Z(R{}, R{});
            for (int k = tables_->first_term[at(i)]; k < tables_->first_term[at(i + 1)]; ++k) {
                const Z& y = term_[0][at(k)];
                for (const auto& f : tables_->factors_of(tables_->terms[at(k)].monomial))
                    j[i][f.unknown] += static_cast<double>(f.power) * Z(-y.im, y.re);
            }
        }
    }

    const H* h_;
    const LaurentTables* tables_;
    int n_;
    AlignedVector<R> weight_;
    std::vector<std::complex<Scalar>> coefficient_;
    AlignedVector<Z> current_;  // coefficients at the time
    AlignedVector<Z> monomial_, slope_, powers_;
    std::vector<std::size_t> first_power_;
    std::array<AlignedVector<Z>, order + 1> term_;      // Taylor coefficients of the terms, from 0 on
    std::array<AlignedVector<Z>, order - 1> exponent_;  // of their exponents, from 1 on
    R rate_{}, time_{}, growth_{}, slowness_{};         // growth: e^(rate (1 - t)); slowness: of s
    bool stale_ = true;
};

}  // namespace equilibria::detail
