#include <complex>
#include <cstdint>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/total_degree_system.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using Z = std::complex<double>;

/// G_i at a start coordinate, from its harmonics.
template <class M>
Z value(const TotalDegreeSystem& start, int i, const StartCoordinate& at) {
    const int d = Formulation<M>::degrees[i];
    Z sum = start.coefficient(i, 0);
    if (i >= n_angles<M>) return sum + start.coefficient(i, d) * std::pow(at.c, d);
    Z c = 1, s = 0;
    for (int k = 1; k <= d; ++k) {
        const Z next = c * at.c - s * at.s;
        s = s * at.c + c * at.s;
        c = next;
        sum += start.coefficient(i, k) * c + start.coefficient(i, -k) * s;
    }
    return sum;
}

/// The scales of the equations are 1, 2, ..
template <class M>
TotalDegreeSystem start_of(TotalDegreeKind kind, Generator& generator) {
    std::vector<double> scale;
    for (int i = 0; i < n_unknowns<M>; ++i) scale.push_back(1 + i);
    return {kind, Sizes<M>(), Formulation<M>::degrees, scale, generator};
}

/// Each G_i has as many roots as its degree asks for, all different, on the circle, and its largest coefficient is the
/// scale.
template <class M>
void check(TotalDegreeKind kind, std::uint64_t seed) {
    Generator generator(seed);
    const auto start = start_of<M>(kind, generator);
    CHECK(start.kind() == kind);
    for (int i = 0; i < n_unknowns<M>; ++i) {
        const int d = Formulation<M>::degrees[i];
        const bool angle = i < n_angles<M>;
        const auto& points = start.points(i);
        REQUIRE(points.size() == static_cast<std::size_t>(angle ? 2 * d : d));
        double largest = 0;
        for (int code = angle ? -d : 0; code <= d; ++code)
            largest = std::max(largest, std::abs(start.coefficient(i, code)));
        CHECK(largest == Approx(1 + i));
        for (std::size_t k = 0; k < points.size(); ++k) {
            CHECK(std::abs(value<M>(start, i, points[k])) < 1e-13 * largest * 100);
            if (angle) CHECK(std::abs(points[k].c * points[k].c + points[k].s * points[k].s - 1.0) < 1e-14);
            for (std::size_t l = 0; l < k; ++l)
                CHECK(std::abs(points[k].c - points[l].c) + std::abs(points[k].s - points[l].s) > 1e-3);
        }
    }
}

}  // namespace

TEST_CASE("the general start: random lines, whatever the degrees") {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        check<mechanisms::TwoLinkChain>(TotalDegreeKind::general, seed);
        check<models::Pendulum>(TotalDegreeKind::general, seed);
        check<models::ElasticPendulum>(TotalDegreeKind::general, seed);
        check<models::CoupledAngles<3>>(TotalDegreeKind::general, seed);
        check<models::Everything>(TotalDegreeKind::general, seed);
    }
}

TEST_CASE("the reflected start: odd, two points at rest, the others in mirror pairs") {
    using M = mechanisms::RotatingChain<3>;
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        check<M>(TotalDegreeKind::reflected, seed);
        Generator generator(seed);
        const auto start = start_of<M>(TotalDegreeKind::reflected, generator);
        for (int i = 0; i < 3; ++i) {
            for (int code = 0; code <= Formulation<M>::degrees[i]; ++code) CHECK(start.coefficient(i, code) == 0.0);
            const auto& points = start.points(i);
            CHECK(points[0].c == 1.0);
            CHECK(points[1].c == -1.0);
            CHECK(points[0].s == 0.0);
            CHECK(points[1].s == 0.0);
            for (std::size_t k = 2; k < points.size(); k += 2) {
                CHECK(points[k].c == points[k + 1].c);
                CHECK(points[k].s == -points[k + 1].s);
            }
        }
    }
}

TEST_CASE("the seed decides the start system") {
    using M = mechanisms::TwoLinkChain;
    const auto coefficient = [](std::uint64_t seed) {
        Generator generator(seed);
        return start_of<M>(TotalDegreeKind::general, generator).coefficient(0, 1);
    };
    CHECK(coefficient(1) == coefficient(1));
    CHECK(coefficient(1) != coefficient(2));
}

TEST_CASE("the seed decides the start system on every compiler") {
    // written down from one of them; an expression with two draws in it would differ
    using M = models::ElasticPendulum;
    Generator generator(42);
    const auto start = start_of<M>(TotalDegreeKind::general, generator);
    CHECK(std::abs(start.points(0)[0].c - Z(0.94795265051866728, -0.1064849070059869)) < 1e-12);
    CHECK(std::abs(start.points(1)[0].c - Z(-0.14184503536651899, 0.93849632466981214)) < 1e-12);
}

TEST_CASE("the number of paths is the total degree") {
    CHECK(total_degree<mechanisms::TwoLinkChain>() == 16);
    CHECK(total_degree<mechanisms::RotatingChain<5>>() == 1024);
    CHECK(total_degree<models::Pendulum>() == 2);
    CHECK(total_degree<models::ElasticPendulum>() == 4);
}
