// CHOLMOD beside dense eigenvalues: solutions and inertia with constraints, by both of its factorizations, and a
// branch.
#include <Eigen/Core>

#include <equilibria/continuation/factorization/cholmod.hpp>
#include <equilibria/core/random.hpp>

#include "support/back_ends.hpp"
#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using tests::saddle_point;
using tests::with_diagonal;

TEST_CASE("CHOLMOD has the inertia of dense eigenvalues on 200 random matrices with constraints") {
    Generator generator(1);
    CholmodFactors factors;
    int factored = 0;
    for (int k = 0; k < 200; ++k) {
        CAPTURE(k);
        const int constraints = k % 4;
        const Eigen::MatrixXd dense = saddle_point(10 + k % 40, constraints, 0, k % 2 == 0, generator);
        const Eigen::VectorXd values = tests::symmetric_eigen(dense).values;
        const int negative = static_cast<int>((values.array() < 0).count());
        const bool done = factors.factor(with_diagonal(dense));
        if (k % 2 == 0 && constraints == 0) CHECK((done && negative == 0));
        if (!done) continue;  // without pivoting a pivot may be 0: a multiplier's, where it comes before its unknowns
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(dense.rows(), -1, 1), x = factors.solve(f);
        const double left = (dense * x - f).norm() / (1 + values.cwiseAbs().maxCoeff() * x.norm());
        if (left > 1e-9) continue;  // nor is it safe
        ++factored;
        CHECK(factors.negative() == negative);
        CHECK(factors.fill() >= dense.rows());
    }
    CHECK(factored > 50);
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
