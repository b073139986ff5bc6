/// \file
/// Newton's corrections along a branch without a factorisation: by GMRES, with the factors of a K nearby as its
/// preconditioner. Of a K whose factorisation takes many times the work of a solution by its factors, as those of
/// equations in three dimensions do, one factorisation a step is left: that of the last correction.
#pragma once

#include <optional>
#include <utility>

#include <Eigen/Core>

#include <equilibria/continuation/detail/bordered_pair.hpp>
#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/gmres.hpp>
#include <equilibria/continuation/problem.hpp>

namespace equilibria::detail {

/// The factors that a solver has, of whatever K of the same problem.
template <class Matrix>
class LastFactors {
public:
    /// The solver must outlive it and not factor meanwhile. scale: an unknown's share in lengths, the square root of
    /// its weight; parameter_scale: the parameter's.
    LastFactors(const BorderedSolver<Matrix>& solver, Eigen::VectorXd scale, double parameter_scale)
        : solver_(&solver), scale_(std::move(scale)), parameter_scale_(parameter_scale) {}

    /// The correction at a point with this K, dg/dp and g, in the plane of that normal; nothing where GMRES does not
    /// get there in most_iterations products. value: that normal.(x, dp) is to have.
    std::optional<Direction> correction(const Linearization<Matrix>& here, const Direction& normal, double value) {
        const Eigen::Index n = here.residual.size();
        if (!pair_) {
            Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 2);
            right.col(1) = -here.parameter_derivative;
            const BorderedSolutions solutions = solver_->solve_roughly(right, Eigen::Vector2d(1, 0));
            pair_ = BorderedPair{solutions[0], solutions[1]};
        }
        // all in multiples of the lengths' units, the parameter last
        const auto packed = [&](const Direction& d) {
            Eigen::VectorXd y(n + 1);
            y << scale_.cwiseProduct(d.q), parameter_scale_ * d.p;
            return y;
        };
        const auto unpacked = [&](const Eigen::VectorXd& y) {
            return Direction{y.head(n).cwiseQuotient(scale_), y(n) / parameter_scale_};
        };
        const auto by_factors = [&](const Eigen::VectorXd& f, double constraint) {
            return packed(pair_->combine(solver_->solve_roughly(f)[0], normal, constraint));
        };
        const auto apply = [&](const Eigen::VectorXd& y) {
            const Direction d = unpacked(y);
            return by_factors(symmetric_product(here.tangent, d.q) + here.parameter_derivative * d.p,
                              normal.q.dot(d.q) + normal.p * d.p);
        };
        const GmresSolution y = gmres(apply, by_factors(-here.residual, value), tolerance, most_iterations);
        if (!y.converged) return std::nullopt;
        return unpacked(y.x);
    }

private:
    /// What is left of an error by a correction, no more than Newton's method itself leaves at the beginning.
    static constexpr double tolerance = 1e-3;
    static constexpr int most_iterations = 10;

    const BorderedSolver<Matrix>* solver_;
    Eigen::VectorXd scale_;
    double parameter_scale_;
    std::optional<BorderedPair> pair_;
};

}  // namespace equilibria::detail
