// Numbers are read by std::from_chars, exactly rounded and whatever the locale. CLI11 reads them once more, by way of
// long double: so the rules hand them on in a form of which that leaves every bit.
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

namespace support {
namespace {

template <class T>
std::optional<T> parsed_as(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

template <std::integral T>
Rule integer_between(T low, T high) {
    return [=](std::string& text) {
        const auto value = parsed_as<T>(text);
        const bool good = value && *value >= low && *value <= high;
        const std::string said =
            verdict(good, text, "must be an integer from " + std::to_string(low) + " to " + std::to_string(high));
        if (good) text = std::to_string(*value);
        return said;
    };
}

}  // namespace

std::optional<double> parsed(std::string_view text) { return parsed_as<double>(text); }

std::optional<std::vector<double>> parsed_list(std::string_view text, char separator) {
    std::vector<double> values;
    for (;;) {
        const std::size_t at = text.find(separator);
        const auto value = parsed(text.substr(0, at));
        if (!value || !std::isfinite(*value)) return {};
        values.push_back(*value);
        if (at == text.npos) return values;
        text.remove_prefix(at + 1);
    }
}

std::string shown(const std::string& text) { return text.empty() ? "''" : text; }

std::string verdict(bool good, const std::string& text, const std::string& allowed) {
    return good ? std::string() : shown(text) + ": " + allowed;
}

Rule number(std::string allowed, Predicate holds) {
    return [allowed = std::move(allowed), holds = std::move(holds)](std::string& text) {
        const auto value = parsed(text);
        const bool good = value && std::isfinite(*value) && holds(*value);
        const std::string said = verdict(good, text, allowed);
        if (good) {
            char hexadecimal[64];
            const double size = std::abs(*value);
            const auto end = std::to_chars(hexadecimal, hexadecimal + sizeof hexadecimal, size, std::chars_format::hex);
            text = (std::signbit(*value) ? "-0x" : "0x") + std::string(hexadecimal, end.ptr);
        }
        return said;
    };
}
Rule finite(std::string allowed) {
    return number(std::move(allowed), [](double) { return true; });
}
Rule positive() {
    return number("must be a positive number", [](double x) { return x > 0; });
}
Rule not_negative(std::string allowed) {
    return number(std::move(allowed), [](double x) { return x >= 0; });
}
Rule number_from(double low, double high, std::string allowed) {
    return number(std::move(allowed), [=](double x) { return x >= low && x <= high; });
}

Rule both(Rule first, Rule second) {
    return [first = std::move(first), second = std::move(second)](std::string& text) {
        std::string written = text, said = first(text);
        if (!said.empty()) return said;
        text = std::move(written);
        return second(text);
    };
}

Rule integer(int low, int high) { return integer_between(low, high); }
Rule integer(std::uint64_t low, std::uint64_t high) { return integer_between(low, high); }

Rule one_of(std::vector<std::string> words, std::string allowed) {
    return [words = std::move(words), allowed = std::move(allowed)](std::string& text) {
        for (const std::string& word : words)
            if (word == text) return std::string();
        return verdict(false, text, allowed);
    };
}

Rule applies(std::function<std::string()> not_to) {
    return [not_to = std::move(not_to)](std::string& text) {
        const std::string what = not_to();
        return verdict(what.empty(), text, "does not apply to " + what);
    };
}

Rule name_of(std::string what) {
    return [what = std::move(what)](std::string& text) {
        return verdict(!text.empty(), text, "must be the name of " + what);
    };
}

Rule a_folder() {
    return [](std::string& text) { return verdict(std::filesystem::is_directory(text), text, "must be a folder"); };
}

bool lexical_cast(const std::string& text, Range& range) {
    const auto values = parsed_list(text, ':');
    if (!values || values->size() != 2) return false;
    range = {(*values)[0], (*values)[1]};
    return true;
}
bool lexical_cast(const std::string& text, List& list) {
    const auto values = parsed_list(text, ',');
    if (values) list.values = *values;
    return values.has_value();
}

Rule range(std::string allowed, double least, double most) {
    return [=, allowed = std::move(allowed)](std::string& text) {
        Range r;
        const bool good = lexical_cast(text, r) && r.low >= least && r.high <= most && r.low < r.high &&
                          std::isfinite(r.high - r.low);
        return verdict(good, text, allowed);
    };
}

Rule list(std::string allowed, std::size_t least, std::size_t most, Predicate holds) {
    return [=, allowed = std::move(allowed), holds = std::move(holds)](std::string& text) {
        List l;
        bool good = lexical_cast(text, l) && l.values.size() >= least && l.values.size() <= most;
        for (const double x : l.values) good = good && holds(x);
        return verdict(good, text, allowed);
    };
}
Rule list(std::string allowed, std::size_t size) {
    return list(std::move(allowed), size, size, [](double) { return true; });
}
Rule positive_list(std::function<int()> size) {
    return [size = std::move(size)](std::string& text) {
        const auto n = static_cast<std::size_t>(size());
        const std::string numbers = n == 1 ? " positive number" : " positive numbers, with commas between";
        return list("must be " + std::to_string(n) + numbers, n, n, [](double x) { return x > 0; })(text);
    };
}

std::string Option::name() const { return option_->get_name(); }
Option Option::transform(Rule rule) const {
    option_->transform(CLI::Validator(std::move(rule), ""));
    return *this;
}

CommandLine::CommandLine(std::string description) : app_(std::make_unique<CLI::App>(std::move(description))) {}
CommandLine::~CommandLine() = default;

template <class T>
Option CommandLine::add_option(const std::string& name, T& variable, const std::string& text) {
    return Option(*app_->add_option(name, variable, text));
}
template Option CommandLine::add_option(const std::string&, double&, const std::string&);
template Option CommandLine::add_option(const std::string&, int&, const std::string&);
template Option CommandLine::add_option(const std::string&, unsigned&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::uint64_t&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::string&, const std::string&);
template Option CommandLine::add_option(const std::string&, Range&, const std::string&);
template Option CommandLine::add_option(const std::string&, List&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::optional<double>&, const std::string&);
template Option CommandLine::add_option(const std::string&, std::optional<int>&, const std::string&);

Option CommandLine::add_option_function(const std::string& name, std::function<void(const std::string&)> given,
                                        const std::string& text) {
    return Option(*app_->add_option_function<std::string>(name, given, text));
}
void CommandLine::add_flag(const std::string& name, bool& variable, const std::string& text) {
    app_->add_flag(name, variable, text);
}
void CommandLine::add_seed(std::uint64_t& seed, const std::string& text) {
    add_option("--seed", seed, text).transform(integer(std::uint64_t{0}, UINT64_MAX));
}
void CommandLine::add_threads(unsigned& threads, const std::string& text) {
    add_option("--threads", threads, text).transform(integer(0, 1024));
}
void CommandLine::add_limit(double& seconds, const std::string& text) {
    add_option("--limit", seconds, text).transform(number("must be a number of seconds above 0", [](double x) {
        return x > 0;
    }));
}

void CommandLine::parse(const std::string& name, int argc, const char* const* argv) {
    CLI::App& app = *app_;
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
bool CommandLine::given(const std::string& name) const { return app_->count(name) > 0; }

}  // namespace support
