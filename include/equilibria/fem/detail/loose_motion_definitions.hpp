/// \file
/// See fem/loose_motion.hpp.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <equilibria/continuation/factorization/bordered.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/fem/loose_motion.hpp>

namespace equilibria::fem {

template <bool Conservative>
std::optional<LooseMotion> loose_motion(const BasicStructure<Conservative>& structure, const StructureState& q,
                                        double p) {
    using Matrix = Eigen::SparseMatrix<double>;
    const Matrix k = structure.tangent(q, p);
    const Eigen::VectorXd weights = structure.weights(q);
    // inverse iteration; without the disturbance a pivot would be 0
    const Eigen::VectorXd noise =
        1e-15 * equilibria::detail::largest_entry(k) * equilibria::detail::generic_vector(k.rows(), 1);
    Matrix disturbed = k;
    disturbed += Matrix(noise.asDiagonal());
    const Eigen::SparseLU<Matrix> lu(disturbed);
    if (lu.info() != Eigen::Success) return std::nullopt;
    Eigen::VectorXd v = equilibria::detail::generic_vector(k.rows());
    for (int iteration = 0; iteration < 3; ++iteration) v = lu.solve(weights.cwiseProduct(v)).normalized();
    if (!v.allFinite()) return std::nullopt;
    const double energy = v.dot(k * v), terms = v.cwiseAbs().dot(k.cwiseAbs() * v.cwiseAbs());
    // where K has no entries along v there is no rounding either
    const double stiffest = k.diagonal().cwiseAbs().cwiseQuotient(weights).maxCoeff() * weights.dot(v.cwiseAbs2());
    if (std::abs(energy) > 5e-16 * terms + 1e-28 * stiffest) return std::nullopt;

    LooseMotion y;
    double most = 0;
    for (int node = 0; node < structure.model().nodes(); ++node)
        for (const Component c : spatial)
            if (const int i = structure.unknown(node, c); i >= 0)
                if (const double part = std::abs(v(i)) * std::sqrt(weights(i)); part > most) most = part, y = {node, c};
    return y;
}

}  // namespace equilibria::fem
