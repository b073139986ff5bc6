/// \file
/// The grammar of PHCpack's format: how many equations and variables, then equations, each ended by a semicolon.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <equilibria/io/detail/expression_grammar.hpp>

namespace equilibria::detail::polynomial_text {

namespace grammar::phcpack {

// clang-format off
struct equation : seq<sum, blanks, must<one<';'>>> {};
struct count : plus<digit> {};
struct second_count : plus<digit> {};
struct counts : seq<blanks, must<count>, opt<plus<blank>, second_count, tao::pegtl::at<star<blank>, eolf>>, blanks> {};
// clang-format on

}  // namespace grammar::phcpack

/// Variables come as they appear, unless their names are given.
class PhcpackReading : public Reading {
public:
    PhcpackReading(const PolynomialLimits& given, const std::vector<std::string>& names)
        : Reading(given), variables(names) {}

    std::string resolve(const std::string& name) override {
        if (name == "i" || name == "I") {
            factor = Expansion(Coefficient(0, 1));
            return {};
        }
        const auto at = std::find(variables.begin(), variables.end(), name);
        const auto v = static_cast<std::size_t>(at - variables.begin());
        if (at == variables.end()) {
            if (names_given_) return "is not among the names of the variables";
            if (v == static_cast<std::size_t>(limits.variables))
                return "is one variable more than " + std::to_string(v) + ", the limit";
            variables.push_back(name);
        }
        factor = Expansion::variable(v);
        return {};
    }

    std::vector<std::string> variables;
    std::vector<int> counts{};
    std::vector<Expansion> equations{};

private:
    bool names_given_ = !variables.empty();
};

template <>
struct Action<grammar::phcpack::count> {
    template <class Input>
    static void apply(const Input& in, PhcpackReading& r) {
        r.counts.push_back(value_of<int>(in));
    }
};
template <>
struct Action<grammar::phcpack::second_count> : Action<grammar::phcpack::count> {};
template <>
struct Action<grammar::phcpack::equation> {
    template <class Input>
    static void apply(const Input& in, PhcpackReading& r) {
        r.equations.push_back(finished(r, in));
    }
};

template <>
inline constexpr auto expected<grammar::phcpack::count> = "the number of equations must stand here";

}  // namespace equilibria::detail::polynomial_text
