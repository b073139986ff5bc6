// What tells divergent paths: powers of 1-t diverge and grow, finite points do not, and poles of loops exclude radii.
#include <cmath>

#include <equilibria/homotopy/detail/divergence.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::detail;

namespace {

/// x_1 = (1-t)^-power where 1-t = r; x_2 stays.
RuntimePoint<double> at(double r, double power) {
    auto q = point_of_zeros<RuntimeUnknowns, double>({0, 2});
    q.x[0] = {std::pow(r, -power), 0};
    q.x[1] = {0.3, 0.4};
    return q;
}

}  // namespace

TEST_CASE("a path that goes out like a power of 1-t diverges, a finite one does not") {
    for (const double power : {0.25, 0.5, 1.0, 3.0}) {
        const Valuations nu{power, 0};
        const auto q = at(1e-9, power);
        CHECK(farthest(q) == 0);
        CHECK(is_far(q));
        CHECK(diverges(q, nu, nu));
        CHECK_FALSE(diverges(q, nu, {-1, -1}));                  // no second scale
        CHECK_FALSE(diverges(q, {0.5 * power, 0}, {power, 0}));  // the valuation falls: far, and finite
    }
    CHECK_FALSE(diverges(at(0.5, 1), {1, 0}, {1, 0}));  // not far yet
    // of two unknowns that are far out one has a valuation that changes
    auto both = at(1e-4, 1);
    both.x[1] = {1e3, 0};
    CHECK(diverges(both, {1, 0.9}, {1, 0.7}));
    CHECK_FALSE(diverges(both, {1, 0.9}, {1, 0.7}, true));
    CHECK(diverges(both, {1, 0.9}, {1, 0.9}, true));
    // a million times nearer its valuation is rounding
    auto unequal = at(1e-9, 1);
    unequal.x[1] = {500, 0};
    CHECK(diverges(unequal, {1, 0.9}, {1, 0.7}, true));
    CHECK_FALSE(is_far(at(1e-9, 0)));
    CHECK_FALSE(diverges(at(1e-9, 0), {0.5, 0.5}, {0.5, 0.5}));
}

TEST_CASE("growth between two radii is the valuation's") {
    const Valuations nu{1, 0};
    CHECK(grows(at(1e-6, 1), nu, at(1e-5, 1), nu));
    CHECK_FALSE(grows(at(1e-6, 1), {2, 0}, at(1e-5, 1), {2, 0}));  // grew by less
    CHECK_FALSE(grows(at(1e-3, 1), nu, at(1e-2, 1), nu));          // not very far out
    CHECK_FALSE(grows(at(1e-6, 1), {0.5, 0}, at(1e-5, 1), nu));    // the valuation falls
    auto now = at(1e-6, 1), back = at(1e-5, 1);
    now.x[1] = {1e3, 0}, back.x[1] = {1e2, 0};
    CHECK(grows(now, {1, 2}, back, {1, 2}));
    CHECK_FALSE(grows(now, {1, 2}, back, {1, 2}, true));
    CHECK(grows(now, {1, 1}, back, {1, 1}, true));
}

TEST_CASE("loops exclude finite points only where both show the same pole") {
    ClosedLoop<double> now, wider;
    now.winding = wider.winding = 2;
    now.pole = wider.pole = 1;
    now.beyond = 1e-3;
    CHECK(excluded_radius(now, 1e-4, wider) == Approx(1e-7));
    wider.pole = 2;
    CHECK(excluded_radius(now, 1e-4, wider) == 1);
    now.pole = wider.pole = 0;
    CHECK(excluded_radius(now, 1e-4, wider) == 1);
}
