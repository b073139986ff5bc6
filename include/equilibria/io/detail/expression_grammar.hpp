/// \file
/// The grammar of polynomial expressions that the formats of polynomial systems share, and what each of its rules does
/// when it has matched: sums, products and powers are multiplied out as they are read. What a name means, each format
/// says itself.
#pragma once

#if !__has_include(<tao/pegtl.hpp>)
#error "reading polynomial systems needs <tao/pegtl.hpp>: Debian's package tao-pegtl-dev, or github.com/taocpp/PEGTL"
#endif

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <tao/pegtl.hpp>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/read_number.hpp>
#include <equilibria/io/detail/polynomial_expansion.hpp>
#include <equilibria/io/polynomial_limits.hpp>

namespace equilibria::detail::polynomial_text {

namespace grammar {

using namespace tao::pegtl;

// clang-format off
struct blanks : star<space> {};
struct sign : one<'+', '-'> {};
struct times : seq<one<'*'>, not_at<one<'*'>>> {};
struct over : one<'/'> {};
struct to_the : sor<one<'^'>, string<'*', '*'>> {};
struct exponent_part : seq<one<'e', 'E', 'd', 'D'>, opt<one<'+', '-'>>, plus<digit>> {};
struct number : seq<sor<seq<plus<digit>, opt<one<'.'>, star<digit>>>, seq<one<'.'>, plus<digit>>>,
                    opt<exponent_part>> {};
struct index : seq<one<'['>, plus<sor<digit, one<','>>>, one<']'>> {};
struct name : seq<identifier, opt<index>> {};
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
// clang-format on

}  // namespace grammar

/// What is being read: the sum, the product and the sign of the next term at each depth of parentheses, and the last
/// factor.
class Reading {
public:
    struct Frame {
        Expansion sum{}, product{Coefficient(1.0)};
        double sign = 1;
        bool divides = false;
    };

    explicit Reading(const PolynomialLimits& given) : limits(given) {}
    virtual ~Reading() = default;

    /// What the name stands for becomes the factor; or why it stands for nothing, in words.
    virtual std::string resolve(const std::string& name) = 0;

    const PolynomialLimits& limits;
    std::vector<Frame> frames{1};
    Expansion factor{};
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
    if (y.underflows()) refuse("makes a coefficient that is too small for a double", in);
    if (y.largest_exponent() > r.limits.exponent)
        refuse("has an exponent above " + std::to_string(r.limits.exponent) + ", the limit", in);
    return y;
}

template <class Number, class Input>
Number value_of(const Input& in) {
    std::string text = in.string();
    for (char& c : text)
        if (c == 'd' || c == 'D') c = 'e';  // as Fortran writes it
    const char* first = text.data() + (text[0] == '+' ? 1 : 0);
    Number value{};
    const auto [end, error] = detail::read_number(first, text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) refuse("must be a number that fits its type", in);
    return value;
}

template <class Rule>
struct Action : tao::pegtl::nothing<Rule> {};

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
        if (const std::string why = r.resolve(in.string()); !why.empty()) refuse(why, in);
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
            if (f.product.underflows()) refuse("makes a coefficient that is too small for a double", in);
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

/// The sum that was read, complete; the next one may come.
template <class Input>
Expansion finished(Reading& r, const Input& in) {
    Expansion y = std::move(r.frames.back().sum);
    r.frames.assign(1, {});
    y.prune();
    for (const auto& [exponents, c] : y.terms())
        if (!std::isfinite(c.value.real()) || !std::isfinite(c.value.imag()))
            refuse("has a coefficient that is not finite", in);
    return y;
}

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
inline constexpr auto expected<grammar::blanks> = "blanks may stand here";

struct Expected {
    template <class Rule>
    static constexpr const char* message = expected<Rule>;
};
template <class Rule>
using Control = tao::pegtl::must_if<Expected, tao::pegtl::normal, false>::control<Rule>;

/// What stands at a place of the text, up to the end of its line.
inline std::string in_short(std::string_view text, std::size_t at) {
    constexpr std::size_t most = 40;
    if (at >= text.size()) return "the end";
    const std::string_view rest = text.substr(at, text.find_first_of("\r\n", at) - at);
    return rest.size() > most ? std::string(rest.substr(0, most)) + "..." : std::string(rest);
}

/// parse(in) of the text; a mistake becomes an InvalidArgument that says its line and column and quotes `shown`, of
/// which the text may be a form with other characters in their places.
template <class Parse>
void parse_text(std::string_view text, std::string_view shown, Parse parse) {
    tao::pegtl::memory_input in(text.data(), text.data() + text.size(), "system");
    try {
        parse(in);
    } catch (const tao::pegtl::parse_error& e) {
        const auto& place = e.positions().front();
        throw InvalidArgument("line " + std::to_string(place.line) + ", column " + std::to_string(place.column),
                              in_short(shown, place.byte), e.message());
    }
}

inline void require_bytes(std::string_view text, const PolynomialLimits& limits) {
    require(text.size() <= limits.bytes, "text", text.size(),
            "must have at most " + std::to_string(limits.bytes) + " bytes, the limit");
}

/// Terms come by falling degree, then by falling exponents.
inline PolynomialSystem<Coefficient> system_of(const std::vector<std::string>& variables,
                                               const std::vector<Expansion>& equations) {
    PolynomialSystem<Coefficient> system{variables, {}};
    for (const auto& equation : equations) {
        PolynomialSum<Coefficient> sum;
        for (const auto& [powers, c] : equation.terms()) {
            std::vector<int> exponents = powers;
            exponents.resize(variables.size());
            sum.add(exponents, c.value);
        }
        system.equations.push_back(sum.terms());
    }
    return system;
}

}  // namespace equilibria::detail::polynomial_text
