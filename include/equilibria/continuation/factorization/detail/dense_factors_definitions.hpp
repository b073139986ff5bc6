/// \file
/// See continuation/factorization/bordered.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>
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

    /// The sign of the determinant, 0 where it is singular to working precision.
    int factor(const Matrix& k, Border border, double corner) {
        lu_.compute(without(k, border, corner));
        const double determinant_sign = lu_.permutationP().determinant() < 0 ? -1 : 1;
        double sign = determinant_sign, smallest = std::numeric_limits<double>::infinity(), largest = 0;
        for (Eigen::Index i = 0; i < lu_.rows(); ++i) {
            const double pivot = lu_.matrixLU()(i, i);
            if (pivot < 0) sign = -sign;
            smallest = std::min(smallest, std::abs(pivot));
            largest = std::max(largest, std::abs(pivot));
        }
        if (!(smallest > 4 * std::numeric_limits<double>::epsilon() * largest)) return 0;
        return sign < 0 ? -1 : 1;
    }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& f, bool transposed) const {
        return transposed ? Eigen::MatrixXd(lu_.transpose().solve(f)) : Eigen::MatrixXd(lu_.solve(f));
    }
    /// Of a symmetric K, the border included.
    static std::optional<TangentInertia> inertia(const Matrix& k, double) {
        TangentInertia y;
        const Eigen::SelfAdjointEigenSolver<Matrix> eigen(k, Eigen::EigenvaluesOnly);
        const Eigen::VectorXd& values = eigen.eigenvalues();  // in increasing order
        y.negative = static_cast<int>((values.array() < 0).count());
        if (y.negative > 0) y.below = values(y.negative - 1);
        if (y.negative < values.size()) y.above = values(y.negative);
        return y;
    }

private:
    LU lu_;
};

}  // namespace equilibria::detail
