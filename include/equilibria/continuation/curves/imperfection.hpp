/// \file
/// Imperfections: g(q, p) + gamma shape = 0, and knock-down curves, the limit load against gamma. With the unfolding
/// variable gamma as the second parameter a bifurcation point is an ordinary point of the fold curve.
///
/// At a pitchfork whose side branch has p = p_c + curvature x^2 / 2, curvature < 0, the limit load falls by
/// 3/2 |curvature|^(1/3) (psi . shape gamma / b)^(2/3) to first order: Koiter's two-thirds power law.
/// Source: Koiter, On the Stability of Elastic Equilibrium (1945); Cardona and Huespe (1999), equation (29).
#pragma once

#include <utility>

#include <equilibria/continuation/curves/critical_curve_trace.hpp>

namespace equilibria {

/// g(q, p) + gamma shape: a dead load `shape` that the structure carries besides p.
template <ContinuationProblem P>
class ImperfectProblem {
public:
    using Configuration = equilibria::Configuration<P>;      ///< as of the perfect problem
    using Vector = Eigen::VectorXd;                          ///< residuals and increments
    static constexpr bool symmetric = symmetric_tangent<P>;  ///< the load is dead: K stays as it is

    /// shape: as many entries as unknowns; gamma: its size.
    ImperfectProblem(P perfect, Vector shape, double gamma)
        : perfect_(std::move(perfect)), shape_(std::move(shape)), gamma_(gamma) {}

    /// A function of a continuation problem (problem.hpp): the perfect problem's, with gamma shape added to g.
    /// \{
    Vector residual(const Configuration& q, double p) const { return perfect_.residual(q, p) + gamma_ * shape_; }
    TangentMatrix<P> tangent(const Configuration& q, double p) const { return perfect_.tangent(q, p); }
    Vector parameter_derivative(const Configuration& q, double p) const { return perfect_.parameter_derivative(q, p); }

    Configuration retract(const Configuration& q, const Vector& d) const { return equilibria::retract(perfect_, q, d); }
    Vector transport(const Configuration& q, const Vector& d, const Vector& v) const {
        return equilibria::transport(perfect_, q, d, v);
    }
    Vector difference(const Configuration& q, const Configuration& near) const {
        return equilibria::difference(perfect_, q, near);
    }
    Configuration rebase(const Configuration& q, double p) const { return equilibria::rebase(perfect_, q, p); }
    Vector weights(const Configuration& q) const { return equilibria::weights(perfect_, q, shape_.size()); }
    TangentMatrix<P> tangent_derivative(const Configuration& q, double p, const Vector& v) const {
        return equilibria::tangent_derivative(perfect_, q, p, v);
    }
    Vector parameter_derivative_along(const Configuration& q, double p, const Vector& v) const {
        return equilibria::parameter_derivative_along(perfect_, q, p, v);
    }
    Vector second_parameter_derivative(const Configuration& q, double p) const {
        return equilibria::second_parameter_derivative(perfect_, q, p);
    }
    int multipliers() const { return equilibria::multipliers(perfect_); }
    /// \}

private:
    P perfect_;
    Vector shape_;
    double gamma_;
};

/// Imperfections gamma of one shape, as a parametric problem.
template <ContinuationProblem P>
struct ImperfectProblems {
    P perfect;              ///< the problem with gamma = 0
    Eigen::VectorXd shape;  ///< the load of gamma = 1
    /// The member with this gamma.
    ImperfectProblem<P> operator()(double gamma) const { return {perfect, shape, gamma}; }
};

/// Limit loads against the size gamma of an imperfection, on both sides of the perfect structure:
/// points[k].p is gamma, points[k].q.p the limit load.
template <ContinuationProblem P>
using KnockDownCurve = Branch<FoldCurve<ImperfectProblems<P>>>;

/// The knock-down curve from a critical point of the perfect structure: a bifurcation with a simple null vector, or a
/// fold. shape: the imperfection, by default the null vector, as a load. options.range.low and high bound gamma. Two
/// half curves, which leave the critical point in opposite directions along the null vector: at a pitchfork gamma is of
/// opposite sign on them. Fewer where one cannot be started. Throws InvalidArgument where the shape has not the size of
/// the unknowns or does no work along the null vector, and for options out of range.
template <ContinuationProblem P>
std::vector<KnockDownCurve<P>> knock_down_curves(const P& perfect, const CriticalPoint<P>& point,
                                                 ContinuationOptions options, Eigen::VectorXd shape = {}) {
    options.validate();
    require(point.nullity == 1, "point.nullity", point.nullity, "must be 1");
    if (shape.size() == 0) shape = point.null_vector;
    require(shape.size() == point.null_vector.size(), "shape.size()", shape.size(),
            "must be the number of unknowns, " + std::to_string(point.null_vector.size()));
    const double work = std::abs(point.left_null_vector.dot(shape));
    require(work > 1e-8 * point.left_null_vector.norm() * shape.norm(), "shape", work,
            "must do work along the null vector");
    // gamma as the displacement that its load would cause were K its largest entry: at the critical point itself it
    // causes an infinite one
    if (options.branch.parameter_weight == 0)
        options.branch.parameter_weight = shape.norm() / detail::largest_entry(perfect.tangent(point.q, point.p));
    const ImperfectProblems<P> problems{perfect, std::move(shape)};
    const auto start = detail::configuration_of(point);
    const FoldCurve<ImperfectProblems<P>> curve(problems, 0.0, detail::scale_of_parameter(problems(0.0), start));
    std::vector<KnockDownCurve<P>> halves;
    for (const double side : {1.0, -1.0}) {
        BranchStepper<FoldCurve<ImperfectProblems<P>>> stepper(curve, options.stepping());
        Direction along{Eigen::VectorXd::Zero(point.null_vector.size() + 1), 0};
        along.q.tail(point.null_vector.size()) = side * point.null_vector;
        auto first = stepper.assess(start, 0, along);
        if (!first) continue;
        first->proposed_step = options.branch.first_step;
        halves.push_back(follow(stepper, *first, options));
    }
    return halves;
}

}  // namespace equilibria
