/// \file
/// See homotopy/path_limit.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <equilibria/core/double_double.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/homotopy/detail/face_systems.hpp>
#include <equilibria/homotopy/path_limit.hpp>

namespace equilibria {

namespace detail {

/// One path, with the digits of R.
template <class R>
class LogarithmicPath : private FaceSystems<R> {
public:
    using Base = FaceSystems<R>;
    using typename Base::Z;
    using Vector = std::vector<std::complex<double>>;

    using Base::double_double, Base::vanishing;
    /// Values of 1 - t at which points of a path are kept; one that does not move any more at the last is singular.
    static constexpr std::array<double, double_double ? 1 : 3> levels = [] {
        if constexpr (double_double)
            return std::array{1e-16};
        else
            return std::array{1e-32, 1e-44, 1e-56};
    }();
    /// A correction that leaves the digits of a regular root: next to a multiple one corrections are halved at best.
    static constexpr double converged = double_double ? 1e-24 : 1e-44;
    /// Largest 1 - t at which a path may be believed to go to infinity.
    static constexpr double far_r = double_double ? 1e-10 : 1e-25;
    using Base::Base;

    PathLimit follow(const Vector& begin, double r, int most_steps) {
        z_.clear();
        for (const auto& z : begin) z_.emplace_back(R(z.real()), R(z.imag()));
        s_ = -std::log(r);
        r_ = R(r);
        y_ = PathLimit();
        before_.clear();
        to_multiple_ = false;
        y_.digits = double_double ? 31 : 64;
        if (!correct(z_, r_, 0.1)) return open("Newton's method does not find the path");
        double h = r > 0.5 ? 0.02 : 0.2;
        std::size_t level = 0;
        while (level < levels.size() && s_ > -std::log(levels[level]) - 1e-9) ++level;
        if (level == levels.size()) return open("it begins too near to its end");
        for (int since_test = 0;;) {
            if (y_.steps++ > most_steps) return y_.points.empty() ? open("too many steps") : singular();
            const double end = -std::log(levels[level]);
            const double step = std::min(h, end - s_);
            std::vector<Z> next = z_;
            const R middle = shrunk(step / 2), after = shrunk(step);
            if (predict(next, step, middle, after) && correct(next, after, 0.05)) {
                z_ = std::move(next);
                s_ += step;
                r_ = after;
                if (contraction_ < 5e-4) h = std::min(1.6 * h, 4.0);
                if (contraction_ > 4e-3) h *= 0.7;
                if (++since_test >= 3 && s_ > 3) {
                    since_test = 0;
                    if (decided()) return finish();
                    if (to_multiple_ && double_double) return open("");
                }
            } else {
                h = 0.4 * step;
                if (h < 1e-7) {
                    if (s_ > 3 && decided()) return finish();
                    return y_.points.empty() ? open("steps become too small") : singular();
                }
            }
            if (s_ < end - 1e-9) continue;
            if (decided()) return finish();
            if (is_still()) keep_point();
            if (++level < levels.size()) continue;
            if (!y_.points.empty()) return singular();
            return open("no limit can be told");
        }
    }

private:
    using Base::angles_, Base::at, Base::columns_, Base::exponent_, Base::f_, Base::growth_factor, Base::j_,
        Base::leading_root, Base::linearize, Base::lu_, Base::n_, Base::newton_step, Base::relative_residual,
        Base::slope, Base::to_;

    /// r exp(-h).
    R shrunk(double h) const { return r_ + growth_factor(Z(R(-h), R(0))).re * r_; }

    PathLimit open(const char* why) {
        y_.kind = LimitKind::open;
        y_.to_multiple_root = to_multiple_;
        y_.reason = to_multiple_ ? "leave for a multiple root at infinity, next to which far roots may be hidden" : why;
        return finish();
    }
    PathLimit finish() {
        y_.r = std::exp(-s_);
        if (y_.kind == LimitKind::open || y_.kind == LimitKind::at_infinity) {
            y_.z.clear();
            for (const Z& z : z_) y_.z.push_back(rounded(z));
        }
        if (y_.kind == LimitKind::open && linearize(z_, r_)) y_.direction = growth();
        return std::move(y_);
    }

    /// Newton's method at s, from no farther than `most`; whether its corrections shrink as they do near this path
    /// alone.
    bool correct(std::vector<Z>& z, const R& r_exact, double most) {
        constexpr double largest_contraction = 0.02, rounding = double_double ? 1e-29 : 1e-60;
        double before = 0;
        const auto r = static_cast<double>(r_exact);
        // paths to one place at infinity are as near to each other as r; on a curve rounding moves along it
        const double most_settled = double_double ? 1e-13 : 1e-24;
        const double settled = std::min(most_settled, std::max(rounding / r, 1e-4 * r));
        contraction_ = 0;
        for (int round = 0; round < 8; ++round) {
            if (!linearize(z, r_exact)) return false;
            const double size = newton_step();
            if (!(size < (round == 0 ? most : largest_contraction * before + settled))) return false;
            if (round == 1) contraction_ = size / before;
            for (int u = 0; u < n_; ++u) z[at(u)] += f_[u] * z[at(u)];
            if (size < settled) return true;
            before = size;
        }
        return false;
    }
    std::vector<Z> turned(const std::vector<Z>& z, double h, const std::vector<Z>& d) const {
        std::vector<Z> y = z;
        for (std::size_t u = 0; u < y.size(); ++u) y[u] += growth_factor(R(h) * d[u]) * y[u];
        return y;
    }
    /// Runge and Kutta's fourth-order step, in all digits: paths that go to one place at infinity stay apart.
    bool predict(std::vector<Z>& z, double h, const R& middle, const R& end) {
        std::vector<Z> a, b, c, d;
        if (!slope(z, r_, a)) return false;
        const auto small = [h](const std::vector<Z>& v) {
            return std::ranges::all_of(v, [h](const Z& x) { return h * std::abs(rounded(x)) < 40; });
        };
        if (!small(a) || !slope(turned(z, h / 2, a), middle, b) || !small(b) ||
            !slope(turned(z, h / 2, b), middle, c) || !small(c) || !slope(turned(z, h, c), end, d) || !small(d))
            return false;
        for (std::size_t u = 0; u < a.size(); ++u) a[u] = (a[u] + 2.0 * (b[u] + c[u]) + d[u]) / R(6);
        z = turned(z, h, a);
        return true;
    }

    /// The growth of each unknown at the last point that `slope` was called at.
    std::vector<double> growth() {
        std::vector<Z> d;
        if (!slope(z_, r_, d)) return {};
        std::vector<double> y;
        for (const Z& x : d) y.push_back(static_cast<double>(x.re));
        return y;
    }

    /// The coordinates that tend to 0, if no unknown goes to infinity; else nothing.
    std::optional<std::vector<char>> vanishing_coordinates(const std::vector<double>& v) const {
        std::vector<char> y(v.size());
        for (std::size_t u = 0; u < v.size(); ++u) {
            if (u < at(angles_) ? std::abs(v[u]) > 0.2 : v[u] > 0.2) return {};
            y[u] = u >= at(angles_) && v[u] < -0.02 && size_exponent(z_[u]) < -10;
        }
        return y;
    }
    bool decided() {
        const std::vector<double> v = growth();
        if (v.empty()) return false;
        if (const auto zero = vanishing_coordinates(v)) {
            bool moving = false;
            for (std::size_t u = 0; u < v.size(); ++u) moving = moving || (!(*zero)[u] && std::abs(v[u]) > 0.05);
            if (!moving && ends_regularly(*zero, v)) return true;
        }
        const bool steady = is_steady(v);
        before_ = v;
        if (!steady || s_ < -std::log(far_r)) return false;
        const bool away = [&] {
            for (std::size_t u = 0; u < v.size(); ++u)
                if (u < at(angles_) ? std::abs(v[u]) > 0.02 : v[u] > 0.02) return true;
            return false;
        }();
        if (away)
            for (const double tolerance : {0.02, 0.1, 0.3}) {
                auto root = leading_root(v, tolerance, z_, r_, s_);
                if (!root) continue;
                if (root->multiple) {
                    to_multiple_ = true;
                    continue;
                }
                y_.kind = LimitKind::at_infinity;
                y_.direction = std::move(root->direction);
                y_.residual = root->residual;
                return true;
            }
        return false;
    }
    /// Whether the growth is as it was before.
    bool is_steady(const std::vector<double>& v) const {
        if (before_.size() != v.size()) return false;
        for (std::size_t u = 0; u < v.size(); ++u)
            if (!(std::abs(v[u] - before_[u]) < 2e-3)) return false;
        return true;
    }
    /// Whether Newton's method at t = 1 converges quadratically to a root, no farther than the path has to go.
    bool ends_regularly(const std::vector<char>& zero, const std::vector<double>& v) {
        std::vector<Z> q = z_;
        double left = 1e-12;
        for (std::size_t u = 0; u < v.size(); ++u) {
            if (zero[u])
                q[u] = Z(0.0);
            else
                left = std::max(left, std::abs(v[u]));
        }
        double before = 1e300, moved = 0;
        for (int round = 0; round < 12; ++round) {
            if (!linearize(q, R(0), &zero)) return false;
            const double size = newton_step();
            if (!(size < 0.05) || !(round == 0 || size < 0.05 * before)) return false;
            for (int u = 0; u < n_; ++u) {
                if (zero[at(u)]) {
                    if (std::abs(rounded(f_[u])) > 1e-22) return false;
                    continue;  // the root has it at 0, or Newton's method would leave it
                }
                q[at(u)] *= Z(1.0) + f_[u];
                moved = std::max(moved, std::abs(rounded(f_[u])));
            }
            if (size < converged) {
                if (!(moved <= 4 * left) || is_singular(q, zero) || !comes_back(q, zero)) return false;
                y_.kind = LimitKind::finite;
                y_.z.clear();
                for (const Z& x : q) y_.z.push_back(rounded(x));
                linearize(q, R(0), &zero);
                y_.residual = relative_residual();
                return true;
            }
            before = size;
        }
        return false;
    }
    /// Whether the inverse at q magnifies by what the digits can tell: on a curve of solutions Newton's method
    /// converges, too, and so it does where an unknown that is 0 has no derivative. Its solution stays in f_.
    bool is_singular(const std::vector<Z>& q, const std::vector<char>& zero) {
        if (!linearize(q, R(0), &zero)) return true;
        lu_.factor(j_);
        for (int i = 0; i < n_; ++i) f_[i] = Z(R(i % 2 == 0 ? 1.0 : -0.7), R(0.6 + 0.1 * i));
        lu_.solve(f_);
        for (int u = 0; u < n_; ++u)
            if (!(std::abs(rounded(f_[u])) < (double_double ? 1e16 : 1e46))) return true;
        return false;
    }
    /// Whether one step of Newton's method takes back what moves equations by 1e4 roundings (is_singular's solution).
    /// Next to a multiple root, where rounding makes values 0 and looks like convergence, it takes half of it back.
    bool comes_back(std::vector<Z> q, const std::vector<char>& zero) {
        constexpr double roundings = double_double ? 1e-27 : 1e-60;
        std::vector<Z> move;
        double largest = 0, left = 0;
        for (int u = 0; u < n_; ++u) {
            move.push_back(zero[at(u)] ? Z(0.0) : R(roundings) * f_[u]);
            q[at(u)] *= Z(1.0) + move.back();
            largest = std::max(largest, std::abs(rounded(move.back())));
        }
        if (!linearize(q, R(0), &zero)) return false;
        newton_step();
        for (int u = 0; u < n_; ++u)
            if (!zero[at(u)]) left = std::max(left, std::abs(rounded(f_[u] + move[at(u)])));
        return left <= 0.25 * largest;
    }
    /// Whether no unknown moves any more, but for coordinates on their way to 0.
    bool is_still() {
        const std::vector<double> v = growth();
        if (v.empty()) return false;
        for (std::size_t u = 0; u < v.size(); ++u) {
            const bool to_zero = u >= at(angles_) && v[u] < 0 && size_exponent(z_[u]) < -5;
            if (std::abs(v[u]) > 0.01 && !to_zero) return false;
        }
        return true;
    }
    void keep_point() {
        PathPoint point{levels[0], {}};
        for (const double r : levels)
            if (std::abs(s_ + std::log(r)) < 1e-6) point.r = r;
        for (const Z& z : z_) {
            auto& parts = point.z.emplace_back();
            for (int part = 0; part < 2; ++part) {
                R rest = part == 0 ? z.re : z.im;
                for (int k = 0; k < (double_double ? 2 : 5); ++k) {
                    const auto high = static_cast<double>(rest);
                    parts[at(part)].push_back(high);
                    rest = rest - R(high);
                }
            }
        }
        y_.points.push_back(std::move(point));
    }
    PathLimit singular() {
        const std::vector<double> v = growth();
        y_.kind = LimitKind::singular;
        y_.direction = v;
        y_.z.clear();
        for (std::size_t u = 0; u < z_.size(); ++u) {
            const bool to_zero = u >= at(angles_) && v[u] < -0.01 && size_exponent(z_[u]) < -5;
            y_.z.push_back(to_zero ? 0.0 : rounded(z_[u]));
        }
        linearize(z_, r_);
        return finish();
    }

    std::vector<Z> z_;
    std::vector<double> before_;
    bool to_multiple_ = false;
    double s_ = 0, contraction_ = 0;
    R r_{};
    PathLimit y_;
};

}  // namespace detail

EQUILIBRIA_INLINE PathLimit follow_to_limit(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns,
                                            std::vector<std::complex<double>> z, double r, int digits, int most_steps) {
    if (digits > 31) return detail::LogarithmicPath<Multiprecision<64>>(sizes, columns).follow(z, r, most_steps);
    return detail::LogarithmicPath<DoubleDouble>(sizes, columns).follow(z, r, most_steps);
}

EQUILIBRIA_INLINE std::string direction_in_words(const std::vector<double>& direction) {
    for (int by = 1; by <= 120; ++by) {
        std::string text = "(";
        bool whole = true;
        for (std::size_t u = 0; u < direction.size(); ++u) {
            const double x = by * direction[u];
            whole = whole && std::abs(x - std::round(x)) < 1e-6 * by;
            text += (u > 0 ? ", " : "") + std::to_string(static_cast<long>(std::lround(x)));
        }
        if (whole) return text + (by > 1 ? ")/" + std::to_string(by) : ")");
    }
    return "irrational";
}

}  // namespace equilibria
