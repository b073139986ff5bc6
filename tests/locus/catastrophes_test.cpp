// Loci whose curves are known: sections of the elementary catastrophes, lines parallel to an axis, symmetric windows.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/model/runtime_model_functions.hpp>
#include <equilibria/system/runtime_model_polynomials.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

/// A potential with two parameters, of so many angles and coordinates.
template <class Function>
struct InPlane {
    int n_angles, n_coordinates;
    Function function;
    int angles() const { return n_angles; }
    int coordinates() const { return n_coordinates; }
    int parameters() const { return 2; }
    auto potential(const auto& theta, const auto& x, const auto& p) const { return function(theta, x, p[0], p[1]); }
};

template <class T>
Locus<RuntimeUnknowns> locus_of(const T& model, const Window& window) {
    const RuntimeModelFunctions<T> functions(model);
    const RuntimeModelPolynomials<T> polynomials(model);
    const SearchedModel searched{&functions, &polynomials, [&](const RuntimeArray<double>& at, const RunOptions& how) {
                                     return count_of(enumerate(model, at, how));
                                 }};
    constexpr int active[] = {0, 1};
    LocusOptions options;
    options.lines = 4;
    options.checks = 8;
    return trace_locus(searched, {1.0, 1.0}, active, window, {}, options);
}
template <class Function>
Locus<RuntimeUnknowns> in_plane(int angles, int coordinates, const Window& window, Function f) {
    return locus_of(InPlane<Function>{angles, coordinates, f}, window);
}

using Counts = std::multiset<std::uint64_t>;
Counts counts(const Locus<RuntimeUnknowns>& locus) {
    Counts y;
    for (const auto& region : locus.regions) y.insert(region.count);
    return y;
}

/// (x^2 - a) (x^2 - a - 1) = 0, whatever b.
struct TwoParabolas {
    int angles() const { return 0; }
    int coordinates() const { return 1; }
    int parameters() const { return 2; }
    auto equations(const auto&, const auto& x, const auto& p) const {
        return std::array{(x[0] * x[0] - p[0]) * (x[0] * x[0] - p[0] - 1.0)};
    }
};

/// The locus of x^5 + a x^3 + b x^2 + c x in the plane of b and c.
Locus<RuntimeUnknowns> swallowtail(double a) {
    return in_plane(0, 1, {{-1, 1}, {-1, 1}}, [a](const auto&, const auto& x, const auto& b, const auto& c) {
        const auto square = x[0] * x[0];
        return square * square * x[0] + a * square * x[0] + b * square + c * x[0];
    });
}

}  // namespace

TEST_CASE("the cusp catastrophe: 8 a^3 + 27 b^2 = 0") {
    const auto locus =
        in_plane(0, 1, {{-2, 3}, {-2.5, 2}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
            return x[0] * x[0] * x[0] * x[0] + a * x[0] * x[0] + b * x[0];
        });
    INFO(locus.argument());
    CHECK(locus.evidence.complete());
    REQUIRE(locus.curves.size() == 1);
    for (const auto& at : locus.curves[0].points)
        CHECK(std::abs(8 * std::pow(at.x(), 3) + 27 * at.y() * at.y()) < 1e-9);
    const auto cusps = locus.of(SingularityKind::cusp);
    REQUIRE(cusps.size() == 1);
    CHECK(cusps[0].x() == 0);
    CHECK(cusps[0].y() == 0);
    CHECK(counts(locus) == Counts{1, 3});
}

// The first three derivatives vanish at a = -10 x^2, b = 20 x^3, c = -15 x^4.
TEST_CASE("sections of the swallowtail") {
    const auto tail = swallowtail(-1);
    INFO(tail.argument());
    CHECK(tail.evidence.complete());
    CHECK(counts(tail) == Counts{0, 2, 4});
    const auto cusps = tail.of(SingularityKind::cusp);
    REQUIRE(cusps.size() == 2);
    for (const auto& at : cusps) {
        CHECK(std::abs(at.x()) == Approx(20 * std::pow(0.1, 1.5)));
        CHECK(at.y() == Approx(-0.15));
    }
    const auto plain = swallowtail(1);
    CHECK(plain.evidence.complete());
    CHECK(plain.of(SingularityKind::cusp).empty());
    CHECK(counts(plain) == Counts{0, 2});
}

TEST_CASE("sections of the umbilics") {
    // cusps at x = 0, y = -a and a: b = a^2, c = 2 a^2 and -2 a^2
    const auto elliptic =
        in_plane(0, 2, {{-2, 2}, {-3, 3}}, [](const auto&, const auto& x, const auto& b, const auto& c) {
            const auto &u = x[0], &v = x[1];
            return u * u * u - u * v * v + u * u + v * v + b * u + c * v;
        });
    INFO(elliptic.argument());
    CHECK(elliptic.evidence.complete());
    CHECK(counts(elliptic) == Counts{2, 4});
    REQUIRE(elliptic.of(SingularityKind::cusp).size() == 2);
    for (const auto& at : elliptic.of(SingularityKind::cusp)) {
        CHECK(at.x() == Approx(1));
        CHECK(std::abs(at.y()) == Approx(2));
    }
    // a cusp at x = y = a / 6: b = c = -a^2 / 4
    const auto hyperbolic =
        in_plane(0, 2, {{-2, 1}, {-2, 1}}, [](const auto&, const auto& x, const auto& b, const auto& c) {
            const auto &u = x[0], &v = x[1];
            return u * u * u + v * v * v + u * v + b * u + c * v;
        });
    INFO(hyperbolic.argument());
    CHECK(hyperbolic.evidence.complete());
    CHECK(counts(hyperbolic) == Counts{0, 2, 4});
    REQUIRE(hyperbolic.of(SingularityKind::cusp).size() == 1);
    CHECK(hyperbolic.of(SingularityKind::cusp)[0].x() == Approx(-0.25));
    CHECK(hyperbolic.of(SingularityKind::cusp)[0].y() == Approx(-0.25));
}

TEST_CASE("two pitchfork lines through a point where every angle is an equilibrium") {
    const auto locus =
        in_plane(1, 0, {{-2, 3}, {-2.5, 2}}, [](const auto& theta, const auto&, const auto& a, const auto& b) {
            return a * cos(theta[0]) + b * cos(2 * theta[0]);
        });
    INFO(locus.argument());
    CHECK(locus.evidence.complete());
    REQUIRE(locus.curves.size() == 2);
    for (const auto& curve : locus.curves) {
        CHECK(curve.kind == SingularityKind::pitchfork);
        for (const auto& at : curve.points) CHECK(std::abs(std::abs(at.x()) - 4 * std::abs(at.y())) < 1e-9);
    }
    CHECK(counts(locus) == Counts{2, 2, 4, 4});
}

TEST_CASE("fold lines parallel to an axis part the window, on the value 0 too") {
    const auto locus = locus_of(TwoParabolas{}, {{-2, 3}, {-2.5, 2}});
    INFO(locus.argument());
    CHECK(locus.evidence.complete());
    REQUIRE(locus.curves.size() == 2);
    CHECK(counts(locus) == Counts{0, 2, 4});
    for (const auto& region : locus.regions)
        CHECK(region.area == Approx(region.count == 4 ? 4.5 * 3 : 4.5).epsilon(1e-6));
}

TEST_CASE("wedges above folds that touch the border midway are regions, with their own area") {
    // b cos t (1 + 2 sin^2 t) = -1 on the folds: from (0, 1) down to cusps at a = +-2/3, and up to a = +-0.7866
    const auto locus =
        in_plane(1, 0, {{-2, 1}, {0, 1}}, [](const auto& theta, const auto&, const auto& a, const auto& b) {
            return -3 * b * sin(2 * theta[0]) - 6 * sin(theta[0]) + 9 * a * cos(theta[0]);
        });
    INFO(locus.argument());
    CHECK(locus.evidence.complete());
    double inside = 0, area = 0;
    for (const auto& region : locus.regions) {
        CHECK((region.count == 2 || region.count == 4));
        inside += region.count == 4 ? region.area : 0;
        area += region.area;
    }
    CHECK(area == Approx(3).epsilon(1e-6));
    // twice the integral of (1 - b) da from the outer branch to the inner one, by trapezia in t
    double wedge = 0;
    const auto height = [](double t) { return 1 + 1 / (std::cos(t) * (1 + 2 * std::pow(std::sin(t), 2))); };
    const auto place = [&](double t) {
        return (std::sin(t) + 2 * (1 - height(t)) * std::sin(2 * t)) / (1.5 * std::cos(t));
    };
    const int steps = 3000;
    const double from = std::numbers::pi - std::asin(std::pow(0.75, 0.25)), step = (std::numbers::pi - from) / steps;
    for (int k = 0; k < steps; ++k) {
        const double t = from + k * step;
        wedge += (height(t) + height(t + step)) / 2 * (place(t) - place(t + step));
    }
    CHECK(inside == Approx(2 * wedge).epsilon(1e-4));
}

TEST_CASE("no curve is traced twice: past an extremal point, and from a cusp on the border") {
    const auto wave =
        in_plane(1, 0, {{-2, 3}, {-2.5, 2}}, [](const auto& theta, const auto&, const auto& a, const auto& b) {
            return 3 * cos(theta[0]) + a * sin(theta[0]) + b * cos(2 * theta[0]) + 0.5 * sin(2 * theta[0]);
        });
    INFO(wave.argument());
    CHECK(wave.evidence.complete());
    CHECK(wave.curves.size() == 2);
    CHECK(wave.regions.size() == 3);

    const auto hub = in_plane(1, 0, {{0, 1}, {0, 3}}, [](const auto& theta, const auto&, const auto& e, const auto& w) {
        const auto r = e + sin(theta[0]);
        return -cos(theta[0]) - 0.5 * w * w * r * r;
    });
    INFO(hub.argument());
    CHECK(hub.evidence.complete());
    CHECK(hub.curves.size() == 1);
    CHECK(hub.regions.size() == 2);
    REQUIRE(hub.of(SingularityKind::cusp).size() == 1);
    CHECK(hub.of(SingularityKind::cusp)[0].x() == 0);
    CHECK(hub.of(SingularityKind::cusp)[0].y() == Approx(1));
}

TEST_CASE("curves on which equilibria come from infinity are traced: a line, a circle, two that cross") {
    // two minima come along a = 0
    const auto line = in_plane(0, 1, {{-1, 2}, {-1, 1}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
        return a * x[0] * x[0] * x[0] * x[0] - x[0] * x[0] + b * x[0];
    });
    INFO(line.argument());
    CHECK(line.evidence.complete());
    CHECK(line.evidence.seeds_from_infinity > 0);
    REQUIRE(line.from_infinity.size() == 1);
    const auto& straight = line.from_infinity[0];
    CHECK(straight.ends == std::array{CurveEnd::border, CurveEnd::border});
    CHECK(std::abs(straight.points.front().y - straight.points.back().y) == Approx(2));
    for (const auto& point : straight.points) CHECK(std::abs(point.x) < 1e-9);
    bool parted = false;
    for (const auto& border : line.borders) parted = parted || border.curve == line.curves.size();
    CHECK(parted);

    // x^2 / 2 + x + (a^2 + b^2 - 1) x^4: the leading coefficient vanishes on the unit circle
    const auto circle =
        in_plane(0, 1, {{-1.5, 1.7}, {-1.4, 1.6}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
            return (a * a + b * b - 1.0) * x[0] * x[0] * x[0] * x[0] + 0.5 * x[0] * x[0] + x[0];
        });
    REQUIRE(circle.from_infinity.size() == 1);
    CHECK(circle.from_infinity[0].ends[0] == CurveEnd::closed);
    double length = 0, off = 0;
    const auto& points = circle.from_infinity[0].points;
    for (std::size_t k = 0; k < points.size(); ++k) {
        off = std::max(off, std::abs(std::hypot(points[k].x, points[k].y) - 1));
        if (k > 0) length += std::hypot(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y);
    }
    CHECK(off < 1e-9);
    CHECK(length == Approx(2 * std::numbers::pi).epsilon(1e-3));
    INFO(circle.argument());
    CHECK(circle.evidence.complete());

    // two lines side by side, 5e-5 apart, are two curves
    const auto pair =
        in_plane(0, 1, {{-1, 1.3}, {-1, 1}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
            return (a - 0.31) * (a - 0.31005) * x[0] * x[0] * x[0] * x[0] + x[0] * x[0] + b * x[0];
        });
    INFO(pair.argument());
    CHECK(pair.from_infinity.size() == 2);
    CHECK(pair.evidence.from_infinity == 0);

    // a b x^3 + x^2 + x
    const auto cross =
        in_plane(0, 1, {{-1, 1.3}, {-1.2, 1}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
            return a * b * x[0] * x[0] * x[0] + x[0] * x[0] + x[0];
        });
    INFO(cross.argument());
    CHECK(cross.from_infinity.size() == 2);
    CHECK(cross.evidence.from_infinity == 0);
}

TEST_CASE("a fold curve whose equilibrium goes to infinity ends on the curve of these, with growing steps") {
    // a^2 x^2 - b x + 1/20 = 0: folds on b^2 = a^2 / 5, at x = b / (2 a^2)
    const auto locus =
        in_plane(0, 1, {{-1, 1}, {-1, 1.1}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
            return a * a * x[0] * x[0] * x[0] / 3.0 - b * x[0] * x[0] / 2.0 + x[0] / 20.0;
        });
    INFO(locus.evidence.argument());
    CHECK(locus.evidence.complete());
    CHECK(counts(locus) == Counts{0, 0, 2, 2, 2, 2});
    REQUIRE(locus.curves.size() == 4);
    for (const auto& curve : locus.curves) {
        CHECK(curve.points.size() < 8000);
        const bool first = curve.ends[0] == CurveEnd::infinity;
        CHECK(curve.ends[first ? 0 : 1] == CurveEnd::infinity);
        CHECK(curve.ends[first ? 1 : 0] == CurveEnd::border);
        const auto& end = first ? curve.points.front() : curve.points.back();
        CHECK(std::hypot(end.x(), end.y()) < 2e-3);
        for (const auto& at : curve.points)
            if (&at != &end) CHECK(std::abs(at.y() * at.y() - at.x() * at.x() / 5) < 1e-9);
    }
}

TEST_CASE("fold curves end at a point of the plane at which every state is an equilibrium") {
    const auto locus = in_plane(0, 1, {{-2, 2}, {0, 4}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
        const auto square = x[0] * x[0];
        return 4.0 * square * square * a + (5.0 * b - 9.0) * square + 3.5 * x[0] * a * a;
    });
    INFO(locus.evidence.argument());
    CHECK(locus.evidence.complete());
    CHECK(locus.points.empty());
    CHECK(counts(locus) == Counts{1, 1, 3, 3});
    REQUIRE(locus.curves.size() == 2);
    for (const auto& curve : locus.curves) {
        CHECK(curve.points.size() < 2000);
        const bool first = curve.ends[0] == CurveEnd::continuum;
        CHECK(curve.ends[first ? 0 : 1] == CurveEnd::continuum);
        const auto& end = first ? curve.points.front() : curve.points.back();
        CHECK(std::abs(end.x()) < 1e-6);
        CHECK(std::abs(end.y() - 1.8) < 1e-6);
    }
}

TEST_CASE("a parameter that enters by its square has the same locus on both sides of 0") {
    // the cusp catastrophe over a^2 - 1: the fold curves from both cusps meet at a = 0
    const auto mirrored_cusp =
        in_plane(0, 1, {{-2, 1.9}, {-1.3, 1.4}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
            return x[0] * x[0] * x[0] * x[0] + (a * a - 1.0) * x[0] * x[0] + b * x[0];
        });
    INFO(mirrored_cusp.argument());
    CHECK(mirrored_cusp.evidence.complete());
    CHECK(mirrored_cusp.of(SingularityKind::cusp).size() == 2);
    double negative = 0, positive = 0;
    for (const auto& curve : mirrored_cusp.curves)
        for (const auto& at : curve.points) {
            CHECK(std::abs(8 * std::pow(at.x() * at.x() - 1, 3) + 27 * at.y() * at.y()) < 1e-9);
            negative = std::min(negative, at.x()), positive = std::max(positive, at.x());
        }
    CHECK(negative == Approx(-1));
    CHECK(positive == Approx(1));
    CHECK(mirrored_cusp.regions.size() == 2);

    // folds at b^2 = a^4 + 0.1: a curve on each side of b = 0, both symmetric in a
    const auto arms =
        in_plane(0, 1, {{-1, 1.1}, {-1.2, 1}}, [](const auto&, const auto& x, const auto& a, const auto& b) {
            return x[0] * x[0] * x[0] / 3.0 + (b * b - a * a * a * a - 0.1) * x[0];
        });
    INFO(arms.argument());
    CHECK(arms.evidence.complete());
    CHECK(arms.curves.size() == 2);
}

TEST_CASE("pitchforks off symmetric branches are no folds of a line, and their curves are not said to be all") {
    // -a sin t / 2 - 5 b cos 2 t: at cos t = 0 whatever a and b, with pitchforks at |a| = 40 |b|, in a wedge that the
    // enumerations of a window may miss
    for (const Window& window : {Window{{0, 2}, {-1, 3}}, Window{{0.5, 2}, {-0.1, 0.1}}}) {
        const auto wedge = in_plane(1, 0, window, [](const auto& t, const auto&, const auto& a, const auto& b) {
            return -0.5 * a * sin(t[0]) - 5 * b * cos(2 * t[0]);
        });
        INFO(wedge.argument());
        CHECK_FALSE(wedge.evidence.complete());
        CHECK(wedge.evidence.degenerate_lines > 0);
        for (const auto& fault : wedge.evidence.faults)
            if (fault.kind == LocusFaultKind::degenerate_line)
                CHECK(std::abs(fault.point.x) == Approx(40 * std::abs(fault.point.y)).epsilon(1e-3));
    }
}
