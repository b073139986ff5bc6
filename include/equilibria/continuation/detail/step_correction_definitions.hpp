/// \file
/// The corrector of a step: see continuation/branch_stepper.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/corrector.hpp>
#include <equilibria/continuation/detail/bordered_pair.hpp>
#include <equilibria/continuation/detail/last_factors.hpp>

namespace equilibria {

template <class Matrix>
bool AnyBranchStepper<Matrix>::iterates() const {
    const double ratio = solver_.work_ratio();
    return ratio > 0 && ratio >= options_.iterate_from;
}

template <class Matrix>
std::optional<detail::LastFactors<Matrix>> AnyBranchStepper<Matrix>::last_factors() const {
    if (!iterates() || solver_.matrix().rows() != weights_.size()) return std::nullopt;
    Eigen::VectorXd scale = weights_.cwiseSqrt();
    // multipliers have next to no weight
    scale.tail(problem_.multipliers()).setConstant(scale.maxCoeff());
    return detail::LastFactors<Matrix>(solver_, std::move(scale), theta_ > 0 ? theta_ : 1.0);
}

template <class Matrix>
auto AnyBranchStepper<Matrix>::normal_of(const Point& from, const Direction& predicted, double h) const -> Constraint {
    Constraint y{options_.constraint, predicted, std::abs(h)};
    if (y.kind == StepConstraint::normal_plane) y.normal = from.tangent;
    if (y.kind == StepConstraint::unknown) {
        y.normal.q = Eigen::VectorXd::Zero(predicted.q.size());
        y.normal.q(std::min(options_.controlled, predicted.q.size() - 1)) = 1;
        y.normal.p = 0;
    }
    if (y.kind == StepConstraint::scalar) {
        const Direction gradient = problem_.control_gradient(from.q, from.p, predicted.q.size());
        y.target = problem_.control(from.q, from.p) + gradient.q.dot(predicted.q) + gradient.p * predicted.p;
    }
    if (y.kind == StepConstraint::parameter) y.normal = {Eigen::VectorXd::Zero(predicted.q.size()), 1};
    return y;
}

template <class Matrix>
std::pair<Direction, double> AnyBranchStepper<Matrix>::constraint_at(const Constraint& c, const Direction& moved,
                                                                     const AnyConfiguration& q, double p) const {
    const auto weighted = [&](const Direction& d) {
        return Direction{weights_.cwiseProduct(d.q), theta_ * theta_ * d.p};
    };
    switch (c.kind) {
        case StepConstraint::normal_plane: return {weighted(c.normal), 0.0};
        case StepConstraint::updated_plane: return {weighted(moved), 0.0};
        case StepConstraint::sphere: return {weighted(moved), (dot(moved, moved) - c.distance * c.distance) / 2};
        case StepConstraint::cylinder: {
            Direction d = weighted(moved);
            // the unknowns move as far as predicted, which is kept in `normal`
            const double radius2 = c.normal.q.dot(weights_.cwiseProduct(c.normal.q)), reached2 = moved.q.dot(d.q);
            d.p = 0;
            return {d, (reached2 - radius2) / 2};
        }
        case StepConstraint::scalar:
            return {problem_.control_gradient(q, p, moved.q.size()), problem_.control(q, p) - c.target};
        case StepConstraint::unknown:
        case StepConstraint::parameter: break;
    }
    return {c.normal, 0.0};
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::correct_from(const Point& from, const Direction& moved,
                                                                          const Constraint& constraint, double h) {
    const Border border = border_;
    if (auto last = last_factors()) {
        if (auto point = correct_from(from, moved, constraint, h, std::move(last))) return point;
        border_ = border;
    }
    return correct_from(from, moved, constraint, h, std::nullopt);
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::correct_from(
    const Point& from, Direction moved, const Constraint& constraint, double h,
    std::optional<detail::LastFactors<Matrix>> last) {
    const bool iterate = last.has_value();
    AnyConfiguration q = problem_.retract(from.q, moved.q);
    double p = from.p + moved.p;
    const double start = length(moved);
    double before = 0, contraction = 0;
    for (int k = 0; k < options_.most_corrections; ++k) {
        Linearization<Matrix> here = problem_.linearization(q, p);
        const Eigen::VectorXd &g = here.residual, &g_p = here.parameter_derivative;
        if (!g.allFinite()) return std::nullopt;
        const auto [normal, value] = constraint_at(constraint, moved, q, p);
        std::optional<Direction> corrected;
        if (last) corrected = last->correction(here, normal, -value);
        std::optional<detail::BorderedPair> factored;
        if (!corrected) {
            if (!factor(std::move(here.tangent))) return std::nullopt;
            Eigen::MatrixXd right = Eigen::MatrixXd::Zero(g.size(), 3);
            right.col(0) = -g;
            right.col(1) = -g_p;
            const BorderedSolutions solutions = solver_.solve(right, Eigen::Vector3d(0, 0, 1));
            factored = detail::BorderedPair{solutions[2], solutions[1]};
            corrected = factored->combine(solutions[0], normal, -value);
            if (iterate && k == 0) last = last_factors();
        }
        const Direction& correction = *corrected;
        const double size = length(correction);
        if (!std::isfinite(size)) return std::nullopt;
        contraction = k > 0 && before > 0 ? size / before : 0;
        if (k == 0 && size > 0.5 * start + 1e3 * options_.tolerance) return std::nullopt;
        // with several weak directions rounding moves the iterates about in them
        const auto rounding = [&] {
            return g.lpNorm<Eigen::Infinity>() <=
                   64 * std::numeric_limits<double>::epsilon() *
                       detail::largest_force(solver_.matrix(), weights_, g.size() - problem_.multipliers());
        };
        if (k > 0 && contraction > 0.7 && size > 1e3 * tolerance(moved) && !rounding()) return std::nullopt;
        q = problem_.retract(q, correction.q);
        p += correction.p;
        moved.q += correction.q;
        moved.p += correction.p;
        before = size;
        if (!factored) {
            // the last correction is made with the factors of the point that it leads to
            if (size <= 300 * tolerance(moved)) last.reset();
            continue;
        }
        if (size <= tolerance(moved) ||
            (k > 0 && contraction > 0.5 && (size <= 1e3 * tolerance(moved) || rounding()))) {
            Direction along = from.tangent;
            along.q = problem_.transport(from.q, moved.q, along.q);
            q = problem_.rebase(q, p);
            auto point = size > tolerance(moved)
                             ? assess(q, p, along)
                             : assess_from(q, p, *factored, size <= 0.01 * tolerance(moved), from, along);
            if (!point) return std::nullopt;
            point->corrections = k + 1;
            point->step = h;
            point->turning = std::acos(std::clamp(dot(point->tangent, along) / length(along), -1.0, 1.0));
            return point;
        }
    }
    return std::nullopt;
}

}  // namespace equilibria
