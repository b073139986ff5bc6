// The curves of a plane of constant ratio, cut at their cusps into pieces with as many points each, so that pieces of
// neighbouring planes can be laid side by side (sheets.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/torus.hpp>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace fold_surface {

using Chain = equilibria::mechanisms::TwoLinkChain;
using Locus = equilibria::Locus<Chain>;
using equilibria::CurveEnd;
using equilibria::SingularityKind;
using equilibria::Window;

/// A degenerate equilibrium: a point of a plane, with its angles in radians.
struct Vertex {
    double alpha, omega;
    std::array<double, 2> theta;
};

/// With the window as the unit of length and the half turn as that of angles. The mirror image of `b` where mirror is
/// -1.
inline double distance(const Vertex& a, const Vertex& b, const Window& window, double mirror = 1) {
    const auto turn = [&](int i) { return equilibria::wrap(a.theta[i] - mirror * b.theta[i]) / std::numbers::pi; };
    return std::hypot(std::hypot((a.alpha - b.alpha) / window.width(), (a.omega - b.omega) / window.height()),
                      std::hypot(turn(0), turn(1)));
}

/// What of a curve of a plane lies between two of its cusps, or between a cusp and an end.
struct Piece {
    struct End {
        CurveEnd why;
        int cusp = -1;  ///< its number in the plane; -1: none, the curve itself ends
        bool like(const End& b) const { return cusp >= 0 || b.cusp >= 0 ? cusp >= 0 && b.cusp >= 0 : why == b.why; }
    };
    SingularityKind kind;
    std::array<End, 2> ends;
    std::vector<Vertex> points;

    bool closed() const { return ends[0].cusp < 0 && ends[0].why == CurveEnd::closed; }
    Piece reversed() const { return {kind, {ends[1], ends[0]}, {points.rbegin(), points.rend()}}; }
};

/// `points`, of which there are at least two, as `count` at equal distances.
inline std::vector<Vertex> resampled(const std::vector<Vertex>& points, int count, const Window& window) {
    std::vector<double> length{0};
    for (std::size_t k = 1; k < points.size(); ++k)
        length.push_back(length.back() + distance(points[k - 1], points[k], window));
    std::vector<Vertex> y;
    std::size_t at = 0;
    for (int k = 0; k < count; ++k) {
        const double target = length.back() * k / (count - 1);
        while (at + 2 < points.size() && length[at + 1] < target) ++at;
        const double step = length[at + 1] - length[at];
        const double part = step > 0 ? std::clamp((target - length[at]) / step, 0., 1.) : 0;
        const Vertex &a = points[at], &b = points[at + 1];
        const auto mix = [&](double u, double v) { return u + part * (v - u); };
        const auto turned = [&](int i) { return a.theta[i] + part * equilibria::wrap(b.theta[i] - a.theta[i]); };
        y.push_back({mix(a.alpha, b.alpha), mix(a.omega, b.omega), {turned(0), turned(1)}});
    }
    return y;
}

/// The cusps of a locus by the points of the curve that they are.
inline std::map<std::size_t, int> cusps_on(const equilibria::LocusCurve<Chain>& curve, const Locus& locus) {
    constexpr double tolerance = 1e-8;
    std::map<std::size_t, int> found;
    if (curve.kind != SingularityKind::fold) return found;
    const auto cusps = locus.of(SingularityKind::cusp);
    for (std::size_t c = 0; c < cusps.size(); ++c)
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const auto &p = curve.points[k], &q = cusps[c];
            if (std::hypot((p.x() - q.x()) / locus.window.width(), (p.y() - q.y()) / locus.window.height()) <
                    tolerance &&
                (equilibria::same_unknowns<Chain>(p.q, q.q, 1e-6) ||
                 equilibria::same_unknowns<Chain>(p.q, equilibria::mirrored<Chain>(q.q), 1e-6))) {
                found.emplace(k, static_cast<int>(c));
                break;
            }
        }
    return found;
}

inline std::vector<Piece> pieces(const Locus& locus) {
    constexpr int samples = 61;
    std::vector<Piece> all;
    for (const auto& curve : locus.curves) {
        if (curve.points.size() < 2) continue;
        const auto cusps = cusps_on(curve, locus);
        std::vector<Piece> own{{curve.kind, {Piece::End{curve.ends[0]}, Piece::End{curve.ends[1]}}, {}}};
        for (std::size_t k = 0; k < curve.points.size(); ++k) {
            const auto& p = curve.points[k];
            own.back().points.push_back({p.x(), p.y(), {p.q[0], p.q[1]}});
            const auto cusp = cusps.find(k);
            if (cusp == cusps.end() || k == 0 || k + 1 == curve.points.size()) continue;
            own.push_back({curve.kind,
                           {Piece::End{curve.ends[0], cusp->second}, own.back().ends[1]},
                           {own.back().points.back()}});
            own[own.size() - 2].ends[1].cusp = cusp->second;
        }
        if (const auto first = cusps.find(0); first != cusps.end() && curve.ends[0] == CurveEnd::closed) {
            own.front().ends[0].cusp = own.back().ends[1].cusp = first->second;
        } else if (own.size() > 1 && curve.ends[0] == CurveEnd::closed) {  // begins within a piece
            Piece& last = own.back();
            last.points.insert(last.points.end(), own.front().points.begin() + 1, own.front().points.end());
            last.ends[1] = own.front().ends[1];
            own.erase(own.begin());
        }
        for (Piece& piece : own) {
            piece.points = resampled(piece.points, samples, locus.window);
            all.push_back(std::move(piece));
        }
    }
    return all;
}

}  // namespace fold_surface
