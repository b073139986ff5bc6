/// \file
/// See continuation/factorization/bordered.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/LU>

#include <equilibria/continuation/factorization/bordered.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE double largest_entry(const Eigen::MatrixXd& k) {
    if (k.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
    return k.size() > 0 ? k.cwiseAbs().maxCoeff() : 0;
}
EQUILIBRIA_INLINE double largest_force(const Eigen::MatrixXd& k, const Eigen::VectorXd& weights, Eigen::Index own) {
    double y = 0;
    for (Eigen::Index c = 0; c < own; ++c) y = std::max(y, k.col(c).cwiseAbs().maxCoeff() / std::sqrt(weights(c)));
    return y;
}

/// L U of a dense K without its border.
template <class Number>
class BorderedFactors<Eigen::MatrixX<Number>> {
public:
    using Matrix = Eigen::MatrixX<Number>;
    using LU = Eigen::PartialPivLU<Matrix>;

    BorderedFactors(bool, int, MakeSymmetricFactors) {}

    int factor(const Matrix& k, Border border, double size) {
        border_ = border;
        Matrix without = k;
        without.row(border.row).setZero();
        without.col(border.column).setZero();
        without(border.row, border.column) = size;
        lu_.compute(without);
        bool negative = lu_.permutationP().determinant() < 0;
        double smallest = std::numeric_limits<double>::infinity(), largest = 0;
        for (Eigen::Index i = 0; i < lu_.rows(); ++i) {
            const double pivot = lu_.matrixLU()(i, i);
            if (pivot < 0) negative = !negative;
            smallest = std::min(smallest, std::abs(pivot));
            largest = std::max(largest, std::abs(pivot));
        }
        if (!(smallest > 4 * std::numeric_limits<double>::epsilon() * largest)) return 0;
        return negative ? -1 : 1;
    }
    BorderedSolutions solve(const Matrix& k, const Eigen::MatrixXd& f, const Eigen::VectorXd& xi, bool transposed,
                            int rounds) const {
        // of B^T, row and column change places
        const Eigen::Index j = transposed ? border_.column : border_.row, i = transposed ? border_.row : border_.column;
        BorderedSolutions y{Eigen::MatrixXd(f.rows(), f.cols()), Eigen::VectorXd(f.cols())};
        Eigen::VectorXd x(f.rows()), rest(f.rows());
        for (Eigen::Index c = 0; c < f.cols(); ++c) {  // few: vectors are quicker than a matrix
            x.setZero();
            x(i) = xi(c);
            // the second round removes the rounding of the first
            for (int round = 0; round < rounds; ++round) {
                rest = f.col(c);
                if (round == 0) {
                    if (xi(c) != 0) rest -= xi(c) * (transposed ? k.row(i).transpose().eval() : k.col(i).eval());
                } else if (transposed) {
                    rest.noalias() -= k.transpose() * x;
                } else {
                    rest.noalias() -= k * x;
                }
                rest(j) = 0;
                x += transposed ? Eigen::VectorXd(lu_.transpose().solve(rest)) : Eigen::VectorXd(lu_.solve(rest));
                x(i) = xi(c);
            }
            y.x.col(c) = x;
            y.tau(c) = f(j, c) - (transposed ? k.col(j).dot(x) : k.row(j).dot(x));
        }
        return y;
    }
    /// Of a symmetric K, the border included.
    static std::optional<TangentInertia> inertia(const Matrix& k, double) {
        TangentInertia y{0, EigenvalueCounts(k)};
        y.negative = y.eigenvalues.below(0);
        return y;
    }
    double work_ratio() const { return 0; }

private:
    LU lu_;
    Border border_;
};

}  // namespace equilibria::detail
