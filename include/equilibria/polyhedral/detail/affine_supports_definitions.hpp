/// \file
/// See polyhedral/affine_supports.hpp.
#pragma once

#include <algorithm>
#include <cstddef>

#include <equilibria/polyhedral/affine_supports.hpp>

namespace equilibria {

namespace detail {

EQUILIBRIA_INLINE bool may_vanish(std::size_t first, const std::vector<std::vector<Supports::Point>>& equations) {
    using Set = unsigned;
    const std::size_t coordinates = equations.size() - first;
    constexpr std::size_t most = 20;
    if (coordinates > most) return true;
    std::vector<std::vector<Set>> terms;  // the coordinates of each term
    for (const auto& equation : equations) {
        terms.emplace_back();
        for (const auto& point : equation) {
            Set in = 0;
            for (std::size_t j = 0; j < coordinates; ++j)
                if (point[first + j] != 0) in |= Set{1} << j;
            terms.back().push_back(in);
        }
    }
    for (Set zero = 1; zero < Set{1} << coordinates; ++zero) {
        const auto single = [&](const std::vector<Set>& equation) {
            return std::ranges::count_if(equation, [&](Set in) { return (in & zero) == 0; }) == 1;
        };
        if (std::ranges::none_of(terms, single)) return true;
    }
    return false;
}

}  // namespace detail

EQUILIBRIA_INLINE void add_origin(int first, std::vector<std::vector<Supports::Point>>& equations) {
    if (!detail::may_vanish(static_cast<std::size_t>(first), equations)) return;
    const Supports::Point origin(equations.size());
    for (auto& equation : equations)
        if (std::ranges::find(equation, origin) == equation.end()) equation.push_back(origin);
}

}  // namespace equilibria
