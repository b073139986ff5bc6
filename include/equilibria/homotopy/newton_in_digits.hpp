/// \file
/// Regular solutions that doubles take for singular ones: far out, or where equations are badly scaled.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <equilibria/core/linear_solve.hpp>
#include <equilibria/core/splitmix.hpp>
#include <equilibria/evaluation/point.hpp>
#include <equilibria/homotopy/detail/segments.hpp>

namespace equilibria::detail {

/// Newton's method in R, of more digits than double has, at t = 1.
template <class H, class R>
class NewtonInDigits {
public:
    explicit NewtonInDigits(const H& homotopy)
        : n_(homotopy.sizes().unknowns), evaluation_(homotopy), lu_(n_), f_(n_), j_(n_) {}

    /// Whether q comes as near to a solution as doubles tell, by corrections that are small and of which each is far
    /// smaller than the one before: next to a multiple solution they are halved at best.
    bool settles(RuntimePoint<R>& q) {
        double allowed2 = 1e-6;
        while (true) {
            evaluation_.target_jacobian(q, f_, j_);
            lu_.factor(j_);
            for (int i = 0; i < n_; ++i) f_[i] = -f_[i];
            lu_.solve(f_);
            const auto size2 = static_cast<double>(correction_size(q, f_));
            if (!(size2 < allowed2)) return false;
            correct(q, f_);
            if (size2 < settled * settled) return true;
            allowed2 = 0.01 * size2;  // a tenth of its size
        }
    }
    /// Whether q, which has settled, is settled to again from beside it: not at a multiple solution, nor on a family.
    bool is_regular(const RuntimePoint<R>& q) {
        RuntimePoint<R> beside = q;
        std::uint64_t state = 1;
        for (int u = 0; u < n_; ++u) {
            const int x = u - q.c.size();
            const double angle = 2 * std::numbers::pi * unit_interval(splitmix64(state));
            const R size = x < 0 ? R(moved) : moved * R(1.0 + square_root(norm2(q.x[x])));
            f_[u] = {std::cos(angle) * size, std::sin(angle) * size};
        }
        correct(beside, f_);
        return settles(beside) && distance(beside, q) < 1e-3 * moved;
    }

private:
    // a regular solution of condition 1e12 draws points to it from 1e-12, and the result is rounded to double
    static constexpr double moved = 1e-14, settled = 1e-16;

    int n_;
    typename H::template Evaluation<R, Complex<R>> evaluation_;
    PivotedFactorization<R> lu_;
    RuntimeArray<Complex<R>> f_;
    RuntimeMatrix<Complex<R>> j_;
};

/// Whether a regular solution is next to q at t = 1, whatever its condition; q becomes it. Newton's method in R comes
/// to it quadratically, and again from a point beside it: to a multiple solution it converges linearly, and on a family
/// to some other point.
template <class H, class R>
bool converges_in_digits(const H& homotopy, RuntimePoint<R>& q) {
    NewtonInDigits<H, R> newton(homotopy);
    RuntimePoint<R> at = q;
    if (!newton.settles(at) || !(distance(at, q) < 1e-3) || !newton.is_regular(at)) return false;
    q = at;
    return true;
}

}  // namespace equilibria::detail
