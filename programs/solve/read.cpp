// Reads a file of solve's, and finds out which of the formats it has.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/polynomial_limits.hpp>
#include <equilibria/io/read_bertini.hpp>
#include <equilibria/io/read_phcpack.hpp>
#include <equilibria/io/read_text.hpp>
#include <equilibria/system/sparse_system.hpp>

#include "solve/solution.hpp"

namespace solve {

namespace {

/// PHCpack's files begin with a number, but for blanks and comments.
bool is_phcpack(const std::string& text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t first = std::min(text.find_first_not_of(" \t\r", begin), end);
        const bool comment =
            first < end && (text[first] == '#' || text[first] == '%' || text.compare(first, 2, "--") == 0);
        if (first < end && !comment) return '0' <= text[first] && text[first] <= '9';
        begin = end + 1;
    }
    return false;
}

using Equation = std::vector<equilibria::PolynomialTerm<std::complex<double>>>;

/// Whether a b = c d, without rounding.
bool same_products(double a, double b, double c, double d) {
    return a * b == c * d && std::fma(a, b, -(a * b)) == std::fma(c, d, -(c * d));
}

/// Whether two equations with real coefficients and terms in the same order are multiples of each other.
bool are_multiples(const Equation& f, const Equation& g) {
    if (f.size() != g.size()) return false;
    for (std::size_t k = 0; k < f.size(); ++k)
        if (f[k].exponents != g[k].exponents || !same_products(f[k].coefficient.real(), g[0].coefficient.real(),
                                                               g[k].coefficient.real(), f[0].coefficient.real()))
            return false;
    return true;
}

std::string counted(std::size_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// Throws std::invalid_argument, in one sentence, where the system cannot have isolated roots alone, or has none of our
/// kind.
void check(const equilibria::PolynomialSystem<std::complex<double>>& system) {
    const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
    const auto& equations = system.equations;
    if (equations.size() != system.variables.size())
        refuse(counted(equations.size(), "equation") + " in " + counted(system.variables.size(), "unknown") +
               ": must be as many equations as unknowns");
    for (std::size_t i = 0; i < equations.size(); ++i) {
        const std::string name = "equation " + std::to_string(i + 1);
        if (equations[i].empty()) refuse(name + " is 0: must not vanish identically");
        bool constant = true;
        for (const auto& t : equations[i]) {
            if (t.coefficient.imag() != 0) refuse(name + " has complex coefficients: must be real");
            for (const int k : t.exponents) constant = constant && k == 0;
        }
        if (constant) refuse(name + " is a number other than 0: must have an unknown, and no root exists");
        for (std::size_t j = 0; j < i; ++j)
            if (are_multiples(equations[j], equations[i]))
                refuse(name + " is equation " + std::to_string(j + 1) +
                       (equations[j][0].coefficient == equations[i][0].coefficient ? "" : ", times a number") +
                       ": no two may be the same, for then no root is isolated");
    }
}

Input input_of(std::string format, const equilibria::PolynomialSystem<std::complex<double>>& system,
               std::vector<int> grouping) {
    check(system);
    return {std::move(format), system.variables, equilibria::sparse_system(system), std::move(grouping)};
}

}  // namespace

Input read(const std::string& path, const std::string& format) {
    const equilibria::PolynomialLimits limits;
    const std::string text = equilibria::read_text(path, limits.bytes);
    if (format == "phcpack" || (format == "auto" && is_phcpack(text)))
        return input_of("PHCpack", equilibria::parse_phcpack(text, {}, limits), {});
    auto [system, grouping] = equilibria::parse_bertini(text, limits);
    bool groups = false;
    for (const int g : grouping) groups = groups || g > 0;
    if (!groups) grouping.clear();
    return input_of("Bertini", system, std::move(grouping));
}

}  // namespace solve
