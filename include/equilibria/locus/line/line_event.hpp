/// \file
/// An event on a line of the parameter space: a degenerate equilibrium, its kind, and what it does to the equilibria by
/// index; or a value of the parameter at which equilibria come from infinity, or are not isolated.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <equilibria/continuation/critical_kind.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>

namespace equilibria {

/// A degenerate equilibrium on a line. M: the model, or RuntimeUnknowns. Events without one (from_infinity, continuum,
/// unexplained) have a value, a kind and a change alone: their other numbers are NaN.
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
    /// trans-critical points and of what comes from infinity, of models with a potential. Else empty.
    std::vector<std::int64_t> change;
    std::optional<std::int64_t> change_in_number{};  ///< of equilibria, as the parameter grows; nothing if not known
    std::size_t interval = 0;                        ///< the first one above the event
    /// Equilibria that go to infinity as the parameter grows to the value, and that come from there above it.
    std::array<std::uint64_t, 2> at_infinity{};

    /// Whether there is an equilibrium to it.
    bool has_equilibrium() const {
        return kind != CriticalKind::from_infinity && kind != CriticalKind::continuum &&
               kind != CriticalKind::unexplained;
    }
};

}  // namespace equilibria
