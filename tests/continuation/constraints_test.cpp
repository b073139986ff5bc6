// Lagrange multipliers: dead points of mechanisms, redundant constraints.
#include <equilibria/continuation/branch.hpp>

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
    options.low = -2;
    options.high = 1;
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
