/// \file
/// Dense linear algebra of doubles by Eigen, each of its decompositions compiled in one place.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/compiled.hpp>

namespace equilibria::detail {

/// The least x with the least |A x - b|, singular values below `threshold` of the largest one counting as zero.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double threshold);

double determinant(const Eigen::MatrixXd& a);

/// The eigenvalues of A x = lambda B x, rising; both symmetric, B positive definite.
Eigen::VectorXd generalized_eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// x of A x = b.
Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// The inverse of a symmetric positive definite matrix.
Eigen::MatrixXd positive_inverse(const Eigen::MatrixXd& a);

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/dense_solvers_definitions.hpp>
#include <equilibria/core/detail/orthogonal_solvers_definitions.hpp>
#endif
