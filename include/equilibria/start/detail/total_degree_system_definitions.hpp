/// \file
/// See start/total_degree_system.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <equilibria/start/total_degree_system.hpp>

namespace equilibria {

namespace detail {
/// Uniform on the unit circle; for the reflected start on the arc from 100 to 260 degrees, generic as well: there
/// chains need 11 to 22 steps a path, near the positive real axis 60 (measured, n = 4 and 6).
EQUILIBRIA_INLINE std::complex<double> draw_gamma(TotalDegreeKind kind, Generator& generator) {
    if (kind != TotalDegreeKind::reflected) return unit_complex(generator);
    return std::polar(1.0, uniform(generator, 100, 260) * std::numbers::pi / 180);
}
}  // namespace detail

EQUILIBRIA_INLINE TotalDegreeSystem::TotalDegreeSystem(TotalDegreeKind kind, const RuntimeSizes& sizes,
                                                       std::span<const int> degrees, std::span<const double> scale,
                                                       Generator& generator)
    : kind_(kind), degrees_(degrees.begin(), degrees.end()), harmonics_(degrees.size()), points_(degrees.size()) {
    const std::complex<double> gamma = detail::draw_gamma(kind, generator);
    for (int i = 0; i < sizes.unknowns; ++i) {
        if (i >= sizes.angles)
            build_coordinate(i, generator);
        else if (kind == TotalDegreeKind::reflected)
            build_reflected(i, generator);
        else
            build_lines(i, generator);
        double size = 0;
        for (const auto& g : harmonics_[at(i)]) size = std::max(size, std::abs(g));
        for (auto& g : harmonics_[at(i)]) g *= gamma * scale[at(i)] / size;
    }
}

/// Multiplies the trigonometric polynomial G_i by a c + b s - e: products of cosines and sines are sums of those of the
/// neighbouring multiples.
EQUILIBRIA_INLINE void TotalDegreeSystem::multiply(int i, const Line& line) {
    const auto& [a, b, e] = line;
    const auto half_a = 0.5 * a, half_b = 0.5 * b;
    const auto old = std::exchange(harmonics_[at(i)], {});
    allocate(i);
    const auto before = [&](int code) { return old[static_cast<std::size_t>(code + degree(i))]; };
    harmonic(i, 0) -= e * before(0);
    if (degree(i) > 0) harmonic(i, 1) += a * before(0), harmonic(i, -1) += b * before(0);
    for (int k = 1; k <= degree(i); ++k) {
        const auto cosine = before(k), sine = before(-k);
        harmonic(i, k) -= e * cosine;
        harmonic(i, -k) -= e * sine;
        harmonic(i, k - 1) += half_a * cosine + half_b * sine;
        if (k > 1) harmonic(i, 1 - k) += half_a * sine - half_b * cosine;
        if (k == degree(i)) break;  // G_i has no more than its degree
        harmonic(i, k + 1) += half_a * cosine - half_b * sine;
        harmonic(i, -k - 1) += half_a * sine + half_b * cosine;
    }
}

EQUILIBRIA_INLINE void TotalDegreeSystem::build_reflected(int i, Generator& generator) {
    allocate(i);
    harmonic(i, -1) = 1;
    points_[at(i)] = {{1.0, 0.0}, {-1.0, 0.0}};
    for (int k = 1; k < degree(i); ++k) {
        const std::complex<double> kappa = 0.7 * unit_complex(generator);
        multiply(i, {1.0, 0.0, kappa});
        const std::complex<double> s = std::sqrt(1.0 - kappa * kappa);
        points_[at(i)].push_back({kappa, s});
        points_[at(i)].push_back({kappa, -s});
    }
}

/// The line cos(phi) c + sin(phi) s = e meets the circle at the angles phi +- arccos(e), all three complex.
EQUILIBRIA_INLINE void TotalDegreeSystem::build_lines(int i, Generator& generator) {
    allocate(i);
    harmonic(i, 0) = 1;
    for (int k = 0; k < degree(i); ++k) {
        const std::complex<double> e = 0.7 * unit_complex(generator);
        // a statement a draw: the order of evaluation of arguments differs between compilers
        const double turn = 2 * std::numbers::pi * uniform(generator);
        const std::complex<double> phi(turn, uniform(generator, -0.4, 0.4));
        const std::complex<double> a = std::cos(phi), b = std::sin(phi), root = std::sqrt(1.0 - e * e);
        multiply(i, {a, b, e});
        points_[at(i)].push_back({a * e - b * root, b * e + a * root});
        points_[at(i)].push_back({a * e + b * root, b * e - a * root});
    }
}

/// x^d - e^d, with e near the unit circle.
EQUILIBRIA_INLINE void TotalDegreeSystem::build_coordinate(int i, Generator& generator) {
    allocate(i);
    const int d = degree(i);
    const double size = uniform(generator, 0.8, 1.2);
    const std::complex<double> e = size * unit_complex(generator);
    harmonic(i, d) = 1;
    harmonic(i, 0) = -std::pow(e, d);
    for (int k = 0; k < d; ++k) points_[at(i)].push_back({e * std::polar(1.0, 2 * std::numbers::pi * k / d), 0.0});
}

EQUILIBRIA_INLINE std::vector<StartForms::Term> TotalDegreeSystem::terms() const {
    std::vector<StartForms::Term> y;
    for (int i = 0; i < static_cast<int>(degrees_.size()); ++i)
        for (int code = -degree(i); code <= degree(i); ++code)
            if (const auto& a = coefficient(i, code); a != 0.0) y.push_back({i, code, a});
    return y;
}

}  // namespace equilibria
