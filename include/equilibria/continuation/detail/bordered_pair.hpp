/// \file
/// The two solutions with a bordered K that tangents and corrections of a branch are made of.
/// Source: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 3.
#pragma once

#include <Eigen/Core>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/problem.hpp>

namespace equilibria::detail {

/// The bordered solutions that a factored K gives for a correction: r, and s for some dg/dp.
struct BorderedPair {
    BorderedSolution r, s;
    /// x and dp with K x + dg/dp dp = f and normal.(x, dp) = value, q0 being K^-1 f by the border.
    Direction combine(const BorderedSolution& q0, const Direction& normal, double value) const {
        // [sigma, t_s; n.r, n.s + n_p] [z; dp] = [-t0; value - n.q0]
        const double a = r.tau, b = s.tau, c = normal.q.dot(r.x), d = normal.q.dot(s.x) + normal.p;
        const double e = -q0.tau, f = value - normal.q.dot(q0.x), determinant = a * d - b * c;
        const double z = (e * d - b * f) / determinant, dp = (a * f - e * c) / determinant;
        return {q0.x + z * r.x + dp * s.x, dp};
    }
    /// Makes them those of this K and dg/dp, next to the K that the solver has factored.
    template <class Matrix>
    void refine(const BorderedSolver<Matrix>& solver, const Matrix& k, const Eigen::VectorXd& g_p) {
        Eigen::MatrixXd rest(g_p.size(), 2);
        rest.col(0) = -(k * r.x);
        rest.col(1) = -g_p - k * s.x;
        const Eigen::Index row = solver.border().row;
        rest(row, 0) -= r.tau;
        rest(row, 1) -= s.tau;
        const BorderedSolutions correction = solver.solve(rest, Eigen::Vector2d::Zero());
        r.x += correction.x.col(0);
        s.x += correction.x.col(1);
        r.tau += correction.tau(0);
        s.tau += correction.tau(1);
    }
};

}  // namespace equilibria::detail
