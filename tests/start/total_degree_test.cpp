// Start points of total-degree homotopies solve the start system, are distinct, and come in mirror pairs where it is
// odd.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/total_degree.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using Z = std::complex<double>;

namespace {

using Chain = mechanisms::RotatingChain<3>;

/// cos(k theta) or, below 0, sin(|k| theta) at a point (c, s) of the complex circle.
Z factor(int code, Z c, Z s) {
    const Z z = std::pow(c + Z(0, 1) * s, std::abs(code)), w = std::pow(c - Z(0, 1) * s, std::abs(code));
    return code >= 0 ? (z + w) / 2.0 : (z - w) / Z(0, 2);
}

Z value(const Complex<double>& a) { return {a.re, a.im}; }

template <class StartSystem>
void check_points(const StartSystem& start) {
    std::vector<std::vector<Z>> points;
    for (std::uint64_t k = 0; k < start.numbering().tracked(); ++k) {
        const auto q = start.point(k);
        points.emplace_back();
        for (int i = 0; i < 3; ++i) {
            const Z c = value(q.c[i]), s = value(q.s[i]);
            CHECK(std::abs(c * c + s * s - 1.0) < 1e-12 * (1 + std::norm(c)));
            const int degree = Formulation<Chain>::degrees[i];
            Z sum = 0;
            double size = 0;
            for (int code = -degree; code <= degree; ++code) {
                const Z term = start.system().coefficient(i, code) * factor(code, c, s);
                sum += term;
                size += std::abs(term);
            }
            CHECK(std::abs(sum) <= 1e-12 * size);
            points.back().insert(points.back().end(), {c, s});
        }
    }
    for (std::size_t a = 0; a < points.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            double apart = 0;
            for (std::size_t u = 0; u < points[a].size(); ++u)
                apart = std::max(apart, std::abs(points[a][u] - points[b][u]));
            REQUIRE(apart > 1e-6);
        }
}

const ModelSystem<Chain>& target() {
    static const ModelSystem<Chain> system([] {
        Parameters<Chain> p;
        for (double& x : p) x = 1.3;
        return p;
    }());
    return system;
}

}  // namespace

TEST_CASE("Points of the total-degree start solve it and are as many as its degree") {
    Generator generator(1);
    const TotalDegree<Chain> start(target(), generator);
    CHECK(start.numbering().total() == 64);  // 4^3
    check_points(start);
}

TEST_CASE("Points of the reflected start solve it, one of each mirror pair, and 2^n rest") {
    Generator generator(1);
    const Reflected<Chain> start(target(), generator);
    CHECK(start.numbering().total() == 64);
    CHECK(start.numbering().resting() == 8);
    CHECK(start.numbering().tracked() == 28);
    check_points(start);
    for (std::uint64_t k = 0; k < 28; ++k) {
        const std::uint64_t path = start.numbering().tracked_path(k);
        const auto q = start.point(k), image = start.point_of(start.numbering().mirror(path));
        for (int i = 0; i < 3; ++i) {
            CHECK(std::abs(value(q.c[i]) - value(image.c[i])) < 1e-12);
            CHECK(std::abs(value(q.s[i]) + value(image.s[i])) < 1e-12);
        }
    }
    for (std::uint64_t k = 0; k < 8; ++k)
        for (const auto& s : start.resting_point(k).s) CHECK(std::abs(value(s)) < 1e-15);
}
