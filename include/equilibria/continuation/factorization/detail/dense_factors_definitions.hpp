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

/// L U of B for a dense K, its ones of the size of K's entries.
template <class Number>
class BorderedFactors<Eigen::MatrixX<Number>> {
public:
    using Matrix = Eigen::MatrixX<Number>;
    using LU = Eigen::PartialPivLU<Matrix>;

    BorderedFactors(bool, int, MakeSymmetricFactors) {}

    int factor(const Matrix& k, Border border, double size) {
        const Eigen::Index n = k.rows();
        size_ = size;
        Matrix b = Matrix::Zero(n + 1, n + 1);
        b.topLeftCorner(n, n) = k;
        b(border.row, n) = b(n, border.column) = size;
        lu_.compute(b);
        bool negative = lu_.permutationP().determinant() < 0;
        double smallest = std::numeric_limits<double>::infinity(), largest = 0;
        for (Eigen::Index i = 0; i <= n; ++i) {
            const double pivot = lu_.matrixLU()(i, i);
            if (pivot < 0) negative = !negative;
            smallest = std::min(smallest, std::abs(pivot));
            largest = std::max(largest, std::abs(pivot));
        }
        if (!(smallest > 4 * std::numeric_limits<double>::epsilon() * largest)) return 0;
        return negative ? 1 : -1;  // det B is minus that of K without them
    }
    BorderedSolutions solve(const Matrix&, const Eigen::MatrixXd& f, const Eigen::VectorXd& xi, bool transposed,
                            int) const {
        const Eigen::Index n = f.rows();
        BorderedSolutions y{Eigen::MatrixXd(n, f.cols()), Eigen::VectorXd(f.cols())};
        Eigen::VectorXd column(n + 1);
        for (Eigen::Index c = 0; c < f.cols(); ++c) {  // few: vectors are quicker than a matrix
            column << f.col(c), size_ * xi(c);
            column = transposed ? Eigen::VectorXd(lu_.transpose().solve(column)) : Eigen::VectorXd(lu_.solve(column));
            y.x.col(c) = column.head(n);
            y.tau(c) = size_ * column(n);
        }
        return y;
    }
    /// Of a symmetric K, the border included.
    static std::optional<TangentInertia> inertia(const Matrix& k, double) {
        TangentInertia y{0, EigenvalueCounts(k)};
        y.negative = y.eigenvalues.below(0);
        return y;
    }

private:
    LU lu_;
    double size_ = 1;
};

}  // namespace equilibria::detail
