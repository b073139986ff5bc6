// Equal coupled angles: every point with sum exp(i theta_j) = -load/k is an equilibrium. Such families must be called
// curves and surfaces, and no point of them a root; the isolated roots beside them must be called isolated.
#include <array>
#include <complex>
#include <sstream>

#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;

namespace {

using Complex = std::complex<double>;

/// x^3 = 0, 1e-4 y = 1: a triple solution 1e4 out.
struct FarTriple {
    static constexpr int n_angles = 0, n_coordinates = 2;
    enum Parameter { unused, n_parameters };
    constexpr auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{pow(x[0], 3) + 0.0 * p[unused], 1e-4 * x[1] - 1.0};
    }
};

template <int N>
double off_family(const Array<Complex, N>& q, double load) {
    Complex sum = 0, inverse_sum = 0;
    for (const auto& angle : q) sum += std::exp(Complex(0, 1) * angle), inverse_sum += std::exp(-Complex(0, 1) * angle);
    return std::abs(sum + load) + std::abs(inverse_sum + load);
}

template <class M>
std::string printed(const RootSet<M>& r) {
    std::ostringstream out;
    out << r;
    return out.str();
}

/// 2^N isolated roots, all real, and one family of dimension N - 2.
template <int N>
void check(const RootSet<models::EqualAngles<N>>& r, double load, bool real) {
    CAPTURE(load, r.seed);
    tests::check_accounts(r);
    CHECK(r.paths.finite == 1u << N);
    CHECK(r.distinct() == 1u << N);
    CHECK(r.real() == 1u << N);
    CHECK(r.degenerate() == 0);
    std::int64_t counted = 0;
    for (const auto count : r.by_index()) counted += count;
    CHECK(counted == 1 << N);
    CHECK_FALSE(r.clean());
    CHECK_FALSE(r.morse_applies());
    for (const auto& root : r.roots) {
        CHECK(root.status == PathStatus::finite);
        CHECK(off_family<N>(root.q, load) > 1e-3);
        for (const auto& angle : root.q) CHECK(std::abs(std::sin(angle)) < 1e-12);
    }
    REQUIRE(r.families.size() == 1);
    const auto& family = r.families[0];
    CHECK(family.dimension == N - 2);
    CHECK(family.paths() == r.paths.singular);
    CHECK(family.real() == real);
    if (family.real()) {
        Array<Complex, N> q;
        for (int i = 0; i < N; ++i) q[i] = (*family.real_point)[i];
        CHECK(off_family<N>(q, load) < 1e-11);
    }
    for (const auto& point : family.points) {
        CHECK(off_family<N>(point.q, load) < 1e-5);
        CHECK(off_family<N>(point.neighbour, load) < 1e-10);
        CHECK(point.distance > 0.01);
        CHECK(point.residual < 1e-12);
        CHECK(point.condition > 1e5);
        CHECK(point.nullity == N - 2);
        REQUIRE(point.tangent.size() == N - 2);
        for (const auto& t : point.tangent) {
            // d sum exp(i theta_j) = 0 along the family
            Complex slope = 0;
            double length = 0, size = 1;
            for (int i = 0; i < N; ++i) {
                const Complex z = std::exp(Complex(0, 1) * point.q[i]);
                slope += z * t[i];
                length += std::norm(t[i]);
                size += std::abs(z);
            }
            CHECK(length == Approx(1));
            CHECK(std::abs(slope) < 1e-4 * size);
        }
    }
    const std::string kind = real ? "a real " + family_kind(N - 2) : "a " + family_kind(N - 2);
    CHECK(printed(r).find("NOT ISOLATED: " + kind + " of solutions") != std::string::npos);
    CHECK(printed(r).find("SINGULAR") == std::string::npos);
}

}  // namespace

TEST_CASE("a curve of equilibria is a curve, its 8 isolated companions are isolated") {
    for (std::uint64_t seed = 1; seed <= 2 * tests::thoroughness; ++seed) {
        const auto r = enumerate<models::EqualAngles<3>>({1, 0.7}, {.seed = seed});
        check<3>(r, 0.7, true);
        CHECK(r.paths.failed == 0);
    }
}

TEST_CASE("a curve without real points is a curve too, and is not called real") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const auto r = enumerate<models::EqualAngles<3>>({1, 3.5}, {.seed = seed});
        check<3>(r, 3.5, false);
    }
}

TEST_CASE("a family is the same for any number of threads") {
    const auto one = enumerate<models::EqualAngles<3>>({1, 0.7}, {.executor = threads(1)});
    CHECK(tests::identical(one, enumerate<models::EqualAngles<3>>({1, 0.7}, {.executor = threads(3)})));
}

TEST_CASE("a surface of equilibria, real and not") {
    check<4>(enumerate<models::EqualAngles<4>>({1, 0.7}), 0.7, true);
    check<4>(enumerate<models::EqualAngles<4>>({1, 5}), 5, false);
}

TEST_CASE("without loads each equilibrium can be turned as a whole: six curves, nothing isolated") {
    using M = models::CoupledAngles<3>;
    Generator generator(3);
    for (int k = 0; k < tests::thoroughness / 2 + 1; ++k) {
        CAPTURE(k);
        Parameters<M> p{};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < i; ++j) p[3 * i + j] = p[3 * j + i] = uniform(generator, 0.3, 1.3);
        const auto r = enumerate<M>(p);
        tests::check_accounts(r);
        CHECK(r.distinct() == 0);
        CHECK(r.real() == 0);
        CHECK(r.paths.failed <= 1);
        CHECK(r.families.size() == 6);
        for (const auto& family : r.families) {
            CHECK(family.dimension == 1);
            for (const auto& point : family.points) {
                CHECK(point.nullity == 1);
                for (const auto& t : point.tangent[0]) CHECK(std::abs(t - point.tangent[0][0]) < 1e-6);
            }
        }
    }
}

TEST_CASE("no equilibria are a family where the parameters are generic") {
    Generator generator(5);
    for (int k = 0; k < 3; ++k) {
        Parameters<models::CoupledAngles<3>> p;
        for (double& x : p) x = uniform(generator, 0.3, 1.3);
        const auto r = enumerate<models::CoupledAngles<3>>(p);
        CHECK(r.families.empty());
        CHECK(r.clean());
    }
}

TEST_CASE("a multiple solution far out is no family") {
    const auto r = enumerate<FarTriple>({0});
    tests::check_accounts(r);
    CHECK(r.paths.singular == 3);
    CHECK(r.families.empty());
    CHECK(r.distinct() == 1);
}
