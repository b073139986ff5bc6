// Discretised differential equations against closed forms, shooting and laws of their branches.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/continuation/corrector.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/continuation/diagrams/deflation.hpp>
#include <equilibria/continuation/generic_problem.hpp>

#include "../programs/support/fields.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

namespace {

using Eigen::VectorXd;

ContinuationOptions large_steps(double low, double high, int steps, double largest = 0.5) {
    ContinuationOptions options;
    options.branch.largest_step = largest;
    options.range = {low, high};
    options.most_steps = steps;
    return options;
}
template <class M>
auto branch_from_zero(const M& model, double low, int steps = 100) {
    const auto problem = sparse(model);
    return continue_branch(problem, VectorXd(VectorXd::Zero(problem.unknowns())), low, 1, large_steps(low, 20, steps));
}
/// The parameters at the folds of the branch that begins with the small solution.
template <class M>
std::vector<double> folds_of(const M& model, double low, int steps = 100) {
    const auto branch = branch_from_zero(model, low, steps);
    CHECK(branch.unexplained.empty());
    std::vector<double> y;
    for (const auto& event : branch.events) {
        CHECK(event.point.kind == CriticalKind::fold);
        y.push_back(event.point.p);
    }
    return y;
}
/// Of errors c h^2 + d h^4 + .., without the terms that values for h, h / 2, h / 4, .. tell.
double extrapolated(std::vector<double> values) {
    for (double factor = 4; values.size() > 1; factor *= 4) {
        for (std::size_t k = 0; k + 1 < values.size(); ++k)
            values[k] = values[k + 1] + (values[k + 1] - values[k]) / (factor - 1);
        values.pop_back();
    }
    return values[0];
}

/// t tanh t = 1: the fold of Bratu's problem in one dimension is at 8 t^2 / cosh^2 t.
double bratu_fold_angle() {
    double t = 1.2;
    for (int k = 0; k < 20; ++k) {
        const double th = std::tanh(t);
        t -= (t * th - 1) / (th + t * (1 - th * th));
    }
    return t;
}
double bratu_parameter(double t) { return 8 * t * t / (std::cosh(t) * std::cosh(t)); }

/// The folds of Gelfand's problem on the ball by Emden's equation w'' + 2 w' / s + e^w = 0, w(0) = w'(0) = 0: lambda =
/// s^2 e^w is stationary. In t = log s, w_tt + w_t + e^(w + 2 t) = 0; Runge and Kutta's method of order 4.
std::vector<double> emden_folds(double last) {
    struct State {
        double w, v;
        State operator+(const State& b) const { return {w + b.w, v + b.v}; }
        State operator*(double a) const { return {a * w, a * v}; }
    };
    const auto rate = [](double t, const State& y) { return State{y.v, -y.v - std::exp(y.w + 2 * t)}; };
    const double h = 5e-4, start = -7, s2 = std::exp(2 * start);
    State y{-s2 / 6 + s2 * s2 / 120, -s2 / 3 + s2 * s2 / 30};
    std::vector<double> folds;
    for (int k = 0; start + k * h < last; ++k) {
        const double t = start + k * h;
        const State k1 = rate(t, y), k2 = rate(t + h / 2, y + k1 * (h / 2)), k3 = rate(t + h / 2, y + k2 * (h / 2)),
                    k4 = rate(t + h, y + k3 * h);
        const State next = y + (k1 + k2 * 2 + k3 * 2 + k4) * (h / 6);
        const double before = 2 + y.v, after = 2 + next.v;  // of log lambda
        if (before * after < 0) {
            // stationary where the parabola through both ends with these slopes is
            const double share = before / (before - after);
            folds.push_back(std::exp(2 * t + y.w + h * share * before / 2));
        }
        y = next;
    }
    return folds;
}

/// The energy of a periodic pattern of the Swift-Hohenberg equation a length: unknowns are the coefficients of
/// cos(j k x), and k.
struct PatternEnergy {
    double nu;
    template <class T>
    T energy(const Eigen::VectorX<T>& q, const T& r) const {
        const Eigen::Index waves = q.size() - 1;
        const int points = 4 * static_cast<int>(waves);
        const T k2 = q(waves) * q(waves);
        T sum = 0.0;
        for (int i = 0; i < points; ++i) {
            T u = 0.0, bend = 0.0;
            for (Eigen::Index j = 0; j < waves; ++j) {
                const double wave = std::cos(2 * std::numbers::pi * i * static_cast<double>(j) / points);
                u += wave * q(j);
                bend += wave * (1 - static_cast<double>(j * j) * k2) * q(j);
            }
            sum += 0.5 * bend * bend - 0.5 * r * u * u - nu / 3 * u * u * u + 0.25 * u * u * u * u;
        }
        return sum / points;
    }
};
/// The parameter at which the best periodic pattern has the energy of u = 0.
double maxwell_point(double nu) {
    const EnergyProblem pattern(PatternEnergy{nu});
    VectorXd q = VectorXd::Zero(9);
    q(0) = 0.4, q(1) = 0.9, q(8) = 1;
    const auto at = [&](double r) {
        REQUIRE(correct_at(pattern, q, r).converged());
        return pattern.energy(q, r);
    };
    double a = -0.3, b = -0.32, e_a = at(a);
    for (int k = 0; k < 8 && std::abs(b - a) > 1e-13; ++k) {
        const double e_b = at(b), next = b - e_b * (b - a) / (e_b - e_a);
        a = b, e_a = e_b, b = next;
    }
    CHECK(q(1) > 0.5);  // no shrunken pattern
    return b;
}

/// How many solutions Carrier's problem has, and their slopes at -1: shooting from there with Runge and Kutta's method,
/// changes of sign of u(1) over all slopes.
std::vector<double> carrier_slopes(double eps) {
    const auto end = [eps](double slope) {
        const int steps = 200;
        const double h = 2.0 / steps;
        double x = -1, u = 0, v = slope;
        const auto rate = [eps](double at, double y) { return (1 - 2 * (1 - at * at) * y - y * y) / (eps * eps); };
        for (int k = 0; k < steps && u > -50; ++k, x += h) {
            const double k1 = rate(x, u), k2 = rate(x + h / 2, u + h / 2 * v),
                         k3 = rate(x + h / 2, u + h / 2 * (v + h / 2 * k1)), k4 = rate(x + h, u + h * (v + h / 2 * k2));
            u += h * v + h * h / 6 * (k1 + k2 + k3);
            v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        return std::max(u, -50.0);
    };
    std::vector<double> slopes;
    const double most = 3 / eps;  // eps^2 v^2 / 2 is at most the height of the potential's hill, about 4
    const int shots = 16000;
    double before = end(-most);
    for (int k = 1; k <= shots; ++k) {
        const double slope = -most + 2 * most * k / shots, now = end(slope);
        if ((before > 0) != (now > 0)) slopes.push_back(slope - most / shots);
        before = now;
    }
    return slopes;
}
double slope_at_start(const VectorXd& u) {
    return (3 * u(0) - 1.5 * u(1) + u(2) / 3) * static_cast<double>(u.size() + 1) / 2;
}

}  // namespace

TEST_CASE("fields pass the check of derivatives") {
    const auto check = [](const auto& model, double p) {
        const auto problem = sparse(model);
        const DerivativeErrors errors =
            check_derivatives(problem, VectorXd(VectorXd::LinSpaced(problem.unknowns(), -0.4, 0.9)), p);
        CHECK(errors.symmetry < 1e-12);
        CHECK(errors.tangent_derivative < 1e-6);
    };
    check(Bratu(1, 20), 0.8);
    check(Bratu(2, 7), 0.8);
    check(Bratu(3, 5), 0.8);
    for (const int degree : {1, 2, 3, 4}) check(BratuElements(5, degree), 0.8);
    check(Gelfand(20), 0.8);
    check(SwiftHohenberg({10}, {30}, 1.8), -0.3);
    check(SwiftHohenberg({8, 6}, {12, 9}, 1.8), -0.3);
    check(Carrier(20), 0.3);
}

TEST_CASE("Bratu, one dimension: the closed form's fold and branch") {
    const double t = bratu_fold_angle(), fold = bratu_parameter(t);
    const auto branch = branch_from_zero(Bratu(1, 400), 0.5);
    REQUIRE(branch.events.size() == 1);
    CHECK(branch.events[0].point.q.maxCoeff() == Approx(2 * std::log(std::cosh(t))).epsilon(1e-5));
    // u in the middle is 2 log cosh t
    for (const auto& point : branch.points)
        CHECK(point.p == Approx(bratu_parameter(std::acosh(std::exp(point.q.maxCoeff() / 2)))).epsilon(1e-4));
    CHECK(extrapolated({folds_of(Bratu(1, 200), 0.5).at(0), branch.events[0].point.p}) == Approx(fold).epsilon(1e-9));
}

TEST_CASE("Bratu, one dimension: elements of degree k have errors of order 2 k") {
    const double fold = bratu_parameter(bratu_fold_angle());
    for (const int degree : {1, 2, 3, 4}) {
        const double coarse = std::abs(folds_of(BratuElements(5, degree), 0.8).at(0) / fold - 1),
                     fine = std::abs(folds_of(BratuElements(10, degree), 0.8).at(0) / fold - 1);
        CAPTURE(degree, coarse, fine);
        CHECK(fine < coarse / std::pow(2.0, 2 * degree - 1));
        if (degree == 4) CHECK(fine < 1e-10);
    }
    const VectorXd u = VectorXd::LinSpaced(9, 0, 1);
    CHECK((sparse(Bratu(1, 10)).residual(u, 1.3) - 10 * sparse(BratuElements(10, 1)).residual(u, 1.3)).norm() < 1e-12);
}

TEST_CASE("Bratu, two dimensions: the fold, extrapolated") {
    std::vector<double> folds;
    for (const int intervals : {8, 16, 32}) folds.push_back(folds_of(Bratu(2, intervals), 2).at(0));
    CHECK(extrapolated(folds) == Approx(6.808124423).epsilon(1e-7));
}

TEST_CASE("Bratu, three dimensions: the fold is between those of the balls inside and outside of the cube") {
    // below Gelfand's fold of the inscribed ball, above that of the circumscribed one: the fold of a domain shrinks
    // with it, and that of a ball of radius R is Gelfand's over R^2
    const double ball = emden_folds(3).at(0);
    const double fold = extrapolated({folds_of(Bratu(3, 4), 8, 12).at(0), folds_of(Bratu(3, 8), 8, 12).at(0)});
    CHECK(fold < 4 * ball);
    CHECK(fold > 4 * ball / 3);
}

TEST_CASE("Gelfand on the ball: folds about lambda = 2 as Emden's equation has them") {
    const std::vector<double> reference = emden_folds(11);
    const std::vector<double> coarse = folds_of(Gelfand(300), 0.5, 70), fine = folds_of(Gelfand(600), 0.5, 70);
    REQUIRE(reference.size() >= 5);
    REQUIRE(coarse.size() >= 5);
    REQUIRE(fine.size() >= 5);
    CHECK(reference[0] == Approx(3.3219921).epsilon(1e-7));
    for (std::size_t k = 0; k < 5; ++k) {
        CAPTURE(k);
        CHECK(extrapolated({coarse[k], fine[k]}) == Approx(reference[k]).epsilon(2e-6));
        CHECK((reference[k] > 2) == (k % 2 == 0));
    }
}

TEST_CASE("Swift-Hohenberg: localised states snake between two limits about the Maxwell point") {
    const double nu = 1.8;
    const SwiftHohenberg model({60}, {240}, nu);
    const auto problem = sparse(model);
    VectorXd guess(model.size());
    for (Eigen::Index i = 0; i < guess.size(); ++i)
        guess(i) = 1.4 * std::cos(model.coordinate(i, 0)) / std::cosh(model.coordinate(i, 0) / 8);
    const auto branch = continue_branch(problem, guess, -0.3, 1, large_steps(-1, -0.02, 160, 0.1));
    CHECK(branch.unexplained.empty());
    std::vector<double> right, left, growth;
    for (std::size_t k = 0; k < branch.events.size(); ++k) {
        const auto& point = branch.events[k].point;
        CHECK(point.kind == CriticalKind::fold);
        // stable up to the right fold, unstable back to the left one
        CHECK(point.negative_before.value_or(-1) == static_cast<int>(k % 2));
        (k % 2 == 0 ? right : left).push_back(point.p);
        if (k % 2 == 0) growth.push_back(point.q.squaredNorm());
    }
    REQUIRE(right.size() >= 4);
    REQUIRE(left.size() >= 3);
    // the fronts feel each other, and the ends, less than e^(-x / 5)
    CHECK(std::abs(right[2] - right[1]) < 0.01 * std::abs(right[1] - right[0]));
    CHECK(std::abs(left[2] - left[1]) < 0.02 * std::abs(left[1] - left[0]));
    const double maxwell = maxwell_point(nu);
    CHECK(left[2] < maxwell);
    CHECK(maxwell < right[2]);
    // each turn adds the same wave on both sides
    CHECK(growth[2] - growth[1] == Approx(growth[1] - growth[0]).epsilon(2e-3));
    CHECK(growth[3] - growth[2] == Approx(growth[2] - growth[1]).epsilon(2e-3));
}

TEST_CASE("Swift-Hohenberg, two dimensions: stripes are the line's, and hexagons snake") {
    const SwiftHohenberg line({12}, {24}, 1.6), plane({12, 5}, {24, 8}, 1.6);
    const VectorXd u = VectorXd::LinSpaced(24, -1, 1.3).array().sin();
    VectorXd stripes(24 * 8);
    for (Eigen::Index row = 0; row < 8; ++row) stripes.segment(24 * row, 24) = u;
    const VectorXd g = sparse(line).residual(u, -0.2), g_plane = sparse(plane).residual(stripes, -0.2);
    for (Eigen::Index row = 0; row < 8; ++row) CHECK((g_plane.segment(24 * row, 24) - g).norm() < 1e-12);

    const double length = 12 * std::numbers::pi, width = 2 * std::numbers::pi / std::sqrt(3.0);
    const SwiftHohenberg strip({length, width}, {48, 5}, 1.6);
    VectorXd guess(strip.size());
    for (Eigen::Index i = 0; i < guess.size(); ++i) {
        const double x = strip.coordinate(i, 0), y = strip.coordinate(i, 1);
        guess(i) = 0.6 * (std::cos(x) + 2 * std::cos(x / 2) * std::cos(std::sqrt(3.0) / 2 * y)) / std::cosh(x / 8);
    }
    const auto branch = continue_branch(sparse(strip), guess, -0.3, 1, large_steps(-1, -0.02, 110, 0.1));
    CHECK(branch.unexplained.empty());
    REQUIRE(branch.events.size() >= 4);
    for (std::size_t k = 0; k < 4; ++k) {
        const auto& point = branch.events[k].point;
        CHECK(point.kind == CriticalKind::fold);
        CHECK((point.p > -0.3) == (k % 2 == 0));
        if (k >= 2) CHECK(point.q.norm() > branch.events[k - 2].point.q.norm());
    }
}

TEST_CASE("Carrier: as many solutions by deflation and on the branches as by shooting, joined in pairs") {
    const double eps = 0.23;
    const Carrier model(300);
    const auto problem = sparse(model);
    const auto solutions = solutions_at(problem, eps, model.guesses(eps, 6));
    std::vector<double> slopes;
    for (const VectorXd& u : solutions) {
        CHECK(problem.residual(u, eps).lpNorm<Eigen::Infinity>() < 1e-9);
        slopes.push_back(slope_at_start(u));
    }
    std::sort(slopes.begin(), slopes.end());
    const std::vector<double> shot = carrier_slopes(eps);
    REQUIRE(shot.size() == 8);
    REQUIRE(slopes.size() == shot.size());
    for (std::size_t k = 0; k < shot.size(); ++k) CHECK(slopes[k] == Approx(shot[k]).epsilon(0.01));

    // what is joined to them, each branch once
    DiagramOptions options;
    options.continuation = large_steps(0.22, 1, 400, 0.1);
    options.continuation.branch.parameter_weight = 2;
    std::vector<BranchGraph<std::remove_cv_t<decltype(problem)>>> graphs;
    BranchStepper stepper(problem, options.continuation.branch);
    for (const VectorXd& u : solutions) {
        const auto start = stepper.start(u, eps, 1);
        REQUIRE(start);
        const bool known = std::any_of(graphs.begin(), graphs.end(), [&](const auto& graph) {
            return std::any_of(graph.branches.begin(), graph.branches.end(),
                               [&](const auto& edge) { return lies_on(stepper, edge.branch, *start); });
        });
        if (!known) graphs.push_back(bifurcation_diagram(problem, u, eps, options));
    }
    std::vector<double> folds, pitchforks;
    for (const auto& graph : graphs) {
        CHECK(graph.complete());
        for (const auto& node : graph.nodes) {
            if (node.point.kind == CriticalKind::fold) folds.push_back(node.point.p);
            if (node.point.kind == CriticalKind::pitchfork) pitchforks.push_back(node.point.p);
        }
    }
    REQUIRE(folds.size() == 1);
    REQUIRE(pitchforks.size() == 2);
    std::sort(pitchforks.begin(), pitchforks.end());
    // two solutions less beyond each of them
    CHECK(pitchforks[0] < folds[0]);
    CHECK(folds[0] < pitchforks[1]);
    std::size_t left = 8;
    for (const double at : {pitchforks[0], folds[0], pitchforks[1]}) {
        CHECK(carrier_slopes(at - 0.005).size() == left);
        left -= 2;
        CHECK(carrier_slopes(at + 0.005).size() == left);
    }
}
