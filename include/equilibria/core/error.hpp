/// \file
/// Errors for broken preconditions: each names the argument, quotes its value and says what is allowed.
/// Expected numerical failures are never exceptions: they are statuses in the results.
#pragma once

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace equilibria {

/// A broken precondition. `what()` reads "<argument> = <value>: <what is allowed>".
class InvalidArgument : public std::invalid_argument {
public:
    InvalidArgument(std::string_view argument, std::string_view value, std::string_view allowed)
        : std::invalid_argument(std::string(argument) + " = " + std::string(value) + ": " + std::string(allowed)) {}
};

/// Writes a value for an error message, with every digit of a floating-point number.
template <class T>
std::string to_text(const T& value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << value;
    return out.str();
}

/// Throws InvalidArgument unless `holds`.
template <class T>
void require(bool holds, std::string_view argument, const T& value, std::string_view allowed) {
    if (!holds) throw InvalidArgument(argument, to_text(value), allowed);
}

/// Throws InvalidArgument unless every entry of `values` is finite; names the entry as argument[k].
template <class Range>
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
