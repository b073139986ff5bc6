/// \file
/// What can be continued: the equilibria g(q, p) = 0 of a structure or a mechanism in one parameter p, n equations in n
/// unknowns. A flat problem, whose configurations are vectors, writes three functions:
///
///     struct Problem {
///         Eigen::VectorXd residual(const Eigen::VectorXd& q, double p) const;               // g
///         Eigen::MatrixXd tangent(const Eigen::VectorXd& q, double p) const;                // K = dg/dq; or sparse
///         Eigen::VectorXd parameter_derivative(const Eigen::VectorXd& q, double p) const;   // dg/dp
///     };
///
/// Optional, each with a default:
///     using Configuration = ...;                      what q is, where it is not a vector
///     static constexpr bool symmetric = false;        K is symmetric (true) where g is the gradient of an energy
///     Configuration retract(q, increment)             q (+) increment; q + increment
///     Eigen::VectorXd transport(q, increment, v)      the tangent vector v at q, seen from retract(q, increment); v
///     Eigen::VectorXd difference(q, near)             the increment from q to `near`: the inverse of retract; near - q
///     Configuration rebase(q, p)                      q written anew after a step, as charts need it; q
///     Eigen::VectorXd weights(q)                      of |v|^2 = sum w_i v_i^2, positive; ones
///     Matrix tangent_derivative(q, p, v)              dK along v; central differences of K, error O(eps^(2/3))
///     Eigen::VectorXd parameter_derivative_along(q, p, v)   d(dg/dp) along v; central differences
///     Eigen::VectorXd second_parameter_derivative(q, p)     d2g/dp2; central differences
///     double control(q, p)                            what StepConstraint::scalar controls
///     Direction control_gradient(q, p)                its derivatives; central differences, 2 n + 2 evaluations
///     int multipliers()                               how many unknowns, the last ones, are Lagrange multipliers; 0
/// On a curved space g and K are taken at q itself: derivatives of the energy by increments of q at increment 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/continuation/factorization/redundant_constraints.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {
template <class P>
struct ConfigurationOf {
    using type = Eigen::VectorXd;
};
template <class P>
requires requires { typename P::Configuration; }
struct ConfigurationOf<P> {
    using type = typename P::Configuration;
};
}  // namespace detail

template <class P>
using Configuration = typename detail::ConfigurationOf<P>::type;

/// A direction of (q, p) space: an increment of q, and one of p.
struct Direction {
    Eigen::VectorXd q;
    double p = 0;
};

/// A problem that can be continued; see the file.
template <class P>
concept ContinuationProblem = requires(const P& problem, const Configuration<P>& q, double p) {
    { problem.residual(q, p) } -> std::convertible_to<Eigen::VectorXd>;
    problem.tangent(q, p);
    { problem.parameter_derivative(q, p) } -> std::convertible_to<Eigen::VectorXd>;
};

namespace detail {

template <ContinuationProblem P>
inline constexpr bool is_sparse = std::is_same_v<typename std::remove_cvref_t<decltype(std::declval<const P&>().tangent(
                                                     std::declval<const Configuration<P>&>(), 0.0))>::StorageKind,
                                                 Eigen::Sparse>;

template <class P>
constexpr bool promised_symmetric() {
    if constexpr (requires { P::symmetric; })
        return P::symmetric;
    else
        return true;
}

}  // namespace detail

/// Eigen::MatrixXd, or Eigen::SparseMatrix<double> where the tangent is sparse.
template <ContinuationProblem P>
using TangentMatrix = std::conditional_t<detail::is_sparse<P>, Eigen::SparseMatrix<double>, Eigen::MatrixXd>;

/// Whether K is symmetric: so unless the problem says `static constexpr bool symmetric = false`.
template <ContinuationProblem P>
inline constexpr bool symmetric_tangent = detail::promised_symmetric<P>();

/// q (+) increment.
template <ContinuationProblem P>
Configuration<P> retract(const P& problem, const Configuration<P>& q, const Eigen::VectorXd& increment) {
    if constexpr (requires { problem.retract(q, increment); })
        return problem.retract(q, increment);
    else
        return q + increment;
}

/// The increment that leads from q to the configuration `near`.
template <ContinuationProblem P>
Eigen::VectorXd difference(const P& problem, const Configuration<P>& q, const Configuration<P>& near) {
    if constexpr (requires { problem.difference(q, near); })
        return problem.difference(q, near);
    else
        return near - q;
}

/// The tangent vector v at q, in the coordinates of increments at q (+) increment.
template <ContinuationProblem P>
Eigen::VectorXd transport(const P& problem, const Configuration<P>& q, const Eigen::VectorXd& increment,
                          const Eigen::VectorXd& v) {
    if constexpr (requires { problem.transport(q, increment, v); })
        return problem.transport(q, increment, v);
    else
        return v;
}

/// The same configuration, written anew after a step.
template <ContinuationProblem P>
Configuration<P> rebase(const P& problem, Configuration<P> q, double p) {
    if constexpr (requires { problem.rebase(q, p); })
        return problem.rebase(q, p);
    else
        return q;
}

/// The weights of |v|^2 = sum w_i v_i^2 for increments of q.
template <ContinuationProblem P>
Eigen::VectorXd weights(const P& problem, const Configuration<P>& q, Eigen::Index size) {
    if constexpr (requires { problem.weights(q); })
        return problem.weights(q);
    else
        return Eigen::VectorXd::Ones(size);
}

/// How many of the last unknowns are Lagrange multipliers.
template <ContinuationProblem P>
int multipliers(const P& problem) {
    if constexpr (requires { problem.multipliers(); })
        return problem.multipliers();
    else
        return 0;
}

namespace detail {

inline const double third_root_of_rounding = std::cbrt(std::numeric_limits<double>::epsilon());

/// The step of a central difference along v: one that moves by eps^(1/3), by the problem's weights.
template <ContinuationProblem P>
double difference_step(const P& problem, const Configuration<P>& q, const Eigen::VectorXd& v) {
    const double size = std::sqrt(v.dot(weights(problem, q, v.size()).cwiseProduct(v)));
    return size > 0 ? third_root_of_rounding / size : 1.0;
}

}  // namespace detail

/// dK along v.
template <ContinuationProblem P>
TangentMatrix<P> tangent_derivative(const P& problem, const Configuration<P>& q, double p, const Eigen::VectorXd& v) {
    if constexpr (requires { problem.tangent_derivative(q, p, v); }) {
        return problem.tangent_derivative(q, p, v);
    } else {
        const double h = detail::difference_step(problem, q, v);
        TangentMatrix<P> ahead = problem.tangent(retract(problem, q, h * v), p);
        const TangentMatrix<P> behind = problem.tangent(retract(problem, q, -h * v), p);
        ahead -= behind;
        ahead *= 1 / (2 * h);
        return ahead;
    }
}

/// The derivative of dg/dp along v: dK/dp v.
template <ContinuationProblem P>
Eigen::VectorXd parameter_derivative_along(const P& problem, const Configuration<P>& q, double p,
                                           const Eigen::VectorXd& v) {
    if constexpr (requires { problem.parameter_derivative_along(q, p, v); }) {
        return problem.parameter_derivative_along(q, p, v);
    } else {
        const double h = detail::difference_step(problem, q, v);
        const Eigen::VectorXd ahead = problem.parameter_derivative(retract(problem, q, h * v), p);
        return (ahead - problem.parameter_derivative(retract(problem, q, -h * v), p)) / (2 * h);
    }
}

/// Whether a problem has a scalar of its own to be controlled by.
template <class P>
concept Controlled = ContinuationProblem<P> && requires(const P& problem, const Configuration<P>& q, double p) {
    { problem.control(q, p) } -> std::convertible_to<double>;
};

/// The derivatives of problem.control.
template <Controlled P>
Direction control_gradient(const P& problem, const Configuration<P>& q, double p, Eigen::Index size) {
    if constexpr (requires { problem.control_gradient(q, p); }) {
        return problem.control_gradient(q, p);
    } else {
        const double h = detail::third_root_of_rounding, hp = h * std::max(1e-3, std::abs(p));
        Direction y{Eigen::VectorXd(size), (problem.control(q, p + hp) - problem.control(q, p - hp)) / (2 * hp)};
        for (Eigen::Index i = 0; i < size; ++i) {
            const Eigen::VectorXd e = h * Eigen::VectorXd::Unit(size, i);
            y.q(i) = (problem.control(retract(problem, q, e), p) -
                      problem.control(retract(problem, q, Eigen::VectorXd(-e)), p)) /
                     (2 * h);
        }
        return y;
    }
}

/// d2g/dp2.
template <ContinuationProblem P>
Eigen::VectorXd second_parameter_derivative(const P& problem, const Configuration<P>& q, double p) {
    if constexpr (requires { problem.second_parameter_derivative(q, p); }) {
        return problem.second_parameter_derivative(q, p);
    } else {
        const double h = detail::third_root_of_rounding * std::max(1e-3, std::abs(p));
        const Eigen::VectorXd ahead = problem.parameter_derivative(q, p + h);
        return (ahead - problem.parameter_derivative(q, p - h)) / (2 * h);
    }
}

/// How far a problem's functions are from what they promise, along one direction; see check_derivatives.
struct DerivativeErrors {
    double tangent = 0;               ///< |K v - difference of g| over their size
    double symmetry = 0;              ///< |K v - K^T v| over |K v|; 0 where no symmetry is promised
    double parameter_derivative = 0;  ///< of dg/dp
    // 0 where the problem gives none
    double tangent_derivative = 0;           ///< of dK along v
    double parameter_derivative_along = 0;   ///< of d(dg/dp) along v
    double second_parameter_derivative = 0;  ///< of d2g/dp2
};

namespace detail {

/// The residual, the tangent and the parameter derivative: finite, and of sizes that fit.
template <ContinuationProblem P>
void require_shapes(const Eigen::VectorXd& g, const TangentMatrix<P>& k, const Eigen::VectorXd& g_p) {
    require(g.allFinite(), "problem.residual", g.hasNaN() ? "NaN" : "infinite", "must be finite at the start");
    require(k.rows() == g.size() && k.cols() == g.size(), "problem.tangent",
            std::to_string(k.rows()) + " x " + std::to_string(k.cols()),
            "must be square, of the residual's size " + std::to_string(g.size()));
    require(g_p.size() == g.size(), "problem.parameter_derivative", std::to_string(g_p.size()),
            "must have the residual's size " + std::to_string(g.size()));
    require(g_p.allFinite(), "problem.parameter_derivative", "NaN or infinite", "must be finite at the start");
}

/// The gradients of the constraints, the rows of K of the multipliers.
template <ContinuationProblem P>
void require_independent_constraints(const P& problem, const TangentMatrix<P>& k, const Configuration<P>& q) {
    const Eigen::Index m = problem.multipliers();
    require(m >= 0 && m < k.rows(), "problem.multipliers", m,
            "must be 0 to " + std::to_string(k.rows() - 1) + ", below the number of unknowns");
    const ConstraintGradients constraints(k, static_cast<int>(m), weights(problem, q, k.rows()));
    const std::size_t redundant =
        constraints.count() <= 2000 ? constraints.redundant().size() : constraints.redundant_count();
    require(redundant == 0, "problem.multipliers", m,
            "must be the number of independent constraints: redundant ones, or a dead point, at the start, where "
            "the rank is " +
                std::to_string(static_cast<std::size_t>(m) - redundant));
}

}  // namespace detail

/// Compares the derivatives of a problem with central differences along a fixed direction without zeros. Throws
/// InvalidArgument that names the function where a value is not finite, a size does not fit, an error is above
/// `tolerance` or constraints are redundant: their gradients, the rows of K of the multipliers, dependent at q.
template <ContinuationProblem P>
DerivativeErrors check_derivatives(const P& problem, const Configuration<P>& q, double p, double tolerance = 1e-4) {
    require(std::isfinite(p), "p", p, "must be finite");
    const Eigen::VectorXd g = problem.residual(q, p);
    const TangentMatrix<P> k = problem.tangent(q, p);
    const Eigen::VectorXd g_p = problem.parameter_derivative(q, p);
    detail::require_shapes<P>(g, k, g_p);
    const Eigen::VectorXd v = detail::generic_vector(g.size());
    const auto error = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b, double least) {
        const double size = std::max({a.norm(), b.norm(), least});
        const double difference = (a - b).norm();
        return difference == 0 ? 0.0 : difference / size;  // NaN stays NaN
    };
    const double h = detail::difference_step(problem, q, v);
    const Configuration<P> ahead = retract(problem, q, h * v), behind = retract(problem, q, -h * v);
    DerivativeErrors y;
    const Eigen::VectorXd kv = k * v;
    const double rounding = 1e-10 * (1 + g.norm()) / tolerance;
    if constexpr (requires { problem.transport(q, v, v); }) {
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
    if (symmetric_tangent<P>) y.symmetry = error(kv, k.transpose() * v, rounding);
    const double hp = detail::third_root_of_rounding * std::max(1e-3, std::abs(p));
    y.parameter_derivative =
        error(g_p, (problem.residual(q, p + hp) - problem.residual(q, p - hp)) / (2 * hp), rounding);
    if constexpr (requires { problem.tangent_derivative(q, p, v); }) {
        const Eigen::VectorXd w = v.reverse();
        const Eigen::VectorXd exact = TangentMatrix<P>(problem.tangent_derivative(q, p, v)) * w;
        const Eigen::VectorXd difference =
            TangentMatrix<P>(problem.tangent(ahead, p)) * w - TangentMatrix<P>(problem.tangent(behind, p)) * w;
        y.tangent_derivative = error(exact, difference / (2 * h), 1e-10 * (1 + kv.norm()) / tolerance);
    }
    if constexpr (requires { problem.parameter_derivative_along(q, p, v); }) {
        const Eigen::VectorXd difference =
            (problem.parameter_derivative(ahead, p) - problem.parameter_derivative(behind, p)) / (2 * h);
        y.parameter_derivative_along =
            error(problem.parameter_derivative_along(q, p, v), difference, 1e-10 * (1 + g_p.norm()) / tolerance);
    }
    if constexpr (requires { problem.second_parameter_derivative(q, p); }) {
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
    if constexpr (requires { problem.multipliers(); }) detail::require_independent_constraints(problem, k, q);
    return y;
}

}  // namespace equilibria
