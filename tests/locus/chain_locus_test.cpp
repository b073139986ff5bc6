// Figure 3.2 of Baillieul, "Parametric dependence in the equilibrium dynamics of rotating structures": the locus of
// the two-link chain, against the model's closed form and its own laws.
#include <algorithm>
#include <cmath>
#include <equilibria/core/taylor.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/locus/proof/prove_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>
#include <map>
#include <vector>

#include "support/catch.hpp"

using namespace equilibria;
using Chain = mechanisms::TwoLinkChain;

namespace {

const Locus<Chain>& figure() {
    static const auto locus = trace_locus<Chain, Chain::alpha, Chain::omega>({0.5, 1.5, 1}, {{0, 1}, {0, 5}});
    return locus;
}

/// The cusp of the model's own closed form. Off the symmetric branches the second equation says
/// sin theta_1 = k sin theta_2 with k = 1 / (W cos theta_2) - r, W = omega^2, and the first one then
/// alpha = k (1 / (W cos theta_1) - 1) / r: a function of theta_2 whose first two derivatives vanish at a cusp.
/// Newton's method in theta_2 and W, from about the cusp with cos theta_1 > 0; none of the library's equations is used.
struct ClosedFormCusp {
    using Series = Taylor<long double, 3>;
    long double alpha = 0, omega = 0, third = 0;

    static Series alpha_along(long double ratio, long double theta_2, long double square) {
        const Series theta = Series::variable(theta_2);
        const Series k = Series(1.0L) / (square * cos(theta)) - Series(ratio), sine = k * sin(theta);
        const Series cosine = sqrt(Series(1.0L) - sine * sine);
        return k * (Series(1.0L) / (square * cosine) - Series(1.0L)) / ratio;
    }
    ClosedFormCusp(long double ratio, long double theta_2, long double omega_near) {
        long double square = omega_near * omega_near;
        for (int step = 0; step < 20; ++step) {
            const auto a = alpha_along(ratio, theta_2, square).coefficient;
            const long double h = 1e-7L * square;
            const auto high = alpha_along(ratio, theta_2, square + h).coefficient,
                       low = alpha_along(ratio, theta_2, square - h).coefficient;
            // [ 2 a_2  d a_1 / dW ]
            // [ 3 a_3  d a_2 / dW ]
            const long double by_w[] = {(high[1] - low[1]) / (2 * h), (high[2] - low[2]) / (2 * h)};
            const long double determinant = 2 * a[2] * by_w[1] - 3 * a[3] * by_w[0];
            theta_2 -= (by_w[1] * a[1] - by_w[0] * a[2]) / determinant;
            square -= (2 * a[2] * a[2] - 3 * a[3] * a[1]) / determinant;
        }
        const auto a = alpha_along(ratio, theta_2, square).coefficient;
        alpha = a[0], omega = std::sqrt(square), third = 6 * a[3];
    }
};

}  // namespace

// One process traces the figure for all of them.
TEST_CASE("Figure 3.2") {
    SECTION("Everything on the lines is explained by the curves, and every count by its region") {
        const auto& e = figure().evidence;
        CHECK(e.complete());
        CHECK(e.lines == 28);
        CHECK(e.checked_points > 300);
        CHECK(e.seconds < 100);  // a hang, not a timing
    }

    SECTION("The cusp of Figure 3.2 and the one beside alpha = 0, to 12 digits, and no other") {
        const auto cusps = figure().of(SingularityKind::cusp);
        REQUIRE(cusps.size() == 2);
        const auto right = cusps[0].x() > 0.1 ? 0u : 1u;
        const auto &cusp = cusps[right], &small = cusps[1 - right];
        CHECK(std::abs(cusp.x() - 0.32989617641140) < 1e-12);
        CHECK(std::abs(cusp.y() - 1.93791347451593) < 2e-12);
        CHECK(std::abs(cusp.derivative(4)) > 1);
        CHECK(std::abs(small.x() - 0.003437156922) < 1e-11);
        for (const auto& c : cusps) {
            CHECK(c.residual < 1e-12);
            const ClosedFormCusp closed(1.5L, c.q[1], c.y());
            CHECK(std::abs(closed.alpha - c.x()) < 1e-13);
            CHECK(std::abs(closed.omega - c.y()) < 1e-12);
            CHECK(std::abs(closed.third) > 1e-3);
        }
        CHECK(figure().evidence.solved.at(SingularityKind::cusp).solutions == 44);
    }

    SECTION("The argument says what was solved for") {
        const std::string argument = figure().argument();
        CHECK(argument.find("cusps: 224 paths, 44 regular complex solutions, 0 failed") != std::string::npos);
        CHECK(argument.find("NOT COMPLETE") == std::string::npos);
    }

    SECTION("Four pitchfork curves and two fold curves, each point a degenerate equilibrium") {
        int folds = 0, pitchforks = 0;
        for (const auto& curve : figure().curves) {
            ++(curve.kind == SingularityKind::fold ? folds : pitchforks);
            for (std::size_t k = 1; k + 1 < curve.points.size(); ++k) {
                const auto& at = curve.points[k];
                const Parameters<Chain> p{at.x(), 1.5, at.y()};
                double residual = 0;
                for (const double f : equations<Chain, double>(at.q, p)) residual = std::max(residual, std::abs(f));
                REQUIRE(residual < 1e-10);
                const auto j = jacobian<Chain, double>(at.q, p);
                REQUIRE(std::hypot(j(0, 0) * at.v[0] + j(0, 1) * at.v[1], j(1, 0) * at.v[0] + j(1, 1) * at.v[1]) <
                        1e-10);
            }
        }
        CHECK(folds == 2);
        CHECK(pitchforks == 4);
    }

    SECTION("The fold curve has its vertical tangent at alpha = 1/3, omega = 2, and that is no cusp") {
        const auto extremal = figure().of(SingularityKind::extremal_fold, SingularityKind::extremal_pitchfork);
        REQUIRE(extremal.size() == 1);
        CHECK(extremal[0].kind == SingularityKind::extremal_fold);
        CHECK(extremal[0].extremal == Chain::alpha);
        CHECK(std::abs(extremal[0].x() - 1. / 3) < 1e-12);
        CHECK(std::abs(extremal[0].y() - 2) < 1e-10);
        double nearest = 1, largest_alpha = 0;
        for (const auto& curve : figure().curves) {
            if (curve.kind != SingularityKind::fold) continue;
            for (std::size_t k = 1; k + 1 < curve.points.size(); ++k) {
                nearest = std::min(nearest, std::hypot(curve.points[k].x() - 1. / 3, curve.points[k].y() - 2));
                if (curve.points[k].y() > 1.96 && curve.points[k].y() < 2.3) {
                    const auto& p = curve.points;
                    if (p[k].x() > p[k - 1].x() && p[k].x() > p[k + 1].x()) largest_alpha = p[k].x();
                }
            }
        }
        CHECK(nearest < 0.01);
        CHECK(largest_alpha == Approx(1. / 3).margin(1e-4));
    }

    SECTION("Seven regions with the tables of Figure 3.3, those of 16 equilibria twice") {
        const std::map<std::uint64_t, std::vector<std::int64_t>> tables{
            {4, {1, 2, 1}}, {6, {2, 3, 1}}, {8, {2, 4, 2}}, {10, {2, 5, 3}}, {12, {2, 6, 4}}, {16, {4, 8, 4}}};
        std::map<std::uint64_t, std::vector<std::int64_t>> found;
        double area = 0;
        for (const auto& r : figure().regions) {
            CHECK(r.clean);
            CHECK(r.confirmed);
            found[r.count] = r.by_index;
            area += r.area;
        }
        CHECK(figure().regions.size() == 7);
        CHECK(found == tables);
        CHECK(area == Approx(5).epsilon(1e-4));
    }

    SECTION(
        "Across a fold curve a pair and its mirror image appear, across a pitchfork curve a pair less a change of "
        "index") {
        CHECK(figure().evidence.wrong_borders == 0);
        REQUIRE(figure().borders.size() >= 8);
        for (const auto& border : figure().borders) {
            const auto &a = figure().regions[static_cast<std::size_t>(border.below)],
                       &b = figure().regions[static_cast<std::size_t>(border.above)];
            const std::int64_t each = figure().curves[border.curve].kind == SingularityKind::fold ? 2 : 1;
            const std::int64_t born = b.count > a.count ? each : -each;
            int changed = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t d = b.by_index[k] - a.by_index[k];
                CHECK((d == 0 || d == born));
                changed += d != 0;
            }
            CHECK(changed == 2);
            CHECK(a.by_index[1] != b.by_index[1]);  // neighbouring indices
        }
    }

    SECTION("Another window and another seed give the same cusp") {
        const LocusOptions options{.lines = 5, .checks = 8};
        const auto locus = trace_locus<Chain, Chain::alpha, Chain::omega>({0.5, 1.5, 1}, {{0.3, 0.36}, {1.8, 2.2}},
                                                                          {.seed = 12345}, options);
        CHECK(locus.evidence.complete());
        const auto cusps = locus.of(SingularityKind::cusp), before = figure().of(SingularityKind::cusp);
        REQUIRE(cusps.size() == 1);
        CHECK(std::abs(cusps[0].x() - before[0].x()) < 1e-12);
        CHECK(std::abs(cusps[0].y() - before[0].y()) < 1e-11);
    }

    SECTION("Certificates confirm curves, cusps and regions, and notice what was moved") {
        auto locus = figure();
        const auto proof = prove_locus<Chain, Chain::alpha, Chain::omega>(locus);
        CAPTURE(proof);
        CHECK(proof.cusps.proved == 2);
        CHECK(proof.extremal.proved == 1);
        CHECK(proof.regions.proved == 7);
        // not proved: points on the window's border, where the model may degenerate
        CHECK(proof.folds.of - proof.folds.proved <= 4);
        CHECK(proof.pitchforks.of - proof.pitchforks.proved <= 8);
        CHECK(proof.folds.of > 200);
        CHECK(proof.largest_radius < 1e-12);

        std::erase_if(locus.regions, [](const auto& region) { return region.count != 4; });
        REQUIRE(locus.regions.size() == 1);
        ++locus.regions[0].by_index[0];
        std::ranges::find(locus.points, SingularityKind::cusp, &Singularity<Chain>::kind)->q[0] += 0.1;
        for (auto& curve : locus.curves) {
            curve.points.resize(20);
            for (std::size_t k = 8; k < 12; ++k) curve.points[k].x() += 1e-6;
        }
        const auto moved = prove_locus<Chain, Chain::alpha, Chain::omega>(locus);
        CAPTURE(moved);
        CHECK(moved.regions.proved == 0);
        CHECK(moved.cusps.proved == 1);
        // the fold across a point that is off is proved, and how far off the point is
        CHECK(moved.largest_radius > 1e-7);
        CHECK(moved.largest_radius < 1e-4);
    }
}

TEST_CASE("A window that is empty or reversed is refused") {
    CHECK_THROWS_AS((trace_locus<Chain, Chain::alpha, Chain::omega>({0.5, 1.5, 1}, {{1, 0}, {0, 5}})), InvalidArgument);
    CHECK_THROWS_AS((trace_locus<Chain, Chain::alpha, Chain::omega>({0.5, 1.5, 1}, {{0, 1}, {5, 5}})), InvalidArgument);
}
