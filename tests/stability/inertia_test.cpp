#include <cmath>
#include <random>

#include <Eigen/Core>

#include <equilibria/core/random.hpp>
#include <equilibria/stability/inertia.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;

namespace {

/// Q^T D Q with a random orthogonal Q: known eigenvalues.
Eigen::MatrixXd with_eigenvalues(const Eigen::VectorXd& values, Generator& generator) {
    Eigen::MatrixXd a(values.size(), values.size());
    for (int i = 0; i < a.rows(); ++i)
        for (int j = 0; j < a.cols(); ++j) a(i, j) = uniform(generator, -1, 1);
    const Eigen::MatrixXd q = tests::orthogonal_factor(a), m = q.transpose() * values.asDiagonal() * q;
    return 0.5 * (m + m.transpose());
}

void check(const Inertia& y, int negative, int zero, int positive) {
    CHECK(y.negative == negative);
    CHECK(y.zero == zero);
    CHECK(y.positive == positive);
}

}  // namespace

TEST_CASE("inertia of matrices with known eigenvalues") {
    Generator generator(1);
    for (int k = 0; k < 100; ++k) {
        Eigen::Matrix<double, 5, 1> values;
        int negative = 0;
        for (int i = 0; i < 5; ++i) {
            values(i) = uniform(generator, 0.01, 10) * (uniform(generator) < 0.5 ? -1 : 1);
            negative += values(i) < 0;
        }
        const Inertia y = inertia(with_eigenvalues(values, generator));
        check(y, negative, 0, 5 - negative);
        const double margin = values.cwiseAbs().minCoeff() / values.cwiseAbs().maxCoeff();
        CHECK(y.margin == Approx(margin).epsilon(1e-10));
    }
}

TEST_CASE("eigenvalues of a graded positive definite matrix, each to full relative accuracy") {
    // D A D with A well conditioned: Jacobi's method loses no small eigenvalue beside a large one (Demmel and Veselic);
    // det (D A D) = det A det D^2 is the check; D holds powers of two, which change no digit
    Generator generator(4);
    for (int k = 0; k < 20; ++k) {
        const Eigen::Matrix4d a = with_eigenvalues(Eigen::Vector4d(1, 1.5, 2, 3), generator);
        const Eigen::Vector4d d(std::ldexp(1.0, 30), 1, std::ldexp(1.0, -20), std::ldexp(1.0, -40));
        const Eigen::Vector4d values = symmetric_eigenvalues<Eigen::Matrix4d>(d.asDiagonal() * a * d.asDiagonal());
        CHECK(values.minCoeff() > 0);
        CHECK(values.prod() == Approx(9 * std::ldexp(1.0, -60)).epsilon(1e-13));
    }
}

TEST_CASE("Sylvester's law: a congruence keeps the inertia") {
    Generator generator(2);
    for (int k = 0; k < 100; ++k) {
        const Eigen::Matrix4d a = with_eigenvalues(Eigen::Vector4d(-3, -0.5, 1, 4), generator);
        Eigen::Matrix4d b = Eigen::Matrix4d::Identity();
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j) b(i, j) = uniform(generator, -1, 1);
        check(inertia(Eigen::Matrix4d(b.transpose() * a * b)), 2, 0, 2);
        check(inertia(Eigen::Matrix4d(-a)), 2, 0, 2);
        check(inertia(Eigen::Matrix4d(1e-200 * a)), 2, 0, 2);
        check(inertia(Eigen::Matrix4d(1e200 * a)), 2, 0, 2);
    }
}

TEST_CASE("eigenvalues that are zero beside the largest") {
    Generator generator(3);
    check(inertia(with_eigenvalues(Eigen::Vector3d(-1, 0, 1), generator)), 1, 1, 1);
    check(inertia(with_eigenvalues(Eigen::Vector3d(-1, 1e-6, 1), generator)), 1, 0, 2);
    check(inertia(with_eigenvalues(Eigen::Vector3d(-1, 1e-8, 1), generator)), 1, 1, 1);
    check(inertia(with_eigenvalues(Eigen::Vector3d(-1e-3, -1e-11, 1e-3), generator)), 1, 1, 1);
    check(inertia(Eigen::Matrix3d(Eigen::Matrix3d::Zero())), 0, 3, 0);
    CHECK(inertia(Eigen::Matrix3d(Eigen::Matrix3d::Zero())).margin == 0);
    check(inertia(Eigen::Matrix<double, 1, 1>(-2.0)), 1, 0, 0);
}

TEST_CASE("a matrix that is not finite has no sign") {
    Eigen::Matrix2d a = Eigen::Matrix2d::Identity();
    a(0, 1) = a(1, 0) = std::nan("");
    CHECK(inertia(a).zero == 2);
}

TEST_CASE("dynamic sizes and long double") {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(6, 6);
    a.diagonal() << -1, -2, 3, 4, 5, 0;
    check(inertia(a), 2, 1, 3);
    Eigen::Matrix<long double, 2, 2> b;
    b << 1, 2, 2, 1;
    check(inertia(b), 1, 0, 1);
}
