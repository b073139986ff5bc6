#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/generic_problem.hpp>

#include "../programs/support/structures.hpp"
#include "continuation/arch_energy.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using namespace support;

namespace {

/// ShallowArch by its equations, with vectors of a fixed size.
struct ArchResidual {
    static constexpr bool symmetric = true;
    double l;
    template <class T>
    Eigen::Matrix<T, 2, 1> residual(const Eigen::VectorX<T>& a, const T& p) const {
        const T stretch = a(0) * a(0) + 4 * a(1) * a(1) - l * l;
        return {a(0) - l + stretch * a(0) + p, 16 * a(1) + 4 * stretch * a(1)};
    }
};
/// von_mises_truss by its energy, with Eigen's vectors of duals.
struct TrussEnergy {
    double h;
    Strain strain;
    template <class T>
    T energy(const Eigen::VectorX<T>& q, const T& p) const {
        using std::sqrt;
        const double l2 = 1 + h * h, l = std::sqrt(l2);
        T v = p * q(1);
        for (const double side : {-1.0, 1.0}) {
            Eigen::Matrix<T, 2, 1> bar = q;
            bar += Eigen::Vector2d(side, h).cast<T>();
            const T strain_now =
                strain == Strain::green ? T((bar.squaredNorm() - l2) / (2 * l2)) : T((sqrt(bar.squaredNorm()) - l) / l);
            v += 0.5 * l * strain_now * strain_now;
        }
        return v;
    }
};

/// Everything nonlinear, the parameter too: V = exp(q0 p) sin(q1) + p^3 q0 q1 + q0^2 / (1 + p^2).
struct Mixed {
    template <class T>
    T energy(const Eigen::VectorX<T>& q, const T& p) const {
        using std::exp, std::sin;
        return exp(q(0) * p) * sin(q(1)) + pow(p, 3) * q(0) * q(1) + q(0) * q(0) / (1 + p * p);
    }
    VectorXd weights(const VectorXd&) const { return Eigen::Vector2d(2, 3); }
};
/// Two unknowns, K unsymmetric; one multiplier, to see that it is passed on.
struct Follower {
    template <class T>
    Eigen::VectorX<T> residual(const Eigen::VectorX<T>& q, const T& p) const {
        using std::cos, std::sin;
        Eigen::VectorX<T> g(2);
        g << q(0) * q(1) - p * sin(q(0)), q(1) * q(1) * q(1) - p * p * cos(q(0));
        return g;
    }
    int multipliers() const { return 1; }
};

/// No generic function.
struct Plain {
    double energy(const VectorXd& q, double p) const { return p * q(0); }
    VectorXd residual(const VectorXd& q, double p) const { return p * q; }
};

static_assert(GenericEnergy<ArchEnergy> && !GenericEnergy<Plain> && !GenericEnergy<ArchResidual>);
static_assert(GenericResidual<ArchResidual> && !GenericResidual<Plain> && !GenericResidual<ArchEnergy>);
static_assert(ContinuationProblem<EnergyProblem<ArchEnergy>> && ContinuationProblem<ResidualProblem<ArchResidual>>);
static_assert(symmetric_tangent<EnergyProblem<ArchEnergy>> && symmetric_tangent<ResidualProblem<ArchResidual>> &&
              !symmetric_tangent<ResidualProblem<Follower>>);

template <class A, class B>
void check_same(const A& a, const B& b, double tolerance) {
    CAPTURE(a, b);
    REQUIRE(a.rows() == b.rows());
    REQUIRE(a.cols() == b.cols());
    CHECK((a - b).norm() <= tolerance * (1 + b.norm()));
}

const VectorXd configurations[] = {Eigen::Vector2d(0.3, -0.8), Eigen::Vector2d(-1.7, 0.4), Eigen::Vector2d(0.2, 0)};
const VectorXd direction = Eigen::Vector2d(0.7, -1.3);

}  // namespace

TEST_CASE("generic problems: the derivatives written by hand, to rounding") {
    const double rounding = 1e-14;
    const auto compare = [&](const auto& generic, const auto& by_hand) {
        for (const auto& q : configurations)
            for (const double p : {-0.4, 0.9}) {
                check_same(generic.residual(q, p), by_hand.residual(q, p), rounding);
                check_same(generic.tangent(q, p), by_hand.tangent(q, p), rounding);
                check_same(generic.parameter_derivative(q, p), by_hand.parameter_derivative(q, p), rounding);
                // a dead load
                CHECK(generic.parameter_derivative_along(q, p, direction).norm() == 0);
                CHECK(generic.second_parameter_derivative(q, p).norm() == 0);
            }
    };
    const ShallowArch arch{2.5};
    const EnergyProblem by_energy(ArchEnergy{2.5});
    const ResidualProblem by_residual(ArchResidual{2.5});
    compare(by_energy, arch);
    compare(by_residual, arch);
    for (const Strain strain : {Strain::green, Strain::engineering})
        compare(EnergyProblem(TrussEnergy{1.2, strain}), von_mises_truss(1.2, strain));
    for (const auto& a : configurations) {
        const VectorXd& v = direction;
        const double d = 2 * a(0) * v(0) + 8 * a(1) * v(1), cross = 8 * (v(0) * a(1) + a(0) * v(1));
        Eigen::Matrix2d k;
        k << d + 4 * a(0) * v(0), cross, cross, 4 * d + 64 * a(1) * v(1);
        check_same(by_energy.tangent_derivative(a, 0.4, v), k, rounding);
        check_same(by_residual.tangent_derivative(a, 0.4, v), k, rounding);
    }
    CHECK(by_energy.energy(Eigen::Vector2d(2, 1), 3) == Approx(0.125 + 8 + 0.25 * 1.75 * 1.75 + 6));
    CHECK(by_energy.model().l == 2.5);
}

TEST_CASE("generic problems: a parameter that enters nonlinearly") {
    const EnergyProblem problem(Mixed{});
    for (const auto& q : configurations)
        for (const double p : {-0.4, 0.9}) {
            const double x = q(0), y = q(1), e = std::exp(x * p), s = std::sin(y), c = std::cos(y);
            const double u = 1 + p * p, vx = direction(0), vy = direction(1);
            const double r = 2 / u, r_p = -4 * p / (u * u), r_pp = (12 * p * p - 4) / (u * u * u);
            const double tolerance = 1e-14;
            check_same(problem.residual(q, p),
                       Eigen::Vector2d(p * e * s + p * p * p * y + r * x, e * c + p * p * p * x), tolerance);
            Eigen::Matrix2d k, dk;
            k << p * p * e * s + r, p * e * c + p * p * p, p * e * c + p * p * p, -e * s;
            const double xxx = p * p * p * e * s, xxy = p * p * e * c, xyy = -p * e * s, yyy = -e * c;
            dk << xxx * vx + xxy * vy, xxy * vx + xyy * vy, xxy * vx + xyy * vy, xyy * vx + yyy * vy;
            check_same(problem.tangent(q, p), k, tolerance);
            check_same(problem.tangent_derivative(q, p, direction), dk, tolerance);
            check_same(problem.parameter_derivative(q, p),
                       Eigen::Vector2d((1 + x * p) * e * s + 3 * p * p * y + r_p * x, x * e * c + 3 * p * p * x),
                       tolerance);
            // dK/dp along the direction
            const double xxp = (2 * p + x * p * p) * e * s + r_p, xyp = (1 + x * p) * e * c + 3 * p * p;
            check_same(problem.parameter_derivative_along(q, p, direction),
                       Eigen::Vector2d(xxp * vx + xyp * vy, xyp * vx - x * e * s * vy), tolerance);
            check_same(problem.second_parameter_derivative(q, p),
                       Eigen::Vector2d((2 * x + x * x * p) * e * s + 6 * p * y + r_pp * x, x * x * e * c + 6 * p * x),
                       tolerance);
        }
}

TEST_CASE("generic problems: an unsymmetric K, by columns") {
    const ResidualProblem problem(Follower{});
    for (const auto& q : configurations) {
        const double p = 0.9, x = q(0), y = q(1), s = std::sin(x), c = std::cos(x);
        const double vx = direction(0), vy = direction(1);
        Eigen::Matrix2d k, dk;
        k << y - p * c, x, p * p * s, 3 * y * y;
        dk << vy + p * s * vx, vx, p * p * c * vx, 6 * y * vy;
        check_same(problem.tangent(q, p), k, 1e-14);
        check_same(problem.tangent_derivative(q, p, direction), dk, 1e-14);
        check_same(problem.parameter_derivative(q, p), Eigen::Vector2d(-s, -2 * p * c), 1e-14);
        check_same(problem.parameter_derivative_along(q, p, direction), Eigen::Vector2d(-c * vx, 2 * p * s * vx),
                   1e-14);
        check_same(problem.second_parameter_derivative(q, p), Eigen::Vector2d(0, -2 * c), 1e-14);
    }
}

TEST_CASE("generic problems pass the check of derivatives, and pass weights and multipliers on") {
    const VectorXd q = Eigen::Vector2d(0.3, -0.8);
    const auto check = [&](const DerivativeErrors& errors) {
        CHECK(errors.tangent < 1e-8);
        CHECK(errors.symmetry < 1e-14);
        CHECK(errors.parameter_derivative < 1e-8);
        CHECK(errors.tangent_derivative < 1e-8);
    };
    check(check_derivatives(EnergyProblem(TrussEnergy{1.2, Strain::engineering}), q, 0.4));
    const EnergyProblem mixed(Mixed{});
    check(check_derivatives(mixed, q, 0.4));
    const ResidualProblem follower(Follower{});
    check(check_derivatives(follower, q, 0.4));
    CHECK(weights(mixed, q, 2) == VectorXd(Eigen::Vector2d(2, 3)));
    CHECK(weights(follower, q, 2) == VectorXd::Ones(2));
    CHECK(multipliers(mixed) == 0);
    CHECK(multipliers(follower) == 1);
}

TEST_CASE("generic problems have the critical points of those written by hand") {
    const auto compare = [](const auto& generic, const auto& by_hand, const VectorXd& near, double p,
                            CriticalKind kind) {
        const auto a = CriticalPointSolver(generic).solve(near, p);
        const auto b = CriticalPointSolver(by_hand).solve(near, p);
        REQUIRE((a && b));
        CHECK(a->kind == kind);
        CHECK(b->kind == kind);
        CHECK(a->p == Approx(b->p).epsilon(1e-13));
        CHECK((a->q - b->q).norm() < 1e-12);
        CHECK((a->null_vector - b->null_vector).norm() < 1e-12);
    };
    const double l = 2.5;
    const ShallowArch arch{l};
    const EnergyProblem by_energy(ArchEnergy{l});
    compare(by_energy, arch, Eigen::Vector2d(1.3, 0.01), 7, CriticalKind::fold);
    compare(by_energy, arch, Eigen::Vector2d(1.52, 0.01), 7, CriticalKind::pitchfork);
    for (const Strain strain : {Strain::green, Strain::engineering}) {
        compare(EnergyProblem(TrussEnergy{3, strain}), von_mises_truss(3, strain), Eigen::Vector2d(0.01, -0.36), 0.16,
                CriticalKind::pitchfork);
        compare(EnergyProblem(TrussEnergy{1.2, strain}), von_mises_truss(1.2, strain), Eigen::Vector2d(0.001, -0.5),
                0.1, CriticalKind::fold);
    }
}
