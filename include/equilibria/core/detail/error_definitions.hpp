/// \file
/// See core/error.hpp.
#pragma once

#include <algorithm>
#include <cstdio>

#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {
/// what() ends at a null character: none of the text is lost.
inline std::string without_null_characters(std::string text) {
    std::replace(text.begin(), text.end(), '\0', '?');
    return text;
}
}  // namespace detail

EQUILIBRIA_INLINE InvalidArgument::InvalidArgument(std::string_view argument, std::string_view value,
                                                   std::string_view allowed)
    : std::invalid_argument(detail::without_null_characters(std::string(argument) + " = " + std::string(value) + ": " +
                                                            std::string(allowed))) {}

EQUILIBRIA_INLINE void require_finite(std::span<const double> values, std::string_view argument) {
    for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isfinite(values[k]))
            require(false, std::string(argument) + "[" + std::to_string(k) + "]", values[k], "must be finite");
}

namespace detail {

EQUILIBRIA_INLINE std::string number_text(long double value) {
    char text[64];
    std::snprintf(text, sizeof text, "%.17Lg", value);
    std::string y = text;
    std::replace(y.begin(), y.end(), ',', '.');  // whatever the locale
    return y;
}
EQUILIBRIA_INLINE std::string number_text(double value) { return number_text(static_cast<long double>(value)); }

}  // namespace detail
}  // namespace equilibria
