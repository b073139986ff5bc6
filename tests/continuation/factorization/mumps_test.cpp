// MUMPS beside SparseLDLT and dense eigenvalues: solutions, inertia with constraints, redundant ones, and branches.
#include <algorithm>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/factorization/mumps.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;

namespace {

/// A random symmetric K with a few entries a row, indefinite or positive definite, and constraints B below it, each on
/// three unknowns, of which the last `redundant` repeat others: [K B^T; B 0].
Eigen::MatrixXd saddle_point(int n, int constraints, int redundant, bool definite, Generator& generator) {
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

Eigen::SparseMatrix<double> with_diagonal(const Eigen::MatrixXd& k) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < k.rows(); ++i)
        for (int j = 0; j < k.cols(); ++j)
            if (i == j || k(i, j) != 0) entries.emplace_back(i, j, k(i, j));
    Eigen::SparseMatrix<double> y(k.rows(), k.cols());
    y.setFromTriplets(entries.begin(), entries.end());
    return y;
}

/// x^3 / 3 - p x of each unknown of a chain, held together by springs: sparse, with folds and bifurcations.
struct Chain {
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

}  // namespace

TEST_CASE("MUMPS has the inertia of dense eigenvalues on 200 random matrices with constraints") {
    Generator generator(1);
    MumpsFactors factors;
    int by_ldlt = 0;
    for (int k = 0; k < 200; ++k) {
        CAPTURE(k);
        const int n = 10 + k % 40, constraints = k % 4, redundant = std::min(constraints, k % 3);
        const Eigen::MatrixXd dense = saddle_point(n, constraints, redundant, k % 2 == 0, generator);
        const auto sparse = with_diagonal(dense);
        const Eigen::VectorXd values = tests::symmetric_eigen(dense).values;
        const double largest = values.cwiseAbs().maxCoeff();
        const int negative = static_cast<int>((values.array() < -1e-10 * largest).count()),
                  zero = static_cast<int>((values.array().abs() <= 1e-10 * largest).count());
        REQUIRE(zero == redundant);
        CHECK(factors.factor(sparse) == (redundant == 0));
        CHECK(factors.negative() == negative);
        CHECK(factors.zero() == redundant);
        if (redundant > 0) continue;
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(dense.rows(), -1, 1), x = factors.solve(f);
        CHECK((dense * x - f).norm() < 1e-10 * (1 + largest * x.norm()));
        SparseLDLT ldlt(constraints);
        if (!ldlt.factor(sparse)) continue;
        ++by_ldlt;
        CHECK(ldlt.negative() == negative);
        CHECK((ldlt.solve(f) - x).norm() < 1e-7 * (1 + x.norm()));
    }
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
    const auto follow_with = [](MakeSymmetricFactors make) {
        const Chain chain{make};
        return continue_branch(chain, Eigen::VectorXd(Eigen::VectorXd::Constant(Chain::n, -0.1)), -1.0, 1,
                               {.range = {-1, 4}, .most_steps = 200});
    };
    const auto own = follow_with(nullptr), named = follow_with(sparse_ldlt), by_mumps = follow_with(mumps);
    REQUIRE(own.points.size() == named.points.size());
    CHECK(own.points.back().q == named.points.back().q);
    REQUIRE(own.points.size() == by_mumps.points.size());
    for (std::size_t k = 0; k < own.points.size(); ++k) {
        CHECK((own.points[k].q - by_mumps.points[k].q).norm() < 1e-9);
        CHECK(own.points[k].negative == by_mumps.points[k].negative);
    }
    REQUIRE(own.events.size() == by_mumps.events.size());
    for (std::size_t k = 0; k < own.events.size(); ++k) {
        CHECK(own.events[k].point.kind == by_mumps.events[k].point.kind);
        CHECK(std::abs(own.events[k].point.p - by_mumps.events[k].point.p) < 1e-10);
    }
}
