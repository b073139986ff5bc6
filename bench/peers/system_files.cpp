// Systems of families with known numbers of roots, for other solvers, and the count of what they found.
//
//   system_files NAME phcpack | macaulay2 | bertini | julia | gfan    writes the system; see tests/support/families.hpp
//   system_files NAME count < solutions        counts the roots among solutions, one a line:
//                                              x1 <re> <im> x2 <re> <im> ..., the variables in any order
//
// gfan's are the equations over a polynomial ring, as gfan_mixedvolume takes them. Every solver's answer goes through
// the same count: a root is a point where every equation is at most 1e-8 of the sum of its terms' sizes, or of 1 where
// that is less; points closer than 1e-6, relative to their size, are one root; an imaginary part below 1e-8 is none.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/io/polynomial_formats.hpp>

#include "support/families.hpp"

namespace {

using System = equilibria::PolynomialSystem<double>;
using Z = std::complex<double>;
using Point = std::vector<Z>;

/// The supports alone matter, and gfan wants integers: coefficients 1.
void write_gfan(std::ostream& out, const System& system) {
    out << "Q[";
    for (std::size_t v = 0; v < system.variables.size(); ++v) out << (v > 0 ? "," : "") << system.variables[v];
    out << "]\n{";
    for (std::size_t i = 0; i < system.equations.size(); ++i) {
        out << (i > 0 ? ",\n" : "");
        for (std::size_t k = 0; k < system.equations[i].size(); ++k) {
            out << (k > 0 ? "+1" : "1");
            const auto& exponents = system.equations[i][k].exponents;
            for (std::size_t v = 0; v < exponents.size(); ++v)
                if (exponents[v] > 0) out << "*" << system.variables[v] << "^" << exponents[v];
        }
    }
    out << "}\n";
}

/// Each equation at the point, relative to its terms.
double residual(const System& system, const Point& point) {
    double largest = 0;
    for (const auto& equation : system.equations) {
        Z sum = 0;
        double size = 1;
        for (const auto& t : equation) {
            Z product = t.coefficient;
            for (std::size_t v = 0; v < point.size(); ++v)
                for (int k = 0; k < t.exponents[v]; ++k) product *= point[v];
            sum += product;
            size += std::abs(product);
        }
        if (!(std::abs(sum) / size <= largest)) largest = std::abs(sum) / size;
    }
    return largest;
}

bool same(const Point& a, const Point& b) {
    double apart = 0, size = 1;
    for (std::size_t v = 0; v < a.size(); ++v) {
        apart = std::max(apart, std::abs(a[v] - b[v]));
        size = std::max(size, std::abs(a[v]));
    }
    return apart < 1e-6 * size;
}

/// Prints "<distinct roots> <real ones>".
void count(std::istream& in, std::ostream& out, const System& system) {
    std::vector<Point> roots;
    int real = 0;
    for (std::string text; std::getline(in, text);) {
        std::istringstream words(text);
        Point point(system.variables.size(), Z(std::nan(""), 0));
        double re = 0, im = 0;
        for (std::string name; words >> name >> re >> im;) {
            const auto at = std::find(system.variables.begin(), system.variables.end(), name);
            if (at != system.variables.end()) point[static_cast<std::size_t>(at - system.variables.begin())] = {re, im};
        }
        if (!(residual(system, point) <= 1e-8)) continue;
        if (std::any_of(roots.begin(), roots.end(), [&](const Point& other) { return same(point, other); })) continue;
        roots.push_back(point);
        real += std::all_of(point.begin(), point.end(), [](const Z& z) { return std::abs(z.imag()) < 1e-8; });
    }
    out << roots.size() << " " << real << "\n";
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc == 3 ? argv[2] : "";
    try {
        if (what == "phcpack")
            equilibria::write_phcpack(std::cout, equilibria::families::by_name(argv[1]));
        else if (what == "macaulay2")
            equilibria::write_macaulay2(std::cout, equilibria::families::by_name(argv[1]));
        else if (what == "bertini")
            equilibria::write_bertini(std::cout, equilibria::families::by_name(argv[1]));
        else if (what == "julia")
            equilibria::write_homotopy_continuation(std::cout, equilibria::families::by_name(argv[1]));
        else if (what == "gfan")
            write_gfan(std::cout, equilibria::families::by_name(argv[1]));
        else if (what == "count")
            count(std::cin, std::cout, equilibria::families::by_name(argv[1]));
        else {
            std::cerr << "system_files: NAME and one of phcpack, macaulay2, bertini, julia, gfan, count\n";
            return 2;
        }
    } catch (const std::exception& error) {
        std::cerr << "system_files: " << error.what() << "\n";
        return 2;
    }
}
