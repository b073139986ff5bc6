/// \file
/// What changes between two points of a branch.
#pragma once

#include <cstdlib>

#include <equilibria/continuation/branch_point.hpp>

namespace equilibria::detail {

/// Whether p turns back between two points of a branch.
inline bool folds(const BranchPoint<Erased>& a, const BranchPoint<Erased>& b) {
    return (a.tangent.p < 0) != (b.tangent.p < 0);
}
/// How many eigenvalues change sign between them, as far as it is known.
inline int changes(const BranchPoint<Erased>& a, const BranchPoint<Erased>& b) {
    if (a.negative && b.negative) return std::abs(*b.negative - *a.negative);
    return a.determinant_sign != b.determinant_sign ? 1 : 0;
}

}  // namespace equilibria::detail
