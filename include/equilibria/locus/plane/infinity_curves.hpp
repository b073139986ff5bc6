/// \file
/// The curves of a plane on which equilibria come from infinity, or go there: where a leading coefficient vanishes, or,
/// with several unknowns, where a root at infinity appears.
///
/// On a line of the plane all such points are solved for (search_infinity). From each of them a curve is followed: the
/// next point is that of the next line, parallel to the axis that the curve is steeper to, which is nearest to the
/// prediction. Steps are a hundredth of the window and less. No curve of this kind is missing that crosses a line that
/// was solved; one that lies between the lines is seen by the counts of equilibria alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/core/window.hpp>
#include <equilibria/locus/line/infinity_search.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/locus/plane/curve_end.hpp>
#include <equilibria/locus/plane/infinity_curve.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria::detail {

/// Solves lines of a window for what comes from infinity, and follows the curves through these points.
class InfinityCurveTracer {
public:
    /// The model has to outlive it. active: the numbers of x and y. sizes: of the coordinates, about.
    InfinityCurveTracer(const SearchedModel& model, std::array<int, 2> active, RuntimeArray<double> p,
                        const Window& window, std::vector<double> sizes, const RunOptions& run)
        : model_(model), active_(active), p_(std::move(p)), window_(window), sizes_(std::move(sizes)), run_(run) {}

    /// Solves the line x = value (axis 0) or y = value (axis 1), whose points curves must pass.
    void add_line(int axis, double value) {
        ++lines_;
        for (const double other : on_line(axis, value)) {
            const PlanePoint at = axis == 0 ? PlanePoint{value, other} : PlanePoint{other, value};
            seeds_.push_back({at, axis, value, false});
        }
    }

    /// The curves through all points of the lines.
    std::vector<InfinityCurve> trace() {
        std::vector<InfinityCurve> curves;
        for (Seed& seed : seeds_) {
            if (seed.traced) continue;
            const auto begin = direction_at(seed);
            if (!begin) continue;
            InfinityCurve curve;
            curve.points.push_back(seed.at);
            curve.ends[1] = follow(curve.points, *begin);
            curve.ends[0] = curve.ends[1];
            if (curve.ends[1] != CurveEnd::closed) {
                std::reverse(curve.points.begin(), curve.points.end());
                const Vector back{-begin->x, -begin->y};
                std::vector<PlanePoint> half{seed.at};
                curve.ends[0] = follow(half, back);
                curve.points.insert(curve.points.end(), half.begin() + 1, half.end());
                std::swap(curve.ends[0], curve.ends[1]);
            }
            claim_crossings(curve);
            seed.traced = true;
            curves.push_back(std::move(curve));
        }
        return curves;
    }

    /// Points of the lines that no curve passes.
    std::vector<PlanePoint> untraced() const {
        std::vector<PlanePoint> y;
        for (const Seed& seed : seeds_)
            if (!seed.traced) y.push_back(seed.at);
        return y;
    }
    std::uint64_t seeds() const { return seeds_.size(); }         ///< points of the lines
    std::uint64_t lines() const { return lines_; }                ///< those that were solved
    std::uint64_t failed_paths() const { return failed_paths_; }  ///< of all lines

private:
    static constexpr double largest_step = 0.01, smallest_step = 1e-5;  // of the window
    static constexpr int most_points = 5000;

    /// A point of a line.
    struct Seed {
        PlanePoint at;
        int axis;
        double line;
        bool traced;
    };
    /// In units of the window.
    struct Vector {
        double x, y;
        double dot(const Vector& o) const { return x * o.x + y * o.y; }
        double length() const { return std::hypot(x, y); }
    };

    /// All points of a line, by the other parameter.
    std::vector<double> on_line(int axis, double value) {
        RuntimeArray<double> p = p_;
        const Interval& moving = axis == 0 ? window_.y : window_.x;
        p[active_[static_cast<std::size_t>(axis)]] = value;
        p[active_[static_cast<std::size_t>(1 - axis)]] = moving.low;
        const auto found =
            search_infinity(model_, p, active_[static_cast<std::size_t>(1 - axis)], moving, sizes_, run_);
        failed_paths_ += found.paths.failed;
        std::vector<double> y;
        for (const auto& event : found.events) y.push_back(event.value);
        return y;
    }
    Vector from(const PlanePoint& a, const PlanePoint& b) const {
        return {(b.x - a.x) / window_.width(), (b.y - a.y) / window_.height()};
    }
    PlanePoint moved(const PlanePoint& a, const Vector& d) const {
        return {a.x + d.x * window_.width(), a.y + d.y * window_.height()};
    }
    /// The point of the curve on the line through `to`, parallel to the axis that d is steeper to, that is nearest to
    /// `to`, if it is within `reach` of it.
    std::optional<PlanePoint> nearest(const PlanePoint& to, const Vector& d, double reach) {
        const int axis = std::abs(d.x) >= std::abs(d.y) ? 0 : 1;
        std::optional<PlanePoint> best;
        double distance = reach;
        for (const double other : on_line(axis, axis == 0 ? to.x : to.y)) {
            const PlanePoint at = axis == 0 ? PlanePoint{to.x, other} : PlanePoint{other, to.y};
            const double apart = from(to, at).length();
            if (apart < distance) distance = apart, best = at;
        }
        return best;
    }
    /// The unit tangent at a seed, from a point next to it.
    std::optional<Vector> direction_at(const Seed& seed) {
        constexpr double small = 1e-3;
        // the line of the seed is crossed: first by a step to a line next to it
        for (const int axis : {seed.axis, 1 - seed.axis})
            for (const double sign : {1.0, -1.0}) {
                const Vector step{axis == 0 ? sign * small : 0, axis == 0 ? 0 : sign * small};
                const PlanePoint to = moved(seed.at, step);
                if (!window_.contains(to.x, to.y)) continue;
                const auto next = nearest(to, step, 3 * small);
                if (!next) continue;
                const Vector d = from(seed.at, *next);
                return Vector{d.x / d.length(), d.y / d.length()};
            }
        return {};
    }
    /// Follows a curve from its last point in the direction d, to the border, to its first point, or as far as it goes.
    CurveEnd follow(std::vector<PlanePoint>& points, Vector d) {
        const PlanePoint first = points.front();
        const Vector begin = d;
        double h = largest_step / 4;
        while (static_cast<int>(points.size()) < most_points) {
            const PlanePoint& last = points.back();
            const PlanePoint to = moved(last, {h * d.x, h * d.y});
            if (!window_.contains(to.x, to.y)) {
                points.push_back(at_border(last, d));
                return CurveEnd::border;
            }
            const auto next = nearest(to, d, 0.3 * h);
            const Vector step = next ? from(last, *next) : Vector{0, 0};
            if (!next || !(step.dot(d) > 0.9 * step.length())) {
                h /= 2;
                if (h < smallest_step) return CurveEnd::step;
                continue;
            }
            const double off = from(to, *next).length();
            d = {step.x / step.length(), step.y / step.length()};
            if (points.size() > 4 && from(last, first).dot(d) > 0 && from(last, first).length() < 1.5 * h &&
                d.dot(begin) > 0.5) {
                points.push_back(first);
                return CurveEnd::closed;
            }
            points.push_back(*next);
            if (off < 0.05 * h) h = std::min(1.5 * h, largest_step);
        }
        return CurveEnd::length;
    }
    /// The point at which the curve leaves the window: on the border if it is found there, else where the tangent
    /// leaves.
    PlanePoint at_border(const PlanePoint& last, const Vector& d) {
        double part = 1e300;
        int axis = 0;
        const auto clip = [&](int k, double value, double at, double speed, double size) {
            const double t = (value - at) / (speed * size);
            if (t >= 0 && t < part) part = t, axis = k;
        };
        if (d.x != 0) clip(0, d.x > 0 ? window_.x.high : window_.x.low, last.x, d.x, window_.width());
        if (d.y != 0) clip(1, d.y > 0 ? window_.y.high : window_.y.low, last.y, d.y, window_.height());
        PlanePoint to = moved(last, {part * d.x, part * d.y});
        (axis == 0 ? to.x : to.y) =
            axis == 0 ? (d.x > 0 ? window_.x.high : window_.x.low) : (d.y > 0 ? window_.y.high : window_.y.low);
        const Vector across{axis == 0 ? 1.0 : 0.0, axis == 0 ? 0.0 : 1.0};
        const auto exact = nearest(to, across, 0.5 * part + 1e-9);
        return exact ? *exact : to;
    }
    /// Marks the seeds that a curve passes: each of its crossings of a line is the nearest seed of that line, and no
    /// two crossings are one seed, so that curves side by side are told apart.
    void claim_crossings(const InfinityCurve& curve) {
        constexpr double near = 1e-3;  // of the window: a chord of the largest step is less off its curve
        std::vector<char> claimed(seeds_.size());
        for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
            const PlanePoint &a = curve.points[k], &b = curve.points[k + 1];
            for (std::size_t first = 0; first < seeds_.size(); ++first) {
                const Seed& of_line = seeds_[first];
                if (first > 0 && seeds_[first - 1].axis == of_line.axis && seeds_[first - 1].line == of_line.line)
                    continue;  // its line has been looked at
                const double from_a = (of_line.axis == 0 ? a.x : a.y) - of_line.line;
                const double from_b = (of_line.axis == 0 ? b.x : b.y) - of_line.line;
                if ((from_a < 0) == (from_b < 0)) continue;
                const double part = from_a / (from_a - from_b);
                const PlanePoint crossing{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
                std::size_t best = seeds_.size();
                double distance = near;
                for (std::size_t m = first; m < seeds_.size(); ++m) {
                    if (seeds_[m].axis != of_line.axis || seeds_[m].line != of_line.line) break;
                    const double apart = from(crossing, seeds_[m].at).length();
                    if (!claimed[m] && apart < distance) distance = apart, best = m;
                }
                if (best < seeds_.size()) claimed[best] = 1, seeds_[best].traced = true;
            }
        }
    }

    const SearchedModel& model_;
    std::array<int, 2> active_;
    RuntimeArray<double> p_;
    Window window_;
    std::vector<double> sizes_;
    RunOptions run_;
    std::vector<Seed> seeds_;
    std::uint64_t failed_paths_ = 0, lines_ = 0;
};

}  // namespace equilibria::detail
