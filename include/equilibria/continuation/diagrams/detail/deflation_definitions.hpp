/// \file
/// See continuation/diagrams/deflation.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/diagrams/deflation.hpp>
#include <equilibria/continuation/factorization/bordered.hpp>

namespace equilibria {

template <class Matrix>
std::optional<AnyConfiguration> deflated_newton(const AnyProblem<Matrix>& problem, double p, AnyConfiguration guess,
                                                const std::vector<AnyConfiguration>& known,
                                                const DeflationOptions& options) {
    options.validate();
    const Eigen::Index n = problem.residual(guess, p).size();
    const Eigen::VectorXd w = problem.weights(guess, n), zero = Eigen::VectorXd::Zero(n);
    BorderedSolver<Matrix> solver(problem.properties().symmetric, problem.multipliers(), problem.symmetric_factors());
    Border border;
    AnyConfiguration q = std::move(guess);
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < options.most_iterations; ++k) {
        const Eigen::VectorXd g = problem.residual(q, p);
        if (!g.allFinite()) return std::nullopt;
        if (!factor_at_weakest(solver, problem.tangent(q, p), w, problem.multipliers(), border)) return std::nullopt;
        const BorderedSolution q0 = solver.solve(-g, 0), r = solver.solve(zero, 1);
        Eigen::VectorXd d = q0.x - q0.tau / r.tau * r.x;
        const double plain = std::sqrt(d.dot(w.cwiseProduct(d)));
        double along = 0;  // d . grad log m
        for (const AnyConfiguration& other : known) {
            const Eigen::VectorXd from = -problem.difference(q, other);
            const double distance2 = from.dot(w.cwiseProduct(from));
            if (!(distance2 > 0)) return std::nullopt;
            const double inverse = std::pow(distance2, -options.power / 2);
            along -= options.power * inverse / distance2 * from.dot(w.cwiseProduct(d)) / (inverse + options.shift);
        }
        d /= 1 - along;
        const double size = std::sqrt(d.dot(w.cwiseProduct(d)));
        if (!std::isfinite(size)) return std::nullopt;
        if (size > options.longest_step) d *= options.longest_step / size;
        q = problem.retract(q, d);
        // both: where the deflated step is small because a known equilibrium is near, the plain one is not
        if (plain <= options.tolerance || (size >= before && std::max(size, plain) < 1e3 * options.tolerance)) {
            for (const AnyConfiguration& other : known) {
                const Eigen::VectorXd from = problem.difference(q, other);
                if (from.dot(w.cwiseProduct(from)) < 1e-12) return std::nullopt;
            }
            return q;
        }
        before = size;
    }
    return std::nullopt;
}

template <class Matrix>
std::vector<AnyConfiguration> deflated_search(const AnyProblem<Matrix>& problem, double p,
                                              const std::vector<AnyConfiguration>& guesses,
                                              std::vector<AnyConfiguration> known, const DeflationOptions& options) {
    const std::size_t given = known.size();
    for (bool more = true; more;) {
        more = false;
        for (const AnyConfiguration& guess : guesses)
            while (auto found = deflated_newton(problem, p, guess, known, options)) {
                known.push_back(std::move(*found));
                more = true;
            }
    }
    known.erase(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(given));
    return known;
}

}  // namespace equilibria
