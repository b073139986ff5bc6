/// \file
/// See start/polyhedral_start.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/start/polyhedral_start.hpp>

namespace equilibria {

/// The cells of a lifting.
struct PolyhedralStart::Draw {
    std::vector<std::array<int, 2>> edges;  ///< one an equation, cell by cell
    std::vector<float> weights;
    std::vector<double> ratio;  ///< of largest to smallest weight, a cell each
    std::vector<std::uint64_t> volume;
    bool fine = true;
    double ratio_of_most = 0;  ///< of 90 % of the paths
};

EQUILIBRIA_INLINE PolyhedralStart::Draw PolyhedralStart::draw(Generator& generator, bool convex, int bits,
                                                              const MixedCellOptions& options) const {
    Lifting lifting;
    for (const auto& support : supports_.equations())
        for (const auto& point : support) {
            std::int64_t height = 0;
            if (convex)
                for (const int e : point) height += std::int64_t{e} * e;
            // a convex lifting that is drawn around a paraboloid has nearly all cells of volume 1
            const int random_bits = convex ? bits : bits + 1;
            lifting.push_back((height << bits) + static_cast<std::int64_t>(generator() >> (64 - random_bits)));
        }
    Draw y;
    mixed_cells(
        supports_, lifting,
        [&](const MixedCell& cell) {
            y.fine = y.fine && cell.fine();
            y.edges.insert(y.edges.end(), cell.edges.begin(), cell.edges.end());
            y.volume.push_back(cell.volume);
            std::int64_t largest = 0, smallest = std::numeric_limits<std::int64_t>::max();
            for (const std::int64_t h : cell.heights) {
                largest = std::max(largest, h);
                if (h > 0) smallest = std::min(smallest, h);
            }
            const bool binomial = largest == 0;  // nothing beside the cell
            y.ratio.push_back(binomial ? 1 : static_cast<double>(largest) / static_cast<double>(smallest));
            for (const std::int64_t h : cell.heights)
                y.weights.push_back(
                    binomial ? 0 : static_cast<float>(static_cast<double>(h) / static_cast<double>(largest)));
        },
        options);
    std::vector<std::pair<double, std::uint64_t>> order;
    std::uint64_t all = 0, below = 0;
    for (std::size_t k = 0; k < y.ratio.size(); ++k) order.emplace_back(y.ratio[k], y.volume[k]), all += y.volume[k];
    std::sort(order.begin(), order.end());
    for (const auto& [ratio, volume] : order) {
        y.ratio_of_most = ratio;
        if (10 * (below += volume) >= 9 * all) break;
    }
    return y;
}

EQUILIBRIA_INLINE double PolyhedralStart::rate_of(const BinomialSystem& binomials,
                                                  std::span<const std::array<int, 2>> edges,
                                                  std::span<const float> weights) const {
    constexpr double negligible = 24 * std::numbers::ln2;
    const auto theta = binomials.solution(0);  // all solutions of a cell have the same imaginary parts
    double begin = negligible;
    for (int i = 0; i < supports_.unknowns(); ++i) {
        const auto& support = supports_.equations()[static_cast<std::size_t>(i)];
        const auto column = static_cast<std::size_t>(supports_.first_column(i));
        const auto size = [&](std::size_t k) {  // the logarithm of the term's
            double y = std::log(std::abs(coefficients_[column + k]));
            for (int u = 0; u < supports_.unknowns(); ++u)
                y -= support[k][static_cast<std::size_t>(u)] * theta[u].imag();
            return y;
        };
        const double of_edge = size(static_cast<std::size_t>(edges[static_cast<std::size_t>(i)][0]));
        for (std::size_t k = 0; k < support.size(); ++k)
            if (const auto weight = static_cast<double>(weights[column + k]); weight > 0)
                begin = std::max(begin, (negligible + size(k) - of_edge) / weight);
    }
    return std::log(1 + begin);
}

EQUILIBRIA_INLINE void PolyhedralStart::take(const Draw& drawn) {
    const auto n = static_cast<std::size_t>(supports_.unknowns()), columns = coefficients_.size();
    for (std::size_t cell = 0; cell < drawn.volume.size(); ++cell) {
        std::vector<std::vector<int>> exponents;
        std::vector<Number> ratio;
        for (std::size_t i = 0; i < n; ++i) {
            const auto& support = supports_.equations()[i];
            const auto [a, b] = drawn.edges[cell * n + i];
            std::vector<int> edge = support[static_cast<std::size_t>(a)];
            for (std::size_t u = 0; u < n; ++u) edge[u] -= support[static_cast<std::size_t>(b)][u];
            exponents.push_back(std::move(edge));
            const Number* const c = coefficients_.data() + supports_.first_column(static_cast<int>(i));
            ratio.push_back(-c[b] / c[a]);
        }
        const BinomialSystem binomials(exponents, ratio);
        const std::span weights(drawn.weights.data() + cell * columns, columns);
        cells_.push_back({binomials, rate_of(binomials, std::span(drawn.edges.data() + cell * n, n), weights), paths_});
        paths_ += drawn.volume[cell];
    }
    weights_ = drawn.weights;
    weight_ratio_ = drawn.ratio_of_most;
}

EQUILIBRIA_INLINE PolyhedralStart::PolyhedralStart(const Supports& supports, std::vector<Number> coefficients,
                                                   Generator& generator, int liftings, const MixedCellOptions& options)
    : supports_(supports), coefficients_(std::move(coefficients)) {
    require(coefficients_.size() == static_cast<std::size_t>(supports_.columns()), "coefficients", coefficients_.size(),
            "must be one for each column of the supports");
    Draw best;
    bool found = false;
    for (int k = 0, bits = 20; k < liftings || !found; ++k) {
        Draw drawn = draw(generator, k % 2 == 1, bits, options);
        if (options.cancel && options.cancel->load(std::memory_order_relaxed)) {
            cancelled_ = true;
            return;
        }
        if (!drawn.fine) {
            bits = std::min(bits + 2, 40);
            continue;
        }
        const bool large = drawn.weights.size() > 2'000'000;  // then cells cost more than they save
        if (!found || drawn.ratio_of_most < best.ratio_of_most) best = std::move(drawn);
        found = true;
        if (large && k >= 2) break;
    }
    take(best);
}

EQUILIBRIA_INLINE std::size_t PolyhedralStart::cell_of(std::uint64_t path) const {
    const auto after = std::upper_bound(cells_.begin(), cells_.end(), path,
                                        [](std::uint64_t k, const Cell& cell) { return k < cell.first; });
    return static_cast<std::size_t>(after - cells_.begin()) - 1;
}

EQUILIBRIA_INLINE RuntimePoint<double> PolyhedralStart::point(std::uint64_t path) const {
    const Cell& cell = cells_[cell_of(path)];
    return point_of<RuntimeUnknowns>(cell.binomials.solution(path - cell.first), RuntimeSizes(supports_.unknowns(), 0));
}

EQUILIBRIA_INLINE std::span<const float> PolyhedralStart::weights(std::uint64_t path) const {
    const auto columns = static_cast<std::size_t>(supports_.columns());
    return {weights_.data() + cell_of(path) * columns, columns};
}

}  // namespace equilibria
