/// \file
/// See core/sorted_order.hpp.
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>

#include <equilibria/core/sorted_order.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::vector<std::size_t> sorted_order(const std::vector<std::array<std::int64_t, 3>>& keys) {
    std::vector<std::size_t> y(keys.size());
    std::iota(y.begin(), y.end(), std::size_t{0});
    std::sort(y.begin(), y.end(),
              [&](std::size_t a, std::size_t b) { return std::pair(keys[a], a) < std::pair(keys[b], b); });
    return y;
}

}  // namespace equilibria
