#include <equilibria/continuation/curves/imperfection.hpp>

#include "../programs/support/structures.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

namespace {

struct Arches {
    ShallowArch operator()(double rise) const { return {rise}; }
};

/// The shallow arch with a spring k in place of 1: on A2 = 0 a cusp where l^2 = k, q = k l.
struct SpringArch {
    double l, k;
    double stretch(const VectorXd& a) const { return a(0) * a(0) + 4 * a(1) * a(1) - l * l; }
    VectorXd residual(const VectorXd& a, double q) const {
        return Eigen::Vector2d(k * (a(0) - l) + stretch(a) * a(0) + q, 16 * a(1) + 4 * stretch(a) * a(1));
    }
    MatrixXd tangent(const VectorXd& a, double) const {
        Eigen::Matrix2d m;
        m << k + stretch(a) + 2 * a(0) * a(0), 8 * a(0) * a(1), 8 * a(0) * a(1), 16 + 4 * stretch(a) + 32 * a(1) * a(1);
        return m;
    }
    MatrixXd tangent_derivative(const VectorXd& a, double, const VectorXd& v) const {
        const double d = 2 * a(0) * v(0) + 8 * a(1) * v(1), mixed = 8 * (a(0) * v(1) + a(1) * v(0));
        Eigen::Matrix2d m;
        m << d + 4 * a(0) * v(0), mixed, mixed, 4 * d + 64 * a(1) * v(1);
        return m;
    }
    VectorXd parameter_derivative(const VectorXd&, double) const { return Eigen::Vector2d(1, 0); }
};

/// Trans-critical at x = p = 0 for r = 0; for r > 0 two folds, for r < 0 none: g = x^2 - p^2 + r (saddle), and the sum
/// of squares (isola), in one coordinate of two.
struct Crossing {
    double r, sign;
    VectorXd residual(const VectorXd& q, double p) const {
        return Eigen::Vector2d(q(0) * q(0) - sign * p * p + r + q(1), 3 * q(1) + q(0) * q(1));
    }
    static constexpr bool symmetric = false;
    MatrixXd tangent(const VectorXd& q, double) const {
        Eigen::Matrix2d k;
        k << 2 * q(0), 1, q(1), 3 + q(0);
        return k;
    }
    VectorXd parameter_derivative(const VectorXd&, double p) const { return Eigen::Vector2d(-2 * sign * p, 0); }
};

template <class P>
CriticalPoint<P> first_of(const P& problem, const VectorXd& q, CriticalKind kind) {
    const auto branch = continue_branch(problem, q, 0, 1, {.range = {-10, 10}});
    for (const auto& event : branch.events)
        if (event.point.kind == kind) return event.point;
    FAIL("no such point");
    return {};
}

double fold_offset(double l) { return 2 * std::pow(l * l - 1, 1.5) / (3 * std::sqrt(3.0)); }

ContinuationOptions between(double low, double high) {
    ContinuationOptions options;
    options.range.low = low;
    options.range.high = high;
    return options;
}

}  // namespace

TEST_CASE("fold curve of the shallow arch: its cusp at rise 1, its hilltops at the root of 5.5") {
    const auto fold = first_of(ShallowArch{2}, Eigen::Vector2d(2, 0), CriticalKind::fold);
    const auto down = continue_folds(Arches{}, fold, 2.0, -1, between(0.5, 3));
    CHECK(down.branch.end == BranchEnd::window);
    CHECK(down.branch.unexplained.empty());
    for (const auto& point : down.branch.points)
        CHECK(std::abs(std::abs(point.q.p - point.p) - fold_offset(point.p)) < 1e-10);
    REQUIRE(down.special.size() == 2);
    CHECK(down.special[0].kind == CriticalKind::cusp);
    CHECK(down.special[0].r == Approx(1).epsilon(1e-12));
    CHECK(down.special[0].at.p == Approx(1).epsilon(1e-12));
    CHECK(down.special[1].kind == CriticalKind::hilltop);
    CHECK(down.special[1].r == Approx(std::sqrt(5.5)).epsilon(1e-11));
    CHECK(down.special[1].at.p == Approx(std::sqrt(5.5) - fold_offset(std::sqrt(5.5))).epsilon(1e-10));
    for (const auto& point : down.special) CHECK(point.residual < 1e-11);
}

TEST_CASE("a fold curve ends where the load leaves its range") {
    const auto fold = first_of(ShallowArch{2}, Eigen::Vector2d(2, 0), CriticalKind::fold);
    REQUIRE(fold.p == Approx(4));
    const auto curve = continue_folds(Arches{}, fold, 2.0, -1, between(0.5, 3), {0.5, 10});
    CHECK(curve.branch.end == BranchEnd::event);
    CHECK(std::string(to_string(curve.branch.end)) == "event");
    REQUIRE(curve.special.size() == 1);  // not the border
    CHECK(curve.special[0].kind == CriticalKind::cusp);
    REQUIRE(curve.branch.crossings.size() == 1);
    const auto& border = curve.branch.crossings[0];
    CHECK(border.step + 2 == curve.branch.points.size());
    CHECK(border.point.q.p == Approx(0.5).epsilon(1e-10));
    CHECK(border.point.p - fold_offset(border.point.p) == Approx(0.5).epsilon(1e-9));
    CHECK(curve.branch.points.back().q.p < 0.5);
    CHECK(curve.branch.points[border.step].q.p > 0.5);
}

TEST_CASE("curve of bifurcations of the shallow arch: gamma 0, turning back at rise 2") {
    const auto pitchfork = first_of(ShallowArch{2.5}, Eigen::Vector2d(2.5, 0), CriticalKind::pitchfork);
    const auto curve = continue_bifurcations(Arches{}, pitchfork, 2.5, -1, between(1.5, 3));
    CHECK(curve.branch.end == BranchEnd::window);
    CHECK(curve.branch.unexplained.empty());
    for (const auto& point : curve.branch.points) {
        CHECK(std::abs(point.q.gamma) < 1e-10);
        CHECK(std::abs(std::pow(point.q.p - point.p, 2) - 9 * (point.p * point.p - 4)) < 1e-8);
    }
    // with the fold at the root of 5.5, on both sides
    const double hilltop = std::sqrt(5.5), expected[] = {hilltop, 2, hilltop};
    REQUIRE(curve.special.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(curve.special[k].kind == CriticalKind::hilltop);
        CHECK(curve.special[k].r == Approx(expected[k]).epsilon(1e-10));
    }
}

TEST_CASE("a curve of cusps is the fold curve of a fold curve") {
    const SpringArch arch{2, 1};
    const auto fold = first_of(arch, Eigen::Vector2d(2, 0), CriticalKind::fold);
    // the third parameter is the spring
    const auto rises = [](double spring) { return [spring](double l) { return SpringArch{l, spring}; }; };
    const auto fold_curves = [&](double spring) { return FoldCurve(rises(spring), 2.0, 1.0); };
    const auto down = continue_branch(fold_curves(1), detail::configuration_of(fold), 2.0, -1, between(0.5, 3));
    REQUIRE(!down.events.empty());
    REQUIRE(down.events[0].point.kind == CriticalKind::fold);
    const auto cusps = continue_folds(fold_curves, down.events[0].point, 1.0, 1, between(0.5, 4));
    CHECK(cusps.branch.end == BranchEnd::window);
    CHECK(cusps.branch.points.size() > 5);
    for (const auto& point : cusps.branch.points) {
        const double spring = point.p, l = point.q.p, q = point.q.q.p;
        CHECK(l == Approx(std::sqrt(spring)).epsilon(1e-9));
        CHECK(q == Approx(spring * l).epsilon(1e-9));
        CHECK(std::abs(point.q.q.q(0)) < 1e-9);
    }
}

TEST_CASE("folds of an unsymmetric problem end in a trans-critical point or in an isola centre") {
    for (const double sign : {1.0, -1.0}) {
        // sign 1: folds x = 0, p^2 = r; sign -1: x = 0, p^2 = -r
        const auto family = [sign](double r) { return Crossing{r, sign}; };
        const double r0 = 0.25 * sign;
        const Crossing member = family(r0);
        CriticalPointSolver<Crossing> solver(member);
        const auto fold = solver.solve(VectorXd(Eigen::Vector2d(0.05, 0)), 0.52);
        REQUIRE(fold);
        REQUIRE(fold->kind == CriticalKind::fold);
        CHECK(fold->p == Approx(0.5).epsilon(1e-12));
        const auto curve = continue_folds(family, *fold, r0, sign > 0 ? -1 : 1, between(-1, 1));
        CHECK(curve.branch.unexplained.empty());
        REQUIRE(curve.special.size() == 1);
        CHECK(curve.special[0].kind == (sign > 0 ? CriticalKind::transcritical : CriticalKind::isola_center));
        CHECK(std::abs(curve.special[0].r) < 1e-12);
        CHECK(std::abs(curve.special[0].at.p) < 1e-9);
    }
}

TEST_CASE("knock-down curve of the shallow arch follows the two-thirds power law") {
    const ShallowArch arch{3};
    const auto pitchfork = first_of(arch, Eigen::Vector2d(3, 0), CriticalKind::pitchfork);
    REQUIRE(pitchfork.curvature < 0);
    auto options = between(-0.5, 0.5);
    options.branch.first_step = 1e-3;
    const auto halves = knock_down_curves(arch, pitchfork, options);
    REQUIRE(halves.size() == 2);
    CHECK(halves[0].points.back().p * halves[1].points.back().p < 0);
    const double factor = 1.5 * std::cbrt(-pitchfork.curvature) *
                          std::pow(pitchfork.null_vector.squaredNorm() / std::abs(pitchfork.b), 2.0 / 3);
    for (const auto& half : halves) {
        CHECK(half.end == BranchEnd::window);
        double last = 0;
        int compared = 0;
        for (const auto& point : half.points) {
            const double gamma = std::abs(point.p), fall = pitchfork.p - point.q.p;
            CHECK(fall >= last - 1e-12);
            last = fall;
            if (gamma < 1e-7 || gamma > 1e-3) continue;
            // the next term is of the order gamma^(4/3)
            CHECK(fall / (factor * std::pow(gamma, 2.0 / 3)) == Approx(1).epsilon(1e-6 + 2 * std::pow(gamma, 2.0 / 3)));
            ++compared;
        }
        CHECK(compared > 1);
    }
    CHECK_THROWS_AS(knock_down_curves(arch, pitchfork, options, Eigen::Vector2d(1, 0)), InvalidArgument);
    CHECK_THROWS_AS(knock_down_curves(arch, pitchfork, options, Eigen::Vector3d(1, 0, 0)), InvalidArgument);
}
