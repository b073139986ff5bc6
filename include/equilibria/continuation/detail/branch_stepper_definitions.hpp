/// \file
/// See continuation/branch_stepper.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/continuation/corrector.hpp>
#include <equilibria/continuation/detail/bordered_pair.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/continuation/factorization/orthonormalize.hpp>

namespace equilibria {

template <class Matrix>
AnyBranchStepper<Matrix>::AnyBranchStepper(AnyProblem<Matrix> problem, const BranchOptions& options)
    : problem_(std::move(problem)), options_(options),
      solver_(problem_.properties().symmetric, problem_.multipliers(), problem_.symmetric_factors()),
      theta_(options.parameter_weight) {
    options.validate();
    require(options.constraint != StepConstraint::scalar || problem_.properties().control, "constraint", "scalar",
            "must not be asked of a problem without control(q, p)");
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::start(AnyConfiguration q, double p, int direction) {
    weights_ = problem_.weights(q, problem_.residual(q, p).size());
    const Correction correction = detail::Corrector<Matrix>(problem_, solver_, border_, weights_)(
        q, p, {.most_steps = 4 * options_.most_corrections, .tolerance = options_.tolerance});
    if (!correction.converged()) return std::nullopt;
    q = problem_.rebase(q, p);
    auto point = assess(q, p, std::nullopt);
    if (!point) return std::nullopt;
    if (direction * point->tangent.p < 0) flip(point->tangent);
    point->corrections = correction.steps;
    point->proposed_step = options_.first_step;
    return point;
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::advance(const Point& from, const Point* before) {
    double h = std::min(from.proposed_step, options_.largest_step);
    for (; h >= options_.smallest_step; h /= 2) {
        std::optional<Point> next = step(from, h, before);
        if (!next) continue;
        if (!(next->turning <= options_.largest_angle)) continue;
        if (h > options_.resolution && jumped(from, *next, predict(from, h, before))) continue;
        if (from.negative && next->negative && h > options_.resolution &&
            std::abs(*from.negative - *next->negative) > options_.most_sign_changes)
            continue;
        const double by_angle = 0.5 * options_.largest_angle / (next->turning + 1e-9);
        // by GMRES a correction gains three digits, and the last one makes sure
        const double by_corrections = std::exp2(((iterates() ? 6 : 4) - next->corrections) / 2.0);
        next->proposed_step = h * std::clamp(std::min(by_angle, by_corrections), 0.5, 2.0);
        return next;
    }
    return std::nullopt;
}

template <class Matrix>
bool AnyBranchStepper<Matrix>::jumped(const Point& from, const Point& next, const Direction& predicted) const {
    // what is controlled moves as predicted, and the others may not
    if (!std::isfinite(options_.largest_miss) || options_.constraint == StepConstraint::parameter ||
        options_.constraint == StepConstraint::unknown || options_.constraint == StepConstraint::scalar)
        return false;
    const auto norm = [&](const Eigen::VectorXd& v) { return std::sqrt(v.dot(weights_.cwiseProduct(v))); };
    const Direction moved = difference(from, next.q, next.p);
    return norm(moved.q - predicted.q) > options_.largest_miss * norm(moved.q) + 1e3 * tolerance(moved);
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::step(const Point& from, double h, const Point* before) {
    Direction predicted = predict(from, h, before);
    border_ = from.border;
    auto next = correct_from(from, predicted, normal_of(from, predicted, h), h);
    if (!next) return std::nullopt;
    next->step = h;
    next->arc_length = from.arc_length + h;
    return next;
}

template <class Matrix>
Direction AnyBranchStepper<Matrix>::predict(const Point& from, double h, const Point* before) const {
    Direction d = from.tangent;
    scale(d, h);
    if (!before || options_.predictor == Predictor::tangent || !(std::abs(from.step) > 0)) return d;
    if (options_.predictor == Predictor::cubic) {
        // what is controlled must not turn back in what is predicted, where the branch does
        if (options_.constraint == StepConstraint::parameter || options_.constraint == StepConstraint::unknown ||
            options_.constraint == StepConstraint::scalar)
            return d;
        const Direction curved = through(from, *before, h);
        // not where the last step was over a sharp bend
        Direction bend = curved;
        bend.q -= d.q;
        bend.p -= d.p;
        return length(bend) < 0.3 * std::abs(h) ? curved : d;
    }
    Direction secant = difference(from, before->q, before->p);
    flip(secant);
    if (options_.predictor == Predictor::secant) {
        scale(secant, h / length(secant));
        return secant;
    }
    // the parabola through both points with the tangent at the last: h t + (h / H)^2 (secant - H t), seen backwards
    const double ratio = h / from.step;
    d.q += ratio * ratio * (from.step * from.tangent.q - secant.q);
    d.p += ratio * ratio * (from.step * from.tangent.p - secant.p);
    return d;
}

template <class Matrix>
Direction AnyBranchStepper<Matrix>::through(const Point& from, const Point& other, double h) const {
    // x(s) = s t + a s^2 + b s^3, s = t.x: of the other point s, x and x' are known
    const Direction x = difference(from, other.q, other.p);
    Direction slope = other.tangent;
    if (problem_.properties().transport) {
        // in increments of `from`
        const double by = detail::difference_step(weights_, slope.q);
        const auto at = [&](double e) {
            return problem_.difference(from.q, problem_.retract(other.q, Eigen::VectorXd(e * slope.q)));
        };
        slope.q = (at(by) - at(-by)) / (2 * by);
    }
    const Direction& t = from.tangent;
    const double s = dot(t, x), rate = dot(t, slope);
    if (!(std::abs(s) > 0.1 * length(x)) || !(std::abs(rate) > 0.1 * length(slope))) {
        Direction d = t;
        scale(d, h);
        return d;
    }
    scale(slope, 1 / rate);
    const double u = h / s, a = u * u * (3 - 2 * u), b = u * u * (u - 1) * s;
    // h t + a (x - s t) + b (x' - t)
    return {h * t.q + a * (x.q - s * t.q) + b * (slope.q - t.q), h * t.p + a * (x.p - s * t.p) + b * (slope.p - t.p)};
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::between(const Point& a, const Point& b, double share) {
    const double h = share * (b.arc_length - a.arc_length);
    const Direction predicted = through(a, b, h);
    border_ = share < 0.5 ? a.border : b.border;
    auto next = correct_from(a, predicted, normal_of(a, predicted, h), h);
    if (!next) return step(a, h);
    next->step = h;
    next->arc_length = a.arc_length + h;
    return next;
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::onto(const AnyConfiguration& q, double p,
                                                                  const Direction& increment, const Direction& normal,
                                                                  const Direction& along) {
    if (weights_.size() == 0) weights_ = problem_.weights(q, increment.q.size());
    Point from;
    from.q = q;
    from.p = p;
    from.tangent = along;
    // a state that does not move keeps the last border
    if (!increment.q.isZero(0)) border_.column = border_.row = largest(increment.q);
    Constraint constraint;
    constraint.kind = StepConstraint::normal_plane;
    constraint.normal = normal;
    auto next = correct_from(from, increment, constraint, length(increment));
    if constexpr (!BorderedSolver<Matrix>::sparse)
        if (!next && !problem_.properties().symmetric) {
            // the row of an unsymmetric K need not be that of the largest increment
            Matrix k = problem_.linearization(problem_.retract(q, increment.q), p + increment.p).tangent;
            if (!factor_at_weakest(solver_, std::move(k), weights_, problem_.multipliers(), border_, {}, 0))
                return std::nullopt;
            next = correct_from(from, increment, constraint, length(increment));
        }
    if (next) next->proposed_step = std::clamp(length(increment), options_.smallest_step, options_.largest_step);
    return next;
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::assess(const AnyConfiguration& q, double p,
                                                                    const std::optional<Direction>& along) {
    Linearization<Matrix> here = problem_.linearization(q, p);
    if (weights_.size() == 0) weights_ = problem_.weights(q, here.residual.size());
    const auto weak =
        factor_at_weakest(solver_, std::move(here.tangent), weights_, problem_.multipliers(), border_, {}, watched());
    if (!weak) return std::nullopt;
    return point_of(q, p, here.residual, *weak, solver_.solve(-here.parameter_derivative, 0), along);
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::assess_from(const AnyConfiguration& q, double p,
                                                                         detail::BorderedPair pair, bool same,
                                                                         const Point& from, const Direction& along) {
    Linearization<Matrix> here;
    if (same) {
        here.residual = problem_.residual(q, p);
    } else {
        here = problem_.linearization(q, p);
        if (!here.residual.allFinite()) return std::nullopt;
        pair.refine(solver_, here.tangent, here.parameter_derivative);
    }
    const Border before = border_;
    const auto weak = weakest_direction(solver_, pair.r, weights_, problem_.multipliers(), border_,
                                        from.weak_directions(), watched());
    if (!weak) return std::nullopt;
    if (border_ != before) return assess(q, p, along);
    return point_of(q, p, here.residual, *weak, pair.s, along);
}

template <class Matrix>
std::optional<BranchPoint<Erased>> AnyBranchStepper<Matrix>::point_of(const AnyConfiguration& q, double p,
                                                                      const Eigen::VectorXd& g,
                                                                      const WeakDirection& weak,
                                                                      const BorderedSolution& s,
                                                                      const std::optional<Direction>& along) {
    if (!g.allFinite()) return std::nullopt;
    Point point;
    point.q = q;
    point.p = p;
    point.residual = g.size() > 0 ? g.lpNorm<Eigen::Infinity>() : 0;
    const BorderedSolution& r = weak.r;
    point.sigma = r.tau;
    point.mu = -s.tau;
    point.weak_direction = weak.direction;
    point.weak_left = weak.left;
    point.weak_eigenvalue = weak.eigenvalue;
    point.next_directions = weak.next;
    point.next_eigenvalues = weak.next_eigenvalues;
    point.border = border_;
    if (auto inertia = solver_.inertia(r.tau)) {
        // each independent constraint brings a negative eigenvalue of its own
        point.negative = inertia->negative - problem_.multipliers();
        point.eigenvalues = std::move(inertia->eigenvalues);
    }
    point.determinant_sign = solver_.sign_of_determinant(r.tau);
    if (theta_ == 0) {
        Eigen::VectorXd slope = s.x - s.tau / r.tau * r.x;
        choose_parameter_weight(q, p, weak, slope.allFinite() && !slope.isZero(0) ? slope : s.x);
    }
    point.tangent = {-s.tau * r.x + r.tau * s.x, r.tau};
    const double size = length(point.tangent);
    if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
    scale(point.tangent, 1 / size);
    if (along && dot(point.tangent, *along) < 0) flip(point.tangent);
    return point;
}

template <class Matrix>
void AnyBranchStepper<Matrix>::choose_parameter_weight(const AnyConfiguration& q, double p, const WeakDirection& weak,
                                                       const Eigen::VectorXd& slope) {
    const double moves = std::sqrt(slope.dot(weights_.cwiseProduct(slope))), span = options_.parameter_span;
    theta_ = std::isfinite(moves) ? moves : 0;
    if (span > 0) theta_ = std::max(theta_, 5 * options_.largest_step / span);
    // a state that hardly moves, as that of a straight column, says nothing of the scale of p: its eigenvalues do
    const Eigen::VectorXd& v = weak.direction;
    const Eigen::VectorXd& left = problem_.properties().symmetric ? v : weak.left;
    const Eigen::VectorXd change =
        problem_.tangent_derivative(q, p, slope) * v + problem_.parameter_derivative_along(q, p, v);
    double rate = std::abs(left.dot(change) / weak.eigenvalue);
    // at a start next to a critical point it is too large
    if (span > 0) rate = std::min(rate, 20 / span);
    if (std::isfinite(rate) && theta_ < 1e-3 * rate) theta_ = rate;
    if (!(theta_ > 0)) theta_ = 1;
}

template <class Matrix>
Eigen::MatrixXd AnyBranchStepper<Matrix>::weak_directions(const AnyConfiguration& q, double p, int count) {
    if (!factor(problem_.tangent(q, p))) return {};
    const Eigen::Index n = solver_.matrix().rows();
    const BorderedSolution r = solver_.solve(Eigen::VectorXd::Zero(n), 1);
    Eigen::MatrixXd v(n, count);
    for (Eigen::Index c = 0; c < count; ++c) v.col(c) = detail::generic_vector(n, c);
    const int rounds = 8;
    for (int round = 1; round <= rounds; ++round) {
        const Eigen::MatrixXd right = weights_.asDiagonal() * v;
        const BorderedSolutions f =
            round < rounds ? solver_.solve_roughly(right) : solver_.solve(right, Eigen::VectorXd::Zero(count));
        v = f.x - r.x * (f.tau / r.tau).transpose();
        detail::orthonormalize(v, weights_);
    }
    if (!v.allFinite()) return {};
    return v;
}

template <class Matrix>
Eigen::Index AnyBranchStepper<Matrix>::largest(const Eigen::VectorXd& v) const {
    const auto scaled = [&](Eigen::Index i) { return std::sqrt(weights_(i)) * std::abs(v(i)); };
    Eigen::Index best = 0;
    for (Eigen::Index i = 1; i < v.size() - problem_.multipliers(); ++i)
        if (scaled(i) > scaled(best)) best = i;
    return best;
}

template <class Matrix>
bool AnyBranchStepper<Matrix>::factor(Matrix&& k) {
    return detail::factor_with_border(solver_, std::move(k), weights_, problem_.multipliers(), border_);
}

}  // namespace equilibria
