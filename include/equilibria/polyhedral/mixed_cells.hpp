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

#include <concepts>
#include <functional>
#include <type_traits>

#include <equilibria/core/compiled.hpp>
#include <equilibria/polyhedral/mixed_cell.hpp>
#include <equilibria/polyhedral/supports.hpp>

namespace equilibria {

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
