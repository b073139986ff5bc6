// Options of programs, typed: what a value may be is a rule, which says it in one sentence and keeps the value as it
// was written. --help ends with status 0, any mistake with one line and status 2.
//
//     app.add_option("--omega", omega, "angular speed").transform(support::finite());
//     app.parse("rotating_chain", argc, argv);
//
// CLI11 reads the command line (options.cpp, which is compiled once for all programs: CLI11 takes longer than most of
// them).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fail.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace support {

/// The whole text as a number, or nothing; a sign '+' is allowed.
std::optional<double> parsed(std::string_view text);

/// The numbers between separators, or nothing where one of them is none or not finite.
std::optional<std::vector<double>> parsed_list(std::string_view text, char separator);

/// What a value looks like in a message.
std::string shown(const std::string& text);

/// A rule's verdict on `text`: nothing where `good`.
std::string verdict(bool good, const std::string& text, const std::string& allowed);

/// What a value may be: says nothing where `text` obeys, and what is allowed otherwise. It may change the text into
/// another one of the same value.
using Rule = std::function<std::string(std::string& text)>;
using Predicate = std::function<bool(double)>;

/// A finite number for which `holds`.
Rule number(std::string allowed, Predicate holds);
Rule finite(std::string allowed = "must be a finite number");
Rule positive();
Rule not_negative(std::string allowed = "must be a number, 0 or more");
Rule number_from(double low, double high, std::string allowed);

/// Both, of the value as it was written; the first one speaks first.
Rule both(Rule first, Rule second);

/// An integer from low to high.
Rule integer(int low, int high);
Rule integer(std::uint64_t low, std::uint64_t high);

/// One of some words.
Rule one_of(std::vector<std::string> words, std::string allowed);

/// An option that has a meaning for some cases only: `not_to` says which one this is where it has none. Options are
/// looked at in the order of their definition; that of the case stands first. To be added last: it is asked first.
Rule applies(std::function<std::string()> not_to);

/// Anything but nothing.
Rule name_of(std::string what);

Rule a_folder();

/// "LOW:HIGH".
struct Range {
    double low = 0, high = 0;
};
/// "1,2.5,3".
struct List {
    std::vector<double> values;
};

/// How CLI11 reads a range and a list.
bool lexical_cast(const std::string& text, Range& range);
bool lexical_cast(const std::string& text, List& list);

/// LOW:HIGH with finite LOW < HIGH, both in [least, most].
Rule range(std::string allowed, double least, double most);

/// A list of finite numbers for which `holds`, at least `least` and at most `most` of them.
Rule list(std::string allowed, std::size_t least, std::size_t most, Predicate holds);
Rule list(std::string allowed, std::size_t size);
/// As many positive numbers as `size` says when the option is looked at: options are in the order of their definition.
Rule positive_list(std::function<int()> size);

/// An option of a command line.
class Option {
public:
    explicit Option(CLI::Option& option) : option_(&option) {}
    std::string name() const;
    /// A rule for its value; of several the one added last is asked first.
    Option transform(Rule rule) const;

private:
    CLI::Option* option_;
};

class CommandLine {
public:
    explicit CommandLine(std::string description);
    ~CommandLine();

    /// T: double, int, unsigned, std::uint64_t, std::string, Range, List, std::optional<double> or
    /// std::optional<int>. The variable has to outlive the parsing.
    template <class T>
    Option add_option(const std::string& name, T& variable, const std::string& text);
    Option add_option_function(const std::string& name, std::function<void(const std::string&)> given,
                               const std::string& text);
    void add_flag(const std::string& name, bool& variable, const std::string& text);
    /// What many programs have.
    void add_seed(std::uint64_t& seed, const std::string& text);
    void add_threads(unsigned& threads, const std::string& text);
    /// In seconds; 0: none was given.
    void add_limit(double& seconds, const std::string& text);

    /// Ends the program where it was asked for help, or where something is wrong.
    void parse(const std::string& program, int argc, const char* const* argv);
    /// Whether an option was given.
    bool given(const std::string& name) const;

private:
    std::unique_ptr<CLI::App> app_;
};

}  // namespace support
