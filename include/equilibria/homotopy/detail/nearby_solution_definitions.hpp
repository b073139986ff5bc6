/// \file
/// See homotopy/nearby_solution.hpp.
#pragma once

#include <algorithm>
#include <cmath>

#include <equilibria/core/double_double.hpp>
#include <equilibria/core/singular_values.hpp>
#include <equilibria/homotopy/detail/logarithmic_homotopy.hpp>
#include <equilibria/homotopy/nearby_solution.hpp>

namespace equilibria {

namespace detail {

/// A search for a solution of the target next to a point, with sums of two doubles.
class NearbySolution : private LogarithmicHomotopy<DoubleDouble> {
public:
    using LogarithmicHomotopy<DoubleDouble>::LogarithmicHomotopy;
    using Vector = std::vector<std::complex<double>>;

    /// See nearby_solution.
    std::optional<Vector> from(const Vector& begin, double most, double small) {
        std::vector<Z> q;
        std::vector<char> zero;
        for (std::size_t u = 0; u < begin.size(); ++u) {
            const auto z = u >= at(angles_) && std::abs(begin[u]) < small ? 0.0 : begin[u];
            q.emplace_back(DoubleDouble(z.real()), DoubleDouble(z.imag()));
            zero.push_back(z == 0.0);
        }
        // an equation all of whose terms vanish is measured by its coefficients
        std::vector<int> coefficient(at(n_), -100000);
        for (std::size_t k = 0; k < to_.size(); ++k) {
            int& most_of = coefficient[at((*columns_)[k].equation)];
            most_of = std::max(most_of, size_exponent(to_[k]));
        }
        double moved = 0, before = 1e300;
        for (int round = 0; round < 100; ++round) {
            if (!linearize(q, DoubleDouble(0), &zero)) return {};
            double residual = 0;
            for (int i = 0; i < n_; ++i) {
                const int below = std::max(-300, std::min(0, exponent_[at(i)] - coefficient[at(i)]));
                residual = std::max(residual, std::ldexp(std::abs(rounded(f_[i])), below));
            }
            if (residual < vanishing) {
                Vector y;
                for (const Z& z : q) y.push_back(rounded(z));
                return y;
            }
            if (round > 10 && residual > 0.98 * before) return {};
            before = residual;
            SingularValues::Vector j(at(n_ * n_)), right(at(n_));
            for (int i = 0; i < n_; ++i) {
                double row = 0;
                for (int u = 0; u < n_; ++u) row = std::max(row, std::abs(rounded(j_[i][u])));
                if (!(row > 1e-14)) continue;  // a square that vanishes: rounding alone is left of it
                right[at(i)] = rounded(f_[i]) / row;
                for (int u = 0; u < n_; ++u) j[at(u * n_ + i)] = rounded(j_[i][u]) / row;
            }
            const SingularValues svd(n_, n_, std::move(j));
            const auto step = svd.solve(right, svd.rank(1e-9));
            for (std::size_t u = 0; u < at(n_); ++u) {
                moved += std::abs(step[u]);
                const Z d(DoubleDouble(-step[u].real()), DoubleDouble(-step[u].imag()));
                if (zero[u])
                    q[u] += d, zero[u] = step[u] == 0.0;
                else
                    q[u] += d * q[u];
            }
            if (!(moved < most)) return {};
        }
        return {};
    }
};

}  // namespace detail

EQUILIBRIA_INLINE std::optional<std::vector<std::complex<double>>> nearby_solution(
    const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns, const std::vector<std::complex<double>>& z,
    double most, double small) {
    return detail::NearbySolution(sizes, columns).from(z, most, small);
}

}  // namespace equilibria
