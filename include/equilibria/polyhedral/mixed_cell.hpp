/// \file
/// A mixed cell of supports and a lifting, what cells are found with, and what is known at the end: see
/// polyhedral/mixed_cells.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <equilibria/run/executor.hpp>

namespace equilibria {

/// A height for each column of the supports, from -2^60 to 2^60; cells are those of the lower hull.
using Lifting = std::vector<std::int64_t>;

/// A mixed cell of a lifting w: a pair of points of each equation whose lifted points lie on a common plane, (gamma,
/// beta), with no point of that equation below it. What the spans show lasts until the sink returns.
struct MixedCell {
    /// The numbers of the two points of each equation in its support, the smaller first.
    std::span<const std::array<int, 2>> edges;
    /// |det| of the edges' vectors: the number of roots of the binomial system of the cell.
    std::uint64_t volume = 0;
    /// A number for each column, volume * (w_{i,a} + <gamma, a> - beta_i): how far above the cell's plane, exactly 0
    /// at the edges.
    std::span<const std::int64_t> heights;

    /// No other column has height 0. A cell that is not fine is one of the cells into which lexicographic
    /// perturbations divide a larger one: liftings with ties have them.
    bool fine() const {
        const auto zeros = static_cast<std::size_t>(std::count(heights.begin(), heights.end(), std::int64_t{0}));
        return zeros == 2 * edges.size();
    }
};

/// What mixed cells are found with. Only the order of the cells and the counts of exchanges depend on it, and which
/// cells stand for one that is not fine, where a lifting has ties.
struct MixedCellOptions {
    /// The numbers of the equations in the order in which they are taken; empty: one after another, that which brings
    /// the least degree and new unknowns. Of twelve random orders the best has 0.6 to 1.4 times as many exchanges, the
    /// worst 1 to 2.3 times, over the families of bench/peers/mixed_volumes.
    std::vector<int> order = {};
    /// The threads that the branches of the tree are divided over. The cells and their order do not depend on it.
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
    /// Exchanges in tables of 32 bits, of 64 bits, without limit.
    std::array<std::uint64_t, 3> exchanges_by_width = {};
    /// The order in which the equations were taken.
    std::vector<int> order;
    /// The walk was not ended by the sink or by a cancel, before all cells were found, nor at the most volume: that is
    /// `value` then, and the mixed volume is larger.
    bool complete = true;
};

}  // namespace equilibria
