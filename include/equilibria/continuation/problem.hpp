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
///     std::vector<Configuration> images(q)            those equivalent to q by symmetries, always as many; none
///     Configuration image(q, k)                       images(q)[k] alone
///     MakeSymmetricFactors symmetric_factors()        what factors a sparse symmetric K; null: SparseLDLT
///     Linearization<Matrix> linearization(q, p)       g, K and dg/dp, where they are quicker together; one by one
/// On a curved space g and K are taken at q itself: derivatives of the energy by increments of q at increment 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/symmetric_factors.hpp>

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

/// What q is: P::Configuration, or Eigen::VectorXd where P has none.
template <class P>
using Configuration = typename detail::ConfigurationOf<P>::type;

/// A direction of (q, p) space: an increment of q, and one of p.
struct Direction {
    Eigen::VectorXd q;  ///< n entries
    double p = 0;       ///< of the parameter
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

/// What factors the problem's tangents, where they are sparse and symmetric; null: SparseLDLT.
template <ContinuationProblem P>
MakeSymmetricFactors symmetric_factors(const P& problem) {
    if constexpr (requires { problem.symmetric_factors(); })
        return problem.symmetric_factors();
    else
        return nullptr;
}

/// g, K and dg/dp at one place.
template <class Matrix>
struct Linearization {
    Eigen::VectorXd residual;              ///< g, n entries
    Matrix tangent;                        ///< K, n x n
    Eigen::VectorXd parameter_derivative;  ///< dg/dp, n entries
};
/// g, K and dg/dp of a problem, by its own `linearization` where it has one.
template <ContinuationProblem P>
Linearization<TangentMatrix<P>> linearization(const P& problem, const Configuration<P>& q, double p) {
    if constexpr (requires { problem.linearization(q, p); })
        return problem.linearization(q, p);
    else
        return {problem.residual(q, p), problem.tangent(q, p), problem.parameter_derivative(q, p)};
}

namespace detail {

/// Whether the values of two sparse matrices are those of the same entries, one by one.
inline bool same_pattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
    return a.isCompressed() && b.isCompressed() && a.rows() == b.rows() && a.cols() == b.cols() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

inline const double third_root_of_rounding = std::cbrt(std::numeric_limits<double>::epsilon());

/// The step of a central difference along v: one that moves by eps^(1/3), by the weights.
inline double difference_step(const Eigen::VectorXd& weights, const Eigen::VectorXd& v) {
    const double size = std::sqrt(v.dot(weights.cwiseProduct(v)));
    return size > 0 ? third_root_of_rounding / size : 1.0;
}
template <ContinuationProblem P>
double difference_step(const P& problem, const Configuration<P>& q, const Eigen::VectorXd& v) {
    return difference_step(weights(problem, q, v.size()), v);
}

}  // namespace detail

/// dK along v by central differences.
template <ContinuationProblem P>
TangentMatrix<P> tangent_difference(const P& problem, const Configuration<P>& q, double p, const Eigen::VectorXd& v) {
    const double h = detail::difference_step(problem, q, v);
    TangentMatrix<P> ahead = problem.tangent(retract(problem, q, h * v), p);
    const TangentMatrix<P> behind = problem.tangent(retract(problem, q, -h * v), p);
    if constexpr (detail::is_sparse<P>) {
        if (detail::same_pattern(ahead, behind))
            ahead.coeffs() -= behind.coeffs();
        else
            ahead -= behind;
    } else {
        ahead -= behind;
    }
    ahead *= 1 / (2 * h);
    return ahead;
}

/// dK along v.
template <ContinuationProblem P>
TangentMatrix<P> tangent_derivative(const P& problem, const Configuration<P>& q, double p, const Eigen::VectorXd& v) {
    if constexpr (requires { problem.tangent_derivative(q, p, v); })
        return problem.tangent_derivative(q, p, v);
    else
        return tangent_difference(problem, q, p, v);
}

/// The derivative of dg/dp along v by central differences.
template <ContinuationProblem P>
Eigen::VectorXd parameter_difference_along(const P& problem, const Configuration<P>& q, double p,
                                           const Eigen::VectorXd& v) {
    const double h = detail::difference_step(problem, q, v);
    const Eigen::VectorXd ahead = problem.parameter_derivative(retract(problem, q, h * v), p);
    return (ahead - problem.parameter_derivative(retract(problem, q, -h * v), p)) / (2 * h);
}

/// The derivative of dg/dp along v: dK/dp v.
template <ContinuationProblem P>
Eigen::VectorXd parameter_derivative_along(const P& problem, const Configuration<P>& q, double p,
                                           const Eigen::VectorXd& v) {
    if constexpr (requires { problem.parameter_derivative_along(q, p, v); })
        return problem.parameter_derivative_along(q, p, v);
    else
        return parameter_difference_along(problem, q, p, v);
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

}  // namespace equilibria
