/// \file
/// Steps along a curve of folds in units that grow with its coordinates, as where equilibria go to infinity.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/curves/critical_curve.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/locus/plane/infinity_curve.hpp>
#include <equilibria/locus/plane/plane_problems.hpp>

namespace equilibria::detail {

/// A stepper for each part of a fold curve: near, where no coordinate is much larger than those of the window's
/// equilibria, that of the caller; elsewhere one whose lengths are by the coordinates themselves.
class ScaledFolds {
public:
    using Folds = FoldCurve<PlaneProblems>;  ///< the curve
    using Point = BranchPoint<Folds>;        ///< of it
    using Stepper = BranchStepper<Folds>;    ///< along it

    /// problems: with the sizes of the unknowns near, 1 for the angles, which come first; options: of the steps there.
    ScaledFolds(PlaneProblems problems, int angles, const Window& window, const BranchOptions& options)
        : problems_(std::move(problems)), angles_(angles), window_(window), options_(options) {
        options_.first_step = 0.02;
        options_.largest_step = 0.05;
    }

    /// Whether a coordinate is much larger than its size at equilibria of the window. sizes: of all unknowns.
    static bool is_far(const Point& at, const Eigen::VectorXd& sizes, int angles) {
        return ratio(at, sizes, angles) > farther;
    }
    /// Whether it is so large that the equilibrium may be on its way to infinity.
    bool may_be_infinite(const Point& at) const { return ratio(at) > infinite; }
    /// Whether it is larger than any number that double precision tells from infinity here.
    bool is_lost(const Point& at) const { return ratio(at) > 1e6 * infinite; }

    /// The stepper for the next step from a point: the one that is used, or another one, whose tangent the point has
    /// then. near: the caller's.
    Stepper& stepper_at(Point& at, Stepper& near, Stepper& used) {
        const double here = ratio(at);
        const bool far = &used != &near;
        if (!far && here <= farther) return near;
        if (far && here < farther / 2) return measured(at, near);
        if (far && here < 4 * scale_ && here > scale_ / 4) return used;
        scale_ = here;
        PlaneProblems problems = problems_;
        for (Eigen::Index k = angles_; k < problems.sizes.size(); ++k)
            problems.sizes(k) = std::max(problems.sizes(k), std::abs(at.q.q(k)));
        const double y = at.p;
        auto curve = std::make_unique<Folds>(std::move(problems), y, window_.width());
        stepper_ = std::make_unique<Stepper>(*curve, options_);
        curve_ = std::move(curve);
        return measured(at, *stepper_);
    }

    /// The point of the plane to which a curve goes whose coordinates grow: on the nearest of the curves on which
    /// equilibria are at infinity. Nothing where none is near.
    std::optional<PlanePoint> limit(const Point& at, const std::vector<InfinityCurve>& curves) const {
        constexpr double near = 1e-3;  // of the window
        std::optional<PlanePoint> best;
        double distance = near;
        const auto scaled = [&](const PlanePoint& p) {
            return Eigen::Vector2d(p.x / window_.width(), p.y / window_.height());
        };
        const Eigen::Vector2d here = scaled({at.q.p, at.p});
        for (const InfinityCurve& curve : curves)
            for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
                const Eigen::Vector2d a = scaled(curve.points[k]), chord = scaled(curve.points[k + 1]) - a;
                const double part = std::clamp(chord.dot(here - a) / chord.squaredNorm(), 0.0, 1.0);
                const Eigen::Vector2d on = a + part * chord;
                if ((here - on).norm() < distance) {
                    distance = (here - on).norm();
                    best = PlanePoint{on(0) * window_.width(), on(1) * window_.height()};
                }
            }
        return best;
    }

private:
    static constexpr double farther = 16, infinite = 1e6;

    /// The largest coordinate over its size; 0 without coordinates.
    static double ratio(const Point& at, const Eigen::VectorXd& sizes, int angles) {
        double y = 0;
        for (Eigen::Index k = angles; k < at.q.q.size(); ++k) y = std::max(y, std::abs(at.q.q(k)) / sizes(k));
        return y;
    }
    double ratio(const Point& at) const { return ratio(at, problems_.sizes, angles_); }

    /// The stepper, the point having its tangent by it.
    static Stepper& measured(Point& at, Stepper& by) {
        if (auto again = by.assess(at.q, at.p, at.tangent)) {
            again->proposed_step = by.options().first_step;
            at = std::move(*again);
        }
        return by;
    }

    PlaneProblems problems_;
    int angles_;
    Window window_;
    BranchOptions options_;
    double scale_ = 1;
    std::unique_ptr<Folds> curve_;  ///< of the stepper
    std::unique_ptr<Stepper> stepper_;
};

}  // namespace equilibria::detail
