#include "support/catch.hpp"

#include <cstddef>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include <equilibria/core/read_number.hpp>

using equilibria::detail::read_number;

TEST_CASE("Numbers are read to the last bit, and no farther than they go") {
    const auto read = [](const std::string& text, double& value) {
        const auto [end, error] = read_number(text.data(), text.data() + text.size(), value);
        return std::pair(static_cast<std::size_t>(end - text.data()), error);
    };
    double value = 7;
    for (const auto& [text, expected, length] : {std::tuple<std::string, double, std::size_t>{"0.1", 0.1, 3},
                                                 {"-2.5e-3x", -2.5e-3, 7},
                                                 {".5", 0.5, 2},
                                                 {"17", 17, 2},
                                                 {"9007199254740993", 9007199254740992.0, 16},
                                                 {"0x10", 0, 1},
                                                 {"4.9e-324", 4.9e-324, 8}}) {
        INFO(text);
        CHECK(read(text, value) == std::pair(length, std::errc{}));
        CHECK(value == expected);
    }
    value = 7;
    for (const char* text : {"", "-", "x", " 1", "+1"})
        CHECK(read(text, value) == std::pair(std::size_t{0}, std::errc::invalid_argument));
    CHECK(read("1e999", value).second == std::errc::result_out_of_range);
    CHECK(read("1e-999", value).second == std::errc::result_out_of_range);
    CHECK(value == 7);

    const std::string text = "12,";
    int integer = 0;
    CHECK(read_number(text.data(), text.data() + text.size(), integer).ptr == text.data() + 2);
    CHECK(integer == 12);
}
