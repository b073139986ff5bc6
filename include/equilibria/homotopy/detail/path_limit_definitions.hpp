/// \file
/// See homotopy/path_limit.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Core>
#include <Eigen/SVD>

#include <equilibria/core/double_double.hpp>
#include <equilibria/core/linear_solve.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/homotopy/path_limit.hpp>

namespace equilibria {

namespace detail {

/// The binary exponent of |z|, roughly; a large negative number of 0.
template <class R>
int size_exponent(const Complex<R>& z) {
    const auto of = [](const R& x) {
        if constexpr (std::is_same_v<R, DoubleDouble>) {
            return x.high() == 0 ? -100000 : std::isfinite(x.high()) ? std::ilogb(x.high()) : 100000;
        } else {
            using std::frexp;
            int e = 0;
            const R m = frexp(x, &e);
            if (!(m == m) || !isfinite(x)) return 100000;
            return m == R(0) ? -100000 : e;
        }
    };
    return std::max(of(z.re), of(z.im));
}
template <class R>
R times_power_of_two(const R& x, int e) {
    if constexpr (std::is_same_v<R, DoubleDouble>)
        return {std::ldexp(x.high(), e), std::ldexp(x.low(), e)};
    else
        return ldexp(x, e);
}
template <class R>
std::complex<double> rounded(const Complex<R>& z) {
    return {static_cast<double>(z.re), static_cast<double>(z.im)};
}

/// One path, with the digits of R.
template <class R>
class LogarithmicPath {
public:
    using Z = Complex<R>;
    using Vector = std::vector<std::complex<double>>;

    static constexpr bool double_double = std::is_same_v<R, DoubleDouble>;
    /// Values of 1 - t at which points of a path are kept; one that does not move any more at the last is singular.
    static constexpr std::array<double, double_double ? 1 : 3> levels = [] {
        if constexpr (double_double)
            return std::array{1e-16};
        else
            return std::array{1e-32, 1e-44, 1e-56};
    }();
    /// A correction that leaves the digits of a regular root: next to a multiple one corrections are halved at best.
    static constexpr double converged = double_double ? 1e-24 : 1e-44;
    /// The logarithm of the size from which on it is believed to go to a multiple root at infinity.
    static constexpr double multiple_size = 100;
    /// Largest 1 - t at which a path may be believed to go to infinity.
    static constexpr double far_r = double_double ? 1e-10 : 1e-25;
    /// A residual that is rounding, against the size of the terms.
    static constexpr double vanishing = double_double ? 1e-24 : 1e-45;

    LogarithmicPath(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns)
        : n_(sizes.unknowns), angles_(sizes.angles), columns_(&columns), highest_(at(n_)), lowest_(at(n_)),
          powers_(at(n_)), f_(n_), by_r_(n_), j_(n_), lu_(n_), exponent_(at(n_)), sum_(at(n_)), terms_(columns.size()) {
        for (const LaurentColumn& c : columns) {
            from_.emplace_back(R(c.from.real()), R(c.from.imag()));
            to_.emplace_back(R(c.to.real()), R(c.to.imag()));
            for (std::size_t u = 0; u < at(n_); ++u) {
                highest_[u] = std::max(highest_[u], c.exponents[u]);
                lowest_[u] = std::min(lowest_[u], c.exponents[u]);
            }
        }
        for (std::size_t u = 0; u < at(n_); ++u) {
            powers_[u].resize(at(highest_[u] - lowest_[u] + 1));
            std::set<int> needed{0};
            for (const LaurentColumn& c : columns) needed.insert(c.exponents[u]);
            needed_.emplace_back(needed.begin(), needed.end());
            most_whole_ = std::max({most_whole_, highest_[u], -lowest_[u]});
        }
        for (int k = -most_whole_; k <= most_whole_; ++k) whole_.push_back(R(k));
    }

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

    /// See has_solution_near.
    bool vanishes_near(const Vector& begin, double most) {
        std::vector<Z> q;
        std::vector<char> zero;
        for (std::size_t u = 0; u < begin.size(); ++u) {
            const auto z = u >= at(angles_) && std::abs(begin[u]) < 1e-6 ? 0.0 : begin[u];
            q.emplace_back(R(z.real()), R(z.imag()));
            zero.push_back(z == 0.0);
        }
        // an equation all of whose terms vanish is measured by its coefficients
        std::vector<int> coefficient(at(n_), -100000);
        for (std::size_t k = 0; k < to_.size(); ++k) {
            int& most_of = coefficient[at((*columns_)[k].equation)];
            most_of = std::max(most_of, size_exponent(to_[k]));
        }
        double moved = 0, before = 1e300;
        for (int round = 0; round < 100; ++round) {
            if (!linearize(q, R(0), &zero)) return false;
            double residual = 0;
            for (int i = 0; i < n_; ++i) {
                const int below = std::max(-300, std::min(0, exponent_[at(i)] - coefficient[at(i)]));
                residual = std::max(residual, std::ldexp(std::abs(rounded(f_[i])), below));
            }
            if (residual < vanishing) return true;
            if (round > 10 && residual > 0.98 * before) return false;
            before = residual;
            SingularValues::Vector j(at(n_ * n_)), right(at(n_));
            for (int i = 0; i < n_; ++i) {
                double row = 0;
                for (int u = 0; u < n_; ++u) row = std::max(row, std::abs(rounded(j_[i][u])));
                if (!(row > 0)) continue;
                right[at(i)] = rounded(f_[i]) / row;
                for (int u = 0; u < n_; ++u) j[at(u * n_ + i)] = rounded(j_[i][u]) / row;
            }
            const SingularValues svd(n_, n_, std::move(j));
            const auto step = svd.solve(right, svd.rank(1e-9));
            for (std::size_t u = 0; u < at(n_); ++u) {
                moved += std::abs(step[u]);
                const Z d(R(-step[u].real()), R(-step[u].imag()));
                if (zero[u])
                    q[u] += d, zero[u] = step[u] == 0.0;
                else
                    q[u] += d * q[u];
            }
            if (!(moved < most)) return false;
        }
        return false;
    }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
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

    /// z^k by squaring, k > 0.
    static Z power_of(Z z, int k) {
        Z y = z;
        int bit = 1;
        while (2 * bit <= k) bit *= 2;
        for (bit /= 2; bit > 0; bit /= 2) {
            y = y * y;
            if (k & bit) y = y * z;
        }
        return y;
    }
    /// Powers of each unknown, those of its exponents, each from the one before; those of an unknown that is 0 too.
    void set_powers(const std::vector<Z>& z) {
        for (std::size_t u = 0; u < at(n_); ++u) {
            auto& p = powers_[u];
            const auto& needed = needed_[u];
            const auto of = [&](int e) -> Z& { return p[at(e - lowest_[u])]; };
            const auto zero = at(static_cast<int>(std::ranges::lower_bound(needed, 0) - needed.begin()));
            of(0) = Z(1.0);
            for (std::size_t k = zero + 1; k < needed.size(); ++k)
                of(needed[k]) = of(needed[k - 1]) * power_of(z[u], needed[k] - needed[k - 1]);
            if (zero > 0) {
                const Z back = inverse(z[u]);
                for (std::size_t k = zero; k-- > 0;)
                    of(needed[k]) = of(needed[k + 1]) * power_of(back, needed[k + 1] - needed[k]);
            }
        }
    }
    const Z& power(std::size_t u, int e) const { return powers_[u][at(e - lowest_[u])]; }

    /// Terms, equations and their derivatives by the logarithms of the unknowns and by r, each equation divided by a
    /// power of two near its largest term. plain: coordinates that are 0 take derivatives by themselves.
    bool linearize(const std::vector<Z>& z, const R& r, const std::vector<char>* plain = nullptr) {
        set_powers(z);
        std::fill(exponent_.begin(), exponent_.end(), -100000);
        std::vector<Z> product(columns_->size()), coefficient(columns_->size());
        for (std::size_t k = 0; k < columns_->size(); ++k) {
            const LaurentColumn& c = (*columns_)[k];
            Z p(1.0);
            for (std::size_t u = 0; u < at(n_); ++u)
                if (c.exponents[u] != 0) p *= power(u, c.exponents[u]);
            product[k] = p;
            coefficient[k] = to_[k] + r * (from_[k] - to_[k]);
            terms_[k] = coefficient[k] * p;
            const int e = size_exponent(terms_[k]);
            if (e >= 100000) return false;
            exponent_[at(c.equation)] = std::max(exponent_[at(c.equation)], e);
        }
        for (int& e : exponent_)
            if (e == -100000) e = 0;  // all terms are 0
        if constexpr (double_double)
            for (const int e : exponent_)
                if (e > 900 || e < -800) return false;
        for (int i = 0; i < n_; ++i) {
            f_[i] = by_r_[i] = Z(0.0);
            sum_[at(i)] = 0;
            for (int u = 0; u < n_; ++u) j_[i][u] = Z(0.0);
        }
        for (std::size_t k = 0; k < columns_->size(); ++k) {
            const LaurentColumn& c = (*columns_)[k];
            const int i = c.equation, e = -exponent_[at(i)];
            const Z t = scaled(terms_[k], e);
            terms_[k] = t;
            f_[i] += t;
            sum_[at(i)] += std::abs(rounded(t));
            by_r_[i] += (from_[k] - to_[k]) * scaled(product[k], e);
            for (int u = 0; u < n_; ++u) {
                const int power_of_u = c.exponents[at(u)];
                if (power_of_u == 0) continue;
                if (plain && (*plain)[at(u)]) {
                    if (power_of_u != 1) continue;  // at 0
                    Z p(1.0);
                    for (std::size_t v = 0; v < at(n_); ++v)
                        if (v != at(u) && c.exponents[v] != 0) p *= power(v, c.exponents[v]);
                    j_[i][u] += scaled(coefficient[k] * p, e);
                } else {
                    j_[i][u] += whole(power_of_u) * t;
                }
            }
        }
        return true;
    }
    /// A small integer, which takes time to convert.
    const R& whole(int k) const { return whole_[at(k + most_whole_)]; }
    static Z scaled(const Z& z, int e) { return {times_power_of_two(z.re, e), times_power_of_two(z.im, e)}; }

    /// f_ becomes -J^-1 f; its largest size is returned.
    double newton_step() {
        lu_.factor(j_);
        for (int i = 0; i < n_; ++i) f_[i] = -f_[i];
        lu_.solve(f_);
        double size = 0;
        for (int u = 0; u < n_; ++u) {
            const double one = std::abs(rounded(f_[u]));
            if (!(one <= size)) size = one;  // a NaN stays
        }
        return size;
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
    /// d zeta / d s at z.
    bool slope(const std::vector<Z>& z, const R& r, std::vector<Z>& d) {
        if (!linearize(z, r)) return false;
        lu_.factor(j_);
        for (int i = 0; i < n_; ++i) f_[i] = r * by_r_[i];
        lu_.solve(f_);
        d.assign(at(n_), Z(0.0));
        for (int u = 0; u < n_; ++u) {
            d[at(u)] = f_[u];
            if (!(std::abs(rounded(f_[u])) < 1e6)) return false;
        }
        return true;
    }
    /// exp(d) - 1 to all digits: by its series, of a small fraction of d.
    static Z growth_factor(Z d) {
        int halvings = 0;
        for (double size = std::abs(rounded(d)); size > 0.05; size /= 2) ++halvings;
        d = scaled(d, -halvings);
        Z sum = d, term = d;
        for (int k = 2; k < (double_double ? 18 : 34); ++k) {
            term = (term * d) / R(k);
            sum += term;
        }
        for (; halvings > 0; --halvings) sum = sum * (sum + 2.0);
        return sum;
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
            for (const double tolerance : {0.02, 0.1, 0.3})
                if (has_leading_root(v, tolerance)) return true;
        return false;
    }
    /// Whether the growth is as it was before.
    bool is_steady(const std::vector<double>& v) const {
        if (before_.size() != v.size()) return false;
        for (std::size_t u = 0; u < v.size(); ++u)
            if (!(std::abs(v[u] - before_[u]) < 2e-3)) return false;
        return true;
    }
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
        bool some_zero = std::ranges::count(zero, char{1}) > 0;
        for (int round = 0; round < 12; ++round) {
            if (!linearize(q, R(0), some_zero ? &zero : nullptr)) return false;
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
                if (is_singular()) return false;
                if (!(moved <= 4 * left)) return false;
                y_.kind = LimitKind::finite;
                y_.z.clear();
                for (const Z& x : q) y_.z.push_back(rounded(x));
                linearize(q, R(0), some_zero ? &zero : nullptr);
                y_.residual = relative_residual();
                return true;
            }
            before = size;
        }
        return false;
    }
    /// Whether the inverse of the last factors magnifies by what the digits can tell: on a curve of solutions
    /// Newton's method converges, too.
    bool is_singular() {
        for (int i = 0; i < n_; ++i) f_[i] = Z(R(i % 2 == 0 ? 1.0 : -0.7), R(0.6 + 0.1 * i));
        lu_.solve(f_);
        for (int u = 0; u < n_; ++u)
            if (!(std::abs(rounded(f_[u])) < (double_double ? 1e16 : 1e46))) return true;
        return false;
    }
    double relative_residual() const {
        double y = 0;
        for (int i = 0; i < n_; ++i) y = std::max(y, std::abs(rounded(f_[i])) / std::max(sum_[at(i)], 1e-300));
        return y;
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

    /// Whether the terms that grow fastest vanish together next to the path.
    bool has_leading_root(const std::vector<double>& v, double tolerance) {
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
        if (std::ranges::any_of(count, [](int c) { return c < 2; })) return false;
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
            return false;
        std::vector<double> w = v;
        for (std::size_t u = 0; u < w.size(); ++u) w[u] += change(static_cast<Eigen::Index>(u));
        if (!make_rational(w)) return false;
        bool away = false;
        for (std::size_t u = 0; u < w.size(); ++u)
            away = away || (u < at(angles_) ? std::abs(w[u]) > 1e-6 : w[u] > 1e-6);
        if (!away) return false;
        // far enough for the leading terms to lead
        if (s_ * farthest(w) < 16) return false;
        // the leading terms grow alike, the others must fall behind
        for (std::size_t k = 0; k < size; ++k) {
            const auto i = at((*columns_)[k].equation);
            if (leads[k] && !(std::abs(rate(k, w) - rate(first[i], w)) < 1e-9)) return false;
            if (!leads[k] && !(rate(k, w) < rate(first[i], w) - 1e-6)) return false;
        }
        return leading_terms_vanish(leads, w);
    }
    static double farthest(const std::vector<double>& w) {
        double y = 0;
        for (const double x : w) y = std::max(y, std::abs(x));
        return y;
    }
    bool leading_terms_vanish(const std::vector<char>& leads, const std::vector<double>& w) {
        std::vector<Z> q = z_;
        const R& r = r_;
        double moved = 0, before = 1e300;
        for (int round = 0; round < 150; ++round) {
            if (!linearize(q, r)) return false;
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
                if (round == 0 && !(behind[i] < 0.3 * ahead[i])) return false;
                residual = std::max(residual, std::abs(rounded(face[i])) / ahead[i]);
                for (std::size_t u = 0; u < at(n_); ++u) of_terms[u * at(n_) + i] = j[u * at(n_) + i] / ahead[i];
                // rows of one size: next to a multiple root they are small
                double row = 0;
                for (std::size_t u = 0; u < at(n_); ++u) row = std::max(row, std::abs(j[u * at(n_) + i]));
                if (!(row > 0)) continue;
                right[i] = rounded(face[i]) / row;
                for (std::size_t u = 0; u < at(n_); ++u) j[u * at(n_) + i] /= row;
            }
            if (round == 0 && !(residual < 0.3)) return false;
            if (residual < vanishing) {
                // near a multiple root at infinity there may be roots that are merely far away: 1e16 and more out,
                // where coefficients are rounded
                if (s_ * farthest(w) < multiple_size) {
                    const SingularValues regular(n_, n_, std::move(of_terms));
                    int rank = 0;
                    while (rank < n_ && regular[rank] > 1e-6) ++rank;
                    if (rank < n_ - 1) {
                        to_multiple_ = true;
                        return false;
                    }
                }
                y_.kind = LimitKind::at_infinity;
                y_.direction = w;
                y_.residual = residual;
                return true;
            }
            if (round > 10 && residual > 0.98 * before) return false;
            before = residual;
            const SingularValues svd(n_, n_, std::move(j));
            const auto step = svd.solve(right, svd.rank(1e-9));
            for (std::size_t u = 0; u < at(n_); ++u) {
                if (!(std::abs(step[u]) < 0.5)) return false;
                moved += std::abs(step[u]);
                q[u] *= Z(1.0) - Z(R(step[u].real()), R(step[u].imag()));
            }
            if (!(moved < 0.7)) return false;
        }
        return false;
    }

    int n_, angles_;
    const std::vector<LaurentColumn>* columns_;
    std::vector<Z> from_, to_;
    std::vector<int> highest_, lowest_;
    std::vector<std::vector<int>> needed_;  ///< the exponents of each unknown, and 0, ascending
    std::vector<std::vector<Z>> powers_;
    int most_whole_ = 0;
    std::vector<R> whole_;
    SizedArray<Z, at_run_time> f_, by_r_;
    RuntimeMatrix<Z> j_;
    PivotedFactorization<R> lu_;
    std::vector<int> exponent_;
    std::vector<double> sum_;
    std::vector<Z> terms_;
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

EQUILIBRIA_INLINE bool has_solution_near(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns,
                                         const std::vector<std::complex<double>>& z, double most) {
    return detail::LogarithmicPath<DoubleDouble>(sizes, columns).vanishes_near(z, most);
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
