/// \file
/// The grammar of the classic input of Bertini 1, and what is known of each name while it is read: settings, which are
/// passed over; declarations of names; and names that become sums.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/io/detail/expression_grammar.hpp>

namespace equilibria::detail::polynomial_text {

namespace grammar::bertini {

// clang-format off
template <char... C>
struct word : seq<string<C...>, not_at<identifier_other>> {};
struct ending : seq<word<'E', 'N', 'D'>, blanks, one<';'>> {};
struct settings_end : ending {};
struct settings : if_must<word<'C', 'O', 'N', 'F', 'I', 'G'>, star<not_at<ending>, sor<identifier, any>>, settings_end> {};
struct first : identifier {};
struct becomes : one<'='> {};
struct declared : identifier {};
struct one_more : declared {};
struct names_end : one<';'> {};
struct names : seq<declared, star<blanks, one<','>, blanks, must<one_more>>, blanks, must<names_end>> {};
struct assignment : if_must<becomes, blanks, sum, blanks, one<';'>> {};
struct statement : seq<first, blanks, sor<assignment, must<names>>> {};
struct file : seq<blanks, opt<settings, blanks>, opt<word<'I', 'N', 'P', 'U', 'T'>, blanks>,
                  star<not_at<sor<ending, eof>>, must<statement>, blanks>> {};
// clang-format on

}  // namespace grammar::bertini

/// Names with what they stand for. A function's value is an equation; other values are put in where they are named.
class BertiniReading : public Reading {
public:
    enum class Kind { variable, constant, function, subfunction };
    struct Name {
        Kind kind;
        std::size_t number;  ///< of a variable, of a function
        tao::pegtl::position place;
        std::optional<Expansion> value{};
    };

    explicit BertiniReading(const PolynomialLimits& given) : Reading(given) {}

    std::string resolve(const std::string& name) override {
        if (name == "I" || name == "Pi") {
            factor = Expansion(name == "I" ? Coefficient(0, 1) : Coefficient(std::numbers::pi));
            return {};
        }
        const auto at = names_.find(name);
        if (at == names_.end())
            return is_reserved(name) ? "is not of a polynomial: sums, products and powers may stand here"
                                     : "is no name yet: variables and constants are declared before they are used, "
                                       "subfunctions get their sums";
        const Name& known = at->second;
        if (known.kind != Kind::variable && !known.value) return "has no value yet: name = sum; must stand before";
        factor = known.kind == Kind::variable ? Expansion::variable(known.number) : *known.value;
        return {};
    }

    /// The statement begins with this word.
    void begin(const std::string& word, const tao::pegtl::position& place) {
        first_ = word;
        place_.emplace(place);
        listed_ = 0;
    }
    /// Whether the word may get a value; subfunctions need no declaration.
    void assign() {
        if (is_reserved(first_)) refuse_first("is a word of Bertini's own, which gets no value");
        const auto [at, is_new] = names_.try_emplace(first_, Name{Kind::subfunction, 0, *place_});
        if (is_new) return;
        if (at->second.kind == Kind::variable) refuse_first("is a variable, which gets no value");
        if (at->second.value) refuse_first("has a value already");
    }
    /// The value of the word, which `assign` allowed; or why it cannot be, in words.
    std::string take(Expansion value) {
        Name& name = names_.at(first_);
        if (name.kind == Kind::constant && !value.is_constant())
            return "must be a number, for it is the value of a constant";
        for (const auto& [exponents, c] : value.terms())
            for (const int k : exponents)
                if (k < 0) return "must have no negative power of a variable";
        name.value = std::move(value);
        return {};
    }
    /// One of the names behind the word, which says what they are; or why it may not be, in words.
    std::string declare(const std::string& name, const tao::pegtl::position& place) {
        const bool grouped = first_ == "variable_group", loose = first_ == "variable";
        if (const auto why = refused_declaration(); !why.empty()) refuse_first(why);
        if (is_reserved(name)) return "is a word of Bertini's own, and no name";
        if (name[0] == '_') return "must start with a letter";
        const Kind kind = grouped || loose ? Kind::variable : first_ == "function" ? Kind::function : Kind::constant;
        auto& list = kind == Kind::variable ? variables : functions_;
        const auto most = static_cast<std::size_t>(kind == Kind::variable ? limits.variables : limits.equations);
        if (kind != Kind::constant && list.size() == most)
            return std::string("is one ") + (kind == Kind::variable ? "variable" : "function") + " more than " +
                   std::to_string(most) + ", the limit";
        if (!names_.try_emplace(name, Name{kind, list.size(), place}).second) return "is declared already";
        if (kind != Kind::constant) list.push_back(name);
        if (kind == Kind::variable) {
            int& group = loose ? loose_group_ : grouped_;
            if (loose ? group < 0 : listed_ == 0) group = groups_++;
            grouping.push_back(group);
        }
        ++listed_;
        return {};
    }
    /// The functions' values in the order of their declaration.
    std::vector<Expansion> equations() const {
        std::vector<Expansion> y;
        for (const auto& name : functions_) {
            const Name& f = names_.at(name);
            if (!f.value) throw tao::pegtl::parse_error("is a function that gets no value", f.place);
            y.push_back(*f.value);
        }
        return y;
    }

    std::vector<std::string> variables{};
    std::vector<int> grouping{};  ///< of each variable

private:
    static bool is_reserved(std::string_view name) {
        constexpr std::array words{"I",   "Pi",     "sin",   "cos",      "tan",      "exp",      "pow",           "log",
                                   "END", "CONFIG", "INPUT", "constant", "function", "variable", "variable_group"};
        for (const std::string_view w : words)
            if (name == w) return true;
        return false;
    }
    std::string refused_declaration() const {
        if (first_ == "variable_group" || first_ == "variable" || first_ == "function" || first_ == "constant")
            return {};
        if (first_ == "hom_variable_group")
            return "is of projective space, which is not read: a variable_group, in which one of these variables is "
                   "put to 1, must stand here";
        if (first_ == "pathvariable" || first_ == "parameter")
            return "is of a homotopy of one's own, which is not read: a system with variable_group must stand here";
        if (first_ == "random" || first_ == "random_real")
            return "is of numbers that Bertini draws, which are not read: constant, with values, must stand here";
        return "must be followed by =, or be variable_group, variable, function or constant before a list of names";
    }
    [[noreturn]] void refuse_first(const std::string& why) const { throw tao::pegtl::parse_error(why, *place_); }

    std::map<std::string, Name> names_{};
    std::vector<std::string> functions_{};
    std::string first_{};
    std::optional<tao::pegtl::position> place_{};
    int listed_ = 0, groups_ = 0, grouped_ = -1, loose_group_ = -1;
};

template <>
struct Action<grammar::bertini::first> {
    template <class Input>
    static void apply(const Input& in, BertiniReading& r) {
        r.begin(in.string(), in.position());
    }
};
template <>
struct Action<grammar::bertini::becomes> {
    static void apply0(BertiniReading& r) { r.assign(); }
};
template <>
struct Action<grammar::bertini::assignment> {
    template <class Input>
    static void apply(const Input& in, BertiniReading& r) {
        if (const std::string why = r.take(finished(r, in)); !why.empty()) refuse(why, in);
    }
};
template <>
struct Action<grammar::bertini::declared> {
    template <class Input>
    static void apply(const Input& in, BertiniReading& r) {
        if (const std::string why = r.declare(in.string(), in.position()); !why.empty()) refuse(why, in);
    }
};

template <>
struct Action<grammar::bertini::one_more> : Action<grammar::bertini::declared> {};

// A rule with a message is one that must match wherever it stands.
template <>
inline constexpr auto expected<grammar::bertini::settings_end> = "END; must stand here";
template <>
inline constexpr auto expected<grammar::bertini::statement> = "a declaration, name = sum; or END; must stand here";
template <>
inline constexpr auto expected<grammar::bertini::names> = "= or names must stand here";
template <>
inline constexpr auto expected<grammar::bertini::one_more> = "a name must stand here";
template <>
inline constexpr auto expected<grammar::bertini::names_end> = "a comma or ; must stand here";

}  // namespace equilibria::detail::polynomial_text
