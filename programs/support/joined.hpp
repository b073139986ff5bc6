// Lists as text.
#pragma once

#include <sstream>
#include <string>
#include <utility>

namespace support {

/// The values with spaces between.
std::string joined(const auto& values) {
    std::ostringstream out;
    for (const char* separator = ""; const auto& value : values) out << std::exchange(separator, " ") << value;
    return out.str();
}

}  // namespace support
