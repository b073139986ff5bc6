/// \file
/// Pitchforks of a symmetric branch in a plane of two parameters.
#pragma once

#include <limits>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/curves/bordered_tangent.hpp>
#include <equilibria/locus/plane/plane_problems.hpp>

namespace equilibria {

/// Where the tangent is singular on a branch q = const, in the plane of the parameters X and Y: sigma(x; y) = 0, a
/// continuation problem in one unknown, x. It is regular where curves of bifurcation points in general are not: where
/// the curve turns back in y.
class PitchforkCurve {
public:
    using Problems = PlaneProblems;  ///< give a problem in x for each y
    using Problem = PlaneProblem;    ///< one of these
    /// The branch's q, and x as its p.
    using Configuration = CriticalConfiguration<equilibria::Configuration<Problem>>;
    static constexpr bool symmetric = false;  ///< the tangent, 1 x 1, is taken for unsymmetric

    /// x_scale: a change of x that counts as much as one of 1.
    PitchforkCurve(Problems problems, double x_scale) : problems_(std::move(problems)), x_scale_(x_scale) {}

    /// A function of a continuation problem (continuation/problem.hpp).
    /// \{
    Eigen::VectorXd residual(const Configuration& at, double y) const {
        const BorderedTangent<Problem> b(problems_(y), at);
        return Eigen::VectorXd::Constant(1, b.regular ? b.sigma() : std::numeric_limits<double>::quiet_NaN());
    }
    Eigen::MatrixXd tangent(const Configuration& at, double y) const {
        return Eigen::MatrixXd::Constant(1, 1, derivative(0, at, y));
    }
    Eigen::VectorXd parameter_derivative(const Configuration& at, double y) const {
        return Eigen::VectorXd::Constant(1, derivative(1, at, y));
    }
    Configuration retract(const Configuration& at, const Eigen::VectorXd& d) const {
        Configuration moved = at;
        moved.p += d(0);
        return moved;
    }
    Eigen::VectorXd difference(const Configuration& at, const Configuration& near) const {
        return Eigen::VectorXd::Constant(1, near.p - at.p);
    }
    Configuration rebase(const Configuration& at, double y) const { return with_best_border(problems_(y), at); }
    Eigen::VectorXd weights(const Configuration&) const {
        return Eigen::VectorXd::Constant(1, 1 / (x_scale_ * x_scale_));
    }
    /// \}

private:
    /// d sigma = -psi^T dK r, along x (axis 0) or y.
    double derivative(int axis, const Configuration& at, double y) const {
        const Problem problem = problems_(y);
        const BorderedTangent<Problem> b(problem, at);
        if (!b.regular) return std::numeric_limits<double>::quiet_NaN();
        return -b.left.x.dot(problem.tangent_by_parameter(axis, at.q, at.p, b.null.x));
    }

    Problems problems_;
    double x_scale_;
};

}  // namespace equilibria
