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

/// The index of the root that lane k proves, or nothing where it cannot be proved. The test was made with real = true,
/// and the system has a potential.
template <class R>
std::optional<int> proved_index(const KrawczykResult<R>& root, int k) {
    using S = typename LaneTraits<R>::Scalar;
    using Matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    const int n = root.radius.size();
    const auto size = [](const S& x) { return x < 0 ? S(-x) : x; };
    const auto a = [&](int r, int c) -> S { return lane(root.jacobian[r][c].re, k); };
    Matrix diagonal(n, n), q = Matrix::Identity(n, n);
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) diagonal(r, c) = a(r, c);
    detail::diagonalize(diagonal, &q);
    const S unit = (n + 6) * rounding_unit<S>;
    // |A - Q D Q^T|, and whether Q^T Q is so close to 1 that Q is regular
    Matrix rest(n, n);
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            S sum(0), sizes(0), gram(r == c ? -1 : 0), gram_sizes(r == c ? 1 : 0);
            for (int m = 0; m < n; ++m) {
                const S product = q(r, m) * diagonal(m, m) * q(c, m), square = q(m, r) * q(m, c);
                sum += product;
                sizes += size(product);
                gram += square;
                gram_sizes += size(square);
            }
            rest(r, c) = rounded_up<S>(size(S(a(r, c) - sum)) + unit * (size(a(r, c)) + sizes));
            if (!(size(gram) + unit * gram_sizes < S(0.5) / n)) return {};
        }
    int negative = 0;
    for (int r = 0; r < n; ++r) {
        if (!(diagonal(r, r) != 0)) return {};
        negative += diagonal(r, r) < 0;
        // row r of (E + |Y| rest |B|) weight < weight
        S sum(0);
        for (int c = 0; c < n; ++c) {
            S entry = lane(root.contraction[r][c], k);
            for (int m = 0; m < n; ++m) {
                S turned(0);
                for (int l = 0; l < n; ++l) turned += rest(m, l) * size(lane(root.basis[l][c].re, k));
                entry += magnitude_bound(Complex<S>(lane(root.inverse[r][m].re, k), S(0))) * turned;
            }
            sum += entry * lane(root.weight[c], k);
        }
        if (!(rounded_up<S>(sum * (1 + 2 * unit)) < lane(root.weight[r], k))) return {};
    }
    return negative;
}

}  // namespace equilibria
