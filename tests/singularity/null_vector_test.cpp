// Null vectors of matrices whose null space is known: of rank one or two less than full, of rows of very different
// size.
#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/QR>

#include <equilibria/core/random.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// Four unknowns; their meaning does not matter here.
struct Four {
    static constexpr int n_angles = 4, n_parameters = 0;
    constexpr auto potential(const auto& theta, const auto&) const { return cos(theta[0]); }
};
struct FourEquations {
    static constexpr int n_angles = 4, n_parameters = 0;
    constexpr auto equations(const auto& theta, const auto&) const {
        return std::array{sin(theta[0]), sin(theta[1]), sin(theta[2]), sin(theta[3])};
    }
};

using Matrix = UnknownMatrix<Four>;
using Column = Eigen::Matrix<double, 4, 1>;

Matrix random_orthogonal(Generator& generator) {
    Matrix a;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) a(i, j) = uniform(generator, -1, 1);
    return Eigen::HouseholderQR<Matrix>(a).householderQ();
}
Column column(const Unknowns<Four>& v) { return {v[0], v[1], v[2], v[3]}; }

}  // namespace

TEST_CASE(
    "null vectors of U diag(s) V^T are the last columns of V, the left one that of U, whatever the other values are") {
    Generator generator(1);
    for (int trial = 0; trial < 50; ++trial) {
        const Matrix u = random_orthogonal(generator), v = random_orthogonal(generator);
        // a second value of 1e-9 of the largest: squared it would be gone
        const Column values(1, uniform(generator, 0.1, 1), 1e-9, 0);
        const Matrix j = u * values.asDiagonal() * v.transpose();
        const Column found = column(null_vector<FourEquations>(j));
        CHECK(std::abs(found.norm() - 1) < 1e-14);
        CHECK(std::abs(std::abs(found.dot(v.col(3))) - 1) < 1e-12);
        CHECK((j * found).norm() < 1e-15);
        CHECK(nullity<FourEquations>(j, 0) == 2);
        CHECK(nullity<FourEquations>(u * Column(1, 1, 1e-7, 0).asDiagonal() * v.transpose(), 0) == 1);
        CHECK(nullity<FourEquations>(u * Column(1, 1, 1e-7, 0).asDiagonal() * v.transpose(), 100) == 2);

        const Unknowns<Four> right{found(0), found(1), found(2), found(3)};
        const Column left = column(left_null_vector<FourEquations>(j, right));
        CHECK((left.transpose() * j).norm() < 1e-15);
        CHECK(left.dot(found) >= 0);
    }
}

TEST_CASE("of a symmetric matrix the left null vector is the right one, and two null vectors are orthonormal") {
    Generator generator(2);
    for (int trial = 0; trial < 50; ++trial) {
        const Matrix v = random_orthogonal(generator);
        const Column values(uniform(generator, -2, -0.5), 1, 0, 0);
        const Matrix j = v * values.asDiagonal() * v.transpose();
        const auto plane = null_vectors<2, Four>(j);
        const Column a = column(plane[0]), b = column(plane[1]);
        CHECK((j * a).norm() < 1e-14);
        CHECK((j * b).norm() < 1e-14);
        CHECK(std::abs(a.dot(b)) < 1e-14);
        CHECK(left_null_vector<Four>(j, plane[0]) == plane[0]);
        CHECK(nullity<Four>(j, 0) == 2);
    }
}

TEST_CASE("a matrix that is not finite has no null vector, and nothing hangs") {
    Matrix j = Matrix::Identity();
    j(1, 2) = std::numeric_limits<double>::quiet_NaN();
    for (const double x : null_vector<Four>(j)) CHECK(std::isnan(x));
    CHECK(nullity<Four>(j, 1) == 0);
}

TEST_CASE(
    "Newton's method: quadratic to the last digit, and not converged where it diverges or meets what is no number") {
    struct Report {
        int steps = 0;
        double correction = 0;
        bool converged = false;
    };
    const auto solve = [](double start, auto&& f) {
        Report at;
        Array<double, 1> y{start};
        detail::newton(y, at, [&](const auto& now, auto& r, auto& jacobian) {
            const auto u = detail::independent(now);
            detail::split_duals(Array<Dual<double, 1>, 1>{f(u[0])}, r, jacobian);
            return true;
        });
        return std::pair(y[0], at);
    };
    const auto [root, at] = solve(1.5, [](const auto& x) { return x * x - 2.0 * Dual<double, 1>(1.0); });
    CHECK(at.converged);
    CHECK(at.steps <= 6);
    CHECK(std::abs(root - std::sqrt(2)) < 1e-15);
    // a double root: linear, half of the error a step
    const auto [twofold, slow] = solve(1.0, [](const auto& x) { return x * x; });
    CHECK(slow.steps > 30);
    // no zero, and no number
    CHECK_FALSE(solve(0.3, [](const auto& x) { return x * x + Dual<double, 1>(1.0); }).second.converged);
    CHECK_FALSE(solve(0.5, [](const auto& x) { return sqrt(x - Dual<double, 1>(1.0)); }).second.converged);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(detail::largest(Array<double, 3>{1, nan, 2})));
    CHECK(std::isnan(detail::largest(Array<double, 2>{nan, 2})));
}
