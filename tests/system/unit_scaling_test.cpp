// Units: powers of two, exact both ways, that bring coefficients of any units near to 1.
#include <cmath>
#include <complex>
#include <vector>

#include <equilibria/io/read_phcpack.hpp>
#include <equilibria/system/unit_scaling.hpp>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("scaling is exact, and undone exactly", "[unit_scaling]") {
    const auto system = sparse_system(parse_phcpack("2\n3e9*x^2*y-0.1*x+7e-12;\nx*y^3-1e15;\n"));
    const UnitScaling units = unit_scaling(system);
    const SparseSystem other = scaled(system, units);
    for (std::size_t k = 0; k < system.terms().size(); ++k) {
        const auto& t = system.terms()[k];
        int power = units.equation[static_cast<std::size_t>(t.equation)];
        for (int u = 0; u < 2; ++u) power += t.monomial.code(u) * units.unknown[static_cast<std::size_t>(u)];
        CHECK(std::ldexp(other.terms()[k].coefficient, -power) == t.coefficient);
    }
    std::vector<std::complex<double>> q{{0.1, -0.7}, {3, 1e-3}};
    const auto before = q;
    units.undo(q);
    for (std::size_t u = 0; u < 2; ++u) CHECK(q[u] == before[u] * std::ldexp(1.0, units.unknown[u]));
}

TEST_CASE("coefficients of a system in other units come back to those near 1", "[unit_scaling]") {
    for (const double a : {1e-9, 1.0, 1e9})
        for (const double b : {1e-6, 1e7}) {
            const auto system = sparse_system(parse_phcpack("2\nx^2*y-2*x+3;\nx*y^2-y+1;\n"));
            std::vector<SparseTerm> terms = system.terms();
            for (auto& t : terms) t.coefficient *= std::pow(a, t.monomial.code(0)) * std::pow(b, t.monomial.code(1));
            const SparseSystem other(system.sizes(), std::move(terms));
            const SparseSystem in_units = scaled(other, unit_scaling(other));
            for (const auto& t : in_units.terms()) {
                CHECK(std::abs(t.coefficient) < 8);
                CHECK(std::abs(t.coefficient) > 0.2);
            }
        }
}

TEST_CASE("a system in its own units is left as it is", "[unit_scaling]") {
    CHECK(unit_scaling(sparse_system(parse_phcpack("1\nx^2-x+1;\n"))).trivial());
}
