/// \file
/// Opt-in: SparseLDLT in an order of nested dissection, by METIS. Needs METIS 5 (Debian: libmetis-dev), linked with
/// -lmetis.
///
///     const Structure shell(model, {.factors = sparse_ldlt_by_nested_dissection});
///
/// The order takes longer to find than by minimum degree, once a branch, and leaves fewer entries of meshes of two and
/// three dimensions. Sources: George, Nested dissection of a regular finite element mesh, SIAM J. Numer. Anal. 10
/// (1973); Karypis, Kumar, A fast and high quality multilevel scheme for partitioning irregular graphs, SIAM J. Sci.
/// Comput. 20 (1998).
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <metis.h>
#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/sparse_ldlt.hpp>

namespace equilibria {

/// An EliminationOrder. Throws std::runtime_error where METIS has no memory.
inline std::vector<int> nested_dissection(const SymmetricFactors::Matrix& k) {
    auto n = static_cast<idx_t>(k.rows());
    const auto size = static_cast<std::size_t>(n);
    std::vector<idx_t> first{0}, neighbours, unknown(size), place(size);
    for (int c = 0; c < k.outerSize(); ++c) {
        for (SymmetricFactors::Matrix::InnerIterator entry(k, c); entry; ++entry)
            if (entry.row() != c) neighbours.push_back(static_cast<idx_t>(entry.row()));
        first.push_back(static_cast<idx_t>(neighbours.size()));
    }
    const int status =
        METIS_NodeND(&n, first.data(), neighbours.data(), nullptr, nullptr, unknown.data(), place.data());
    if (status != METIS_OK) throw std::runtime_error("METIS: NodeND ended with status " + std::to_string(status));
    return {unknown.begin(), unknown.end()};
}

/// What a problem names to have its tangents factored so.
inline std::unique_ptr<SymmetricFactors> sparse_ldlt_by_nested_dissection(int multipliers) {
    return std::make_unique<SparseLDLT>(multipliers, nested_dissection);
}

}  // namespace equilibria
