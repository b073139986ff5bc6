/// \file
/// Equilibria against one parameter: between two neighbouring events (folds and pitchforks, all of the line's) the number
/// of equilibria and their indices are constant, so each interval is enumerated once, in its middle, and every
/// equilibrium is followed by arc length to both ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <equilibria/continuation/path.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line_events.hpp>
#include <equilibria/locus/model_problem.hpp>

namespace equilibria {

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
                                    const EnumerateOptions& options = {}, PathOptions path = {.first_step = 1e-3, .largest_step = 0.02}) {
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

    using Problem = ModelProblem<M, Active>;
    using Point = BranchPoint<Problem>;
    const Problem problem(p);
    if (path.parameter_weight == 0) path.parameter_weight = 1 / (high - low);
    PathStepper<Problem> stepper(problem, path);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        Parameters<M> middle = p;
        middle[Active] = 0.5 * (ends[k] + ends[k + 1]);
        for (const auto& e : enumerate<M>(middle, options).equilibria) {
            BranchPiece<M> piece{e.index, {{middle[Active], e.q}}};
            for (const int side : {-1, 1}) {
                const double end = side < 0 ? ends[k] : ends[k + 1];
                std::optional<Point> point = stepper.start(Problem::vector(e.q), middle[Active], side);
                std::vector<typename BranchPiece<M>::Point> half;
                while (point && half.size() < 100000) {
                    const auto next = stepper.advance(*point);
                    if (!next) break;
                    const bool turned = next->tangent.p * side <= 0;  // around a fold or a pitchfork
                    if (!turned && (next->p - end) * side < 0) {
                        half.push_back({next->p, Problem::unknowns(next->q)});
                        point = next;
                        continue;
                    }
                    Eigen::VectorXd last = point->q;
                    if (!turned) last += (end - point->p) / (next->p - point->p) * (next->q - point->q);
                    if (turned)  // the degenerate equilibrium itself
                        for (const auto& event : diagram.events) {
                            Eigen::VectorXd to = Problem::vector(event.q) - last;
                            for (int i = 0; i < n_angles<M>; ++i) to(i) = std::remainder(to(i), 2 * std::numbers::pi);
                            if (std::abs(event.value - end) > 1e-9 * (high - low) || to.cwiseAbs().maxCoeff() > 0.2)
                                continue;
                            last += to;
                        }
                    half.push_back({end, Problem::unknowns(last)});
                    break;
                }
                if (side < 0)
                    piece.points.insert(piece.points.begin(), half.rbegin(), half.rend());
                else
                    piece.points.insert(piece.points.end(), half.begin(), half.end());
            }
            diagram.pieces.push_back(std::move(piece));
        }
    }
    return diagram;
}

}  // namespace equilibria
