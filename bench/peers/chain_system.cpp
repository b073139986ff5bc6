// The benchmark chain of LINKS links (a macro), for other solvers: l_i = 1 + i/10, m_i = 1 + i^2/20, g = 1, omega
// = 1.7.
//
//   chain_system phcpack | macaulay2 | bertini | julia    writes the system
//   chain_system phcpack-start                            writes a total-degree start with its 4^n solutions for phc -p
//   chain_system count < solutions                        counts the roots among solutions, one a line:
//                                                         c1 <re> <im> s1 <re> <im> ..., the variables in any order
//
// Every solver's answer goes through the same count. A root is a point where every equation is at most 1e-8 (its
// coefficients are of order 1 to 30), points closer than 1e-6 are one root, and an imaginary part below 1e-8 is none.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

namespace {

using Model = equilibria::mechanisms::RotatingChain<LINKS>;
using Z = std::complex<double>;
using Point = std::vector<Z>;

equilibria::PolynomialSystem<double> chain() {
    equilibria::Parameters<Model> p;
    for (int i = 0; i < LINKS; ++i) {
        p[Model::length + i] = 1 + 0.1 * (i + 1);
        p[Model::mass + i] = 1 + 0.05 * (i + 1) * (i + 1);
    }
    p[Model::omega] = 1.7;
    p[Model::gravity] = 1;
    return equilibria::polynomial_system<Model>(p);
}

/// v^2 - r_v = 0 for each variable v: every equation of the chain has degree 2. In PHCpack's format with solutions.
void write_phcpack_start(std::ostream& out) {
    const auto target = chain();
    const std::size_t n = target.variables.size();
    equilibria::Generator generator(1);
    equilibria::PolynomialSystem<Z> start{target.variables, {}};
    Point root;
    for (std::size_t v = 0; v < n; ++v) {
        const Z r = equilibria::unit_complex(generator);
        root.push_back(std::sqrt(r));
        std::vector<int> square(n);
        square[v] = 2;
        start.equations.push_back({{1, square}, {-r, std::vector<int>(n)}});
    }
    equilibria::write_phcpack(out, start);
    const unsigned long count = 1ul << n;
    out << "\nTHE SOLUTIONS :\n\n" << count << " " << n << "\n" << std::string(75, '=') << "\n";
    char line[120];
    for (unsigned long k = 0; k < count; ++k) {
        out << "solution " << k + 1 << " :\nt :  0.0E+00   0.0E+00\nm : 1\nthe solution for t :\n";
        for (std::size_t v = 0; v < n; ++v) {
            const Z z = k >> v & 1 ? -root[v] : root[v];
            std::snprintf(line, sizeof line, " %s : %.16E  %.16E\n", start.variables[v].c_str(), z.real(), z.imag());
            out << line;
        }
        out << "== err :  0.0E+00 = rco :  1.0E+00 = res :  0.0E+00 ==\n";
    }
}

double distance(const Point& a, const Point& b) {
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, std::abs(a[v] - b[v]));
    return largest;
}

/// Prints "<distinct roots> <real ones>".
void count(std::istream& in, std::ostream& out) {
    const auto system = chain();
    // Close points have close projections on a random line: only neighbours there are compared.
    equilibria::Generator generator(2);
    Point line;
    for (std::size_t v = 0; v < system.variables.size(); ++v) line.push_back(equilibria::unit_complex(generator));
    std::vector<std::pair<double, Point>> roots;
    for (std::string text; std::getline(in, text);) {
        std::istringstream words(text);
        Point point(system.variables.size(), Z(std::nan(""), 0));
        double re = 0, im = 0;
        for (std::string name; words >> name >> re >> im;) {
            const auto at = std::find(system.variables.begin(), system.variables.end(), name);
            if (at != system.variables.end()) point[static_cast<std::size_t>(at - system.variables.begin())] = {re, im};
        }
        bool is_root = true;
        for (const Z& f : evaluate(system, point)) is_root = is_root && std::abs(f) <= 1e-8;
        double projection = 0;
        for (std::size_t v = 0; v < point.size(); ++v) projection += (line[v] * point[v]).real();
        if (is_root) roots.emplace_back(projection, point);
    }
    std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    int distinct = 0, real = 0;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const double reach = 1e-6 * static_cast<double>(line.size());
        bool known = false;
        for (std::size_t j = k; j-- > 0 && roots[k].first - roots[j].first < reach && !known;)
            known = distance(roots[k].second, roots[j].second) < 1e-6;
        if (known) continue;
        ++distinct;
        real += std::all_of(roots[k].second.begin(), roots[k].second.end(),
                            [](const Z& z) { return std::abs(z.imag()) < 1e-8; });
    }
    out << distinct << " " << real << "\n";
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc == 2 ? argv[1] : "";
    if (what == "phcpack")
        equilibria::write_phcpack(std::cout, chain());
    else if (what == "phcpack-start")
        write_phcpack_start(std::cout);
    else if (what == "macaulay2")
        equilibria::write_macaulay2(std::cout, chain());
    else if (what == "bertini")
        equilibria::write_bertini(std::cout, chain());
    else if (what == "julia")
        equilibria::write_homotopy_continuation(std::cout, chain());
    else if (what == "count")
        count(std::cin, std::cout);
    else {
        std::cerr << "chain_system: one of phcpack, phcpack-start, macaulay2, bertini, julia, count\n";
        return 2;
    }
}
