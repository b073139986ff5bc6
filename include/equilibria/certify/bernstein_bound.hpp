/// \file
/// Bernstein's bound for models of one or two angles: the mixed volume of the Newton polytopes of the Laurent system in
/// z = exp(i theta), in exact arithmetic. Every complex angle is a z other than 0, so that it bounds the number of
/// isolated equilibria. Source: Bernstein, The number of roots of a system of equations, Funct. Anal. Appl. 9 (1975).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <equilibria/algebra/laurent.hpp>
#include <equilibria/certify/exact_system.hpp>

namespace equilibria {

namespace detail {

using LatticePoint = std::array<std::int64_t, 2>;

/// Twice the area of the convex hull of these points, not empty.
inline std::int64_t twice_hull_area(std::vector<LatticePoint> points) {
    const auto turn = [](const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    std::sort(points.begin(), points.end());
    std::int64_t area = 0;
    for (int side = 0; side < 2; ++side) {  // lower chain from the left, upper chain from the right
        std::vector<LatticePoint> chain;
        for (const auto& p : points) {
            while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
            chain.push_back(p);
        }
        for (std::size_t k = 1; k < chain.size(); ++k)
            area += chain[k - 1][0] * chain[k][1] - chain[k - 1][1] * chain[k][0];
        std::reverse(points.begin(), points.end());
    }
    return area;
}

/// area(P + Q) - area(P) - area(Q).
inline std::int64_t mixed_area(const std::vector<LatticePoint>& p, const std::vector<LatticePoint>& q) {
    std::vector<LatticePoint> sum;
    for (const auto& a : p)
        for (const auto& b : q) sum.push_back({a[0] + b[0], a[1] + b[1]});
    return (twice_hull_area(sum) - twice_hull_area(p) - twice_hull_area(q)) / 2;
}

/// The exponents of each equation's Laurent terms, those that cancel left out. Of one angle the second exponent is 0.
template <Model M>
std::array<std::vector<LatticePoint>, static_cast<std::size_t>(n_unknowns<M>)> laurent_exponents(
    const ExactSystem<M>& system) {
    constexpr auto n = static_cast<std::size_t>(n_unknowns<M>);
    std::array<std::map<LatticePoint, std::array<ExactBall, 2>>, n> sums;  // real and imaginary parts
    for (const auto& t : system.terms)
        expand_laurent<M>(t.monomial, [&](const auto& exponents, int turns, double factor) {
            LatticePoint at{};
            std::copy(exponents.begin(), exponents.end(), at.begin());
            auto& part = sums[static_cast<std::size_t>(t.equation)][at][static_cast<std::size_t>(turns % 2)];
            part = part + ExactBall(turns < 2 ? factor : -factor) * t.coefficient;
        });
    std::array<std::vector<LatticePoint>, n> y;
    for (std::size_t i = 0; i < n; ++i)
        for (const auto& [at, parts] : sums[i])
            if (!(parts[0] == ExactBall(0) && parts[1] == ExactBall(0))) y[i].push_back(at);
    return y;
}

}  // namespace detail

/// The mixed volume, or nothing where an equation vanishes identically, or where the volume is 0 (two angles): then
/// there may be a curve of equilibria. Where that many isolated roots exist there is none: a common factor with the
/// polygon H beside A and B would add V(H, H) + V(H, A) + V(H, B), which is 0 only where V(A, B) is 0 too.
template <Model M>
requires(n_coordinates<M> == 0 && n_angles<M> <= 2)
std::optional<std::uint64_t> bernstein_bound(const ExactSystem<M>& system) {
    const auto exponents = detail::laurent_exponents(system);
    for (const auto& equation : exponents)
        if (equation.empty()) return {};
    if constexpr (n_angles<M> == 1) {
        const auto [low, high] = std::minmax_element(exponents[0].begin(), exponents[0].end());
        return static_cast<std::uint64_t>((*high)[0] - (*low)[0]);
    } else {
        const auto volume = detail::mixed_area(exponents[0], exponents[1]);
        if (volume == 0) return {};
        return static_cast<std::uint64_t>(volume);
    }
}

}  // namespace equilibria
