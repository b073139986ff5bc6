/// \file
/// See continuation/corrector.hpp.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <equilibria/continuation/corrector.hpp>

namespace equilibria {

namespace detail {

template <class Matrix>
Correction Corrector<Matrix>::operator()(AnyConfiguration& q, double p, const CorrectionOptions& options) {
    const auto ended = [](Correction y, CorrectionStatus status) {
        y.status = status;
        return y;
    };
    Correction y;
    double before = std::numeric_limits<double>::infinity();
    while (y.steps < options.most_steps) {
        const Eigen::VectorXd g = problem_.residual(q, p);
        if (!g.allFinite() ||
            !factor_with_border(solver_, problem_.tangent(q, p), weights_, problem_.multipliers(), border_))
            return ended(y, CorrectionStatus::not_finite);
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(g.size(), 2);
        right.col(0) = -g;
        const BorderedSolutions solutions = solver_.solve(right, Eigen::Vector2d(0, 1));
        const BorderedSolution q0 = solutions[0], r = solutions[1];
        const Eigen::VectorXd d = q0.x - q0.tau / r.tau * r.x;
        const double size = std::sqrt(d.dot(weights_.cwiseProduct(d)));
        if (!std::isfinite(size)) return ended(y, CorrectionStatus::not_finite);
        q = problem_.retract(q, d);
        ++y.steps;
        if (size <= options.tolerance || (size >= before && size < options.rounding * options.tolerance))
            return ended(y, CorrectionStatus::converged);
        before = size;
    }
    return y;
}

}  // namespace detail

template <class Matrix>
Correction correct_at(const AnyProblem<Matrix>& problem, AnyConfiguration& q, double p,
                      const CorrectionOptions& options) {
    options.validate();
    const Eigen::VectorXd metric = problem.weights(q, problem.residual(q, p).size());
    BorderedSolver<Matrix> solver(problem.properties().symmetric, problem.multipliers(), problem.symmetric_factors());
    Border border;
    return detail::Corrector<Matrix>(problem, solver, border, metric)(q, p, options);
}

}  // namespace equilibria
