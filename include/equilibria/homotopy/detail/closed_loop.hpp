/// \file
/// A path that has closed around t = 1 after m turns: the Laurent series in s = (1-t)^(1/m) that its points determine.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include <equilibria/evaluation/point.hpp>

namespace equilibria::detail {

template <class R>
struct ClosedLoop {
    using Z = Complex<R>;
    using At = RuntimePoint<R>;
    static constexpr int samples = 8;  ///< points a turn
    static constexpr int most_turns = 12;

    int winding = 0;        ///< m, 0 where the path has not closed
    At mean{};              ///< the constant term
    bool has_mean = false;  ///< false where that is no point of the circle, as an angle's on its way to infinity
    int pole = 0;           ///< s^-pole is the largest term of negative order, 0 where it does not dominate its unknown
    double beyond = 0;      ///< the largest term of still lower order, beside that one

    ClosedLoop() = default;
    ClosedLoop(const std::vector<At>& points, int turns) : winding(turns) {
        find_mean(points);
        find_pole(points);
    }

private:
    void find_mean(const std::vector<At>& points) {
        mean = points.front();
        const int angles = mean.c.size(), coordinates = mean.x.size();
        for (std::size_t k = 1; k < points.size(); ++k) {
            const At& at = points[k];
            for (int i = 0; i < angles; ++i) mean.c[i] += at.c[i], mean.s[i] += at.s[i];
            for (int j = 0; j < coordinates; ++j) mean.x[j] += at.x[j];
        }
        const R by = 1.0 / R(static_cast<double>(points.size()));
        has_mean = true;
        for (int i = 0; i < angles; ++i) {
            mean.c[i] *= by;
            mean.s[i] *= by;
            const Z square = mean.c[i] * mean.c[i] + mean.s[i] * mean.s[i];
            if (!(norm2(1.0 - square) < 1e-4 * (1.0 + norm2(mean.c[i]) + norm2(mean.s[i])))) has_mean = false;
            const Z back = 1.5 - 0.5 * square;
            mean.c[i] *= back;
            mean.s[i] *= back;
        }
        for (int j = 0; j < coordinates; ++j) mean.x[j] *= by;
    }
    /// Of an angle the cosine tells: far out the sine is as large.
    void find_pole(const std::vector<At>& points) {
        const int size = static_cast<int>(points.size());
        std::complex<double> root[samples * most_turns];
        for (int k = 0; k < size; ++k) root[k] = std::polar(1.0, 2 * std::numbers::pi * k / size);
        double largest = 0;
        for (int u = 0; u < unknowns(points.front()); ++u) {
            double term[samples * most_turns / 2], size2 = 0;
            std::complex<double> value[samples * most_turns];
            for (int k = 0; k < size; ++k) {
                const At& at = points[static_cast<std::size_t>(k)];
                const Z& z = u < at.c.size() ? at.c[u] : at.x[u - at.c.size()];
                value[k] = {static_cast<double>(z.re), static_cast<double>(z.im)};
                size2 += std::norm(value[k]) / size;
            }
            int leading = 0;
            for (int j = 1; j < size / 2; ++j) {
                std::complex<double> sum = 0;
                for (int k = 0; k < size; ++k) sum += value[k] * root[j * k % size];
                term[j] = std::abs(sum) / size;
                if (leading == 0 || term[j] > term[leading]) leading = j;
            }
            if (leading == 0 || !(term[leading] > largest)) continue;
            largest = term[leading];
            pole = 2 * largest * largest > size2 ? leading : 0;
            double lower = 0;
            for (int j = leading + 1; j < size / 2; ++j) lower = std::max(lower, term[j]);
            beyond = lower / largest;
        }
    }
};

}  // namespace equilibria::detail
