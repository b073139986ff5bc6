// A problem whose type is not known: its functions are the problem's own, defaults where it has none, and points,
// critical points, branches and diagrams come back as they went.
#include <cmath>
#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>

#include "../programs/support/structures.hpp"
#include "support/catch.hpp"

using namespace equilibria;
using support::ShallowArch;

namespace {

using Vector = Eigen::VectorXd;

/// q^2 / 2 + p = 0 on the line of logarithms: the configuration is exp(q), not a vector, and each optional function is
/// there.
struct Everything {
    using Configuration = double;
    static constexpr bool symmetric = false;
    Vector residual(double x, double p) const { return Vector::Constant(1, std::log(x) * std::log(x) / 2 + p); }
    Eigen::SparseMatrix<double> tangent(double x, double) const { return sparse(std::log(x)); }
    Vector parameter_derivative(double, double) const { return Vector::Ones(1); }
    double retract(double x, const Vector& d) const { return x * std::exp(d(0)); }
    Vector difference(double x, double y) const { return Vector::Constant(1, std::log(y / x)); }
    Vector transport(double, const Vector& d, const Vector& v) const { return (1 + d(0)) * v; }
    double rebase(double x, double) const { return 2 * x; }
    Vector weights(double x) const { return Vector::Constant(1, x); }
    Eigen::SparseMatrix<double> tangent_derivative(double, double, const Vector& v) const { return sparse(3 * v(0)); }
    Vector parameter_derivative_along(double, double, const Vector& v) const { return 5 * v; }
    Vector second_parameter_derivative(double, double) const { return Vector::Constant(1, 7); }
    double control(double x, double p) const { return x + p; }
    Direction control_gradient(double x, double) const { return {Vector::Constant(1, x), 1}; }
    int multipliers() const { return 0; }
    std::vector<double> images(double x) const { return {1 / x}; }

private:
    static Eigen::SparseMatrix<double> sparse(double k) {
        Eigen::SparseMatrix<double> y(1, 1);
        y.insert(0, 0) = k;
        return y;
    }
};

void check_equal(const BranchPoint<ShallowArch>& a, const BranchPoint<ShallowArch>& b) {
    CHECK((a.q == b.q && a.p == b.p && a.tangent.q == b.tangent.q && a.tangent.p == b.tangent.p));
    CHECK((a.negative == b.negative && a.sigma == b.sigma && a.mu == b.mu && a.arc_length == b.arc_length));
    CHECK((a.weak_direction == b.weak_direction && a.proposed_step == b.proposed_step && a.border == b.border));
}

}  // namespace

TEST_CASE("the functions of a problem of any type are its own") {
    const Everything problem;
    const AnyProblem<Eigen::SparseMatrix<double>> any(problem);
    const auto& has = any.properties();
    CHECK((has.control && has.transport && has.multipliers && has.tangent_derivative));
    CHECK((has.parameter_derivative_along && has.second_parameter_derivative && !has.symmetric));
    const double x = 1.5, p = 0.25;
    const auto q = AnyConfiguration::of(x), near = AnyConfiguration::of(1.7);
    const Vector v = Vector::Constant(1, 0.3);
    CHECK(any.residual(q, p) == problem.residual(x, p));
    CHECK(any.tangent(q, p).coeff(0, 0) == std::log(x));
    CHECK(any.parameter_derivative(q, p)(0) == 1);
    CHECK(any.retract(q, v).as<double>() == problem.retract(x, v));
    CHECK(any.difference(q, near) == problem.difference(x, 1.7));
    CHECK(any.transport(q, v, v)(0) == Approx(1.3 * 0.3).epsilon(1e-15));
    CHECK(any.rebase(q, p).as<double>() == 3);
    CHECK(any.weights(q, 1)(0) == x);
    CHECK(any.tangent_derivative(q, p, v).coeff(0, 0) == 3 * v(0));
    CHECK(any.parameter_derivative_along(q, p, v)(0) == 5 * v(0));
    CHECK(any.second_parameter_derivative(q, p)(0) == 7);
    CHECK(any.control(q, p) == x + p);
    CHECK(any.control_gradient(q, p, 1).q(0) == x);
    CHECK(any.images(q).at(0).as<double>() == 1 / x);
}

TEST_CASE("functions that a problem has not are defaults") {
    const ShallowArch arch{2.5};
    const AnyProblem<Eigen::MatrixXd> any(arch);
    const auto& has = any.properties();
    CHECK(has.symmetric);
    CHECK_FALSE((has.control || has.transport || has.multipliers || has.second_parameter_derivative));
    const Vector x = Eigen::Vector2d(1.2, 0.4), d = Eigen::Vector2d(0.1, -0.2), v = Eigen::Vector2d(-0.5, 0.7);
    const auto q = AnyConfiguration::of(x);
    CHECK(any.multipliers() == 0);
    CHECK(any.retract(q, d).as<Vector>() == x + d);
    CHECK(any.difference(q, any.retract(q, d)).isApprox(d, 1e-14));
    CHECK(any.transport(q, d, v) == v);
    CHECK(any.rebase(q, 1).as<Vector>() == x);
    CHECK(any.weights(q, 2) == Vector::Ones(2));
    CHECK(any.images(q).empty());
    CHECK(any.tangent_derivative(q, 1, v) == tangent_derivative(arch, x, 1, v));
    CHECK(any.second_parameter_derivative(q, 1) == second_parameter_derivative(arch, x, 1));
}

TEST_CASE("a branch is the same through its type and without it") {
    const ShallowArch arch{2.5};
    const Vector start = Eigen::Vector2d(2.5, 0);
    const ContinuationOptions options{.range = {-1, 8}};
    const auto branch = continue_branch(arch, start, 0, 1, options);
    const AnyProblem<Eigen::MatrixXd> any(arch);
    const auto again = typed<ShallowArch>(continue_branch(any, AnyConfiguration::of(start), 0.0, 1, options, {}));
    REQUIRE(branch.points.size() > 5);
    REQUIRE(branch.events.size() > 0);
    REQUIRE(again.points.size() == branch.points.size());
    REQUIRE(again.events.size() == branch.events.size());
    for (std::size_t k = 0; k < branch.points.size(); ++k) check_equal(branch.points[k], again.points[k]);
    const auto there_and_back = typed<ShallowArch>(erased(branch));
    REQUIRE(there_and_back.points.size() == branch.points.size());
    for (std::size_t k = 0; k < branch.points.size(); ++k) check_equal(branch.points[k], there_and_back.points[k]);
    for (std::size_t k = 0; k < branch.events.size(); ++k) {
        const auto &a = branch.events[k], &b = there_and_back.events[k];
        CHECK((a.step == b.step && a.point.kind == b.point.kind && a.point.q == b.point.q && a.point.p == b.point.p));
        CHECK((a.point.null_vector == b.point.null_vector && a.point.curvature == b.point.curvature));
    }
    CHECK(there_and_back.end == branch.end);
}
