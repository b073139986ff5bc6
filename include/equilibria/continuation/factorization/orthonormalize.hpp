/// \file
/// Gram and Schmidt's process, each vector twice (Giraud, Langou, Rozloznik, The loss of orthogonality in the
/// Gram-Schmidt orthogonalization process, Comput. Math. Appl. 50 (2005)).
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace equilibria::detail {

/// Makes the columns of v orthonormal by the weights, each against those before it.
inline void orthonormalize(Eigen::MatrixXd& v, const Eigen::VectorXd& weights) {
    for (Eigen::Index c = 0; c < v.cols(); ++c) {
        for (int twice = 0; twice < 2; ++twice)
            for (Eigen::Index b = 0; b < c; ++b) v.col(c) -= v.col(b).dot(weights.cwiseProduct(v.col(c))) * v.col(b);
        v.col(c) /= std::sqrt(v.col(c).dot(weights.cwiseProduct(v.col(c))));
    }
}

}  // namespace equilibria::detail
