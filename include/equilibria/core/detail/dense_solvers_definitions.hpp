/// \file
/// See core/dense_solvers.hpp.
#pragma once

#include <Eigen/LU>

#include <equilibria/core/dense_solvers.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE double determinant(const Eigen::MatrixXd& a) { return a.determinant(); }

EQUILIBRIA_INLINE Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    return a.partialPivLu().solve(b);
}

}  // namespace equilibria::detail
