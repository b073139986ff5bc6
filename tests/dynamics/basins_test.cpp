// Which equilibrium a damped motion comes to, with the energy argument.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/dynamics/basins.hpp>
#include <equilibria/model/torus.hpp>

#include "support/catch.hpp"
#include "support/moving_models.hpp"

using namespace equilibria;
using std::numbers::pi;

namespace {

/// V = -cos q - depth cos 2 q: for depth > 1/4 wells at 0 and pi, that at pi the shallower one.
struct TwoWells {
    static constexpr int n_angles = 1;
    enum Parameter { depth, friction, n_parameters };
    constexpr auto potential(const auto& q, const auto& p) const { return -cos(q[0]) - p[depth] * cos(2 * q[0]); }
    constexpr auto kinetic_energy(const auto&, const auto& v, const auto&) const { return 0.5 * v[0] * v[0]; }
    constexpr auto dissipation(const auto&, const auto& v, const auto& p) const {
        return 0.5 * p[friction] * v[0] * v[0];
    }
};

struct Found {
    Unknowns<TwoWells> q;
    double energy;
    bool minimum;
    bool stable() const { return minimum; }
};

std::vector<Found> equilibria_of(double depth) {
    const double top = std::acos(-1 / (4 * depth));
    const auto energy = [&](double q) { return -std::cos(q) - depth * std::cos(2 * q); };
    return {
        {{0}, energy(0), true}, {{pi}, energy(pi), true}, {{top}, energy(top), false}, {{-top}, energy(top), false}};
}

}  // namespace

TEST_CASE("From rest, strong damping takes each start to the well that it lies in") {
    const Parameters<TwoWells> p{1, 20};
    const auto all = equilibria_of(1);
    const double top = all[2].q[0];
    std::vector<MotionState<TwoWells>> starts;
    for (int k = 0; k < 40; ++k) starts.push_back({{-3.1 + 0.155 * k}, {0}});
    const auto settled = find_basins<TwoWells>(p, all, starts);
    REQUIRE(settled.size() == starts.size());
    for (std::size_t k = 0; k < starts.size(); ++k) {
        CAPTURE(starts[k].q[0]);
        CHECK(settled[k].status == MotionStatus::finished);
        REQUIRE(settled[k].equilibrium);
        CHECK(*settled[k].equilibrium == (std::abs(starts[k].q[0]) < top ? 0U : 1U));
        CHECK(settled[k].trapped_time == 0);
        CHECK(settled[k].energy_rise < 1e-7);
        CHECK(std::abs(wrap(settled[k].last.q[0] - all[*settled[k].equilibrium].q[0])) < 1e-3);
    }
}

TEST_CASE("Fast starts turn over before they are trapped, and threads change nothing") {
    const Parameters<TwoWells> p{1, 0.05};
    const auto all = equilibria_of(1);
    Generator generator(1);
    std::vector<MotionState<TwoWells>> starts;
    for (int k = 0; k < 60; ++k) starts.push_back({{uniform(generator, -pi, pi)}, {uniform(generator, -4, 4)}});
    BasinOptions options;
    const auto one = find_basins<TwoWells>(p, all, starts, options);
    options.executor = threads(2);
    const auto two = find_basins<TwoWells>(p, all, starts, options);
    int shallow = 0, later = 0;
    for (std::size_t k = 0; k < starts.size(); ++k) {
        REQUIRE(one[k].equilibrium);
        CHECK(one[k].equilibrium == two[k].equilibrium);
        CHECK(one[k].time == two[k].time);
        CHECK(one[k].last.q[0] == two[k].last.q[0]);
        CHECK(one[k].energy_rise < 1e-7);
        const auto& p0 = starts[k];
        const double energy = 0.5 * p0.velocity[0] * p0.velocity[0] + potential<TwoWells>(p0.q, p);
        CHECK((one[k].trapped_time > 0) == (energy >= all[2].energy));
        CHECK(one[k].trapped_time < one[k].time);
        shallow += *one[k].equilibrium == 1;
        later += one[k].trapped_time > 0;
    }
    CHECK(shallow > 5);
    CHECK(shallow < 55);
    CHECK(later > 20);
}

TEST_CASE("Motions that do not settle say so, and so does a list without a stable equilibrium") {
    const auto all = equilibria_of(1);
    BasinOptions options;
    options.longest_time = 20;
    const auto free = find_basins<TwoWells>({1, 0}, all, {{{1}, {0}}}, options);
    CHECK_FALSE(free[0].equilibrium);
    CHECK(free[0].time >= 20);
    CHECK(free[0].status == MotionStatus::finished);
    const auto message = [&](const std::vector<Found>& some, const BasinOptions& o) -> std::string {
        try {
            find_basins<TwoWells>({1, 1}, some, {{{1}, {0}}}, o);
        } catch (const InvalidArgument& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message({all[2]}, options) == "equilibria = 1: of these one at least must be stable");
    options.longest_time = -1;
    CHECK(message(all, options) == "longest_time = -1: must be positive");
    options.longest_time = 1;
    options.settled_share = 1;
    CHECK(message(all, options) == "settled_share = 1: must be between 0 and 1");
}
