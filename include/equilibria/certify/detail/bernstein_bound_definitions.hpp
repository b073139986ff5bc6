/// \file
/// See certify/bernstein_bound.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <equilibria/algebra/laurent_products.hpp>
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
        std::vector<int> codes(n);
        for (int k = t.first; k < t.last; ++k) {
            const auto [unknown, code] = system.factors[static_cast<std::size_t>(k)];
            codes[static_cast<std::size_t>(unknown)] = code;
        }
        for (const auto& product : laurent_products(codes, system.sizes.angles)) {
            Parts& parts = sums[static_cast<std::size_t>(t.equation)][product.exponents];
            parts[0] = parts[0] + ExactBall(product.coefficient.real()) * t.coefficient;
            parts[1] = parts[1] + ExactBall(product.coefficient.imag()) * t.coefficient;
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
        if (detail::mixed_volume_again(*supports, volume.order) != volume.value) return {};
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
