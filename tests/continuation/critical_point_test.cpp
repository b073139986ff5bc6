
#include <Eigen/Core>

#include <equilibria/continuation/critical_point.hpp>

#include "../programs/support/structures.hpp"
#include "support/catch.hpp"
#include "support/dense.hpp"

using namespace equilibria;
using namespace support;

namespace {

/// On the way down to rounding each step is at most a constant times the square of the one before; at least two are
/// seen.
template <class P>
void check_quadratic(const CriticalPoint<P>& point, double constant) {
    int seen = 0;
    for (std::size_t k = 1; k < point.history.size(); ++k) {
        const double before = point.history[k - 1].step, step = point.history[k].step;
        if (before > 0.05 || point.history[k - 1].bifurcation_system != point.history[k].bifurcation_system) continue;
        if (before < 1e-8) break;
        CAPTURE(k, before, step);
        CHECK(step <= constant * before * before + 1e-13);
        ++seen;
    }
    CHECK(seen >= 2);
}

/// Newton's method on the full system (29) of Cardona and Huespe, unknowns q, phi, p, gamma; differences along the way.
template <class P>
VectorXd dense_bifurcation(const P& problem, VectorXd q, VectorXd phi, double p) {
    const Eigen::Index n = q.size();
    Eigen::Index i = 0;
    phi.cwiseAbs().maxCoeff(&i);
    VectorXd y(2 * n + 2);
    y << q, phi / phi(i), p, 0;
    const auto f = [&](const VectorXd& z) {
        const VectorXd at = z.head(n), v = z.segment(n, n);
        VectorXd r(2 * n + 2);
        r.head(n) = problem.residual(at, z(2 * n));
        r(i) += z(2 * n + 1);
        r.segment(n, n) = problem.tangent(at, z(2 * n)) * v;
        r(2 * n) = v(i) - 1;
        r(2 * n + 1) = problem.parameter_derivative(at, z(2 * n)).dot(v);
        return r;
    };
    for (int k = 0; k < 20; ++k) {
        MatrixXd j(2 * n + 2, 2 * n + 2);
        for (Eigen::Index c = 0; c < y.size(); ++c) {
            VectorXd ahead = y, behind = y;
            ahead(c) += 1e-6;
            behind(c) -= 1e-6;
            j.col(c) = (f(ahead) - f(behind)) / 2e-6;
        }
        y -= tests::solved(j, f(y));
    }
    return y;
}

/// The equilibrium at a load, from an unloaded structure, by load control in small steps.
VectorXd loaded(const Truss& truss, double p) {
    VectorXd q = truss.unloaded();
    for (int step = 1; step <= 50; ++step)
        for (int k = 0; k < 8; ++k)
            q -= tests::solved(truss.tangent(q, p * step / 50), truss.residual(q, p * step / 50));
    return q;
}

}  // namespace

TEST_CASE("limit points: quadratic from 1 % and from 5 % off in the load") {
    const double limit = 3.15579970840e-4;
    const auto dome = star_dome(1, 0);
    for (const double off : {0.01, 0.05}) {
        CriticalPointSolver<Truss> solver(dome);
        const auto point = solver.solve(loaded(dome, (1 - off) * limit), (1 - off) * limit, Border{2, 2});
        REQUIRE(point);
        CHECK(point->kind == CriticalKind::fold);
        CHECK(point->p == Approx(limit).epsilon(1e-11));
        CHECK(point->transversality > 0.5);
        CHECK(point->iterations() <= 8);
        check_quadratic(*point, 20);
    }
}

TEST_CASE("bifurcation points: quadratic from 1 % and from 5 % off, and the root of the full system (29)") {
    const double critical = 8.64367449817e-4;
    const auto dome = star_dome(.5, 1);
    for (const double off : {0.01, 0.05}) {
        CriticalPointSolver<Truss> solver(dome);
        const auto point = solver.solve(loaded(dome, (1 - off) * critical), (1 - off) * critical);
        REQUIRE(point);
        CHECK(point->kind == CriticalKind::pitchfork);
        CHECK(point->p == Approx(critical).epsilon(1e-11));
        CHECK(point->transversality < 1e-9);
        CHECK(std::abs(point->unfolding) < 1e-15);
        check_quadratic(*point, 20);
        const VectorXd full = dense_bifurcation(dome, loaded(dome, (1 - off) * critical), point->null_vector, critical);
        CHECK(full(2 * 21) == Approx(point->p).epsilon(1e-11));
        CHECK((full.head(21) - point->q).norm() < 1e-8);
        CHECK(std::abs(full(2 * 21 + 1)) < 1e-12);
    }
}

TEST_CASE("the coefficients of the bifurcation equation: exact derivatives and differences agree") {
    struct Exact : ShallowArch {
        MatrixXd tangent_derivative(const VectorXd& a, double, const VectorXd& v) const {
            const double d = 2 * a(0) * v(0) + 8 * a(1) * v(1), cross = 8 * (v(0) * a(1) + a(0) * v(1));
            Eigen::Matrix2d k;
            k << d + 4 * a(0) * v(0), cross, cross, 4 * d + 64 * a(1) * v(1);
            return k;
        }
    };
    for (const double l : {2.2, 2.5, 3.0}) {
        const VectorXd near = Eigen::Vector2d(std::sqrt(l * l - 4) * 1.01, 0);
        const ShallowArch arch{l};
        const Exact exact{{l}};
        const double p = arch.bifurcation();
        const auto by_differences = CriticalPointSolver<ShallowArch>(arch).solve(near, p, Border{1, 1});
        const auto by_derivatives = CriticalPointSolver<Exact>(exact).solve(near, p, Border{1, 1});
        REQUIRE((by_differences && by_derivatives));
        CHECK(by_derivatives->p == Approx(p).epsilon(1e-13));
        CHECK(by_differences->a == Approx(by_derivatives->a).margin(1e-8));
        CHECK(by_differences->b == Approx(by_derivatives->b).epsilon(1e-8));
        CHECK(by_differences->c == Approx(by_derivatives->c).margin(1e-8));
        CHECK(by_differences->curvature == Approx(by_derivatives->curvature).epsilon(1e-5));
        // side branch: p = l + 3 A1, A1^2 + 4 A2^2 = l^2 - 4
        CHECK(by_derivatives->curvature == Approx(-12 / std::sqrt(l * l - 4)).epsilon(1e-6));
    }
}

TEST_CASE("isola centre, and a trans-critical point at which dg/dp vanishes") {
    /// One unknown: x^2 + p^2, or x (p - x).
    struct Scalar {
        int which;
        VectorXd residual(const VectorXd& q, double p) const {
            const double x = q(0);
            return VectorXd::Constant(1, which == 0 ? x * x + p * p : x * (p - x));
        }
        MatrixXd tangent(const VectorXd& q, double p) const {
            const double x = q(0);
            return MatrixXd::Constant(1, 1, which == 0 ? 2 * x : p - 2 * x);
        }
        VectorXd parameter_derivative(const VectorXd& q, double p) const {
            return VectorXd::Constant(1, which == 0 ? 2 * p : q(0));
        }
    };
    const auto at = [](int which, double x, double p) {
        const Scalar problem{which};
        return CriticalPointSolver<Scalar>(problem).solve(VectorXd::Constant(1, x), p);
    };
    const auto isola = at(0, 1e-3, 1e-3);
    REQUIRE(isola);
    CHECK(isola->kind == CriticalKind::isola_center);
    CHECK(isola->tangents.empty());
    const auto crossing = at(1, 1e-3, 2e-3);
    REQUIRE(crossing);
    CHECK(crossing->kind == CriticalKind::transcritical);
    REQUIRE(crossing->tangents.size() == 2);
    for (const auto& t : crossing->tangents)
        CHECK((std::abs(t.q(0)) < 1e-9 || t.q(0) == Approx(t.p).epsilon(1e-9)));  // the lines x = 0 and x = p
}
