// Models that tests share: small ones, each with something that the chains of mechanisms/ lack.
#pragma once

#include <array>
#include <cstddef>

#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/model/model.hpp>

namespace models {

/// One angle under a constant torque: equations without a potential. sin(theta) = torque.
struct Pendulum {
    static constexpr int n_angles = 1;
    enum Parameter { torque, n_parameters };
    constexpr auto equations(const auto& theta, const auto& p) const { return std::array{sin(theta[0]) - p[torque]}; }
};

/// The same with a stiffness: stiffness sin(theta) = torque, folds at torque = +-stiffness, theta = +-pi/2.
struct TorquePendulum {
    static constexpr int n_angles = 1;
    enum Parameter { torque, stiffness, n_parameters };
    constexpr auto equations(const auto& theta, const auto& p) const {
        return std::array{p[stiffness] * sin(theta[0]) - p[torque]};
    }
};

/// A coordinate: a bob at distance x on a spring of rest length 1. V = k/2 (x - 1)^2 - g x cos(theta).
struct ElasticPendulum {
    static constexpr int n_angles = 1, n_coordinates = 1;
    enum Parameter { stiffness, gravity, n_parameters };
    constexpr auto potential(const auto& theta, const auto& x, const auto& p) const {
        return 0.5 * p[stiffness] * (x[0] - 1) * (x[0] - 1) - p[gravity] * x[0] * cos(theta[0]);
    }
};

/// All-to-all coupled angles, sum_j k_ij sin(theta_i - theta_j), with loads on the cosine and sine of each angle.
template <int N>
struct CoupledAngles {
    static constexpr int n_angles = N, n_parameters = N * N + 2 * N;
    constexpr auto equations(const auto& theta, const auto& p) const {
        std::array<equilibria::scalar_of<decltype(theta)>, N> f{};
        for (int i = 0; i < N; ++i) {
            auto& sum = f[static_cast<std::size_t>(i)];
            sum = p[N * N + 2 * i] * cos(theta[i]) + p[N * N + 2 * i + 1] * sin(theta[i]);
            for (int j = 0; j < N; ++j)
                if (j != i) sum += p[N * i + j] * sin(theta[i] - theta[j]);
        }
        return f;
    }
};

/// N equal angles, all-to-all coupling k, load on each: V = -k sum cos(theta_i - theta_j) - load sum cos theta_i, and
/// F_i = Im(exp(i theta_i) (k T + load)) in the real case, T the sum of exp(-i theta_j). Solutions: T and its conjugate
/// both -load/k, a family of dimension N - 2, real where load/k <= N; and z_i = +-1, 2^N isolated points.
template <int N>
struct EqualAngles {
    static constexpr int n_angles = N;
    enum Parameter { coupling, load, n_parameters };
    constexpr auto potential(const auto& theta, const auto& p) const {
        equilibria::scalar_of<decltype(theta)> v{};
        for (int i = 0; i < N; ++i) {
            v -= p[load] * cos(theta[i]);
            for (int j = 0; j < i; ++j) v -= p[coupling] * cos(theta[i] - theta[j]);
        }
        return v;
    }
};

using TwoAngleMechanism = equilibria::mechanisms::HolonomicMechanism;

/// Multiples, differences and phases of angles, powers of a coordinate, functions of parameters.
struct Everything {
    static constexpr int n_angles = 2, n_coordinates = 1;
    enum Parameter { a, b, phase, n_parameters };
    constexpr auto potential(const auto& theta, const auto& x, const auto& p) const {
        auto sum = 2 * theta[0];
        sum -= 3 * theta[1];
        return p[a] * cos(sum + p[phase]) + sqrt(p[b]) * pow(sin(theta[1] - 0.3), 2) * x[0] +
               exp(p[a]) * pow(x[0], 3) / (1 + p[b] * p[b]) - sin(-theta[0]) * x[0] * x[0] + cos(p[phase] - theta[1]);
    }
};

}  // namespace models
