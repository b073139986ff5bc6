#include <equilibria/continuation/branch.hpp>

#include "../programs/support/structures.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

namespace {

struct Expected {
    CriticalKind kind;
    double p;
    int nullity, before, after;
};

template <class P>
void check_events(const Branch<P>& branch, const std::vector<Expected>& expected, double tolerance = 1e-10) {
    CHECK(branch.unexplained.empty());
    REQUIRE(branch.events.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const auto& point = branch.events[k].point;
        CAPTURE(k, point.p);
        CHECK(point.kind == expected[k].kind);
        CHECK(point.p == Approx(expected[k].p).epsilon(tolerance));
        CHECK(point.nullity == expected[k].nullity);
        CHECK(point.negative_before == expected[k].before);
        CHECK(point.negative_after == expected[k].after);
    }
}

ContinuationOptions window(double low, double high, int steps = 1000) {
    ContinuationOptions options;
    options.range.low = low;
    options.range.high = high;
    options.most_steps = steps;
    return options;
}

}  // namespace

TEST_CASE("shallow arch: folds, pitchforks and the closed side branch") {
    const ShallowArch arch{2.5};
    const double fold = arch.fold(), bifurcation = arch.bifurcation(), mirror = 2 * arch.l;
    const auto branch = continue_branch(arch, VectorXd(Eigen::Vector2d(2.5, 0)), 0, 1, window(-10, 10));
    CHECK(branch.end == BranchEnd::window);
    check_events(branch, {{CriticalKind::pitchfork, bifurcation, 1, 0, 1},
                          {CriticalKind::fold, fold, 1, 1, 2},
                          {CriticalKind::fold, mirror - fold, 1, 2, 1},
                          {CriticalKind::pitchfork, mirror - bifurcation, 1, 1, 0}});
    // q = l + 3 A1 and A1^2 + 4 A2^2 = l^2 - 4: q'' along A2 is -12 / A1
    CHECK(branch.events[0].point.curvature == Approx(-12 / 1.5).epsilon(1e-6));

    BranchStepper<ShallowArch> stepper(arch, {});
    REQUIRE(stepper.start(Eigen::Vector2d(2.5, 0), 0, 1));
    const auto& event = branch.events[0];
    const auto starts = switch_branch(stepper, event.point, branch.points[event.step].tangent, 0.05);
    REQUIRE(starts.size() == 2);
    CHECK(starts[0].q(1) * starts[1].q(1) < 0);
    for (const auto& start : starts) {
        const auto side = follow(stepper, start, window(-10, 10));
        CHECK(side.end == BranchEnd::closed);
        check_events(side, {{CriticalKind::pitchfork, mirror - bifurcation, 1, 1, 1},
                            {CriticalKind::pitchfork, bifurcation, 1, 1, 1}});
        for (const auto& point : side.points) CHECK(std::abs(point.p - arch.l - 3 * point.q(0)) < 1e-9);
    }
}

TEST_CASE("a branch ends with as many critical points as asked for") {
    const ShallowArch arch{2.5};
    const auto followed = [&](int most) {
        auto options = window(-10, 10);
        options.most_critical_points = most;
        return continue_branch(arch, VectorXd(Eigen::Vector2d(2.5, 0)), 0, 1, options);
    };
    const auto whole = followed(5);
    CHECK(whole.end == BranchEnd::window);
    REQUIRE(whole.events.size() == 4);
    for (const int most : {1, 2, 3, 4}) {
        CAPTURE(most);
        const auto branch = followed(most);
        CHECK(branch.end == BranchEnd::critical);
        REQUIRE(static_cast<int>(branch.events.size()) == most);
        // nothing beyond the step with the last of them, and up to there the same
        CHECK(branch.points.size() == branch.events.back().step + 2);
        for (std::size_t k = 0; k < branch.events.size(); ++k)
            CHECK(branch.events[k].point.p == whole.events[k].point.p);
        for (std::size_t k = 0; k < branch.points.size(); ++k) CHECK(branch.points[k].p == whole.points[k].p);
    }
    CHECK_THROWS_AS(followed(0), InvalidArgument);
}

TEST_CASE("shallow arch: a fold and a bifurcation in one point, and 1e-6 apart") {
    const double l = std::sqrt(5.5);
    const auto follow_from = [](const ShallowArch& arch) {
        return continue_branch(arch, VectorXd(Eigen::Vector2d(arch.l, 0)), 0, 1, window(-10, 10));
    };
    const ShallowArch hilltop{l}, before{l + 1e-3}, after{l - 1e-3};
    check_events(follow_from(hilltop), {{CriticalKind::hilltop, hilltop.fold(), 2, 0, 2},
                                        {CriticalKind::hilltop, 2 * l - hilltop.fold(), 2, 2, 0}});
    CHECK(before.fold() - before.bifurcation() < 1e-5);
    check_events(follow_from(before), {{CriticalKind::pitchfork, before.bifurcation(), 1, 0, 1},
                                       {CriticalKind::fold, before.fold(), 1, 1, 2},
                                       {CriticalKind::fold, 2 * before.l - before.fold(), 1, 2, 1},
                                       {CriticalKind::pitchfork, 2 * before.l - before.bifurcation(), 1, 1, 0}});
    check_events(follow_from(after), {{CriticalKind::fold, after.fold(), 1, 0, 1},
                                      {CriticalKind::pitchfork, after.bifurcation(), 1, 1, 2},
                                      {CriticalKind::pitchfork, 2 * after.l - after.bifurcation(), 1, 2, 1},
                                      {CriticalKind::fold, 2 * after.l - after.fold(), 1, 1, 0}});
}

TEST_CASE("von Mises truss: limit load, bifurcation, and its side branch, a circle") {
    const double h = 2, l3 = std::pow(1 + h * h, 1.5);
    const double limit = 2 * h * h * h / (3 * std::sqrt(3.0) * l3), bifurcation = 2 * std::sqrt(h * h - 2) / l3;
    const auto truss = von_mises_truss(h);
    const auto branch = continue_branch(truss, truss.unloaded(), 0, 1, window(-1, 1));
    check_events(branch, {{CriticalKind::pitchfork, bifurcation, 1, 0, 1},
                          {CriticalKind::fold, limit, 1, 1, 2},
                          {CriticalKind::fold, -limit, 1, 2, 1},
                          {CriticalKind::pitchfork, -bifurcation, 1, 1, 0}});
    BranchStepper<Truss> stepper(truss, {});
    REQUIRE(stepper.start(truss.unloaded(), 0, 1));
    const auto starts =
        switch_branch(stepper, branch.events[0].point, branch.points[branch.events[0].step].tangent, 0.05);
    REQUIRE(starts.size() == 2);
    for (const auto& point : follow(stepper, starts[0], window(-1, 1)).points) {
        const double x = point.q(0), y = h + point.q(1);
        CHECK(x * x + y * y == Approx(h * h - 2).epsilon(1e-9));
    }
    // below sqrt 2 there is no bifurcation
    const auto shallow = von_mises_truss(1.3);
    const auto flat = continue_branch(shallow, shallow.unloaded(), 0, 1, window(-1, 1));
    REQUIRE(flat.events.size() == 2);
    for (const auto& event : flat.events) CHECK(event.point.kind == CriticalKind::fold);
}

TEST_CASE("star dome: the simple bifurcation, both double ones, the fold, and two folds under the apex load alone") {
    const auto dome = star_dome(.5, 1);
    const auto branch = continue_branch(dome, dome.unloaded(), 0, 1, window(-1e-3, 2e-3));
    check_events(branch, {{CriticalKind::pitchfork, 8.64367449817e-4, 1, 0, 1},
                          {CriticalKind::multiple, 1.02026178545e-3, 2, 1, 3},
                          {CriticalKind::multiple, 1.54281129992e-3, 2, 3, 5},
                          {CriticalKind::fold, 1.81039958136e-3, 1, 5, 6}});
    const auto apex = star_dome(1, 0);
    check_events(continue_branch(apex, apex.unloaded(), 0, 1, window(-1e-3, 1e-3)),
                 {{CriticalKind::fold, 3.15579970840e-4, 1, 0, 1}, {CriticalKind::fold, -2.76052681472e-4, 1, 1, 0}});

    // six-fold symmetry: 3 and 3 half branches from the first double point, 6 and 6 from the second, alike in each set
    BranchStepper<Truss> stepper(dome, {});
    REQUIRE(stepper.start(dome.unloaded(), 0, 1));
    for (const auto& [event, halves] : {std::pair{1, 6}, std::pair{2, 12}}) {
        const auto& e = branch.events[static_cast<std::size_t>(event)];
        const auto starts = switch_branch(stepper, e.point, branch.points[e.step].tangent, 0.05);
        CHECK(static_cast<int>(starts.size()) == halves);
    }
}

TEST_CASE("any constraint and predictor gives the same critical points") {
    const ShallowArch arch{2.5};
    for (const auto constraint : {StepConstraint::normal_plane, StepConstraint::updated_plane, StepConstraint::sphere,
                                  StepConstraint::cylinder})
        for (const auto predictor : {Predictor::tangent, Predictor::secant, Predictor::quadratic, Predictor::cubic}) {
            CAPTURE(static_cast<int>(constraint), static_cast<int>(predictor));
            auto options = window(-10, 10);
            options.branch.constraint = constraint;
            options.branch.predictor = predictor;
            const auto branch = continue_branch(arch, VectorXd(Eigen::Vector2d(2.5, 0)), 0, 1, options);
            CHECK(branch.unexplained.empty());
            REQUIRE(branch.events.size() == 4);
            CHECK(branch.events[1].point.p == Approx(arch.fold()).epsilon(1e-12));
        }
}

TEST_CASE("sparse: a chain of links buckles and is followed onto its side branch") {
    for (const int links : {1, 2, 3, 40, 1000}) {
        const SpringElastica chain{links};
        const double critical = chain.buckling_load();
        auto options = window(-1, 1.5 * critical);
        options.branch.parameter_weight = 1 / critical;  // straight, the load moves nothing: it has no scale of its own
        const auto branch = continue_branch(chain, VectorXd(VectorXd::Zero(links)), 0, 1, options);
        REQUIRE(!branch.events.empty());
        const auto& event = branch.events[0];
        CHECK(event.point.kind == CriticalKind::pitchfork);
        CHECK(event.point.p == Approx(critical).epsilon(1e-9));
        // a buckled chain carries more than the critical load
        CHECK(event.point.curvature > 0);
        BranchStepper<SpringElastica> stepper(chain, options.branch);
        REQUIRE(stepper.start(VectorXd::Zero(links), 0, 1));
        const auto starts = switch_branch(stepper, event.point, branch.points[event.step].tangent, 0.1);
        REQUIRE(starts.size() == 2);
        const auto side = follow(stepper, starts[0], window(-1, 1.5 * critical, 30));
        CHECK(side.unexplained.empty());
        for (const auto& point : side.points) CHECK(point.negative == 0);
        CHECK(side.points.back().p > critical);
    }
}

TEST_CASE("bad problems are refused by name") {
    struct Bad : ShallowArch {
        int what = 0;
        VectorXd residual(const VectorXd& q, double p) const {
            VectorXd g = ShallowArch::residual(q, p);
            if (what == 0) g(1) = std::nan("");
            return g;
        }
        MatrixXd tangent(const VectorXd& q, double p) const {
            MatrixXd k = ShallowArch::tangent(q, p);
            if (what == 1) k(0, 0) *= 1.01;
            if (what == 2) k(0, 1) += 0.1;
            return k;
        }
        VectorXd parameter_derivative(const VectorXd& q, double p) const {
            return what == 3 ? VectorXd(VectorXd::Zero(3))
                             : (what == 4 ? 2.0 : 1.0) * ShallowArch::parameter_derivative(q, p);
        }
    };
    const auto refusal = [](int what) {
        try {
            continue_branch(Bad{{2.5}, what}, VectorXd(Eigen::Vector2d(2.4, 0.1)), 0.1, 1);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    using Catch::Matchers::Contains;
    CHECK_THAT(refusal(0), Contains("problem.residual = NaN: must be finite at the start"));
    CHECK_THAT(refusal(1), Contains("problem.tangent") && Contains("must be the derivative of the residual by q"));
    CHECK_THAT(refusal(2), Contains("problem.tangent"));
    CHECK_THAT(refusal(3), Contains("problem.parameter_derivative = 3: must have the residual's size 2"));
    CHECK_THAT(refusal(4), Contains("problem.parameter_derivative") && Contains("by p"));
    CHECK(refusal(5).empty());
    CHECK_THROWS_AS(continue_branch(ShallowArch{2}, VectorXd(Eigen::Vector2d(2, 0)), 0, 2), InvalidArgument);
}

TEST_CASE("options of critical points out of range are refused, by branches, solvers and finders of events") {
    const ShallowArch arch{2};
    const auto refusal = [&](const CriticalPointOptions& critical) {
        std::string said;
        const auto refused = [&](const auto& call) {
            try {
                call();
            } catch (const InvalidArgument& error) {
                return std::string(error.what());
            }
            return std::string("nothing");
        };
        ContinuationOptions options;
        options.critical = critical;
        options.most_steps = 1;
        BranchStepper<ShallowArch> stepper(arch, options.branch);
        said = refused([&] { continue_branch(arch, VectorXd(Eigen::Vector2d(2, 0)), 0, 1, options); });
        CHECK(refused([&] { CriticalPointSolver<ShallowArch>(arch, critical); }) == said);
        CHECK(refused([&] { EventFinder<ShallowArch>(stepper, critical); }) == said);
        return said;
    };
    constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal({}) == "nothing");
    CHECK(refusal({.bifurcation_start = infinity, .bifurcation = 0, .reach = infinity}) == "nothing");
    CHECK(refusal({.most_iterations = 0}) == "most_iterations = 0: must be at least 1");
    CHECK(refusal({.tolerance = 0}) == "tolerance = 0: must be positive");
    CHECK(refusal({.tolerance = nan}) == "tolerance = nan: must be positive");
    CHECK(refusal({.bifurcation_start = -0.5}) == "bifurcation_start = -0.5: must be 0 or positive");
    CHECK(refusal({.bifurcation = -1}) == "bifurcation = -1: must be 0 or positive");
    CHECK(refusal({.reach = 0}) == "reach = 0: must be positive");
}
