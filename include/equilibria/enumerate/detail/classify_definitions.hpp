/// \file
/// See enumerate/classify.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/core/eigenvalues.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/stability/inertia.hpp>

namespace equilibria::detail {

EQUILIBRIA_INLINE bool is_real(const RealEquations& equations, const RootView& root, std::span<double> q) {
    const auto n = q.size(), angles = static_cast<std::size_t>(equations.sizes.angles);
    double imaginary = 0;
    for (const auto& z : root.q) imaginary = std::max(imaginary, std::abs(z.imag()));
    if (!(imaginary < 1e-5)) return false;
    for (std::size_t u = 0; u < n; ++u) q[u] = root.q[u].real();
    if (root.singular) return true;
    const auto size_of = static_cast<Eigen::Index>(n);
    Eigen::VectorXd f(size_of);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(size_of, size_of);
    double moved = 0;
    for (int round = 0; round < 3; ++round) {
        equations.linearize(q.data(), f.data(), jacobian.data());
        const Eigen::VectorXd step = jacobian.partialPivLu().solve(f);
        if (!std::isfinite(step.sum())) return imaginary < 1e-12;
        const double size = step.cwiseAbs().maxCoeff();
        for (std::size_t u = 0; u < n; ++u) q[u] -= step[static_cast<Eigen::Index>(u)];
        moved += size;
        if (moved > 1e-4) return false;
        if (size < 1e-15) break;
    }
    for (std::size_t u = 0; u < angles; ++u) {
        q[u] = std::remainder(q[u], 2 * std::numbers::pi);
        if (q[u] <= -std::numbers::pi) q[u] = std::numbers::pi;
    }
    // the real Newton iteration moves by the size of the imaginary part if root and conjugate are two, and by rounding
    // if they are one
    return imaginary <= 1e-13 * root.condition + 1e-12;
}

EQUILIBRIA_INLINE Classification classified(const RealEquations& equations, std::span<const double> q) {
    const auto n = static_cast<Eigen::Index>(q.size());
    Eigen::VectorXd f(n);
    Eigen::MatrixXd jacobian(n, n);
    equations.linearize(q.data(), f.data(), jacobian.data());
    jacobian.transposeInPlace();
    Classification y;
    y.energy = equations.energy(q.data());
    if (equations.has_potential) {
        const Inertia hessian = inertia(jacobian);
        y.index = hessian.negative;
        y.nullity = hessian.zero;
        y.margin = hessian.margin;
        return y;
    }
    const auto values = eigenvalues<double>(static_cast<int>(n), {jacobian.data(), jacobian.data() + jacobian.size()});
    double largest = 0, smallest = std::numeric_limits<double>::infinity();
    for (const auto& z : values) {
        largest = std::max(largest, std::abs(z));
        smallest = std::min(smallest, std::abs(z));
    }
    for (const auto& z : values)
        if (!(std::abs(z) > zero_eigenvalue * largest))
            ++y.nullity;
        else
            y.index += z.real() < 0;
    y.margin = largest > 0 ? smallest / largest : 0;
    return y;
}

}  // namespace equilibria::detail
