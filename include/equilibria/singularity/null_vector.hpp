/// \file
/// The null vectors of the Jacobian J at a degenerate equilibrium: the right singular vectors of its smallest singular
/// values, by one-sided Jacobi rotations (core/singular_values.hpp). J is symmetric or not, and not squared, so that a
/// vector is as exact as J is. What the sign is, and which basis of a plane, is left to the rotations.
/// Where it fails: away from degenerate equilibria the vector is the direction that J shortens most, no more.
/// Source: Golub and Van Loan, Matrix Computations, 8.6.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model_functions.hpp>

namespace equilibria {

/// The unit vectors, orthogonal to each other, that J shortens most, the most shortened one first; NaN where an entry
/// of J is not finite. count: at most as many as J has columns.
std::vector<RuntimeArray<double>> null_vectors(const RuntimeMatrix<double>& j, int count);

/// The unit vector v of least |J v|: the null vector where J is singular.
RuntimeArray<double> null_vector(const RuntimeMatrix<double>& j);

/// The unit vector u of least |u^T J| on the side of the null vector v, u . v >= 0: v itself where J is symmetric.
RuntimeArray<double> left_null_vector(const RuntimeMatrix<double>& j, const RuntimeArray<double>& v, bool symmetric);

/// The number of singular values of J that are 0 to 1e-8 of `scale`, or of the largest one.
int nullity(const RuntimeMatrix<double>& j, double scale);

/// The same of a model, whose J is symmetric where it has a potential.
/// \{
template <int Count, Model M>
Array<Unknowns<M>, Count> null_vectors(const UnknownMatrix<M>& j) {
    static_assert(Count <= n_unknowns<M>, "equilibria: no more null vectors than unknowns");
    const auto found = null_vectors(runtime_matrix(j), Count);
    Array<Unknowns<M>, Count> y;
    for (int c = 0; c < Count; ++c) y[c] = unknowns_from<M>(found[static_cast<std::size_t>(c)]);
    return y;
}
template <Model M>
Unknowns<M> null_vector(const UnknownMatrix<M>& j) {
    return null_vectors<1, M>(j)[0];
}
template <Model M>
Unknowns<M> left_null_vector(const UnknownMatrix<M>& j, const Unknowns<M>& v) {
    return unknowns_from<M>(left_null_vector(runtime_matrix(j), runtime_array(v), PotentialModel<M>));
}
template <Model M>
int nullity(const UnknownMatrix<M>& j, double scale) {
    return nullity(runtime_matrix(j), scale);
}
/// \}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/singularity/detail/null_vector_definitions.hpp>
#endif
