/// \file
/// Regular solutions that doubles take for singular ones: far out, or where equations are badly scaled.
#pragma once

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/detail/segments.hpp>

namespace equilibria::detail {

/// Whether Newton's method in R converges from q at t = 1, quadratically and next to it: then a regular solution is
/// there, whatever its condition, and q becomes it. (At a multiple one it converges linearly: from a point that is
/// known to more digits than doubles have it does not come closer in a few corrections, so that such a point is moved
/// first.)
template <class H, class R>
bool converges_in_digits(const H& homotopy, RuntimePoint<R>& q) {
    constexpr int most_corrections = 8;
    constexpr double moved = 1e-12, settled = 1e-18;  // eight halvings of the one stay far above the other
    const int n = homotopy.sizes().unknowns;
    typename H::template Evaluation<R, Complex<R>> evaluation(homotopy);
    PivotedFactorization<R> lu(n);
    RuntimeArray<Complex<R>> f(n);
    RuntimeMatrix<Complex<R>> j(n);
    RuntimePoint<R> at = q;
    for (int k = 0; k < most_corrections; ++k) {
        evaluation.target_jacobian(at, f, j);
        if (homotopy.symmetric())
            for (int r = 0; r < n; ++r)
                for (int c = 0; c < r; ++c) j[r][c] = j[c][r];
        lu.factor(j);
        for (int i = 0; i < n; ++i) f[i] = -f[i];
        lu.solve(f);
        const auto size2 = static_cast<double>(correction_size(at, f));
        if (!(size2 < 1e-6)) return false;
        correct(at, f);
        if (k == 0 && size2 < moved * moved) {
            for (int u = 0; u < n; ++u) {
                const int x = u - at.c.size();
                f[u] = Complex<R>(moved) * (x < 0 ? R(1.0) : R(1.0 + square_root(norm2(at.x[x]))));
            }
            correct(at, f);
        } else if (size2 < settled * settled) {
            if (!(distance(at, q) < 1e-3)) return false;
            q = at;
            return true;
        }
    }
    return false;
}

}  // namespace equilibria::detail
