/// \file
/// Where a curve of cusps is followed, and what comes of it: points, ends, and the transitions on the way.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <equilibria/continuation/branch_options.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/window.hpp>
#include <equilibria/locus/plane/curve_end.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

/// How a curve of cusps is followed.
struct CuspCurveOptions {
    /// In radians, units of the coordinates and of the unit null vector, and parts of the box; parameter_weight is set
    /// by it.
    BranchOptions branch{.first_step = 1e-3,
                         .largest_step = 0.01,
                         .largest_angle = 0.15,
                         .largest_miss = std::numeric_limits<double>::infinity()};
    int most_points = 20000;  ///< of each way

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(most_points > 1, "most_points", most_points, "must be more than 1");
        branch.validate();
    }
};

/// A point of a curve of cusps at which something changes.
template <PotentialModel M>
struct CuspTransition {
    std::size_t step = 0;  ///< between points step and step + 1
    /// What it is, with the evidence. Where Newton's method did not confirm what changed sign on the curve: the point
    /// of the curve, `undecided` and not `converged`.
    Singularity<M> at;
};

/// A curve of cusps, with what happens on it.
template <PotentialModel M>
struct CuspCurve {
    /// Cusps in order, none where no cusp was found to start from: the null vector v is continuous along the curve, and
    /// derivative(4) the reduced fourth derivative.
    std::vector<Singularity<M>> points;
    /// At the first point, at the last. `symmetric`: at the last transition. `degenerate`: within 1e-6 of a face.
    std::array<CurveEnd, 2> ends{CurveEnd::step, CurveEnd::step};
    std::vector<CuspTransition<M>> transitions;  ///< in the order of the points
};

}  // namespace equilibria
