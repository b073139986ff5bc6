/// \file
/// Equilibria against one parameter: between two neighbouring events (folds and pitchforks, all of the line's) the number
/// of equilibria and their indices are constant, so each interval is enumerated once, in its middle, and every
/// equilibrium is followed by arc length to both ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <equilibria/continuation/arc_length.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line_events.hpp>

namespace equilibria {

/// A branch F(q, p) = 0 as a curve y = (q, p_active).
template <Model M, int Active>
struct BranchCurve {
    static constexpr int n = n_unknowns<M>;
    static constexpr int unknowns = n + 1;
    using Vector = Eigen::Matrix<double, unknowns, 1>;

    Parameters<M> parameters;  ///< the active one is not read

    Unknowns<M> q(const Vector& y) const {
        Unknowns<M> u;
        for (int i = 0; i < n; ++i) u[i] = y(i);
        return u;
    }
    Parameters<M> p(const Vector& y) const {
        Parameters<M> values = parameters;
        values[Active] = y(n);
        return values;
    }
    Eigen::Matrix<double, n, 1> residual(const Vector& y) const {
        const auto f = equations<M, double>(q(y), p(y));
        Eigen::Matrix<double, n, 1> r;
        for (int i = 0; i < n; ++i) r(i) = f[i];
        return r;
    }
    Eigen::Matrix<double, n, unknowns> jacobian(const Vector& y) const {
        Eigen::Matrix<double, n, unknowns> j;
        j.template leftCols<n>() = equilibria::jacobian<M, double>(q(y), p(y));
        const auto fp = parameter_derivative<M, double>(q(y), p(y), Active);
        for (int i = 0; i < n; ++i) j(i, n) = fp[i];
        return j;
    }
};

/// A piece of a branch between two events.
template <Model M>
struct BranchPiece {
    int index;  ///< of its equilibria
    struct Point {
        double parameter;
        Unknowns<M> q;
    };
    std::vector<Point> points;  ///< the parameter increases
};

template <Model M>
struct BifurcationDiagram {
    std::vector<BranchPiece<M>> pieces;
    std::vector<LineEvent<M>> events;  ///< by parameter
    std::uint64_t failed_paths = 0;
};

/// The equilibria for all values in [low, high] of the parameter number Active. Fixed: the number of another parameter,
/// in whose neighbourhood the generic line of the fold system is taken.
///
/// Throws InvalidArgument for an interval that is empty, reversed or not finite, and for options with a checkpoint or a
/// cancel: these are of one enumeration, and a diagram takes many.
template <Model M, int Active, int Fixed>
BifurcationDiagram<M> trace_diagram(const Parameters<M>& p, double low, double high,
                                    const EnumerateOptions& options = {}, ArcLengthOptions arc_length = {}) {
    require_finite(p, "parameters");
    require(std::isfinite(low) && std::isfinite(high) && low < high, "interval", to_text(low) + ":" + to_text(high),
            "must be finite and run from the smaller to the larger value");
    require(options.checkpoint.empty(), "checkpoint", options.checkpoint, "must be empty: it keeps a single enumeration");
    require(options.cancel == nullptr, "cancel", "given", "must be empty: a diagram cannot be cancelled");
    BifurcationDiagram<M> diagram;
    const double around = 0.3 * std::max(std::abs(p[Fixed]), 1e-3);
    const LineSolver<M, Active> solver(p, Fixed, p[Fixed] - around, p[Fixed] + around, options);
    for (const auto& e : solver.folds(p[Fixed], diagram.failed_paths))
        if (e.value >= low && e.value <= high) diagram.events.push_back(e);
    for (const auto& e : solver.pitchforks(p[Fixed], low, high)) diagram.events.push_back(e);
    std::sort(diagram.events.begin(), diagram.events.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    std::vector<double> ends{low};
    for (const auto& e : diagram.events)
        if (e.value - ends.back() > 1e-9 * (high - low)) ends.push_back(e.value);
    if (high - ends.back() > 1e-9 * (high - low)) ends.push_back(high);

    using Curve = BranchCurve<M, Active>;
    const Curve curve{p};
    typename Curve::Vector scale = Curve::Vector::Ones();
    scale(Curve::n) = high - low;
    const ArcLengthStepper<Curve> stepper(curve, scale, arc_length);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        Parameters<M> middle = p;
        middle[Active] = 0.5 * (ends[k] + ends[k + 1]);
        for (const auto& e : enumerate<M>(middle, options).equilibria) {
            typename Curve::Vector y0;
            for (int i = 0; i < Curve::n; ++i) y0(i) = e.q[i];
            y0(Curve::n) = middle[Active];
            std::vector<typename Curve::Vector> points{y0};
            for (const int side : {-1, 1}) {
                const double end = side < 0 ? ends[k] : ends[k + 1];
                auto state = stepper.start(y0, 1);
                if (!state) continue;
                if (state->tangent(Curve::n) * side < 0) state->tangent = -state->tangent;
                std::vector<typename Curve::Vector> half;
                while (half.size() < 100000) {
                    const auto next = stepper.advance(*state);
                    if (!next) break;
                    const bool turned = next->tangent(Curve::n) * side <= 0;  // around a fold or a pitchfork
                    if (turned || (next->y(Curve::n) - end) * side >= 0) {
                        typename Curve::Vector last = state->y;
                        if (!turned)
                            last += (end - state->y(Curve::n)) / (next->y(Curve::n) - state->y(Curve::n)) *
                                    (next->y - state->y);
                        last(Curve::n) = end;
                        if (turned)  // the degenerate equilibrium itself
                            for (const auto& event : diagram.events) {
                                double distance = 0;
                                for (int i = 0; i < Curve::n; ++i)
                                    distance = std::max(distance,
                                                        i < n_angles<M>
                                                            ? std::abs(std::remainder(event.q[i] - last(i), 2 * std::numbers::pi))
                                                            : std::abs(event.q[i] - last(i)));
                                if (std::abs(event.value - end) > 1e-9 * (high - low) || distance > 0.2) continue;
                                for (int i = 0; i < Curve::n; ++i)
                                    last(i) += i < n_angles<M> ? std::remainder(event.q[i] - last(i), 2 * std::numbers::pi)
                                                               : event.q[i] - last(i);
                            }
                        half.push_back(last);
                        break;
                    }
                    half.push_back(next->y);
                    state = next;
                }
                if (side < 0)
                    points.insert(points.begin(), half.rbegin(), half.rend());
                else
                    points.insert(points.end(), half.begin(), half.end());
            }
            BranchPiece<M> piece{e.index, {}};
            for (const auto& y : points) piece.points.push_back({y(Curve::n), curve.q(y)});
            diagram.pieces.push_back(std::move(piece));
        }
    }
    return diagram;
}

}  // namespace equilibria
