// MUMPS beside SparseLDLT and dense eigenvalues: solutions, inertia with constraints, redundant ones, and branches.
#include <Eigen/Core>

#include <equilibria/continuation/factorization/mumps.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#include <equilibria/core/random.hpp>

#include "support/back_ends.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using tests::saddle_point;
using tests::with_diagonal;

TEST_CASE("MUMPS has the inertia of dense eigenvalues on 200 random matrices with constraints") {
    MumpsFactors factors;
    int by_ldlt = 0;
    tests::for_each_saddle_point([&](const tests::RandomSaddlePoint& k) {
        CHECK(factors.factor(k.sparse) == (k.redundant == 0));
        CHECK(factors.negative() == k.negative);
        CHECK(factors.zero() == k.redundant);
        if (k.redundant > 0) return;
        const Eigen::VectorXd x = factors.solve(k.right_side);
        CHECK((k.dense * x - k.right_side).norm() < 1e-10 * (1 + k.largest * x.norm()));
        SparseLDLT ldlt(k.constraints);
        if (!ldlt.factor(k.sparse)) return;
        ++by_ldlt;
        CHECK(ldlt.negative() == k.negative);
        CHECK((ldlt.solve(k.right_side) - x).norm() < 1e-7 * (1 + x.norm()));
    });
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
