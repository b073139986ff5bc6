/// \file
/// Mixed cells and mixed volumes of the supports of a Laurent system, in exact integers. The mixed volume bounds the
/// number of isolated roots with no coordinate 0, and is that number for almost all coefficients; the mixed cells of a
/// lifting are the starts of the paths of a polyhedral homotopy, as many paths from a cell as its volume.
///
/// Method: tropical regeneration. A mixed cell is known by its circuit table, in which the columns that spoil the cell
/// while the lifting changes are seen at once; a cell is left by one exchange of a column, as in the simplex algorithm,
/// and from each cell the cells behind its wall are those that the table names. A rule that lets one parent alone go on
/// to a cell with two makes the walk a tree: no cell is stored, none is visited twice, and branches are independent.
/// Equations are taken one at a time: the remaining ones are simplices, whose cells are known. Ties are broken by
/// infinitesimal liftings in lexicographic order, so that no random lifting has to be drawn, and drawn again.
///
/// The cost is that of the sum of the partial mixed volumes, those of the first equations and of simplices: the order
/// of the equations decides (MixedCellOptions::order). Where all supports are equal one volume of a polytope would do,
/// and this is wasteful. Nothing is rounded: tables begin in 32 bits, bounds are checked before every exchange, and a
/// branch that might not fit goes on in 64 bits and then without limit.
///
/// Sources: A. N. Jensen, Tropical homotopy continuation, arXiv:1601.02818 (2016). D. N. Bernstein, The number of roots
/// of a system of equations, Funct. Anal. Appl. 9 (1975) 183-185. B. Huber, B. Sturmfels, A polyhedral method for
/// solving sparse polynomial systems, Math. Comp. 64 (1995) 1541-1555.
#pragma once

#include <array>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/polyhedral/supports.hpp>
#include <equilibria/run/executor.hpp>

namespace equilibria {

/// A height for each column of the supports, from -2^60 to 2^60; cells are those of the lower hull.
using Lifting = std::vector<std::int64_t>;

/// A mixed cell of a lifting w: a pair of points of each equation whose lifted points lie on a common plane, (gamma,
/// beta), with no point of that equation below it. What the spans show lasts until the sink returns.
struct MixedCell {
    /// Of each equation the numbers of the two points in its support, the smaller first.
    std::span<const std::array<int, 2>> edges;
    /// |det| of the edges' vectors: the number of roots of the binomial system of the cell.
    std::uint64_t volume = 0;
    /// Of each column, volume * (w_{i,a} + <gamma, a> - beta_i): how far above the cell's plane, exactly 0 at the
    /// edges.
    std::span<const std::int64_t> heights;

    /// No other column has height 0. A cell that is not fine is one of the cells into which lexicographic
    /// perturbations divide a larger one: liftings with ties have them.
    bool fine() const;
};

/// What mixed cells are found with. Only the order of the cells and the counts of exchanges depend on it, and which
/// cells stand for one that is not fine, where a lifting has ties.
struct MixedCellOptions {
    /// The numbers of the equations in the order in which they are taken; empty: one after another, that which brings
    /// the least degree and new unknowns. Of twelve random orders the best has 0.6 to 1.4 times as many exchanges, the
    /// worst 1 to 2.3 times, over the families of bench/peers/mixed_volumes.
    std::vector<int> order = {};
    /// Over which the branches of the tree are divided. The cells and their order do not depend on it.
    Executor executor = {};
    /// mixed_volume() stops as soon as it knows that the mixed volume is larger.
    std::uint64_t most_volume = std::numeric_limits<std::uint64_t>::max();
    /// The walk ends soon after this has become true; the result is not complete then. It outlives the walk.
    const std::atomic<bool>* cancel = nullptr;
    /// The largest entries of tables of 32 and of 64 bits (1 or more); less than the types hold: tests of what is
    /// wider.
    /// \{
    std::int32_t largest_narrow = std::numeric_limits<std::int32_t>::max();
    std::int64_t largest_wide = std::numeric_limits<std::int64_t>::max();
    /// \}
};

/// A mixed volume and how it was found.
struct MixedVolume {
    /// The mixed volume: the sum of the volumes of the cells.
    std::uint64_t value = 0;
    /// The cells that it is the sum of: of the given lifting, or of the lexicographic one.
    std::uint64_t cells = 0;
    /// The walls that were crossed.
    std::uint64_t exchanges = 0;
    /// Of these, in tables of 32 bits, of 64 bits, without limit.
    std::array<std::uint64_t, 3> exchanges_by_width = {};
    /// The order in which the equations were taken.
    std::vector<int> order;
    /// The walk was not ended by the sink or by a cancel, before all cells were found, nor at the most volume: that is
    /// `value` then, and the mixed volume is larger.
    bool complete = true;
};

/// The mixed volume of the supports, exactly: 0 where the system has no isolated root for almost all coefficients.
/// Throws InvalidArgument where the options' order is not one of the equations, or the mixed volume is 2^64 or more.
MixedVolume mixed_volume(const Supports& supports, const MixedCellOptions& options = {});

namespace detail {
/// mixed_cells() with a sink that says whether to go on.
MixedVolume walk_mixed_cells(const Supports& supports, const Lifting& lifting,
                             const std::function<bool(const MixedCell&)>& sink, const MixedCellOptions& options);
}  // namespace detail

/// Calls sink(const MixedCell&) for each mixed cell of the lifting, one at a time, in an order that does not depend on
/// the executor; a sink that returns bool ends the walk by `false`. With a serial executor no cell is stored; with
/// another one those wait that are found before their turn. The volumes add up to the mixed volume whatever the
/// lifting. Throws InvalidArgument as mixed_volume() does, and where the lifting does not have a height for each
/// column, or a height of a cell does not fit into 64 bits. An exception of the sink ends the walk.
template <class Sink>
requires std::invocable<Sink&, const MixedCell&>
MixedVolume mixed_cells(const Supports& supports, const Lifting& lifting, Sink&& sink,
                        const MixedCellOptions& options = {}) {
    return detail::walk_mixed_cells(
        supports, lifting,
        [&sink](const MixedCell& cell) {
            if constexpr (std::is_same_v<std::invoke_result_t<Sink&, const MixedCell&>, bool>) {
                return sink(cell);
            } else {
                sink(cell);
                return true;
            }
        },
        options);
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/polyhedral/detail/mixed_cells_definitions.hpp>
#endif
