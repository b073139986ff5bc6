#include <equilibria/continuation/branch.hpp>

#include "../programs/support/structures.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

namespace {

/// K unsymmetric: sin(q0) - p + q1 / 2, 2 q1 - q0^2 / 3.
struct Unsymmetric {
    static constexpr bool symmetric = false;
    VectorXd residual(const VectorXd& q, double p) const {
        return Eigen::Vector2d(std::sin(q(0)) - p + q(1) / 2, 2 * q(1) - q(0) * q(0) / 3);
    }
    MatrixXd tangent(const VectorXd& q, double) const {
        Eigen::Matrix2d k;
        k << std::cos(q(0)), 0.5, -2 * q(0) / 3, 2;
        return k;
    }
    VectorXd parameter_derivative(const VectorXd&, double) const { return Eigen::Vector2d(-1, 0); }
};

/// A point of the unit circle, held by a spring towards the direction p: V = -cos(angle - p) - cos(angle) / 2. The
/// configuration is the point itself, an increment turns it.
struct OnCircle {
    using Configuration = Eigen::Vector2d;
    Configuration retract(const Configuration& x, const VectorXd& d) const {
        const double c = std::cos(d(0)), s = std::sin(d(0));
        return {c * x(0) - s * x(1), s * x(0) + c * x(1)};
    }
    VectorXd difference(const Configuration& x, const Configuration& y) const {
        return VectorXd::Constant(1, std::atan2(x(0) * y(1) - x(1) * y(0), x.dot(y)));
    }
    VectorXd residual(const Configuration& x, double p) const {
        return VectorXd::Constant(1, x(1) * std::cos(p) - x(0) * std::sin(p) + x(1) / 2);
    }
    MatrixXd tangent(const Configuration& x, double p) const {
        return MatrixXd::Constant(1, 1, x(0) * std::cos(p) + x(1) * std::sin(p) + x(0) / 2);
    }
    VectorXd parameter_derivative(const Configuration& x, double p) const {
        return VectorXd::Constant(1, -x(1) * std::sin(p) - x(0) * std::cos(p));
    }
};

}  // namespace

TEST_CASE("predictors: the error falls with h^2 for tangent and secant, with h^3 for the parabola") {
    const ShallowArch arch{2.5};
    for (const auto& [predictor, order] : {std::pair{Predictor::tangent, 2.0}, std::pair{Predictor::secant, 2.0},
                                           std::pair{Predictor::quadratic, 3.0}, std::pair{Predictor::cubic, 4.0}}) {
        double errors[2];
        for (int k = 0; k < 2; ++k) {
            const double h = 0.02 / (1 << k);
            BranchStepper<ShallowArch> stepper(arch, {.predictor = predictor, .parameter_weight = 1});
            const auto start = stepper.start(Eigen::Vector2d(2.3, 0), 0.5, 1);
            REQUIRE(start);
            const auto first = stepper.step(*start, h);
            REQUIRE(first);
            const auto exact = stepper.step(*first, h);
            REQUIRE(exact);
            const Direction predicted = stepper.predict(*first, h, &*start);
            Direction error = stepper.difference(*first, exact->q, exact->p);
            error.q -= predicted.q;
            error.p -= predicted.p;
            errors[k] = stepper.length(error);
        }
        CAPTURE(order, errors[0], errors[1]);
        CHECK(std::log2(errors[0] / errors[1]) == Approx(order).margin(0.25));
    }
}

TEST_CASE("the tangent solves K q' + dg/dp p' = 0, also next to a fold, and has length 1") {
    const auto truss = von_mises_truss(1.2);
    BranchStepper<Truss> stepper(truss, {});
    const auto start = stepper.start(truss.unloaded(), 0, 1);
    REQUIRE(start);
    int k = 0;
    for (const auto& point : BranchPoints(stepper, *start)) {
        const VectorXd rest = truss.tangent(point.q, point.p) * point.tangent.q +
                              truss.parameter_derivative(point.q, point.p) * point.tangent.p;
        CHECK(rest.norm() < 1e-12);
        CHECK(stepper.length(point.tangent) == Approx(1).epsilon(1e-12));
        CHECK(truss.residual(point.q, point.p).norm() < 1e-13);
        if (++k == 40) break;
    }
    CHECK(k == 40);
}

TEST_CASE("control by one unknown and by the parameter") {
    const ShallowArch arch{2.5};
    BranchOptions options{.constraint = StepConstraint::unknown, .controlled = 0};
    BranchStepper<ShallowArch> stepper(arch, options);
    auto point = stepper.start(Eigen::Vector2d(2.5, 0), 0, 1);
    REQUIRE(point);
    // the first unknown falls steadily, through both folds
    for (int k = 0; k < 200 && point->q(0) > -2.5; ++k) {
        const auto next = stepper.advance(*point);
        REQUIRE(next);
        CHECK(next->q(0) < point->q(0));
        point = next;
    }
    CHECK(point->q(0) <= -2.5);
    // load control stops at the limit load
    options.constraint = StepConstraint::parameter;
    ContinuationOptions loads;
    loads.branch = options;
    const auto branch = continue_branch(arch, VectorXd(Eigen::Vector2d(2.5, 0)), 0, 1, loads);
    CHECK(branch.end == BranchEnd::stopped);
    CHECK(branch.points.back().p == Approx(arch.fold()).epsilon(1e-3));
}

TEST_CASE("unsymmetric K: folds by the left null vector") {
    const Unsymmetric problem;
    ContinuationOptions options;
    options.range.low = -5;
    options.range.high = 5;
    options.most_steps = 400;
    const auto branch = continue_branch(problem, VectorXd(Eigen::Vector2d(0, 0)), 0, 1, options);
    CHECK(branch.unexplained.empty());
    REQUIRE(!branch.events.empty());
    for (const auto& event : branch.events) {
        // p = sin x + x^2 / 12
        const double x = event.point.q(0);
        CHECK(event.point.kind == CriticalKind::fold);
        CHECK(std::abs(std::cos(x) + x / 6) < 1e-12);
        CHECK(event.point.p == Approx(std::sin(x) + x * x / 12).epsilon(1e-12));
        CHECK((problem.tangent(event.point.q, 0).transpose() * event.point.left_null_vector).norm() < 1e-12);
    }
}

TEST_CASE("a curved configuration space: folds where the branch turns, many turns of the parameter") {
    const OnCircle problem;
    ContinuationOptions options;
    options.range.high = 20;
    options.most_steps = 600;
    const auto branch = continue_branch(problem, Eigen::Vector2d(1, 0), 0, 1, options);
    // the spring towards p is the stronger one: no fold, and the point follows all the turns
    CHECK(branch.end == BranchEnd::window);
    CHECK(branch.events.empty());
    for (const auto& point : branch.points) {
        CHECK(point.q.norm() == Approx(1).epsilon(1e-12));
        CHECK(point.negative == 0);
    }
}

TEST_CASE("paths are refused for options out of range") {
    const ShallowArch arch{2.5};
    const auto refusal = [&](const BranchOptions& options) {
        try {
            BranchStepper<ShallowArch> stepper(arch, options);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal({.smallest_step = 0}) == "smallest_step = 0: must be positive");
    CHECK(refusal({.first_step = 1}) == "largest_step = 0.20000000000000001: must be at least first_step");
    CHECK(refusal({.most_corrections = 1}) == "most_corrections = 1: must be at least 2");
    CHECK(refusal({}).empty());
}

namespace {

struct ArchByHeight : ShallowArch {
    double control(const VectorXd& a, double) const { return a(0) + a(0) * a(0) * a(0); }
};

}  // namespace

TEST_CASE("control by a scalar of the problem, which falls all along the branch") {
    const ArchByHeight arch{{1.9}};
    BranchOptions options;
    options.constraint = StepConstraint::scalar;
    BranchStepper<ArchByHeight> stepper(arch, options);
    auto point = stepper.start(Eigen::Vector2d(1.9, 0), 0.0, 1);
    REQUIRE(point);
    // through both folds
    for (int k = 0; k < 60 && point->q(0) > -1.5; ++k) {
        const double before = arch.control(point->q, 0);
        const double h = 0.05;
        const Direction gradient = control_gradient(arch, point->q, point->p, 2);
        const double wanted = before + h * (gradient.q.dot(point->tangent.q) + gradient.p * point->tangent.p);
        point = stepper.step(*point, h);
        REQUIRE(point);
        CHECK(arch.control(point->q, 0) == Approx(wanted).margin(1e-10));
        CHECK(arch.residual(point->q, point->p).norm() < 1e-10);
    }
    CHECK(point->q(0) < 0);
    const ShallowArch uncontrolled{2};
    CHECK_THROWS_WITH(BranchStepper<ShallowArch>(uncontrolled, options), Catch::Contains("constraint"));
}
