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

#include <complex>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/io/detail/phcpack_grammar.hpp>
#include <equilibria/io/polynomial_limits.hpp>
#include <equilibria/io/read_text.hpp>

namespace equilibria {

namespace detail::phcpack {

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
            sum.add(exponents, c.value);
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
