/// \file
/// Random draws from the caller's generator. The standard's distributions may differ between libraries, these do not:
/// the same seed gives the same start system everywhere.
#pragma once

#include <complex>
#include <cstdint>
#include <numbers>
#include <random>

#include <equilibria/core/splitmix.hpp>

namespace equilibria {

using Generator = std::mt19937_64;  ///< the only source of randomness here; always the caller's

/// Uniform in [0, 1), 53 bits.
inline double uniform(Generator& generator) { return unit_interval(generator()); }

/// Uniform in [low, high).
inline double uniform(Generator& generator, double low, double high) { return low + (high - low) * uniform(generator); }

/// Uniform on the unit circle of the complex plane.
inline std::complex<double> unit_complex(Generator& generator) {
    return std::polar(1.0, 2 * std::numbers::pi * uniform(generator));
}

}  // namespace equilibria
