/// \file
/// Polynomial systems from text in PHCpack's format (Verschelde 1999, ACM Trans. Math. Softw. 25, 251-276), in which
/// many systems of the literature are kept:
///
///     2
///     x^2 + 4*y^2 - 4;
///     2*y^2 - x;
///
/// The number of equations, the number of variables behind it where it differs, then the equations, each ended by a
/// semicolon: sums, products, powers (^ or **), parentheses, division by numbers, and i or I for the imaginary unit.
/// Variables come in the order in which they first appear, unless their names are given. Needs PEGTL.
#pragma once

#if !__has_include(<tao/pegtl.hpp>)
#error "reading polynomial systems needs <tao/pegtl.hpp>: Debian's package tao-pegtl-dev, or github.com/taocpp/PEGTL"
#endif

#include <algorithm>
#include <charconv>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <tao/pegtl.hpp>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/io/read_text.hpp>

namespace equilibria {

/// What text from outside may ask for. Sums in parentheses are multiplied out.
struct PolynomialLimits {
    std::size_t bytes = std::size_t{64} << 20;  ///< of the text
    int equations = 1'000;
    int variables = 1'000;
    int exponent = 10'000;      ///< absolute value, of one variable in one term
    int nesting = 100;          ///< parentheses in parentheses
    int products = 10'000'000;  ///< of two terms, in the whole text: what its expansion takes

    void validate() const {
        const auto positive = [](const char* name, int value) {
            require(value >= 1, name, value, "must be at least 1");
        };
        require(bytes >= 1, "bytes", bytes, "must be at least 1");
        positive("equations", equations);
        positive("variables", variables);
        positive("exponent", exponent);
        positive("nesting", nesting);
        positive("products", products);
    }
};

namespace detail::phcpack {

using Coefficient = std::complex<double>;

/// Exponents up to the last that is not 0: more variables may be still to come.
using Exponents = std::vector<int>;

/// A polynomial expanded, the coefficient of each product of powers.
class Expansion {
public:
    Expansion() = default;
    explicit Expansion(Coefficient constant) { add({}, constant); }
    static Expansion variable(std::size_t v) {
        Expansion y;
        Exponents e(v + 1);
        e[v] = 1;
        y.add(e, 1.0);
        return y;
    }

    const std::map<Exponents, Coefficient>& terms() const { return terms_; }
    bool is_constant() const { return terms_.empty() || (terms_.size() == 1 && terms_.begin()->first.empty()); }
    Coefficient constant() const { return terms_.empty() ? 0.0 : terms_.begin()->second; }

    void add(const Expansion& other, double factor) {
        for (const auto& [exponents, c] : other.terms_) add(exponents, factor * c);
    }

    /// The largest absolute value of an exponent.
    int largest_exponent() const {
        int largest = 0;
        for (const auto& [exponents, c] : terms_)
            for (int k : exponents) largest = std::max(largest, std::abs(k));
        return largest;
    }

    Expansion times(const Expansion& other) const {
        Expansion y;
        for (const auto& [a, ca] : terms_)
            for (const auto& [b, cb] : other.terms_) {
                Exponents e = a;
                e.resize(std::max(a.size(), b.size()));
                for (std::size_t v = 0; v < b.size(); ++v) e[v] += b[v];
                while (!e.empty() && e.back() == 0) e.pop_back();
                y.add(e, ca * cb);
            }
        return y;
    }

    void divide_by(Coefficient divisor) {
        for (auto& [exponents, c] : terms_) c = divisor.imag() == 0 ? c / divisor.real() : c / divisor;
    }

    /// Of a single term.
    Expansion inverse() const {
        Expansion y;
        Exponents e = terms_.begin()->first;
        for (int& k : e) k = -k;
        y.add(e, 1.0);
        y.divide_by(terms_.begin()->second);
        return y;
    }

private:
    void add(const Exponents& exponents, Coefficient c) {
        if (c == 0.0) return;
        const auto [at, is_new] = terms_.try_emplace(exponents, c);
        if (!is_new && (at->second += c) == 0.0) terms_.erase(at);
    }

    std::map<Exponents, Coefficient> terms_;
};

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
        for (const auto& [exponents, c] : r.frames.back().sum.terms())
            if (!std::isfinite(c.real()) || !std::isfinite(c.imag()))
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

/// What stands at a place of the text, up to the end of its line.
inline std::string in_short(std::string_view text, std::size_t at) {
    constexpr std::size_t most = 40;
    if (at >= text.size()) return "the end";
    const std::string_view rest = text.substr(at, text.find_first_of("\r\n", at) - at);
    return rest.size() > most ? std::string(rest.substr(0, most)) + "..." : std::string(rest);
}

inline void read(std::string_view text, Reading& r) {
    namespace pegtl = tao::pegtl;
    pegtl::memory_input in(text.data(), text.data() + text.size(), "system");
    try {
        pegtl::parse<grammar::counts, Action, Control>(in, r);
        require(r.counts[0] >= 1 && r.counts[0] <= r.limits.equations, "number of equations", r.counts[0],
                "must be from 1 to " + std::to_string(r.limits.equations) + ", the limit");
        while (static_cast<int>(r.equations.size()) < r.counts[0])
            pegtl::parse<pegtl::seq<grammar::blanks, grammar::equation>, Action, Control>(in, r);
    } catch (const pegtl::parse_error& e) {
        const auto& place = e.positions().front();
        throw InvalidArgument("line " + std::to_string(place.line) + ", column " + std::to_string(place.column),
                              in_short(text, place.byte), e.message());
    }
}

}  // namespace detail::phcpack

/// The system in the text; what write_phcpack writes comes back, digit by digit. Terms come by falling degree, then by
/// falling exponents, those of equal exponents added. What stands behind the last equation, where PHCpack writes titles
/// and solutions, is not read.
///
/// variables: their order; where it is empty, that of their first appearance. Throws InvalidArgument with line and
/// column for text that is no such system, that names other variables or goes beyond the limits, and for a number of
/// variables other than the text says.
inline PolynomialSystem<std::complex<double>> parse_phcpack(std::string_view text,
                                                            const std::vector<std::string>& variables = {},
                                                            const PolynomialLimits& limits = {}) {
    limits.validate();
    require(text.size() <= limits.bytes, "text", text.size(),
            "must have at most " + std::to_string(limits.bytes) + " bytes, the limit");
    detail::phcpack::Reading r{limits, !variables.empty(), variables};
    detail::phcpack::read(text, r);
    const int said = r.counts.size() > 1 ? r.counts[1] : r.counts[0];
    require(said == static_cast<int>(r.variables.size()), "number of variables", r.variables.size(),
            "must be " + std::to_string(said) + ", as the first line says");

    PolynomialSystem<std::complex<double>> system{r.variables, {}};
    for (const auto& equation : r.equations) {
        detail::PolynomialSum<std::complex<double>> sum;
        for (const auto& [powers, c] : equation.terms()) {
            std::vector<int> exponents = powers;
            exponents.resize(system.variables.size());
            sum.add(exponents, c);
        }
        system.equations.push_back(sum.terms());
    }
    return system;
}

/// The system in a file. Throws InvalidArgument also where the file cannot be read.
inline PolynomialSystem<std::complex<double>> read_phcpack(const std::string& path,
                                                           const std::vector<std::string>& variables = {},
                                                           const PolynomialLimits& limits = {}) {
    limits.validate();
    return parse_phcpack(read_text(path, limits.bytes), variables, limits);
}

}  // namespace equilibria
