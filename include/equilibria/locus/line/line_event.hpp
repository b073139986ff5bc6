/// \file
/// An event on a line of the parameter space: a degenerate equilibrium, its kind, and what it does to the equilibria by
/// index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <equilibria/continuation/critical_kind.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>

namespace equilibria {

/// A degenerate equilibrium on a line. M: the model, or RuntimeUnknowns.
template <class M>
struct LineEvent {
    CriticalKind kind = CriticalKind::fold;  ///< what the equilibrium is
    double value = 0;                        ///< of the active parameter
    UnknownArray<M, double> q;               ///< angles in (-pi, pi]
    UnknownArray<M, double> v;               ///< the unit null vector
    double residual = 0;                     ///< the largest |entry| of F and J v
    /// Of the last step of Newton's method: about the error. NaN of kinds other than fold and pitchfork.
    double correction = 0;
    ReducedCoefficients reduced;  ///< derivatives along v that decide between fold, cusp and pitchfork
    /// Of folds u . dF/dp, u the unit left null vector (v where there is a potential); else the derivative by p of the
    /// eigenvalue that vanishes, along the branch.
    double slope = 0;
    int index = 0;  ///< negative eigenvalues beside the one that vanishes
    /// By how much the numbers of equilibria of index 0, 1, .. n change as the parameter grows; of folds, pitchforks
    /// and trans-critical points of models with a potential. Else empty.
    std::vector<std::int64_t> change;
    std::size_t interval = 0;  ///< the first one above the event
};

}  // namespace equilibria
