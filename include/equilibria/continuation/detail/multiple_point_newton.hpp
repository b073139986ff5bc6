/// \file
/// Newton's method for a point of a branch with k null vectors,
///
///     g(q, p) = 0,   S(q, p) = 0,   where   K V + E S = 0,  E^T V = I,
///
/// E being k columns of the identity, at unknowns in which the null vectors are large. S is k x k, and 0 exactly where
/// K has k null vectors, the columns of V. There are more equations than unknowns. Where a symmetry makes K lose k
/// ranks at once they agree, and the Gauss-Newton method converges quadratically; where eigenvalues vanish close to
/// each other it leaves an S that tells so.
///
/// With K^T W + E S^T = 0, E^T W = I the derivative of S is -W^T dK V. A correction is x + y dp + V c with K x + E t =
/// -g and K y + E u = -dg/dp, E^T x = E^T y = 0, so that c and dp alone are left: t + u dp + S c = 0, S + dS = 0.
/// Sources: Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 3; Deuflhard, Newton Methods
/// for Nonlinear Problems, section 4.3 (Gauss-Newton).
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>

#include <equilibria/continuation/any_problem.hpp>
#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/factorization/bordered.hpp>

namespace equilibria::detail {

/// Unknowns, multipliers apart, at which the columns are largest by the weights, one after the other, what the columns
/// before have there taken off: complete pivoting. Empty where the columns depend on each other.
inline std::vector<Eigen::Index> rows_of_null_vectors(Eigen::MatrixXd v, const Eigen::VectorXd& weights,
                                                      int multipliers) {
    const Eigen::Index own = v.rows() - multipliers, k = v.cols();
    v = weights.head(own).cwiseSqrt().asDiagonal() * v.topRows(own).eval();
    std::vector<Eigen::Index> y;
    double first = 0;
    for (Eigen::Index j = 0; j < k; ++j) {
        Eigen::Index row = 0, column = 0;
        const double pivot = v.rightCols(k - j).cwiseAbs().maxCoeff(&row, &column);
        if (j == 0) first = pivot;
        if (!(pivot > 1e-8 * first)) return {};
        y.push_back(row);
        v.col(j).swap(v.col(j + column));
        const Eigen::RowVectorXd rest = v.row(row).rightCols(k - j - 1) / v(row, j);
        v.rightCols(k - j - 1) -= (v.col(j) * rest).eval();
    }
    return y;
}

/// Solutions with [K E; E^T 0], E the columns of the identity at `rows`. One of them borders the factorisation; at the
/// others K has springs, whose forces are taken back.
template <class Matrix>
class SeveralBorders {
public:
    /// [x; t] for each column of a right hand side.
    struct Solution {
        Eigen::MatrixXd x, t;
    };

    /// The solver must outlive it. False in `factored` where that matrix is singular to working precision.
    SeveralBorders(BorderedSolver<Matrix>& solver, Matrix k, std::vector<Eigen::Index> rows)
        : solver_(solver), rows_(std::move(rows)), spring_(2.7 * detail::largest_entry(k)) {
        for (std::size_t j = 1; j < rows_.size(); ++j) k.coeffRef(rows_[j], rows_[j]) += spring_;
        factored_ = solver_.factor(std::move(k), {rows_[0], rows_[0]});
    }
    bool factored() const { return factored_; }

    /// K x + E t = f, E^T x = h; with K^T where `transposed`.
    Solution solve(const Eigen::MatrixXd& f, const Eigen::MatrixXd& h, bool transposed) {
        const Eigen::Index k = size(), others = k - 1;
        Eigen::MatrixXd right = f;
        for (Eigen::Index j = 1; j < k; ++j) right.row(row(j)) += spring_ * h.row(j);
        const BorderedSolutions base = bordered(right, h.row(0).transpose(), transposed);
        Solution y{base.x, Eigen::MatrixXd(k, f.cols())};
        y.t.row(0) = base.tau.transpose();
        if (others == 0) return y;
        // what forces at the other unknowns do
        BorderedSolutions& unit = units_[transposed ? 1 : 0];
        if (unit.x.size() == 0) {
            Eigen::MatrixXd at = Eigen::MatrixXd::Zero(f.rows(), others);
            for (Eigen::Index j = 0; j < others; ++j) at(row(j + 1), j) = 1;
            unit = bordered(at, Eigen::VectorXd::Zero(others), transposed);
        }
        Eigen::MatrixXd response(others, others), excess(others, f.cols());
        for (Eigen::Index j = 0; j < others; ++j) {
            response.row(j) = unit.x.row(row(j + 1));
            excess.row(j) = base.x.row(row(j + 1)) - h.row(j + 1);
        }
        const Eigen::MatrixXd t = response.partialPivLu().solve(excess);
        y.x -= unit.x * t;
        y.t.row(0) -= unit.tau.transpose() * t;
        y.t.bottomRows(others) = t;
        return y;
    }

private:
    Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }
    Eigen::Index row(Eigen::Index j) const { return rows_[static_cast<std::size_t>(j)]; }
    BorderedSolutions bordered(const Eigen::MatrixXd& f, const Eigen::VectorXd& xi, bool transposed) const {
        if (!transposed) return solver_.solve(f, xi);
        BorderedSolutions y{Eigen::MatrixXd(f.rows(), f.cols()), Eigen::VectorXd(f.cols())};
        for (Eigen::Index c = 0; c < f.cols(); ++c) {
            const BorderedSolution one = solver_.solve_transposed(f.col(c), xi(c));
            y.x.col(c) = one.x;
            y.tau(c) = one.tau;
        }
        return y;
    }

    BorderedSolver<Matrix>& solver_;
    std::vector<Eigen::Index> rows_;
    double spring_;
    bool factored_ = false;
    BorderedSolutions units_[2];
};

/// Newton's method for a point with several null vectors.
template <class Matrix>
class MultiplePointNewton {
public:
    /// The point that it ended at, and what is left there.
    struct Found {
        AnyConfiguration q;
        double p = 0;
        Eigen::MatrixXd null_vectors;  ///< V
        Eigen::MatrixXd left;          ///< W
        Eigen::VectorXd load;          ///< W^T dg/dp, over the lengths of dg/dp and of the columns of W
        double residual = 0;           ///< |g|, the largest entry
        double singular = 0;           ///< the largest |S|
        std::vector<CriticalIteration> history;
    };

    /// All must outlive it. weights: of lengths; basis: nearly the null vectors, a column each.
    MultiplePointNewton(const AnyProblem<Matrix>& problem, BorderedSolver<Matrix>& solver,
                        const Eigen::VectorXd& weights, const Eigen::MatrixXd& basis)
        : problem_(problem), solver_(solver), weights_(weights),
          rows_(rows_of_null_vectors(basis, weights, problem.multipliers())) {}

    /// Whether there are as many unknowns as null vectors in which these are large.
    bool possible() const { return !rows_.empty(); }

    /// From (q, p); nothing where it does not converge, or a step is longer than `reach`, where p counts by its weight.
    std::optional<Found> solve(const AnyConfiguration& q, double p, const CriticalPointOptions& options, double reach,
                               double parameter_weight) {
        Found y;
        y.q = q;
        y.p = p;
        for (int k = 0; k < options.most_iterations; ++k) {
            const std::optional<Step> step = evaluate(y);
            if (!step || !std::isfinite(step->length)) return std::nullopt;
            if (std::hypot(norm(step->d.q), parameter_weight * step->d.p) > reach) return std::nullopt;
            const double before = y.history.empty() ? std::numeric_limits<double>::infinity() : y.history.back().step;
            y.history.push_back({step->length, y.singular, y.residual, true});
            y.q = problem_.retract(y.q, step->d.q);
            y.p += step->d.p;
            if (step->length <= options.tolerance || (step->length < 1e-8 && step->length > 0.2 * before)) {
                if (!evaluate(y)) return std::nullopt;
                return y;
            }
        }
        return std::nullopt;
    }
    /// The largest |S| at a place, to compare with; nothing where it cannot be told.
    std::optional<double> singular_at(const AnyConfiguration& q, double p) {
        Found y;
        y.q = q;
        y.p = p;
        if (!evaluate(y)) return std::nullopt;
        return y.singular;
    }

private:
    struct Step {
        Direction d;
        double length;
    };

    double norm(const Eigen::VectorXd& v) const { return std::sqrt(v.dot(weights_.cwiseProduct(v))); }

    /// What there is at (y.q, y.p), and the correction from there.
    std::optional<Step> evaluate(Found& y) {
        const bool symmetric = problem_.properties().symmetric;
        const auto k = static_cast<Eigen::Index>(rows_.size());
        Linearization<Matrix> here = problem_.linearization(y.q, y.p);
        const Eigen::Index n = here.residual.size();
        if (!here.residual.allFinite()) return std::nullopt;
        y.residual = here.residual.template lpNorm<Eigen::Infinity>();
        SeveralBorders<Matrix> borders(solver_, std::move(here.tangent), rows_);
        if (!borders.factored()) return std::nullopt;
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, k + 2), unit = Eigen::MatrixXd::Zero(k, k + 2);
        right.col(k) = -here.residual;
        right.col(k + 1) = -here.parameter_derivative;
        unit.leftCols(k).setIdentity();
        const auto solution = borders.solve(right, unit, false);
        const Eigen::MatrixXd v = solution.x.leftCols(k), s = solution.t.leftCols(k);
        const Eigen::MatrixXd w =
            symmetric ? v : borders.solve(Eigen::MatrixXd::Zero(n, k), Eigen::MatrixXd::Identity(k, k), true).x;
        if (!solution.x.allFinite() || !w.allFinite()) return std::nullopt;
        y.null_vectors = v;
        y.left = w;
        y.singular = s.cwiseAbs().maxCoeff();
        const Eigen::VectorXd root = weights_.cwiseSqrt();
        const double load = here.parameter_derivative.cwiseQuotient(root).norm();
        y.load = w.transpose() * here.parameter_derivative;
        for (Eigen::Index j = 0; j < k; ++j) y.load(j) /= load > 0 ? load * norm(w.col(j)) : 1.0;

        // columns: c, dp; rows: the load's work, then S
        Eigen::MatrixXd a(k + k * k, k + 1);
        Eigen::VectorXd b(k + k * k);
        a.topLeftCorner(k, k) = s;
        a.topRightCorner(k, 1) = solution.t.col(k + 1);
        b.head(k) = -solution.t.col(k);
        for (Eigen::Index j = 0; j < k; ++j) {
            const Matrix along = problem_.tangent_derivative(y.q, y.p, v.col(j));
            const Eigen::MatrixXd turned = along * solution.x;
            Eigen::MatrixXd moved = w.transpose() * turned;
            // where a symmetry makes them 0, differences leave noise
            for (Eigen::Index l = 0; l < k; ++l)
                for (Eigen::Index i = 0; i < k; ++i)
                    if (std::abs(moved(i, l)) < 1e-7 * w.col(i).norm() * turned.col(l).norm()) moved(i, l) = 0;
            const Eigen::VectorXd by_load = w.transpose() * problem_.parameter_derivative_along(y.q, y.p, v.col(j));
            a.block(k + j * k, 0, k, k) = moved.leftCols(k);
            a.block(k + j * k, k, k, 1) = moved.col(k + 1) + by_load;
            b.segment(k + j * k, k) = s.col(j) - moved.col(k);
        }
        // each unknown as if its column were of length 1; what nothing depends on stays
        Eigen::VectorXd scale = a.colwise().norm().transpose();
        if (!scale.allFinite()) return std::nullopt;
        const double rounding = 1e4 * std::numeric_limits<double>::epsilon() * solver_.largest_entry();
        for (Eigen::Index c = 0; c <= k; ++c) scale(c) = scale(c) > (c < k ? rounding : 0.0) ? 1 / scale(c) : 0;
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least;
        least.setThreshold(1e-9);
        least.compute(a * scale.asDiagonal());
        const Eigen::VectorXd found = scale.cwiseProduct(least.solve(b));
        Step step;
        step.d.p = found(k);
        step.d.q = solution.x.col(k) + found(k) * solution.x.col(k + 1) + v * found.head(k);
        step.length = norm(step.d.q) + std::abs(step.d.p) * rate(solution.x.col(k + 1), y.p);
        return step;
    }
    /// Lengths per unit of p: as far as the unknowns move with it, or, where they hardly do, p over its size.
    double rate(const Eigen::VectorXd& slope, double p) const {
        return std::max(norm(slope), p != 0 ? 1 / std::abs(p) : 0.0);
    }

    const AnyProblem<Matrix>& problem_;
    BorderedSolver<Matrix>& solver_;
    const Eigen::VectorXd& weights_;
    std::vector<Eigen::Index> rows_;
};

}  // namespace equilibria::detail
