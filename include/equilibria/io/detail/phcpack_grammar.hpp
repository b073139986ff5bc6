/// \file
/// The grammar of PHCpack's polynomials, and what each of its rules does when it has matched: sums, products and powers
/// are multiplied out as they are read.
#pragma once

#if !__has_include(<tao/pegtl.hpp>)
#error "reading polynomial systems needs <tao/pegtl.hpp>: Debian's package tao-pegtl-dev, or github.com/taocpp/PEGTL"
#endif

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <tao/pegtl.hpp>

#include <equilibria/io/detail/polynomial_expansion.hpp>
#include <equilibria/io/polynomial_limits.hpp>

namespace equilibria::detail::phcpack {

namespace grammar {

using namespace tao::pegtl;

// clang-format off
struct blanks : star<space> {};
struct sign : one<'+', '-'> {};
struct times : seq<one<'*'>, not_at<one<'*'>>> {};
struct over : one<'/'> {};
struct to_the : sor<one<'^'>, string<'*', '*'>> {};
struct exponent_part : seq<one<'e', 'E'>, opt<one<'+', '-'>>, plus<digit>> {};
struct number : seq<sor<seq<plus<digit>, opt<one<'.'>, star<digit>>>, seq<one<'.'>, plus<digit>>>,
                    opt<exponent_part>> {};
struct name : identifier {};
struct open : one<'('> {};
struct close : one<')'> {};
struct sum;
struct group : if_must<open, blanks, sum, blanks, close> {};
struct base : sor<number, name, group> {};
struct power : seq<opt<one<'+', '-'>>, plus<digit>> {};
struct exponent : sor<power, seq<one<'('>, blanks, power, blanks, one<')'>>> {};
struct factor : seq<base, opt<blanks, if_must<to_the, blanks, exponent>>> {};
struct term : seq<factor, star<blanks, sor<times, over>, must<blanks, factor>>> {};
struct sum : seq<opt<sign, blanks>, must<term>, star<blanks, sign, must<blanks, term>>> {};
struct equation : seq<sum, blanks, must<one<';'>>> {};
struct count : plus<digit> {};
struct counts : seq<blanks, must<count>, opt<plus<blank>, count>, blanks> {};
// clang-format on

}  // namespace grammar

/// What is being read: the sum, the product and the sign of the next term at each depth of parentheses, and the last
/// factor.
struct Reading {
    struct Frame {
        Expansion sum{}, product{Coefficient(1.0)};
        double sign = 1;
        bool divides = false;
    };

    PolynomialLimits limits{};
    bool names_given = false;
    std::vector<std::string> variables{};
    std::vector<int> counts{};
    std::vector<Frame> frames{1};
    Expansion factor{};
    std::vector<Expansion> equations{};
    std::size_t products = 0;  ///< of two terms so far
};

template <class Input>
[[noreturn]] void refuse(const std::string& why, const Input& in) {
    throw tao::pegtl::parse_error(why, in);
}

/// The product, unless it takes more than the limits allow.
template <class Input>
Expansion product(const Expansion& a, const Expansion& b, Reading& r, const Input& in) {
    const std::size_t size = a.terms().size(), other = b.terms().size();
    if (other != 0 && size > (static_cast<std::size_t>(r.limits.products) - r.products) / other)
        refuse("takes more than " + std::to_string(r.limits.products) + " products of terms, the limit", in);
    r.products += size * other;
    Expansion y = a.times(b);
    if (y.largest_exponent() > r.limits.exponent)
        refuse("has an exponent above " + std::to_string(r.limits.exponent) + ", the limit", in);
    return y;
}

template <class Number, class Input>
Number value_of(const Input& in) {
    const std::string text = in.string();
    const char* first = text.data() + (text[0] == '+' ? 1 : 0);
    Number value{};
    const auto [end, error] = std::from_chars(first, text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) refuse("must be a number that fits its type", in);
    return value;
}

template <class Rule>
struct Action : tao::pegtl::nothing<Rule> {};

template <>
struct Action<grammar::count> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        r.counts.push_back(value_of<int>(in));
    }
};
template <>
struct Action<grammar::number> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        r.factor = Expansion(Coefficient(value_of<double>(in)));
    }
};
template <>
struct Action<grammar::name> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        const std::string name = in.string();
        if (name == "i" || name == "I") {
            r.factor = Expansion(Coefficient(0, 1));
            return;
        }
        if (std::string_view("iIeE_").find(name[0]) != std::string_view::npos)
            refuse("must not start with i, I, e, E or _, which no variable of PHCpack does", in);
        const auto at = std::find(r.variables.begin(), r.variables.end(), name);
        const auto v = static_cast<std::size_t>(at - r.variables.begin());
        if (at == r.variables.end()) {
            if (r.names_given) refuse("is not among the names of the variables", in);
            if (v == static_cast<std::size_t>(r.limits.variables))
                refuse("is one variable more than " + std::to_string(v) + ", the limit", in);
            r.variables.push_back(name);
        }
        r.factor = Expansion::variable(v);
    }
};
template <>
struct Action<grammar::open> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        if (r.frames.size() > static_cast<std::size_t>(r.limits.nesting))
            refuse("is nested deeper than " + std::to_string(r.limits.nesting) + " parentheses, the limit", in);
        r.frames.emplace_back();
    }
};
template <>
struct Action<grammar::close> {
    static void apply0(Reading& r) {
        r.factor = std::move(r.frames.back().sum);
        r.factor.prune();
        r.frames.pop_back();
    }
};
template <>
struct Action<grammar::power> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        const int k = value_of<int>(in);
        if (std::abs(static_cast<double>(k)) > r.limits.exponent)
            refuse("must be at most " + std::to_string(r.limits.exponent) + ", the limit", in);
        if (k < 0) {
            if (r.factor.terms().size() != 1) refuse("must not be negative, for it is not the power of one term", in);
            r.factor = r.factor.inverse();
        }
        Expansion y(Coefficient(1.0));
        for (int j = 0; j < std::abs(k); ++j) y = product(y, r.factor, r, in);
        r.factor = std::move(y);
    }
};
template <>
struct Action<grammar::sign> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        r.frames.back().sign = in.peek_char() == '-' ? -1 : 1;
    }
};
template <>
struct Action<grammar::times> {
    static void apply0(Reading& r) { r.frames.back().divides = false; }
};
template <>
struct Action<grammar::over> {
    static void apply0(Reading& r) { r.frames.back().divides = true; }
};
template <>
struct Action<grammar::factor> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        Reading::Frame& f = r.frames.back();
        if (f.divides) {
            if (!r.factor.is_constant() || r.factor.terms().empty())
                refuse("must be a number other than 0, for it is a divisor", in);
            f.product.divide_by(r.factor.constant());
            f.divides = false;
        } else {
            f.product = product(f.product, r.factor, r, in);
        }
    }
};
template <>
struct Action<grammar::term> {
    static void apply0(Reading& r) {
        Reading::Frame& f = r.frames.back();
        f.sum.add(f.product, f.sign);
        f = {std::move(f.sum)};
    }
};
template <>
struct Action<grammar::equation> {
    template <class Input>
    static void apply(const Input& in, Reading& r) {
        r.frames.back().sum.prune();
        for (const auto& [exponents, c] : r.frames.back().sum.terms())
            if (!std::isfinite(c.value.real()) || !std::isfinite(c.value.imag()))
                refuse("has a coefficient that is not finite", in);
        r.equations.push_back(std::move(r.frames.back().sum));
        r.frames.assign(1, {});
    }
};

/// What was expected where the text is something else.
template <class>
inline constexpr const char* expected = nullptr;
template <>
inline constexpr auto expected<grammar::term> = "a number, a variable or ( must stand here";
template <>
inline constexpr auto expected<grammar::factor> = "a number, a variable or ( must stand here";
template <>
inline constexpr auto expected<grammar::sum> = "a number, a variable or ( must stand here";
template <>
inline constexpr auto expected<grammar::close> = "an operator or ) must stand here";
template <>
inline constexpr auto expected<grammar::exponent> = "an integer must stand here, or one in parentheses";
template <>
inline constexpr auto expected<tao::pegtl::one<';'>> = "an operator or ; must stand here";
template <>
inline constexpr auto expected<grammar::count> = "the number of equations must stand here";
template <>
inline constexpr auto expected<grammar::blanks> = "blanks may stand here";

struct Expected {
    template <class Rule>
    static constexpr const char* message = expected<Rule>;
};
template <class Rule>
using Control = tao::pegtl::must_if<Expected, tao::pegtl::normal, false>::control<Rule>;

}  // namespace equilibria::detail::phcpack
