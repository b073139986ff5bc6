// The rotating chain as a continuation problem, without the locus module's search.
#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/continuation/curves/critical_curve_trace.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Chain = mechanisms::TwoLinkChain;
using Eigen::VectorXd;

TEST_CASE("the chain's fold at alpha = 0.33 and its fold curve through the cusp, by continuation alone") {
    const ModelProblems<Chain, Chain::omega, Chain::alpha> family{{.33, 1.5, 2}};
    const auto member = family(0.33);
    const VectorXd start = Eigen::Vector2d(1.1, -1.04);
    const auto errors = check_derivatives(member, start, 2.06);
    CHECK(errors.tangent < 1e-8);
    CHECK(errors.tangent_derivative < 1e-8);
    CHECK(errors.parameter_derivative_along < 1e-8);

    CriticalPointSolver solver(member);
    const auto fold = solver.solve(start, 2.06);
    REQUIRE(fold);
    CHECK(fold->kind == CriticalKind::fold);
    CHECK(fold->residual < 1e-14);

    ContinuationOptions options;
    options.range.low = 0.01;
    options.range.high = 0.55;
    options.branch.first_step = 1e-3;
    const auto curve = continue_folds(family, *fold, 0.33, 1, options);
    CHECK(curve.branch.end == BranchEnd::window);
    CHECK(curve.branch.unexplained.empty());
    // where alpha is largest the fold is born or dies in the plane of omega: a vertical tangent of the locus
    REQUIRE(curve.special.size() == 2);
    CHECK(is_bifurcation(curve.special[0].kind));
    CHECK(curve.special[0].r == Approx(1.0 / 3).epsilon(1e-11));
    CHECK(curve.special[0].at.p == Approx(2).epsilon(1e-9));
    CHECK(curve.special[1].kind == CriticalKind::cusp);
    CHECK(curve.special[1].r == Approx(0.32989617641140).epsilon(1e-12));
    CHECK(curve.special[1].at.p == Approx(1.93791347451593).epsilon(1e-12));
    for (const auto& point : curve.special) CHECK(point.residual < 1e-13);
}

TEST_CASE("the fold curve's derivatives by the second parameter are exact, and all of it at once is its parts") {
    const ModelProblems<Chain, Chain::omega, Chain::alpha> family{{.33, 1.5, 2}};
    STATIC_REQUIRE(DifferentiableFamily<decltype(family)>);
    const auto differenced = [&](double alpha) { return family(alpha); };
    STATIC_REQUIRE(!DifferentiableFamily<decltype(differenced)>);
    const FoldCurve exact(family, 0.33, 1.0);
    const FoldCurve plain(differenced, 0.33, 1.0);
    for (const double turn : {0.0, 0.2, -0.4}) {
        CriticalConfiguration<VectorXd> at;
        at.q = Eigen::Vector2d(1.1 + turn, -1.04);
        at.p = 2.06 - turn;
        at.border = {1, 1};
        const VectorXd by_alpha = exact.parameter_derivative(at, 0.33);
        CHECK((by_alpha - plain.parameter_derivative(at, 0.33)).norm() < 1e-9 * (1 + by_alpha.norm()));
        for (const auto& all : {exact.linearization(at, 0.33), plain.linearization(at, 0.33)}) {
            CHECK((all.residual - exact.residual(at, 0.33)).norm() == 0);
            CHECK((all.tangent - exact.tangent(at, 0.33)).norm() == 0);
            CHECK((all.parameter_derivative - by_alpha).norm() < 1e-9 * (1 + by_alpha.norm()));
        }
    }
}
