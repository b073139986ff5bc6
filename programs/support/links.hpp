// What programs for a number of links known at run time share.
#pragma once

#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace support {

/// Calls call(std::integral_constant<int, links>), links being 1 to Most.
template <int Most, class Result>
Result for_links(int links, const auto& call) {
    using Function = Result (*)(decltype(call));
    static constexpr auto functions = []<int... K>(std::integer_sequence<int, K...>) {
        return std::array<Function, Most>{
            [](decltype(call) f) -> Result { return f(std::integral_constant<int, K + 1>()); }...};
    }(std::make_integer_sequence<int, Most>{});
    return functions[static_cast<std::size_t>(links - 1)](call);
}

/// The values with spaces between.
std::string joined(const auto& values) {
    std::ostringstream out;
    for (const char* separator = ""; const auto& value : values) out << std::exchange(separator, " ") << value;
    return out.str();
}

}  // namespace support
