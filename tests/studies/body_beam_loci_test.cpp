// Relative equilibria of the body and beam against the angular momentum, and their pitchforks and folds in two
// parameters.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/curves/critical_curve_trace.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_either_strain.hpp>
#include <equilibria/studies/rotating_body_beam/momentum_hessian.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Eigen::VectorXd;
using mechanisms::BeamControl, mechanisms::BeamStrain, mechanisms::BodyBeamEitherStrain, mechanisms::whirl_speeds;

namespace {

constexpr int K = 2;
using M = BodyBeamEitherStrain<K, BeamControl::momentum>;
using ByAxis = mechanisms::RotatingBodyBeam<K, BeamStrain::either>;
using Values = Parameters<M>;
constexpr double inertia_3 = 0.8;

/// Two modes are too few for a stiff beam with the coupled strain energy: with mu_3 = 20 its whirling branches begin as
/// the continuous beam's do, towards smaller momenta; with 100 they do not.
Values body(double kappa, double stretching = 20) {
    Values p{2, 1.2, 1.3, inertia_3, 0, 0, 0, 1, 1, 1.2};
    p[M::stretching] = stretching;
    p[M::coupling] = kappa;
    p[M::second_axis] = 1;
    return p;
}

/// With its symmetries: reflections in the planes of the axes, and -w for w.
struct Problem : ModelProblem<M, M::momentum> {
    using ModelProblem::ModelProblem;
    /// The momentum enters as A omega.
    VectorXd parameter_derivative_along(const VectorXd& q, double, const VectorXd&) const {
        return VectorXd::Zero(q.size());
    }
    std::vector<VectorXd> images(const VectorXd& q) const {
        std::vector<VectorXd> y;
        for (int signs = 1; signs < 8; ++signs) {
            VectorXd image = q;
            for (int a = 0; a < 2; ++a)
                if ((signs >> a & 1) != 0) {
                    image(a) *= -1;
                    image.segment(M::first_mode + a * K, K) *= -1;
                }
            if ((signs & 4) != 0) image.head(3) *= -1;
            y.push_back(image);
        }
        return y;
    }
};

/// The undeformed beam, turning about itself.
VectorXd spin(double momentum) {
    VectorXd q = VectorXd::Zero(M::n_coordinates);
    q(2) = q(M::omega) = momentum / inertia_3;
    q(M::multiplier) = inertia_3;
    return q;
}

double whirl_momentum(const Values& p, int plane) { return inertia_3 * whirl_speeds<K>(p, plane)[0]; }

ContinuationOptions window(double low, double high) {
    ContinuationOptions y;
    y.range = {low, high};
    return y;
}

/// Stable where 0: negative eigenvalues of the energy at the given momentum.
int index(const VectorXd& q, double momentum, const Values& p) {
    Unknowns<ByAxis> x{};
    for (int i = 0; i < x.size(); ++i) x[i] = i < 3 ? q(i) / q(M::omega) : q(i);
    const Eigen::MatrixXd hessian = mechanisms::momentum_hessian<K, BeamStrain::either>(x, momentum, p);
    return inertia(hessian).negative;
}

/// p'' along phi at the pitchfork in which the spin begins to whirl.
double curvature(const Values& p, int plane) {
    const Problem problem(p);
    CriticalPointSolver<Problem> solver(problem);
    const double momentum = whirl_momentum(p, plane);
    const auto point = solver.solve(spin(momentum), momentum);
    REQUIRE(point);
    CHECK(point->kind == CriticalKind::pitchfork);
    CHECK(point->p == Approx(momentum).epsilon(1e-10));
    return point->curvature;
}

/// The branch that leaves the spin's first or second pitchfork.
Branch<Problem> whirling(const Problem& problem, const Values& p, int plane, const ContinuationOptions& options) {
    BranchStepper<Problem> stepper(problem, options.branch);
    const double momentum = whirl_momentum(p, plane);
    const auto before = stepper.start(spin(momentum - 0.01), momentum - 0.01, 1);
    REQUIRE(before);
    CriticalPointSolver<Problem> solver(problem);
    const auto point = solver.solve(spin(momentum), momentum);
    REQUIRE(point);
    const auto sides = switch_branch(stepper, *point, before->tangent, 0.05);
    REQUIRE(sides.size() == 2);
    return follow(stepper, sides[0], options);
}

}  // namespace

TEST_CASE("Followed in the momentum the spin begins to whirl where the whirling speeds say") {
    for (const double kappa : {0.0, 1.0}) {
        const Values p = body(kappa);
        const Problem problem(p);
        const auto branch = continue_branch(problem, spin(3.5), 3.5, 1, window(3, 4.5));
        CHECK(branch.end == BranchEnd::window);
        CHECK(branch.unexplained.empty());
        REQUIRE(branch.events.size() == 2);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto& point = branch.events[k].point;
            CHECK(point.kind == CriticalKind::pitchfork);
            CHECK(point.p == Approx(whirl_momentum(p, static_cast<int>(k) + 1)).epsilon(1e-10));
            CHECK((point.curvature > 0) == (kappa == 0));
        }
        for (const auto& point : branch.points) {
            CHECK(point.residual < 1e-11);
            const auto passed = std::count_if(branch.events.begin(), branch.events.end(),
                                              [&](const auto& e) { return e.point.p < point.p; });
            CHECK(index(point.q, point.p, p) == 2 + passed);
        }
    }
}

TEST_CASE("The whirling branches with their folds and secondary pitchforks, and the index along them") {
    for (const double kappa : {0.0, 1.0}) {
        CAPTURE(kappa);
        const Values p = body(kappa);
        DiagramOptions options;
        options.continuation = kappa == 0 ? window(3.85, 6.72) : window(3.8, 4);
        const auto graph = bifurcation_diagram(Problem(p), spin(3.9), 3.9, options);
        CHECK(graph.complete());
        int folds = 0, secondary = 0;
        for (const auto& node : graph.nodes) {
            const auto& point = node.point;
            if (point.kind == CriticalKind::fold) {
                ++folds;
                const bool first = std::abs(point.q(0)) > std::abs(point.q(1));
                CHECK(point.p < whirl_momentum(p, first ? 1 : 2));
            } else {
                CHECK(point.kind == CriticalKind::pitchfork);
                secondary += std::hypot(point.q(0), point.q(1)) > 0.1;
            }
        }
        // the linear beam's whirling branches are joined by a closed one, through two points of each
        CHECK(folds == (kappa == 0 ? 0 : 1));
        CHECK(secondary == (kappa == 0 ? 4 : 0));
        for (const auto& edge : graph.branches) {
            const auto& points = edge.branch.points;
            std::vector<int> events(points.size(), 0), turned(points.size(), 0), indices;
            for (const auto& event : edge.branch.events) ++events[event.step];
            for (const auto& point : points) {
                CHECK(point.residual < 1e-10);
                CHECK(point.q.head(3).norm() == Approx(point.q(M::omega)).epsilon(1e-12));
                CHECK(point.q(M::omega) * point.q(M::multiplier) == Approx(point.p).epsilon(1e-12));
                indices.push_back(index(point.q, point.p, p));
                // of K: one for the multiplier and one for omega
                REQUIRE(point.negative);
                CHECK(indices.back() == *point.negative - 2);
            }
            for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                const int change = std::abs(indices[k + 1] - indices[k]);
                const bool turns = points[k].tangent.p * points[k + 1].tangent.p < 0;
                if (events[k] == 0) {
                    CHECK(change == 0);
                    CHECK(!turns);
                } else if (events[k] == 1) {
                    const auto& event = *std::find_if(edge.branch.events.begin(), edge.branch.events.end(),
                                                      [&](const auto& e) { return e.step == k; });
                    // none on the side branch of a pitchfork, which turns there
                    CHECK(change == (event.point.kind == CriticalKind::pitchfork && turns ? 0 : 1));
                }
            }
        }
    }
}

TEST_CASE("Over the ratio of the stiffnesses the pitchforks follow the whirling speeds and cross at a double one") {
    const Values p = body(1);
    const ModelProblems<M, M::momentum, M::bending_2> family{p};
    const auto member = family(p[M::bending_2]);
    CriticalPointSolver solver(member);
    // in the second plane A / sqrt(mu_2) is constant, the first one does not feel mu_2
    const double ratio = whirl_momentum(p, 1) / whirl_momentum(p, 2), crossing = p[M::bending_2] * ratio * ratio;
    for (const int plane : {1, 2}) {
        const double momentum = whirl_momentum(p, plane);
        const auto point = solver.solve(spin(momentum), momentum);
        REQUIRE(point);
        const auto curve = continue_bifurcations(family, *point, p[M::bending_2], -1, window(1.07, 1.25));
        CHECK(curve.branch.end == BranchEnd::window);
        CHECK(curve.branch.unexplained.empty());
        CHECK(curve.branch.points.size() >= 3);
        for (const auto& at : curve.branch.points) {
            Values there = p;
            there[M::bending_2] = at.p;
            CHECK(at.q.p == Approx(whirl_momentum(there, plane)).epsilon(1e-10));
            CHECK(std::abs(at.q.gamma) < 1e-10);
            CHECK(at.residual < 1e-10);
        }
        const auto is_crossing = [&](const auto& special) {
            return special.kind == CriticalKind::hilltop && std::abs(special.r - crossing) < 1e-6;
        };
        CHECK(std::count_if(curve.special.begin(), curve.special.end(), is_crossing) == 1);
    }
}

TEST_CASE("The coupled beam's fold over the ratio of the stiffnesses and over the coupling") {
    const Values p = body(1);
    for (const int plane : {1, 2}) {
        CAPTURE(plane);
        const Problem problem(p);
        auto steps = window(3.6, whirl_momentum(p, plane));
        steps.most_steps = 45;
        const auto branch = whirling(problem, p, plane, steps);
        REQUIRE(branch.events.size() == 1);
        const auto& found = branch.events[0].point;
        REQUIRE(found.kind == CriticalKind::fold);
        // as of the class that the families give
        const ModelProblems<M, M::momentum, M::bending_2> ratios{p};
        const ModelProblems<M, M::momentum, M::coupling> couplings{p};
        const auto member = couplings(1);
        CriticalPointSolver solver(member);
        const auto fold = solver.solve(found.q, found.p);
        REQUIRE(fold);
        CHECK(fold->kind == CriticalKind::fold);

        const auto by_ratio = continue_folds(ratios, *fold, p[M::bending_2], 1, window(1.12, 1.28));
        CHECK(by_ratio.branch.end == BranchEnd::window);
        CHECK(by_ratio.branch.points.size() >= 3);
        for (const auto& at : by_ratio.branch.points) {
            CHECK(at.residual < 1e-9);
            Values there = p;
            there[M::bending_2] = at.p;
            CHECK(at.q.p < whirl_momentum(there, plane));
            // a beam bent in the first plane does not feel mu_2
            if (plane == 1) CHECK(at.q.p == Approx(fold->p).epsilon(1e-10));
        }

        // V is quadratic in the coupling, and so is the pitchfork's curvature; at its zero the pitchfork is degenerate
        const auto at = [&](double kappa) { return curvature(body(kappa), plane); };
        const double c0 = at(0), c1 = at(1), middle = at(0.5);
        const double b = 4 * middle - 3 * c0 - c1, a = c1 - c0 - b;
        CHECK(at(0.75) == Approx(c0 + 0.75 * (b + 0.75 * a)).margin(1e-5));
        const double end = 2 * c0 / (-b + std::sqrt(b * b - 4 * a * c0));
        CHECK((end > 0.6 && end < 0.9));
        CHECK(std::abs(at(end)) < 1e-5);
        // the fold's curve leads there, and ends on the pitchforks' curve tangentially: as the square of the distance
        const double pitchfork = whirl_momentum(p, plane);
        const auto curve = continue_folds(couplings, *fold, 1, -1, window(end + 0.01, 1.1));
        CHECK(curve.branch.end == BranchEnd::window);
        CHECK(std::none_of(curve.special.begin(), curve.special.end(),
                           [](const auto& s) { return s.kind == CriticalKind::cusp; }));
        const auto& last = curve.branch.points.back();
        const auto& earlier = *std::find_if(curve.branch.points.begin(), curve.branch.points.end(),
                                            [&](const auto& x) { return x.p - end < 0.1; });
        CHECK(last.p - end < 0.02);
        CHECK(earlier.p - end > 0.03);
        CHECK(last.q.p < pitchfork);
        const double distances = std::log((earlier.p - end) / (last.p - end));
        CHECK(std::log((pitchfork - earlier.q.p) / (pitchfork - last.q.p)) / distances == Approx(2).margin(0.1));
        // the bending as its root
        const auto bend = [&](const auto& x) { return x.q.q.segment(M::first_mode, 2 * K).norm(); };
        CHECK(std::log(bend(earlier) / bend(last)) / distances == Approx(0.5).margin(0.05));
    }
}

TEST_CASE("Of a locked beam two folds vanish in a cusp over the coupling") {
    const Values p = body(1, 100);
    const Problem problem(p);
    const auto branch = whirling(problem, p, 1, window(3.95, 4.02));
    REQUIRE(branch.events.size() == 2);
    CHECK(branch.events[0].point.p > branch.events[1].point.p);
    const ModelProblems<M, M::momentum, M::coupling> couplings{p};
    const auto member = couplings(1);
    CriticalPointSolver solver(member);
    const auto fold = solver.solve(branch.events[0].point.q, branch.events[0].point.p);
    REQUIRE(fold);
    const auto curve = continue_folds(couplings, *fold, 1, -1, window(0.95, 1));
    CHECK(curve.branch.end == BranchEnd::window);
    const auto is_cusp = [](const auto& s) { return s.kind == CriticalKind::cusp; };
    REQUIRE(std::count_if(curve.special.begin(), curve.special.end(), is_cusp) == 1);
    const auto& cusp = *std::find_if(curve.special.begin(), curve.special.end(), is_cusp);
    CHECK(cusp.residual < 1e-10);
    CHECK((cusp.r > 0.9 && cusp.r < 1));
    // from the cusp the curve comes back to the other fold, at the coupling 1
    const auto& last = curve.branch.points.back();
    CHECK(last.p == Approx(1));
    CHECK(last.tangent.p > 0);
    CHECK(std::abs(last.q.p - branch.events[1].point.p) < 1e-8);
}
