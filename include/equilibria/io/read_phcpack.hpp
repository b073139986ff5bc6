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
/// Other names that begin with i or e are variables, which PHCpack refuses or misreads; so are names such as x[1].
/// Numbers may be Fortran's, as 1.5D+03. Lines that begin with #, % or -- are comments, which PHCpack has none of.
/// Variables come in the order in which they first appear, unless their names are given. Needs PEGTL.
#pragma once

#include <algorithm>
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

namespace detail::polynomial_text {

/// The text with blanks for lines that are comments, so that all else keeps its place.
inline std::string without_comment_lines(std::string_view text) {
    std::string y(text);
    for (std::size_t begin = 0; begin < y.size();) {
        const std::size_t end = std::min(y.find('\n', begin), y.size());
        const std::size_t first = std::min(y.find_first_not_of(" \t\r", begin), end);
        if (first < end && (y[first] == '#' || y[first] == '%' || y.compare(first, 2, "--") == 0))
            std::fill(y.begin() + static_cast<std::ptrdiff_t>(first), y.begin() + static_cast<std::ptrdiff_t>(end),
                      ' ');
        begin = end + 1;
    }
    return y;
}

/// Whether one more equation begins where the input stands.
template <class Input>
bool has_equation(const Input& in, const PolynomialLimits& limits) {
    PhcpackReading r(limits, {});
    tao::pegtl::memory_input rest(in.current(), in.end(), "rest");
    try {
        return tao::pegtl::parse<tao::pegtl::seq<grammar::blanks, grammar::phcpack::equation>, Action, Control>(rest,
                                                                                                                r);
    } catch (const tao::pegtl::parse_error&) {
        return false;
    }
}

inline void read(std::string_view text, PhcpackReading& r) {
    namespace pegtl = tao::pegtl;
    parse_text(without_comment_lines(text), text, [&](auto& in) {
        pegtl::parse<grammar::phcpack::counts, Action, Control>(in, r);
        const int said = r.counts[0];
        require(said >= 1 && said <= r.limits.equations, "number of equations", said,
                "must be from 1 to " + std::to_string(r.limits.equations) + ", the limit");
        while (static_cast<int>(r.equations.size()) < said) {
            pegtl::parse<grammar::blanks>(in);
            require(!in.empty(), "number of equations", r.equations.size(),
                    "must be " + std::to_string(said) + ", as the first line says");
            pegtl::parse<grammar::phcpack::equation, Action, Control>(in, r);
        }
        require(!has_equation(in, r.limits), "number of equations", "more than " + std::to_string(said),
                "must be " + std::to_string(said) + ", as the first line says");
    });
}

}  // namespace detail::polynomial_text

/// The system in the text; what write_phcpack writes comes back, digit by digit. Terms come by falling degree, then by
/// falling exponents, those of equal exponents added. What stands behind the last equation, where PHCpack writes titles
/// and solutions, is not read, unless it is one more equation.
///
/// variables: their order; where it is empty, that of their first appearance. Throws InvalidArgument with line and
/// column for text that is no such system, that names other variables or goes beyond the limits, and for numbers of
/// equations and variables other than the text says.
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
