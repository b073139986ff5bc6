/// \file
/// The number of negative eigenvalues of the Hessian at a real root, proved.
///
/// Krawczyk's test shows that every matrix in the hull of the Jacobians over its polydisc is regular. Along a path of
/// regular symmetric matrices no eigenvalue changes sign, so the Hessian at the root has the inertia of the one at the
/// centre, A. With A = Q D Q^T + R, Q regular and |Y R B| small enough for the matrices between A and Q D Q^T to be
/// regular as well, that is the inertia of the diagonal matrix D, by Sylvester's law.
#pragma once

#include <optional>

#include <Eigen/Core>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/core/symmetric_eigen.hpp>

namespace equilibria {

namespace detail {

/// The number of negative entries d(m) where A, the Hessian at the centre of lane k, is Q diag(d) Q^T closely enough;
/// nothing where that cannot be shown. Q is known to be regular.
template <class R, class Matrix, class Diagonal>
std::optional<int> index_of_congruent(const KrawczykResult<R>& root, int k, const Matrix& q, const Diagonal& d) {
    using S = typename LaneTraits<R>::Scalar;
    const int n = root.radius.size();
    const auto size = [](const S& x) { return x < 0 ? S(-x) : x; };
    const S unit = (n + 6) * rounding_unit<S>;
    Matrix rest(n, n);  // |A - Q D Q^T|
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            const S a = lane(root.jacobian[r][c].re, k);
            S sum(0), sizes(0);
            for (int m = 0; m < n; ++m) {
                const S product = q(r, m) * d(m) * q(c, m);
                sum += product;
                sizes += size(product);
            }
            rest(r, c) = rounded_up<S>(size(S(a - sum)) + unit * (size(a) + sizes));
        }
    Matrix turned(n, n);  // rest |B|
    for (int m = 0; m < n; ++m)
        for (int c = 0; c < n; ++c) {
            turned(m, c) = S(0);
            for (int l = 0; l < n; ++l) turned(m, c) += rest(m, l) * size(lane(root.basis[l][c].re, k));
        }
    int negative = 0;
    for (int r = 0; r < n; ++r) {
        if (!(d(r) != 0)) return {};
        negative += d(r) < 0;
        // row r of (E + |Y| rest |B|) weight < weight
        S sum(0);
        for (int c = 0; c < n; ++c) {
            S entry = lane(root.contraction[r][c], k);
            for (int m = 0; m < n; ++m)
                entry += magnitude_bound(Complex<S>(lane(root.inverse[r][m].re, k), S(0))) * turned(m, c);
            sum += entry * lane(root.weight[c], k);
        }
        if (!(rounded_up<S>(sum * (1 + 2 * unit)) < lane(root.weight[r], k))) return {};
    }
    return negative;
}

}  // namespace detail

/// The index of the root that lane k proves, or nothing where it cannot be proved. The test was made with real = true,
/// and the system has a potential. By A = L D L^T without pivoting, whose L is regular as it stands; where a pivot is
/// too small for that, by the eigenvectors.
template <class R>
std::optional<int> proved_index(const KrawczykResult<R>& root, int k) {
    using S = typename LaneTraits<R>::Scalar;
    using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    const int n = root.radius.size();
    Matrix a(n, n), q = Matrix::Identity(n, n);
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) a(r, c) = lane(root.jacobian[r][c].re, k);
    Matrix left = a;
    for (int m = 0; m < n; ++m)
        for (int r = m + 1; r < n; ++r) {
            q(r, m) = left(r, m) / left(m, m);
            for (int c = m + 1; c <= r; ++c) left(r, c) -= q(r, m) * left(c, m);
        }
    if (const auto index = detail::index_of_congruent(root, k, q, left.diagonal())) return index;

    q = Matrix::Identity(n, n);
    detail::diagonalize(a, &q);
    // whether Q^T Q is so close to 1 that Q is regular
    const auto size = [](const S& x) { return x < 0 ? S(-x) : x; };
    const S unit = (n + 6) * rounding_unit<S>;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            S gram(r == c ? -1 : 0), sizes(r == c ? 1 : 0);
            for (int m = 0; m < n; ++m) {
                const S square = q(m, r) * q(m, c);
                gram += square;
                sizes += size(square);
            }
            if (!(size(gram) + unit * sizes < S(0.5) / n)) return {};
        }
    return detail::index_of_congruent(root, k, q, a.diagonal());
}

}  // namespace equilibria
