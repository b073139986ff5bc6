// Symmetric positive definite systems: residuals of solutions, what is not positive definite, and the condition against
// that of Eigen's inverse.
#include <cmath>
#include <limits>

#include <equilibria/core/cholesky.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using detail::Cholesky;

namespace {

template <int N, int Columns>
Eigen::Matrix<double, N, Columns> random_matrix(Generator& generator) {
    Eigen::Matrix<double, N, Columns> a;
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < Columns; ++k) a(i, k) = uniform(generator, -1, 1);
    return a;
}

double norm_of(const Eigen::MatrixXd& a) { return a.cwiseAbs().colwise().sum().maxCoeff(); }

template <int N>
void check_size(Generator& generator) {
    CAPTURE(N);
    for (int trial = 0; trial < 20; ++trial) {
        const auto root = random_matrix<N, N>(generator);
        typename Cholesky<N>::Matrix a = root * root.transpose();
        a.diagonal().array() += 0.01;
        const Cholesky<N> factor(a);
        REQUIRE(factor.positive());
        const auto b = random_matrix<N, 3>(generator);
        const auto x = factor.template solve<3>(b);
        CHECK((a * x - b).norm() < 1e-13 * N * (1 + norm_of(a) * norm_of(x)));
        const Eigen::Vector<double, N> first = b.col(0);
        CHECK((factor.solve(first) - x.col(0)).norm() == 0);
        CHECK(factor.reciprocal_condition(a) == Approx(1 / (norm_of(a) * norm_of(tests::inverse(a)))).epsilon(1e-9));
    }
}

}  // namespace

TEST_CASE("Symmetric positive definite systems of all sizes are solved to rounding") {
    Generator generator(1);
    check_size<1>(generator);
    check_size<2>(generator);
    check_size<3>(generator);
    check_size<6>(generator);
    check_size<13>(generator);
}

TEST_CASE("The upper triangle of a matrix to be factorised is not read") {
    Eigen::Matrix3d a;
    a << 4, 7, 8, 1, 5, 9, 2, 1, 6;
    const Eigen::Matrix3d symmetric = a.selfadjointView<Eigen::Lower>();
    const Eigen::Vector3d b(1, -2, 3);
    CHECK((symmetric * Cholesky<3>(a).solve(b) - b).norm() < 1e-14);
}

TEST_CASE("What is not positive definite is told, and what is hardly so has a small reciprocal condition") {
    CHECK(!Cholesky<1>(Cholesky<1>::Matrix(0.0)).positive());
    CHECK(!Cholesky<1>(Cholesky<1>::Matrix(-2.0)).positive());
    Eigen::Matrix2d a;
    a << 1, 2, 2, 4;
    CHECK(!Cholesky<2>(a).positive());
    a(1, 1) = 3;
    CHECK(!Cholesky<2>(a).positive());
    a(0, 0) = 0;
    CHECK(!Cholesky<2>(a).positive());
    for (const double small : {1e-3, 1e-8, 1e-14}) {
        a << 1, 1, 1, 1 + small;
        const Cholesky<2> factor(a);
        REQUIRE(factor.positive());
        // |A| = 2 + small, |A^-1| = (2 + small) / small
        const double condition = (2 + small) * (2 + small) / small;
        CHECK(factor.reciprocal_condition(a) == Approx(1 / condition).epsilon(2e-16 / small + 1e-12));
    }
}

TEST_CASE("What is no number passes a factorisation, and shows in the solution and in the condition") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (int place = 0; place < 3; ++place) {
        Eigen::Matrix3d a = Eigen::Matrix3d::Identity();
        a(place, place) = none;
        const Cholesky<3> factor(a);
        CHECK(factor.positive());
        CHECK(!factor.solve(Eigen::Vector3d(1, 1, 1)).allFinite());
        CHECK(!(factor.reciprocal_condition(a) > 0));
    }
}
