/// \file
/// How many paths a model's formulations need, side by side: upper bounds on the number of its isolated complex
/// equilibria. The number of paths decides the cost of an enumeration, and formulations differ by orders of magnitude,
/// so they are counted before one is tracked.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/model/model.hpp>

namespace equilibria {

/// Baillieul's estimate for chains, Theorems 3.1 and 3.2: where every equation has degree 2 in angles alone and is odd
/// under theta -> -theta, the 2^n points with every sine zero are equilibria, and there are at most 4^n isolated ones.
struct ChainEstimate {
    PathCount at_least;  ///< number of equilibria that there always are, 2^n
    PathCount at_most;   ///< bound of the number of isolated ones, 4^n
};

/// The estimate, where the model is such a chain.
template <Model M>
constexpr std::optional<ChainEstimate> chain_estimate() {
    if (!Formulation<M>::reflection_symmetric) return {};
    ChainEstimate e{{1, false}, {1, false}};
    for (int d : Formulation<M>::degrees) {
        if (d != 2) return {};
        e.at_least = e.at_least * PathCount{2, false};
        e.at_most = e.at_most * PathCount{4, false};
    }
    return e;
}

/// The bounds of one model, side by side.
struct Bounds {
    int angles = 0;                           ///< number of angles
    int coordinates = 0;                      ///< number of plain coordinates
    PathCount total_degree;                   ///< number of Bezout in (cos, sin) of the angles and the coordinates
    std::optional<PathCount> one_group_each;  ///< none above 20 unknowns
    PathCount multihomogeneous;               ///< the smallest of the groupings compared
    std::vector<int> grouping;                ///< the one that has it: the group of each unknown
    ComparedGroupings compared = ComparedGroupings::one;  ///< which groupings that was
    std::optional<ChainEstimate> chain;                   ///< none where the model is no such chain
    std::optional<PathCount> mixed_volume;                ///< of the system in (cos, sin), where it was computed
    std::optional<PathCount> laurent_mixed_volume;        ///< of the system in exp(i theta), where it was computed

    /// The least number of paths that reaches every isolated equilibrium, of those known here.
    PathCount smallest() const {
        PathCount least = std::min(total_degree, multihomogeneous);
        for (const auto& other : {mixed_volume, laurent_mixed_volume})
            if (other) least = std::min(least, *other);
        return least;
    }

    /// A table of several lines, ending in a new line.
    friend std::ostream& operator<<(std::ostream& out, const Bounds& b) {
        out << b.angles << (b.angles == 1 ? " angle" : " angles");
        if (b.coordinates > 0) out << ", " << b.coordinates << (b.coordinates == 1 ? " coordinate" : " coordinates");
        out << "\n  total degree            " << b.total_degree;
        if (b.one_group_each) out << "\n  a group each unknown    " << *b.one_group_each;
        out << "\n  multihomogeneous        " << b.multihomogeneous << "  ";
        const int groups = detail::n_groups(b.grouping);
        for (int g = 0; g < groups; ++g) {
            const char* separator = "{";
            for (std::size_t u = 0; u < b.grouping.size(); ++u) {
                if (b.grouping[u] != g) continue;
                const int k = static_cast<int>(u) + 1;
                out << separator << (k <= b.angles ? "theta" : "x") << (k <= b.angles ? k : k - b.angles);
                separator = " ";
            }
            out << "}";
        }
        switch (b.compared) {
            case ComparedGroupings::all: out << ", least of all groupings"; break;
            case ComparedGroupings::one_or_each: out << ", the lesser of one group and a group each"; break;
            default: out << ", the only grouping tried"; break;
        }
        if (b.mixed_volume) out << "\n  mixed volume            " << *b.mixed_volume;
        if (b.laurent_mixed_volume) out << "\n  Laurent mixed volume    " << *b.laurent_mixed_volume;
        if (b.chain) out << "\n  estimate for chains     " << b.chain->at_least << " to " << b.chain->at_most;
        return out << "\n";
    }
};

/// What degrees alone say; the mixed volumes are left empty.
template <Model M>
Bounds bounds() {
    Bounds b;
    b.angles = n_angles<M>;
    b.coordinates = n_coordinates<M>;
    b.total_degree = total_degree_count<M>();
    if constexpr (n_unknowns<M> <= 20) b.one_group_each = multihomogeneous_number<M>(one_group_each<M>());
    const auto smallest = smallest_multihomogeneous_number<M>();
    b.multihomogeneous = smallest.number;
    b.grouping.assign(smallest.grouping.begin(), smallest.grouping.end());
    b.compared = smallest.compared;
    b.chain = chain_estimate<M>();
    return b;
}

}  // namespace equilibria
