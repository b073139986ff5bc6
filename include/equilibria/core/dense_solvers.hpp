/// \file
/// Dense linear algebra of doubles by Eigen, each of its decompositions compiled in one place.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/compiled.hpp>

namespace equilibria::detail {

/// The least x with the least |A x - b|, singular values below `threshold` of the largest one counting as zero.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double threshold);

double determinant(const Eigen::MatrixXd& a);

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/dense_solvers_definitions.hpp>
#endif
