// Sylvester's minors against the inertia, on matrices whose inertia is known.
#include <Eigen/Core>

#include <equilibria/core/random.hpp>
#include <equilibria/stability/lagrange_dirichlet.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;

TEST_CASE("Sylvester's minors and the inertia agree, and congruence keeps both verdicts") {
    Generator generator(1);
    int stable = 0;
    for (int k = 0; k < 500; ++k) {
        const int n = 1 + k % 6;
        const int negative = k % 3 == 0 ? 0 : k % (n + 1);
        Eigen::VectorXd diagonal(n);
        for (int i = 0; i < n; ++i) diagonal[i] = (i < negative ? -1 : 1) * uniform(generator, 0.5, 2);
        const Eigen::MatrixXd turn = Eigen::MatrixXd::Identity(n, n) + 0.4 * Eigen::MatrixXd::NullaryExpr(n, n, [&] {
                                                                           return uniform(generator, -1, 1);
                                                                       });
        const Eigen::MatrixXd hessian = turn * diagonal.asDiagonal() * turn.transpose();
        const auto y = lagrange_dirichlet(hessian);
        CAPTURE(n, negative, hessian);
        if (y.inertia.zero > 0) continue;
        CHECK(y.inertia.negative == negative);
        CHECK(y.agree());
        CHECK(y.verdict() == (negative == 0 ? PotentialVerdict::stable : PotentialVerdict::unstable));
        CHECK(y.minors[n - 1] == Approx(tests::determinant(hessian)).epsilon(1e-10));
        stable += negative == 0;
    }
    CHECK(stable > 100);
}

TEST_CASE("A singular Hessian without a negative direction decides nothing") {
    const auto flat = lagrange_dirichlet(Eigen::Matrix2d{{1, 1}, {1, 1}});
    CHECK(flat.verdict() == PotentialVerdict::undecided);
    CHECK(flat.agree());
    const auto saddle = lagrange_dirichlet(Eigen::Matrix3d{{0, 0, 0}, {0, -1, 0}, {0, 0, 1}});
    CHECK(saddle.verdict() == PotentialVerdict::unstable);
    // the holonomic mechanism's first equilibrium (Vesovic and Radulovic 2022, Table 2)
    const auto first = lagrange_dirichlet(Eigen::Matrix2d{{111.015, -208.317}, {-208.317, -306.19}});
    CHECK(first.minors[1] == Approx(-77387.7).epsilon(1e-5));
    CHECK(first.verdict() == PotentialVerdict::unstable);
}
