/// \file
/// See system/unit_scaling.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <equilibria/system/unit_scaling.hpp>

namespace equilibria {

namespace detail {

/// The power of two by which a term's coefficient is multiplied.
EQUILIBRIA_INLINE int scaling_of(const SparseTerm& term, const UnitScaling& units) {
    int y = units.equation[static_cast<std::size_t>(term.equation)];
    for (int u = 0; u < term.monomial.size(); ++u)
        y += term.monomial.code(u) * units.unknown[static_cast<std::size_t>(u)];
    return y;
}

}  // namespace detail

EQUILIBRIA_INLINE bool UnitScaling::trivial() const {
    const auto zero = [](int e) { return e == 0; };
    return std::all_of(unknown.begin(), unknown.end(), zero) && std::all_of(equation.begin(), equation.end(), zero);
}

EQUILIBRIA_INLINE void UnitScaling::undo(std::span<std::complex<double>> q) const {
    for (std::size_t u = 0; u < q.size(); ++u)
        q[u] = {std::ldexp(q[u].real(), unknown[u]), std::ldexp(q[u].imag(), unknown[u])};
}

EQUILIBRIA_INLINE UnitScaling unit_scaling(const SparseSystem& system) {
    const int n = system.sizes().unknowns, angles = system.sizes().angles, m = n - angles;
    const auto size = static_cast<std::size_t>(n);
    // normal equations of: log2 |a| + e_i + sum_u k_u s_u = 0 for each term; s is held at 0 weakly
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
    normal.diagonal().tail(m).setConstant(1e-6);
    Eigen::VectorXd row(n + m);
    for (const SparseTerm& term : system.terms()) {
        if (term.coefficient == 0) continue;
        row.setZero();
        row(term.equation) = 1;
        for (int u = angles; u < n; ++u) row(n + u - angles) = term.monomial.code(u);
        normal += row * row.transpose();
        right -= std::log2(std::abs(term.coefficient)) * row;
    }
    const Eigen::VectorXd best = normal.ldlt().solve(right);
    UnitScaling y{std::vector<int>(size), std::vector<int>(size)};
    for (int i = 0; i < n; ++i) y.equation[static_cast<std::size_t>(i)] = static_cast<int>(std::lround(best(i)));
    for (int u = angles; u < n; ++u)
        y.unknown[static_cast<std::size_t>(u)] = static_cast<int>(std::lround(best(n + u - angles)));
    const bool exact = std::ranges::all_of(system.terms(), [&](const SparseTerm& term) {
        return term.coefficient == 0 || std::isnormal(std::ldexp(term.coefficient, detail::scaling_of(term, y)));
    });
    if (!exact) return {std::vector<int>(size), std::vector<int>(size)};
    return y;
}

EQUILIBRIA_INLINE SparseSystem scaled(const SparseSystem& system, const UnitScaling& units) {
    std::vector<SparseTerm> terms = system.terms();
    for (SparseTerm& term : terms) term.coefficient = std::ldexp(term.coefficient, detail::scaling_of(term, units));
    return {system.sizes(), std::move(terms)};
}

}  // namespace equilibria
