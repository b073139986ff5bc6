/// \file
/// How a branch is followed: predictor, constraint of the corrector, and step control.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/error.hpp>

namespace equilibria {

/// Where the corrector looks for the branch, a step h away from the last point.
enum class StepConstraint {
    normal_plane,   ///< in the plane through the predicted point, normal to the predictor (pseudo-arclength)
    updated_plane,  ///< in planes through the latest iterate, normal to the whole increment
    sphere,         ///< at the distance h (Crisfield, parameter included)
    cylinder,       ///< at the distance h of the unknowns alone (Crisfield)
    unknown,        ///< where one unknown has moved by the predicted amount
    parameter,      ///< at the predicted parameter: load control, which fails at folds
    scalar,         ///< where problem.control(q, p) has changed by the predicted amount
};

/// How the next point is guessed.
enum class Predictor {
    tangent,    ///< along the tangent at the last point
    secant,     ///< along the chord from the point before the last
    quadratic,  ///< the parabola through the last two points with the tangent at the last
    cubic,      ///< the cubic with the tangents at both, of an error of fourth order
};

/// Lengths of steps are by the norm of branch_stepper.hpp: unknowns in their own units (angles in radians), weighted by
/// the problem, and the parameter in its unit, weighted by parameter_weight.
struct BranchOptions {
    double first_step = 0.05;     ///< length of the first step
    double smallest_step = 1e-9;  ///< the branch ends where this one does not converge either
    double largest_step = 0.2;    ///< no step is longer
    double largest_angle = 0.35;  ///< between neighbouring tangents, radians
    /// Distance of the unknowns from where they are predicted, over the way that they move; infinity: not looked at.
    double largest_miss = 0.25;
    int most_corrections = 8;  ///< of Newton's method in a step, before the step is shortened
    double tolerance = 1e-11;  ///< of the last correction, over the size of the unknowns
    StepConstraint constraint = StepConstraint::normal_plane;  ///< what fixes the length of a step
    Predictor predictor = Predictor::cubic;                    ///< where the corrector starts
    Eigen::Index controlled = 0;                               ///< the unknown of StepConstraint::unknown
    /// Theta, in lengths per unit of p; 0: chosen at the start, where it is the largest of three rates. They are
    /// |dq/dp|, 5 largest_step / parameter_span, and, where the start hardly moves, that at which the weakest
    /// eigenvalue changes.
    double parameter_weight = 0;
    /// Width of the range of p that is followed, in its unit; 0: not known. Where theta is chosen, no step crosses
    /// more than a fifth of it.
    double parameter_span = 0;
    /// From so many times the multiplications of a solution on that a factorisation takes, all corrections but the last
    /// one are made by GMRES with the last factors.
    double iterate_from = 75;
    int most_sign_changes = 1;  ///< of eigenvalues in a step, before it is halved
    double resolution = 1e-4;   ///< a step is not halved below this, nor below 1e-4 of the way from the start, for the
                                ///< sake of eigenvalues

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(smallest_step > 0, "smallest_step", smallest_step, "must be positive");
        require(first_step >= smallest_step, "first_step", first_step, "must be at least smallest_step");
        require(largest_step >= first_step, "largest_step", largest_step, "must be at least first_step");
        require(largest_angle > 0 && largest_angle < 1.5, "largest_angle", largest_angle, "must be in (0, 1.5)");
        require(largest_miss > 0, "largest_miss", largest_miss, "must be positive");
        require(most_corrections >= 2, "most_corrections", most_corrections, "must be at least 2");
        require(tolerance > 0, "tolerance", tolerance, "must be positive");
        require(parameter_weight >= 0, "parameter_weight", parameter_weight, "must be 0 (chosen) or positive");
        require(parameter_span >= 0, "parameter_span", parameter_span, "must be 0 (not known) or positive");
        require(iterate_from >= 0, "iterate_from", iterate_from, "must not be negative");
        require(controlled >= 0, "controlled", controlled, "must be the number of an unknown");
        require(resolution >= smallest_step, "resolution", resolution, "must be at least smallest_step");
    }
};

}  // namespace equilibria
