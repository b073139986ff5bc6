#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <equilibria/certify/real_search.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "support/catch.hpp"
#include "support/models.hpp"

using namespace equilibria;
using models::Pendulum;

namespace {

constexpr double pi = std::numbers::pi;

/// A family in one parameter.
template <class M>
BallSystems<double> family(const Parameters<M>& p, int varied, double low, double high) {
    return BallSystems<double>(ExactSystems<M, 1>(p, {{varied}}, {{low}}, {{high}}));
}

/// The boxes of roots near the given angles, each of which must be proved for the whole family.
template <class M>
std::vector<AngleBox> proved_boxes(const BallSystems<double>& family,
                                   const std::vector<Array<double, n_angles<M>>>& roots) {
    std::vector<AngleBox> boxes;
    for (const auto& root : roots) {
        Point<M, double> q;
        for (int u = 0; u < n_angles<M>; ++u) {
            q.c[u] = Complex<double>(std::cos(root[u]));
            q.s[u] = Complex<double>(std::sin(root[u]));
        }
        const auto proof = krawczyk<M, double>(family, q, true);
        REQUIRE(proof.proved);
        boxes.push_back(AngleBox::of(proof, q, 0));
    }
    return boxes;
}

/// Complete with all boxes, and not with any one of them left out.
void check_exactly(const BallSystems<double>& family, const std::vector<AngleBox>& boxes) {
    CHECK(search_real_roots(family, boxes, 20000).complete);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        auto fewer = boxes;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
        CHECK_FALSE(search_real_roots(family, fewer, 20000).complete);
    }
}

/// Each angle 0 or pi.
template <int n>
std::vector<Array<double, n>> straight() {
    std::vector<Array<double, n>> y;
    for (int pattern = 0; pattern < 1 << n; ++pattern) {
        y.emplace_back();
        for (int i = 0; i < n; ++i) y.back()[i] = (pattern >> i & 1) != 0 ? pi : 0;
    }
    return y;
}

/// Multiples of angles: 6 values of the first, for each of them 4 of the second.
struct Multiples {
    static constexpr int n_angles = 2;
    enum Parameter { push, n_parameters };
    constexpr auto equations(const auto& theta, const auto& p) const {
        return std::array{sin(3 * theta[0]) - p[push], sin(2 * theta[1] - theta[0])};
    }
};

}  // namespace

TEST_CASE("sin(theta) = torque: two roots, none above 1, nothing proved where both meet") {
    const auto below = family<Pendulum>({{0}}, Pendulum::torque, 0.3, 0.5);
    check_exactly(below, proved_boxes<Pendulum>(below, {{{std::asin(0.4)}}, {{pi - std::asin(0.4)}}}));
    const auto above = family<Pendulum>({{0}}, Pendulum::torque, 1.001, 3.0);
    CHECK(search_real_roots(above, {}, 20000).complete);
    const auto across = family<Pendulum>({{0}}, Pendulum::torque, 0.999, 1.001);
    CHECK_FALSE(search_real_roots(across, {}, 20000).complete);
}

TEST_CASE("the interval of parameters may reach as far as a fixed share of the distance to the fold") {
    // exclusion beside the fold needs no more than that the values do not meet 0
    for (double gap = 0.1; gap > 1e-6; gap /= 10) {
        const auto beside = family<Pendulum>({{0}}, Pendulum::torque, 1 + gap, 1 + 2 * gap);
        const auto result = search_real_roots(beside, {}, 20000);
        CHECK(result.complete);
        CHECK(result.boxes < 2000);
    }
}

TEST_CASE("a slow chain has the straight equilibria and no other, for 1 to 3 links") {
    const auto check = [](auto links, const auto& p, int omega, double low, double high) {
        using M = typename decltype(links)::type;
        const auto slow = family<M>(p, omega, low, high);
        check_exactly(slow, proved_boxes<M>(slow, straight<n_angles<M>>()));
    };
    using One = mechanisms::RotatingChain<1>;
    using Two = mechanisms::TwoLinkChain;
    using Three = mechanisms::RotatingChain<3>;
    check(std::type_identity<One>{}, Parameters<One>{{1.2, 0.7, 0, 1}}, 2, 0.0, 0.5);
    check(std::type_identity<Two>{}, Parameters<Two>{{0.4, 1.5, 0}}, Two::omega, 0.0, 0.4);
    check(std::type_identity<Three>{}, Parameters<Three>{{1.387, 1.538, 1.087, .505, .364, .302, 0, 1}}, 6, 0.0, 0.1);
}

TEST_CASE("multiples of angles: 6 x 4 roots") {
    const auto multiples = family<Multiples>({{0}}, Multiples::push, 0.1, 0.12);
    std::vector<Array<double, 2>> roots;
    const double angle = std::asin(0.11) / 3;
    for (int k = 0; k < 3; ++k)
        for (const double first : {angle + 2 * k * pi / 3, pi / 3 - angle + 2 * k * pi / 3})
            for (int half = 0; half < 4; ++half) roots.push_back({{first, first / 2 + half * pi / 2}});
    check_exactly(multiples, proved_boxes<Multiples>(multiples, roots));
}

TEST_CASE("a search stops at the number of boxes that it was given") {
    const auto above = family<Pendulum>({{0}}, Pendulum::torque, 1.0001, 1.0002);
    const auto result = search_real_roots(above, {}, 8);
    CHECK_FALSE(result.complete);
    CHECK(result.boxes <= 8);
}
