/// \file
/// See core/dense_solvers.hpp: what is rare, and takes long to compile.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <equilibria/core/dense_solvers.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double threshold) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(threshold);
    return solver.compute(a).solve(b);
}

EQUILIBRIA_INLINE Eigen::VectorXd generalized_eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b).eigenvalues();
}

EQUILIBRIA_INLINE Eigen::MatrixXd positive_inverse(const Eigen::MatrixXd& a) {
    return a.llt().solve(Eigen::MatrixXd::Identity(a.rows(), a.cols()));
}

}  // namespace equilibria::detail
