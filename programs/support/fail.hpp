// How a program refuses what it was given: one line on stderr, exit status 2.
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

namespace support {

/// What the error messages begin with; `parse` sets it.
inline std::string program = "program";

/// Whether this process says what is wrong: of several that run together one does (ranks.hpp).
inline bool speaks = true;

/// Prints "program: text" and ends with status 2. Control characters, which could break the line, come out as '?'.
[[noreturn]] inline void refuse(std::string_view text) {
    std::string line = program + ": " + std::string(text);
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
    if (speaks) std::cerr << line << '\n';
    std::exit(2);
}

/// "program: --option value: what is allowed".
[[noreturn]] inline void fail(std::string_view option, std::string_view value, std::string_view allowed) {
    refuse(std::string(option) + (value.empty() ? "" : " ") + std::string(value) + ": " + std::string(allowed));
}

}  // namespace support
