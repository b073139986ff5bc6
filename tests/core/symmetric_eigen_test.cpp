// Jacobi's rotations: a = Q diag(values) Q^T with orthonormal Q, and small eigenvalues of graded matrices to all
// digits.
#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <equilibria/core/random.hpp>
#include <equilibria/core/symmetric_eigen.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("A symmetric matrix is its eigenvectors and eigenvalues") {
    Generator generator(1);
    for (int n : {1, 2, 5, 9})
        for (int round = 0; round < 20; ++round) {
            Eigen::MatrixXd a(n, n);
            for (int i = 0; i < n; ++i)
                for (int j = 0; j <= i; ++j) a(i, j) = a(j, i) = uniform(generator, -1, 1);
            const SymmetricEigen<Eigen::MatrixXd> eigen(a);
            const Eigen::MatrixXd& q = eigen.vectors;
            CHECK((q.transpose() * q - Eigen::MatrixXd::Identity(n, n)).norm() < 1e-13);
            CHECK((q * eigen.values.asDiagonal() * q.transpose() - a).norm() < 1e-13);
            CHECK((symmetric_eigenvalues(a) - eigen.values).norm() < 1e-13);
        }
}

TEST_CASE("The small eigenvalue of a graded matrix is right to its last digits") {
    Eigen::Matrix2d a;
    a << 1, 1e-8, 1e-8, 1e-15;
    Eigen::Vector2d values = symmetric_eigenvalues(a);
    std::sort(values.begin(), values.end());
    // the product of both is det a = 1e-15 - 1e-16
    CHECK(values(0) * values(1) == Approx(9e-16).epsilon(1e-14));
}

TEST_CASE("Equal eigenvalues and a diagonal matrix stay as they are") {
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    CHECK(symmetric_eigenvalues(identity) == Eigen::Vector3d::Ones());
    const SymmetricEigen<Eigen::Matrix3d> eigen(Eigen::Vector3d(3, -1, 3).asDiagonal().toDenseMatrix());
    CHECK(eigen.values == Eigen::Vector3d(3, -1, 3));
    CHECK(eigen.vectors == identity);
}

TEST_CASE("Entries whose squares no double holds") {
    Eigen::Matrix2d a;
    a << 2, 1, 1, 2;
    for (const double size : {1e-250, 1e-120, 1e120, 1e250}) {
        Eigen::Vector2d values = symmetric_eigenvalues(Eigen::Matrix2d(size * a));
        std::sort(values.begin(), values.end());
        CHECK(values(0) == Approx(size).epsilon(1e-14));
        CHECK(values(1) == Approx(3 * size).epsilon(1e-14));
    }
}
