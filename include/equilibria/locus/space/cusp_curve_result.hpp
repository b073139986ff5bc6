/// \file
/// Where a curve of cusps is followed, and what comes of it: points, ends, and the transitions on the way.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <equilibria/continuation/path_options.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

/// Where a curve of cusps is followed.
struct CuspBox {
    double x_low, x_high, y_low, y_high, z_low, z_high;

    bool contains(double x, double y, double z) const {
        return x >= x_low && x <= x_high && y >= y_low && y <= y_high && z >= z_low && z <= z_high;
    }
    /// Throws InvalidArgument unless every range is finite and not empty.
    void validate() const {
        const auto check = [](double low, double high, const char* name) {
            require(std::isfinite(low), name, low, "must be finite");
            require(std::isfinite(high) && high > low, name, high, "must be finite and above the lower bound");
        };
        check(x_low, x_high, "box.x");
        check(y_low, y_high, "box.y");
        check(z_low, z_high, "box.z");
    }
};

struct CuspCurveOptions {
    /// In radians, units of the coordinates and of the unit null vector, and parts of the box; parameter_weight is set
    /// by it.
    PathOptions path{.first_step = 1e-3, .largest_step = 0.01, .largest_angle = 0.15};
    int most_points = 20000;  ///< of each way

    void validate() const {
        require(most_points > 1, "most_points", most_points, "must be more than 1");
        path.validate();
    }
};

/// Why a curve of cusps ends.
enum class CuspCurveEnd {
    box,         ///< on a face of the box
    closed,      ///< where it began
    symmetric,   ///< on a symmetric branch, where it meets its mirror image: the last transition
    degenerate,  ///< within 1e-6 of a face of the box where the step control gave up: the model is degenerate on it
    step,        ///< the step control gave up elsewhere
    length       ///< too many points
};

constexpr const char* to_string(CuspCurveEnd end) {
    switch (end) {
        case CuspCurveEnd::box: return "box";
        case CuspCurveEnd::closed: return "closed";
        case CuspCurveEnd::symmetric: return "symmetric";
        case CuspCurveEnd::degenerate: return "degenerate";
        case CuspCurveEnd::step: return "step";
        case CuspCurveEnd::length: return "length";
    }
    return "unknown";
}

template <PotentialModel M>
struct CuspCurvePoint {
    double x = 0, y = 0, z = 0;  ///< the three parameters
    Unknowns<M> q;               ///< the cusp
    Unknowns<M> v;               ///< its unit null vector, continuous along the curve
    double fourth = 0;           ///< b, the reduced fourth derivative
};

template <PotentialModel M>
struct CuspTransition {
    std::size_t step = 0;  ///< between points step and step + 1
    double x = 0, y = 0, z = 0;
    /// What it is, with the evidence. Where Newton's method did not confirm what changed sign on the curve: the point
    /// of the curve, `undecided` and not `converged`.
    Singularity<M> at;
};

template <PotentialModel M>
struct CuspCurve {
    std::vector<CuspCurvePoint<M>> points;  ///< in order; none where no cusp was found to start from
    std::array<CuspCurveEnd, 2> ends{CuspCurveEnd::step, CuspCurveEnd::step};  ///< at the first point, at the last
    std::vector<CuspTransition<M>> transitions;                                ///< in the order of the points
};

}  // namespace equilibria
