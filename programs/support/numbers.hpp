// Numbers, lists of numbers and ranges from the command line, checked. What is called parsed_... gives nothing where
// the text is wrong, its namesake ends the program by `fail`.
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

/// A finite number for which `holds`, or nothing.
template <std::predicate<double> Holds>
std::optional<double> parsed_number(std::string_view text, Holds holds) {
    const auto value = parsed<double>(text);
    return value && std::isfinite(*value) && holds(*value) ? value : std::nullopt;
}

/// An integer from `low` to `high`, or nothing.
template <std::integral T>
std::optional<T> parsed_integer(std::string_view text, T low, T high) {
    const auto value = parsed<T>(text);
    return value && *value >= low && *value <= high ? value : std::nullopt;
}

/// `size` positive finite numbers with commas between them, or nothing.
inline std::optional<std::vector<double>> parsed_positive_list(std::string_view text, int size) {
    std::vector<double> values;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const auto value = parsed_number(text.substr(at, comma - at), [](double x) { return x > 0; });
        if (!value) return {};
        values.push_back(*value);
        at = comma + 1;
    }
    if (values.size() != static_cast<std::size_t>(size)) return {};
    return values;
}

struct Range {
    double low, high;
};

/// "a:b" with finite a < b, both in [least, most], or nothing.
inline std::optional<Range> parsed_range(std::string_view text, double least, double most) {
    const std::size_t colon = text.find(':');
    if (colon == text.npos) return {};
    const auto low = parsed<double>(text.substr(0, colon)), high = parsed<double>(text.substr(colon + 1));
    if (!low || !high || !(*low >= least && *high <= most && *low < *high) || !std::isfinite(*high - *low)) return {};
    return Range{*low, *high};
}

/// What an empty value looks like in a message.
inline std::string shown(const std::string& text) { return text.empty() ? "''" : text; }

template <std::predicate<double> Holds>
double number(std::string_view option, const std::string& text, std::string_view allowed, Holds holds) {
    const auto value = parsed_number(text, holds);
    if (!value) fail(option, shown(text), allowed);
    return *value;
}

template <std::integral T>
T integer(std::string_view option, const std::string& text, T low, T high) {
    const auto value = parsed_integer<T>(text, low, high);
    if (!value)
        fail(option, shown(text), "must be an integer from " + std::to_string(low) + " to " + std::to_string(high));
    return *value;
}

inline std::vector<double> positive_list(std::string_view option, const std::string& text, int size) {
    const auto values = parsed_positive_list(text, size);
    if (!values)
        fail(option, shown(text),
             size == 1 ? "must be 1 positive number"
                       : "must be " + std::to_string(size) + " positive numbers, with commas between");
    return *values;
}

inline Range range(std::string_view option, const std::string& text, std::string_view allowed, double least,
                   double most) {
    const auto value = parsed_range(text, least, most);
    if (!value) fail(option, shown(text), allowed);
    return *value;
}

}  // namespace support
