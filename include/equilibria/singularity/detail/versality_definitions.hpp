/// \file
/// See singularity/singularity_evidence.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/singularity/singularity_evidence.hpp>
#include <equilibria/singularity/singularity_newton.hpp>

namespace equilibria::detail {

/// The unfolding's coefficients by the parameters: each column is that of one of the null vectors `right` or of one
/// parameter, its rows the part of F along `left` and the conditions of Newton's system. F is solved for q across the
/// null vectors; columns are scaled. None where the null vectors are no border of J.
EQUILIBRIA_INLINE std::vector<RuntimeArray<double>> unfolding(const RuntimeMatrix<double>& a, int rows,
                                                              const std::vector<RuntimeArray<double>>& right,
                                                              const std::vector<RuntimeArray<double>>& left) {
    const int size = a.size(), conditions = size - rows, corank = static_cast<int>(right.size());
    const auto number = [](int k) { return static_cast<std::size_t>(k); };
    RuntimeMatrix<double> bordered(rows + corank);
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < rows; ++j) bordered[i][j] = a[i][j];
        for (int c = 0; c < corank; ++c)
            bordered[i][rows + c] = -left[number(c)][i], bordered[rows + c][i] = right[number(c)][i];
    }
    std::vector<RuntimeArray<double>> columns(number(corank + conditions), RuntimeArray<double>(corank + conditions));
    const auto conditions_along = [&](const RuntimeArray<double>& z, RuntimeArray<double>& column) {
        for (int k = 0; k < conditions; ++k)
            for (int i = 0; i < rows; ++i) column[corank + k] += a[rows + k][i] * z[i];
    };
    const auto scale = [](RuntimeArray<double>& column, double by) {
        if (by > 0)
            for (double& x : column) x /= by;
    };
    double largest_along_null = 0;
    for (int c = 0; c < corank; ++c) {
        auto& column = columns[number(c)];
        conditions_along(right[number(c)], column);
        largest_along_null = std::max(largest_along_null, std::sqrt(dot(column, column)));
    }
    for (int c = 0; c < corank; ++c) scale(columns[number(c)], largest_along_null);
    const DenseFactorization<double, at_run_time> factors(bordered);
    if (!factors.regular()) return {};
    for (int k = 0; k < conditions; ++k) {
        auto& column = columns[number(corank + k)];
        RuntimeArray<double> b(rows + corank);
        double whole = 0;
        for (int i = 0; i < size; ++i) whole += a[i][rows + k] * a[i][rows + k];
        for (int i = 0; i < rows; ++i) b[i] = -a[i][rows + k];
        b = factors.solve(b);
        for (int c = 0; c < corank; ++c) column[c] = b[rows + c];
        conditions_along(b, column);
        for (int i = 0; i < conditions; ++i) column[corank + i] += a[rows + i][rows + k];
        scale(column, std::sqrt(whole));
    }
    return columns;
}

EQUILIBRIA_INLINE double versality(const RuntimeMatrix<double>& jacobian, int rows,
                                   const std::vector<RuntimeArray<double>>& right,
                                   const std::vector<RuntimeArray<double>>& left) {
    const auto columns = unfolding(jacobian, rows, right, left);
    if (columns.empty()) return 0;
    SingularValues::Vector entries;
    for (const auto& column : columns) entries.insert(entries.end(), column.begin(), column.end());
    for (const auto& x : entries)
        if (!std::isfinite(x.real())) return 0;
    const int size = static_cast<int>(columns.size());
    return SingularValues(size, size, std::move(entries))[size - 1];
}

}  // namespace equilibria::detail
