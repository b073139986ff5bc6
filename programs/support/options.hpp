// Options of programs, typed by CLI11: what a value may be is a validator, which says it in one sentence and keeps the
// value as it was written. --help ends with status 0, any mistake with one line and status 2.
//
//     app.add_option("--omega", omega, "angular speed")->transform(support::finite());
//     support::parse(app, "rotating_chain", argc, argv);
//
// Numbers are read by std::from_chars, exactly rounded and whatever the locale. CLI11 reads them once more, by way of
// long double: so the validators hand them on in a form of which that leaves every bit.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
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

/// The numbers between separators, or nothing where one of them is none or not finite.
inline std::optional<std::vector<double>> parsed_list(std::string_view text, char separator) {
    std::vector<double> values;
    for (;;) {
        const std::size_t at = text.find(separator);
        const auto value = parsed<double>(text.substr(0, at));
        if (!value || !std::isfinite(*value)) return {};
        values.push_back(*value);
        if (at == text.npos) return values;
        text.remove_prefix(at + 1);
    }
}

/// What a value looks like in a message.
inline std::string shown(const std::string& text) { return text.empty() ? "''" : text; }

/// A validator's verdict on `text`: nothing where `good`.
inline std::string verdict(bool good, const std::string& text, const std::string& allowed) {
    return good ? std::string() : shown(text) + ": " + allowed;
}

using Predicate = std::function<bool(double)>;

/// A finite number for which `holds`.
inline CLI::Validator number(std::string allowed, Predicate holds) {
    return {[allowed = std::move(allowed), holds = std::move(holds)](std::string& text) {
                const auto value = parsed<double>(text);
                const bool good = value && std::isfinite(*value) && holds(*value);
                const std::string said = verdict(good, text, allowed);
                if (good) {
                    char hexadecimal[64];
                    const double size = std::abs(*value);
                    const auto end =
                        std::to_chars(hexadecimal, hexadecimal + sizeof hexadecimal, size, std::chars_format::hex);
                    text = (std::signbit(*value) ? "-0x" : "0x") + std::string(hexadecimal, end.ptr);
                }
                return said;
            },
            ""};
}
inline CLI::Validator finite(std::string allowed = "must be a finite number") {
    return number(std::move(allowed), [](double) { return true; });
}
inline CLI::Validator positive() {
    return number("must be a positive number", [](double x) { return x > 0; });
}
inline CLI::Validator not_negative(std::string allowed = "must be a number, 0 or more") {
    return number(std::move(allowed), [](double x) { return x >= 0; });
}
inline CLI::Validator number_from(double low, double high, std::string allowed) {
    return number(std::move(allowed), [=](double x) { return x >= low && x <= high; });
}

/// Both, of the value as it was written; the first one speaks first.
inline CLI::Validator both(CLI::Validator first, CLI::Validator second) {
    return {[first = std::move(first), second = std::move(second)](std::string& text) {
                std::string written = text, said = first(text);
                if (!said.empty()) return said;
                text = std::move(written);
                return second(text);
            },
            ""};
}

/// An integer from low to high.
template <std::integral T>
CLI::Validator integer(T low, T high) {
    return {[=](std::string& text) {
                const auto value = parsed<T>(text);
                const bool good = value && *value >= low && *value <= high;
                const std::string said = verdict(
                    good, text, "must be an integer from " + std::to_string(low) + " to " + std::to_string(high));
                if (good) text = std::to_string(*value);
                return said;
            },
            ""};
}

/// One of some words.
inline CLI::Validator one_of(std::vector<std::string> words, std::string allowed) {
    return {[words = std::move(words), allowed = std::move(allowed)](std::string& text) {
                for (const std::string& word : words)
                    if (word == text) return std::string();
                return verdict(false, text, allowed);
            },
            ""};
}

/// An option that has a meaning for some cases only: `not_to` says which one this is where it has none. Options are
/// looked at in the order of their definition; that of the case stands first. To be added last: it is asked first.
inline CLI::Validator applies(std::function<std::string()> not_to) {
    return {[not_to = std::move(not_to)](std::string& text) {
                const std::string what = not_to();
                return verdict(what.empty(), text, "does not apply to " + what);
            },
            ""};
}

/// Anything but nothing.
inline CLI::Validator name_of(std::string what) {
    return {[what = std::move(what)](std::string& text) {
                return verdict(!text.empty(), text, "must be the name of " + what);
            },
            ""};
}

inline CLI::Validator a_folder() {
    return {[](std::string& text) { return verdict(std::filesystem::is_directory(text), text, "must be a folder"); },
            ""};
}

/// "LOW:HIGH".
struct Range {
    double low = 0, high = 0;
};
/// "1,2.5,3".
struct List {
    std::vector<double> values;
};

/// How CLI11 reads a range and a list.
inline bool lexical_cast(const std::string& text, Range& range) {
    const auto values = parsed_list(text, ':');
    if (!values || values->size() != 2) return false;
    range = {(*values)[0], (*values)[1]};
    return true;
}
inline bool lexical_cast(const std::string& text, List& list) {
    const auto values = parsed_list(text, ',');
    if (values) list.values = *values;
    return values.has_value();
}

/// LOW:HIGH with finite LOW < HIGH, both in [least, most].
inline CLI::Validator range(std::string allowed, double least, double most) {
    return {[=, allowed = std::move(allowed)](std::string& text) {
                Range r;
                const bool good = lexical_cast(text, r) && r.low >= least && r.high <= most && r.low < r.high &&
                                  std::isfinite(r.high - r.low);
                return verdict(good, text, allowed);
            },
            ""};
}

/// A list of finite numbers for which `holds`, at least `least` and at most `most` of them.
inline CLI::Validator list(std::string allowed, std::size_t least, std::size_t most, Predicate holds) {
    return {[=, allowed = std::move(allowed), holds = std::move(holds)](std::string& text) {
                List l;
                bool good = lexical_cast(text, l) && l.values.size() >= least && l.values.size() <= most;
                for (const double x : l.values) good = good && holds(x);
                return verdict(good, text, allowed);
            },
            ""};
}
inline CLI::Validator list(std::string allowed, std::size_t size) {
    return list(std::move(allowed), size, size, [](double) { return true; });
}
/// As many positive numbers as `size` says when the option is looked at: options are in the order of their definition.
inline CLI::Validator positive_list(std::function<int()> size) {
    return {[size = std::move(size)](std::string& text) {
                const auto n = static_cast<std::size_t>(size());
                const std::string numbers = n == 1 ? " positive number" : " positive numbers, with commas between";
                return list("must be " + std::to_string(n) + numbers, n, n, [](double x) { return x > 0; })(text);
            },
            ""};
}

/// What many programs have.
inline void add_seed(CLI::App& app, std::uint64_t& seed, const std::string& text) {
    app.add_option("--seed", seed, text)->transform(integer<std::uint64_t>(0, UINT64_MAX));
}
inline void add_threads(CLI::App& app, unsigned& threads, const std::string& text) {
    app.add_option("--threads", threads, text)->transform(integer<unsigned>(0, 1024));
}

inline void parse(CLI::App& app, const std::string& name, int argc, char** argv) {
    program = name;
    app.name(name);
    app.allow_extras();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        std::exit(0);
    } catch (const CLI::ValidationError& error) {
        // "--option: value: what is allowed"
        const std::string text = error.what();
        const std::size_t at = text.find(": ");
        refuse(text.substr(0, at) + " " + text.substr(at + 2));
    } catch (const CLI::ArgumentMismatch& error) {
        // CLI11's texts begin with the option's name
        const std::string text = error.what(), option = text.substr(0, text.find(':'));
        const bool known = option.starts_with("--") && app.get_option_no_throw(option) != nullptr;
        if (!known) fail("command line", "", text);
        if (app.get_option(option)->count() > 1) fail(option, "", "must be given once only");
        fail(option, "", "must be followed by a value");
    } catch (const CLI::ParseError& error) {
        fail("command line", "", error.what());
    }
    if (const auto rest = app.remaining(); !rest.empty()) fail(rest.front(), "", "is not an option; --help lists them");
}

}  // namespace support
