// Linear-product starts: as many solutions as the multihomogeneous number, each one a solution of the start system, and
// the same roots as from a total-degree start.
#include <algorithm>
#include <complex>

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/start/linear_product.hpp>

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
    const auto system = sparse_system<Grouped>(p);
    const LinearProduct start(system, Grouped::grouping, unit_complex(generator), generator);
    CHECK(static_cast<std::int64_t>(start.solutions().size()) ==
          multihomogeneous_number<Grouped>(Grouped::grouping).value);
    CHECK(start.solutions().size() == 12);
    CHECK(total_degree<Grouped>() == 24);
    // H(q, 0) = G
    const PolynomialHomotopy homotopy(system, start);
    PolynomialHomotopy::Evaluation<double, double> evaluation(homotopy);
    for (std::uint64_t k = 0; k < start.solutions().size(); ++k) {
        Complex<double> g[3];
        evaluation.value(start.point(k), 0.0, g);
        for (const auto& value : g) CHECK(std::sqrt(norm2(value)) < 1e-12);
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
    const auto solutions = [&](const Parameters<Grouped>& p) {
        return LinearProduct(sparse_system<Grouped>(p), Grouped::grouping, 1.0, generator).solutions().size();
    };
    CHECK(solutions({.7, .4, .3}) == 12);
    CHECK(solutions({0, .4, .3}) == 4);
}
