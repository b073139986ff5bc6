// The order of nested dissection: a permutation that leaves fewer entries of a grid, with the same solutions and
// inertia.
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/nested_dissection.hpp>

#include "support/back_ends.hpp"
#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// Five-point differences on a square grid, shifted: some eigenvalues are negative.
Eigen::SparseMatrix<double> grid(int m, double shift) {
    std::vector<Eigen::Triplet<double>> entries;
    const auto at = [&](int i, int j) { return i * m + j; };
    for (int i = 0; i < m; ++i)
        for (int j = 0; j < m; ++j) {
            entries.emplace_back(at(i, j), at(i, j), 4 - shift);
            for (const auto& [k, l] : {std::pair(i + 1, j), std::pair(i, j + 1)}) {
                if (k == m || l == m) continue;
                entries.emplace_back(at(i, j), at(k, l), -1);
                entries.emplace_back(at(k, l), at(i, j), -1);
            }
        }
    Eigen::SparseMatrix<double> y(m * m, m * m);
    y.setFromTriplets(entries.begin(), entries.end());
    return y;
}

}  // namespace

TEST_CASE("Nested dissection orders all unknowns, the same way each time") {
    const auto k = grid(40, 0.05);
    auto order = nested_dissection(k);
    CHECK(order == nested_dissection(k));
    std::sort(order.begin(), order.end());
    std::vector<int> all(1600);
    std::iota(all.begin(), all.end(), 0);
    CHECK(order == all);
}

TEST_CASE("Nested dissection leaves fewer entries of a large grid, and the same solutions") {
    const auto k = grid(200, 0.013);
    SparseLDLT by_degree, by_dissection(0, nested_dissection);
    REQUIRE(by_degree.factor(k));
    REQUIRE(by_dissection.factor(k));
    CHECK(by_dissection.fill() < by_degree.fill());
    CHECK(by_dissection.negative() == by_degree.negative());
    CHECK(by_degree.negative() > 0);
    const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(k.rows(), -1, 1), x = by_dissection.solve(f);
    CHECK((k * x - f).norm() < 1e-9 * (1 + x.norm()));
}

TEST_CASE("A branch has the same points and critical points in an order of nested dissection") {
    tests::check_branch(sparse_ldlt_by_nested_dissection);
}
