/// \file
/// Parameter values at which equilibria come from infinity, or go there: where a leading coefficient vanishes, or, with
/// several unknowns, where the equations have a root at infinity that generic values of the parameter have not.
///
/// The equilibria for all values of the parameter a form a curve. With x = X / u, sum_j r_j X_j = 1, r random, a point
/// at infinity of the coordinates x is one with u = 0. The points with u = u_1 are solved for, all complex ones, and
/// followed to u = 0: the finite limits of a are the values sought. Real equilibria far out, at small real u, say how
/// many come and go, and their indices. Angles stay where they are: a model of angles alone has no such values.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/sized_array.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/path_counts.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

/// A value of a parameter at which equilibria come from infinity, or go there.
struct InfinityEvent {
    double value = 0;  ///< of the parameter
    double error = 0;  ///< about
    /// Real equilibria that go to infinity as the parameter grows to the value, and that come from there above it.
    std::array<std::uint64_t, 2> equilibria{};
    /// By how much the numbers of equilibria of index 0, 1, .. n change; empty of models without a potential.
    std::vector<std::int64_t> change;
    bool decided = true;  ///< two distances from infinity agree about what comes and goes
};

/// All such values in a range, and the evidence.
struct InfinitySearch {
    std::vector<InfinityEvent> events;  ///< by value
    PathCounts paths;                   ///< to infinity, in the last attempt; none of a model without coordinates
    std::string start;                  ///< the start system of the points that they begin at
    std::uint64_t solutions = 0;        ///< complex values of the parameter, in the range or not
};

/// All values in `range` of the parameter number `active`. sizes: about those of the coordinates, positive.
InfinitySearch search_infinity(const SearchedModel& model, const RuntimeArray<double>& p, int active,
                               const Interval& range, const std::vector<double>& sizes, const RunOptions& run = {});

namespace detail {

/// Every isolated solution, as solve_least_cost; none where an equation is a constant other than 0. Where one vanishes
/// identically no solution is isolated, and none is returned either.
ComplexRoots<> solve_equations(const RuntimePolynomials<>& equations, const RuntimeSizes& sizes,
                               const std::vector<int>& grouping, const RunOptions& run, MoreDigits<> resort = nullptr);

}  // namespace detail

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/locus/line/detail/infinity_search_definitions.hpp>
#endif
