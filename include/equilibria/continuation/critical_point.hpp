/// \file
/// Exact critical points: Newton's method on the extended systems of Cardona and Huespe (1999), equations (28) and
/// (29),
///
///     limit point        [ g ; K phi ; phi_i - 1 ] = 0                                 unknowns q, phi, p
///     bifurcation point  [ g + gamma e_i ; K phi ; phi_i - 1 ; phi^T dg/dp ] = 0        unknowns q, phi, p, gamma
///
/// in their minimally augmented form, sigma = 0 and mu = 0 of bordered.hpp, by block elimination with one factorisation
/// a step. The first is regular at quadratic folds, the second at simple bifurcations, where its gamma is 0. Which of
/// them is solved is decided by |phi^T dg/dp| / (|phi| |dg/dp|), which no scaling changes; where that
/// fails, by the length of their steps.
///
/// With w, K w = -dg/dp, w_i = 0, the bifurcation equation a x^2 + 2 b x y + c y^2 = 0 has the tangents x phi + y w, y
/// (of p); phi is the left null vector where K is not symmetric.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/continuation/critical_kind.hpp>
#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

/// How critical points are solved for.
struct CriticalPointOptions {
    int most_iterations = 30;         ///< of Newton's method on one system
    double tolerance = 1e-13;         ///< of the last step, over the size of the unknowns and of p
    double bifurcation_start = 1e-2;  ///< the second system is tried where |phi^T dg/dp| / (|phi| |dg/dp|) is below
    double bifurcation = 1e-7;        ///< and its point is a bifurcation where the quotient is below this
    /// Of one step, as it is measured in CriticalIteration: Newton's method that makes a longer one is given up.
    double reach = std::numeric_limits<double>::infinity();

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(most_iterations >= 1, "most_iterations", most_iterations, "must be at least 1");
        require(tolerance > 0, "tolerance", tolerance, "must be positive");
        require(bifurcation_start >= 0, "bifurcation_start", bifurcation_start, "must be 0 or positive");
        require(bifurcation >= 0, "bifurcation", bifurcation, "must be 0 or positive");
        require(reach > 0, "reach", reach, "must be positive");
    }
};

/// One step of Newton's method on an extended system.
struct CriticalIteration {
    double step;              ///< its length: unknowns by the problem's weights, and p over its size
    double sigma;             ///< of bordered.hpp at the iterate, 0 at a singular K
    double residual;          ///< |g|, the largest entry
    bool bifurcation_system;  ///< whether the second system was being solved
};

/// What is known of a critical point, whatever its configuration is.
struct CriticalPointEvidence {
    CriticalKind kind = CriticalKind::fold;  ///< what the point is
    double p = 0;                            ///< the parameter
    Eigen::VectorXd null_vector;             ///< phi, its largest entry 1
    Eigen::VectorXd left_null_vector;        ///< the same where K is symmetric
    Eigen::MatrixXd null_vectors;            ///< of multiple points: a basis, a column each
    Eigen::VectorXd slope;                   ///< w: K w = -dg/dp; of bifurcations
    int nullity = 1;                         ///< null vectors of K: 1, or 2 and more
    double residual = 0;                     ///< |g|, the largest entry
    double sigma = 0;                        ///< left of the singularity
    double transversality = 0;               ///< |phi^T dg/dp| / (|phi| |dg/dp|): 0 at bifurcations
    double unfolding = 0;                    ///< gamma
    double a = 0;                            ///< coefficient of x^2; of folds too
    double b = 0;                            ///< half the coefficient of x y
    double c = 0;                            ///< coefficient of y^2
    double curvature = 0;                    ///< p = p_c + curvature x^2 / 2 along phi: of pitchforks and folds
    double curvature_error = 0;              ///< how far apart two orders of differences have that of a pitchfork
    std::vector<Direction> tangents;         ///< of the branches through the point, up to their lengths
    std::vector<CriticalIteration> history;  ///< every step of Newton's method
    std::optional<int> negative_before;      ///< eigenvalues below 0 before it, on the branch on which it was met
    std::optional<int> negative_after;       ///< and behind it

    int iterations() const { return static_cast<int>(history.size()); }  ///< of Newton's method
};

/// A critical point, with its configuration.
template <class P>
struct CriticalPoint : CriticalPointEvidence {
    Configuration<P> q{};  ///< the configuration
};

/// The same point, its configuration of any type, and back.
/// \{
template <ContinuationProblem P>
CriticalPoint<Erased> erased(const CriticalPoint<P>& point) {
    return {point, AnyConfiguration::of(point.q)};
}
template <ContinuationProblem P>
CriticalPoint<P> typed(const CriticalPoint<Erased>& point) {
    return {point, point.q.as<Configuration<P>>()};
}
/// \}

/// Of a problem of any type, see CriticalPointSolver. solver: of this problem's tangents, whose factors are no longer
/// needed; null: one of its own, which analyses their pattern first. weak: nearly the null vector; empty where it is
/// not known.
template <class Matrix>
std::optional<CriticalPoint<Erased>> critical_point_near(const AnyProblem<Matrix>& problem, const AnyConfiguration& q,
                                                         double p, const CriticalPointOptions& options, Border border,
                                                         BorderedSolver<Matrix>* solver = nullptr,
                                                         const Eigen::VectorXd& weak = {}, bool fold = false);

/// Newton's method on both systems, and what the converged point is.
template <ContinuationProblem P>
class CriticalPointSolver {
public:
    using Matrix = TangentMatrix<P>;  ///< of K, dense or sparse

    /// The problem must outlive the solver. Throws InvalidArgument for an option out of range.
    explicit CriticalPointSolver(const P& problem, const CriticalPointOptions& options = {})
        : problem_(problem), options_(options) {
        options_.validate();
    }
    explicit CriticalPointSolver(P&&, const CriticalPointOptions& = {}) = delete;

    /// The critical point next to (q, p); nothing where neither system converges. border: with which the search for the
    /// weakest direction begins.
    std::optional<CriticalPoint<P>> solve(const Configuration<P>& q, double p, Border border = {}) const {
        const auto found = critical_point_near(problem_, AnyConfiguration::of(q), p, options_, border);
        if (!found) return std::nullopt;
        return typed<P>(*found);
    }

private:
    AnyProblem<Matrix> problem_;
    CriticalPointOptions options_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/critical_point_definitions.hpp>
#endif
