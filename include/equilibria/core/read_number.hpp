/// \file
/// Numbers from text, exactly rounded and whatever the locale.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <string>
#include <system_error>
#include <version>

#ifndef __cpp_lib_to_chars
#include <cerrno>
#include <cmath>
#include <cstdlib>
#endif

namespace equilibria::detail {

/// As std::from_chars. Where the C++ library has none for doubles, as libc++, it is strtod, of decimal digits alone;
/// programs that set a locale with another point need the former.
inline std::from_chars_result read_number(const char* first, const char* last, double& value) {
#ifdef __cpp_lib_to_chars
    return std::from_chars(first, last, value);
#else
    const std::string text(first, last);
    const std::size_t sign = text.starts_with('-') ? 1 : 0;
    if (text.size() == sign || !(('0' <= text[sign] && text[sign] <= '9') || text[sign] == '.'))
        return {first, std::errc::invalid_argument};
    const std::string number = text.substr(0, text.find_first_of("xX"));  // behind 0 it would begin a hexadecimal one
    char* end = nullptr;
    errno = 0;
    const double read = std::strtod(number.c_str(), &end);
    const auto length = end - number.c_str();
    if (length == 0) return {first, std::errc::invalid_argument};
    if (errno == ERANGE && (std::isinf(read) || read == 0)) return {first + length, std::errc::result_out_of_range};
    value = read;
    return {first + length, {}};
#endif
}
/// An integer, as std::from_chars.
template <std::integral T>
std::from_chars_result read_number(const char* first, const char* last, T& value) {
    return std::from_chars(first, last, value);
}

}  // namespace equilibria::detail
