// Linear-product starts: as many solutions as the multihomogeneous number, each one a solution of the start system, and the
// same roots as from a total-degree start.
#include <algorithm>
#include <complex>

#include <equilibria/model/torus.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/system/linear_product.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// Two angles and a coordinate in two groups: x enters linearly, so that {theta}, {x} needs 12 paths instead of 24.
struct Grouped {
    static constexpr int n_angles = 2, n_coordinates = 1;
    enum Parameter { a, b, c, n_parameters };
    static constexpr Array<int, 3> grouping{0, 0, 1};
    constexpr auto equations(const auto& theta, const auto& x, const auto& p) const {
        return std::array{sin(theta[0]) + p[a] * sin(theta[0]) * cos(theta[1]) * x[0] - p[b],
                          cos(theta[0]) - p[b] * sin(theta[1]) - p[c],
                          sin(theta[1]) + p[c] * cos(theta[0]) * x[0] - p[b] * x[0]};
    }
};

}  // namespace

TEST_CASE("the start system has as many solutions as the multihomogeneous number, each one exact") {
    Generator generator(3);
    const Parameters<Grouped> p{.7, .4, .3};
    const LinearProductStart<Grouped> start(p, generator);
    CHECK(static_cast<std::int64_t>(start.solutions.size()) == multihomogeneous_number<Grouped>(Grouped::grouping).value);
    CHECK(start.solutions.size() == 12);
    CHECK(total_degree<Grouped>() == 24);
    using F = Formulation<LinearProduct<Grouped>>;
    for (const auto& q : start.solutions) {
        std::complex<double> value[3] = {};
        for (int k = 0; k < F::terms; ++k) {
            std::complex<double> term = start.coefficients[k];
            for (int u = 0; u < 3; ++u) {
                const int code = F::support[k].monomial.code(u);
                const double m = std::abs(code);
                if (u == 2)
                    term *= std::pow(q[u], code);
                else if (code != 0)
                    term *= code > 0 ? std::cos(m * q[u]) : std::sin(m * q[u]);
            }
            value[F::support[k].equation] += term;
        }
        for (const auto& v : value) CHECK(std::abs(v) < 1e-12);
    }
}

TEST_CASE("a linear-product start finds the roots that a total-degree start finds") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Generator generator(seed);
        Parameters<Grouped> p;
        for (double& x : p) x = uniform(generator, -1, 1);
        const auto all = enumerate<Grouped>(p, {.seed = seed});
        const auto found = solve_multihomogeneous<Grouped>(p, {.seed = seed});
        CHECK(found.paths.accounted_for());
        CHECK(found.paths.failed == 0);
        REQUIRE(found.roots.size() == all.roots.size());
        for (const auto& root : all.roots) {
            double nearest = 1;
            for (const auto& other : found.roots) {
                double off = 0;
                for (int u = 0; u < 3; ++u) {
                    const auto d = root.q[u] - other.q[u];
                    const double re = u < 2 ? wrap(d.real()) : d.real();
                    off = std::max(off, std::hypot(re, d.imag()));
                }
                nearest = std::min(nearest, off);
            }
            CHECK(nearest < 1e-9);
        }
    }
}

TEST_CASE("terms with the coefficient 0 cost no paths") {
    Generator generator(1);
    const LinearProductStart<Grouped> whole({.7, .4, .3}, generator), without({0, .4, .3}, generator);
    CHECK(whole.solutions.size() == 12);
    CHECK(without.solutions.size() == 4);
}
