// What each back end of sparse symmetric factors is tested with: saddle points, and a branch.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

namespace tests {

using equilibria::continue_branch;
using equilibria::Generator;
using equilibria::MakeSymmetricFactors;
using equilibria::uniform;

/// A random symmetric K with a few entries a row, indefinite or positive definite, and constraints B below it, each on
/// three unknowns, of which the last `redundant` repeat others: [K B^T; B 0].
inline Eigen::MatrixXd saddle_point(int n, int constraints, int redundant, bool definite, Generator& generator) {
    const auto draw = [&](int below) { return static_cast<int>(generator() % static_cast<std::uint64_t>(below)); };
    const int size = n + constraints + redundant;
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < n; ++i) {
        k(i, i) = definite ? 8 : uniform(generator, -4, 4);
        for (int entry = 0; entry < 2; ++entry) {
            const int j = draw(n);
            if (j != i) k(i, j) = k(j, i) = uniform(generator, -1, 1);
        }
    }
    for (int m = 0; m < constraints; ++m)
        for (int entry = 0; entry < 3; ++entry) {
            const int i = (3 * m + entry) % n;
            k(n + m, i) = k(i, n + m) = uniform(generator, 0.5, 1);
        }
    for (int m = 0; m < redundant; ++m) {
        k.row(n + constraints + m).head(n) = 2 * k.row(n + m).head(n);
        k.col(n + constraints + m).head(n) = 2 * k.col(n + m).head(n);
    }
    return k;
}

inline Eigen::SparseMatrix<double> with_diagonal(const Eigen::MatrixXd& k) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < k.rows(); ++i)
        for (int j = 0; j < k.cols(); ++j)
            if (i == j || k(i, j) != 0) entries.emplace_back(i, j, k(i, j));
    Eigen::SparseMatrix<double> y(k.rows(), k.cols());
    y.setFromTriplets(entries.begin(), entries.end());
    return y;
}

/// One of those that back ends are compared on, with the inertia that dense eigenvalues give.
struct RandomSaddlePoint {
    Eigen::MatrixXd dense;
    Eigen::SparseMatrix<double> sparse;
    int constraints, redundant, negative;
    double largest;  ///< absolute value of an eigenvalue
    Eigen::VectorXd right_side;
};

/// visit(RandomSaddlePoint) for 200 of them: half definite but for the constraints, of which there are up to three, and
/// some redundant ones.
inline void for_each_saddle_point(auto visit) {
    Generator generator(1);
    for (int k = 0; k < 200; ++k) {
        CAPTURE(k);
        RandomSaddlePoint y;
        y.constraints = k % 4;
        y.redundant = std::min(y.constraints, k % 3);
        y.dense = saddle_point(10 + k % 40, y.constraints, y.redundant, k % 2 == 0, generator);
        y.sparse = with_diagonal(y.dense);
        const Eigen::VectorXd values = symmetric_eigen(y.dense).values;
        y.largest = values.cwiseAbs().maxCoeff();
        y.negative = static_cast<int>((values.array() < -1e-10 * y.largest).count());
        REQUIRE((values.array().abs() <= 1e-10 * y.largest).count() == y.redundant);
        y.right_side = Eigen::VectorXd::LinSpaced(y.dense.rows(), -1, 1);
        visit(y);
    }
}

/// x^3 / 3 - p x of each unknown of a chain, held together by springs: sparse, with folds and bifurcations.
struct CubicChain {
    MakeSymmetricFactors make;
    static constexpr int n = 12;

    Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const {
        Eigen::VectorXd g(n);
        for (int i = 0; i < n; ++i) {
            g(i) = q(i) * q(i) * q(i) - p * q(i) + (i == 0 ? 0.02 : 0);
            if (i > 0) g(i) += q(i) - q(i - 1);
            if (i + 1 < n) g(i) += q(i) - q(i + 1);
        }
        return g;
    }
    Eigen::SparseMatrix<double> tangent(const Eigen::VectorXd& q, double p) const {
        Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
        for (int i = 0; i < n; ++i) {
            k(i, i) = 3 * q(i) * q(i) - p + (i > 0) + (i + 1 < n);
            if (i > 0) k(i, i - 1) = k(i - 1, i) = -1;
        }
        return with_diagonal(k);
    }
    Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double) const { return -q; }
    MakeSymmetricFactors symmetric_factors() const { return make; }
};

/// The same points and critical points as by what a problem has that names none.
inline void check_branch(MakeSymmetricFactors make) {
    const auto follow_with = [](MakeSymmetricFactors factors) {
        const CubicChain chain{factors};
        return continue_branch(chain, Eigen::VectorXd(Eigen::VectorXd::Constant(CubicChain::n, -0.1)), -1.0, 1,
                               {.range = {-1, 4}, .most_steps = 200});
    };
    const auto own = follow_with(nullptr), other = follow_with(make);
    REQUIRE(own.points.size() == other.points.size());
    for (std::size_t k = 0; k < own.points.size(); ++k) {
        CHECK((own.points[k].q - other.points[k].q).norm() < 1e-9);
        CHECK(own.points[k].negative == other.points[k].negative);
    }
    REQUIRE(own.events.size() == other.events.size());
    for (std::size_t k = 0; k < own.events.size(); ++k) {
        CHECK(own.events[k].point.kind == other.events[k].point.kind);
        CHECK(std::abs(own.events[k].point.p - other.events[k].point.p) < 1e-10);
    }
}

}  // namespace tests
