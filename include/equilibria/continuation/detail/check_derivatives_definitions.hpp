/// \file
/// See continuation/check_derivatives.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/continuation/factorization/redundant_constraints.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {

/// The residual, the tangent and the parameter derivative: finite, and of sizes that fit.
template <class Matrix>
void require_shapes(const Eigen::VectorXd& g, const Matrix& k, const Eigen::VectorXd& g_p) {
    require(g.allFinite(), "problem.residual", g.hasNaN() ? "NaN" : "infinite", "must be finite at the start");
    require(k.rows() == g.size() && k.cols() == g.size(), "problem.tangent",
            std::to_string(k.rows()) + " x " + std::to_string(k.cols()),
            "must be square, of the residual's size " + std::to_string(g.size()));
    require(g_p.size() == g.size(), "problem.parameter_derivative", std::to_string(g_p.size()),
            "must have the residual's size " + std::to_string(g.size()));
    require(g_p.allFinite(), "problem.parameter_derivative", "NaN or infinite", "must be finite at the start");
}

/// The gradients of the constraints, the rows of K of the multipliers.
template <class Matrix>
void require_independent_constraints(const AnyProblem<Matrix>& problem, const Matrix& k, const AnyConfiguration& q) {
    const Eigen::Index m = problem.multipliers();
    require(m >= 0 && m < k.rows(), "problem.multipliers", m,
            "must be 0 to " + std::to_string(k.rows() - 1) + ", below the number of unknowns");
    const ConstraintGradients constraints(k, static_cast<int>(m), problem.weights(q, k.rows()));
    const std::size_t redundant =
        constraints.count() <= 2000 ? constraints.redundant().size() : constraints.redundant_count();
    require(redundant == 0, "problem.multipliers", m,
            "must be the number of independent constraints: redundant ones, or a dead point, at the start, where "
            "the rank is " +
                std::to_string(static_cast<std::size_t>(m) - redundant));
}

}  // namespace detail

template <class Matrix>
DerivativeErrors check_derivatives(const AnyProblem<Matrix>& problem, const AnyConfiguration& q, double p,
                                   double tolerance) {
    const ProblemProperties& has = problem.properties();
    require(std::isfinite(p), "p", p, "must be finite");
    const Eigen::VectorXd g = problem.residual(q, p);
    const Matrix k = problem.tangent(q, p);
    const Eigen::VectorXd g_p = problem.parameter_derivative(q, p);
    detail::require_shapes(g, k, g_p);
    const Eigen::VectorXd v = detail::generic_vector(g.size());
    const auto error = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b, double least) {
        const double size = std::max({a.norm(), b.norm(), least});
        const double difference = (a - b).norm();
        return difference == 0 ? 0.0 : difference / size;  // NaN stays NaN
    };
    const double h = detail::difference_step(problem.weights(q, v.size()), v);
    const AnyConfiguration ahead = problem.retract(q, h * v), behind = problem.retract(q, -h * v);
    DerivativeErrors y;
    const Eigen::VectorXd kv = k * v;
    const double rounding = 1e-10 * (1 + g.norm()) / tolerance;
    if (has.transport) {
        // g is by increments at the configuration that it is taken at: w . g belongs to transported w
        Eigen::Vector3d exact, difference;
        for (int n = 0; n < 3; ++n) {
            const Eigen::VectorXd w = detail::generic_vector(g.size(), n + 1);
            exact(n) = w.dot(kv);
            difference(n) = (problem.residual(ahead, p).dot(problem.transport(q, Eigen::VectorXd(h * v), w)) -
                             problem.residual(behind, p).dot(problem.transport(q, Eigen::VectorXd(-h * v), w))) /
                            (2 * h);
        }
        y.tangent = error(exact, difference, std::max(rounding, 0.1 * kv.norm()));
    } else {
        y.tangent = error(kv, (problem.residual(ahead, p) - problem.residual(behind, p)) / (2 * h), rounding);
    }
    if (has.symmetric) y.symmetry = error(kv, k.transpose() * v, rounding);
    const double hp = detail::third_root_of_rounding * std::max(1e-3, std::abs(p));
    y.parameter_derivative =
        error(g_p, (problem.residual(q, p + hp) - problem.residual(q, p - hp)) / (2 * hp), rounding);
    if (has.tangent_derivative) {
        const Eigen::VectorXd w = v.reverse();
        const Eigen::VectorXd exact = problem.tangent_derivative(q, p, v) * w;
        const Eigen::VectorXd difference = problem.tangent(ahead, p) * w - problem.tangent(behind, p) * w;
        y.tangent_derivative = error(exact, difference / (2 * h), 1e-10 * (1 + kv.norm()) / tolerance);
    }
    if (has.parameter_derivative_along) {
        const Eigen::VectorXd difference =
            (problem.parameter_derivative(ahead, p) - problem.parameter_derivative(behind, p)) / (2 * h);
        y.parameter_derivative_along =
            error(problem.parameter_derivative_along(q, p, v), difference, 1e-10 * (1 + g_p.norm()) / tolerance);
    }
    if (has.second_parameter_derivative) {
        const Eigen::VectorXd difference =
            (problem.parameter_derivative(q, p + hp) - problem.parameter_derivative(q, p - hp)) / (2 * hp);
        y.second_parameter_derivative =
            error(problem.second_parameter_derivative(q, p), difference, 1e-12 * (1 + g_p.norm()) / hp / tolerance);
    }
    const auto check = [&](const char* function, double value, const char* what) {
        require(value <= tolerance, function, to_text(value) + " relative error", what);
    };
    check("problem.tangent", y.tangent, "must be the derivative of the residual by q");
    check("problem.tangent", y.symmetry,
          "must be symmetric, or the problem must say static constexpr bool symmetric = false");
    check("problem.parameter_derivative", y.parameter_derivative, "must be the derivative of the residual by p");
    check("problem.tangent_derivative", y.tangent_derivative, "must be the derivative of the tangent along v");
    check("problem.parameter_derivative_along", y.parameter_derivative_along,
          "must be the derivative of parameter_derivative along v");
    check("problem.second_parameter_derivative", y.second_parameter_derivative,
          "must be the derivative of parameter_derivative by p");
    if (has.multipliers) detail::require_independent_constraints(problem, k, q);
    return y;
}

}  // namespace equilibria
