/// \file
/// Binomial systems c_i z^(a_i) + d_i z^(b_i) = 0, one equation an unknown: as many solutions with every z_u other than
/// 0 as |det M|, the rows of M being a_i - b_i.
///
/// In complex angles the system is linear, M theta = -i log(-d / c) + 2 pi k, and its solutions belong to the integer
/// vectors k modulo the lattice M Z^n, which the Hermite form of M names. It is solved with M itself: the unimodular
/// factors of the Hermite form may have entries of many digits, M has small ones.
/// Source: Huber, Sturmfels, A polyhedral method for solving sparse polynomial systems, Math. Comp. 64 (1995); Cohen, A
/// Course in Computational Algebraic Number Theory (1993), 2.4.2 (Hermite form).
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// The diagonal of the Hermite form of a square integer matrix (rows by rows) of full rank: the vectors k with 0 <= k_i
/// < diagonal[i] are one of each class of Z^n modulo the lattice of the matrix's columns. Throws InvalidArgument where
/// the matrix is singular or the numbers do not fit.
std::vector<std::int64_t> hermite_diagonal(std::vector<std::vector<std::int64_t>> matrix);

/// exponents[i] = a_i - b_i, ratio[i] = -d_i / c_i.
class BinomialSystem {
public:
    using Number = std::complex<double>;  ///< type of ratios and of complex angles

    /// As many exponents and ratios as equations, which is not checked. Throws InvalidArgument as hermite_diagonal, and
    /// where there are 2^64 solutions or more.
    BinomialSystem(const std::vector<std::vector<int>>& exponents, std::span<const Number> ratio);

    /// |det M|.
    std::uint64_t solutions() const { return solutions_; }
    /// Solution number k, in complex angles.
    UnknownArray<RuntimeUnknowns, Number> solution(std::uint64_t k) const;

private:
    std::vector<std::int64_t> diagonal_;
    std::uint64_t solutions_ = 1;
    std::vector<double> inverse_;  // of M, by rows
    std::vector<Number> right_side_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/start/detail/binomial_system_definitions.hpp>
#endif
