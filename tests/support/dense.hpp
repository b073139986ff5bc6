// Dense linear algebra to check ours with: Eigen's, compiled once for all tests.
#pragma once

#include <Eigen/Core>

namespace tests {

/// The solution of a x = b.
Eigen::VectorXd solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);
double determinant(const Eigen::MatrixXd& a);
/// An orthogonal matrix: the factor Q of a = Q R.
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& a);

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a);

/// a = vectors diag(values) vectors^T of a symmetric matrix, values in increasing order.
struct SymmetricEigen {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a);

/// a = left diag(values) right^T, values in decreasing order.
struct SingularDecomposition {
    Eigen::MatrixXd left;
    Eigen::VectorXd values;
    Eigen::MatrixXd right;
};
SingularDecomposition singular_decomposition(const Eigen::MatrixXd& a);

}  // namespace tests
