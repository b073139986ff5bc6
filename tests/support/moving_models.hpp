// Models in motion that tests share.
#pragma once

#include <array>
#include <cmath>

#include <equilibria/model/kinetics.hpp>

namespace models {

/// A point mass on a rod, damped in the joint, with a torque torque cos(frequency t).
struct DrivenPendulum {
    static constexpr int n_angles = 1;
    enum Parameter { mass, length, gravity, friction, torque, frequency, n_parameters };
    constexpr auto potential(const auto& q, const auto& p) const {
        return -p[mass] * p[gravity] * p[length] * cos(q[0]);
    }
    constexpr auto kinetic_energy(const auto&, const auto& v, const auto& p) const {
        return 0.5 * p[mass] * p[length] * p[length] * v[0] * v[0];
    }
    constexpr auto dissipation(const auto&, const auto& v, const auto& p) const {
        return 0.5 * p[friction] * v[0] * v[0];
    }
    auto generalised_forces(double t, const auto&, const auto& v, const auto& p) const {
        using std::cos;
        return std::array{p[torque] * cos(t * p[frequency]) + 0.0 * v[0]};
    }
};

/// The same without friction and torque, in x and y (downwards): one constraint.
struct PendulumInPlane {
    static constexpr int n_angles = 0, n_coordinates = 2, n_constraints = 1;
    enum Parameter { mass, length, gravity, n_parameters };
    constexpr auto potential(const auto&, const auto& x, const auto& p) const { return -p[mass] * p[gravity] * x[1]; }
    constexpr auto kinetic_energy(const auto&, const auto&, const auto& v, const auto& p) const {
        return 0.5 * p[mass] * (v[0] * v[0] + v[1] * v[1]);
    }
    constexpr auto constraints(const auto&, const auto& x, const auto& p) const {
        return std::array{0.5 * (x[0] * x[0] + x[1] * x[1] - p[length] * p[length])};
    }
};

/// A bob at distance x on a spring of rest length 1.
struct ElasticPendulumInMotion {
    static constexpr int n_angles = 1, n_coordinates = 1;
    enum Parameter { mass, stiffness, gravity, n_parameters };
    constexpr auto potential(const auto& q, const auto& x, const auto& p) const {
        return 0.5 * p[stiffness] * (x[0] - 1) * (x[0] - 1) - p[mass] * p[gravity] * x[0] * cos(q[0]);
    }
    constexpr auto kinetic_energy(const auto&, const auto& x, const auto& v, const auto& p) const {
        return 0.5 * p[mass] * (v[1] * v[1] + x[0] * x[0] * v[0] * v[0]);
    }
};

struct NotQuadratic {
    static constexpr int n_angles = 1, n_parameters = 1;
    constexpr auto potential(const auto& q, const auto& p) const { return p[0] * cos(q[0]); }
    constexpr auto kinetic_energy(const auto&, const auto& v, const auto& p) const { return p[0] * v[0] * v[0] + v[0]; }
};

}  // namespace models
