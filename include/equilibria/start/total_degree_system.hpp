/// \file
/// Total-degree start systems. Equation i, of total degree d_i in (cos, sin) and the coordinates, gets a start
/// polynomial G_i of degree d_i in unknown i alone. For an angle it meets the circle in 2 d_i points, for a coordinate
/// it has d_i roots: the product is the total degree (Bezout number) of the polynomial system with its circle
/// equations, and the paths of (1-t) gamma G + t F from these points reach every isolated solution of F = 0.
///
/// Two kinds. General: G_i is a product of d_i random lines. Reflected: G_i = s_i prod (c_i - kappa_k), odd as F is, so
/// that theta -> -theta maps paths to paths: one path of each pair is tracked, and the 2^n points with every s_i = 0
/// are solutions at every t.
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/algebra/multihomogeneous.hpp>
#include <equilibria/core/random.hpp>

namespace equilibria {

/// The two kinds of total-degree start systems.
enum class TotalDegreeKind {
    general,   ///< random lines
    reflected  ///< odd under theta -> -theta
};

/// One start point of one unknown: (c, s) of an angle, or (x, 0).
struct StartCoordinate {
    std::complex<double> c, s;
};

/// G_1 .. G_n and their roots.
template <Model M>
class TotalDegreeSystem {
public:
    using F = Formulation<M>;

    /// `scale[i]` multiplies G_i, so that it weighs in the homotopy as equation i does.
    TotalDegreeSystem(TotalDegreeKind kind, const Array<double, n_unknowns<M>>& scale, Generator& generator)
        : kind_(kind) {
        const std::complex<double> gamma = draw_gamma(kind, generator);
        for (int i = 0; i < n_unknowns<M>; ++i) {
            if (i >= n_angles<M>)
                build_coordinate(i, generator);
            else if (kind == TotalDegreeKind::reflected)
                build_reflected(i, generator);
            else
                build_lines(i, generator);
            double size = 0;
            for (const auto& g : harmonics_[i]) size = std::max(size, std::abs(g));
            for (auto& g : harmonics_[i]) g *= gamma * scale[i] / size;
        }
    }

    /// The coefficient in G_i of the factor with this code (see Monomial): cos k, sin k, or x^k of unknown i.
    std::complex<double> coefficient(int i, int code) const {
        return harmonics_[i][static_cast<std::size_t>(code + F::degrees[i])];
    }
    /// The start points of unknown i. Reflected: first the two with s = 0, then pairs (c, s), (c, -s).
    const std::vector<StartCoordinate>& points(int i) const { return points_[i]; }
    TotalDegreeKind kind() const { return kind_; }

private:
    /// Uniform on the unit circle; for the reflected start on the arc from 100 to 260 degrees, generic as well: there
    /// chains need 11 to 22 steps a path, near the positive real axis 60 (measured, n = 4 and 6).
    static std::complex<double> draw_gamma(TotalDegreeKind kind, Generator& generator) {
        if (kind != TotalDegreeKind::reflected) return unit_complex(generator);
        return std::polar(1.0, uniform(generator, 100, 260) * std::numbers::pi / 180);
    }

    using Line = Array<std::complex<double>, 3>;  // a c + b s - e

    std::complex<double>& harmonic(int i, int code) {
        return harmonics_[i][static_cast<std::size_t>(code + F::degrees[i])];
    }
    void allocate(int i) { harmonics_[i].assign(static_cast<std::size_t>(2 * F::degrees[i] + 1), 0.0); }

    /// Multiplies the trigonometric polynomial G_i by a c + b s - e.
    void multiply(int i, const Line& line) {
        using Polynomial = TrigonometricPolynomial<1, 0, std::complex<double>>;
        using Basis = Polynomial::Basis;
        Polynomial g, factor;
        for (int k = -F::degrees[i]; k <= F::degrees[i]; ++k) g += Polynomial(Basis::single(0, k), harmonic(i, k));
        factor += Polynomial(Basis::single(0, 1), line[0]);
        factor += Polynomial(Basis::single(0, -1), line[1]);
        factor += Polynomial(-line[2]);
        allocate(i);
        const Polynomial product = g * factor;
        for (const auto& t : product.terms()) harmonic(i, t.monomial.code(0)) = t.coefficient;
    }

    void build_reflected(int i, Generator& generator) {
        allocate(i);
        harmonic(i, -1) = 1;
        points_[i] = {{1.0, 0.0}, {-1.0, 0.0}};
        for (int k = 1; k < F::degrees[i]; ++k) {
            const std::complex<double> kappa = 0.7 * unit_complex(generator);
            multiply(i, {1.0, 0.0, kappa});
            const std::complex<double> s = std::sqrt(1.0 - kappa * kappa);
            points_[i].push_back({kappa, s});
            points_[i].push_back({kappa, -s});
        }
    }

    /// The line cos(phi) c + sin(phi) s = e meets the circle at the angles phi +- arccos(e), all three complex.
    void build_lines(int i, Generator& generator) {
        allocate(i);
        harmonic(i, 0) = 1;
        for (int k = 0; k < F::degrees[i]; ++k) {
            const std::complex<double> e = 0.7 * unit_complex(generator);
            // a statement a draw: the order of evaluation of arguments differs between compilers
            const double turn = 2 * std::numbers::pi * uniform(generator);
            const std::complex<double> phi(turn, uniform(generator, -0.4, 0.4));
            const std::complex<double> a = std::cos(phi), b = std::sin(phi), root = std::sqrt(1.0 - e * e);
            multiply(i, {a, b, e});
            points_[i].push_back({a * e - b * root, b * e + a * root});
            points_[i].push_back({a * e + b * root, b * e - a * root});
        }
    }

    /// x^d - e^d, with e near the unit circle.
    void build_coordinate(int i, Generator& generator) {
        allocate(i);
        const int d = F::degrees[i];
        const double size = uniform(generator, 0.8, 1.2);
        const std::complex<double> e = size * unit_complex(generator);
        harmonic(i, d) = 1;
        harmonic(i, 0) = -std::pow(e, d);
        for (int k = 0; k < d; ++k) points_[i].push_back({e * std::polar(1.0, 2 * std::numbers::pi * k / d), 0.0});
    }

    TotalDegreeKind kind_;
    Array<std::vector<std::complex<double>>, n_unknowns<M>> harmonics_;
    Array<std::vector<StartCoordinate>, n_unknowns<M>> points_;
};

}  // namespace equilibria
