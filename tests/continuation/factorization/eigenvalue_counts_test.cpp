// Counts of eigenvalues of dense symmetric matrices, held against the eigenvalues themselves.
#include <equilibria/continuation/factorization/eigenvalue_counts.hpp>
#include <equilibria/core/random.hpp>

#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;

TEST_CASE("Between any two eigenvalues as many are smaller as there are") {
    Generator generator(7);
    for (int n = 1; n <= 12; ++n)
        for (int trial = 0; trial < 20; ++trial) {
            Eigen::MatrixXd k(n, n);
            for (int i = 0; i < n; ++i)
                for (int j = 0; j <= i; ++j) k(i, j) = k(j, i) = uniform(generator, -1, 1) * (trial % 3 == 0 ? 1e6 : 1);
            const EigenvalueCounts counts(k);
            const Eigen::VectorXd values = tests::symmetric_eigen(k).values;
            CHECK(counts.size() == n);
            CHECK(counts.below(values(0) - 1) == 0);
            CHECK(counts.below(values(n - 1) + 1) == n);
            for (int i = 0; i + 1 < n; ++i) CHECK(counts.below((values(i) + values(i + 1)) / 2) == i + 1);
        }
}

TEST_CASE("Diagonal matrices, eigenvalues that are 0, and no matrix") {
    const Eigen::Vector4d values(-2, 0, 0, 3);
    const EigenvalueCounts counts(Eigen::MatrixXd(values.asDiagonal()));
    CHECK(counts.below(-1e-9) == 1);
    CHECK(counts.below(1e-9) == 3);
    CHECK(counts.below(4) == 4);
    CHECK(EigenvalueCounts().empty());
    CHECK(EigenvalueCounts(Eigen::MatrixXd(0, 0)).empty());
    CHECK(EigenvalueCounts().below(1) == 0);
}
