// Plain coordinates, beside angles and alone.
#include <numbers>

#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;
using std::numbers::pi;
using tests::check_accounts;

namespace {

/// A particle in the double well V = x^4/4 - a x^2/2 - b x: coordinates only.
struct DoubleWell {
    static constexpr int n_angles = 0, n_coordinates = 1;
    enum Parameter { a, b, n_parameters };
    constexpr auto potential(const auto&, const auto& x, const auto& p) const {
        return 0.25 * pow(x[0], 4) - 0.5 * p[a] * x[0] * x[0] - p[b] * x[0];
    }
};

}  // namespace

TEST_CASE("an elastic pendulum: an angle and a coordinate") {
    // dV/dx = k (x - 1) - g cos theta, dV/dtheta = g x sin theta: sin theta = 0, x = 1 +- g/k; or x = 0, cos theta =
    // -k/g
    const double k = 3, g = 1;
    const auto r = enumerate<models::ElasticPendulum>({k, g});
    check_accounts(r);
    CHECK(r.paths.failed == 0);
    CHECK(r.paths.singular == 0);
    CHECK(r.distinct() == 4);
    REQUIRE(r.real() == 2);
    CHECK(r.equilibria[0].q[0] == Approx(0).margin(1e-14));
    CHECK(r.equilibria[0].q[1] == Approx(1 + g / k));
    CHECK(r.equilibria[0].index == 0);
    CHECK(std::abs(r.equilibria[1].q[0]) == Approx(pi));
    CHECK(r.equilibria[1].q[1] == Approx(1 - g / k));
    CHECK(r.equilibria[1].index == 1);
    CHECK_FALSE(r.morse_applies());

    const auto soft = enumerate<models::ElasticPendulum>({0.5, 1});
    CHECK(soft.real() == 4);
    for (const auto& e : soft.equilibria)
        if (std::abs(std::sin(e.q[0])) > 1e-9) {
            CHECK(std::cos(e.q[0]) == Approx(-0.5));
            CHECK(e.q[1] == Approx(0).margin(1e-14));
        }
}

TEST_CASE("a double well: coordinates alone") {
    const auto r = enumerate<DoubleWell>({1, 0});
    check_accounts(r);
    CHECK(r.paths.total == 3);
    REQUIRE(r.real() == 3);
    CHECK(r.by_index() == std::vector<std::int64_t>{2, 1});
    for (const auto& e : r.equilibria) CHECK(e.q[0] * (e.q[0] * e.q[0] - 1) == Approx(0).margin(1e-14));
    // x^3 = b: one real root, two complex ones
    const auto one = enumerate<DoubleWell>({0, 8});
    CHECK(one.distinct() == 3);
    REQUIRE(one.real() == 1);
    CHECK(one.equilibria[0].q[0] == Approx(2));
    // the cusp x^3 = 0
    const auto cusp = enumerate<DoubleWell>({0, 0});
    CHECK(cusp.paths.singular == 3);
    REQUIRE(cusp.real() == 1);
    CHECK(cusp.equilibria[0].multiplicity == 3);
    CHECK_FALSE(cusp.clean());
    // far away and close to 0: -1e-10, +-1e5
    const auto far = enumerate<DoubleWell>({1e10, 1});
    CHECK(far.real() == 3);
    CHECK(far.clean());
}
