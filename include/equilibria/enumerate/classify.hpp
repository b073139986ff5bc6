/// \file
/// From roots to equilibria: filtered to real ones, classified.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <tuple>
#include <vector>

#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/eigenvalues.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/stability/inertia.hpp>

namespace equilibria::detail {

template <Model M>
double largest_imaginary(const Root<M>& root) {
    double y = 0;
    for (const auto& q : root.q) y = std::max(y, std::abs(q.imag()));
    return y;
}

/// Whether a root is real, by Newton's method in real arithmetic from its real part: a regular root whose imaginary
/// part is rounding is reached again. On success q is the real root.
template <Model M>
bool is_real(const Root<M>& root, const Parameters<M>& p, Unknowns<M>& q) {
    const double imaginary = largest_imaginary(root);
    if (!(imaginary < 1e-5)) return false;
    for (int u = 0; u < n_unknowns<M>; ++u) q[u] = root.q[u].real();
    if (root.status == PathStatus::singular) return true;
    double moved = 0;
    for (int round = 0; round < 3; ++round) {
        const auto f = equations<M, double>(q, p);
        const auto j = jacobian<M, double>(q, p);
        Array<Array<double, n_unknowns<M>>, n_unknowns<M>> matrix;
        for (int r = 0; r < n_unknowns<M>; ++r)
            for (int c = 0; c < n_unknowns<M>; ++c) matrix[r][c] = j(r, c);
        const Unknowns<M> step = DenseFactorization<double, n_unknowns<M>>(matrix).solve(f);
        double size = 0, sum = 0;
        for (const double d : step) size = std::max(size, std::abs(d)), sum += d;
        if (!std::isfinite(sum)) return imaginary < 1e-12;
        for (int u = 0; u < n_unknowns<M>; ++u) q[u] -= step[u];
        moved += size;
        if (moved > 1e-4) return false;
        if (size < 1e-15) break;
    }
    for (int u = 0; u < n_angles<M>; ++u) q[u] = std::remainder(q[u], 2 * std::numbers::pi);
    for (int u = 0; u < n_angles<M>; ++u)
        if (q[u] <= -std::numbers::pi) q[u] = std::numbers::pi;
    // the real Newton iteration moves by the size of the imaginary part if root and conjugate are two, and by rounding
    // if they are one
    return imaginary <= 1e-13 * root.condition + 1e-12;
}

template <Model M>
Equilibrium<M> classified(const Root<M>& root, const Unknowns<M>& q, const Parameters<M>& p) {
    Equilibrium<M> e;
    e.q = q;
    e.residual = root.residual;
    e.condition = root.condition;
    e.path = root.path;
    e.multiplicity = root.paths;
    const UnknownMatrix<M> j = jacobian<M, double>(q, p);
    if constexpr (PotentialModel<M>) {
        e.energy = potential<M, double>(q, p);
        const Inertia inertia_of_hessian = inertia(j);
        e.index = inertia_of_hessian.negative;
        e.nullity = inertia_of_hessian.zero;
        e.margin = inertia_of_hessian.margin;
    } else {
        e.energy = std::numeric_limits<double>::quiet_NaN();
        const auto values = eigenvalues<double>(n_unknowns<M>, {j.data(), j.data() + j.size()});
        double largest = 0, smallest = std::numeric_limits<double>::infinity();
        for (const auto& z : values) {
            largest = std::max(largest, std::abs(z));
            smallest = std::min(smallest, std::abs(z));
        }
        for (const auto& z : values)
            if (!(std::abs(z) > zero_eigenvalue * largest))
                ++e.nullity;
            else
                e.index += z.real() < 0;
        e.margin = largest > 0 ? smallest / largest : 0;
    }
    if (root.status == PathStatus::singular && e.nullity == 0) e.nullity = 1;
    return e;
}

/// The real roots among roots, classified.
template <Model M>
struct RealRoots {
    std::vector<Equilibrium<M>> equilibria;  ///< by index, then nullity, then path
    /// The largest imaginary part among the real roots, the smallest among the others (infinity where there are none).
    double largest_real_imaginary = 0, smallest_nonreal_imaginary = std::numeric_limits<double>::infinity();
};

template <Model M>
RealRoots<M> classify(const std::vector<Root<M>>& roots, const Parameters<M>& p, const Executor& executor) {
    std::vector<std::uint8_t> real(roots.size());
    std::vector<Unknowns<M>> at(roots.size());
    executor.for_blocks(roots.size(), 4096, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) real[k] = is_real(roots[k], p, at[k]);
    });
    RealRoots<M> y;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const double imaginary = largest_imaginary(roots[k]);
        if (real[k]) {
            y.equilibria.push_back(classified(roots[k], at[k], p));
            y.largest_real_imaginary = std::max(y.largest_real_imaginary, imaginary);
        } else {
            y.smallest_nonreal_imaginary = std::min(y.smallest_nonreal_imaginary, imaginary);
        }
    }
    const auto order = [](const Equilibrium<M>& e) { return std::tuple(e.index, e.nullity, e.path); };
    std::sort(y.equilibria.begin(), y.equilibria.end(),
              [&](const auto& a, const auto& b) { return order(a) < order(b); });
    return y;
}

}  // namespace equilibria::detail
