/// \file
/// See start/binomial_system.hpp.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Core>
#include <Eigen/LU>

#include <equilibria/core/error.hpp>
#include <equilibria/start/binomial_system.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::vector<std::int64_t> hermite_diagonal(std::vector<std::vector<std::int64_t>> matrix) {
    const std::size_t n = matrix.size();
    std::vector<std::int64_t> diagonal;
    for (std::size_t row = 0; row < n; ++row) {
        // Euclid's algorithm on this row's entries, by operations on columns row .. n-1
        for (std::size_t column = row + 1; column < n; ++column)
            while (matrix[row][column] != 0) {
                const std::int64_t by = matrix[row][row] / matrix[row][column];
                for (std::size_t r = row; r < n; ++r) {
                    std::int64_t product;
                    const bool fits = !__builtin_mul_overflow(by, matrix[r][column], &product) &&
                                      !__builtin_sub_overflow(matrix[r][row], product, &matrix[r][row]);
                    require(fits, "matrix", "an entry of its Hermite form", "must fit into 64 bits");
                    std::swap(matrix[r][row], matrix[r][column]);
                }
            }
        require(matrix[row][row] != 0, "matrix", "singular", "must have full rank");
        diagonal.push_back(std::abs(matrix[row][row]));
    }
    return diagonal;
}

EQUILIBRIA_INLINE BinomialSystem::BinomialSystem(const std::vector<std::vector<int>>& exponents,
                                                 std::span<const Number> ratio) {
    const std::size_t n = exponents.size();
    std::vector<std::vector<std::int64_t>> matrix;
    for (const auto& row : exponents) matrix.emplace_back(row.begin(), row.end());
    diagonal_ = hermite_diagonal(std::move(matrix));
    for (const std::int64_t d : diagonal_) {
        const bool fits = !__builtin_mul_overflow(solutions_, static_cast<std::uint64_t>(d), &solutions_);
        require(fits, "exponents", "the absolute value of their determinant", "must be below 2^64");
    }
    const auto size = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd m(size, size);
    for (Eigen::Index r = 0; r < size; ++r)
        for (Eigen::Index c = 0; c < size; ++c)
            m(r, c) = exponents[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    const Eigen::MatrixXd inverse = m.partialPivLu().inverse();
    for (Eigen::Index r = 0; r < size; ++r)
        for (Eigen::Index c = 0; c < size; ++c) inverse_.push_back(inverse(r, c));
    for (const Number& q : ratio) right_side_.push_back(Number(0, -1) * std::log(q));
}

EQUILIBRIA_INLINE UnknownArray<RuntimeUnknowns, std::complex<double>> BinomialSystem::solution(std::uint64_t k) const {
    const std::size_t n = right_side_.size();
    std::vector<Number> right = right_side_;
    for (std::size_t i = 0; i < n; ++i) {
        const auto radix = static_cast<std::uint64_t>(diagonal_[i]);
        right[i] += 2 * std::numbers::pi * static_cast<double>(k % radix);
        k /= radix;
    }
    UnknownArray<RuntimeUnknowns, Number> theta(static_cast<int>(n));
    for (std::size_t u = 0; u < n; ++u) {
        Number y = 0;
        for (std::size_t i = 0; i < n; ++i) y += inverse_[u * n + i] * right[i];
        theta[static_cast<int>(u)] = y;
    }
    return theta;
}

}  // namespace equilibria
