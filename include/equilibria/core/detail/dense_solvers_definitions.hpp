/// \file
/// See core/dense_solvers.hpp.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

#include <equilibria/core/dense_solvers.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double threshold) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(threshold);
    return solver.compute(a).solve(b);
}

EQUILIBRIA_INLINE double determinant(const Eigen::MatrixXd& a) { return a.determinant(); }

}  // namespace equilibria::detail
