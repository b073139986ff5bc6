/// \file
/// Where along a branch the weakest eigenvalues of K vanish, all together, as far as their derivatives at one point
/// tell: K restricted to the span of their directions, linear along the branch, is singular where a small eigenvalue
/// problem says, also where eigenvalues are so close that they change places (first-order degenerate perturbation
/// theory; Kato, Perturbation Theory for Linear Operators, section II.2).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <equilibria/continuation/branch_stepper.hpp>

namespace equilibria::detail {

/// What dK/ds along the branch, s its arc length, makes of the columns of v.
template <class Matrix>
Eigen::MatrixXd derivative_along(const AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& from,
                                 const Eigen::MatrixXd& v) {
    const AnyProblem<Matrix>& problem = stepper.problem();
    const Eigen::VectorXd& t = from.tangent.q;
    if (problem.properties().tangent_derivative) {
        Eigen::MatrixXd y = problem.tangent_derivative(from.q, from.p, t) * v;
        for (Eigen::Index k = 0; k < v.cols(); ++k)
            y.col(k) += from.tangent.p * problem.parameter_derivative_along(from.q, from.p, v.col(k));
        return y;
    }
    // differences along the tangent, which is of length 1
    const double h = third_root_of_rounding;
    const auto at = [&](double by) {
        const Matrix k =
            problem.tangent(problem.retract(from.q, Eigen::VectorXd(by * t)), from.p + by * from.tangent.p);
        return problem.properties().symmetric ? symmetric_product(k, v) : Eigen::MatrixXd(k * v);
    };
    return (at(h) - at(-h)) / (2 * h);
}

/// Where an eigenvalue is predicted to vanish: how far along the branch, in arc length, and its direction there.
struct PredictedZero {
    double s;
    Eigen::VectorXd direction;
};
/// The zeros, up to `reach` along the branch both ways, of so many of the weakest eigenvalues of a symmetric K, by s.
/// It factors K there. Empty where K is singular to rounding.
template <class Matrix>
std::vector<PredictedZero> predicted_zeros(AnyBranchStepper<Matrix>& stepper, const BranchPoint<Erased>& from,
                                           int count, double reach) {
    const Eigen::MatrixXd v = stepper.weak_directions(from.q, from.p, count + 2);
    if (v.size() == 0) return {};
    const Eigen::MatrixXd k = v.transpose() * symmetric_product(stepper.solver().matrix(), v),
                          slope = v.transpose() * derivative_along(stepper, from, v);
    // (k + s slope) y = 0
    const Eigen::EigenSolver<Eigen::MatrixXd> eigen(-k.partialPivLu().solve(slope));
    std::vector<PredictedZero> y;
    for (Eigen::Index i = 0; i < v.cols(); ++i) {
        const std::complex<double> inverse = eigen.eigenvalues()(i);
        const double s = 1 / inverse.real();
        if (std::abs(inverse.imag()) < 1e-9 * std::abs(inverse) && std::abs(s) < reach)
            y.push_back({s, v * eigen.eigenvectors().col(i).real()});
    }
    std::sort(y.begin(), y.end(), [](const PredictedZero& one, const PredictedZero& other) { return one.s < other.s; });
    return y;
}

}  // namespace equilibria::detail
