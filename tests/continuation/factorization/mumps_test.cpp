// MUMPS beside SparseLDLT and dense eigenvalues: solutions, inertia with constraints, redundant ones, and branches.
#include <algorithm>

#include <Eigen/Core>

#include <equilibria/continuation/factorization/mumps.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#include <equilibria/core/random.hpp>

#include "support/back_ends.hpp"
#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using tests::saddle_point;
using tests::with_diagonal;

TEST_CASE("MUMPS has the inertia of dense eigenvalues on 200 random matrices with constraints") {
    Generator generator(1);
    MumpsFactors factors;
    int by_ldlt = 0;
    for (int k = 0; k < 200; ++k) {
        CAPTURE(k);
        const int n = 10 + k % 40, constraints = k % 4, redundant = std::min(constraints, k % 3);
        const Eigen::MatrixXd dense = saddle_point(n, constraints, redundant, k % 2 == 0, generator);
        const auto sparse = with_diagonal(dense);
        const Eigen::VectorXd values = tests::symmetric_eigen(dense).values;
        const double largest = values.cwiseAbs().maxCoeff();
        const int negative = static_cast<int>((values.array() < -1e-10 * largest).count()),
                  zero = static_cast<int>((values.array().abs() <= 1e-10 * largest).count());
        REQUIRE(zero == redundant);
        CHECK(factors.factor(sparse) == (redundant == 0));
        CHECK(factors.negative() == negative);
        CHECK(factors.zero() == redundant);
        if (redundant > 0) continue;
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(dense.rows(), -1, 1), x = factors.solve(f);
        CHECK((dense * x - f).norm() < 1e-10 * (1 + largest * x.norm()));
        SparseLDLT ldlt(constraints);
        if (!ldlt.factor(sparse)) continue;
        ++by_ldlt;
        CHECK(ldlt.negative() == negative);
        CHECK((ldlt.solve(f) - x).norm() < 1e-7 * (1 + x.norm()));
    }
    CHECK(by_ldlt > 80);
}

TEST_CASE("MUMPS analyses a pattern once and takes another one") {
    Generator generator(2);
    MumpsFactors factors;
    for (const int n : {30, 30, 12, 30}) {
        const Eigen::MatrixXd dense = saddle_point(n, 2, 0, false, generator);
        REQUIRE(factors.factor(with_diagonal(dense)));
        const Eigen::VectorXd f = Eigen::VectorXd::Ones(dense.rows());
        CHECK((dense * factors.solve(f) - f).norm() < 1e-10 * (1 + factors.solve(f).norm()));
        REQUIRE(factors.factor(with_diagonal(2 * dense)));
        CHECK((2 * dense * factors.solve(f) - f).norm() < 1e-10 * (1 + factors.solve(f).norm()));
        CHECK(factors.fill() >= n);
    }
}

TEST_CASE("A branch has the same points and critical points by every back end") {
    tests::check_branch(sparse_ldlt);
    tests::check_branch(mumps);
}
