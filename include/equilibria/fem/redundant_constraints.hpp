/// \file
/// Constraints that say what others say already: over-constrained mechanisms, whose multipliers have no values. A dead
/// point looks the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseQR>

#include <equilibria/fem/structure.hpp>

namespace equilibria::fem {

struct RedundantConstraints {
    int constraints = 0;           ///< how many could be redundant
    std::vector<int> multipliers;  ///< of those that depend on earlier ones, from 0, rising
};

/// Which constraints' gradients depend on those before them; k: the structure's tangent. Multipliers with a flexibility
/// of their own, as MixedBeam has where it is not rigid, are independent of all others. Where more than `most`
/// constraints are left they are not looked at, and none is named: the time may grow with the cube of their number.
template <bool Conservative>
RedundantConstraints redundant_constraints(const BasicStructure<Conservative>& structure,
                                           const Eigen::SparseMatrix<double>& k, int most = 2000) {
    const int own = structure.size() - structure.multipliers();
    Eigen::VectorXd unit = Eigen::VectorXd::Ones(own);  // displacements are measured in the structure's length
    for (int node = 0; node < structure.model().nodes(); ++node)
        for (const Component c : positions)
            if (const int i = structure.unknown(node, c); i >= 0) unit(i) = structure.length();

    // gradients are K's last columns, and flexibilities their diagonal
    RedundantConstraints y;
    std::vector<int> which;
    std::vector<Eigen::Triplet<double>> entries;
    for (int m = 0; m < structure.multipliers(); ++m) {
        double size = 0, flexibility = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator it(k, own + m); it; ++it) {
            if (it.row() < own) size = std::hypot(size, unit(it.row()) * it.value());
            if (it.row() == own + m) flexibility = std::abs(it.value());
        }
        if (flexibility > 1e-12 * size) continue;
        for (Eigen::SparseMatrix<double>::InnerIterator it(k, own + m); it; ++it)
            if (it.row() < own && it.value() != 0)
                entries.emplace_back(it.row(), y.constraints, unit(it.row()) * it.value() / size);
        which.push_back(m);
        ++y.constraints;
    }
    if (y.constraints == 0 || y.constraints > most) return y;
    Eigen::SparseMatrix<double> gradients(own, y.constraints);
    gradients.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>> qr;
    qr.setPivotThreshold(1e-9);
    qr.compute(gradients);
    for (Eigen::Index i = qr.rank(); i < y.constraints; ++i)  // those come last
        y.multipliers.push_back(which[static_cast<std::size_t>(qr.colsPermutation().indices()(i))]);
    std::sort(y.multipliers.begin(), y.multipliers.end());
    return y;
}

}  // namespace equilibria::fem
