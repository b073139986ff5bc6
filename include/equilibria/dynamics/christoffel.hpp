/// \file
/// Christoffel symbols of the kinetic energy's metric. Source: Vesovic and Radulovic, "Modelling and
/// stability analysis of the nonlinear system", Theoretical and Applied Mechanics (2022), (1.17) and (*).
#pragma once

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/cholesky.hpp>
#include <equilibria/dynamics/motion_point.hpp>
#include <equilibria/model/kinetics.hpp>

namespace equilibria {

/// One symmetric n x n matrix for each unknown k, with entries (i, j).
template <DynamicModel M>
using ChristoffelSymbols = Array<UnknownMatrix<M>, n_unknowns<M>>;

/// Gamma_ij,k = 1/2 (dM_jk/dq_i + dM_ik/dq_j - dM_ij/dq_k) at entry (i, j) of matrix k: of the first kind.
template <DynamicModel M>
ChristoffelSymbols<M> christoffel_first_kind(const Unknowns<M>& q, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    const auto d = mass_matrix_derivatives<M>(q, p);
    ChristoffelSymbols<M> y;
    for (int k = 0; k < n; ++k)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) y[k](i, j) = 0.5 * (d[i](j, k) + d[j](i, k) - d[k](i, j));
    return y;
}

/// Gamma^k_ij = (M^-1)_kl Gamma_ij,l at entry (i, j) of matrix k: of the second kind. M must be positive definite.
template <DynamicModel M>
ChristoffelSymbols<M> christoffel_second_kind(const Unknowns<M>& q, const Parameters<M>& p) {
    constexpr int n = n_unknowns<M>;
    const auto first = christoffel_first_kind<M>(q, p);
    const UnknownMatrix<M> identity = UnknownMatrix<M>::Identity(),
                           inverse = detail::Cholesky<n>(mass_matrix<M>(q, p)).solve(identity);
    ChristoffelSymbols<M> y;
    for (int k = 0; k < n; ++k) {
        y[k].setZero();
        for (int l = 0; l < n; ++l) y[k] += inverse(k, l) * first[l];
    }
    return y;
}

/// v^T Gamma_k v for each k.
template <DynamicModel M>
detail::UnknownVector<M> contracted(const ChristoffelSymbols<M>& symbols, const detail::UnknownVector<M>& v) {
    detail::UnknownVector<M> y;
    for (int k = 0; k < symbols.size(); ++k) y[k] = v.dot(symbols[k] * v);
    return y;
}

}  // namespace equilibria
