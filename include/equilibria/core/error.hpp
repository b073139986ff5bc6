/// \file
/// Errors for broken preconditions: each names the argument, quotes its value and says what is allowed.
/// Expected numerical failures are never exceptions: they are statuses in the results.
#pragma once

#include <cmath>
#include <complex>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// A broken precondition. `what()` reads "<argument> = <value>: <what is allowed>".
class InvalidArgument : public std::invalid_argument {
public:
    /// The three parts of `what()`.
    InvalidArgument(std::string_view argument, std::string_view value, std::string_view allowed);
};

namespace detail {
std::string number_text(double value);
std::string number_text(long double value);
template <class T>
inline constexpr bool is_complex = false;
template <class R>
inline constexpr bool is_complex<std::complex<R>> = true;
}  // namespace detail

/// Writes a value for an error message, with every digit of a floating-point number. Of other types than numbers,
/// complex numbers and strings: what their member text(digits) or str(digits) gives.
template <class T>
std::string to_text(const T& value) {
    if constexpr (std::is_integral_v<T>)
        return std::to_string(value);
    else if constexpr (std::is_floating_point_v<T>)
        return detail::number_text(value);
    else if constexpr (std::is_convertible_v<const T&, std::string_view>)
        return std::string(std::string_view(value));
    else if constexpr (detail::is_complex<T>)
        return "(" + to_text(value.real()) + "," + to_text(value.imag()) + ")";
    else if constexpr (requires { value.text(17); })
        return value.text(17);
    else
        return value.str(17);
}

/// Throws InvalidArgument unless `holds`.
template <class T>
void require(bool holds, std::string_view argument, const T& value, std::string_view allowed) {
    if (!holds) throw InvalidArgument(argument, to_text(value), allowed);
}

/// Throws InvalidArgument unless every entry of `values` is finite; names the entry as argument[k].
void require_finite(std::span<const double> values, std::string_view argument);
/// Of entries of another type: float, multiprecision or whatever else has an isfinite.
template <class Range>
requires(!std::is_convertible_v<const Range&, std::span<const double>>)
void require_finite(const Range& values, std::string_view argument) {
    int k = 0;
    for (const auto& value : values) {
        using std::isfinite;
        if (!isfinite(value))
            require(false, std::string(argument) + "[" + std::to_string(k) + "]", value, "must be finite");
        ++k;
    }
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/core/detail/error_definitions.hpp>
#endif
