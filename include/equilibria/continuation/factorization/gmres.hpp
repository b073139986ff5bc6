/// \file
/// Linear equations by the generalised minimal residual method, without restarts: what is preconditioned well takes a
/// few products.
/// Source: Saad and Schultz, GMRES: a generalized minimal residual algorithm for solving nonsymmetric linear systems,
/// SIAM J. Sci. Stat. Comput. 7 (1986).
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Jacobi>

namespace equilibria {

/// How the iteration ended.
struct GmresSolution {
    Eigen::VectorXd x;      ///< n entries
    double residual = 0;    ///< |b - A x| / |b| by the recurrence; 0 where b = 0
    int iterations = 0;     ///< products with A
    bool converged = true;  ///< the residual is at most the tolerance
};

/// x with A x = b from x = 0, by at most `most` products; apply(v): A v. Where b or a product is not finite, x is 0 and
/// not converged.
template <class Apply>
GmresSolution gmres(const Apply& apply, const Eigen::VectorXd& b, double tolerance, int most) {
    GmresSolution y{Eigen::VectorXd::Zero(b.size())};
    const double size = b.norm();
    if (size == 0) return y;
    y.residual = 1;
    y.converged = false;
    if (!std::isfinite(size)) return y;
    // Arnoldi's basis, and its Hessenberg matrix made triangular by rotations
    std::vector<Eigen::VectorXd> basis{b / size};
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(most + 1, most);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(most + 1);
    right(0) = size;
    std::vector<Eigen::JacobiRotation<double>> rotations;
    int used = 0;  // columns of h
    while (y.iterations < most && !y.converged) {
        const int k = y.iterations;
        Eigen::VectorXd v = apply(basis.back());
        if (!v.allFinite()) return y;
        const double negligible = std::numeric_limits<double>::epsilon() * v.norm();
        for (int i = 0; i <= k; ++i) {
            h(i, k) = basis[static_cast<std::size_t>(i)].dot(v);
            v -= h(i, k) * basis[static_cast<std::size_t>(i)];
        }
        h(k + 1, k) = v.norm();
        const bool exhausted = !(h(k + 1, k) > negligible);
        if (!exhausted) basis.push_back(v / h(k + 1, k));
        for (int i = 0; i < k; ++i) h.col(k).applyOnTheLeft(i, i + 1, rotations[static_cast<std::size_t>(i)].adjoint());
        Eigen::JacobiRotation<double>& rotation = rotations.emplace_back();
        rotation.makeGivens(h(k, k), h(k + 1, k));
        h.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
        ++y.iterations;
        // a singular matrix: nothing more is gained
        if (!(std::abs(h(k, k)) > negligible)) break;
        right.applyOnTheLeft(k, k + 1, rotation.adjoint());
        ++used;
        y.residual = std::abs(right(used)) / size;
        y.converged = y.residual <= tolerance;
        if (exhausted) break;
    }
    const Eigen::VectorXd share = h.topLeftCorner(used, used).triangularView<Eigen::Upper>().solve(right.head(used));
    if (!share.allFinite()) {
        y.converged = false;
        return y;
    }
    for (int i = 0; i < used; ++i) y.x += share(i) * basis[static_cast<std::size_t>(i)];
    return y;
}

}  // namespace equilibria
