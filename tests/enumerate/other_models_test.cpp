// Models that are no chains: equations without a potential, multiples of angles, a mechanism.
#include <numbers>

#include "support/enumeration.hpp"
#include "support/models.hpp"

using namespace equilibria;
using std::numbers::pi;
using tests::check_accounts;

namespace {

/// V = cos 3 theta - load cos theta: harmonics of one angle.
struct ThreeWells {
    static constexpr int n_angles = 1;
    enum Parameter { load, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        return cos(3 * theta[0]) - p[load] * cos(theta[0]);
    }
};

}  // namespace

TEST_CASE("a pendulum under a torque: equations without a potential") {
    for (const double torque : {-0.9, 0.0, 0.3, 0.5}) {
        const auto r = enumerate<models::Pendulum>({torque});
        check_accounts(r);
        CHECK(r.paths.total == 2);
        REQUIRE(r.real() == 2);
        CHECK(r.clean());
        // F' = cos theta: positive at arcsin, negative at pi - arcsin
        CHECK(r.equilibria[0].q[0] == Approx(std::asin(torque)).margin(1e-14));
        CHECK(r.equilibria[0].index == 0);
        CHECK(std::abs(wrap(r.equilibria[1].q[0] - (pi - std::asin(torque)))) < 1e-14);
        CHECK(r.equilibria[1].index == 1);
        CHECK(std::isnan(r.equilibria[0].energy));
        CHECK_FALSE(r.morse_applies());
    }
    const auto none = enumerate<models::Pendulum>({1.5});
    CHECK(none.real() == 0);
    CHECK(none.distinct() == 2);
    // sin theta = 3/2 at pi/2 +- i arcosh(3/2)
    for (const auto& root : none.roots) {
        CHECK(root.q[0].real() == Approx(pi / 2));
        CHECK(std::abs(root.q[0].imag()) == Approx(std::acosh(1.5)));
    }
    const auto fold = enumerate<models::Pendulum>({1});
    CHECK(fold.paths.singular == 2);
    CHECK_FALSE(fold.clean());
    REQUIRE(fold.real() == 1);
    CHECK(fold.equilibria[0].degenerate());
    CHECK(fold.equilibria[0].multiplicity == 2);
    CHECK(std::abs(fold.equilibria[0].q[0] - pi / 2) < 1e-6);
}

TEST_CASE("harmonics of one angle") {
    const auto r = enumerate<ThreeWells>({0.5});
    check_accounts(r);
    CHECK(r.paths.total == 6);
    CHECK(r.clean());
    CHECK(r.real() == 6);
    CHECK(r.by_index() == std::vector<std::int64_t>{3, 3});
    CHECK(r.morse());
    const auto gone = enumerate<ThreeWells>({20});
    CHECK(gone.real() == 2);
    CHECK(gone.clean());
    // V'' = -+9 +- load at 0 and pi: two pitchforks at once
    const auto fork = enumerate<ThreeWells>({9});
    CHECK_FALSE(fork.clean());
    CHECK(fork.degenerate() == 2);
    CHECK(fork.real() == 2);
}

TEST_CASE("the holonomic mechanism at 100 N: four equilibria of six roots") {
    using M = models::TwoAngleMechanism;
    const auto p = M::paper_parameters(100);
    const auto r = enumerate<M>(p);
    check_accounts(r);
    CHECK(r.paths.total == 16);
    CHECK(r.distinct() == 6);
    CHECK(r.paths.at_infinity == 10);
    CHECK(r.clean());
    CHECK(r.morse());
    const double expected[4][3] = {{1.46544020854, -0.25630918245, 0},
                                   {0.779776976161, -2.95917510938, 1},
                                   {-1.42175799139, -2.54488196512, 1},
                                   {-2.356470734, 1.38609618224, 2}};
    REQUIRE(r.real() == 4);
    for (const auto& [q1, q2, index] : expected) {
        const auto found =
            std::count_if(r.equilibria.begin(), r.equilibria.end(), [&, a = q1, b = q2, k = index](const auto& e) {
                return std::abs(e.q[0] - a) < 1e-9 && std::abs(e.q[1] - b) < 1e-10 && e.index == static_cast<int>(k);
            });
        CHECK(found == 1);
    }
}
