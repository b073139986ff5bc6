// Systems of families with known numbers of roots, for other solvers, and the count of what they found.
//
//   system_files NAME phcpack | macaulay2 | bertini | julia | gfan    writes the system; see tests/support/families.hpp
//   system_files NAME known                    how many roots it has, 0 if that is not known
//   system_files NAME count < solutions        counts the roots among solutions, one a line:
//                                              x1 <re> <im> x2 <re> <im> ..., the variables in any order
//
// gfan's are the equations over a polynomial ring, as gfan_mixedvolume takes them. Every solver's answer goes through
// the same count: a root is what Newton's method in 31 digits finds next to the point; points closer than 1e-5,
// relative to their size, are one root; an imaginary part below 1e-8 is none.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/core/double_double.hpp>
#include <equilibria/core/linear_solve.hpp>
#include <equilibria/core/sized_array.hpp>
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

/// In 31 digits: of roots with conditions of 1e12 doubles leave nothing.
using Digits = equilibria::DoubleDouble;
using Complex = equilibria::Complex<Digits>;

/// A step of Newton's method, of each variable; nothing where the Jacobian has no inverse.
Point newton_step(const System& system, const std::vector<Complex>& point) {
    const int n = static_cast<int>(point.size());
    equilibria::RuntimeMatrix<Complex> jacobian(n);
    equilibria::RuntimeArray<Complex> step(n);
    for (int i = 0; i < n; ++i) {
        std::vector<Complex> row(point.size() + 1, Complex(0.0));
        for (const auto& t : system.equations[static_cast<std::size_t>(i)])
            for (std::size_t by = 0; by <= point.size(); ++by) {
                Complex product(static_cast<double>(t.coefficient));
                for (std::size_t v = 0; v < point.size(); ++v) {
                    const int e = t.exponents[v];
                    if (v == by) product *= Digits(e);
                    for (int k = v == by ? 1 : 0; k < e; ++k) product *= point[v];
                }
                row[by] += product;
            }
        for (int u = 0; u < n; ++u) jacobian[i][u] = row[static_cast<std::size_t>(u)];
        step[i] = row.back();
    }
    equilibria::PivotedFactorization<Digits> lu(n);
    lu.factor(jacobian);
    lu.solve(step);
    Point y;
    for (const auto& z : step) y.emplace_back(-static_cast<double>(z.re), -static_cast<double>(z.im));
    return y;
}

double size(const Point& point) {
    double largest = 1;
    for (const Z& z : point) largest = std::max(largest, std::abs(z));
    return largest;
}
double length(const Point& step) {
    double largest = 0;
    for (const Z& z : step)
        if (!(std::abs(z) <= largest)) largest = std::abs(z);
    return largest;
}

/// The root that Newton's method finds next to the point: nothing where it goes away, as on paths to infinity, or does
/// not converge, as at singular ones.
std::optional<Point> root_next_to(const System& system, const Point& given) {
    std::vector<Complex> point;
    for (const Z& z : given) point.emplace_back(Digits(z.real()), Digits(z.imag()));
    for (int round = 0; round < 5; ++round) {
        const Point step = newton_step(system, point);
        if (!(length(step) <= 1e-4 * size(given))) return {};
        for (std::size_t v = 0; v < point.size(); ++v)
            point[v] += Complex(Digits(step[v].real()), Digits(step[v].imag()));
        if (!(length(step) <= 1e-10 * size(given))) continue;
        Point y;
        for (const Complex& z : point) y.emplace_back(static_cast<double>(z.re), static_cast<double>(z.im));
        return y;
    }
    return {};
}

bool same(const Point& a, const Point& b) {
    double apart = 0;
    for (std::size_t v = 0; v < a.size(); ++v) apart = std::max(apart, std::abs(a[v] - b[v]));
    return apart < 1e-5 * size(a);
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
        const auto root = root_next_to(system, point);
        if (!root) continue;
        if (std::any_of(roots.begin(), roots.end(), [&](const Point& other) { return same(*root, other); })) continue;
        roots.push_back(*root);
        real += std::all_of(root->begin(), root->end(),
                            [](const Z& z) { return std::abs(z.imag()) < 1e-8 * (1 + std::abs(z)); });
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
        else if (what == "known")
            std::cout << equilibria::families::known_roots(argv[1]) << "\n";
        else if (what == "count")
            count(std::cin, std::cout, equilibria::families::by_name(argv[1]));
        else {
            std::cerr << "system_files: NAME and one of phcpack, macaulay2, bertini, julia, gfan, known, count\n";
            return 2;
        }
    } catch (const std::exception& error) {
        std::cerr << "system_files: " << error.what() << "\n";
        return 2;
    }
}
