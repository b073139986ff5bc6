// Lagrange multipliers: dead points of mechanisms, redundant constraints.
#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/factorization/redundant_constraints.hpp>
#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Parallelogram four-bar, cranks of length 1, coupler and base of length 2, torsion springs at the crank (unloaded at
/// rest) and at the coupler, moment p on the crank; multipliers for the closure, of which the x equation is written
/// `copies` times. Unknowns: angles of crank, coupler and rocker, multipliers. The branch crank = rocker, coupler 0,
/// p = crank - rest, passes a dead point where the crank is 0.
struct FourBar {
    double rest = 0.5;
    int copies = 1;
    int multipliers() const { return 1 + copies; }
    VectorXd residual(const VectorXd& q, double p) const {
        const double c1 = std::cos(q(0)), c2 = std::cos(q(1)), c3 = std::cos(q(2));
        const double s1 = std::sin(q(0)), s2 = std::sin(q(1)), s3 = std::sin(q(2));
        double x = 0;
        for (int k = 0; k < copies; ++k) x += q(4 + k);
        VectorXd g(4 + copies);
        g.head(4) << q(0) - rest - p - x * s1 + q(3) * c1, 3 * q(1) - 2 * x * s2 + 2 * q(3) * c2, x * s3 - q(3) * c3,
            s1 + 2 * s2 - s3;
        for (int k = 0; k < copies; ++k) g(4 + k) = c1 + 2 * c2 - c3 - 2;
        return g;
    }
    MatrixXd tangent(const VectorXd& q, double) const {
        const double c1 = std::cos(q(0)), c2 = std::cos(q(1)), c3 = std::cos(q(2));
        const double s1 = std::sin(q(0)), s2 = std::sin(q(1)), s3 = std::sin(q(2));
        double x = 0;
        for (int k = 0; k < copies; ++k) x += q(4 + k);
        MatrixXd t = MatrixXd::Zero(4 + copies, 4 + copies);
        t(0, 0) = 1 - x * c1 - q(3) * s1;
        t(1, 1) = 3 - 2 * x * c2 - 2 * q(3) * s2;
        t(2, 2) = x * c3 + q(3) * s3;
        t.row(3).head(3) << c1, 2 * c2, -c3;
        for (int k = 0; k < copies; ++k) t.row(4 + k).head(3) << -s1, -2 * s2, s3;
        t.topRightCorner(3, 1 + copies) = t.bottomLeftCorner(1 + copies, 3).transpose();
        return t;
    }
    VectorXd parameter_derivative(const VectorXd&, double) const {
        VectorXd g = VectorXd::Zero(4 + copies);
        g(0) = -1;
        return g;
    }
};

}  // namespace

TEST_CASE("a dead point of a four-bar mechanism is named, and passed") {
    const FourBar bar;
    VectorXd start = VectorXd::Zero(5);
    start(0) = start(2) = -0.6;
    ContinuationOptions options;
    options.range.low = -2;
    options.range.high = 1;
    const auto branch = continue_branch(bar, start, -1.1, 1, options);
    CHECK(branch.end == BranchEnd::window);
    CHECK(branch.unexplained.empty());
    REQUIRE(branch.events.size() == 1);
    const auto& point = branch.events[0].point;
    CHECK(point.kind == CriticalKind::kinematic);
    CHECK(point.p == Approx(-0.5).epsilon(1e-6));
    CHECK(std::abs(point.null_vector(4)) > 0.999 * point.null_vector.norm());
    for (const auto& at : branch.points) {
        CHECK(at.q(0) == Approx(at.p + 0.5).margin(1e-9));
        // K has as many negative eigenvalues as constraints, the energy on their set none
        CHECK(at.stable() == true);
    }
}

TEST_CASE("redundant constraints are refused by name") {
    const FourBar twice{0.5, 2};
    VectorXd start = VectorXd::Zero(6);
    start(0) = start(2) = -0.6;
    CHECK_THROWS_WITH(check_derivatives(twice, start, -1.1),
                      Catch::Contains("problem.multipliers") && Catch::Contains("rank is 2"));
}

TEST_CASE("redundant constraints among many are counted, and named up to some thousands") {
    // a ring of n bars that hold x_i - x_{i+1}, the last one redundant, whatever their units
    for (const bool closed : {false, true})
        for (const int n : {3, 400, 1900, 20'000}) {
            const int bars = closed ? n : n - 1, size = n + bars;
            std::vector<Eigen::Triplet<double>> entries;
            for (int i = 0; i < bars; ++i)
                for (const auto& [node, value] : {std::pair(i, 1.0 + i), std::pair((i + 1) % n, -1.0 - i)}) {
                    entries.emplace_back(n + i, node, value);
                    entries.emplace_back(node, n + i, value);
                }
            Eigen::SparseMatrix<double> k(size, size);
            k.setFromTriplets(entries.begin(), entries.end());
            const ConstraintGradients constraints(k, bars, VectorXd::Constant(size, 1e-6));
            INFO(n << " bars, closed: " << closed);
            CHECK(constraints.count() == bars);
            CHECK(constraints.redundant_count() == (closed ? 1 : 0));
            if (n < 2000) CHECK(constraints.redundant() == (closed ? std::vector{n - 1} : std::vector<int>{}));
            // a bar with a flexibility of its own is independent
            k.coeffRef(n, n) = -1;
            const ConstraintGradients others(k, bars, VectorXd::Constant(size, 1e-6));
            CHECK(others.count() == bars - 1);
            CHECK(others.redundant_count() == 0);
        }
}

TEST_CASE("A sparse matrix may change its pattern between factorisations") {
    SparseLDLT ldlt(1);
    // x^2 + y^2 + 2 z^2 with x + y = 0, then coupled and with x + z = 0 instead
    for (const bool coupled : {false, true, false}) {
        MatrixXd k = MatrixXd::Zero(4, 4);
        k.diagonal() << 1, 1, 2, 0;
        k(3, 0) = k(0, 3) = 1;
        if (coupled)
            k(0, 1) = k(1, 0) = -0.5, k(3, 2) = k(2, 3) = 1;
        else
            k(3, 1) = k(1, 3) = 1;
        REQUIRE(ldlt.factor(k.sparseView()));
        CHECK(ldlt.negative() == 1);
        const VectorXd f = VectorXd::LinSpaced(4, 1, 4);
        CHECK((k * ldlt.solve(f) - f).norm() < 1e-14);
    }
}
