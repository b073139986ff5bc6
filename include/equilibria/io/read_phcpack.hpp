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
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/io/detail/phcpack_grammar.hpp>
#include <equilibria/io/polynomial_limits.hpp>
#include <equilibria/io/read_text.hpp>

namespace equilibria {

namespace detail::polynomial_text {

inline void read(std::string_view text, PhcpackReading& r) {
    namespace pegtl = tao::pegtl;
    parse_text(text, text, [&](auto& in) {
        pegtl::parse<grammar::phcpack::counts, Action, Control>(in, r);
        require(r.counts[0] >= 1 && r.counts[0] <= r.limits.equations, "number of equations", r.counts[0],
                "must be from 1 to " + std::to_string(r.limits.equations) + ", the limit");
        while (static_cast<int>(r.equations.size()) < r.counts[0])
            pegtl::parse<pegtl::seq<grammar::blanks, grammar::phcpack::equation>, Action, Control>(in, r);
    });
}

}  // namespace detail::polynomial_text

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
    detail::polynomial_text::require_bytes(text, limits);
    detail::polynomial_text::PhcpackReading r(limits, variables);
    detail::polynomial_text::read(text, r);
    const int said = r.counts.size() > 1 ? r.counts[1] : r.counts[0];
    require(said == static_cast<int>(r.variables.size()), "number of variables", r.variables.size(),
            "must be " + std::to_string(said) + ", as the first line says");
    return detail::polynomial_text::system_of(r.variables, r.equations);
}

/// The system in a file. Throws InvalidArgument also where the file cannot be read.
inline PolynomialSystem<std::complex<double>> read_phcpack(const std::string& path,
                                                           const std::vector<std::string>& variables = {},
                                                           const PolynomialLimits& limits = {}) {
    limits.validate();
    return parse_phcpack(read_text(path, limits.bytes), variables, limits);
}

}  // namespace equilibria
