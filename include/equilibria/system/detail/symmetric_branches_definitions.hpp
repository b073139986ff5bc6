/// \file
/// See system/symmetric_branches.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/eigenvalues.hpp>
#include <equilibria/system/symmetric_branches.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::vector<RuntimeArray<double>> symmetric_branches(const ModelPolynomials& model) {
    std::vector<RuntimeArray<double>> branches;
    if (!model.reflection_symmetric()) return branches;
    const int n = model.sizes().angles;
    for (unsigned bits = 0; bits < 1u << n; ++bits) {
        RuntimeArray<double> q(n);
        for (int i = 0; i < n; ++i) q[i] = bits >> i & 1 ? std::numbers::pi : 0;
        branches.push_back(std::move(q));
    }
    return branches;
}

EQUILIBRIA_INLINE bool on_symmetric_branch(const ModelPolynomials& model, const RuntimeArray<double>& q,
                                           double tolerance) {
    if (!model.reflection_symmetric()) return false;
    for (const double angle : q)
        if (!(std::abs(std::sin(angle)) <= tolerance)) return false;
    return true;
}

EQUILIBRIA_INLINE std::vector<double> polynomial_roots(const std::function<double(double)>& f, int degree, double low,
                                                       double high) {
    const int m = degree + 1;
    const auto to_interval = [&](double t) { return 0.5 * (low + high) + 0.5 * (high - low) * t; };
    Eigen::VectorXd values(m), c = Eigen::VectorXd::Zero(m);
    for (int k = 0; k < m; ++k) values(k) = f(to_interval(std::cos(std::numbers::pi * (k + 0.5) / m)));
    for (int j = 0; j < m; ++j) {
        for (int k = 0; k < m; ++k) c(j) += values(k) * std::cos(std::numbers::pi * j * (k + 0.5) / m);
        c(j) *= (j == 0 ? 1.0 : 2.0) / m;
    }
    int d = degree;
    while (d > 0 && std::abs(c(d)) <= 1e-13 * c.cwiseAbs().maxCoeff()) --d;
    std::vector<double> roots;
    if (d == 0) return roots;
    const auto size = static_cast<std::size_t>(d);
    std::vector<double> colleague(size * size);
    const auto entry = [&](int i, int j) -> double& { return colleague[static_cast<std::size_t>(i * d + j)]; };
    for (int k = 0; k < d; ++k) {
        if (k > 0) entry(k, k - 1) = k == d - 1 && d == 1 ? 1 : 0.5;
        if (k + 1 < d) entry(k, k + 1) = k == 0 ? 1 : 0.5;
    }
    for (int k = 0; k < d; ++k) entry(d - 1, k) -= (d == 1 ? 1.0 : 0.5) * c(k) / c(d);
    for (const std::complex<double>& t : eigenvalues(size, std::move(colleague))) {
        // a double root may come out as a pair with an imaginary part of sqrt(epsilon)
        if (std::abs(t.imag()) < 1e-7 && std::abs(t.real()) <= 1 + 1e-12)
            roots.push_back(to_interval(std::clamp(t.real(), -1.0, 1.0)));
    }
    std::sort(roots.begin(), roots.end());
    return roots;
}

EQUILIBRIA_INLINE std::vector<double> singular_points_of_branch(const ModelDerivatives<>& functions,
                                                                const RuntimeArray<double>& branch,
                                                                RuntimeArray<double> p, int active, int degree,
                                                                const Interval& range) {
    const auto [low, high] = range;
    const auto determinant = [&](double value) {
        p[active] = value;
        const auto j = jacobian(functions, branch, p);
        Eigen::MatrixXd a(j.size(), j.size());
        for (int r = 0; r < j.size(); ++r)
            for (int c = 0; c < j.size(); ++c) a(r, c) = j[r][c];
        return detail::determinant(a);
    };
    // pieces that shrink towards 0: the roots of a wide segment differ by orders of magnitude
    std::vector<double> ends{low, high}, roots;
    for (double end = std::max(std::abs(low), std::abs(high)) / 4; end > 1; end /= 4)
        for (const double edge : {-end, end})
            if (edge > low && edge < high) ends.push_back(edge);
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        for (const double root : polynomial_roots(determinant, branch.size() * degree, ends[k], ends[k + 1]))
            // at an edge both pieces have it
            if (k == 0 || roots.empty() || root > ends[k] + 1e-9 * std::abs(ends[k]) ||
                std::abs(roots.back() - root) > 1e-9 * std::abs(root))
                roots.push_back(root);
    return roots;
}

}  // namespace equilibria
