// A model that is not the chain, without the symmetry theta -> -theta: its locus has cusps known in closed form.
#include <algorithm>
#include <cmath>
#include <equilibria/locus/plane/trace_locus.hpp>

#include "support/catch.hpp"
#include "support/spring_loaded_double_pendulum.hpp"

using namespace equilibria;

TEST_CASE("The cusps of the spring-loaded double pendulum are its buckling loads without offset") {
    using Model = models::SpringLoadedDoublePendulum;
    const auto locus = trace_locus<Model, Model::offset, Model::stiffness>({1, 0}, {{-0.5, 0.5}, {0.5, 4}});
    CHECK(locus.evidence.complete());
    // det J = 0 at theta_1, theta_2 in {0, pi}: k^2 - 4 k + 2 = 0 at (0, 0); k^2 = 2 at (0, pi) and (pi, 0)
    std::vector<double> loads;
    for (const auto& cusp : locus.of(SingularityKind::cusp)) {
        CHECK(std::abs(cusp.x()) < 1e-12);
        CHECK(cusp.residual < 1e-12);
        CHECK(std::abs(cusp.derivative(4)) > 0.1);
        loads.push_back(cusp.y());
    }
    std::sort(loads.begin(), loads.end());
    REQUIRE(loads.size() == 4);
    const double expected[] = {2 - std::sqrt(2), std::sqrt(2), std::sqrt(2), 2 + std::sqrt(2)};
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(loads[k] - expected[k]) < 1e-12);

    // mirror images under offset -> -offset, theta -> -theta
    for (const auto& curve : locus.curves) {
        CHECK(curve.kind == SingularityKind::fold);
        const auto &a = curve.points.front(), &b = curve.points.back();
        CHECK(a.x() == Approx(-b.x()).margin(1e-9));
        CHECK(a.y() == Approx(b.y()).margin(1e-9));
    }
    // a fold changes the count by two, and Morse's sum stays 0 in each region
    for (const auto& region : locus.regions) {
        CHECK(region.clean);
        CHECK(region.confirmed);
        CHECK(region.by_index[0] - region.by_index[1] + region.by_index[2] == 0);
        CHECK(region.count % 2 == 0);
    }
}
