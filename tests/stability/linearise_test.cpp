// M, D, C of models at equilibria, against differences of their accelerations.
#include <array>
#include <cmath>

#include <equilibria/stability/linearise.hpp>
#include <equilibria/stability/pole_count.hpp>

#include "support/catch.hpp"
#include "support/moving_models.hpp"

using namespace equilibria;

namespace {

/// Two coordinates on springs, with a gyroscopic and a circulatory force: neither D nor C is symmetric.
struct Whirl {
    static constexpr int n_angles = 0, n_coordinates = 2;
    enum Parameter { stiffness, damping, gyroscopic, circulatory, n_parameters };
    constexpr auto potential(const auto&, const auto& x, const auto& p) const {
        return 0.5 * p[stiffness] * (x[0] * x[0] + x[1] * x[1]);
    }
    constexpr auto kinetic_energy(const auto&, const auto&, const auto& v, const auto&) const {
        return 0.5 * (v[0] * v[0] + v[1] * v[1]);
    }
    constexpr auto dissipation(const auto&, const auto&, const auto& v, const auto& p) const {
        return 0.5 * p[damping] * (v[0] * v[0] + v[1] * v[1]);
    }
    auto generalised_forces(double, const auto&, const auto& x, const auto& v, const auto& p) const {
        return std::array{p[circulatory] * x[1] - p[gyroscopic] * v[1], p[gyroscopic] * v[0] - p[circulatory] * x[0]};
    }
};

}  // namespace

TEST_CASE("Gyroscopic and circulatory forces enter D and C, and decide the stability") {
    const auto y = linearise<Whirl>({0, 0}, {4, 0.5, 3, 0.25});
    CHECK(y.mass == Eigen::Matrix2d::Identity());
    CHECK(y.damping == Eigen::Matrix2d{{0.5, 3}, {-3, 0.5}});
    CHECK(y.stiffness == Eigen::Matrix2d{{4, -0.25}, {0.25, 4}});
    // without gyroscopic forces: s^2 + d s + k = +-i c, flutter above c = d sqrt(k)
    CHECK(count_poles(linearise<Whirl>({0, 0}, {4, 0.5, 0, 0.99})).verdict() ==
          StabilityVerdict::asymptotically_stable);
    CHECK(count_poles(linearise<Whirl>({0, 0}, {4, 0.5, 0, 1})).verdict() == StabilityVerdict::marginal);
    CHECK(count_poles(linearise<Whirl>({0, 0}, {4, 0.5, 0, 1.01})).right_half_plane() == 2);
}

TEST_CASE("A pendulum hanging and upright") {
    using P = models::DrivenPendulum;
    const Parameters<P> p{2, 1.5, 9.81, 0.3, 0, 1};
    const double inertia = 2 * 1.5 * 1.5, weight = 2 * 9.81 * 1.5;
    const auto hanging = linearise<P>({0}, p);
    CHECK(hanging.mass(0, 0) == Approx(inertia));
    CHECK(hanging.damping(0, 0) == Approx(0.3));
    CHECK(hanging.stiffness(0, 0) == Approx(weight));
    const auto down = count_poles(hanging), up = count_poles(linearise<P>({std::acos(-1.0)}, p));
    CHECK(down.verdict() == StabilityVerdict::asymptotically_stable);
    CHECK(down.poles[0].real() == Approx(-0.15 / inertia));
    CHECK(up.right_half_plane() == 1);
    CHECK(up.verdict() == StabilityVerdict::unstable);
}
