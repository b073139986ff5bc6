#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/system/laurent_terms.hpp>

#include "support/catch.hpp"
#include "support/families.hpp"

using namespace equilibria;
using Number = std::complex<double>;

namespace {

Number value(const std::vector<PolynomialTerm<Number>>& equation, const std::vector<Number>& z) {
    Number sum = 0;
    for (const auto& t : equation) {
        Number product = t.coefficient;
        for (std::size_t u = 0; u < z.size(); ++u) product *= std::pow(z[u], t.exponents[u]);
        sum += product;
    }
    return sum;
}
Number value(const SparseSystem& system, int equation, const std::vector<Number>& q) {
    Number sum = 0;
    for (const auto& t : system.terms()) {
        if (t.equation != equation) continue;
        Number product = t.coefficient;
        for (int u = 0; u < system.sizes().unknowns; ++u) {
            const int code = t.monomial.code(u);
            const Number x = q[static_cast<std::size_t>(u)];
            if (u >= system.sizes().angles)
                product *= std::pow(x, code);
            else if (code != 0)
                product *=
                    code > 0 ? std::cos(static_cast<double>(code) * x) : std::sin(static_cast<double>(-code) * x);
        }
        sum += product;
    }
    return sum;
}

}  // namespace

TEST_CASE("a system and its Laurent form have the same values at complex angles and coordinates") {
    const SparseSystem system(RuntimeSizes(2, 1), {{0, SparseMonomial({-2, 1, 1}), 1.5},
                                                   {0, SparseMonomial({0, 3, 0}), -0.5},
                                                   {0, SparseMonomial({1, -1, 2}), 2},
                                                   {1, SparseMonomial({-1, -1, 0}), 1},
                                                   {1, SparseMonomial({0, 0, 0}), 0.25},
                                                   {2, SparseMonomial({0, 0, 3}), -1},
                                                   {2, SparseMonomial({-1, 0, 0}), 1}});
    const auto laurent = laurent_terms(system);
    Generator generator(2);
    for (int draw = 0; draw < 50; ++draw) {
        std::vector<Number> q, z;
        for (int u = 0; u < 3; ++u) {
            q.push_back({uniform(generator, -2, 2), uniform(generator, -1, 1)});
            z.push_back(u < 2 ? std::exp(Number(0, 1) * q.back()) : q.back());
        }
        for (int i = 0; i < 3; ++i)
            CHECK(std::abs(value(laurent[static_cast<std::size_t>(i)], z) - value(system, i, q)) < 1e-12);
    }
}

TEST_CASE("what cancels is no exponent: cos(theta_1 - theta_2) has two") {
    const SparseSystem system(
        RuntimeSizes(2, 0),
        {{0, SparseMonomial({1, 1}), 0.3}, {0, SparseMonomial({-1, -1}), 0.3}, {1, SparseMonomial({0, -1}), 1}});
    const auto supports = laurent_supports(system);
    CHECK(supports.equations()[0].size() == 2);
    CHECK(supports.equations()[1].size() == 2);
}

TEST_CASE("the origin is added where a coordinate may be 0 at a root, and only there") {
    // x y - 1, x + y: no root on an axis
    const SparseSystem off(RuntimeSizes(0, 2), {{0, SparseMonomial({1, 1}), 1},
                                                {0, SparseMonomial({0, 0}), -1},
                                                {1, SparseMonomial({1, 0}), 1},
                                                {1, SparseMonomial({0, 1}), 1}});
    CHECK(affine_supports(off).columns() == laurent_supports(off).columns());
    // x (y - 1), x + y: the root (0, 0)
    const SparseSystem on(RuntimeSizes(0, 2), {{0, SparseMonomial({1, 1}), 1},
                                               {0, SparseMonomial({1, 0}), -1},
                                               {1, SparseMonomial({1, 0}), 1},
                                               {1, SparseMonomial({0, 1}), 1}});
    CHECK(affine_supports(on).columns() == laurent_supports(on).columns() + 2);
    // angles are never 0 on the torus
    const families::LoadedAngles angles{3, families::row(3)};
    const auto system = families::system_of(angles, families::generic(angles.parameters(), 1));
    CHECK(affine_supports(system).columns() == laurent_supports(system).columns());
}
