// Pitchforks at which dg/dp itself vanishes were called folds where the limit point's system landed on them before its
// slow convergence was noticed. The mechanism over c2 without a force has four: there c2's spring does no work.
#include <cmath>
#include <numbers>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using M = mechanisms::HolonomicMechanism;

TEST_CASE("A bifurcation at which dg/dp vanishes is no fold, from any start near by") {
    using Problem = ModelProblem<M, M::stiffness_2>;
    const auto p = M::paper_parameters(0);
    const Problem problem(p);
    // det Hess V = 0 at (pi / 2, 0), over l: (c1 l + c2 l - 2 w)(c1 l + w) = (c1 l)^2
    const double l = p[M::length], w = p[M::mass_1] * p[M::gravity], c1 = p[M::stiffness_1] * l;
    const double expected = (c1 * c1 / (c1 + w) + 2 * w - c1) / l;
    Generator generator(1);
    for (int k = 0; k < 500; ++k) {
        const Unknowns<M> q{std::numbers::pi / 2 + 1e-4 * uniform(generator, -1, 1), 1e-4 * uniform(generator, -1, 1)};
        const auto point = CriticalPointSolver<Problem>(problem).solve(Problem::vector(q),
                                                                       expected + 1e-3 * uniform(generator, -1, 1));
        REQUIRE(point);
        CHECK(point->kind == CriticalKind::pitchfork);
        CHECK(point->p == Approx(expected).epsilon(1e-10));
    }
}
