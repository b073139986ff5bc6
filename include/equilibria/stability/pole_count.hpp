/// \file
/// Stability of a linear motion by three criteria that check each other: its poles, Routh's table, Hurwitz's minors.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include <equilibria/stability/hurwitz.hpp>
#include <equilibria/stability/routh.hpp>
#include <equilibria/stability/second_order_system.hpp>

namespace equilibria {

/// A pole counts as on the imaginary axis when its real part is below this share of the largest pole.
inline constexpr double imaginary_pole = 1e-9;

/// What the poles say of a linear motion.
enum class StabilityVerdict {
    asymptotically_stable,  ///< all poles left of the imaginary axis
    marginal,  ///< poles on the axis, or so near that the criteria do not agree; none right of it for certain
    unstable,  ///< poles right of it
};

/// "stable", "marginal" or "unstable".
inline const char* to_string(StabilityVerdict verdict) {
    switch (verdict) {
        case StabilityVerdict::asymptotically_stable: return "stable";
        case StabilityVerdict::marginal: return "marginal";
        case StabilityVerdict::unstable: break;
    }
    return "unstable";
}

/// The poles of a linear motion, and what each criterion says of them.
template <class Matrix>
struct PoleCount {
    using System = SecondOrderSystem<Matrix>;  ///< M, D and C

    typename System::Polynomial polynomial;                 ///< from s^2n, whose coefficient is 1, to the constant
    typename System::Poles poles;                           ///< by real parts, the largest last
    RouthTable<typename System::Polynomial> routh;          ///< of the polynomial
    HurwitzCriterion<typename System::Polynomial> hurwitz;  ///< of the polynomial
    int right_of_axis = 0;                                  ///< poles right of the imaginary axis
    int on_axis = 0;                                        ///< poles on it, see imaginary_pole

    /// Poles right of the imaginary axis; nothing where the criteria do not agree. Of Hurwitz's minors nothing is asked
    /// where the last ones are zero.
    std::optional<int> right_half_plane() const {
        if (routh.right_half_plane != right_of_axis ||
            hurwitz.right_half_plane.value_or(right_of_axis) != right_of_axis)
            return {};
        return right_of_axis;
    }
    /// Whether poles lie on the axis, by any criterion, or too near for a count.
    bool marginal() const {
        return !right_half_plane() || on_axis > 0 || routh.imaginary_axis > 0 || !hurwitz.right_half_plane;
    }
    /// By all criteria; marginal where they do not agree.
    StabilityVerdict verdict() const {
        if (right_half_plane().value_or(0) > 0) return StabilityVerdict::unstable;
        return marginal() ? StabilityVerdict::marginal : StabilityVerdict::asymptotically_stable;
    }
};

/// Throws InvalidArgument where `system` is not one: see SecondOrderSystem::validate.
template <class Matrix>
PoleCount<Matrix> count_poles(const SecondOrderSystem<Matrix>& system) {
    system.validate();
    PoleCount<Matrix> y;
    y.polynomial = characteristic_polynomial(system);
    y.poles = poles(system);
    y.routh = routh_table(y.polynomial);
    y.hurwitz = hurwitz_criterion(y.polynomial);
    const auto largest = y.poles.cwiseAbs().maxCoeff();
    for (const auto& pole : y.poles) {
        if (std::abs(pole.real()) <= imaginary_pole * largest)
            ++y.on_axis;
        else
            y.right_of_axis += pole.real() > 0;
    }
    return y;
}

}  // namespace equilibria
