/// \file
/// A converged point of a branch.
#pragma once

#include <optional>

#include <Eigen/Core>

#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/eigenvalue_counts.hpp>
#include <equilibria/continuation/problem.hpp>

namespace equilibria {

/// What is known of a converged point of a branch, whatever its configuration is.
struct BranchPointEvidence {
    double p = 0;                    ///< the parameter
    Direction tangent;               ///< of length 1, along the direction of travel
    Eigen::VectorXd weak_direction;  ///< of length 1: nearly the eigenvector of the smallest eigenvalue
    Eigen::VectorXd weak_left;       ///< the same of K^T where K is not symmetric, else empty
    double weak_eigenvalue = 0;      ///< of K against the weights
    /// Further weak directions of a sparse symmetric K, a column each; see WeakDirection::next.
    Eigen::MatrixXd next_directions;
    Eigen::VectorXd next_eigenvalues;  ///< the eigenvalues of these, Rayleigh quotients
    /// Of the weak eigenvalue and the next ones along the branch, once somebody has asked for them: the search for
    /// events does.
    mutable Eigen::VectorXd weak_slopes;
    /// Negative real eigenvalues of an unsymmetric K, -1 where it has too many unknowns; filled likewise.
    mutable std::optional<int> negative_real;
    double sigma = 0;              ///< test function: 0 at every singular point, see bordered.hpp
    double mu = 0;                 ///< test function: 0 at bifurcations alone
    Border border;                 ///< where the weak directions are large
    std::optional<int> negative;   ///< negative eigenvalues of K; under constraints, of the energy on their set
    EigenvalueCounts eigenvalues;  ///< of a dense symmetric K; else empty
    int determinant_sign = 1;      ///< of K
    double residual = 0;           ///< |g|, the largest entry
    int corrections = 0;           ///< of the corrector
    double step = 0;               ///< the length that led here, 0 at the start
    double turning = 0;            ///< the angle between the last tangent and this one, radians
    double proposed_step = 0;      ///< for the next one
    double arc_length = 0;         ///< from the start

    /// The weak direction and the next ones, a column each.
    Eigen::MatrixXd weak_directions() const {
        Eigen::MatrixXd y(weak_direction.size(), 1 + next_directions.cols());
        y.col(0) = weak_direction;
        if (next_directions.cols() > 0) y.rightCols(next_directions.cols()) = next_directions;
        return y;
    }

    /// Stable by energy: no negative eigenvalue; nothing where the inertia is not known.
    std::optional<bool> stable() const {
        if (!negative) return std::nullopt;
        return *negative == 0;
    }
};

/// A converged point of a branch.
template <class P>
struct BranchPoint : BranchPointEvidence {
    Configuration<P> q{};  ///< the configuration
};

/// The same point, its configuration of any type, and back.
/// \{
template <ContinuationProblem P>
BranchPoint<Erased> erased(const BranchPoint<P>& at) {
    return {at, AnyConfiguration::of(at.q)};
}
template <ContinuationProblem P>
BranchPoint<P> typed(const BranchPoint<Erased>& at) {
    return {at, at.q.as<Configuration<P>>()};
}
template <ContinuationProblem P>
std::optional<BranchPoint<P>> typed(const std::optional<BranchPoint<Erased>>& at) {
    if (!at) return std::nullopt;
    return typed<P>(*at);
}
/// \}

}  // namespace equilibria
