// Orders: of the differences that stand in for missing derivatives, of the coefficients that are made from them, and of
// Newton's method on the extended systems. The exact derivatives are those of generic_problem.hpp.
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/generic_problem.hpp>

#include "continuation/arch_energy.hpp"
#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using Eigen::MatrixXd, Eigen::VectorXd;

namespace {

const double eps = std::numeric_limits<double>::epsilon();

/// Two bars with EA = 1 from (-1, 0) and (1, 0) to the apex, which is at q; unloaded at (0, h), load p down.
/// Engineering strain, or Green's.
struct Truss {
    double h;
    bool green = true;
    template <class T>
    T energy(const Eigen::VectorX<T>& q, const T& p) const {
        using std::sqrt;
        const double l2 = 1 + h * h, l = std::sqrt(l2);
        T v = p * q(1);
        for (const double side : {-1.0, 1.0}) {
            const T x = q(0) + side, now2 = x * x + q(1) * q(1);
            const T strain = green ? T((now2 - l2) / (2 * l2)) : T((sqrt(now2) - l) / l);
            v += 0.5 * l * strain * strain;
        }
        return v;
    }
};

/// Two branches cross at s = 0, y = sin p, sin p + p = 1, one of them s = 0; the parameter enters nonlinearly:
/// V = (y - sin p)^2 / 2 + alpha (e^s - 1 - s - s^2 / 2) + beta s^2 (y + p - 1), s = x - delta sin p.
struct Crossing {
    double alpha, beta, delta;
    template <class T>
    T energy(const Eigen::VectorX<T>& q, const T& p) const {
        using std::exp, std::sin;
        const T s = q(0) - delta * sin(p), y = q(1) - sin(p);
        return 0.5 * y * y + alpha * (exp(s) - 1 - s - 0.5 * s * s) + beta * s * s * (q(1) + p - 1);
    }
    static double critical() {
        double p = 0.5;
        for (int k = 0; k < 8; ++k) p -= (std::sin(p) + p - 1) / (std::cos(p) + 1);
        return p;
    }
};

/// A problem without its optional functions: they are differenced.
template <class P>
struct Differenced {
    const P& exact;
    static constexpr bool symmetric = P::symmetric;
    VectorXd residual(const VectorXd& q, double p) const { return exact.residual(q, p); }
    MatrixXd tangent(const VectorXd& q, double p) const { return exact.tangent(q, p); }
    VectorXd parameter_derivative(const VectorXd& q, double p) const { return exact.parameter_derivative(q, p); }
};

/// A problem in units that are `scale` times as large, of q and of p: a step of differences is that much longer.
template <class P>
struct Scaled {
    const P& problem;
    double scale;
    static constexpr bool symmetric = P::symmetric;
    VectorXd residual(const VectorXd& q, double p) const { return problem.residual(scale * q, scale * p); }
    MatrixXd tangent(const VectorXd& q, double p) const { return scale * problem.tangent(scale * q, scale * p); }
    VectorXd parameter_derivative(const VectorXd& q, double p) const {
        return scale * problem.parameter_derivative(scale * q, scale * p);
    }
    MatrixXd tangent_derivative(const VectorXd& q, double p, const VectorXd& v) const
    requires requires(const P& at) { at.tangent_derivative(q, p, v); }
    {
        return scale * scale * problem.tangent_derivative(scale * q, scale * p, v);
    }
};

/// The slope of log error over log step by least squares.
double slope(const std::vector<double>& steps, const std::vector<double>& errors) {
    const auto n = static_cast<double>(steps.size());
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const double a = std::log(steps[k]), b = std::log(errors[k]);
        x += a, y += b, xx += a * a, xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

/// The equilibrium at a load by load control, from `start` at the load `from`, in small steps.
template <class P>
VectorXd loaded(const P& problem, VectorXd q, double from, double p) {
    for (int step = 1; step <= 50; ++step) {
        const double now = from + (p - from) * step / 50;
        for (int k = 0; k < 6; ++k) q -= tests::solved(problem.tangent(q, now), problem.residual(q, now));
    }
    return q;
}

/// Each step after one below 0.3 is at most `constant` times the square of the one before, down to rounding; at least
/// two are seen.
void check_quadratic(const std::vector<double>& steps, double constant) {
    int seen = 0;
    for (std::size_t k = 1; k < steps.size() && steps[k - 1] > 1e-8; ++k) {
        if (steps[k - 1] > 0.3) continue;
        CAPTURE(k, steps[k - 1], steps[k], steps[k] / (steps[k - 1] * steps[k - 1]));
        CHECK(steps[k] <= constant * steps[k - 1] * steps[k - 1] + 1e-13);
        ++seen;
    }
    CHECK(seen >= 2);
}
/// The steps on the system that converged.
template <class P>
std::vector<double> last_steps(const CriticalPoint<P>& point) {
    std::vector<double> steps;
    for (const auto& entry : point.history)
        if (entry.bifurcation_system == point.history.back().bifurcation_system) steps.push_back(entry.step);
    return steps;
}

/// Newton's method on a full extended system, z -= J^-1 F: the root, and the lengths of the steps.
struct DenseRoot {
    VectorXd z;
    std::vector<double> steps;
};
template <class System>
DenseRoot dense_newton(const System& system, VectorXd z) {
    DenseRoot y;
    for (int k = 0; k < 20; ++k) {
        const auto [f, j] = system(z);
        const VectorXd d = tests::solved(j, f);
        z -= d;
        y.steps.push_back(d.norm());
        if (d.norm() < 1e-13) break;
    }
    y.z = z;
    return y;
}

/// (28) of Cardona and Huespe, [g; K phi; phi^T phi - 1], unknowns q, phi, p: F and its Jacobian
///     [ K   0        g_p      ]
///     [ D   K        K_p phi  ]    D = dK along phi
///     [ 0   2 phi^T  0        ]
template <class P>
std::pair<VectorXd, MatrixXd> limit_system(const P& problem, const VectorXd& z) {
    const Eigen::Index n = (z.size() - 1) / 2;
    const VectorXd q = z.head(n), phi = z.segment(n, n);
    const double p = z(2 * n);
    const MatrixXd k = problem.tangent(q, p);
    VectorXd f(2 * n + 1);
    f << problem.residual(q, p), k * phi, phi.squaredNorm() - 1;
    MatrixXd j = MatrixXd::Zero(2 * n + 1, 2 * n + 1);
    j.topLeftCorner(n, n) = j.block(n, n, n, n) = k;
    j.block(n, 0, n, n) = problem.tangent_derivative(q, p, phi);
    j.col(2 * n).head(n) = problem.parameter_derivative(q, p);
    j.col(2 * n).segment(n, n) = problem.parameter_derivative_along(q, p, phi);
    j.row(2 * n).segment(n, n) = 2 * phi.transpose();
    return {f, j};
}

/// (29), [g + gamma e_i; K phi; phi_i - 1; phi^T g_p], unknowns q, phi, p, gamma, K symmetric: F and its Jacobian
///     [ K              0      g_p          e_i ]
///     [ D              K      K_p phi      0   ]
///     [ 0              e_i^T  0            0   ]
///     [ (K_p phi)^T    g_p^T  phi^T g_pp   0   ]
template <class P>
std::pair<VectorXd, MatrixXd> bifurcation_system(const P& problem, Eigen::Index i, const VectorXd& z) {
    const Eigen::Index n = (z.size() - 2) / 2;
    const VectorXd q = z.head(n), phi = z.segment(n, n);
    const double p = z(2 * n);
    const MatrixXd k = problem.tangent(q, p);
    const VectorXd g_p = problem.parameter_derivative(q, p), k_p_phi = problem.parameter_derivative_along(q, p, phi);
    VectorXd f(2 * n + 2);
    f << problem.residual(q, p), k * phi, phi(i) - 1, phi.dot(g_p);
    f(i) += z(2 * n + 1);
    MatrixXd j = MatrixXd::Zero(2 * n + 2, 2 * n + 2);
    j.topLeftCorner(n, n) = j.block(n, n, n, n) = k;
    j.block(n, 0, n, n) = problem.tangent_derivative(q, p, phi);
    j.col(2 * n) << g_p, k_p_phi, 0, phi.dot(problem.second_parameter_derivative(q, p));
    j(i, 2 * n + 1) = 1;
    j(2 * n, n + i) = 1;
    j.row(2 * n + 1).head(2 * n) << k_p_phi.transpose(), g_p.transpose();
    return {f, j};
}

/// A critical point on the primary path, from `off` before it.
struct Case {
    const char* name;
    VectorXd start;  ///< the equilibrium at p = 0
    double p;
};

/// From 1 % and 5 % off, in the load and off the branch: quadratic steps, the kind, and the root and the steps of the
/// full system.
template <class P>
void check_convergence(const P& problem, const Case& at, CriticalKind kind, double constant) {
    for (const double off : {0.01, 0.05}) {
        CAPTURE(at.name, off);
        const double p = (1 - off) * at.p;
        VectorXd q = loaded(problem, at.start, 0, p);
        q += off * Eigen::Vector2d(0.6, -0.8);
        const auto point = CriticalPointSolver<P>(problem).solve(q, p);
        REQUIRE(point);
        CHECK(point->kind == kind);
        CHECK(point->p == Approx(at.p).epsilon(1e-13));
        check_quadratic(last_steps(*point), constant);

        const Eigen::Index n = q.size();
        const VectorXd phi = point->null_vector + off * Eigen::Vector2d(0.8, 0.6);
        DenseRoot full;
        if (kind == CriticalKind::fold) {
            VectorXd z(2 * n + 1);
            z << q, phi.normalized(), p;
            full = dense_newton([&](const VectorXd& y) { return limit_system(problem, y); }, z);
        } else {
            Eigen::Index i = 0;
            phi.cwiseAbs().maxCoeff(&i);
            VectorXd z(2 * n + 2);
            z << q, phi / phi(i), p, 0;
            full = dense_newton([&](const VectorXd& y) { return bifurcation_system(problem, i, y); }, z);
            CHECK(std::abs(full.z(2 * n + 1)) < 1e-14);
        }
        CHECK(full.z(2 * n) == Approx(point->p).epsilon(1e-12));
        CHECK((full.z.head(n) - point->q).norm() < 1e-10);
        check_quadratic(full.steps, constant);
    }
}

/// The closed forms of a pitchfork of the truss: apex at (0, y).
struct TrussPitchfork {
    double y, p, b, curvature;
};
TrussPitchfork green_pitchfork(double h) {
    // V_x = x (x^2 + y^2 - h^2 + 2) / l^3, V_y = y (x^2 + y^2 - h^2) / l^3 + p
    const double l3 = std::pow(1 + h * h, 1.5), y = std::sqrt(h * h - 2);
    return {y, 2 * y / l3, -y / (h * h - 3), -2 / (l3 * y)};
}
TrussPitchfork engineering_pitchfork(double h) {
    // V_xx = 2 (1/l - y^2/s^3) = 0 at the bars' length s; the root of s^3 = l (s^2 - 1) that is met first
    const double l = std::sqrt(1 + h * h);
    double s = l;
    for (int k = 0; k < 30; ++k) s -= (s * s * s - l * (s * s - 1)) / (3 * s * s - 2 * l * s);
    const double y = std::sqrt(s * s - 1), s3 = s * s * s, s5 = s3 * s * s, s7 = s5 * s * s;
    const double v_yy = 2 / l - 2 / s3, v_xxy = -2 * (2 * y / s3 - 3 * y * y * y / s5),
                 v_xxxx = 6 * y * y / s5 - 30 * y * y / s7;
    const double b = -v_xxy / v_yy, d = v_xxxx - 3 * v_xxy * v_xxy / v_yy;
    return {y, 2 * y * (1 / s - 1 / l), b, -d / (3 * b)};
}

}  // namespace

TEST_CASE("differences in place of derivatives converge with the square of the step") {
    const EnergyProblem problem(Crossing{1.3, 0.7, 0.4});
    const VectorXd q = Eigen::Vector2d(0.6, -0.2), v = Eigen::Vector2d(0.7, -1);
    const double p = 0.8;
    std::vector<double> steps, errors[3];
    for (double scale = 200; scale < 5000; scale *= 2) {
        // the library's own steps: eps^(1/3) in these units, thus eps^(1/3) scale
        const Scaled<EnergyProblem<Crossing>> rough{problem, scale};
        const Differenced<Scaled<EnergyProblem<Crossing>>> hidden{rough};
        const double unit = 1 / (scale * scale);
        steps.push_back(scale * std::cbrt(eps));
        errors[0].push_back(
            (unit * tangent_derivative(hidden, VectorXd(q / scale), p / scale, v) - problem.tangent_derivative(q, p, v))
                .norm());
        errors[1].push_back((unit * parameter_derivative_along(hidden, VectorXd(q / scale), p / scale, v) -
                             problem.parameter_derivative_along(q, p, v))
                                .norm());
    }
    for (int k = 0; k < 2; ++k) {
        CAPTURE(k, errors[k]);
        CHECK(slope(steps, errors[k]) == Approx(2).margin(0.1));
    }
    // d2g/dp2 has a step relative to p: a difference of the test's own
    for (const double h : steps) {
        const VectorXd central =
            (problem.parameter_derivative(q, p + h) - problem.parameter_derivative(q, p - h)) / (2 * h);
        errors[2].push_back((central - problem.second_parameter_derivative(q, p)).norm());
    }
    CHECK(slope(steps, errors[2]) == Approx(2).margin(0.1));
    // and with the library's steps all are within a constant times eps^(2/3)
    const Differenced<EnergyProblem<Crossing>> hidden{problem};
    const double bound = 20 * std::pow(eps, 2.0 / 3);
    CHECK((tangent_derivative(hidden, q, p, v) - problem.tangent_derivative(q, p, v)).norm() < bound);
    CHECK((parameter_derivative_along(hidden, q, p, v) - problem.parameter_derivative_along(q, p, v)).norm() < bound);
    CHECK((second_parameter_derivative(hidden, q, p) - problem.second_parameter_derivative(q, p)).norm() < bound);
}

TEST_CASE("a, b, c of a trans-critical point: closed form, exact derivatives, differences") {
    const double p = Crossing::critical(), w = std::cos(p);
    for (const double delta : {0.0, 0.4}) {
        const double alpha = 1.3, beta = 0.7;
        const EnergyProblem problem(Crossing{alpha, beta, delta});
        const Differenced<EnergyProblem<Crossing>> hidden{problem};
        const VectorXd near = Eigen::Vector2d(delta * std::sin(p) + 0.01, std::sin(p) - 0.01);
        const auto exact = CriticalPointSolver(problem).solve(near, p + 0.01);
        const auto differenced = CriticalPointSolver(hidden).solve(near, p + 0.01);
        REQUIRE((exact && differenced));
        // with (s, y) for (x, y) the coefficients are alpha, 2 beta (1 + w), 0, and x = s + delta w p
        const double b = 2 * beta * (1 + w), t = delta * w;
        const double a = alpha, b_x = b - alpha * t, c_x = -2 * b * t + alpha * t * t;
        CHECK(exact->kind == CriticalKind::transcritical);
        CHECK(differenced->kind == CriticalKind::transcritical);
        CHECK(exact->p == Approx(p).epsilon(1e-13));
        CHECK(differenced->p == Approx(p).epsilon(1e-13));
        CHECK(exact->a == Approx(a).epsilon(1e-12));
        CHECK(exact->b == Approx(b_x).epsilon(1e-12));
        CHECK(exact->c == Approx(c_x).epsilon(1e-12).margin(1e-12));
        const double bound = 20 * std::pow(eps, 2.0 / 3);
        CHECK(std::abs(differenced->a - a) < bound);
        CHECK(std::abs(differenced->b - b_x) < bound);
        CHECK(std::abs(differenced->c - c_x) < bound);
        // the tangents are s = 0 and a s + 2 b p = 0
        REQUIRE(exact->tangents.size() == 2);
        int along = 0, across = 0;
        for (const auto& d : exact->tangents) {
            const double s = d.q(0) - t * d.p;
            CHECK(d.q(1) == Approx(w * d.p).epsilon(1e-12));
            if (std::abs(s) < 1e-12) ++along;
            if (std::abs(a * s + 2 * b * d.p) < 1e-12) ++across;
        }
        CHECK(along == 1);
        CHECK(across == 1);
    }
}

TEST_CASE("coefficients of the arch and of the truss: closed form, exact derivatives, differences") {
    const double second = 50 * std::pow(eps, 2.0 / 3);  // of a, b, c from differences
    const double cubic = 50 * std::pow(eps, 1.0 / 2);   // of the curvature: a difference with the step eps^(1/4)
    const double noisy = 50 * std::pow(eps, 5.0 / 12);  // of differences over that step
    const auto check = [&](const auto& problem, const VectorXd& near, double p, double b, double curvature) {
        const Differenced<std::remove_cvref_t<decltype(problem)>> hidden{problem};
        const auto exact = CriticalPointSolver(problem).solve(near, p);
        const auto differenced = CriticalPointSolver(hidden).solve(near, p);
        REQUIRE((exact && differenced));
        CHECK(exact->kind == CriticalKind::pitchfork);
        CHECK(differenced->kind == CriticalKind::pitchfork);
        CHECK(exact->p == Approx(p).epsilon(1e-13));
        CHECK(std::abs(exact->a) < 1e-12);
        CHECK(exact->b == Approx(b).epsilon(1e-11));
        CHECK(std::abs(exact->c) < 1e-12);
        CHECK(exact->curvature == Approx(curvature).epsilon(cubic));
        CHECK(std::abs(differenced->a) < second);
        CHECK(differenced->b == Approx(b).epsilon(second));
        CHECK(std::abs(differenced->c) < second);
        CHECK(differenced->curvature == Approx(curvature).epsilon(noisy));
    };
    const double l = 2.5, a1 = std::sqrt(l * l - 4);
    check(EnergyProblem(ArchEnergy{l}), Eigen::Vector2d(1.01 * a1, 0), l + 3 * a1, -8 * a1 / (2 * l * l - 11),
          -12 / a1);
    const double h = 3;
    const auto green = green_pitchfork(h), engineering = engineering_pitchfork(h);
    CHECK(green.curvature == Approx(-0.02390457).epsilon(1e-6));
    check(EnergyProblem(Truss{h}), Eigen::Vector2d(0, green.y + 0.01), green.p, green.b, green.curvature);
    check(EnergyProblem(Truss{h, false}), Eigen::Vector2d(0, engineering.y + 0.01), engineering.p, engineering.b,
          engineering.curvature);
}

TEST_CASE("coefficients of folds: a and the curvature of p") {
    const auto check = [](const auto& problem, const VectorXd& near, double p, double a, double curvature) {
        const Differenced<std::remove_cvref_t<decltype(problem)>> hidden{problem};
        const auto exact = CriticalPointSolver(problem).solve(near, 1.01 * p);
        const auto differenced = CriticalPointSolver(hidden).solve(near, 1.01 * p);
        REQUIRE((exact && differenced));
        CHECK(exact->kind == CriticalKind::fold);
        CHECK(exact->p == Approx(p).epsilon(1e-13));
        CHECK(exact->a == Approx(a).epsilon(1e-12));
        CHECK(exact->curvature == Approx(curvature).epsilon(1e-12));
        CHECK(differenced->a == Approx(a).epsilon(50 * std::pow(eps, 2.0 / 3)));
        CHECK(differenced->curvature == Approx(curvature).epsilon(50 * std::pow(eps, 2.0 / 3)));
    };
    const double l = 1.8, a1 = std::sqrt((l * l - 1) / 3);
    check(EnergyProblem(ArchEnergy{l}), Eigen::Vector2d(a1 + 0.02, 0.01), l + 2 * (l * l - 1) * a1 / 3, 6 * a1,
          -6 * a1);
    // Green: p = y (h^2 - y^2) / l^3
    const double h = 1.2, l3 = std::pow(1 + h * h, 1.5), y = h / std::sqrt(3.0);
    check(EnergyProblem(Truss{h}), Eigen::Vector2d(0.001, y + 0.02), 2 * h * h * y / (3 * l3), 6 * y / l3, -6 * y / l3);
    // engineering: p = 2 y (1/s - 1/l), extreme at s^3 = l, p'' = -6 y / s^5
    const double s = std::cbrt(std::sqrt(1 + h * h)), ye = std::sqrt(s * s - 1);
    check(EnergyProblem(Truss{h, false}), Eigen::Vector2d(0.001, ye + 0.02), 2 * ye * (1 / s - 1 / (s * s * s)),
          6 * ye / std::pow(s, 5), -6 * ye / std::pow(s, 5));
}

TEST_CASE("the curvature of a pitchfork converges with the square of its step") {
    // the step eps^(1/4) is that many times longer in units in which the truss is small
    const EnergyProblem problem(Truss{3, false});
    const auto exact = engineering_pitchfork(3);
    std::vector<double> steps, errors;
    for (double scale = 50; scale < 1000; scale *= 2) {
        const Scaled<EnergyProblem<Truss>> rough{problem, scale};
        const VectorXd near = Eigen::Vector2d(0, exact.y / scale);
        const auto point = CriticalPointSolver(rough).solve(near, exact.p / scale);
        REQUIRE(point);
        REQUIRE(point->kind == CriticalKind::pitchfork);
        steps.push_back(scale * std::pow(eps, 0.25));
        errors.push_back(std::abs(point->curvature / scale - exact.curvature));
    }
    CAPTURE(errors);
    CHECK(slope(steps, errors) == Approx(2).margin(0.1));
}

TEST_CASE("limit points: quadratic with exact derivatives, and the root of the full system (28)") {
    const double l = 1.8;
    check_convergence(EnergyProblem(ArchEnergy{l}),
                      {"arch", Eigen::Vector2d(l, 0), l + 2 * std::pow(l * l - 1, 1.5) / (3 * std::sqrt(3.0))},
                      CriticalKind::fold, 3);
    const double h = 1.2, l3 = std::pow(1 + h * h, 1.5);
    check_convergence(EnergyProblem(Truss{h}),
                      {"truss", Eigen::Vector2d(0, h), 2 * h * h * h / (3 * std::sqrt(3.0) * l3)}, CriticalKind::fold,
                      3);
}

TEST_CASE("bifurcation points: quadratic with exact derivatives, and the root of the full system (29)") {
    const double l = 2.5;
    check_convergence(EnergyProblem(ArchEnergy{l}), {"arch", Eigen::Vector2d(l, 0), l + 3 * std::sqrt(l * l - 4)},
                      CriticalKind::pitchfork, 12);
    check_convergence(EnergyProblem(Truss{3}), {"truss", Eigen::Vector2d(0, 3), green_pitchfork(3).p},
                      CriticalKind::pitchfork, 12);
    check_convergence(EnergyProblem(Crossing{1.3, 0.7, 0}), {"crossing", Eigen::Vector2d(0, 0), Crossing::critical()},
                      CriticalKind::transcritical, 12);
}
