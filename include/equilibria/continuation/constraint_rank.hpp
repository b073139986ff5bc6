/// \file
/// How many constraints are independent, from the rows of K that belong to their multipliers.
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace equilibria::detail {

/// The rank of the last `multipliers` rows of K. Those with an entry on the diagonal, of unknowns that carry an energy of
/// their own (a force with its flexibility), are independent of all others.
template <class Matrix>
Eigen::Index constraint_rank(const Matrix& k, Eigen::Index multipliers) {
    const Eigen::Index own = k.rows() - multipliers;
    const Matrix transposed = k.transpose();
    std::vector<Eigen::Index> rigid;
    for (Eigen::Index i = own; i < k.rows(); ++i)
        if (k.coeff(i, i) == 0) rigid.push_back(i);
    const Eigen::Index count = static_cast<Eigen::Index>(rigid.size()), others = multipliers - count;
    if (count == 0) return others;
    constexpr bool sparse = std::is_same_v<typename Matrix::StorageKind, Eigen::Sparse>;
    if (!sparse || count <= 500) {
        Eigen::MatrixXd gradients(count, own);
        for (Eigen::Index r = 0; r < count; ++r)
            gradients.row(r) = Eigen::VectorXd(transposed.col(rigid[static_cast<std::size_t>(r)])).head(own);
        return others + gradients.colPivHouseholderQr().rank();
    }
    if constexpr (sparse) {
        // Gram's matrix of the rows, each of length 1: a pivot next to 0 is a row that depends on those before it
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index r = 0; r < count; ++r) {
            const Eigen::Index column = rigid[static_cast<std::size_t>(r)];
            double square = 0;
            for (typename Matrix::InnerIterator entry(transposed, column); entry; ++entry)
                if (entry.row() < own) square += entry.value() * entry.value();
            for (typename Matrix::InnerIterator entry(transposed, column); entry; ++entry)
                if (entry.row() < own && square > 0) entries.emplace_back(entry.row(), r, entry.value() / std::sqrt(square));
        }
        Eigen::SparseMatrix<double> rows(own, count);
        rows.setFromTriplets(entries.begin(), entries.end());
        Eigen::SparseMatrix<double> gram = rows.transpose() * rows;
        for (Eigen::Index r = 0; r < count; ++r) gram.coeffRef(r, r) += 1e-14;  // no pivot is 0 itself
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(gram);
        return others + (ldlt.vectorD().array() > 1e-12).count();
    }
}

}  // namespace equilibria::detail
