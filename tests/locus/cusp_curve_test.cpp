// Curves of cusps that are known in closed form, in coordinates that are not those of the normal form, through each
// transition; and the curve of the rotating chain.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/continuation/check_derivatives.hpp>
#include <equilibria/locus/space/cusp_curve.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/singularity/refine_singularity.hpp>

#include "support/catch.hpp"

using namespace equilibria;

namespace {

constexpr double u_by_second = 0.3, w_by_first = -0.25, u_bend = 0.2, w_bend = 0.35;

/// Two angles become u and w, odd functions of them plus even ones: those with `Bent` have no symmetry.
template <bool Bent>
constexpr auto local_u(const auto& theta) {
    const auto odd = sin(theta[0]) + u_by_second * sin(theta[1]) + 0.1 * sin(2 * theta[0] + theta[1]);
    if constexpr (Bent)
        return odd + u_bend * (1 - cos(theta[0])) + 0.1 * sin(theta[0]) * sin(theta[1]);
    else
        return odd;
}
template <bool Bent>
constexpr auto local_w(const auto& theta) {
    const auto odd = sin(theta[1]) + w_by_first * sin(theta[0]);
    if constexpr (Bent)
        return odd + w_bend * (1 - cos(theta[1]));
    else
        return odd;
}

template <bool Bent>
struct Coordinates {
    static constexpr int n_angles = 2, n_parameters = 2;
    constexpr auto equations(const auto& theta, const auto& p) const {
        return std::array{local_u<Bent>(theta) - p[0], local_w<Bent>(theta) - p[1]};
    }
};

/// Where u and w have these values, near 0.
template <bool Bent>
Array<double, 2> angles_of(double u, double w) {
    using Map = Coordinates<Bent>;
    Unknowns<Map> q{u, w};
    for (int k = 0; k < 20; ++k) {
        const auto f = equations<Map>(q, {u, w});
        const auto j = jacobian<Map>(q, {u, w});
        const double determinant = j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0);
        q[0] -= (j(1, 1) * f[0] - j(0, 1) * f[1]) / determinant;
        q[1] -= (j(0, 0) * f[1] - j(1, 0) * f[0]) / determinant;
    }
    return q;
}
template <bool Bent>
Array<double, 2> u_and_w(const auto& q) {
    const CircleAngle<double> theta[] = {{std::cos(q[0]), std::sin(q[0])}, {std::cos(q[1]), std::sin(q[1])}};
    return {local_u<Bent>(theta), local_w<Bent>(theta)};
}

/// V' = u^4 + a u^2 + b u + c along w = 0: cusps at a = -6 u^2, b = 8 u^3, c = -3 u^4.
struct Swallowtail {
    static constexpr int n_angles = 2;
    enum Parameter { a, b, c, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = local_u<true>(theta), w = local_w<true>(theta);
        return pow(u, 5) / 5 + p[a] * pow(u, 3) / 3 + p[b] * u * u / 2 + p[c] * u - 0.5 * w * w;
    }
};
/// u^3 + w^3 + a u w + ..: cusps at u = w = a / 6 along (1, -1). Sign -1: u^3 - 3 u w^2 + a (u^2 + w^2) + ..: cusps at
/// the distance a / 3 from 0 in three directions.
template <int Sign>
struct Umbilic {
    static constexpr int n_angles = 2, n_coordinates = 1;
    enum Parameter { a, b, c, n_parameters };
    constexpr auto potential(const auto& theta, const auto& x, const auto& p) const {
        const auto u = local_u<true>(theta), w = local_w<true>(theta), t = x[0] + 0.3 * sin(theta[0]) * (1 + x[0]);
        const auto unfolding = p[b] * u + p[c] * w + 0.5 * t * t;
        if constexpr (Sign > 0)
            return pow(u, 3) + pow(w, 3) + p[a] * u * w + unfolding;
        else
            return pow(u, 3) - 3 * u * w * w + p[a] * (u * u + w * w) + unfolding;
    }
};
/// u^4 / 4 + h(y, z) u^2 / 2 + x u: cusps at u = x = h = 0. h = z + y^2, z - y^2, y^2 + z^2 - 0.09.
enum class Contact { lips, beak_to_beak, circle };
template <Contact Kind>
struct Meeting {
    static constexpr int n_angles = 2;
    enum Parameter { x, y, z, n_parameters };
    static constexpr auto h(const auto& p) {
        if constexpr (Kind == Contact::lips)
            return p[z] + p[y] * p[y];
        else if constexpr (Kind == Contact::beak_to_beak)
            return p[z] - p[y] * p[y];
        else
            return p[y] * p[y] + p[z] * p[z] - 0.09;
    }
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = local_u<true>(theta), w = local_w<true>(theta);
        return pow(u, 4) / 4 + h(p) * u * u / 2 + p[x] * u + 0.5 * w * w;
    }
};
/// V' = u (u^6 + a u^4 + b u^2 + c) along w = 0, and the symmetry theta -> -theta: cusps at a = -3 u^2, b = 3 u^4,
/// c = -u^6.
struct Symmetric {
    static constexpr int n_angles = 2;
    enum Parameter { a, b, c, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        const auto u = local_u<false>(theta), w = local_w<false>(theta);
        return pow(u, 8) / 8 + p[a] * pow(u, 6) / 6 + p[b] * pow(u, 4) / 4 + p[c] * u * u / 2 + 0.5 * w * w;
    }
};

template <class M>
void check_confirmed(const CuspTransition<M>& t, SingularityKind kind) {
    CHECK(std::string(to_string(t.at.kind)) == to_string(kind));
    CHECK(t.at.converged);
    CHECK(t.at.residual < 1e-13);
}

template <class M>
double distance_from_0(const CuspTransition<M>& t) {
    double y = std::max({std::abs(t.at.x()), std::abs(t.at.y()), std::abs(t.at.z())});
    for (const double q : t.at.q) y = std::max(y, std::abs(q));
    return y;
}

}  // namespace

TEST_CASE("the cusp problem's derivatives are those of its residual") {
    using Problem = CuspProblem<Swallowtail, 0, 1, 2>;
    const Problem problem({}, 1, 1);
    const auto errors = check_derivatives(problem, Problem::packed({0.3, -0.2}, {0.6, 0.7}, 0.4, -0.1), 0.2);
    CHECK(errors.tangent < 1e-7);
    CHECK(errors.parameter_derivative < 1e-7);
}

TEST_CASE("through a swallowtail: the curve turns back in every parameter, and its points are the closed form's") {
    using M = Swallowtail;
    const double u = 0.3, a = -6 * u * u, b = 8 * u * u * u, c = -3 * u * u * u * u;
    const auto q = angles_of<true>(u, 0);
    const Box box{{-1, 1}, {-1, 1}, {-1, 1}};
    const auto check = [&](const CuspCurve<M>& curve, const auto& order) {
        REQUIRE(curve.points.size() > 20);
        CHECK(curve.ends[0] == CurveEnd::border);
        CHECK(curve.ends[1] == CurveEnd::border);
        for (const auto& point : curve.points) {
            const double xyz[] = {point.x(), point.y(), point.z()};
            const double s = u_and_w<true>(point.q)[0];
            CHECK(std::abs(xyz[order[0]] + 6 * s * s) < 1e-10);
            CHECK(std::abs(xyz[order[1]] - 8 * s * s * s) < 1e-10);
            CHECK(std::abs(xyz[order[2]] + 3 * s * s * s * s) < 1e-10);
        }
        for (const auto& end : {curve.points.front(), curve.points.back()}) {
            const double xyz[] = {end.x(), end.y(), end.z()};
            CHECK(xyz[order[0]] == -1);  // the first face that is met, exactly
            CHECK(std::abs(u_and_w<true>(end.q)[0]) == Approx(std::sqrt(1. / 6)).epsilon(1e-11));
        }
        REQUIRE(curve.transitions.size() == 1);
        const auto& t = curve.transitions[0];
        check_confirmed(t, SingularityKind::swallowtail);
        CHECK(distance_from_0(t) < 1e-12);
        CHECK(t.at.versal());
        CHECK(curve.points[t.step].derivative(4) * curve.points[t.step + 1].derivative(4) < 0);
    };
    check(trace_cusp_curve<M, M::b, M::c, M::a>({a + 0.001, b, c}, q, box), Array<int, 3>{2, 0, 1});
    check(trace_cusp_curve<M, M::a, M::b, M::c>({a, b - 0.001, c}, q, box), Array<int, 3>{0, 1, 2});
}

TEST_CASE("through umbilics: one curve of cusps at the hyperbolic one, three at the elliptic one") {
    const Box box{{-0.5, 0.5}, {-0.5, 0.5}, {-0.5, 0.5}};
    const auto check = [&]<class M>(const M&, double a, double u, double w, double b, double c, SingularityKind kind) {
        const auto angles = angles_of<true>(u, w);
        Unknowns<M> q{angles[0], angles[1], 0};
        q[2] = -0.3 * std::sin(q[0]) / (1 + 0.3 * std::sin(q[0]));
        const auto curve = trace_cusp_curve<M, M::b, M::c, M::a>({a, b, c}, q, box);
        REQUIRE(curve.points.size() > 20);
        CHECK(curve.ends[0] == CurveEnd::border);
        CHECK(curve.ends[1] == CurveEnd::border);
        for (const auto& point : curve.points) {
            const auto now = u_and_w<true>(point.q);
            CHECK(std::abs(now[0] - u / a * point.z()) < 1e-10);
            CHECK(std::abs(now[1] - w / a * point.z()) < 1e-10);
        }
        REQUIRE(curve.transitions.size() == 1);
        const auto& t = curve.transitions[0];
        check_confirmed(t, kind);
        CHECK(t.at.nullity == 2);
        CHECK(t.at.versal());
        CHECK(distance_from_0(t) < 1e-12);
    };
    const double a = 0.2;
    check(Umbilic<1>{}, a, a / 6, a / 6, -a * a / 4, -a * a / 4, SingularityKind::hyperbolic_umbilic);
    for (int k = 0; k < 3; ++k) {
        const double phase = 2 * std::numbers::pi * k / 3, u = a / 3 * std::cos(phase), w = a / 3 * std::sin(phase);
        check(Umbilic<-1>{}, a, u, w, -3 * u * u + 3 * w * w - 2 * a * u, 6 * u * w - 2 * a * w,
              SingularityKind::elliptic_umbilic);
    }
}

TEST_CASE("lips and beak-to-beak: the curve is tangent to a plane and b stays away from 0") {
    const Box box{{-0.5, 0.5}, {-0.5, 0.5}, {-0.5, 0.5}};
    const auto check = [&]<class M>(const M&, double z, SingularityKind kind) {
        const auto curve = trace_cusp_curve<M, M::x, M::y, M::z>({0.001, 0.4, z}, {0.01, -0.01}, box);
        REQUIRE(curve.points.size() > 20);
        CHECK(curve.ends[0] == CurveEnd::border);
        CHECK(curve.ends[1] == CurveEnd::border);
        for (const auto& point : curve.points) {
            CHECK(std::abs(point.x()) < 1e-10);
            CHECK(std::abs(M::h(Parameters<M>{point.x(), point.y(), point.z()})) < 1e-10);
            CHECK(point.derivative(4) > 1);
        }
        REQUIRE(curve.transitions.size() == 1);
        const auto& t = curve.transitions[0];
        check_confirmed(t, kind);
        CHECK(distance_from_0(t) < 1e-12);
        CHECK((t.at.form[0] * t.at.form[1] > 0) == (kind == SingularityKind::lips));
    };
    check(Meeting<Contact::lips>{}, -0.16, SingularityKind::lips);
    check(Meeting<Contact::beak_to_beak>{}, 0.16, SingularityKind::beak_to_beak);
}

TEST_CASE("a closed curve of cusps begins and ends in lips") {
    using M = Meeting<Contact::circle>;
    const auto curve = trace_cusp_curve<M, M::x, M::y, M::z>({0, 0.24, 0.18}, {0, 0}, {{-1, 1}, {-1, 1}, {-1, 1}});
    CHECK(curve.ends[0] == CurveEnd::closed);
    CHECK(curve.ends[1] == CurveEnd::closed);
    REQUIRE(curve.transitions.size() == 2);
    double product = 1;
    for (const auto& t : curve.transitions) {
        check_confirmed(t, SingularityKind::lips);
        CHECK(std::abs(std::abs(t.at.z()) - 0.3) < 1e-12);
        product *= t.at.z();
    }
    CHECK(product < 0);
    // a start on the turn itself
    const auto turned = trace_cusp_curve<M, M::x, M::y, M::z>({0, 0, 0.3}, {0, 0}, {{-1, 1}, {-1, 1}, {-1, 1}});
    CHECK(turned.ends[0] == CurveEnd::closed);
}

TEST_CASE("on a symmetric branch the curve meets its mirror image, in a tetracritical pitchfork") {
    using M = Symmetric;
    const Box box{{-1, 1}, {-1, 1}, {-1.2, 1}};
    for (const double u : {0.55, -0.3}) {
        const Parameters<M> p{-3 * u * u, 3 * std::pow(u, 4), -std::pow(u, 6)};
        const auto curve = trace_cusp_curve<M, M::b, M::c, M::a>(p, angles_of<false>(u, 0), box);
        REQUIRE(curve.points.size() > 10);
        const bool last = curve.ends[1] == CurveEnd::symmetric;
        CHECK(curve.ends[last ? 1 : 0] == CurveEnd::symmetric);
        CHECK(curve.ends[last ? 0 : 1] == CurveEnd::border);
        REQUIRE(curve.transitions.size() == 1);
        const auto& t = curve.transitions[0];
        check_confirmed(t, SingularityKind::tetracritical_pitchfork);
        CHECK(distance_from_0(t) < 1e-12);
        CHECK(std::abs(t.at.derivative(8)) > 1);
        for (const auto& point : curve.points) {
            const double square = std::pow(u_and_w<false>(point.q)[0], 2);
            CHECK(std::abs(point.z() + 3 * square) < 1e-9);
            CHECK(std::abs(point.x() - 3 * square * square) < 1e-9);
        }
    }
}

TEST_CASE("the two cusps of the rotating chain at ratio 1.5 are on one curve, and meet beak to beak at ratio 16 / 9") {
    using M = mechanisms::TwoLinkChain;
    const Box box{{0, 1}, {0, 20}, {1, 3}};
    double start_alpha[2];
    const Unknowns<M> starts[] = {{0.96388, -1.0864}, {0.1773, -0.638}};
    const Parameters<M> near[] = {{0.3299, 1.5, 1.938}, {0.003437, 1.5, 1.0168}};
    for (int k = 0; k < 2; ++k) {
        const auto cusp = refine_singularity<M, SingularityKind::cusp, M::alpha, M::omega>(starts[k], near[k]);
        REQUIRE(cusp.kind == SingularityKind::cusp);
        start_alpha[k] = cusp.p[M::alpha];
        const auto curve = trace_cusp_curve<M, M::alpha, M::omega, M::ratio>(near[k], starts[k], box);
        REQUIRE(curve.points.size() > 100);
        const bool first = curve.ends[0] == CurveEnd::border;
        const auto &fast = first ? curve.points.front() : curve.points.back(),
                   &slow = first ? curve.points.back() : curve.points.front();
        CHECK(curve.ends[first ? 0 : 1] == CurveEnd::border);
        CHECK(curve.ends[first ? 1 : 0] == CurveEnd::degenerate);
        CHECK(fast.y() == 20);
        CHECK(std::abs(fast.x() - 0.95463988085) < 1e-10);
        // towards a massless second link of the length of the first, hanging: alpha = e^4 / 16, omega = 1 + e^3 / 8 and
        // the angles e^1.5 / 2 and -e^0.5 to leading order in e = ratio - 1
        const double e = slow.z() - 1;
        CHECK(e > 0);
        CHECK(e < 1e-2);
        CHECK(slow.x() == Approx(std::pow(e, 4) / 16).epsilon(2 * e));
        CHECK(slow.y() - 1 == Approx(std::pow(e, 3) / 8).epsilon(2 * e));
        CHECK(std::abs(slow.q[0]) == Approx(std::pow(e, 1.5) / 2).epsilon(2 * e));
        CHECK(std::abs(slow.q[1]) == Approx(std::sqrt(e)).epsilon(2 * e));

        REQUIRE(curve.transitions.size() == 1);
        const auto& t = curve.transitions[0];
        check_confirmed(t, SingularityKind::beak_to_beak);
        CHECK(std::abs(t.at.x() - 1. / 16) < 1e-12);
        CHECK(std::abs(std::pow(t.at.y(), 4) - 243. / 125) < 1e-12);
        CHECK(std::abs(t.at.z() - 16. / 9) < 1e-12);
        CHECK(std::abs(std::pow(std::sin(t.at.q[0]), 2) - 7. / 27) < 1e-12);
        CHECK(std::abs(std::pow(std::sin(t.at.q[1]), 2) - 7. / 12) < 1e-12);
        CHECK(t.at.derivative(4) < -1);
        // the curve passes the plane ratio = 1.5 in both cusps
        std::vector<double> alphas;
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
            const auto &a = curve.points[i], &b = curve.points[i + 1];
            if ((a.z() - 1.5) * (b.z() - 1.5) <= 0)
                alphas.push_back(a.x() + (b.x() - a.x()) * (1.5 - a.z()) / (b.z() - a.z()));
        }
        CHECK(alphas.size() >= 2);
        for (const double alpha : alphas)
            CHECK((std::abs(alpha - 0.329896176411403) < 1e-3 || std::abs(alpha - 0.003437156922) < 1e-4));
    }
    CHECK(std::abs(start_alpha[0] - start_alpha[1]) > 0.3);
}

TEST_CASE("without a cusp there is no curve, and bad boxes are refused") {
    using M = Swallowtail;
    CHECK(trace_cusp_curve<M, 0, 1, 2>({5, 5, 5}, {1, 1}, {{-1, 1}, {-1, 1}, {-1, 1}}).points.empty());
    CHECK_THROWS_AS((trace_cusp_curve<M, 0, 1, 2>({0, 0, 0}, {0, 0}, {{-1, -1}, {-1, 1}, {-1, 1}})), InvalidArgument);
    CHECK_THROWS_AS((trace_cusp_curve<M, 0, 1, 2>({NAN, 0, 0}, {0, 0}, {{-1, 1}, {-1, 1}, {-1, 1}})), InvalidArgument);
}
