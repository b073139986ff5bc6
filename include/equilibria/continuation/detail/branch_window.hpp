/// \file
/// The range of the parameter that a branch is followed in: the branch's points on its borders.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/event_function.hpp>
#include <equilibria/continuation/events.hpp>
#include <equilibria/core/window.hpp>

namespace equilibria::detail {

/// The range of p, and the points of branches on its two borders.
template <class Matrix>
class BranchWindow {
public:
    using Point = BranchPoint<Erased>;

    BranchWindow(AnyBranchStepper<Matrix>& stepper, Interval range) : stepper_(stepper), range_(range) {}

    /// Rounding of p counts as inside.
    bool inside(double p) const { return p >= range_.low - slack(range_.low) && p <= range_.high + slack(range_.high); }
    /// Whether p is on the border that it would leave the range by, growing (direction above 0) or falling.
    bool at_border(double p, double direction) const {
        if (direction == 0) return false;
        const double border = direction > 0 ? range_.high : range_.low;
        return std::abs(p - border) <= slack(border);
    }
    /// The border beyond which p is.
    double border_before(double p) const { return p < range_.low ? range_.low : range_.high; }

    /// The point at p = border between two neighbouring points of a branch, of which one is beyond the border; nothing
    /// where the corrector does not converge.
    std::optional<Point> on_border(const Point& a, const Point& b, double border) {
        const double h = b.arc_length - a.arc_length;
        // where the cubic curve through both has this p; at fixed p the corrector converges but next to folds
        double low = 0, high = h;
        const bool rising = b.p > a.p;
        for (int k = 0; k < 40; ++k) {
            const double middle = (low + high) / 2;
            ((stepper_.through(a, b, middle).p < border - a.p) == rising ? low : high) = middle;
        }
        Direction increment = stepper_.through(a, b, low);
        const Eigen::Index n = increment.q.size();
        increment.p = border - a.p;
        if (auto point = stepper_.onto(a.q, a.p, increment, {Eigen::VectorXd::Zero(n), 1}, a.tangent)) {
            point->step = low;
            point->arc_length = a.arc_length + low;
            const double from_a = stepper_.length(stepper_.difference(a, point->q, point->p));
            if (std::abs(from_a - low) < 0.2 * std::abs(h)) return point;
        }
        return zero_between(stepper_, {"border", [border](const Point& at) { return at.p - border; }}, a, b);
    }

    /// The last point of a branch that leaves the range between a, inside, and b, and what happens before it; nothing
    /// in `last` where that point is not found. left: b is outside, or a critical point between them is, at which p
    /// turns back.
    struct Exit {
        bool left = false;
        std::optional<Point> last;
        StepEvents<Erased> events;
    };
    /// What happens between a and b as far as it is inside.
    Exit between(const Point& a, const Point& b, const CriticalPointOptions& options) {
        Exit y;
        std::optional<Point> beyond;
        if (!inside(b.p)) {
            beyond = b;
        } else {
            y.events = events_between(stepper_, options, a, b);
            const auto outside = std::find_if(y.events.points.begin(), y.events.points.end(),
                                              [&](const auto& point) { return !inside(point.p); });
            if (outside == y.events.points.end()) return y;
            const Direction to = stepper_.difference(a, outside->q, outside->p),
                            chord = stepper_.difference(a, b.q, b.p);
            beyond = stepper_.between(a, b, stepper_.dot(to, chord) / stepper_.dot(chord, chord));
            // it reaches over the border by less than is told apart here
            if (!beyond || inside(beyond->p)) {
                std::erase_if(y.events.points, [&](const auto& point) { return !inside(point.p); });
                return y;
            }
        }
        y.left = true;
        y.last = on_border(a, *beyond, border_before(beyond->p));
        y.events = {};
        if (!y.last) {
            y.events.explained = false;
            y.events.reason = "the branch leaves the range of the parameter behind p = " + to_text(a.p) +
                              ", and its point on the border was not found";
            return y;
        }
        y.events = events_between(stepper_, options, a, *y.last);
        std::erase_if(y.events.points, [&](const auto& point) { return !inside(point.p); });
        return y;
    }

private:
    double slack(double border) const {
        const double width = range_.high - range_.low;
        return 1e-10 * (std::isfinite(width) ? width : std::isfinite(border) ? std::abs(border) : 0);
    }

    AnyBranchStepper<Matrix>& stepper_;
    Interval range_;
};

}  // namespace equilibria::detail
