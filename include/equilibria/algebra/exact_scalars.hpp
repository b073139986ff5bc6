/// \file
/// Polynomials over exact numbers: what cancels in them is exactly 0.
#pragma once

#include <cmath>

#include <equilibria/algebra/runtime_equations.hpp>
#include <equilibria/algebra/trigonometric_polynomial.hpp>
#include <equilibria/core/dual.hpp>
#include <equilibria/core/exact_ball.hpp>

namespace equilibria {

/// Midpoints are exact.
/// \{
template <>
inline constexpr bool exact_cancellation<ExactBall> = true;
template <int N>
inline constexpr bool exact_cancellation<Dual<ExactBall, N>> = true;
/// \}

/// True unless every number of the ball is 0, or the ball is the rounding of one that is 0.
inline bool may_differ_from_zero(const ExactBall& a) {
    // an exact number may be smaller than any double
    return !a.mid().is_zero() && (a.rad() == 0 || std::abs(a.mid().to<double>()) > a.rad());
}

}  // namespace equilibria

#ifdef EQUILIBRIA_COMPILED
namespace equilibria {
extern template class RuntimePool<ExactBall>;
extern template class RuntimeScalar<ExactBall>;
extern template class RuntimeAngle<ExactBall>;
extern template class RuntimePool<Dual<ExactBall, 2>>;
extern template class RuntimeScalar<Dual<ExactBall, 2>>;
extern template class RuntimeAngle<Dual<ExactBall, 2>>;
}  // namespace equilibria
#endif
