/// \file
/// The order of things by their keys: sorted once for all types.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// The numbers 0, 1, .. in ascending lexicographic order of the keys; of equal keys the smaller number first.
std::vector<std::size_t> sorted_order(const std::vector<std::array<std::int64_t, 3>>& keys);

/// The things in this order.
template <class T>
std::vector<T> in_order(const std::vector<std::size_t>& order, std::vector<T>&& things) {
    std::vector<T> y;
    y.reserve(things.size());
    for (const std::size_t k : order) y.push_back(std::move(things[k]));
    return y;
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/sorted_order_definitions.hpp>
#endif
