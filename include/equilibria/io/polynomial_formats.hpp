/// \file
/// Polynomial systems as input of other solvers, to compare with them and to check against them: PHCpack, Bertini,
/// HomotopyContinuation.jl and Macaulay2. Coefficients have as many decimal digits as make them come back exactly.
///
/// Each function throws InvalidArgument for a coefficient that is not finite, for a variable whose name the program
/// would misread, and where the program takes no negative exponents, for those (see LaurentForm::non_negative).
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/error.hpp>

namespace equilibria {

namespace detail {

/// How a program spells polynomials.
struct Spelling {
    std::string_view program;
    std::string_view imaginary_unit;
    bool negative_exponents;
    bool underscores;                                  ///< in names
    std::string_view first_letters;                    ///< with which no name may start
    std::initializer_list<std::string_view> reserved;  ///< names that mean something else
};

inline bool is_name(const std::string& name, const Spelling& spelling) {
    const auto letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); };
    if (name.empty() || !letter(name[0]) || spelling.first_letters.find(name[0]) != std::string_view::npos)
        return false;
    for (char c : name)
        if (!letter(c) && !('0' <= c && c <= '9') && !(c == '_' && spelling.underscores)) return false;
    for (std::string_view r : spelling.reserved)
        if (name == r) return false;
    return true;
}

template <class R>
std::string decimal(const R& value) {
    std::ostringstream out;
    out << std::scientific;
    out.precision(std::numeric_limits<R>::max_digits10 - 1);
    out << (value == 0 ? R(0) : value);  // no -0
    return out.str();
}

template <class R>
std::string coefficient(const R& re, const R& im, const Spelling& spelling) {
    if (im == 0) return decimal(re);
    const bool minus = im < 0;
    return "(" + decimal(re) + (minus ? " - " : " + ") + decimal(minus ? R(-im) : im) + "*" +
           std::string(spelling.imaginary_unit) + ")";
}

template <class C>
std::string expression(const std::vector<PolynomialTerm<C>>& equation, const std::vector<std::string>& variables,
                       const Spelling& spelling) {
    std::string text;
    for (const auto& t : equation) {
        auto [re, im] = [&] {
            if constexpr (requires { t.coefficient.re; })
                return std::pair(t.coefficient.re, t.coefficient.im);
            else if constexpr (std::is_same_v<C, std::complex<typename RealPart<C>::type>>)
                return std::pair(t.coefficient.real(), t.coefficient.imag());
            else
                return std::pair(t.coefficient, C(0));
        }();
        using std::isfinite;
        if (!isfinite(re) || !isfinite(im)) throw InvalidArgument("coefficient", to_text(re), "must be finite");
        if (re == 0 && im == 0) continue;
        const bool minus = im == 0 && re < 0;
        if (minus) re = -re;
        text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
        text += coefficient(re, im, spelling);
        for (std::size_t v = 0; v < variables.size(); ++v) {
            const int e = t.exponents[v];
            if (e == 0) continue;
            if (e < 0 && !spelling.negative_exponents)
                throw InvalidArgument("exponent of " + variables[v], to_text(e),
                                      "must not be negative for " + std::string(spelling.program));
            text += "*" + variables[v];
            if (e != 1) text += (e < 0 ? "^(" : "^") + std::to_string(e) + (e < 0 ? ")" : "");
        }
    }
    return text.empty() ? "0" : text;
}

/// The equations' expressions, after the names were checked.
template <class C>
std::vector<std::string> expressions(const PolynomialSystem<C>& system, const Spelling& spelling) {
    for (const auto& name : system.variables)
        if (!is_name(name, spelling))
            throw InvalidArgument("variable", name, "is not a name of a variable in " + std::string(spelling.program));
    std::vector<std::string> y;
    for (const auto& equation : system.equations) y.push_back(expression(equation, system.variables, spelling));
    return y;
}

inline std::string joined(const std::vector<std::string>& parts, std::string_view separator) {
    std::string text;
    for (const auto& part : parts) text += (text.empty() ? "" : std::string(separator)) + part;
    return text;
}

}  // namespace detail

/// The input file of PHCpack (`phc -b input output`), Laurent systems too. Names must not start with i, I, e or E.
template <class C>
void write_phcpack(std::ostream& out, const PolynomialSystem<C>& system) {
    const auto equations = detail::expressions(system, {"PHCpack", "i", true, true, "iIeE", {}});
    out << equations.size();
    if (equations.size() != system.variables.size()) out << " " << system.variables.size();
    for (const auto& e : equations) out << "\n" << e << ";";
    out << "\n";
}

/// The input file of Bertini 1 and of Bertini 2's classic mode, all variables in one group.
template <class C>
void write_bertini(std::ostream& out, const PolynomialSystem<C>& system) {
    const auto equations = detail::expressions(
        system, {"Bertini", "I", false, true, "", {"I", "i", "Pi", "sin", "cos", "tan", "exp", "pow", "END"}});
    std::vector<std::string> names;
    for (std::size_t k = 1; k <= equations.size(); ++k) {
        names.push_back("equation" + std::to_string(k));
        for (const auto& variable : system.variables)
            require(variable != names.back(), "variable", variable, "must not be the name of an equation");
    }
    out << "CONFIG\nEND;\nINPUT\nvariable_group " << detail::joined(system.variables, ", ") << ";\nfunction "
        << detail::joined(names, ", ") << ";\n";
    for (std::size_t k = 0; k < equations.size(); ++k) out << names[k] << " = " << equations[k] << ";\n";
    out << "END;\n";
}

/// A Julia program that solves the system with HomotopyContinuation.jl: `F` is the system, `result` what came back.
template <class C>
void write_homotopy_continuation(std::ostream& out, const PolynomialSystem<C>& system) {
    const auto equations = detail::expressions(system, {"HomotopyContinuation.jl",
                                                        "im",
                                                        false,
                                                        true,
                                                        "",
                                                        {"im", "pi", "F", "result", "solve", "System", "begin", "end",
                                                         "for", "if", "do", "in", "let", "try"}});
    out << "using HomotopyContinuation\n@var " << detail::joined(system.variables, " ") << "\nF = System([\n    "
        << detail::joined(equations, ",\n    ") << ",\n], variables = [" << detail::joined(system.variables, ", ")
        << "])\nresult = solve(F)\n";
}

/// A Macaulay2 program that defines the system, the list F of elements of R, for `solveSystem F` of the package
/// NumericalAlgebraicGeometry. Names have no underscores.
template <class C>
void write_macaulay2(std::ostream& out, const PolynomialSystem<C>& system) {
    const auto equations = detail::expressions(
        system, {"Macaulay2", "ii", false, false, "", {"ii", "pi", "CC", "RR", "QQ", "ZZ", "F", "R"}});
    out << "needsPackage \"NumericalAlgebraicGeometry\"\nR = CC[" << detail::joined(system.variables, ", ")
        << "]\nF = {\n    " << detail::joined(equations, ",\n    ") << "\n}\n";
}

}  // namespace equilibria
