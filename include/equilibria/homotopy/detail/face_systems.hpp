/// \file
/// Face systems at infinity: the terms of each equation that grow fastest along a direction, and their roots. See
/// homotopy/path_limit.hpp.
///
/// Source: D. N. Bernstein, The number of roots of a system of equations, Functional Analysis and its Applications 9
/// (1975) 183-185.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SVD>

#include <equilibria/core/singular_values.hpp>
#include <equilibria/homotopy/detail/logarithmic_homotopy.hpp>

namespace equilibria::detail {

/// A root of a face system next to a path.
struct FaceRoot {
    std::vector<double> direction;  ///< growth of log |z| along it, rational
    double residual = 0;            ///< of the leading terms, against their size
    bool multiple = false;          ///< next to a multiple root far roots may be hidden
};

/// Finds the roots of face systems next to points of a path.
template <class R>
class FaceSystems : public LogarithmicHomotopy<R> {
public:
    using Base = LogarithmicHomotopy<R>;
    using typename Base::Z;
    using Base::vanishing;
    /// The logarithm of the size from which on it is believed to go to a multiple root at infinity.
    static constexpr double multiple_size = 100;

    using Base::Base;

protected:
    using Base::angles_, Base::at, Base::columns_, Base::from_, Base::linearize, Base::n_, Base::terms_, Base::to_;

    /// The root of the terms that grow fastest next to the point z at 1 - t = r, s = -log r; nothing where they do not
    /// vanish together there. v: the growth of the unknowns. tolerance: of growth, within which terms lead.
    std::optional<FaceRoot> leading_root(const std::vector<double>& v, double tolerance, const std::vector<Z>& z,
                                         const R& r, double s) {
        // growth of each term; r itself, whose coefficient an absent term has, shrinks
        const std::size_t size = columns_->size();
        const auto rate = [&](std::size_t k, const std::vector<double>& w) {
            const LaurentColumn& c = (*columns_)[k];
            double y = c.to == 0.0 ? -1 : 0;
            for (std::size_t u = 0; u < at(n_); ++u) y += c.exponents[u] * w[u];
            return y;
        };
        std::vector<double> most(at(n_), -1e300);
        for (std::size_t k = 0; k < size; ++k) {
            auto& m = most[at((*columns_)[k].equation)];
            m = std::max(m, rate(k, v));
        }
        std::vector<char> leads(size);
        std::vector<std::size_t> first(at(n_), size);
        std::vector<int> count(at(n_));
        for (std::size_t k = 0; k < size; ++k) {
            const auto i = at((*columns_)[k].equation);
            leads[k] = rate(k, v) > most[i] - tolerance;
            if (!leads[k]) continue;
            ++count[i];
            if (first[i] == size) first[i] = k;
        }
        if (std::ranges::any_of(count, [](int c) { return c < 2; })) return {};
        // the direction nearest to v along which all of them grow alike
        std::vector<std::pair<std::size_t, std::size_t>> equal;
        for (std::size_t k = 0; k < size; ++k)
            if (const auto i = at((*columns_)[k].equation); leads[k] && k != first[i]) equal.emplace_back(k, first[i]);
        Eigen::MatrixXd a(static_cast<Eigen::Index>(equal.size()), n_);
        Eigen::VectorXd b(a.rows());
        for (std::size_t m = 0; m < equal.size(); ++m) {
            const auto [k, l] = equal[m];
            const auto row = static_cast<Eigen::Index>(m);
            for (int u = 0; u < n_; ++u) a(row, u) = (*columns_)[k].exponents[at(u)] - (*columns_)[l].exponents[at(u)];
            b(row) = -(rate(k, v) - rate(l, v));
        }
        Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
        svd.setThreshold(1e-9);
        const Eigen::VectorXd change = svd.solve(b);
        if (!((a * change - b).lpNorm<Eigen::Infinity>() < 1e-9) || !(change.lpNorm<Eigen::Infinity>() < 0.1))
            return {};
        std::vector<double> w = v;
        for (std::size_t u = 0; u < w.size(); ++u) w[u] += change(static_cast<Eigen::Index>(u));
        if (!make_rational(w)) return {};
        bool away = false;
        for (std::size_t u = 0; u < w.size(); ++u)
            away = away || (u < at(angles_) ? std::abs(w[u]) > 1e-6 : w[u] > 1e-6);
        if (!away) return {};
        // far enough for the leading terms to lead
        if (s * farthest(w) < 16) return {};
        // the leading terms grow alike, the others must fall behind
        for (std::size_t k = 0; k < size; ++k) {
            const auto i = at((*columns_)[k].equation);
            if (leads[k] && !(std::abs(rate(k, w) - rate(first[i], w)) < 1e-9)) return {};
            if (!leads[k] && !(rate(k, w) < rate(first[i], w) - 1e-6)) return {};
        }
        return vanishing_terms(leads, w, z, r, s);
    }
    static double farthest(const std::vector<double>& w) {
        double y = 0;
        for (const double x : w) y = std::max(y, std::abs(x));
        return y;
    }
    std::optional<FaceRoot> vanishing_terms(const std::vector<char>& leads, const std::vector<double>& w,
                                            const std::vector<Z>& z, const R& r, double s) {
        std::vector<Z> q = z;
        double moved = 0, before = 1e300;
        for (int round = 0; round < 150; ++round) {
            if (!linearize(q, r)) return {};
            // the equations of the leading terms alone
            std::vector<double> behind(at(n_)), ahead(at(n_));
            std::vector<Z> face(at(n_), Z(0.0));
            SingularValues::Vector j(at(n_ * n_)), of_terms(at(n_ * n_)), right(at(n_));
            for (std::size_t k = 0; k < columns_->size(); ++k) {
                const LaurentColumn& c = (*columns_)[k];
                const auto i = at(c.equation);
                const auto size = std::abs(rounded(terms_[k]));
                if (!leads[k]) {
                    behind[i] += size;
                    continue;
                }
                // its coefficient in the limit
                const Z limit = c.to == 0.0 ? terms_[k] : terms_[k] * (to_[k] / (to_[k] + r * (from_[k] - to_[k])));
                ahead[i] += size;
                face[i] += limit;
                for (std::size_t u = 0; u < at(n_); ++u)
                    j[u * at(n_) + i] += static_cast<double>(c.exponents[u]) * rounded(limit);
            }
            double residual = 0;
            for (std::size_t i = 0; i < at(n_); ++i) {
                if (round == 0 && !(behind[i] < 0.3 * ahead[i])) return {};
                residual = std::max(residual, std::abs(rounded(face[i])) / ahead[i]);
                for (std::size_t u = 0; u < at(n_); ++u) of_terms[u * at(n_) + i] = j[u * at(n_) + i] / ahead[i];
                // rows of one size: next to a multiple root they are small
                double row = 0;
                for (std::size_t u = 0; u < at(n_); ++u) row = std::max(row, std::abs(j[u * at(n_) + i]));
                if (!(row > 0)) continue;
                right[i] = rounded(face[i]) / row;
                for (std::size_t u = 0; u < at(n_); ++u) j[u * at(n_) + i] /= row;
            }
            if (round == 0 && !(residual < 0.3)) return {};
            if (residual < vanishing) {
                // near a multiple root at infinity there may be roots that are merely far away: 1e16 and more out,
                // where coefficients are rounded
                if (s * farthest(w) < multiple_size) {
                    const SingularValues regular(n_, n_, std::move(of_terms));
                    int rank = 0;
                    while (rank < n_ && regular[rank] > 1e-6) ++rank;
                    if (rank < n_ - 1) return FaceRoot{w, residual, true};
                }
                return FaceRoot{w, residual, false};
            }
            if (round > 10 && residual > 0.98 * before) return {};
            before = residual;
            const SingularValues svd(n_, n_, std::move(j));
            const auto step = svd.solve(right, svd.rank(1e-9));
            for (std::size_t u = 0; u < at(n_); ++u) {
                if (!(std::abs(step[u]) < 0.5)) return {};
                moved += std::abs(step[u]);
                q[u] *= Z(1.0) - Z(R(step[u].real()), R(step[u].imag()));
            }
            if (!(moved < 0.7)) return {};
        }
        return {};
    }

private:
    /// The fractions of one small denominator that v are nearly; whether there are any.
    static bool make_rational(std::vector<double>& v) {
        for (int by = 1; by <= 24; ++by) {
            if (!std::ranges::all_of(v, [by](double x) { return std::abs(x - std::round(by * x) / by) < 2e-3; }))
                continue;
            for (double& x : v) x = std::round(by * x) / by;
            return true;
        }
        return false;
    }
};

}  // namespace equilibria::detail
