/// \file
/// Newton's method over any real scalar type, on the equations with exactly known coefficients: to bring a root to the
/// digits that a proof needs.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/evaluation/point_of.hpp>

namespace equilibria {

/// The unknowns of a root, complex angles in radians, then coordinates, over S, which has at least the digits of
/// double: where Newton's method starts.
template <class S>
ComplexUnknowns<RuntimeUnknowns, S> complex_unknowns(std::span<const std::complex<double>> q) {
    std::vector<Complex<S>> y;
    for (const auto& z : q) y.emplace_back(S(z.real()), S(z.imag()));
    return ComplexUnknowns<RuntimeUnknowns, S>(std::move(y));
}

/// Improves q until a step changes nothing that S can hold beside the condition of the root, or `most` steps. Returns
/// the size of the last step, NaN where the Jacobian is singular.
template <class S>
S newton(const BallSystem<S>& system, std::type_identity_t<std::span<Complex<S>>> q, int most) {
    using std::sqrt;
    const int n = system.sizes.unknowns;
    FactorBalls<S> at(system);
    SizedArray<Ball<S>, at_run_time> f(n);
    RuntimeMatrix<Ball<S>> j(n);
    RuntimeMatrix<Complex<S>> mid(n);
    SizedArray<Complex<S>, at_run_time> unknowns(n), d(n);
    PivotedFactorization<S> lu(n);
    S size(0), before(0);
    for (int step = 0; step < most; ++step) {
        std::copy(q.begin(), q.end(), unknowns.begin());
        at.enclose(point_of<RuntimeUnknowns, S>(unknowns, system.sizes), false);
        ball_values(system, at, f);
        ball_jacobian(system, at, j);
        for (int r = 0; r < n; ++r) {
            d[r] = -f[r].mid;
            for (int c = 0; c < n; ++c) mid[r][c] = j[r][c].mid;
        }
        lu.factor(mid);
        lu.solve(d);
        before = size;
        size = S(0);
        for (int u = 0; u < n; ++u) {
            q[static_cast<std::size_t>(u)] += d[u];
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
