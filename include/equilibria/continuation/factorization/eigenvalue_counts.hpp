/// \file
/// How many eigenvalues of a dense symmetric matrix lie below a number: of its tridiagonal form by the signs of a Sturm
/// sequence, which is cheaper than the eigenvalues themselves and as sure.
/// Source: Parlett, The Symmetric Eigenvalue Problem (SIAM, 1998), sections 3.3 and 7.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace equilibria {

/// Counts the eigenvalues of a dense symmetric matrix below any number, after one reduction to tridiagonal form.
class EigenvalueCounts {
public:
    EigenvalueCounts() = default;
    /// k: symmetric and finite; the entries above its diagonal are not read.
    explicit EigenvalueCounts(const Eigen::MatrixXd& k) {
        if (k.rows() == 0) return;
        const Eigen::Tridiagonalization<Eigen::MatrixXd> tridiagonal(k);
        diagonal_ = tridiagonal.diagonal();
        squares_ = tridiagonal.subDiagonal().cwiseAbs2();
    }

    bool empty() const { return diagonal_.size() == 0; }    ///< of no matrix
    Eigen::Index size() const { return diagonal_.size(); }  ///< how many eigenvalues there are

    /// How many are smaller than x, to rounding.
    int below(double x) const {
        int count = 0;
        double d = 1;
        for (Eigen::Index i = 0; i < diagonal_.size(); ++i) {
            d = diagonal_(i) - x - (i > 0 ? squares_(i - 1) / d : 0.0);
            if (d == 0) d = std::numeric_limits<double>::min();
            count += d < 0;
        }
        return count;
    }

private:
    Eigen::VectorXd diagonal_, squares_;  ///< of the tridiagonal form; below its diagonal, squared
};

}  // namespace equilibria
