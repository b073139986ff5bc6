// Bordered systems: solutions at regular and singular tangents, dense and sparse, symmetric or not; what they tell of
// the determinant, the null vectors and the inertia.
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using Dense = Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

namespace {

Dense random_matrix(int n, bool symmetric, Generator& generator) {
    Dense k(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) k(i, j) = symmetric && j < i ? k(j, i) : uniform(generator, -1, 1);
    return k;
}
/// With the eigenvalue (or singular value) next to 0 made 0, simple.
Dense singular_matrix(int n, bool symmetric, Generator& generator) {
    const Dense k = random_matrix(n, symmetric, generator);
    if (symmetric) {
        auto [values, vectors] = tests::symmetric_eigen(k);
        Eigen::Index least;
        values.cwiseAbs().minCoeff(&least);
        values(least) = 0;
        return vectors * values.asDiagonal() * vectors.transpose();
    }
    auto [left, values, right] = tests::singular_decomposition(k);
    values(n - 1) = 0;
    return left * values.asDiagonal() * right.transpose();
}

/// [K e_j; e_i^T 0]
Dense bordered(const Dense& k, const Border& border) {
    const Eigen::Index n = k.rows();
    Dense b = Dense::Zero(n + 1, n + 1);
    b.topLeftCorner(n, n) = k;
    b(border.row, n) = b(n, border.column) = 1;
    return b;
}

template <class Matrix>
Matrix as(const Dense& k) {
    if constexpr (std::is_same_v<Matrix, Dense>)
        return k;
    else
        return k.sparseView(0, 0);  // zeros of the diagonal are stored as well
}

template <class Matrix>
void check_solutions(const Dense& k, bool symmetric) {
    const Eigen::Index n = k.rows();
    BorderedSolver<Matrix> solver(symmetric);
    Border border;
    const Eigen::VectorXd weights = Eigen::VectorXd::Ones(n);
    const auto weak = factor_at_weakest(solver, as<Matrix>(k), weights, 0, border);
    REQUIRE(weak);
    CHECK(border == solver.border());
    if (symmetric) CHECK(border.row == border.column);
    const Dense b = bordered(k, border);
    Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(n, -1, 2);
    for (double xi : {0.0, 0.7}) {
        Eigen::VectorXd right(n + 1), x(n + 1);
        right << f, xi;
        const BorderedSolution y = solver.solve(f, xi), z = solver.solve_transposed(f, xi);
        x << y.x, y.tau;
        CHECK((b * x - right).norm() < 1e-11 * (1 + x.norm()));
        x << z.x, z.tau;
        CHECK((b.transpose() * x - right).norm() < 1e-11 * (1 + x.norm()));
    }
    // sigma = -det K / det of K without row j and column i, by the sign of the cofactor in B
    CHECK(weak->r.tau == Approx(tests::determinant(k) / tests::determinant(b)).margin(1e-12));
    CHECK(weak->r.x(border.column) == Approx(1));
    CHECK((k * weak->r.x + weak->r.tau * Eigen::VectorXd::Unit(n, border.row)).norm() < 1e-12 * (1 + weak->r.x.norm()));
    if (std::abs(weak->r.tau) > 1e-10)
        CHECK(solver.sign_of_determinant(weak->r.tau) == (tests::determinant(k) < 0 ? -1 : 1));
    if (symmetric) {
        const auto inertia = solver.inertia(weak->r.tau);
        const Eigen::VectorXd values = tests::symmetric_eigen(k).values;
        if (inertia && std::abs(weak->r.tau) > 1e-10) CHECK(inertia->negative == (values.array() < 0).count());
    }
}

}  // namespace

TEST_CASE("Bordered systems are solved to rounding where K is regular and where it is singular") {
    Generator generator(1);
    for (bool symmetric : {true, false})
        for (int round = 0; round < 10; ++round)
            for (const Dense& k : {random_matrix(6, symmetric, generator), singular_matrix(6, symmetric, generator)}) {
                check_solutions<Dense>(k, symmetric);
                check_solutions<Sparse>(k, symmetric);
            }
}

TEST_CASE("The weakest direction of a singular K is its null vector, and sigma is 0") {
    Generator generator(2);
    for (bool symmetric : {true, false}) {
        const Dense k = singular_matrix(7, symmetric, generator);
        BorderedSolver<Dense> solver(symmetric);
        Border border;
        const auto weak = factor_at_weakest(solver, Dense(k), Eigen::VectorXd::Ones(7), 0, border);
        REQUIRE(weak);
        CHECK(std::abs(weak->r.tau) < 1e-13);
        CHECK((k * weak->direction).norm() < 1e-12);
        CHECK(weak->direction.norm() == Approx(1));
        CHECK(std::abs(weak->eigenvalue) < 1e-12);
        if (!symmetric) CHECK((k.transpose() * weak->left).norm() < 1e-12);
    }
}

TEST_CASE("A K of nullity two, or one that is not finite, has no border") {
    const Dense k = Eigen::Vector4d(1, 0, 0, 2).asDiagonal();
    BorderedSolver<Dense> solver(true);
    Border border;
    CHECK_FALSE(factor_at_weakest(solver, Dense(k), Eigen::VectorXd::Ones(4), 0, border));
    Dense nan = Dense::Identity(3, 3);
    nan(1, 1) = NAN;
    CHECK_FALSE(solver.factor(Dense(nan), {0, 0}));
    CHECK_FALSE(factor_at_weakest(solver, Dense(nan), Eigen::VectorXd::Ones(3), 0, border));
}
