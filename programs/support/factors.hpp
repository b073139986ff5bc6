// What factors the tangents of a large structure, see continuation/factorization/symmetric_factors.hpp.
#pragma once

#include <equilibria/continuation/factorization/sparse_ldlt.hpp>
#include <equilibria/fem/structure.hpp>
#ifdef EQUILIBRIA_WITH_MUMPS
#include <equilibria/continuation/factorization/mumps.hpp>
#endif

namespace support {

/// MUMPS where the program was built with it and the factors have many entries a column, as those of shells and
/// gridshells have, not of frames, however large; null: SparseLDLT.
inline equilibria::MakeSymmetricFactors factors_for([[maybe_unused]] const equilibria::fem::Structure& structure) {
#ifdef EQUILIBRIA_WITH_MUMPS
    constexpr int large = 10000, many = 60;
    if (structure.size() < large) return nullptr;
    equilibria::SparseLDLT ldlt(structure.multipliers());
    ldlt.factor(structure.tangent(structure.initial(), 0));
    if (ldlt.fill() > many * static_cast<Eigen::Index>(structure.size())) return equilibria::mumps;
#endif
    return nullptr;
}

}  // namespace support
