/// \file
/// See certify/bernstein_bound.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

#include <equilibria/certify/bernstein_bound.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/polyhedral/affine_supports.hpp>
#include <equilibria/polyhedral/mixed_area.hpp>
#include <equilibria/polyhedral/mixed_cells.hpp>

namespace equilibria {

namespace detail {

/// The exponents of z and the coordinates in each equation.
EQUILIBRIA_INLINE std::vector<std::vector<Supports::Point>> laurent_exponents(const ExactTerms& system) {
    using Parts = std::array<ExactBall, 2>;  // real and imaginary
    const auto n = static_cast<std::size_t>(system.sizes.unknowns);
    std::vector<std::map<Supports::Point, Parts>> sums(n);
    for (const auto& t : system.terms) {
        struct Product {
            Supports::Point exponents;
            double factor;  // times -i to the number of sines
        };
        std::vector<Product> products{{Supports::Point(n), 1}};
        std::size_t sines = 0;
        for (int k = t.first; k < t.last; ++k) {
            const auto [unknown, code] = system.factors[static_cast<std::size_t>(k)];
            const auto u = static_cast<std::size_t>(unknown);
            for (Product& product : products) product.exponents[u] = std::abs(code);
            if (unknown >= system.sizes.angles) continue;
            // cos k = (z^k + z^-k) / 2, sin k = (z^k - z^-k) / 2i
            sines += code < 0;
            const std::size_t before = products.size();
            for (std::size_t m = 0; m < before; ++m) {
                products[m].factor *= 0.5;
                Product other = products[m];
                other.exponents[u] = -std::abs(code);
                if (code < 0) other.factor = -other.factor;
                products.push_back(std::move(other));
            }
        }
        for (const Product& product : products) {
            ExactBall& part = sums[static_cast<std::size_t>(t.equation)][product.exponents][sines % 2];
            const double sign = sines % 4 == 1 || sines % 4 == 2 ? -1 : 1;  // (-i)^sines
            part = part + ExactBall(sign * product.factor) * t.coefficient;
        }
    }
    std::vector<std::vector<Supports::Point>> y(n);
    for (std::size_t i = 0; i < n; ++i)
        for (const auto& [at, parts] : sums[i])
            if (!(parts[0] == ExactBall(0) && parts[1] == ExactBall(0))) y[i].push_back(at);
    return y;
}

/// By the cells of a random lifting, the equations in an order other than the given one.
EQUILIBRIA_INLINE std::uint64_t mixed_volume_again(const Supports& supports, std::vector<int> order) {
    for (std::size_t k = 0; k + 1 < order.size(); k += 2) std::swap(order[k], order[k + 1]);
    Generator generator(1);
    Lifting lifting(static_cast<std::size_t>(supports.columns()));
    for (auto& height : lifting) height = static_cast<std::int64_t>(generator() >> 40);
    return mixed_cells(supports, lifting, [](const MixedCell&) {}, {.order = std::move(order)}).value;
}

}  // namespace detail

EQUILIBRIA_INLINE std::optional<Supports> bernstein_supports(const ExactTerms& system) {
    auto equations = detail::laurent_exponents(system);
    for (const auto& equation : equations)
        if (equation.empty()) return {};
    add_origin(system.sizes.angles, equations);
    return Supports(system.sizes.unknowns, std::move(equations));
}

EQUILIBRIA_INLINE std::optional<std::uint64_t> bernstein_bound(const ExactTerms& system) {
    const auto supports = bernstein_supports(system);
    if (!supports) return {};
    try {
        const MixedVolume volume = mixed_volume(*supports);
        if (volume.value == 0 || detail::mixed_volume_again(*supports, volume.order) != volume.value) return {};
        if (supports->unknowns() == 2) {
            std::array<std::vector<detail::LatticePoint>, 2> polygons;
            for (std::size_t i = 0; i < 2; ++i)
                for (const auto& point : supports->equations()[i]) polygons[i].push_back({point[0], point[1]});
            if (static_cast<std::uint64_t>(detail::mixed_area(polygons[0], polygons[1])) != volume.value) return {};
        }
        return volume.value;
    } catch (const InvalidArgument&) {
        return {};  // 2^64 or more
    }
}

}  // namespace equilibria
