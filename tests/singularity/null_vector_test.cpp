// Null vectors of matrices whose null space is known: of rank one or two less than full, of rows of very different
// size.
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <equilibria/core/random.hpp>
#include <equilibria/singularity/null_vector.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

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
    return tests::orthogonal_factor(a);
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
