// CHOLMOD beside dense eigenvalues: solutions and inertia with constraints, by both of its factorizations, and a
// branch.
#include <Eigen/Core>

#include <equilibria/continuation/factorization/cholmod.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#include <equilibria/core/random.hpp>

#include "support/back_ends.hpp"
#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using tests::saddle_point;
using tests::with_diagonal;

TEST_CASE("CHOLMOD has the inertia of dense eigenvalues on random matrices with constraints, as SparseLDLT") {
    int factored = 0;
    tests::for_each_saddle_point([&](const tests::RandomSaddlePoint& k) {
        if (k.redundant > 0) return;
        CholmodFactors factors(k.constraints);
        SparseLDLT ldlt(k.constraints);
        REQUIRE(factors.factor(k.sparse));
        REQUIRE(ldlt.factor(k.sparse));
        ++factored;
        CHECK(factors.negative() == k.negative);
        CHECK(factors.fill() >= k.dense.rows());
        const Eigen::VectorXd x = factors.solve(k.right_side);
        CHECK((ldlt.solve(k.right_side) - x).norm() < 1e-7 * (1 + x.norm()));
    });
    CHECK(factored == 100);
}

TEST_CASE("CHOLMOD leaves an unknown out, and finds what is singular") {
    Generator generator(2);
    CholmodFactors factors;
    for (const bool definite : {true, false, true}) {
        Eigen::MatrixXd dense = saddle_point(20, 0, 0, definite, generator);
        const auto k = with_diagonal(dense);
        dense.row(3).setZero();
        dense.col(3).setZero();
        dense(3, 3) = 5;
        REQUIRE(factors.factor(k, {3, 5}));
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(20, 1, 2), x = factors.solve(f);
        CHECK((dense * x - f).norm() < 1e-9 * (1 + x.norm()));
        CHECK(factors.negative() == (tests::symmetric_eigen(dense).values.array() < 0).count());
    }
    CHECK_FALSE(factors.factor(with_diagonal(Eigen::MatrixXd::Zero(3, 3))));
    CHECK(factors.factor(with_diagonal(-Eigen::MatrixXd::Identity(3, 3))));
    CHECK(factors.negative() == 3);
}

TEST_CASE("A branch has the same points and critical points by CHOLMOD") { tests::check_branch(cholmod); }
