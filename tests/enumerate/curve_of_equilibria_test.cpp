// Three equal angles with coupling 1 under the load 0.7: every point with exp(i a) + exp(i b) + exp(i c) = -0.7 is an
// equilibrium, a curve of them, and there are 8 isolated ones. The points of the curve must not pass for regular roots.
#include <complex>

#include "support/enumeration.hpp"

using namespace equilibria;

namespace {

struct ThreeEqualAngles {
    static constexpr int n_angles = 3;
    enum Parameter { coupling, load, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        scalar_of<decltype(theta)> v{};
        for (int i = 0; i < 3; ++i) {
            v -= p[load] * cos(theta[i]);
            for (int j = 0; j < i; ++j) v -= p[coupling] * cos(theta[i] - theta[j]);
        }
        return v;
    }
};

}  // namespace

TEST_CASE("a curve of equilibria is singular, its 8 isolated companions are not") {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        CAPTURE(seed);
        const auto r = enumerate<ThreeEqualAngles>({1, 0.7}, {.seed = seed});
        tests::check_accounts(r);
        CHECK(r.paths.finite == 8);
        CHECK_FALSE(r.clean());
        CHECK_FALSE(r.morse());
        CHECK(r.paths.singular > 0);
        CHECK(r.paths.failed <= 4);
        for (const auto& root : r.roots) {
            constexpr std::complex<double> i(0, 1);
            std::complex<double> sum = 0, inverse_sum = 0;
            for (const auto& q : root.q) sum += std::exp(i * q), inverse_sum += std::exp(-i * q);
            const bool on_curve = std::abs(sum + 0.7) + std::abs(inverse_sum + 0.7) < 1e-6;
            CHECK(on_curve == (root.status == PathStatus::singular));
        }
        std::uint64_t isolated = 0;
        for (const auto& e : r.equilibria) isolated += !e.degenerate();
        CHECK(isolated == 8);
    }
}
