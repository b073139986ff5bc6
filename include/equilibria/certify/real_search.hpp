/// \file
/// Branch and prune over the torus of real angles: a proof that systems have no real root beside those that
/// are known, for any parameters in their intervals. It needs no bound on the number of complex roots, and none of
/// them.
///
/// The torus is cut into boxes m + d, |d_u| <= r_u. With J and F_k, the derivatives by the unknowns and the parameters,
/// over the whole box and all parameters, any matrix Y and the parameters' distances |t_k| <= w_k from their middle,
///     |F(m)| > |J| r + sum |F_k| w_k,  or  |Y F(m)| > r + |1 - Y J| r + sum |Y F_k| w_k
/// in one component excludes a root (mean value theorem; the second one with Y the inverse of the midpoint of J). And
/// |1 - Y J| r < r makes F injective over the box, so that a known root in it is the only one. What is neither is cut
/// in two. Sources: Hansen, Walster, Global Optimization Using Interval Analysis, chapter 11; Neumaier, Interval
/// Methods for Systems of Equations, chapter 5.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <equilibria/certify/krawczyk_systems.hpp>

namespace equilibria {

/// All real angles with |theta_u - center_u| <= radius_u, in radians and up to whole turns.
template <int n>
struct AngleBox {
    Array<double, n> center, radius;

    /// That of the root which lane k of a test with real = true proves, for all parameters of the test.
    template <class M, class R>
    static AngleBox of(const KrawczykResult<R>& proof, const Point<M, R>& q, int k) {
        AngleBox y;
        for (int u = 0; u < n; ++u) {
            y.center[u] = std::atan2(lane(q.s[u].re, k), lane(q.c[u].re, k));
            y.radius[u] = rounded_up(lane(proof.radius[u], k) + angle_rounding);
        }
        return y;
    }
    /// Covers the rounding of angles up to a few turns, and of their sines and cosines.
    static constexpr double angle_rounding = 64 * std::numeric_limits<double>::epsilon();
};

/// What a search found: nothing but the known roots, or a box that it could not decide.
struct RealSearchResult {
    bool complete = false;  ///< there is no real root outside the boxes given
    std::size_t boxes = 0;  ///< that were examined
};

namespace detail {

template <class M, int N>
class RealSearch {
public:
    static constexpr int n = n_angles<M>;
    using Pack = Lanes<native_lanes>;
    using Box = AngleBox<n>;

    RealSearch(const BallSystems<M, double, N>& systems, const std::vector<Box>& roots, std::size_t most)
        : systems_(systems), roots_(roots), most_(most) {
        for (int k = 0; k < N; ++k) width_[k] = broadcast<Pack>(systems.half_width[k]);
    }

    RealSearchResult run() {
        RealSearchResult out;
        start();
        while (!open_.empty()) {
            if (out.boxes >= most_) return out;
            const std::size_t count = std::min(open_.size(), std::size_t{native_lanes});
            const std::vector<Box> batch(open_.end() - static_cast<std::ptrdiff_t>(count), open_.end());
            open_.resize(open_.size() - count);
            out.boxes += count;
            const Test test(*this, batch);
            std::vector<Box> joined;
            std::vector<std::size_t> joined_of;
            for (std::size_t k = 0; k < count; ++k)
                if (!test.excluded(k))
                    if (const auto hull = with_nearest_root(batch[k])) joined.push_back(*hull), joined_of.push_back(k);
            std::array<bool, native_lanes> only_root{};
            if (!joined.empty()) {
                const Test around(*this, joined);
                for (std::size_t k = 0; k < joined.size(); ++k) only_root[joined_of[k]] = around.injective(k);
            }
            for (std::size_t k = 0; k < count; ++k) {
                if (test.excluded(k) || only_root[k]) continue;
                if (test.hopeless(k)) return out;
                split(batch[k], test.longest(k));
            }
        }
        out.complete = true;
        return out;
    }

private:
    /// Up to a pack of boxes, examined together.
    class Test {
    public:
        Test(const RealSearch& search, const std::vector<Box>& boxes) {
            const auto& systems = search.systems_;
            Point<M, Pack> q;
            for (int u = 0; u < n; ++u)
                for (int k = 0; k < native_lanes; ++k) {
                    const Box& box = boxes[std::min(static_cast<std::size_t>(k), boxes.size() - 1)];
                    set_lane(q.c[u].re, k, std::cos(box.center[u]));
                    set_lane(q.s[u].re, k, std::sin(box.center[u]));
                    set_lane(q.c[u].im, k, 0.0);
                    set_lane(q.s[u].im, k, 0.0);
                    set_lane(r_[u], k, rounded_up(box.radius[u] + Box::angle_rounding));
                }
            const FactorBalls<Pack> at(systems.center, q, true), wide = at.widened(r_);
            Ball<Pack> f[n], j[n][n], g[N][n];
            ball_values(systems.center, at, f);
            ball_jacobian(systems.all, wide, j);
            for (int m = 0; m < N; ++m) ball_values(systems.derivative[static_cast<std::size_t>(m)], wide, g[m]);
            const Pack zero = Pack{} + 0.0;
            excluded_ = zero > zero;
            hopeless_ = injective_ = zero == zero;
            // plainly
            for (int i = 0; i < n; ++i) {
                Pack by_angle = zero, by_parameter = zero;
                for (int u = 0; u < n; ++u) {
                    slope_[i][u] = magnitude_bound(j[i][u]);
                    by_angle = by_angle + slope_[i][u] * r_[u];
                }
                for (int m = 0; m < N; ++m) by_parameter = by_parameter + magnitude_bound(g[m][i]) * search.width_[m];
                const Pack re = f[i].mid.re, size = lane_max(re, Pack(-re)) - f[i].rad;
                decide(size, by_angle, by_parameter);
                share_[i] = size / (by_angle + by_parameter);
            }
            // preconditioned
            Complex<Pack> middle[n][n], y[n][n];
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < n; ++c) middle[r][c] = j[r][c].mid;
            PivotedFactorization<Pack, n> lu;
            Complex<Pack> column[n];
            approximate_inverse(n, lu, middle, column, y);
            Pack size_y[n][n], e[n][n], part[n], by_parameter[n];
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < n; ++c) size_y[r][c] = rounded_up<Pack>(magnitude_bound(y[r][c]));
            contraction<Pack>(n, y, size_y, j, e);
            for (int u = 0; u < n; ++u) by_parameter[u] = zero;
            for (int m = 0; m < N; ++m) {
                product_bound<Pack>(n, y, size_y, g[m], part);
                for (int u = 0; u < n; ++u) by_parameter[u] = by_parameter[u] + part[u] * search.width_[m];
            }
            for (int u = 0; u < n; ++u) {
                Complex<Pack> sum(0.0);
                Pack error = zero, by_angle = zero;
                for (int k = 0; k < n; ++k) {
                    sum += y[u][k] * f[k].mid;
                    error = error + size_y[u][k] * (f[k].rad + sum_unit * magnitude_bound(f[k].mid));
                    by_angle = by_angle + e[u][k] * r_[k];
                }
                by_angle = rounded_up<Pack>(by_angle * (1 + sum_unit));
                injective_ = mask_and<Mask>(injective_, by_angle < r_[u]);
                decide(lane_max(sum.re, Pack(-sum.re)) - rounded_up<Pack>(error * (1 + sum_unit)), r_[u] + by_angle,
                       by_parameter[u]);
            }
        }

        /// No root for any parameters.
        bool excluded(std::size_t k) const { return mask_lane(excluded_, static_cast<int>(k)); }
        /// At most one root for each parameters.
        bool injective(std::size_t k) const { return mask_lane(injective_, static_cast<int>(k)); }
        /// The parameters' intervals alone prevent an exclusion, however small the box becomes.
        bool hopeless(std::size_t k) const { return mask_lane(hopeless_, static_cast<int>(k)); }
        /// The angle to cut: the one that widens the equation closest to an exclusion most.
        int longest(std::size_t lane_number) const {
            const int k = static_cast<int>(lane_number);
            int best = 0, u = 0;
            for (int i = 1; i < n; ++i)
                if (lane(share_[i], k) > lane(share_[best], k)) best = i;
            for (int v = 1; v < n; ++v)
                if (lane(slope_[best][v], k) * lane(r_[v], k) > lane(slope_[best][u], k) * lane(r_[u], k)) u = v;
            return u;
        }

    private:
        using Mask = typename LaneTraits<Pack>::Mask;
        static constexpr double sum_unit = (2 * n + 2 * N + 4) * std::numeric_limits<double>::epsilon();

        void decide(const Pack& size, const Pack& by_angle, const Pack& by_parameter) {
            excluded_ = mask_or(excluded_, size > rounded_up<Pack>((by_angle + by_parameter) * (1 + sum_unit)));
            hopeless_ = mask_and<Mask>(hopeless_, size + by_angle < by_parameter);
        }
        static Mask mask_or(const Mask& a, const Mask& b) { return mask_not(mask_and<Mask>(mask_not(a), mask_not(b))); }

        Pack r_[n], slope_[n][n], share_[n];
        Mask excluded_, hopeless_, injective_;
    };

    void start() {
        // the widest boxes over which cosines of the highest multiple are bounded
        Array<int, n> pieces;
        Box first;
        for (int u = 0; u < n; ++u) {
            pieces[u] = 8 * systems_.all.highest[u];
            first.radius[u] = rounded_up(std::numbers::pi / pieces[u]);
            first.center[u] = -std::numbers::pi + std::numbers::pi / pieces[u];
        }
        open_ = {first};
        for (int u = 0; u < n; ++u) {
            const std::size_t size = open_.size();
            for (int k = 1; k < pieces[u]; ++k)
                for (std::size_t b = 0; b < size; ++b) {
                    open_.push_back(open_[b]);
                    open_.back().center[u] += 2 * std::numbers::pi / pieces[u] * k;
                }
        }
    }

    /// The smallest box around the given one and the nearest known root.
    std::optional<Box> with_nearest_root(const Box& box) const {
        std::optional<Box> best;
        double nearest = 0;
        for (const Box& root : roots_) {
            Box near = root;
            double distance = -std::numbers::pi;
            for (int u = 0; u < n; ++u) {
                constexpr double turn = 2 * std::numbers::pi;
                near.center[u] -= turn * std::round((near.center[u] - box.center[u]) / turn);
                distance = std::max(distance, std::abs(near.center[u] - box.center[u]) - near.radius[u]);
            }
            if (best && distance >= nearest) continue;
            nearest = distance;
            best = hull(box, near);
        }
        return best;
    }
    static Box hull(const Box& a, const Box& b) {
        Box y;
        for (int u = 0; u < n; ++u) {
            const double low = std::min(a.center[u] - a.radius[u], b.center[u] - b.radius[u]),
                         high = std::max(a.center[u] + a.radius[u], b.center[u] + b.radius[u]);
            y.center[u] = low + (high - low) / 2;
            y.radius[u] = (high - low) / 2 + Box::angle_rounding;
        }
        return y;
    }
    void split(const Box& box, int u) {
        for (const int side : {-1, 1}) {
            Box half = box;
            half.radius[u] = rounded_up(box.radius[u] / 2);
            half.center[u] += side * box.radius[u] / 2;
            open_.push_back(half);
        }
    }

    const BallSystems<M, double, N>& systems_;
    const std::vector<Box>& roots_;
    std::size_t most_;
    Pack width_[N];
    std::vector<Box> open_;
};

}  // namespace detail

/// Whether systems in angles have no real roots but one in each of the given boxes, for all their
/// parameters. The boxes hold proved roots and are disjoint; at most `most` boxes are examined.
template <Model M, int N>
requires(n_coordinates<M> == 0)
RealSearchResult search_real_roots(const BallSystems<M, double, N>& systems,
                                   const std::vector<AngleBox<n_angles<M>>>& roots, std::size_t most) {
    return detail::RealSearch<M, N>(systems, roots, most).run();
}

}  // namespace equilibria
