// L D L^T of sparse symmetric matrices: solutions, inertia, multipliers, and what it refuses.
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using Sparse = Eigen::SparseMatrix<double>;

namespace {

/// A positive definite K of a chain of springs with a few random links, and constraints B below it: [K B^T; B 0].
Eigen::MatrixXd constrained(int n, int multipliers, Generator& generator) {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n + multipliers, n + multipliers);
    for (int i = 0; i < n; ++i) {
        k(i, i) += 1;
        if (i > 0) k(i, i) += 2, k(i - 1, i - 1) += 2, k(i, i - 1) -= 2, k(i - 1, i) -= 2;
    }
    for (int m = 0; m < multipliers; ++m)
        for (int i = 3 * m; i < 3 * m + 3; ++i) k(n + m, i) = k(i, n + m) = uniform(generator, -1, 1);
    return k;
}

int negative_eigenvalues(const Eigen::MatrixXd& k) {
    return static_cast<int>((tests::symmetric_eigen(k).values.array() < 0).count());
}

}  // namespace

TEST_CASE("A sparse LDLT solves with multipliers and counts negative eigenvalues") {
    Generator generator(1);
    for (int multipliers : {0, 1, 4}) {
        Eigen::MatrixXd k = constrained(20, multipliers, generator);
        SparseLDLT ldlt(multipliers);
        for (double shift : {0.0, -1.5, -4.0}) {  // the same pattern, other values
            k.topLeftCorner(20, 20).diagonal().array() += shift;
            REQUIRE(ldlt.factor(k.sparseView()));
            CHECK(ldlt.negative() == negative_eigenvalues(k));
            const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(k.rows(), -1, 1), x = ldlt.solve(f);
            CHECK((k * x - f).norm() < 1e-10 * (1 + x.norm()));
        }
    }
}

TEST_CASE("A sparse LDLT takes matrices of other patterns and sizes one after the other") {
    Generator generator(2);
    SparseLDLT ldlt;
    for (int n : {5, 12, 5}) {
        Eigen::MatrixXd k = constrained(n, 0, generator);
        k(0, n - 1) = k(n - 1, 0) = 0.5;
        REQUIRE(ldlt.factor(k.sparseView()));
        const Eigen::VectorXd f = Eigen::VectorXd::Ones(n);
        CHECK((k * ldlt.solve(f) - f).norm() < 1e-12);
        CHECK(ldlt.fill() >= n - 1);
    }
}

TEST_CASE("A sparse LDLT refuses a pivot of 0") {
    SparseLDLT ldlt;
    CHECK_FALSE(ldlt.factor(Eigen::MatrixXd::Ones(3, 3).sparseView()));
    CHECK(ldlt.factor(Eigen::MatrixXd(Eigen::Vector3d(1, -2, 3).asDiagonal()).sparseView()));
    CHECK(ldlt.negative() == 1);
}

TEST_CASE(
    "A sparse LDLT of random grids: every column solved, with an unknown removed, and the inertia of dense "
    "eigenvalues") {
    Generator generator(3);
    for (const int side : {1, 2, 7, 16}) {
        // blocks of three unknowns a node, coupled along a grid's edges and diagonals: wide and narrow supernodes
        const int n = 3 * side * side;
        std::vector<Eigen::Triplet<double>> entries;
        const auto couple = [&](int a, int b) {
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c) {
                    const double value = uniform(generator, -1, 1);
                    entries.emplace_back(3 * a + r, 3 * b + c, value);
                    entries.emplace_back(3 * b + c, 3 * a + r, value);
                }
        };
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const int at = j * side + i;
                couple(at, at);
                if (i + 1 < side) couple(at, at + 1);
                if (j + 1 < side) couple(at, at + side);
                if (i + 1 < side && j + 1 < side) couple(at, at + side + 1);
            }
        for (const double shift : {30.0, 3.0}) {  // definite, and not
            Sparse k(n, n);
            k.setFromTriplets(entries.begin(), entries.end());
            for (int i = 0; i < n; ++i) k.coeffRef(i, i) += i % 2 == 0 || shift > 10 ? shift : -shift;
            k.makeCompressed();
            SparseLDLT ldlt;
            for (const int removed : {-1, n / 2}) {
                Eigen::MatrixXd dense = k;
                if (removed >= 0) {
                    dense.row(removed).setZero();
                    dense.col(removed).setZero();
                    dense(removed, removed) = 2;
                }
                CAPTURE(side, shift, removed);
                REQUIRE(ldlt.factor(k, {removed, 2}));
                CHECK(ldlt.negative() == negative_eigenvalues(dense));
                Eigen::MatrixXd f(n, 5);
                for (auto& entry : f.reshaped()) entry = uniform(generator, -1, 1);
                const Eigen::MatrixXd x = ldlt.solve(f);
                CHECK((dense * x - f).norm() < 1e-9 * dense.norm() * x.norm());
                for (int c = 0; c < 5; ++c) CHECK((x.col(c) - ldlt.solve(f.col(c))).norm() < 1e-9 * (1 + x.norm()));
            }
        }
    }
}
