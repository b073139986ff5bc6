/// \file
/// Proofs about the complex roots of a system that is data: that each exists, is distinct from the others, is real or
/// not; and, where a proved bound is reached, that none is missing. As `prove` of a model's equilibria (prove.hpp),
/// without an index. The proof is of the system with its coefficients as the doubles that they are: decimal fractions
/// of a file were rounded when they were read.
///
/// Where a system has fewer roots than all bounds, all of them may be proved and the set is not. Singular roots, and
/// curves of roots, are never proved.
#pragma once

#include <vector>

#include <equilibria/certify/exact_system.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// The terms of the system, exactly.
ExactTerms exact_terms(const SparseSystem& system);

/// By Bezout's theorem, on the degrees that the system's terms have: the total degree, where it can be counted, and the
/// smallest multihomogeneous number where it is less.
std::vector<ProvedBound> bezout_bounds(const SparseSystem& system);

/// Those, and the mixed volume (Bernstein's theorem), where it could be computed.
std::vector<ProvedBound> proved_bounds(const SparseSystem& system);

/// Proves what can be proved of the roots of a system. bounds: theorems' upper bounds of the number of its isolated
/// complex roots; the smallest counts. `contradictions` counts the roots that are proved real, though an imaginary part
/// is 1e-8 of 1 + |x| or more, and those proved non-real though none is. Throws InvalidArgument for options out of
/// range, and for a run with a checkpoint or a cancel.
ProofOfRoots prove(const SparseSystem& system, const ComplexRoots<>& found, const std::vector<ProvedBound>& bounds,
                   const RunOptions& run = {}, const ProveOptions& options = {});

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/enumerate/detail/prove_complex_roots_definitions.hpp>
#endif
