/// \file
/// Newton's method over any real scalar type, on the equations with exactly known coefficients: to bring a root to the
/// digits that a proof needs.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/evaluation/point_of.hpp>

namespace equilibria {

template <class M, class S>
ComplexUnknowns<M, S> unknowns_of(const Array<std::complex<double>, n_unknowns<M>>& q) {
    ComplexUnknowns<M, S> y;
    for (int u = 0; u < q.size(); ++u) y[u] = Complex<S>(S(q[u].real()), S(q[u].imag()));
    return y;
}

/// Improves q until a step changes nothing that S can hold beside the condition of the root, or `most` steps. Returns
/// the size of the last step, NaN where the Jacobian is singular.
template <class M, class S>
S newton(const BallSystem<M, S>& system, ComplexUnknowns<M, S>& q, int most) {
    using std::sqrt;
    constexpr int n = n_unknowns<M>;
    S size(0), before(0);
    for (int step = 0; step < most; ++step) {
        const FactorBalls<M, S> at(system, point_of<M, S>(q), false);
        Ball<S> f[n], j[n][n];
        ball_values(system, at, f);
        ball_jacobian(system, at, j);
        Complex<S> mid[n][n], d[n];
        for (int r = 0; r < n; ++r) {
            d[r] = -f[r].mid;
            for (int c = 0; c < n; ++c) mid[r][c] = j[r][c].mid;
        }
        PivotedFactorization<S, n> lu;
        lu.factor(mid);
        lu.solve(d);
        before = size;
        size = S(0);
        for (int u = 0; u < n; ++u) {
            q[u] += d[u];
            const S one = sqrt(norm2(d[u]));
            if (!(one <= size)) size = one;
        }
        if (!(size < S(1e3))) break;
        if (size < 4 * rounding_unit<S>) break;
        if (step > 2 && size > before / 2 && size < sqrt(rounding_unit<S>)) break;  // rounding, no progress any more
    }
    return size;
}

}  // namespace equilibria
