/// \file
/// Steps along curves of a plane of parameters: whether one closes the curve, stands still, or leaves the window, and
/// where.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/model/torus.hpp>

namespace equilibria::detail {

/// Judges steps along curves whose configurations have x as p, and whose parameter is y.
class CurveSteps {
public:
    /// angles: the first unknowns, as many as these, count modulo 2 pi.
    CurveSteps(const Window& window, int angles) : window_(window), angles_(angles) {}

    /// Whether a step, not a tiny one, moves the unknowns alone.
    template <class Point>
    bool stands(const Point& last, const Point& next) const {
        const Window& w = window_;
        return next.step > 1e-4 && std::abs(next.q.p - last.q.p) < 1e-11 * w.width() &&
               std::abs(next.p - last.p) < 1e-11 * w.height();
    }
    /// Moves a point that is outside by rounding to the border; false where it is further outside.
    template <class Point>
    bool put_into_window(Point& at) const {
        const Window& w = window_;
        const double x = std::clamp(at.q.p, w.x.low, w.x.high), y = std::clamp(at.p, w.y.low, w.y.high);
        if (std::abs(x - at.q.p) > 1e-10 * w.width() || std::abs(y - at.p) > 1e-10 * w.height()) return false;
        at.q.p = x;
        at.p = y;
        return true;
    }
    /// Whether a point is on the border of the window, to 1e-9 of it.
    template <class Point>
    bool on_border(const Point& at) const {
        const Window& w = window_;
        const auto near = [](double value, const Interval& range) {
            return std::min(value - range.low, range.high - value) < 1e-9 * range.width();
        };
        return near(at.q.p, w.x) || near(at.p, w.y);
    }
    /// Whether the step from `last` to `now` passes the first point, in its direction; angles modulo 2 pi.
    template <class Curve>
    bool closes(const BranchStepper<Curve>& stepper, const BranchPoint<Curve>& first, const BranchPoint<Curve>& last,
                const BranchPoint<Curve>& now) const {
        const auto to = [&](const BranchPoint<Curve>& point) {
            Direction d = stepper.difference(last, point.q, point.p);
            for (int i = 0; i + 1 < d.q.size() && i < angles_; ++i) d.q(i + 1) = wrap(d.q(i + 1));
            return d;
        };
        Direction step = to(now), away = to(first);
        const double part = stepper.dot(away, step) / stepper.dot(step, step);
        if (!(part > 0 && part <= 1)) return false;
        away.q -= part * step.q;
        away.p -= part * step.p;
        return stepper.length(away) < 0.25 * stepper.length(step) &&
               stepper.dot(first.tangent, now.tangent) > 0.5 * stepper.length(first.tangent);
    }

    /// The point of the curve near `from` (+) chord at which x (axis 0) or y (axis 1) is that of the chord's end.
    template <class Curve>
    std::optional<BranchPoint<Curve>> where(BranchStepper<Curve>& stepper, const BranchPoint<Curve>& from,
                                            const Direction& chord, int axis) const {
        Direction normal{Eigen::VectorXd::Zero(chord.q.size()), axis == 1 ? 1.0 : 0.0};
        if (axis == 0) normal.q(0) = 1;
        return stepper.onto(from.q, from.p, chord, normal, from.tangent);
    }
    /// The entry of x (axis 0) or y (axis 1).
    static double& entry(Direction& d, int axis) { return axis == 0 ? d.q(0) : d.p; }

    /// Where the segment from a (inside) to b (outside) leaves the window: on the curve if Newton's method finds it
    /// there, else on the chord.
    template <class Curve>
    BranchPoint<Curve> at_border(BranchStepper<Curve>& stepper, const BranchPoint<Curve>& a,
                                 const BranchPoint<Curve>& b) const {
        const Window& w = window_;
        const double from[] = {a.q.p, a.p}, to[] = {b.q.p, b.p};
        double part = 1;
        int axis = 0;
        double value = to[0];
        const auto clip = [&](int k, double bound) {
            if ((from[k] - bound) * (to[k] - bound) < 0 || to[k] == bound) {
                const double s = (bound - from[k]) / (to[k] - from[k]);
                if (s < part) part = s, axis = k, value = bound;
            }
        };
        clip(0, w.x.low);
        clip(0, w.x.high);
        clip(1, w.y.low);
        clip(1, w.y.high);
        Direction chord = stepper.difference(a, b.q, b.p);
        BranchStepper<Curve>::scale(chord, part);
        entry(chord, axis) = value - from[axis];
        const auto exactly = [&](BranchPoint<Curve> point) {
            (axis == 0 ? point.q.p : point.p) = value;
            return point;
        };
        const auto near = [&](const std::optional<BranchPoint<Curve>>& point) {
            if (!point) return false;
            Direction d = stepper.difference(a, point->q, point->p);
            d.q -= chord.q;
            d.p -= chord.p;
            return stepper.length(d) < 0.1;
        };
        if (const auto point = where(stepper, a, chord, axis); near(point)) return exactly(*point);
        // the border itself may be degenerate (a massless link): close to it in quarters of the way, then along the
        // tangent
        BranchPoint<Curve> y = a;
        const double size = axis == 0 ? w.width() : w.height();
        const auto at = [&](const BranchPoint<Curve>& point) { return axis == 0 ? point.q.p : point.p; };
        const auto ahead = [&](double share) {
            Direction d = y.tangent;
            BranchStepper<Curve>::scale(d, share * (value - at(y)) / entry(d, axis));
            return d;
        };
        while (std::abs(at(y) - value) > 1e-6 * size) {
            auto closer = where(stepper, y, ahead(0.75), axis);
            if (!near(closer)) break;
            y = std::move(*closer);
        }
        const Direction end = entry(y.tangent, axis) != 0 ? ahead(1) : chord;
        y.q = retract(stepper.problem(), y.q, end.q);
        y.p += end.p;
        return exactly(std::move(y));
    }

private:
    Window window_;
    int angles_;
};

}  // namespace equilibria::detail
