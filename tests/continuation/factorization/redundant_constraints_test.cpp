// Constraints that others repeat, in a tangent [K B^T; B 0].
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/redundant_constraints.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

Eigen::MatrixXd tangent(const Eigen::MatrixXd& constraints) {
    const Eigen::Index n = constraints.cols(), m = constraints.rows();
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n + m, n + m);
    k.topLeftCorner(n, n).diagonal().setConstant(3);
    k.bottomLeftCorner(m, n) = constraints;
    k.topRightCorner(n, m) = constraints.transpose();
    return k;
}

}  // namespace

TEST_CASE("Independent constraints are none of them redundant") {
    Eigen::MatrixXd b(2, 4);
    b << 1, 0, 2, 0, 0, 1, 0, -1;
    const ConstraintGradients gradients(tangent(b), 2, Eigen::VectorXd::Ones(4));
    CHECK(gradients.count() == 2);
    CHECK(gradients.redundant().empty());
    CHECK(gradients.redundant_count() == 0);
}

TEST_CASE("Constraints that depend on those before them are redundant, whatever their units") {
    Generator generator(1);
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(5, 8);
    for (int i : {0, 1, 3})
        for (int j = 0; j < 8; ++j) b(i, j) = uniform(generator, -1, 1);
    b.row(2) = 1e6 * b.row(0);                      // the same in other units
    b.row(4) = b.row(0) - 2 * b.row(1) + b.row(3);  // what three others say together
    Eigen::VectorXd weights(8);
    weights << 1, 1e-6, 100, 1, 2, 3, 4, 5;
    const Eigen::MatrixXd k = tangent(b);
    for (const ConstraintGradients& gradients :
         {ConstraintGradients(k, 5, weights),
          ConstraintGradients(Eigen::SparseMatrix<double>(k.sparseView()), 5, weights)}) {
        CHECK(gradients.redundant() == std::vector<int>{2, 4});
        CHECK(gradients.redundant_count() == 2);
    }
}

TEST_CASE("A force with a flexibility of its own repeats no constraint") {
    Eigen::MatrixXd b(2, 3);
    b << 1, 2, 3, 1, 2, 3;
    Eigen::MatrixXd k = tangent(b);
    k(4, 4) = -0.1;
    const ConstraintGradients gradients(k, 2, Eigen::VectorXd::Ones(3));
    CHECK(gradients.count() == 1);
    CHECK(gradients.redundant().empty());
}
