// Reduced coefficients and line events on models whose bifurcations are known in closed form.
#include <cmath>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/null_vector.hpp>
#include <equilibria/singularity/reduced_coefficients.hpp>
#include <equilibria/system/symmetric_branches.hpp>
#include <vector>

#include "support/catch.hpp"

using namespace equilibria;

TEST_CASE("Polynomial roots by Chebyshev interpolation, also where the degree is only a bound") {
    const auto roots = polynomial_roots([](double x) { return (x - 0.25) * (x - 1) * (x - 3.5) * (x - 7); }, 9, 0, 5);
    REQUIRE(roots.size() == 3);
    CHECK(roots[0] == Approx(0.25).margin(1e-12));
    CHECK(roots[1] == Approx(1).margin(1e-12));
    CHECK(roots[2] == Approx(3.5).margin(1e-12));
    CHECK(polynomial_roots([](double) { return 2.0; }, 3, 0, 1).empty());
}

/// The figures were computed independently: interval branch and bound, multiprecision.
TEST_CASE("Folds and pitchforks of the two-link chain on lines alpha = const") {
    using Chain = mechanisms::TwoLinkChain;
    struct Line {
        double alpha, pitchforks[4], fold;
    };
    for (const Line& line :
         {Line{.1, {.76450069744675, .83377163246986, 1.0322526364616, 1.1257844089591}, 2.3179684357649},
          Line{.4, {.6960675016716, .90127739195077, 1.1695539717331, 1.5143539252415}, 2.4293853881739},
          Line{.6, {.66948880558549, .96948528423161, 1.3316287206556, 1.9283286560808}, 7.4951235452437},
          Line{.7, {.65870047908076, 1.0175035388023, 1.4650681085145, 2.2631105219176}, 0}}) {
        const auto found = find_events<Chain, Chain::omega>({line.alpha, 1.5, 1}, {0, 8});
        CHECK(found.complete());
        int folds = 0;
        std::vector<double> pitchforks;
        for (const auto& e : found.events) {
            CHECK(e.residual < 1e-12);
            CHECK(e.correction < 1e-12);
            if (e.kind == CriticalKind::fold) {
                ++folds;
                CHECK(e.value == Approx(line.fold).epsilon(1e-12));
                CHECK(std::abs(e.reduced.third) > 1e-3);
            } else {
                CHECK(e.kind == CriticalKind::pitchfork);
                pitchforks.push_back(e.value);
                CHECK(std::abs(e.reduced.third) < 1e-12);  // v is odd
                CHECK(std::abs(e.reduced.fourth) > 1e-3);
            }
        }
        CHECK(folds == (line.fold > 0 ? 2 : 0));  // and its mirror image
        REQUIRE(pitchforks.size() == 4);
        for (std::size_t k = 0; k < 4; ++k) CHECK(pitchforks[k] == Approx(line.pitchforks[k]).epsilon(1e-12));
        // a pitchfork adds two equilibria, a fold and its mirror image four
        CHECK(found.intervals.back().count == 4u + 2 * 4 + 2 * static_cast<unsigned>(folds));
        CHECK(found.paths.total == 48);  // the mixed volume
        CHECK(found.start == "polyhedral");
        CHECK(found.pitchfork_paths == 24);
    }
}

TEST_CASE("Reduced coefficients agree with the energy along the centre manifold, by finite differences") {
    using Chain = mechanisms::TwoLinkChain;
    const Parameters<Chain> p{0.4, 1.5, .6960675016716};  // pitchfork of (0, 0)
    const Unknowns<Chain> q{0, 0};
    const auto j = jacobian<Chain, double>(q, p);
    const auto v = null_vector<Chain>(j);
    const auto reduced = reduced_coefficients<Chain>(q, v, p);
    // minimise V over the direction orthogonal to v at distance a along v
    const auto energy = [&](double a) {
        double b = 0;
        const auto at = [&](double s) { return Unknowns<Chain>{a * v[0] - s * v[1], a * v[1] + s * v[0]}; };
        for (int k = 0; k < 20; ++k) {
            const auto f = equations<Chain, double>(at(b), p);
            const auto h = jacobian<Chain, double>(at(b), p);
            const double slope = -f[0] * v[1] + f[1] * v[0];
            const double curvature = h(0, 0) * v[1] * v[1] - 2 * h(0, 1) * v[0] * v[1] + h(1, 1) * v[0] * v[0];
            b -= slope / curvature;
        }
        return potential<Chain, double>(at(b), p);
    };
    const double a = 0.05, e0 = energy(0), e1 = energy(a) - e0, e2 = energy(2 * a) - e0;
    // V = fourth a^4 / 24 + O(a^6): eliminate the sixth order
    const double fourth = 24 * (64 * e1 - e2) / (48 * a * a * a * a);
    CHECK(fourth == Approx(reduced.fourth).epsilon(1e-4));
}
