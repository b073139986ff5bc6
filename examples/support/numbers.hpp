// Numbers, lists of numbers and ranges from the command line, checked; whatever is wrong ends the program by `fail`.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fail.hpp"

namespace support {

/// The whole text as a number, or nothing; a sign '+' is allowed.
template <class T>
std::optional<T> parsed(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

/// What an empty value looks like in a message.
inline std::string shown(const std::string& text) { return text.empty() ? "''" : text; }

/// A finite number for which `holds`; `allowed` says which those are.
template <std::predicate<double> Holds>
double number(std::string_view option, const std::string& text, std::string_view allowed, Holds holds) {
    const auto value = parsed<double>(text);
    if (!value || !std::isfinite(*value) || !holds(*value)) fail(option, shown(text), allowed);
    return *value;
}

/// An integer from `low` to `high`.
template <std::integral T>
T integer(std::string_view option, const std::string& text, T low, T high) {
    const auto value = parsed<T>(text);
    if (!value || *value < low || *value > high)
        fail(option, shown(text), "must be an integer from " + std::to_string(low) + " to " + std::to_string(high));
    return *value;
}

/// `size` positive finite numbers with commas between them.
inline std::vector<double> positive_list(std::string_view option, const std::string& text, int size) {
    const std::string allowed = size == 1
                                    ? "must be 1 positive number"
                                    : "must be " + std::to_string(size) + " positive numbers, with commas between";
    std::vector<double> values;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const auto value = parsed<double>(std::string_view(text).substr(at, comma - at));
        if (!value || !std::isfinite(*value) || *value <= 0) fail(option, shown(text), allowed);
        values.push_back(*value);
        at = comma + 1;
    }
    if (values.size() != static_cast<std::size_t>(size)) fail(option, shown(text), allowed);
    return values;
}

struct Range {
    double low, high;
};

/// "a:b" with finite a < b, both in [least, most].
inline Range range(std::string_view option, const std::string& text, std::string_view allowed, double least,
                   double most) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) fail(option, shown(text), allowed);
    const auto low = parsed<double>(std::string_view(text).substr(0, colon));
    const auto high = parsed<double>(std::string_view(text).substr(colon + 1));
    if (!low || !high || !(*low >= least && *high <= most && *low < *high) || !std::isfinite(*high - *low))
        fail(option, shown(text), allowed);
    return {*low, *high};
}

}  // namespace support
