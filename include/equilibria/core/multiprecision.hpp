/// \file
/// Floats of more digits, opt-in: this header costs every unit that includes it seconds of compile time.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace equilibria {

/// A float of so many decimal digits. Without expression templates, which generic code does not see through.
template <unsigned Digits>
using Float =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>, boost::multiprecision::et_off>;

}  // namespace equilibria
