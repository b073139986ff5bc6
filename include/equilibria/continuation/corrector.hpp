/// \file
/// Newton's method for g(q, p) = 0 at a fixed parameter p: where a branch begins, and for a problem that is to be
/// solved at one parameter alone.
///
/// Each correction is K^-1 g by the bordered system of bordered.hpp, with a round of iterative refinement, so that it
/// exists next to a fold as well. It ends where a correction is small, or no longer shrinks for rounding. Where it
/// fails: at a singular point itself (events.hpp and critical_point.hpp find those), and from a start outside of the
/// region in which the method converges, since no step is damped. Source: Deuflhard, Newton Methods for Nonlinear
/// Problems, section 2.1; Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 3.
#pragma once

#include <Eigen/Core>

#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

/// Why Newton's method ended.
enum class CorrectionStatus {
    converged,
    not_finite,  ///< the tangent is singular, or the iterates ran away
    steps,       ///< as many as allowed
};
/// In words: "converged", "not finite" or "steps".
constexpr const char* to_string(CorrectionStatus status) {
    constexpr const char* names[] = {"converged", "not finite", "steps"};
    return names[static_cast<int>(status)];
}

/// When Newton's method ends.
struct CorrectionOptions {
    int most_steps = 30;       ///< most corrections
    double tolerance = 1e-11;  ///< of the last correction's length, by the problem's weights
    /// A correction that is no longer shorter than the one before counts as the last one where it is below so many
    /// tolerances: rounding.
    double rounding = 1e3;

    /// Throws InvalidArgument.
    void validate() const {
        require(most_steps >= 1, "most_steps", most_steps, "must be at least 1");
        require(tolerance > 0, "tolerance", tolerance, "must be positive");
        require(rounding >= 1, "rounding", rounding, "must be at least 1");
    }
};

/// How Newton's method went.
struct Correction {
    CorrectionStatus status = CorrectionStatus::steps;                        ///< why it ended
    int steps = 0;                                                            ///< corrections that were made
    bool converged() const { return status == CorrectionStatus::converged; }  ///< the last iterate is a solution
};

namespace detail {

/// Newton's method at fixed parameters, with the linear algebra of whoever follows the branch.
template <class Matrix>
class Corrector {
public:
    /// weights: of the length of an increment of q. All must outlive the corrector; the border is where the search for
    /// one starts and ends.
    Corrector(const AnyProblem<Matrix>& problem, BorderedSolver<Matrix>& solver, Border& border,
              const Eigen::VectorXd& weights)
        : problem_(problem), solver_(solver), border_(border), weights_(weights) {}

    /// From q to the solution near it at the parameter p; q is the last iterate, whatever the status.
    Correction operator()(AnyConfiguration& q, double p, const CorrectionOptions& options);

private:
    const AnyProblem<Matrix>& problem_;
    BorderedSolver<Matrix>& solver_;
    Border& border_;
    const Eigen::VectorXd& weights_;
};

}  // namespace detail

/// Of a problem of any type, see below.
template <class Matrix>
Correction correct_at(const AnyProblem<Matrix>& problem, AnyConfiguration& q, double p,
                      const CorrectionOptions& options);

/// Newton's method at the parameter p from q, which is the last iterate afterwards. Throws InvalidArgument where an
/// option is out of range; all else is a status.
template <ContinuationProblem P>
Correction correct_at(const P& problem, Configuration<P>& q, double p, const CorrectionOptions& options = {}) {
    AnyConfiguration at = AnyConfiguration::of(q);
    const Correction y = correct_at(AnyProblemOf<P>(problem), at, p, options);
    q = at.as<Configuration<P>>();
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/detail/corrector_definitions.hpp>
#endif
