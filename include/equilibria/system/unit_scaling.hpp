/// \file
/// Units in which a system's coefficients are about 1: a power of two for each coordinate and each equation.
///
/// The logarithms of all coefficients are made as small as they can be, in the sense of least squares, by adding a
/// number to each equation and to each coordinate (times its exponent). Powers of two round nothing: the scaled system
/// is the system, written in other units. Source: A. Morgan, Solving Polynomial Systems Using Continuation for
/// Engineering and Scientific Problems, Prentice-Hall (1987), chapter 5 (SCLGEN).
///
/// Where it fails: roots of very different sizes have no common unit. Their paths are followed in logarithms then
/// (homotopy/path_limit.hpp).
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/system/sparse_system.hpp>

namespace equilibria {

/// Powers of two: coordinate x_u = 2^unknown[u] y_u, equation i times 2^equation[i].
struct UnitScaling {
    std::vector<int> unknown;   ///< one an unknown, 0 of an angle
    std::vector<int> equation;  ///< one an equation

    /// True if nothing is scaled.
    bool trivial() const;
    /// The unknowns in the units of the system, from those of the scaled one.
    void undo(std::span<std::complex<double>> q) const;
};

/// The units that make the coefficients' logarithms least in the sense of least squares. A coefficient that would
/// overflow or lose digits in them leaves everything as it is.
UnitScaling unit_scaling(const SparseSystem& system);

/// The system in these units, exactly.
SparseSystem scaled(const SparseSystem& system, const UnitScaling& units);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/system/detail/unit_scaling_definitions.hpp>
#endif
