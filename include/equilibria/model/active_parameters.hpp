/// \file
/// The parameters that a search moves, its active ones, named by their numbers: with_active<X, Y>(p, x, y) is p with
/// other values of those two.
#pragma once

#include <cstddef>

#include <equilibria/core/array.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// p with the values given for the parameters number Active.., in that order.
template <int... Active, class S, int N, class... Value>
constexpr Array<S, N> with_active(Array<S, N> p, const Value&... value) {
    static_assert(sizeof...(Active) == sizeof...(Value), "equilibria: a value for each active parameter");
    ((p[Active] = value), ...);
    return p;
}

namespace detail {

/// Fails to compile unless all are parameters of the model, and different ones.
template <class M, int... Active>
constexpr void check_active() {
    static_assert(((Active >= 0 && Active < n_parameters<M>) && ...), "equilibria: no such parameter");
    constexpr int active[] = {Active...};
    constexpr bool different = [&] {
        for (std::size_t i = 0; i < sizeof...(Active); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (active[i] == active[j]) return false;
        return true;
    }();
    static_assert(different, "equilibria: the active parameters must be different ones");
}

/// p over another scalar, with y[first], y[first + 1], .. for the active ones.
template <int... Active, class S, int K, class T, int N>
Array<T, K> lifted_with_active(const Array<S, K>& p, const Array<T, N>& y, int first) {
    Array<T, K> lifted;
    for (int k = 0; k < K; ++k) lifted[k] = T(p[k]);
    ((lifted[Active] = y[first++]), ...);
    return lifted;
}

}  // namespace detail

}  // namespace equilibria
