#include <equilibria/continuation/branch.hpp>

#include "../programs/support/structures.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

TEST_CASE("zeros of a user's scalar are located on the branch, its jumps are reported") {
    const ShallowArch arch{1.9};
    ContinuationOptions options;
    options.range.low = -10;
    options.range.high = 10;
    const std::vector<EventFunction<ShallowArch>> functions{
        {"height", [](const BranchPoint<ShallowArch>& at) { return at.q(0) - 1.2345; }},
        {"jump", [](const BranchPoint<ShallowArch>& at) { return at.q(0) > 0.5 ? 1.0 : -1.0; }},
        {"never", [](const BranchPoint<ShallowArch>& at) { return 20 - at.p; }}};
    for (const auto predictor : {Predictor::tangent, Predictor::secant, Predictor::quadratic}) {
        CAPTURE(static_cast<int>(predictor));
        options.branch.predictor = predictor;
        const auto branch = continue_branch(arch, VectorXd(Eigen::Vector2d(1.9, 0)), 0, 1, options, functions);
        REQUIRE(branch.crossings.size() == 1);
        const auto& crossing = branch.crossings[0];
        CHECK(crossing.function == 0);
        const double a = 1.2345;
        CHECK(crossing.point.q(0) == Approx(a).epsilon(1e-13));
        CHECK(crossing.point.p == Approx(1.9 - a - (a * a - 1.9 * 1.9) * a).epsilon(1e-12));
        CHECK(branch.points[crossing.step].q(0) > a);
        CHECK(branch.points[crossing.step + 1].q(0) < a);
        REQUIRE(branch.unexplained.size() == 1);
        CHECK(branch.unexplained[0].reason == "jump changes sign, and no zero was found");
    }
}
