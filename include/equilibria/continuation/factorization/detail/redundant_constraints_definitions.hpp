/// \file
/// See continuation/factorization/redundant_constraints.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseQR>

#include <equilibria/continuation/factorization/redundant_constraints.hpp>

namespace equilibria {

EQUILIBRIA_INLINE ConstraintGradients::ConstraintGradients(const Eigen::MatrixXd& k, int multipliers,
                                                           const Eigen::VectorXd& weights)
    : ConstraintGradients(Eigen::SparseMatrix<double>(k.sparseView()), multipliers, weights) {}

EQUILIBRIA_INLINE ConstraintGradients::ConstraintGradients(const Eigen::SparseMatrix<double>& k, int multipliers,
                                                           const Eigen::VectorXd& weights) {
    using Entry = Eigen::SparseMatrix<double>::InnerIterator;
    const Eigen::SparseMatrix<double> columns = k.transpose();
    const Eigen::Index own = k.rows() - multipliers;
    std::vector<Eigen::Triplet<double>> entries;
    for (int m = 0; m < multipliers; ++m) {
        double size = 0, flexibility = 0;
        for (Entry at(columns, own + m); at; ++at) {
            if (at.row() < own) size = std::hypot(size, at.value() / std::sqrt(weights(at.row())));
            if (at.row() == own + m) flexibility = std::abs(at.value());
        }
        if (flexibility > 1e-12 * size) continue;
        for (Entry at(columns, own + m); at; ++at)
            if (at.row() < own && at.value() != 0)
                entries.emplace_back(at.row(), count(), at.value() / std::sqrt(weights(at.row())) / size);
        multipliers_.push_back(m);
    }
    gradients_.resize(own, count());
    gradients_.setFromTriplets(entries.begin(), entries.end());
}

EQUILIBRIA_INLINE std::vector<int> ConstraintGradients::redundant() const {
    std::vector<int> y;
    if (count() == 0) return y;
    Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>> qr;
    qr.setPivotThreshold(1e-9);
    qr.compute(gradients_);
    for (Eigen::Index i = qr.rank(); i < count(); ++i)  // those come last
        y.push_back(multipliers_[static_cast<std::size_t>(qr.colsPermutation().indices()(i))]);
    std::sort(y.begin(), y.end());
    return y;
}

EQUILIBRIA_INLINE std::size_t ConstraintGradients::redundant_count() const {
    // Sylvester's law: Gram's matrix has as many eigenvalues below a shift as negative pivots with it
    Eigen::SparseMatrix<double> gram = gradients_.transpose() * gradients_;
    for (Eigen::Index r = 0; r < count(); ++r) gram.coeffRef(r, r) -= 1e-13;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(gram);
    return static_cast<std::size_t>((ldlt.vectorD().array() < 0).count());
}

}  // namespace equilibria
