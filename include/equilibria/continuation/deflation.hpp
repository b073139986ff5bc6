/// \file
/// Deflated Newton: an equilibrium at a fixed parameter other than those that are known, from the same guesses. g is
/// multiplied by prod_k (1 / |q - q_k|^power + shift), which keeps its other zeros and removes q_k. With the step d of
/// Newton's method on g, that on the deflated system is d / (1 - d . grad log m), m the factor.
/// Source: Farrell, Birkisson and Funke, Deflation techniques for finding distinct solutions of nonlinear partial
/// differential equations, SIAM J. Sci. Comput. 37 (2015).
#pragma once

#include <optional>
#include <vector>

#include <equilibria/continuation/branch_stepper.hpp>

namespace equilibria {

struct DeflationOptions {
    double power = 2;
    double shift = 1;
    int most_iterations = 100;
    double tolerance = 1e-11;  ///< of the last step, over the size of the unknowns
    /// Of Newton's method, by the problem's weights.
    double longest_step = std::numeric_limits<double>::infinity();

    void validate() const {
        require(power >= 1, "power", power, "must be at least 1");
        require(shift >= 0, "shift", shift, "must be 0 or positive");
        require(most_iterations >= 1, "most_iterations", most_iterations, "must be at least 1");
        require(tolerance > 0, "tolerance", tolerance, "must be positive");
        require(longest_step > 0, "longest_step", longest_step, "must be positive");
    }
};

/// An equilibrium at the parameter p other than `known`; nothing where Newton's method does not converge from the
/// guess, which happens where there is none as well. Distances are by the problem's weights.
template <ContinuationProblem P>
std::optional<Configuration<P>> deflated_newton(const P& problem, double p, Configuration<P> guess,
                                                const std::vector<Configuration<P>>& known,
                                                const DeflationOptions& options = {}) {
    options.validate();
    const Eigen::Index n = problem.residual(guess, p).size();
    const Eigen::VectorXd w = weights(problem, guess, n), zero = Eigen::VectorXd::Zero(n);
    BorderedSolver<TangentMatrix<P>> solver(symmetric_tangent<P>, equilibria::multipliers(problem));
    Border border;
    Configuration<P> q = std::move(guess);
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < options.most_iterations; ++k) {
        const Eigen::VectorXd g = problem.residual(q, p);
        if (!g.allFinite()) return std::nullopt;
        const TangentMatrix<P> tangent = problem.tangent(q, p);
        if (!factor_at_weakest(solver, tangent, w, multipliers(problem), border)) return std::nullopt;
        const BorderedSolution q0 = solver.solve(-g, 0), r = solver.solve(zero, 1);
        Eigen::VectorXd d = q0.x - q0.tau / r.tau * r.x;
        const double plain = std::sqrt(d.dot(w.cwiseProduct(d)));
        double along = 0;  // d . grad log m
        for (const Configuration<P>& other : known) {
            const Eigen::VectorXd from = -difference(problem, q, other);
            const double distance2 = from.dot(w.cwiseProduct(from));
            if (!(distance2 > 0)) return std::nullopt;
            const double inverse = std::pow(distance2, -options.power / 2);
            along -= options.power * inverse / distance2 * from.dot(w.cwiseProduct(d)) / (inverse + options.shift);
        }
        d /= 1 - along;
        const double size = std::sqrt(d.dot(w.cwiseProduct(d)));
        if (!std::isfinite(size)) return std::nullopt;
        if (size > options.longest_step) d *= options.longest_step / size;
        q = retract(problem, q, d);
        // both: where the deflated step is small because a known equilibrium is near, the plain one is not
        if (plain <= options.tolerance || (size >= before && std::max(size, plain) < 1e3 * options.tolerance)) {
            for (const Configuration<P>& other : known) {
                const Eigen::VectorXd from = difference(problem, q, other);
                if (from.dot(w.cwiseProduct(from)) < 1e-12) return std::nullopt;
            }
            return q;
        }
        before = size;
    }
    return std::nullopt;
}

/// All equilibria at the parameter p that deflated Newton finds from the guesses besides `known`: each new one joins
/// those that are deflated, and the guesses are tried again.
template <ContinuationProblem P>
std::vector<Configuration<P>> deflated_search(const P& problem, double p, const std::vector<Configuration<P>>& guesses,
                                              std::vector<Configuration<P>> known,
                                              const DeflationOptions& options = {}) {
    const std::size_t given = known.size();
    for (bool more = true; more;) {
        more = false;
        for (const Configuration<P>& guess : guesses)
            while (auto found = deflated_newton(problem, p, guess, known, options)) {
                known.push_back(std::move(*found));
                more = true;
            }
    }
    known.erase(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(given));
    return known;
}

}  // namespace equilibria
