// GMRES: exact after as many products as there are unknowns, or directions in which the matrix is not the identity; its
// residual, and what it cannot solve.
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/continuation/factorization/gmres.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd generic_matrix(Eigen::Index rows, Eigen::Index columns, int seed) {
    return detail::generic_vector(rows * columns, seed).reshaped(rows, columns);
}
auto product_with(const MatrixXd& a) {
    return [&a](const VectorXd& v) { return VectorXd(a * v); };
}

}  // namespace

TEST_CASE("GMRES tells the residual that its solution leaves") {
    const MatrixXd a = 3 * MatrixXd::Identity(40, 40) + generic_matrix(40, 40, 1);
    const VectorXd b = detail::generic_vector(40, 2);
    for (const int most : {1, 5, 12, 25, 40}) {
        CAPTURE(most);
        const auto y = gmres(product_with(a), b, 1e-12, most);
        CHECK(std::abs(y.residual - (b - a * y.x).norm() / b.norm()) < 1e-12);
        CHECK(y.iterations <= most);
    }
    const auto whole = gmres(product_with(a), b, 1e-12, 40);
    CHECK(whole.converged);
    CHECK((a * whole.x - b).norm() < 1e-11 * b.norm());
}

TEST_CASE("GMRES needs one product more than the rank of what is added to the identity") {
    for (const int rank : {1, 2, 5}) {
        CAPTURE(rank);
        const MatrixXd a =
            MatrixXd::Identity(200, 200) + generic_matrix(200, rank, 3) * generic_matrix(rank, 200, 4) / 20;
        const auto y = gmres(product_with(a), detail::generic_vector(200, 5), 1e-10, 20);
        CHECK(y.converged);
        CHECK(y.iterations == rank + 1);
    }
}

TEST_CASE("GMRES says where it has no solution") {
    const MatrixXd projection = VectorXd::LinSpaced(6, 0, 1).cwiseSign().asDiagonal();
    const VectorXd b = VectorXd::Ones(6);
    const auto singular = gmres(product_with(projection), b, 1e-8, 6);
    CHECK_FALSE(singular.converged);
    CHECK((b - projection * singular.x).norm() > 0.99);
    const auto endless = gmres([](const VectorXd& v) { return VectorXd(v / 0.0); }, b, 1e-8, 6);
    CHECK_FALSE(endless.converged);
    CHECK(endless.x.isZero());
    CHECK_FALSE(gmres(product_with(projection), std::nan("") * b, 1e-8, 6).converged);
    const auto nothing = gmres(product_with(projection), VectorXd::Zero(6), 1e-8, 6);
    CHECK(nothing.converged);
    CHECK(nothing.iterations == 0);
}
