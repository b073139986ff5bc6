/// \file
/// The grammar of formulas, and what each of its rules does when it has matched: a FormulaBuilder puts them together.
#pragma once

#if !__has_include(<tao/pegtl.hpp>)
#error "reading models needs <tao/pegtl.hpp>: Debian's package tao-pegtl-dev, or github.com/taocpp/PEGTL"
#endif

#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <tao/pegtl.hpp>

#include <equilibria/core/error.hpp>
#include <equilibria/core/read_number.hpp>
#include <equilibria/formula/formula_builder.hpp>

namespace equilibria::detail::formula_text {

namespace grammar {

using namespace tao::pegtl;

// clang-format off
struct blanks : star<space> {};
struct exponent_part : seq<one<'e', 'E'>, opt<one<'+', '-'>>, plus<ascii::digit>> {};
struct number : seq<sor<seq<plus<ascii::digit>, opt<one<'.'>, star<ascii::digit>>>, seq<one<'.'>, plus<ascii::digit>>>,
                    opt<exponent_part>> {};
struct name : identifier {};
struct sum;
struct open : one<'('> {};
struct close : one<')'> {};
struct called : seq<identifier, blanks, tao::pegtl::at<one<'('>>> {};
struct group : if_must<open, blanks, sum, blanks, close> {};
struct call : if_must<called, group> {};
struct base : sor<number, call, name, group> {};
struct signs : star<one<'+', '-'>, blanks> {};
struct factor;
struct to_the : sor<one<'^'>, string<'*', '*'>> {};
struct raised : if_must<to_the, blanks, factor> {};
struct power : seq<base, opt<blanks, raised>> {};
struct factor : seq<signs, must<power>> {};
struct times : if_must<seq<one<'*'>, not_at<one<'*'>>>, blanks, factor> {};
struct over : if_must<one<'/'>, blanks, factor> {};
struct term : seq<factor, star<blanks, sor<times, over>>> {};
struct added : if_must<one<'+'>, blanks, term> {};
struct subtracted : if_must<one<'-'>, blanks, term> {};
struct sum : seq<term, star<blanks, sor<added, subtracted>>> {};
struct formula : must<blanks, sum, blanks, eof> {};
// clang-format on

}  // namespace grammar

/// What is being read.
struct Reading {
    FormulaBuilder& builder;
    /// What a name stands for; throws InvalidArgument where it stands for nothing.
    std::function<Formula(const std::string& name)> resolve;
    std::vector<Formula> values{};
    std::vector<std::string> calls{};
    std::vector<bool> negative{};  ///< signs before factors that are being read
    int depth = 0;

    static constexpr int most_depth = 100;

    Formula take() {
        Formula y = std::move(values.back());
        values.pop_back();
        return y;
    }
};

/// operation(), whose error becomes one at this place.
template <class Input, class Operation>
void at(const Input& in, const Operation& operation) {
    try {
        operation();
    } catch (const InvalidArgument& error) {
        std::string what = error.what();
        if (what.starts_with("formula = ")) what.erase(0, 10);
        throw tao::pegtl::parse_error(what, in);
    }
}

template <class Rule>
struct Action : tao::pegtl::nothing<Rule> {};

template <>
struct Action<grammar::number> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        const std::string text = in.string();
        double value{};
        const auto [end, error] = detail::read_number(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size())
            throw tao::pegtl::parse_error("must be a number that a double can hold", in);
        at(in, [&] { r.values.push_back(r.builder.number(value)); });
    }
};
template <>
struct Action<grammar::name> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        const std::string name = in.string();
        at(in, [&] { r.values.push_back(name == "pi" ? r.builder.number(std::numbers::pi) : r.resolve(name)); });
    }
};
template <>
struct Action<grammar::called> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        std::string name = in.string();
        name.erase(name.find_last_not_of(" \t\r\n\v\f") + 1);
        bool known = false;
        std::string names;
        for (const std::string& own : FormulaBuilder::functions()) {
            known = known || own == name;
            names += (names.empty() ? "" : own == FormulaBuilder::functions().back() ? " or " : ", ") + own;
        }
        if (!known) throw tao::pegtl::parse_error(name + ": is no function, must be " + names, in);
        r.calls.push_back(std::move(name));
    }
};
template <>
struct Action<grammar::call> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        const std::string name = std::move(r.calls.back());
        r.calls.pop_back();
        at(in, [&] { r.values.push_back(r.builder.function(name, r.take())); });
    }
};
struct Deeper {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        if (++r.depth > Reading::most_depth)
            throw tao::pegtl::parse_error("must not be nested deeper than 100 parentheses and powers", in);
    }
};
template <>
struct Action<grammar::open> : Deeper {};
template <>
struct Action<grammar::to_the> : Deeper {};
template <>
struct Action<grammar::close> {
    static void apply0(Reading& r) { --r.depth; }
};
template <>
struct Action<grammar::signs> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        bool negative = false;
        for (const char c : in.string_view()) negative = negative != (c == '-');
        r.negative.push_back(negative);
    }
};
template <>
struct Action<grammar::factor> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        const bool negative = r.negative.back();
        r.negative.pop_back();
        if (negative) at(in, [&] { r.values.push_back(r.builder.negative(r.take())); });
    }
};

template <Formula (FormulaBuilder::*operation)(const Formula&, const Formula&), int deeper = 0>
struct Binary {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        r.depth -= deeper;
        const Formula b = r.take(), a = r.take();
        at(in, [&] { r.values.push_back((r.builder.*operation)(a, b)); });
    }
};
template <>
struct Action<grammar::raised> : Binary<&FormulaBuilder::power, 1> {};
template <>
struct Action<grammar::times> : Binary<&FormulaBuilder::product> {};
template <>
struct Action<grammar::over> : Binary<&FormulaBuilder::quotient> {};
template <>
struct Action<grammar::added> : Binary<&FormulaBuilder::sum> {};
template <>
struct Action<grammar::subtracted> : Binary<&FormulaBuilder::difference> {};

/// What was expected where the text is something else.
template <class>
inline constexpr const char* expected = nullptr;
inline constexpr const char* expected_operand = "a number, a name, a function or ( must stand here";
template <>
inline constexpr auto expected<grammar::power> = expected_operand;
template <>
inline constexpr auto expected<grammar::factor> = expected_operand;
template <>
inline constexpr auto expected<grammar::term> = expected_operand;
template <>
inline constexpr auto expected<grammar::sum> = expected_operand;
template <>
inline constexpr auto expected<grammar::close> = "an operator or ) must stand here";
template <>
inline constexpr auto expected<tao::pegtl::eof> = "an operator or the end must stand here";
template <>
inline constexpr auto expected<grammar::blanks> = "blanks may stand here";

struct Expected {
    template <class Rule>
    static constexpr const char* message = expected<Rule>;
};
template <class Rule>
using Control = tao::pegtl::must_if<Expected, tao::pegtl::normal, false>::control<Rule>;

/// A mistake in a formula, and which byte it is at.
class FormulaError : public InvalidArgument {
public:
    FormulaError(std::string_view argument, std::string_view value, std::string_view allowed, std::size_t at)
        : InvalidArgument(argument, value, allowed), byte(at), what_is_there(value), what_is_allowed(allowed) {}

    std::size_t byte;
    std::string what_is_there, what_is_allowed;
};

/// The formula of a text, of these names. Throws FormulaError.
inline Formula parse(std::string_view text, FormulaBuilder& builder,
                     const std::function<Formula(const std::string& name)>& resolve) {
    Reading r{builder, resolve};
    tao::pegtl::memory_input in(text.data(), text.data() + text.size(), "formula");
    try {
        tao::pegtl::parse<grammar::formula, Action, Control>(in, r);
    } catch (const tao::pegtl::parse_error& e) {
        constexpr std::size_t most = 40;
        const auto& place = e.positions().front();
        const std::size_t byte = std::min(place.byte, text.size());
        std::string there(text.substr(byte, most));
        if (byte + most < text.size()) there += "...";
        throw FormulaError("column " + std::to_string(byte + 1), there.empty() ? "the end" : there,
                           std::string(e.message()), byte);
    }
    return r.take();
}

}  // namespace equilibria::detail::formula_text
