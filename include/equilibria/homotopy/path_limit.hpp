/// \file
/// The limit of a path at t = 1, in logarithms of the unknowns and of 1 - t, with many digits: finite, singular, or at
/// infinity, each with what shows it.
///
/// With zeta = log z and s = -log(1 - t) a path to infinity, or to a coordinate 0, becomes a straight line: its slope
/// is the direction in which it leaves, and units do not matter. A path counts as one to infinity if its leading terms
/// say so: the terms of each equation that grow fastest along the direction must vanish together, to the rounding of
/// the digits, at a point that Newton's method finds next to the path. These are the equations' face systems, whose
/// roots are the only places at infinity (Bernstein's second theorem). Source: D. N. Bernstein, The number of roots of
/// a system of equations, Functional Analysis and its Applications 9 (1975) 183-185; B. Huber, J. Verschelde,
/// Polyhedral end games for polynomial continuation, Numerical Algorithms 18 (1998) 91-108.
///
/// It fails for a root that is farther than 1e7 out, in scaled units, next to a simple root at infinity: it counts as
/// that one. Next to a multiple root at infinity a path stays open. Simple roots were told apart down to 1e-12 of their
/// size.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/laurent_column.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// What a path tends to.
enum class LimitKind : std::uint8_t {
    finite,       ///< a regular root, to which Newton's method converges quadratically
    singular,     ///< a finite point at which the path slows down
    at_infinity,  ///< a root of the face system of `direction`
    open          ///< none of these could be shown
};

/// A point of a path to more digits than a double has.
struct PathPoint {
    double r;  ///< 1 - t there
    std::vector<std::array<std::vector<double>, 2>>
        z;  ///< real and imaginary parts of each unknown, as sums of doubles
};

/// The limit of one path, with what shows it.
struct PathLimit {
    LimitKind kind = LimitKind::open;  ///< what the path tends to
    std::vector<std::complex<double>>
        z;  ///< finite, singular: the limit, 0 of a coordinate that vanishes; else the last point
    std::vector<double> direction;  ///< growth d log|z| / d s of each unknown
    double residual = 0;            ///< of the equations there, or of the face system: against the size of their terms
    double r = 1;                   ///< 1 - t at the last point
    int steps = 0;                  ///< predictor-corrector steps, refused ones included
    int digits = 31;                ///< decimal digits of the arithmetic
    std::string reason;             ///< why the path is open
    bool to_multiple_root = false;  ///< open, since near a multiple root at infinity far roots may be hidden
    /// Singular: the path on its way, at 1 - t = 1e-16 with 31 digits; at 1e-32, 1e-44 and 1e-56 with 64.
    std::vector<PathPoint> points;
};

/// The limit of the path through z at 1 - t = r, which is given to a double's digits. digits: 31 (sums of two doubles)
/// or 64.
PathLimit follow_to_limit(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns,
                          std::vector<std::complex<double>> z, double r, int digits, int most_steps = 1500);

/// A direction as small integers over their common denominator: "(1, -2)/3".
std::string direction_in_words(const std::vector<double>& direction);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/homotopy/detail/path_limit_definitions.hpp>
#endif
