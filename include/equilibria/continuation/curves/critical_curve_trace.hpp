/// \file
/// Curves of critical points followed in two parameters, with their special points:
///
///     const auto arches = [](double rise) { return ShallowArch{rise}; };
///     const auto curve = continue_folds(arches, fold, 2.5, -1, {.range = {1, 3}});
///     for (const auto& point : curve.branch.points) std::cout << point.p << ' ' << point.q.p << '\n';  // r, p
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/curves/critical_curve.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>

namespace equilibria {

/// A special point of a curve of critical points.
template <class Curve>
struct CriticalCurvePoint {
    /// On a fold curve: cusp; hilltop, where a second null vector joins; or, where r turns back in a bifurcation of the
    /// member, the kind of that. On a curve of bifurcations: hilltop, where the bifurcation equation degenerates and r
    /// turns back, or a second null vector joins; or, where gamma passes 0, the kind of the perfect bifurcation.
    CriticalKind kind;
    std::size_t step;         ///< between points step and step + 1
    Configuration<Curve> at;  ///< its configuration: p and q
    double r;                 ///< the second parameter there
    double residual;          ///< of the curve's equations, the largest entry
};

/// A curve of critical points: branch.points[k].p is r, and branch.points[k].q holds p and q.
template <class Curve>
struct CriticalCurveTrace {
    Branch<Curve> branch;                            ///< the curve as a branch in r
    std::vector<CriticalCurvePoint<Curve>> special;  ///< special points, in the order of the branch
};

namespace detail {

inline constexpr Interval any_value{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

template <class P>
CriticalConfiguration<Configuration<P>> configuration_of(const CriticalPoint<P>& point) {
    CriticalConfiguration<Configuration<P>> y;
    y.q = point.q;
    y.p = point.p;
    point.null_vector.cwiseAbs().maxCoeff(&y.border.column);
    point.left_null_vector.cwiseAbs().maxCoeff(&y.border.row);
    return y;
}

/// A change of p that moves the unknowns by 1.
template <class P>
double scale_of_parameter(const P& problem, const CriticalConfiguration<Configuration<P>>& y) {
    const BorderedTangent<P> b(problem, y);
    if (!b.regular) return 1;
    const double slope = std::sqrt(b.slope.x.dot(weights(problem, y.q, b.g.size()).cwiseProduct(b.slope.x)));
    return slope > 0 && std::isfinite(slope) ? 1 / slope : 1.0;
}

/// The smallest eigenvalue, by the weights, of K without its border: 0 where a second null vector joins the first.
template <class Curve>
double second_eigenvalue(const Curve& curve, const BranchPoint<Curve>& point) {
    const auto problem = curve.problem(point.p);
    const BorderedTangent b(problem, point.q);
    if (!b.regular) return 0;
    const Eigen::VectorXd w = weights(problem, point.q.q, b.g.size());
    Eigen::VectorXd v = generic_vector(b.g.size());
    for (int k = 0; k < 8; ++k) {
        v = b.solver.solve(w.cwiseProduct(v), 0).x;
        v /= std::sqrt(v.dot(w.cwiseProduct(v)));
    }
    return v.dot(b.k() * v);
}

template <class Curve>
struct CurveStart {
    Configuration<Curve> at;
    double r;
    int direction;  ///< 1: towards larger r, -1: smaller
};

/// Follows a curve from a point, with event functions, the first of which is the second eigenvalue; the points where
/// one of them vanishes are special, `kind_at` of its number. Where p leaves its range the curve ends.
template <class Curve, class KindAt>
CriticalCurveTrace<Curve> trace_curve(const Curve& curve, const CurveStart<Curve>& start,
                                      const ContinuationOptions& options, const Interval& p_range,
                                      std::vector<EventFunction<Curve>> functions, const KindAt& kind_at) {
    functions.insert(functions.begin(), {"second eigenvalue", [&curve](const BranchPoint<Curve>& point) {
                                             return second_eigenvalue(curve, point);
                                         }});
    const std::size_t special_functions = functions.size();
    for (const double bound : {p_range.low, p_range.high})
        if (std::isfinite(bound))
            functions.push_back(
                {"range of p", [bound](const BranchPoint<Curve>& point) { return point.q.p - bound; }, true});
    CriticalCurveTrace<Curve> trace;
    trace.branch = continue_branch(curve, start.at, start.r, start.direction, options, functions);
    for (const auto& [step, function, point] : trace.branch.crossings) {
        if (function >= special_functions) continue;
        trace.special.push_back(
            {function == 0 ? CriticalKind::hilltop : kind_at(function, point), step, point.q, point.p, point.residual});
        // it explains its step: there the curve's own tangent may be singular
        std::erase_if(trace.branch.unexplained, [at = step](const auto& u) { return u.step == at; });
    }
    return trace;
}

template <class P>
CriticalKind kind_of(const P& problem, const CriticalConfiguration<Configuration<P>>& at,
                     CriticalPointOptions options) {
    options.bifurcation_start = std::numeric_limits<double>::infinity();  // no fold is asked for
    CriticalPointSolver<P> solver(problem, options);
    const auto there = solver.solve(at.q, at.p, at.border);
    return there ? there->kind : CriticalKind::hilltop;
}

template <class Curve>
void sort_special(CriticalCurveTrace<Curve>& trace) {
    std::stable_sort(trace.special.begin(), trace.special.end(),
                     [](const auto& a, const auto& b) { return a.step < b.step; });
}

}  // namespace detail

/// Follows the folds of a parametric problem from one of them, found at the value r of the second parameter, towards
/// larger r (direction 1) or smaller (-1), through cusps. options.range bounds r, and p_range p: where p leaves it the
/// curve ends. Cusps, points where r turns back in a bifurcation, and points with a second null vector are located.
/// Without points where the curve cannot be started. Throws as continue_branch does.
template <ParametricProblem F>
CriticalCurveTrace<FoldCurve<F>> continue_folds(const F& problems, const CriticalPoint<detail::MemberOf<F>>& fold,
                                                double r, int direction, const ContinuationOptions& options = {},
                                                const Interval& p_range = detail::any_value) {
    const auto start = detail::configuration_of(fold);
    const FoldCurve<F> curve(problems, r, detail::scale_of_parameter(problems(r), start));
    auto trace = detail::trace_curve(curve, {start, r, direction}, options, p_range, {},
                                     [](std::size_t, const auto&) { return CriticalKind::hilltop; });
    for (const auto& [step, point] : trace.branch.events) {
        CriticalKind kind = point.kind;
        if (kind == CriticalKind::fold) {
            // at a cusp p turns back with r
            const Eigen::VectorXd own = point.null_vector.tail(point.null_vector.size() - 1);
            const bool cusp = std::abs(point.null_vector(0)) / curve.p_scale() < 1e-5 * own.norm();
            kind = cusp ? CriticalKind::cusp : detail::kind_of(problems(point.p), point.q, options.critical);
        } else if (std::any_of(trace.special.begin(), trace.special.end(),
                               [at = step](const auto& other) { return other.step == at; })) {
            continue;  // a hilltop by its second eigenvalue
        }
        trace.special.push_back({kind, step, point.q, point.p, point.residual});
    }
    detail::sort_special(trace);
    return trace;
}

/// Follows the bifurcation points of a parametric problem, as continue_folds does its folds. gamma stays 0 where a
/// symmetry keeps the bifurcation; where none does, the member bifurcates where gamma passes 0, which is located.
template <ParametricProblem F>
CriticalCurveTrace<BifurcationCurve<F>> continue_bifurcations(const F& problems,
                                                              const CriticalPoint<detail::MemberOf<F>>& point, double r,
                                                              int direction, const ContinuationOptions& options = {},
                                                              const Interval& p_range = detail::any_value) {
    using Curve = BifurcationCurve<F>;
    const auto start = detail::configuration_of(point);
    const auto member = problems(r);
    const Curve curve(problems, r, detail::scale_of_parameter(member, start));
    const double noise = 1e-10 * detail::largest_entry(member.tangent(point.q, point.p));
    auto trace = detail::trace_curve(
        curve, {start, r, direction}, options, p_range,
        {{"gamma", [noise](const BranchPoint<Curve>& at) { return std::abs(at.q.gamma) < noise ? 0.0 : at.q.gamma; }},
         {"dr/ds", [](const BranchPoint<Curve>& at) { return at.tangent.p; }}},
        [&](std::size_t function, const BranchPoint<Curve>& at) {
            return function == 1 ? detail::kind_of(problems(at.p), at.q, options.critical) : CriticalKind::hilltop;
        });
    detail::sort_special(trace);
    return trace;
}

}  // namespace equilibria
