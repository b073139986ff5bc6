/// \file
/// See core/cholesky.hpp.
#pragma once

#include <cmath>

#include <equilibria/core/cholesky.hpp>

namespace equilibria::detail {

// Sums along rows, whose order the compiler keeps: of columns it would make vectors, which a few numbers do not fill.
EQUILIBRIA_INLINE bool factorize_positive(int n, double* a) {
    for (int j = 0; j < n; ++j) {
        for (int i = j; i < n; ++i) {
            double sum = a[i + j * n];
            for (int k = 0; k < j; ++k) sum -= a[i + k * n] * a[k + j * n];
            a[i + j * n] = sum;
        }
        double& pivot = a[j + j * n];
        if (pivot <= 0) return false;
        pivot = 1 / pivot;
        for (int i = j + 1; i < n; ++i) {
            a[j + i * n] = a[i + j * n];
            a[i + j * n] *= pivot;
        }
    }
    return true;
}

EQUILIBRIA_INLINE void solve_positive(int n, const double* factor, int columns, double* b) {
    for (int c = 0; c < columns; ++c, b += n) {
        for (int i = 1; i < n; ++i) {
            double sum = b[i];
            for (int k = 0; k < i; ++k) sum -= factor[i + k * n] * b[k];
            b[i] = sum;
        }
        for (int i = n - 1; i >= 0; --i) {
            double sum = b[i] * factor[i + i * n];
            for (int k = i + 1; k < n; ++k) sum -= factor[k + i * n] * b[k];
            b[i] = sum;
        }
    }
}

EQUILIBRIA_INLINE double norm_of_columns(int n, const double* a) {
    double largest = 0;
    for (int k = 0; k < n; ++k) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += std::abs(a[k * n + i]);
        if (sum > largest || std::isnan(sum)) largest = sum;
    }
    return largest;
}

EQUILIBRIA_INLINE double norm_of_inverse(int n, const double* factor, double* column) {
    double largest = 0;
    for (int k = 0; k < n; ++k) {
        for (int i = 0; i < n; ++i) column[i] = i == k;
        solve_positive(n, factor, 1, column);
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += std::abs(column[i]);
        if (sum > largest || std::isnan(sum)) largest = sum;
    }
    return largest;
}

}  // namespace equilibria::detail
