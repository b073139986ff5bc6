// How a program refuses what it was given: one line on stderr, exit status 2.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

namespace support {

/// What the error messages begin with; `parse` sets it.
inline std::string program = "program";

/// Prints "program: --option value: what is allowed" and ends with status 2. Control characters in the value, which
/// could break the line, come out as '?'.
[[noreturn]] inline void fail(std::string_view option, std::string_view value, std::string_view allowed) {
    std::string line = program + ": " + std::string(option);
    if (!value.empty()) line += " " + std::string(value);
    line += ": " + std::string(allowed);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    std::cerr << line << '\n';
    std::exit(2);
}

}  // namespace support
