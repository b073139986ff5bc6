/// \file
/// Constraints that say what others say already: over-constrained mechanisms, whose multipliers have no values. A dead
/// point looks the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseQR>

namespace equilibria {

/// The constraints of a tangent K that others could repeat, from the rows of its last unknowns, their multipliers.
/// Those of unknowns that carry an energy of their own, an entry on K's diagonal (a force with its flexibility), are
/// independent of all others and not among them.
class ConstraintGradients {
public:
    /// weights: of the unknowns, as the continuation's problem has them; lengths are theirs.
    template <class Matrix>
    ConstraintGradients(const Matrix& k, int multipliers, const Eigen::VectorXd& weights) {
        const Eigen::SparseMatrix<double> columns = Eigen::SparseMatrix<double>(sparse(k).transpose());
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

    int count() const { return static_cast<int>(multipliers_.size()); }

    /// Those that depend on constraints before them to 1e-9: multipliers from 0, rising. The time may grow with the
    /// cube of their number.
    std::vector<int> redundant() const {
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
    /// How many depend on others: singular values of the unit gradients below 3e-7. For thousands of constraints.
    std::size_t redundant_count() const {
        // Sylvester's law: Gram's matrix has as many eigenvalues below a shift as negative pivots with it
        Eigen::SparseMatrix<double> gram = gradients_.transpose() * gradients_;
        for (Eigen::Index r = 0; r < count(); ++r) gram.coeffRef(r, r) -= 1e-13;
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(gram);
        return static_cast<std::size_t>((ldlt.vectorD().array() < 0).count());
    }

private:
    using Entry = Eigen::SparseMatrix<double>::InnerIterator;

    static const Eigen::SparseMatrix<double>& sparse(const Eigen::SparseMatrix<double>& k) { return k; }
    static Eigen::SparseMatrix<double> sparse(const Eigen::MatrixXd& k) { return k.sparseView(); }

    Eigen::SparseMatrix<double> gradients_;  // columns of length 1
    std::vector<int> multipliers_;           // theirs
};

}  // namespace equilibria
