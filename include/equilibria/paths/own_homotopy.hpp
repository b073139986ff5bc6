/// \file
/// Paths of a homotopy of a type of one's own: of a start with a law of time of its own (SparseHomotopy), or with
/// another predictor or step control (TrackedBy). The engine is compiled for that type.
#pragma once

#include <concepts>

#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/sparse_homotopy.hpp>
#include <equilibria/homotopy/tracking.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/paths/detail/path_solver.hpp>

namespace equilibria {

/// As of a PolynomialHomotopy.
template <class H, class StartSystem>
requires(!std::same_as<H, PolynomialHomotopy>)
PathSet track(const H& homotopy, const StartSystem& start, const RunOptions& run = {},
              const TrackerOptions& options = {}, MoreDigits<H> resort = nullptr) {
    return detail::PathSolver<H>(homotopy, {.start = StartPoints(start)}, run, options, resort).track();
}

/// As of a PolynomialHomotopy.
template <class H, class StartSystem>
requires(!std::same_as<H, PolynomialHomotopy>)
ComplexRoots<> complex_roots(const H& homotopy, const StartSystem& start, const RunOptions& run = {},
                             const TrackerOptions& options = {}, MoreDigits<H> resort = nullptr) {
    auto found = complex_roots(track(homotopy, start, run, options, resort));
    found.start = start.name();
    return found;
}

}  // namespace equilibria
