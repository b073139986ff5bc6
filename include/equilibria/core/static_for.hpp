/// \file
/// Loops whose index is a constant expression.
#pragma once

#include <type_traits>
#include <utility>

namespace equilibria {

/// Calls f(std::integral_constant<int, k>) for k = 0 .. N-1.
template <int N, class F>
constexpr void static_for(F&& f) {
    [&]<int... K>(std::integer_sequence<int, K...>) {
        (f(std::integral_constant<int, K>{}), ...);
    }(std::make_integer_sequence<int, N>{});
}

}  // namespace equilibria
