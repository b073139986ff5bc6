// The quadrature of the beam's shapes, which is made at compile time, against Boost.Math's, and its degree.
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>

#include <equilibria/studies/rotating_body_beam/beam_modes.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using mechanisms::BeamModes;

namespace {

/// Nodes and weights, falling.
template <int K>
std::vector<std::pair<double, double>> rule() {
    static constexpr BeamModes<K> modes;
    std::vector<std::pair<double, double>> y;
    modes.for_each_node([&](double z, double w) { y.emplace_back(z, w); });
    return y;
}

template <int K>
void check_rule() {
    CAPTURE(K);
    constexpr std::size_t nodes = 2 * K + 3;
    const auto ours = rule<K>();
    REQUIRE(ours.size() == nodes);
    // Boost's are those of [-1, 1] from 0 on, rising
    using Gauss = boost::math::quadrature::gauss<double, static_cast<unsigned>(nodes)>;
    const auto& place = Gauss::abscissa();
    const auto& weight = Gauss::weights();
    for (std::size_t k = 0; k < place.size(); ++k) {
        const std::size_t above = nodes / 2 - k, below = nodes / 2 + k;
        CHECK(ours[above].first == Approx(0.5 * (1 + place[k])).epsilon(1e-14));
        CHECK(ours[below].first == Approx(0.5 * (1 - place[k])).epsilon(1e-14).margin(1e-16));
        CHECK(ours[above].second == Approx(0.5 * weight[k]).epsilon(1e-12));
        CHECK(ours[below].second == Approx(0.5 * weight[k]).epsilon(1e-12));
    }
    // exact to degree 4 K + 5
    for (int degree = 0; degree <= 4 * K + 5; ++degree) {
        double sum = 0;
        for (const auto& [z, w] : ours) sum += w * std::pow(z, degree);
        CHECK(sum == Approx(1.0 / (degree + 1)).epsilon(1e-13));
    }
}

}  // namespace

TEST_CASE("The nodes of the beam's quadrature are Gauss's, as Boost has them") {
    check_rule<1>();
    check_rule<2>();
    check_rule<4>();
    check_rule<8>();
    check_rule<14>();
}
