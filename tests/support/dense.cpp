#include "support/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace tests {

Eigen::VectorXd solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) { return a.partialPivLu().solve(b); }
Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) { return a.inverse(); }
double determinant(const Eigen::MatrixXd& a) { return a.determinant(); }
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& a) { return a.householderQr().householderQ(); }

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& a) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(a, false).eigenvalues();
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(a);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

SingularDecomposition singular_decomposition(const Eigen::MatrixXd& a) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

}  // namespace tests
