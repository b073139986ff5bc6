/// \file
/// Shape functions of a beam that is clamped at 0 and free at 1, at compile time: polynomials that are orthonormal in
/// L2, and the integrals of their products that an energy needs.
///
/// Everything here is a constant expression, since a model's potential must be one: so Gauss's nodes are found here,
/// and are not taken from boost::math::quadrature::gauss, whose functions no constant expression may call; a test holds
/// them against it. K = 14 is in use, with whirling speeds to 13 digits; many more shapes reach the compilers' limit of
/// steps in a constant expression. Sources: Hale and Townsend, Fast and accurate computation of Gauss-Legendre and
/// Gauss-Jacobi quadrature nodes and weights, SIAM J. Sci. Comput. 35 (2013); Gautschi, Orthogonal Polynomials:
/// Computation and Approximation (2004), section 2.2, for Stieltjes' procedure.
#pragma once

#include <numbers>

#include <equilibria/core/array.hpp>
#include <equilibria/core/constant_math.hpp>

namespace equilibria::mechanisms {

/// Bending shapes phi_0 .. phi_{K-1}, of degrees 2 to K + 1, with phi = phi' = 0 at 0, and stretching shapes psi_0 ..
/// psi_{K-1}, of degrees 1 to K, with psi = 0 at 0: z^2 and z times orthonormal polynomials for the weights z^4 and
/// z^2. The conditions at the free end are natural ones, which the energy brings along.
template <int K>
struct BeamModes {
    static_assert(K >= 1);
    using Vector = Array<double, K>;            ///< one of each shape
    using Matrix = Array<Array<double, K>, K>;  ///< of pairs of shapes

    /// A shape and its first two derivatives at a place z of [0, 1].
    struct Values {
        Vector value;   ///< of each shape
        Vector first;   ///< its first derivative
        Vector second;  ///< its second derivative
    };

    Vector bending_mean{};          ///< int phi_j
    Vector bending_moment{};        ///< int z phi_j
    Vector stretching_mean{};       ///< int psi_j
    Vector stretching_moment{};     ///< int z psi_j
    Matrix bending_stiffness{};     ///< int phi_i'' phi_j''
    Matrix stretching_stiffness{};  ///< int psi_i' psi_j'
    Matrix product{};               ///< int phi_i psi_j

    constexpr BeamModes() {
        for (int q = 0; q < nodes; ++q) {
            // Gauss's nodes on [-1, 1] by Newton's method from Tricomi's estimate
            double x = constant_math::cos(std::numbers::pi * (q + 0.75) / (nodes + 0.5)), slope = 0;
            for (int step = 0; step < 10; ++step) {
                double p = 1, before = 0;
                for (int n = 0; n < nodes; ++n) {
                    const double next = ((2 * n + 1) * x * p - n * before) / (n + 1);
                    before = p, p = next;
                }
                slope = nodes * (x * p - before) / (x * x - 1);
                x -= p / slope;
            }
            place_[q] = 0.5 * (1 + x);
            weight_[q] = 1 / ((1 - x * x) * slope * slope);
        }
        orthonormalise(bending_, 2);
        orthonormalise(stretching_, 1);
        for (int q = 0; q < nodes; ++q) {
            const double z = place_[q], w = weight_[q];
            const Values phi = bending(z), psi = stretching(z);
            for (int i = 0; i < K; ++i) {
                bending_mean[i] += w * phi.value[i];
                bending_moment[i] += w * z * phi.value[i];
                stretching_mean[i] += w * psi.value[i];
                stretching_moment[i] += w * z * psi.value[i];
                for (int j = 0; j < K; ++j) {
                    bending_stiffness[i][j] += w * phi.second[i] * phi.second[j];
                    stretching_stiffness[i][j] += w * psi.first[i] * psi.first[j];
                    product[i][j] += w * phi.value[i] * psi.value[j];
                }
            }
        }
    }

    /// Gauss's quadrature over [0, 1], exact to degree 4 K + 5: calls f(place, weight) for each node.
    constexpr void for_each_node(const auto& f) const {
        for (int q = 0; q < nodes; ++q) f(place_[q], weight_[q]);
    }
    constexpr Values bending(double z) const { return values(bending_, 2, z); }        ///< phi_j at z of [0, 1]
    constexpr Values stretching(double z) const { return values(stretching_, 1, z); }  ///< psi_j at z of [0, 1]

private:
    static constexpr int nodes = 2 * K + 3;

    /// p_0 = 1 / scale[0], scale[n + 1] p_{n+1} = (z - shift[n]) p_n - scale[n] p_{n-1}.
    struct Recurrence {
        Array<double, K + 1> shift, scale;
    };

    /// Stieltjes' procedure for the weight z^(2 power).
    constexpr void orthonormalise(Recurrence& r, int power) {
        Array<double, nodes> weight, p, before;
        double norm = 0;
        for (int q = 0; q < nodes; ++q) {
            weight[q] = weight_[q];
            for (int k = 0; k < 2 * power; ++k) weight[q] *= place_[q];
            p[q] = 1;
            norm += weight[q];
        }
        r.scale[0] = constant_math::sqrt(norm);
        for (int q = 0; q < nodes; ++q) p[q] /= r.scale[0];
        for (int n = 0; n < K; ++n) {
            for (int q = 0; q < nodes; ++q) r.shift[n] += weight[q] * place_[q] * p[q] * p[q];
            double square = 0;
            for (int q = 0; q < nodes; ++q) {
                const double next = (place_[q] - r.shift[n]) * p[q] - (n > 0 ? r.scale[n] * before[q] : 0);
                before[q] = p[q];
                p[q] = next;
                square += weight[q] * next * next;
            }
            r.scale[n + 1] = constant_math::sqrt(square);
            for (int q = 0; q < nodes; ++q) p[q] /= r.scale[n + 1];
        }
    }
    static constexpr Values values(const Recurrence& r, int power, double z) {
        Vector p, p1, p2;  // the orthonormal polynomials and their derivatives
        p[0] = 1 / r.scale[0];
        for (int n = 0; n + 1 < K; ++n) {
            const double c = n > 0 ? r.scale[n] : 0, d = z - r.shift[n];
            const int b = n > 0 ? n - 1 : 0;
            p[n + 1] = (d * p[n] - c * p[b]) / r.scale[n + 1];
            p1[n + 1] = (d * p1[n] + p[n] - c * p1[b]) / r.scale[n + 1];
            p2[n + 1] = (d * p2[n] + 2 * p1[n] - c * p2[b]) / r.scale[n + 1];
        }
        // times z^power
        const double f = power == 2 ? z * z : z, f1 = power == 2 ? 2 * z : 1, f2 = power == 2 ? 2 : 0;
        Values y;
        for (int n = 0; n < K; ++n) {
            y.value[n] = f * p[n];
            y.first[n] = f1 * p[n] + f * p1[n];
            y.second[n] = f2 * p[n] + 2 * f1 * p1[n] + f * p2[n];
        }
        return y;
    }

    Array<double, nodes> place_{}, weight_{};
    Recurrence bending_{}, stretching_{};
};

/// The integrals of products of slopes that a stretch of second order needs.
template <int K>
struct BeamSlopeIntegrals {
    using Matrix = typename BeamModes<K>::Matrix;  ///< of pairs of shapes
    Array<Matrix, K> coupling{};                   ///< int psi_i' phi_j' phi_k'
    Array<Array<Matrix, K>, K> quartic{};          ///< int phi_h' phi_i' phi_j' phi_k'

    /// By Gauss's quadrature, exact.
    constexpr explicit BeamSlopeIntegrals(const BeamModes<K>& modes) {
        modes.for_each_node([&](double z, double w) {
            const auto phi = modes.bending(z).first, psi = modes.stretching(z).first;
            for (int i = 0; i < K; ++i)
                for (int j = 0; j < K; ++j)
                    for (int k = 0; k < K; ++k) {
                        coupling[i][j][k] += w * psi[i] * phi[j] * phi[k];
                        for (int h = 0; h < K; ++h) quartic[h][i][j][k] += w * phi[h] * phi[i] * phi[j] * phi[k];
                    }
        });
    }
};

}  // namespace equilibria::mechanisms
