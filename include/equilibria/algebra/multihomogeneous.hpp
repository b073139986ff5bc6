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

#include <equilibria/algebra/detail/grouping_search.hpp>
#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/array.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// A number of paths. One that does not fit 63 bits is the largest that does, and `saturated` says so.
struct PathCount {
    std::int64_t value = 0;  ///< at most 2^63 - 1
    bool saturated = false;  ///< the number does not fit 63 bits

    /// 2^63 - 1 and saturated.
    static constexpr PathCount too_many() { return {std::numeric_limits<std::int64_t>::max(), true}; }

    /// Saturating; 0 times what is saturated is 0.
    /// \{
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
    /// \}
    /// Order by value; what is saturated comes last.
    /// \{
    friend constexpr bool operator==(PathCount, PathCount) = default;
    friend constexpr bool operator<(PathCount a, PathCount b) {
        return a.value != b.value ? a.value < b.value : a.saturated < b.saturated;
    }
    /// \}
    /// The number, behind "more than " where it is saturated.
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

constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr int n_groups(const auto& grouping) {
    int highest = 0;
    for (int g : grouping) highest = std::max(highest, g);
    return highest + 1;
}

/// The coefficient of prod_g a_g^size[g] in prod_i sum_g degree[i][g] a_g; the sizes add up to the number of factors.
/// One factor after the other; the state is how often each group was taken so far, a mixed-radix number.
constexpr PathCount bezout_coefficient(const auto& degree, const auto& size, int groups) {
    std::vector<std::size_t> stride(at(groups + 1), 1);
    for (int g = 0; g < groups; ++g) stride[at(g + 1)] = stride[at(g)] * static_cast<std::size_t>(size[at(g)] + 1);
    std::vector<PathCount> ways(stride.back(), PathCount{}), next(stride.back(), PathCount{});
    ways[0] = {1, false};
    for (const auto& factor : degree) {
        std::fill(next.begin(), next.end(), PathCount{});
        for (std::size_t state = 0; state < ways.size(); ++state) {
            if (ways[state] == PathCount{}) continue;
            for (int g = 0; g < groups; ++g) {
                const int taken = static_cast<int>(state % stride[at(g + 1)] / stride[at(g)]);
                if (taken == size[at(g)] || factor[at(g)] == 0) continue;
                PathCount& sum = next[state + stride[at(g)]];
                sum = sum + ways[state] * PathCount{factor[at(g)], false};
            }
        }
        std::swap(ways, next);
    }
    return ways.back();
}

/// The number for one grouping of the unknowns, the first `angles` of which are angles. support: entries with
/// `equation` and `monomial.degree(unknown)`. Of zeros, to be counted in: size, an entry a group, and degree, an entry
/// an equation of an entry a group, as many groups as unknowns.
constexpr PathCount multihomogeneous_number(const auto& support, int angles, const auto& grouping, auto size,
                                            auto degree) {
    const int n = static_cast<int>(grouping.size());
    for (int g : grouping) {
        if (g < 0 || g >= n) throw InvalidArgument("grouping", to_text(g), "must number the groups from 0");
        ++size[at(g)];
    }
    const int groups = n_groups(grouping);
    double states = 1;
    for (int g = 0; g < groups; ++g) states *= size[at(g)] + 1;
    if (states > 1 << 22)
        throw InvalidArgument("grouping", to_text(groups) + " groups", "must not be that many for so many unknowns");
    for (const auto& t : support) {
        auto d = size;
        for (int g = 0; g < groups; ++g) d[at(g)] = 0;
        for (int u = 0; u < n; ++u) d[at(grouping[at(u)])] += t.monomial.degree(u);
        auto& most = degree[at(t.equation)];
        for (int g = 0; g < groups; ++g) most[at(g)] = std::max(most[at(g)], d[at(g)]);
    }
    PathCount number = bezout_coefficient(degree, size, groups);
    for (int i = 0; i < angles; ++i) number = number * PathCount{2, false};
    return number;
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
    return detail::multihomogeneous_number(Formulation<M>::support, n_angles<M>, grouping, Array<int, n>{},
                                           Array<Array<int, n>, n>{});
}

/// Which groupings were compared for the smallest multihomogeneous number.
enum class ComparedGroupings {
    all,          ///< every partition of the unknowns: up to 8 unknowns, 4140 partitions
    one_or_each,  ///< one group of all, and a group each
    one           ///< one group of all, the total degree: above 20 unknowns
};

/// The smallest number of those compared. G: a group for each unknown.
template <class G>
struct GroupingNumber {
    PathCount number;            ///< of paths
    G grouping;                  ///< the group of each unknown by which that number comes
    ComparedGroupings compared;  ///< which groupings there were to choose from
};
/// What smallest_multihomogeneous_number returns.
template <Model M>
using SmallestGrouping = GroupingNumber<Grouping<M>>;

namespace detail {

/// The number of every partition of the unknowns against `best`, which is one group of all: the smallest, of those the
/// fewest groups, of those the first in lexicographic order.
template <class Count, class G>
constexpr void compare_partitions(GroupingNumber<G>& best, const DegreesInSets& degrees, int angles) {
    int fewest = 1;
    GroupingSearch<Count>(degrees).for_each([&](Count ways, const std::vector<int>& grouping, int groups) {
        PathCount number{ways};
        for (int i = 0; i < angles; ++i) number = number * PathCount{2};
        if (best.number < number || (best.number == number && fewest < groups)) return;
        if (best.number == number && fewest == groups && !std::ranges::lexicographical_compare(grouping, best.grouping))
            return;
        best.number = number, fewest = groups;
        std::ranges::copy(grouping, best.grouping.begin());
    });
}

/// Compares `best`, which is one group of all, with the other groupings; number_of: of one of them.
template <class G>
constexpr void compare_groupings(GroupingNumber<G>& best, const auto& support, int angles, auto number_of) {
    const int n = static_cast<int>(best.grouping.size());
    if (n <= 8) {
        best.compared = ComparedGroupings::all;
        if (n < 2) return;
        const DegreesInSets degrees(support, n);
        if (degrees.most() < 0x1p62)
            compare_partitions<std::int64_t>(best, degrees, angles);
        else
            compare_partitions<PathCount>(best, degrees, angles);
    } else if (n <= 20) {
        best.compared = ComparedGroupings::one_or_each;
        G each = best.grouping;
        for (int u = 0; u < n; ++u) each[at(u)] = u;
        if (const PathCount number = number_of(each); number < best.number) best.number = number, best.grouping = each;
    }
}

}  // namespace detail

/// The smallest multihomogeneous number, and the first grouping that has it; fewer groups come first.
template <Model M>
constexpr SmallestGrouping<M> smallest_multihomogeneous_number() {
    SmallestGrouping<M> best{total_degree_count<M>(), {}, ComparedGroupings::one};
    detail::compare_groupings(best, Formulation<M>::support, n_angles<M>,
                              [](const Grouping<M>& grouping) { return multihomogeneous_number<M>(grouping); });
    return best;
}

}  // namespace equilibria
