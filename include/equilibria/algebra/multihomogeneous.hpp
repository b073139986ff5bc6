/// \file
/// Multihomogeneous numbers of Bezout: bounds on the number of isolated complex equilibria, from degrees alone.
///
/// They count the solutions of the polynomial system in the (cos, sin) of the angles and the coordinates, with a circle
/// equation an angle. With the variables in groups g of d_g variables, equation i of degree d_ig in group g, the number
/// is the coefficient of prod_g a_g^d_g in prod_i sum_g d_ig a_g (Morgan, Sommese, A homotopy for solving general
/// polynomial systems that respects m-homogeneous structures, 1987). An angle brings two variables and its circle
/// equation, which is of degree 2 in their group alone: it takes one a_g and gives a factor 2. Degrees say nothing of
/// which terms there are: the mixed volume does, and may be far smaller.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// A number of paths. One that does not fit 63 bits is the largest that does, and `saturated` says so.
struct PathCount {
    std::int64_t value = 0;
    bool saturated = false;

    static constexpr PathCount too_many() { return {std::numeric_limits<std::int64_t>::max(), true}; }

    friend constexpr PathCount operator+(PathCount a, PathCount b) {
        std::int64_t sum = 0;
        if (a.saturated || b.saturated || __builtin_add_overflow(a.value, b.value, &sum)) return too_many();
        return {sum, false};
    }
    friend constexpr PathCount operator*(PathCount a, PathCount b) {
        std::int64_t product = 0;
        if (a == PathCount{} || b == PathCount{}) return {};
        if (a.saturated || b.saturated || __builtin_mul_overflow(a.value, b.value, &product)) return too_many();
        return {product, false};
    }
    friend constexpr bool operator==(PathCount, PathCount) = default;
    friend constexpr bool operator<(PathCount a, PathCount b) {
        return a.value != b.value ? a.value < b.value : a.saturated < b.saturated;
    }
    friend std::ostream& operator<<(std::ostream& out, PathCount a) {
        return out << (a.saturated ? "more than " : "") << std::to_string(a.value);
    }
};

/// The group of each unknown: numbers from 0, none left out.
template <Model M>
using Grouping = Array<int, n_unknowns<M>>;

/// Each unknown for itself: the angle's (cos, sin), or x.
template <Model M>
constexpr Grouping<M> one_group_each() {
    Grouping<M> g;
    for (int i = 0; i < g.size(); ++i) g[i] = i;
    return g;
}

namespace detail {

constexpr int n_groups(const auto& grouping) {
    int highest = 0;
    for (int g : grouping) highest = std::max(highest, g);
    return highest + 1;
}

/// The coefficient of prod_g a_g^size_g in prod_i sum_g degree[i][g] a_g; the sizes add up to N. One factor after the
/// other; the state is how often each group was taken so far, a mixed-radix number.
template <int N>
constexpr PathCount bezout_coefficient(const Array<Array<int, N>, N>& degree, const Array<int, N>& size, int groups) {
    Array<std::size_t, N + 1> stride;
    stride[0] = 1;
    for (int g = 0; g < groups; ++g) stride[g + 1] = stride[g] * static_cast<std::size_t>(size[g] + 1);
    std::vector<PathCount> ways(stride[groups]), next(stride[groups]);
    ways[0] = {1, false};
    for (int i = 0; i < N; ++i) {
        std::fill(next.begin(), next.end(), PathCount{});
        for (std::size_t state = 0; state < ways.size(); ++state) {
            if (ways[state] == PathCount{}) continue;
            for (int g = 0; g < groups; ++g) {
                const int taken = static_cast<int>(state % stride[g + 1] / stride[g]);
                if (taken == size[g] || degree[i][g] == 0) continue;
                PathCount& sum = next[state + stride[g]];
                sum = sum + ways[state] * PathCount{degree[i][g], false};
            }
        }
        std::swap(ways, next);
    }
    return ways.back();
}

/// The next set partition as a restricted growth string (no entry exceeds the largest before it by more than 1); false
/// after the last.
template <int N>
constexpr bool next_partition(Array<int, N>& g) {
    for (int i = N - 1; i > 0; --i) {
        int highest = 0;
        for (int j = 0; j < i; ++j) highest = std::max(highest, g[j]);
        if (g[i] > highest) continue;
        ++g[i];
        for (int j = i + 1; j < N; ++j) g[j] = 0;
        return true;
    }
    return false;
}

}  // namespace detail

/// The product over the unknowns of the equation's degree, times 2 an angle: the number of Bezout.
template <Model M>
constexpr PathCount total_degree_count() {
    PathCount product{1, false};
    for (int i = 0; i < n_unknowns<M>; ++i)
        product = product * PathCount{(i < n_angles<M> ? 2 : 1) * Formulation<M>::degrees[i], false};
    return product;
}

/// The same as an integer: the number of paths of a total-degree start. Throws std::overflow_error above 2^63 - 1; in a
/// constant expression, that does not compile.
template <Model M>
constexpr std::int64_t total_degree() {
    constexpr PathCount count = total_degree_count<M>();
    if (count.saturated) throw std::overflow_error("equilibria: the total degree of the model exceeds 63 bits");
    return count.value;
}

/// The multihomogeneous number of Bezout for one grouping of the unknowns. Needs time and memory of the order of
/// prod_g (size of g + 1), 2^n for one group each. Throws InvalidArgument where that exceeds 2^22, and for a group
/// number that is not in [0, n).
template <Model M>
constexpr PathCount multihomogeneous_number(const Grouping<M>& grouping) {
    constexpr int n = n_unknowns<M>;
    Array<int, n> size{};
    for (int g : grouping) {
        if (g < 0 || g >= n) throw InvalidArgument("grouping", to_text(g), "must number the groups from 0");
        ++size[g];
    }
    const int groups = detail::n_groups(grouping);
    double states = 1;
    for (int g = 0; g < groups; ++g) states *= size[g] + 1;
    if (states > 1 << 22)
        throw InvalidArgument("grouping", to_text(groups) + " groups", "must not be that many for so many unknowns");
    Array<Array<int, n>, n> degree{};
    for (const auto& t : Formulation<M>::support) {
        Array<int, n> d{};
        for (int u = 0; u < n; ++u) d[grouping[u]] += t.monomial.degree(u);
        for (int g = 0; g < groups; ++g) degree[t.equation][g] = std::max(degree[t.equation][g], d[g]);
    }
    PathCount number = detail::bezout_coefficient<n>(degree, size, groups);
    for (int i = 0; i < n_angles<M>; ++i) number = number * PathCount{2, false};
    return number;
}

/// Which groupings were compared for the smallest multihomogeneous number.
enum class ComparedGroupings {
    all,          ///< every partition of the unknowns: up to 8 unknowns, 4140 partitions
    one_or_each,  ///< one group of all, and a group each
    one           ///< one group of all, the total degree: above 20 unknowns
};

template <Model M>
struct SmallestGrouping {
    PathCount number;
    Grouping<M> grouping;
    ComparedGroupings compared;
};

/// The smallest multihomogeneous number, and the first grouping that has it; fewer groups come first.
template <Model M>
constexpr SmallestGrouping<M> smallest_multihomogeneous_number() {
    constexpr int n = n_unknowns<M>;
    SmallestGrouping<M> best{total_degree_count<M>(), {}, ComparedGroupings::one};
    const auto try_grouping = [&](const Grouping<M>& grouping) {
        const PathCount number = multihomogeneous_number<M>(grouping);
        const bool simpler = number == best.number && detail::n_groups(grouping) < detail::n_groups(best.grouping);
        if (number < best.number || simpler) best.number = number, best.grouping = grouping;
    };
    if constexpr (n <= 8) {
        best.compared = ComparedGroupings::all;
        Grouping<M> grouping{};
        while (detail::next_partition(grouping)) try_grouping(grouping);
    } else if constexpr (n <= 20) {
        best.compared = ComparedGroupings::one_or_each;
        try_grouping(one_group_each<M>());
    }
    return best;
}

}  // namespace equilibria
