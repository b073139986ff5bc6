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

#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/problem.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

/// Why Newton's method ended.
enum class CorrectionStatus {
    converged,
    not_finite,  ///< the tangent is singular, or the iterates ran away
    steps,       ///< as many as allowed
};
constexpr const char* to_string(CorrectionStatus status) {
    constexpr const char* names[] = {"converged", "not finite", "steps"};
    return names[static_cast<int>(status)];
}

struct CorrectionOptions {
    int most_steps = 30;
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
    CorrectionStatus status = CorrectionStatus::steps;
    int steps = 0;  ///< corrections that were made
    bool converged() const { return status == CorrectionStatus::converged; }
};

/// Newton's method at fixed parameters, with the linear algebra of whoever follows the branch.
template <ContinuationProblem P>
class Corrector {
public:
    /// weights: of the length of an increment of q. All must outlive the corrector; the border is where the search for
    /// one starts and ends.
    Corrector(const P& problem, BorderedSolver<TangentMatrix<P>>& solver, Border& border,
              const Eigen::VectorXd& weights)
        : problem_(problem), solver_(solver), border_(border), weights_(weights) {}

    /// From q to the solution near it at the parameter p; q is the last iterate, whatever the status.
    Correction operator()(Configuration<P>& q, double p, const CorrectionOptions& options) {
        Correction y;
        double before = std::numeric_limits<double>::infinity();
        while (y.steps < options.most_steps) {
            const Eigen::VectorXd g = problem_.residual(q, p);
            if (!g.allFinite() || !factor(problem_.tangent(q, p))) return ended(y, CorrectionStatus::not_finite);
            const BorderedSolution q0 = solver_.solve(-g, 0), r = solver_.solve(Eigen::VectorXd::Zero(g.size()), 1);
            const Eigen::VectorXd d = q0.x - q0.tau / r.tau * r.x;
            const double size = std::sqrt(d.dot(weights_.cwiseProduct(d)));
            if (!std::isfinite(size)) return ended(y, CorrectionStatus::not_finite);
            q = retract(problem_, q, d);
            ++y.steps;
            if (size <= options.tolerance || (size >= before && size < options.rounding * options.tolerance))
                return ended(y, CorrectionStatus::converged);
            before = size;
        }
        return y;
    }

private:
    bool factor(const TangentMatrix<P>& k) {
        return detail::factor_with_border(solver_, k, weights_, multipliers(problem_), border_);
    }
    static Correction ended(Correction y, CorrectionStatus status) {
        y.status = status;
        return y;
    }

    const P& problem_;
    BorderedSolver<TangentMatrix<P>>& solver_;
    Border& border_;
    const Eigen::VectorXd& weights_;
};

/// Newton's method at the parameter p from q, which is the last iterate afterwards. Throws InvalidArgument where an
/// option is out of range; all else is a status.
template <ContinuationProblem P>
Correction correct_at(const P& problem, Configuration<P>& q, double p, const CorrectionOptions& options = {}) {
    options.validate();
    const Eigen::VectorXd metric = weights(problem, q, problem.residual(q, p).size());
    BorderedSolver<TangentMatrix<P>> solver(symmetric_tangent<P>, multipliers(problem));
    Border border;
    return Corrector<P>(problem, solver, border, metric)(q, p, options);
}

}  // namespace equilibria
