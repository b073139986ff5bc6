/// \file
/// A rigid body with an elastic beam, free in space: relative equilibria, in which it turns uniformly about a principal
/// axis of its deformed shape. Source: Baillieul, "Parametric dependence in the equilibrium dynamics of rotating
/// structures", section 2, with Galerkin modes for the beam. Where it fails: with the coupled strain energy one or two
/// modes lock (docs/body-beam.md); rotating_body_beam_boundary.hpp has the continuous beam.
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/array.hpp>
#include <equilibria/core/dense_solvers.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/model.hpp>
#include <equilibria/studies/rotating_body_beam/beam_modes.hpp>

namespace equilibria::mechanisms {

namespace detail {
/// w^T J w of a symmetric J.
constexpr auto quadratic_form(const auto& j, const auto& w) {
    auto y = j[0][0] * w[0] * w[0];
    for (int a = 0; a < 3; ++a)
        for (int b = a == 0 ? 1 : a; b < 3; ++b) y += (a == b ? 1.0 : 2.0) * j[a][b] * w[a] * w[b];
    return y;
}
}  // namespace detail

/// The beam's strain energy.
enum class BeamStrain {
    linear,   ///< 1/2 int mu_1 u1''^2 + mu_2 u2''^2 + mu_3 u3'^2, Baillieul's
    coupled,  ///< mu_3/2 int (u3' + (u1'^2 + u2'^2)/2)^2 for the last part: with centrifugal stiffening
    either,   ///< mu_3/2 int (u3' + kappa (u1'^2 + u2'^2)/2)^2, kappa the parameter `coupling`: 0 or 1 for the others
};

/// What is given of a relative equilibrium.
enum class BeamControl {
    speed,     ///< the angular speed omega
    momentum,  ///< the size A of the angular momentum: omega = A / lambda
};

/// What the models below share. The body frame has its origin where the beam is clamped and its third axis along the
/// undeformed beam, whose line density is 1: its mass is its length l. The beam's point z is at r = (u1(z), u2(z), z +
/// u3(z)) with K modes a direction, orthonormal in L2 over the length.
template <int K, BeamStrain Strain>
struct RotatingBodyBeamBase {
    static constexpr int n_modes = 3 * K;  ///< shapes in all
    /// Mass and principal moments of inertia of the body about the origin, along the frame; its centre of mass; the
    /// beam's length; its stiffnesses mu_1, mu_2 (bending along the axes 1 and 2) and mu_3 (stretching); the angular
    /// speed omega; the size of the angular momentum. Read by some models alone: those after the speed.
    enum Parameter {
        body_mass,
        inertia_1,
        inertia_2,
        inertia_3,
        centre_1,
        centre_2,
        centre_3,
        length,
        bending_1,
        bending_2,
        stretching,
        speed,
        momentum,
        coupling,     ///< of BeamStrain::either
        second_axis,  ///< of BodyBeamEitherStrain
        n_parameters
    };
    using Values = Array<double, n_parameters>;  ///< one of each, by `Parameter`
    static constexpr BeamModes<K> modes{};       ///< shapes of a beam of length 1

    /// Throws InvalidArgument unless masses, inertias, length and stiffnesses are positive, the speed is not negative,
    /// and the inertia is that of a body: each moment is at most the sum of the others.
    static void validate(const Values& p) {
        require_finite(p, "parameters");
        const auto positive = [&](Parameter k, const char* name) { require(p[k] > 0, name, p[k], "must be positive"); };
        positive(body_mass, "body_mass");
        positive(inertia_1, "inertia_1");
        positive(inertia_2, "inertia_2");
        positive(inertia_3, "inertia_3");
        positive(length, "length");
        positive(bending_1, "bending_1");
        positive(bending_2, "bending_2");
        positive(stretching, "stretching");
        require(p[speed] >= 0, "speed", p[speed], "must be 0 or more");
        for (int k = 0; k < 3; ++k)
            require(p[inertia_1 + k] <= p[inertia_1 + (k + 1) % 3] + p[inertia_1 + (k + 2) % 3], "inertia",
                    p[inertia_1 + k], "must be at most the sum of the two other moments");
    }

    /// V(u) for the modes u = (u1, u2, u3), K of each.
    static constexpr auto strain_energy(const auto& u, const auto& p) {
        using S = std::remove_cvref_t<decltype(u[0] * p[0])>;
        const auto l = p[length];
        const auto inverse = 1 / l, squared = inverse * inverse;
        S bending{}, stretch{};
        for (int i = 0; i < K; ++i)
            for (int j = 0; j < K; ++j) {
                bending +=
                    modes.bending_stiffness[i][j] * (p[bending_1] * u[i] * u[j] + p[bending_2] * u[K + i] * u[K + j]);
                stretch += modes.stretching_stiffness[i][j] * u[2 * K + i] * u[2 * K + j];
            }
        S energy = 0.5 * squared * (squared * bending + p[stretching] * stretch);
        if constexpr (Strain != BeamStrain::linear) {
            // u_i' has the size l^(-3/2): the cubic term l^(-7/2), the quartic one l^(-5)
            constexpr BeamSlopeIntegrals<K> slope(modes);
            using std::sqrt;
            const auto third = inverse * inverse * inverse * sqrt(inverse);
            S cubic{}, quartic{};
            for (int a = 0; a < K; ++a)
                for (int b = 0; b < K; ++b) {
                    S stretches{};  // int u3' phi_a' phi_b'
                    for (int i = 0; i < K; ++i) stretches += slope.coupling[i][a][b] * u[2 * K + i];
                    const S pair = u[a] * u[b] + u[K + a] * u[K + b];
                    cubic += stretches * pair;
                    for (int c = 0; c < K; ++c)
                        for (int d = 0; d < K; ++d)
                            quartic += slope.quartic[a][b][c][d] * pair * (u[c] * u[d] + u[K + c] * u[K + d]);
                }
            S coupled = third * cubic, twice = 0.25 * squared * squared * inverse * quartic;
            if constexpr (Strain == BeamStrain::either) {
                coupled = coupled * p[coupling];
                twice = twice * p[coupling] * p[coupling];
            }
            energy += 0.5 * p[stretching] * (coupled + twice);
        }
        return energy;
    }

    /// int r r^T over the beam, with the body at its centre of mass, about the common centre of mass: the upper
    /// triangle of a symmetric 3 x 3 array. The deformed inertia is I + tr(S) E - S.
    static constexpr auto second_moments(const auto& u, const auto& p) {
        using std::sqrt;
        using S = std::remove_cvref_t<decltype(u[0] * p[0])>;
        const auto l = p[length];
        const auto root = sqrt(l), l2 = l * l;
        // first moments int r and second moments int r r^T
        Array<S, 3> first{};
        Array<Array<S, 3>, 3> second{};
        first[2] = S(0.5 * l2);
        second[2][2] = S(l2 * l / 3);
        for (int i = 0; i < K; ++i) {
            const S &u1 = u[i], &u2 = u[K + i], &u3 = u[2 * K + i];
            first[0] += root * modes.bending_mean[i] * u1;
            first[1] += root * modes.bending_mean[i] * u2;
            first[2] += root * modes.stretching_mean[i] * u3;
            second[0][0] += u1 * u1;
            second[0][1] += u1 * u2;
            second[1][1] += u2 * u2;
            second[0][2] += l * root * modes.bending_moment[i] * u1;
            second[1][2] += l * root * modes.bending_moment[i] * u2;
            second[2][2] += 2 * l * root * modes.stretching_moment[i] * u3 + u3 * u3;
            for (int j = 0; j < K; ++j) {
                second[0][2] += modes.product[i][j] * u1 * u[2 * K + j];
                second[1][2] += modes.product[i][j] * u2 * u[2 * K + j];
            }
        }
        for (int i = 0; i < 3; ++i) first[i] += p[body_mass] * p[centre_1 + i];
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) second[i][j] -= first[i] * first[j] / (p[body_mass] + l);
        return second;
    }

    /// The deformed inertia J(u), (2.5), about the common centre of mass: a symmetric 3 x 3 array.
    static constexpr auto inertia(const auto& u, const auto& p) {
        auto y = second_moments(u, p);
        const auto trace = y[0][0] + y[1][1] + y[2][2];
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) {
                y[i][j] = i == j ? p[inertia_1 + i] + trace - y[i][i] : -y[i][j];
                y[j][i] = y[i][j];
            }
        return y;
    }
};

/// Relative equilibria at a given angular speed omega > 0: critical points of V(u) - omega^2/2 n^T J(u) n over the
/// modes u and the axis n on the unit sphere. With a multiplier lambda for the sphere these are (2.6), J n = lambda n,
/// and (2.7) in its Galerkin form. Unknowns: n (3), u (3 K), lambda: the moment of inertia about the axis. n and -n are
/// one equilibrium, turning either way.
///
/// The axis has three coordinates and a multiplier, not two angles: angles of the sphere have poles, and there
/// solutions that are no equilibria.
template <int K, BeamStrain Strain = BeamStrain::linear>
struct RotatingBodyBeam : RotatingBodyBeamBase<K, Strain> {
    using Base = RotatingBodyBeamBase<K, Strain>;    ///< names the parameters
    static constexpr int n_angles = 0;               ///< the axis is a vector
    static constexpr int n_coordinates = 4 + 3 * K;  ///< n, u and lambda
    static constexpr int first_mode = 3;             ///< place of u among the coordinates
    static constexpr int multiplier = 3 + 3 * K;     ///< place of lambda

    /// n, u and lambda as groups of their own. Multihomogeneous numbers: 438 for K = 1 and 1,734 for K = 2 with the
    /// linear strain energy, 1,884 and 108,216 with the coupled one.
    static constexpr Array<int, n_coordinates> grouping = [] {
        Array<int, n_coordinates> y;
        for (int i = 0; i < n_coordinates; ++i) y[i] = i < first_mode ? 0 : i < multiplier ? 1 : 2;
        return y;
    }();

    /// The function whose critical points are the equilibria.
    constexpr auto potential(const auto&, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(x[0] * p[0])>;
        Array<S, 3> n;
        Array<S, 3 * K> u;
        S sphere(-1.0);
        for (int i = 0; i < 3; ++i) {
            n[i] = S(x[i]);
            sphere += x[i] * x[i];
        }
        for (int i = 0; i < u.size(); ++i) u[i] = S(x[first_mode + i]);
        const S form = detail::quadratic_form(Base::inertia(u, p), n);
        return Base::strain_energy(u, p) - 0.5 * p[Base::speed] * p[Base::speed] * (form - sphere * x[multiplier]);
    }
};

/// The angular speeds, rising, at which the body that spins about the axis of its undeformed beam begins to whirl, the
/// beam bent in the plane of the axes `plane` (1 or 2) and 3: pitchforks of RotatingBodyBeam, for both strain energies.
/// With the bending modes eliminated K u = omega^2 B u; directions in which B is not positive never whirl. The centre
/// of mass must lie on the axis. Throws InvalidArgument where it does not, where `plane` or a parameter is none, or
/// where the body's moments about the two axes are equal (then any small tilt is a relative equilibrium).
template <int K>
std::vector<double> whirl_speeds(const Array<double, RotatingBodyBeam<K>::n_parameters>& p, int plane) {
    using M = RotatingBodyBeam<K>;
    M::validate(p);
    require(plane == 1 || plane == 2, "plane", plane, "must be 1 or 2");
    require(p[M::centre_1] == 0 && p[M::centre_2] == 0, "centre", p[M::centre_1] == 0 ? p[M::centre_2] : p[M::centre_1],
            "must lie on the third axis");
    const auto& modes = M::modes;
    const double l = p[M::length], mass = p[M::body_mass] + l, along = p[M::body_mass] * p[M::centre_3] + 0.5 * l * l;
    const double transverse = p[M::inertia_1 + plane - 1] + l * l * l / 3 - along * along / mass,
                 difference = p[M::inertia_3] - transverse;
    require(difference != 0, "inertia_3", p[M::inertia_3],
            "must differ from the transverse moment about the centre of mass");
    Eigen::MatrixXd stiffness(K, K), b(K, K);
    Eigen::VectorXd product(K);  // of inertia, by each mode: -dJ_13/du
    for (int i = 0; i < K; ++i)
        product(i) = std::sqrt(l) * (l * modes.bending_moment[i] - modes.bending_mean[i] * along / mass);
    for (int i = 0; i < K; ++i)
        for (int j = 0; j < K; ++j) {
            stiffness(i, j) =
                p[plane == 1 ? M::bending_1 : M::bending_2] * modes.bending_stiffness[i][j] / (l * l * l * l);
            b(i, j) = (i == j) - l / mass * modes.bending_mean[i] * modes.bending_mean[j] +
                      product(i) * product(j) / difference;
        }
    const Eigen::VectorXd squares = equilibria::detail::generalized_eigenvalues(b, stiffness);
    std::vector<double> y;
    for (int k = K; k-- > 0;)
        if (squares(k) > 0) y.push_back(1 / std::sqrt(squares(k)));
    return y;
}

}  // namespace equilibria::mechanisms
