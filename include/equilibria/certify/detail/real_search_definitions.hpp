/// \file
/// See certify/real_search.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include <equilibria/certify/real_search.hpp>

namespace equilibria::detail {

/// Boxes side by side, centre and radius of each angle in turn: there are many of them.
class BoxStack {
public:
    explicit BoxStack(int n) : n_(n) {}

    std::size_t size() const { return numbers_.size() / at(2 * n_); }
    double& center(std::size_t box, int u) { return numbers_[box * at(2 * n_) + at(u)]; }
    double& radius(std::size_t box, int u) { return numbers_[box * at(2 * n_) + at(n_ + u)]; }
    double center(std::size_t box, int u) const { return numbers_[box * at(2 * n_) + at(u)]; }
    double radius(std::size_t box, int u) const { return numbers_[box * at(2 * n_) + at(n_ + u)]; }
    /// A copy of one of another stack, or of this one.
    void push(const BoxStack& other, std::size_t box) {
        numbers_.resize(numbers_.size() + at(2 * n_));
        std::copy_n(other.numbers_.begin() + static_cast<std::ptrdiff_t>(box * at(2 * n_)), 2 * n_,
                    numbers_.end() - 2 * n_);
    }
    /// One of zeros.
    void push() { numbers_.resize(numbers_.size() + at(2 * n_)); }
    void resize(std::size_t boxes) { numbers_.resize(boxes * at(2 * n_)); }
    void clear() { numbers_.clear(); }

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }

    int n_;
    std::vector<double> numbers_;
};

/// Up to a pack of boxes, examined together.
class BoxTest {
public:
    using Pack = Lanes<native_lanes>;

    explicit BoxTest(const BallSystems<double>& systems)
        : systems_(systems), n_(systems.all.sizes.unknowns),
          sum_unit_((2 * n_ + 2 * systems.varied() + 4) * std::numeric_limits<double>::epsilon()),
          q_(point_of_zeros<RuntimeUnknowns, Pack>(systems.all.sizes)), at_(systems.center), wide_(systems.center),
          f_(n_), j_(n_), g_(static_cast<std::size_t>(systems.varied()), RuntimeArray<Ball<Pack>>(n_)), r_(n_),
          share_(n_), part_(n_), by_parameter_(n_), slope_(n_), size_y_(n_), e_(n_), middle_(n_), y_(n_), lu_(n_) {}

    /// The boxes from number `first` on, as many as there are, at most a pack.
    void examine(const BoxStack& boxes, std::size_t first) {
        for (int u = 0; u < n_; ++u)
            for (int k = 0; k < native_lanes; ++k) {
                const std::size_t box = std::min(first + static_cast<std::size_t>(k), boxes.size() - 1);
                set_lane(q_.c[u].re, k, std::cos(boxes.center(box, u)));
                set_lane(q_.s[u].re, k, std::sin(boxes.center(box, u)));
                set_lane(q_.c[u].im, k, 0.0);
                set_lane(q_.s[u].im, k, 0.0);
                set_lane(r_[u], k, rounded_up(boxes.radius(box, u) + AngleBox::angle_rounding));
            }
        at_.enclose(q_, true);
        wide_.widen(at_, r_);
        ball_values(systems_.center, at_, f_);
        ball_jacobian(systems_.all, wide_, j_);
        for (std::size_t m = 0; m < g_.size(); ++m) ball_values(systems_.derivative[m], wide_, g_[m]);
        const Pack zero = Pack{} + 0.0;
        excluded_ = zero > zero;
        hopeless_ = injective_ = zero == zero;
        decide_plainly();
        decide_preconditioned();
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
        for (int i = 1; i < n_; ++i)
            if (lane(share_[i], k) > lane(share_[best], k)) best = i;
        for (int v = 1; v < n_; ++v)
            if (lane(slope_[best][v], k) * lane(r_[v], k) > lane(slope_[best][u], k) * lane(r_[u], k)) u = v;
        return u;
    }

private:
    using Mask = typename LaneTraits<Pack>::Mask;
    template <class T>
    using Numbers = RuntimeArray<T>;
    template <class T>
    using Matrix = RuntimeMatrix<T>;

    void decide_plainly() {
        const Pack zero = Pack{} + 0.0;
        for (int i = 0; i < n_; ++i) {
            Pack by_angle = zero, by_parameter = zero;
            for (int u = 0; u < n_; ++u) {
                slope_[i][u] = magnitude_bound(j_[i][u]);
                by_angle = by_angle + slope_[i][u] * r_[u];
            }
            for (std::size_t m = 0; m < g_.size(); ++m)
                by_parameter = by_parameter + magnitude_bound(g_[m][i]) * systems_.half_width[m];
            const Pack re = f_[i].mid.re, size = lane_max(re, Pack(-re)) - f_[i].rad;
            decide(size, by_angle, by_parameter);
            share_[i] = size / (by_angle + by_parameter);
        }
    }
    void decide_preconditioned() {
        const Pack zero = Pack{} + 0.0;
        for (int r = 0; r < n_; ++r)
            for (int c = 0; c < n_; ++c) middle_[r][c] = j_[r][c].mid;
        lu_.factor(middle_);
        lu_.inverse_into(y_);
        for (int r = 0; r < n_; ++r)
            for (int c = 0; c < n_; ++c) size_y_[r][c] = rounded_up<Pack>(magnitude_bound(y_[r][c]));
        contraction<Pack>(n_, y_, size_y_, j_, e_);
        for (int u = 0; u < n_; ++u) by_parameter_[u] = zero;
        for (std::size_t m = 0; m < g_.size(); ++m) {
            product_bound<Pack>(n_, y_, size_y_, g_[m], part_);
            for (int u = 0; u < n_; ++u) by_parameter_[u] = by_parameter_[u] + part_[u] * systems_.half_width[m];
        }
        for (int u = 0; u < n_; ++u) {
            Complex<Pack> sum(0.0);
            Pack error = zero, by_angle = zero;
            for (int k = 0; k < n_; ++k) {
                sum += y_[u][k] * f_[k].mid;
                error = error + size_y_[u][k] * (f_[k].rad + sum_unit_ * magnitude_bound(f_[k].mid));
                by_angle = by_angle + e_[u][k] * r_[k];
            }
            by_angle = rounded_up<Pack>(by_angle * (1 + sum_unit_));
            injective_ = mask_and<Mask>(injective_, by_angle < r_[u]);
            decide(lane_max(sum.re, Pack(-sum.re)) - rounded_up<Pack>(error * (1 + sum_unit_)), r_[u] + by_angle,
                   by_parameter_[u]);
        }
    }
    void decide(const Pack& size, const Pack& by_angle, const Pack& by_parameter) {
        excluded_ = mask_or(excluded_, size > rounded_up<Pack>((by_angle + by_parameter) * (1 + sum_unit_)));
        hopeless_ = mask_and<Mask>(hopeless_, size + by_angle < by_parameter);
    }
    static Mask mask_or(const Mask& a, const Mask& b) { return mask_not(mask_and<Mask>(mask_not(a), mask_not(b))); }

    const BallSystems<double>& systems_;
    int n_;
    double sum_unit_;
    RuntimePoint<Pack> q_;
    FactorBalls<Pack> at_, wide_;
    Numbers<Ball<Pack>> f_;
    Matrix<Ball<Pack>> j_;
    std::vector<Numbers<Ball<Pack>>> g_;
    Numbers<Pack> r_, share_, part_, by_parameter_;
    Matrix<Pack> slope_, size_y_, e_;
    Matrix<Complex<Pack>> middle_, y_;
    PivotedFactorization<Pack> lu_;
    Mask excluded_, hopeless_, injective_;
};

class RealSearch {
public:
    RealSearch(const BallSystems<double>& systems, const std::vector<AngleBox>& roots, std::size_t most)
        : systems_(systems), roots_(roots), most_(most), n_(systems.all.sizes.unknowns), test_(systems),
          around_(systems), open_(n_), batch_(n_), joined_(n_) {}

    RealSearchResult run() {
        RealSearchResult out;
        start();
        while (open_.size() > 0) {
            if (out.boxes >= most_) return out;
            const std::size_t count = std::min(open_.size(), std::size_t{native_lanes}), first = open_.size() - count;
            batch_.clear();
            for (std::size_t k = 0; k < count; ++k) batch_.push(open_, first + k);
            open_.resize(first);
            out.boxes += count;
            test_.examine(batch_, 0);
            joined_.clear();
            std::vector<std::size_t> joined_of;
            for (std::size_t k = 0; k < count; ++k)
                if (!test_.excluded(k) && join_nearest_root(k)) joined_of.push_back(k);
            std::array<bool, native_lanes> only_root{};
            if (!joined_of.empty()) {
                around_.examine(joined_, 0);
                for (std::size_t k = 0; k < joined_of.size(); ++k) only_root[joined_of[k]] = around_.injective(k);
            }
            for (std::size_t k = 0; k < count; ++k) {
                if (test_.excluded(k) || only_root[k]) continue;
                if (test_.hopeless(k)) return out;
                split(k, test_.longest(k));
            }
        }
        out.complete = true;
        return out;
    }

private:
    void start() {
        // the widest boxes over which cosines of the highest multiple are bounded
        open_.push();
        for (int u = 0; u < n_; ++u) {
            const int pieces = 8 * systems_.all.highest(u);
            const std::size_t size = open_.size();
            for (std::size_t b = 0; b < size; ++b) {
                open_.radius(b, u) = rounded_up(std::numbers::pi / pieces);
                open_.center(b, u) = -std::numbers::pi + std::numbers::pi / pieces;
            }
            for (int k = 1; k < pieces; ++k)
                for (std::size_t b = 0; b < size; ++b) {
                    open_.push(open_, b);
                    open_.center(open_.size() - 1, u) += 2 * std::numbers::pi / pieces * k;
                }
        }
    }

    /// Adds the smallest box around number `box` of the batch and the nearest known root; false where there is none.
    bool join_nearest_root(std::size_t box) {
        std::optional<std::size_t> best;
        double nearest = 0;
        const auto moved = [&](const AngleBox& root, int u) {
            constexpr double turn = 2 * std::numbers::pi;
            return root.center[u] - turn * std::round((root.center[u] - batch_.center(box, u)) / turn);
        };
        for (std::size_t k = 0; k < roots_.size(); ++k) {
            double distance = -std::numbers::pi;
            for (int u = 0; u < n_; ++u)
                distance =
                    std::max(distance, std::abs(moved(roots_[k], u) - batch_.center(box, u)) - roots_[k].radius[u]);
            if (best && distance >= nearest) continue;
            nearest = distance;
            best = k;
        }
        if (!best) return false;
        joined_.push();
        const std::size_t hull = joined_.size() - 1;
        for (int u = 0; u < n_; ++u) {
            const double center = batch_.center(box, u), radius = batch_.radius(box, u);
            const double root = moved(roots_[*best], u), reach = roots_[*best].radius[u];
            const double low = std::min(center - radius, root - reach), high = std::max(center + radius, root + reach);
            joined_.center(hull, u) = low + (high - low) / 2;
            joined_.radius(hull, u) = (high - low) / 2 + AngleBox::angle_rounding;
        }
        return true;
    }
    void split(std::size_t box, int u) {
        const double radius = batch_.radius(box, u);
        for (const int side : {-1, 1}) {
            open_.push(batch_, box);
            open_.radius(open_.size() - 1, u) = rounded_up(radius / 2);
            open_.center(open_.size() - 1, u) += side * radius / 2;
        }
    }

    const BallSystems<double>& systems_;
    const std::vector<AngleBox>& roots_;
    std::size_t most_;
    int n_;
    BoxTest test_, around_;
    BoxStack open_, batch_, joined_;
};

}  // namespace equilibria::detail

namespace equilibria {

EQUILIBRIA_INLINE RealSearchResult search_real_roots(const BallSystems<double>& systems,
                                                     const std::vector<AngleBox>& roots, std::size_t most) {
    return detail::RealSearch(systems, roots, most).run();
}

}  // namespace equilibria
