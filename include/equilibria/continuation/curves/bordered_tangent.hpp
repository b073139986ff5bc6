/// \file
/// A configuration next to a critical point, with the border that makes its tangent regular, and what one factorisation
/// gives there: what the curves of critical points are written with.
#pragma once

#include <algorithm>
#include <cmath>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/problem.hpp>

namespace equilibria {

/// A point of a curve of critical points; Q: the configuration of the member.
template <class Q>
struct CriticalConfiguration {
    Q q{};             ///< the configuration of the member
    double p = 0;      ///< the parameter
    double gamma = 0;  ///< of bifurcation points: 0 where the bifurcation is perfect
    Border border;     ///< with which the tangent is regular
    double sign = 1;   ///< of sigma and mu, so that a change of border leaves no jump of the determinant's sign
};

/// sigma, mu and the vectors of bordered.hpp, of a problem at one configuration.
template <ContinuationProblem P>
struct BorderedTangent {
    /// Factors the tangent of `problem` at y with the border of y.
    BorderedTangent(const P& problem, const CriticalConfiguration<Configuration<P>>& y)
        : g(problem.residual(y.q, y.p)), g_p(problem.parameter_derivative(y.q, y.p)),
          solver(symmetric_tangent<P>, equilibria::multipliers(problem), symmetric_factors(problem)),
          regular(solver.factor(problem.tangent(y.q, y.p), y.border) && g.allFinite()) {
        if (!regular) return;
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(g.size(), 2);
        right.col(1) = -g_p;
        const BorderedSolutions solutions = solver.solve(right, Eigen::Vector2d(1, 0));
        null = solutions[0];
        slope = solutions[1];
        left = symmetric_tangent<P> ? null : solver.solve_transposed(Eigen::VectorXd::Zero(g.size()), 1);
    }
    double sigma() const { return null.tau; }                      ///< 0 where K is singular
    double mu() const { return -slope.tau; }                       ///< 0 at bifurcations, where sigma is
    const TangentMatrix<P>& k() const { return solver.matrix(); }  ///< K

    Eigen::VectorXd g;                        ///< the residual
    Eigen::VectorXd g_p;                      ///< dg/dp
    BorderedSolver<TangentMatrix<P>> solver;  ///< with K's factors
    bool regular;                             ///< the bordered matrix is regular, and g finite
    BorderedSolution null;                    ///< [r; sigma]; empty where not regular
    BorderedSolution left;                    ///< the same of B^T
    BorderedSolution slope;                   ///< [s; -mu]
};

/// The same point with the border where the null vectors are largest.
template <ContinuationProblem P>
CriticalConfiguration<Configuration<P>> with_best_border(const P& problem,
                                                         const CriticalConfiguration<Configuration<P>>& y) {
    const BorderedTangent<P> b(problem, y);
    if (!b.regular) return y;
    const Eigen::Index size = b.g.size() - multipliers(problem);
    const Eigen::VectorXd root = weights(problem, y.q, b.g.size()).cwiseSqrt();
    auto moved = y;
    const auto turn = [&](const Eigen::VectorXd& v, Eigen::Index& at) {
        Eigen::Index best = 0;
        const double largest = root.cwiseProduct(v).head(size).cwiseAbs().maxCoeff(&best);
        if (!(largest > 2 * root(at) * std::abs(v(at)))) return;
        if (v(best) * v(at) < 0) moved.sign = -moved.sign;
        at = best;
    };
    turn(b.null.x, moved.border.column);
    turn(b.left.x, moved.border.row);
    if (symmetric_tangent<P>) moved.border.row = moved.border.column, moved.sign = y.sign;
    return moved;
}

}  // namespace equilibria
