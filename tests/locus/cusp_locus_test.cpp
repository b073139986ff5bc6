// The curve of cusps of the rotating chain, found from planes that are solved for all their cusps.
#include <algorithm>
#include <cmath>
#include <string>

#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/locus/space/cusp_locus.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

using Chain = mechanisms::TwoLinkChain;

CuspLocus<Chain> find(const Box& box, const CuspLocusOptions& options = {}, MoreDigits<> resort = nullptr) {
    return find_cusp_locus<Chain, Chain::alpha, Chain::omega, Chain::ratio>({0.5, 1.5, 1}, box, {}, options, resort);
}

void check_beak_to_beak(const CuspCurve<Chain>& curve) {
    REQUIRE(curve.transitions.size() == 1);
    const auto& t = curve.transitions[0];
    CHECK(std::string(to_string(t.at.kind)) == "beak-to-beak");
    CHECK(std::abs(t.at.x() - 1. / 16) < 1e-12);
    CHECK(std::abs(std::pow(t.at.y(), 4) - 243. / 125) < 1e-12);
    CHECK(std::abs(t.at.z() - 16. / 9) < 1e-12);
    CHECK(t.at.residual < 1e-14);
}

/// What is said agrees with itself.
void check_complete(const CuspLocus<Chain>& locus) {
    CHECK(locus.complete());
    CHECK(locus.argument().find("NOT COMPLETE") == std::string::npos);
    std::uint64_t cusps = 0;
    for (const auto& plane : locus.planes) {
        CHECK(plane.counts.paths.failed == 0);
        CHECK(plane.counts.solutions == 44);
        cusps += plane.cusps.size();
        for (const auto& cusp : plane.cusps) {
            const Parameters<Chain> p{cusp.x(), plane.z, cusp.y()};
            const auto at =
                refine_singularity<Chain, SingularityKind::cusp, Chain::alpha, Chain::omega>(cusp.q, p, cusp.v);
            CHECK(at.settled());
            // next to a face all derivatives are as small as alpha
            CHECK((at.kind == SingularityKind::cusp || at.x() < 1e-6));
            CHECK(std::abs(at.derivative(4)) > 1e-3 * at.x());
            CHECK(at.residual < 1e-13);
        }
    }
    CHECK(locus.evidence.cusps == cusps);
    CHECK(locus.evidence.crossings == cusps);
}

}  // namespace

TEST_CASE("two cusps at ratio 1.5, none at 2.2: one curve, which turns back in a beak-to-beak") {
    const auto locus = find({{0, 1}, {0, 20}, {1.5, 2.2}}, {.planes = 3});
    check_complete(locus);
    REQUIRE(locus.planes.size() == 3);
    const auto &first = locus.planes[0], &last = locus.planes[2];
    CHECK(first.z == 1.5);
    CHECK(last.z == 2.2);
    CHECK(locus.evidence.beyond[0] == 0);
    CHECK(locus.evidence.beyond[1] == 0);
    CHECK(last.cusps.empty());
    REQUIRE(first.cusps.size() == 2);
    double alpha[] = {first.cusps[0].x(), first.cusps[1].x()};
    std::sort(alpha, alpha + 2);
    CHECK(std::abs(alpha[0] - 0.00343715692193062) < 1e-12);
    CHECK(std::abs(alpha[1] - 0.329896176411403) < 1e-12);

    REQUIRE(locus.curves.size() == 1);
    const auto& curve = locus.curves[0];
    for (const auto end : curve.ends) CHECK(end == CurveEnd::border);
    CHECK(curve.points.front().z() == 1.5);
    CHECK(curve.points.back().z() == 1.5);
    check_beak_to_beak(curve);
}

TEST_CASE("at ratio 1, where the chain is degenerate, the plane is given up for one next to it") {
    const auto locus = find({{0, 1}, {0, 20}, {1, 3}}, {.planes = 2}, more_digits);
    check_complete(locus);
    REQUIRE(locus.planes.size() == 2);
    const auto &first = locus.planes[0], &last = locus.planes[1];
    CHECK(first.z > 1);
    CHECK(first.z < 1.01);
    CHECK(locus.evidence.beyond[0] == Approx((first.z - 1) / 2));
    REQUIRE(!first.given_up.empty());
    CHECK(first.given_up[0].z == 1);
    CHECK(first.given_up[0].solutions < 22);
    CHECK(first.cusps.size() == 1);
    CHECK(first.outside > 0);     // the other cusp's omega is above 20
    CHECK(first.degenerate > 0);  // at alpha = 0 the second link has no mass
    CHECK(last.z == 3);
    CHECK(last.cusps.empty());
    CHECK(locus.argument().find("the plane at 1 was given up") != std::string::npos);

    REQUIRE(locus.curves.size() == 1);
    const auto& curve = locus.curves[0];
    const bool reversed = curve.ends[0] == CurveEnd::border;
    CHECK(curve.ends[reversed ? 0 : 1] == CurveEnd::border);
    CHECK(curve.ends[reversed ? 1 : 0] == CurveEnd::degenerate);
    CHECK((reversed ? curve.points.front() : curve.points.back()).y() == 20);
    check_beak_to_beak(curve);
}

TEST_CASE("next to ratio 1 more digits leave no path undecided, and lose no solution") {
    // where solutions come together
    const auto locus = find({{0, 1}, {0, 20}, {1.015, 1.05}}, {.planes = 3}, more_digits);
    CHECK(locus.complete());
    REQUIRE(locus.planes.size() == 3);
    for (const auto& plane : locus.planes) {
        CHECK(plane.given_up.empty());
        CHECK(plane.counts.paths.failed == 0);
        CHECK(plane.counts.paths.singular == 0);
        CHECK(plane.counts.solutions == 44);
    }
}

TEST_CASE("next to ratio 1 a cusp as close to the face alpha = 0 as 1e-11 is found, and is on the curve") {
    const auto locus = find({{0, 1}, {0, 20}, {1.005, 1.02}}, {.planes = 3}, more_digits);
    check_complete(locus);
    REQUIRE(locus.curves.size() == 1);
    for (const auto end : locus.curves[0].ends) CHECK(end == CurveEnd::border);
    for (const auto& plane : locus.planes) {
        REQUIRE(plane.cusps.size() == 1);
        // alpha goes to 0 as the fourth power of ratio - 1
        const double power = std::pow(plane.z - 1, 4), x = plane.cusps[0].x();
        CHECK(x > 0.04 * power);
        CHECK(x < 0.08 * power);
    }
}

TEST_CASE("bad boxes, parameters and options are refused") {
    CHECK_THROWS_AS(find({{0, 1}, {0, 20}, {2, 2}}), InvalidArgument);
    CHECK_THROWS_AS(find({{1, 0}, {0, 20}, {1, 3}}), InvalidArgument);
    CHECK_THROWS_AS(find({{0, 1}, {0, INFINITY}, {1, 3}}), InvalidArgument);
    CHECK_THROWS_AS(find({{0, 1}, {NAN, 20}, {1, 3}}), InvalidArgument);
    CHECK_THROWS_AS(find({{0, 1}, {0, 20}, {1, 3}}, {.planes = 1}), InvalidArgument);
    CHECK_THROWS_AS(
        (find_cusp_locus<Chain, Chain::alpha, Chain::omega, Chain::ratio>({0.5, NAN, 1}, {{0, 1}, {0, 20}, {1, 3}})),
        InvalidArgument);
}
