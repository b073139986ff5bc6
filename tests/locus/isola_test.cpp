// Planted components of a locus that no line of the window meets: found by their extremal points and cusps.
#include <algorithm>
#include <cmath>
#include <equilibria/locus/plane/trace_locus.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// With u = sin(theta) and R = dx^2 + dy^2 - r^2 around (x_0, y_0):
/// circle = 1: V' = cos(theta) (u^2 + R), folds at theta = 0 and pi where R = 0;
/// lips = 1: V' = cos(theta) (u^3 + (dy^2 - r^2) u + k dx), a lens of folds with cusps at dx = 0, dy = +-r.
struct FoldIsola {
    static constexpr int n_angles = 1;
    enum Parameter { x, y, x_0, y_0, radius, circle, lips, slope, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto dx = p[x] - p[x_0], dy = p[y] - p[y_0];
        const auto inside = dy * dy - p[radius] * p[radius];
        const auto u = sin(theta[0]);
        return p[circle] * (u * u * u / 3 + (dx * dx + inside) * u) +
               p[lips] * (u * u * u * u / 4 + 0.5 * inside * u * u + p[slope] * dx * u);
    }
};

/// V' = sin(theta) (R + 1 - cos(theta)): pitchforks from theta = 0 where R = 0, a circle.
struct PitchforkCircle {
    static constexpr int n_angles = 1;
    enum Parameter { x, y, x_0, y_0, radius, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto dx = p[x] - p[x_0], dy = p[y] - p[y_0];
        const auto r = dx * dx + dy * dy - p[radius] * p[radius];
        return 0.5 * cos(theta[0]) * cos(theta[0]) - (r + 1) * cos(theta[0]);
    }
};

constexpr double x_0 = 0.4137, y_0 = 0.7321, radius = 3e-4;
const LocusOptions few{.lines = 3, .checks = 4};

template <class M>
void check_circle(const Locus<M>& locus, SingularityKind kind, std::size_t copies) {
    CAPTURE(locus.argument());
    CHECK(locus.evidence.complete());
    CHECK(locus.of(SingularityKind::cusp).empty());
    REQUIRE(locus.curves.size() == copies);
    for (const auto& curve : locus.curves) {
        CHECK(curve.kind == kind);
        CHECK(curve.ends[0] == CurveEnd::closed);
        CHECK(curve.points.size() > 20);
        for (const auto& at : curve.points)
            CHECK(std::hypot(at.x() - x_0, at.y() - y_0) == Approx(radius).margin(1e-12));
    }
    const auto extremal = locus.of(SingularityKind::extremal_fold, SingularityKind::extremal_pitchfork);
    REQUIRE(extremal.size() == 4 * copies);
    for (const auto& point : extremal) {
        CHECK(curve_of(point.kind) == kind);
        const double along = point.extremal == M::x ? point.x() - x_0 : point.y() - y_0;
        const double across = point.extremal == M::x ? point.y() - y_0 : point.x() - x_0;
        CHECK(std::abs(along) == Approx(radius).margin(1e-12));
        CHECK(std::abs(across) < 1e-10);
    }
    CHECK(locus.regions.size() == 2);
}

}  // namespace

TEST_CASE("a circle of folds, 3e-4 of the window in radius, is found and traced") {
    const auto locus = trace_locus<FoldIsola, FoldIsola::x, FoldIsola::y>({0, 0, x_0, y_0, radius, 1, 0, 0},
                                                                          {{0, 1}, {0, 1}}, {}, few);
    check_circle(locus, SingularityKind::fold, 2);  // theta = 0 and theta = pi
    for (const auto& region : locus.regions) CHECK(region.count == (region.area < 1e-3 ? 6 : 2));
}

TEST_CASE("a circle of pitchforks, 3e-4 of the window in radius, is found and traced") {
    const auto locus = trace_locus<PitchforkCircle, PitchforkCircle::x, PitchforkCircle::y>({0, 0, x_0, y_0, radius},
                                                                                            {{0, 1}, {0, 1}}, {}, few);
    check_circle(locus, SingularityKind::pitchfork, 1);
    for (const auto& region : locus.regions) CHECK(region.count == (region.area < 1e-3 ? 4 : 2));
}

TEST_CASE("a lens between two cusps, 1e-3 of the window, is found and traced") {
    const double r = 5e-4;
    const auto locus =
        trace_locus<FoldIsola, FoldIsola::x, FoldIsola::y>({0, 0, x_0, y_0, r, 0, 1, 1e-7}, {{0, 1}, {0, 1}}, {}, few);
    CAPTURE(locus.argument());
    CHECK(locus.evidence.complete());
    const auto cusps = locus.of(SingularityKind::cusp);
    REQUIRE(cusps.size() == 4);  // theta = 0 and theta = pi
    for (const auto& cusp : cusps) {
        CHECK(std::abs(cusp.x() - x_0) < 1e-10);
        CHECK(std::abs(std::abs(cusp.y() - y_0) - r) < 1e-12);
    }
    REQUIRE(locus.curves.size() == 2);
    for (const auto& curve : locus.curves) CHECK(curve.ends[0] == CurveEnd::closed);
    for (const auto& curve : locus.curves)
        for (const auto& at : curve.points) {
            const double s = r * r - (at.y() - y_0) * (at.y() - y_0), x = 1e-7 * (at.x() - x_0);
            CHECK(std::abs(4 * s * s * s - 27 * x * x) < 1e-20);
        }
}
