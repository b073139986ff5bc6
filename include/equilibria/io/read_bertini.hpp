/// \file
/// Polynomial systems from text in the classic input format of Bertini 1 (Bates, Hauenstein, Sommese, Wampler,
/// Numerically Solving Polynomial Systems with Bertini, SIAM 2013), which Bertini 2 reads as well:
///
///     CONFIG
///     TrackType: 0;       % settings are passed over
///     END;
///     INPUT
///     variable_group x, y;
///     function f, g;
///     constant a;
///     a = 1/4;
///     circle = x^2 + y^2; % a subfunction
///     f = circle - 1;
///     g = x - a*y;
///     END;
///
/// Sums, products, integer powers, parentheses, division by numbers, I and Pi. Several groups of variables are a
/// grouping for a multihomogeneous start. What is no system of polynomials in affine space is refused:
/// hom_variable_group, homotopies of one's own, sin, cos, exp, random numbers. Needs PEGTL.
#pragma once

#include <complex>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/io/detail/bertini_grammar.hpp>
#include <equilibria/io/polynomial_limits.hpp>
#include <equilibria/io/read_text.hpp>

namespace equilibria {

/// A polynomial system, with the groups of its variables.
struct BertiniSystem {
    PolynomialSystem<std::complex<double>> polynomials;  ///< variables and functions in the order of their declaration
    /// The group of each variable, from 0, as solve_multihomogeneous takes it: a group each variable_group; those
    /// declared as `variable` are one group.
    std::vector<int> grouping;
};

namespace detail::polynomial_text {

/// The text with blanks for comments, so that all else keeps its place.
inline std::string without_comments(std::string_view text) {
    std::string y(text);
    bool comment = false;
    for (char& c : y) {
        comment = c != '\n' && (comment || c == '%');
        if (comment && c != '\r') c = ' ';
    }
    return y;
}

}  // namespace detail::polynomial_text

/// The system in the text; what write_bertini writes comes back, digit by digit. Terms come by falling degree, then by
/// falling exponents. What stands behind END; is not read; CONFIG and INPUT may be left out.
///
/// Throws InvalidArgument with line and column for text that is no such system, or goes beyond the limits.
inline BertiniSystem parse_bertini(std::string_view text, const PolynomialLimits& limits = {}) {
    using namespace detail::polynomial_text;
    limits.validate();
    require_bytes(text, limits);
    BertiniReading r(limits);
    BertiniSystem y;
    parse_text(without_comments(text), text, [&](auto& in) {
        tao::pegtl::parse<grammar::bertini::file, Action, Control>(in, r);
        y.polynomials = system_of(r.variables, r.equations());
    });
    require(!r.variables.empty(), "number of variables", 0, "must be at least 1: variable_group declares them");
    require(!y.polynomials.equations.empty(), "number of functions", 0, "must be at least 1: function declares them");
    y.grouping = r.grouping;
    return y;
}

/// The system in a file. Throws InvalidArgument also where the file cannot be read.
inline BertiniSystem read_bertini(const std::string& path, const PolynomialLimits& limits = {}) {
    limits.validate();
    return parse_bertini(read_text(path, limits.bytes), limits);
}

}  // namespace equilibria
