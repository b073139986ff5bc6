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

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/evaluation/start_forms.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// The two kinds of total-degree start systems.
enum class TotalDegreeKind {
    general,   ///< random lines
    reflected  ///< odd under theta -> -theta
};

/// One start point of one unknown: (c, s) of an angle, or (x, 0).
struct StartCoordinate {
    std::complex<double> c;  ///< cosine, or coordinate
    std::complex<double> s;  ///< sine; 0 of a coordinate
};

/// G_1 .. G_n and their roots.
class TotalDegreeSystem {
public:
    /// degrees: d_i, at least 1. scale[i] multiplies G_i, so that it weighs in the homotopy as equation i does.
    TotalDegreeSystem(TotalDegreeKind kind, const RuntimeSizes& sizes, std::span<const int> degrees,
                      std::span<const double> scale, Generator& generator);

    /// The coefficient in G_i of the factor with this code (see Monomial): cos k, sin k, or x^k of unknown i.
    std::complex<double> coefficient(int i, int code) const {
        return harmonics_[at(i)][static_cast<std::size_t>(code + degree(i))];
    }
    /// Those that are not 0, as what the start adds to a homotopy.
    std::vector<StartForms::Term> terms() const;
    /// The start points of unknown i. Reflected: first the two with s = 0, then pairs (c, s), (c, -s).
    const std::vector<StartCoordinate>& points(int i) const { return points_[at(i)]; }
    TotalDegreeKind kind() const { return kind_; }  ///< general or reflected

private:
    using Line = std::complex<double>[3];  // a c + b s - e

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    int degree(int i) const { return degrees_[at(i)]; }
    std::complex<double>& harmonic(int i, int code) {
        return harmonics_[at(i)][static_cast<std::size_t>(code + degree(i))];
    }
    void allocate(int i) { harmonics_[at(i)].assign(static_cast<std::size_t>(2 * degree(i) + 1), 0.0); }
    void multiply(int i, const Line& line);
    void build_reflected(int i, Generator& generator);
    void build_lines(int i, Generator& generator);
    void build_coordinate(int i, Generator& generator);

    TotalDegreeKind kind_;
    std::vector<int> degrees_;
    std::vector<std::vector<std::complex<double>>> harmonics_;
    std::vector<std::vector<StartCoordinate>> points_;
};

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/start/detail/total_degree_system_definitions.hpp>
#endif
