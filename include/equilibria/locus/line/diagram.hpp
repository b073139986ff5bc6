/// \file
/// Equilibria against one parameter: between two neighbouring events (folds and pitchforks, all of the line's) the
/// number of equilibria and their indices are constant, so each interval is enumerated once, in its middle, and every
/// equilibrium is followed by arc length to both ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/model/torus.hpp>

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

/// The equilibria for all values in [low, high] of the parameter number Active.
///
/// Throws InvalidArgument as find_events does.
template <Model M, int Active>
BifurcationDiagram<M> trace_diagram(const Parameters<M>& p, const Interval& range, const RunOptions& run = {},
                                    BranchOptions branch = {.first_step = 1e-3, .largest_step = 0.02}) {
    BifurcationDiagram<M> diagram;
    auto found = find_events<M, Active>(p, range, run);
    diagram.failed_paths = found.paths.failed;
    diagram.events = std::move(found.events);
    const auto [low, high] = range;
    std::vector<double> ends{low};
    for (const auto& e : diagram.events)
        if (e.value - ends.back() > 1e-9 * (high - low)) ends.push_back(e.value);
    if (high - ends.back() > 1e-9 * (high - low)) ends.push_back(high);

    using Problem = ModelProblem<M, Active>;
    using Point = BranchPoint<Problem>;
    const Problem problem(p);
    if (branch.parameter_weight == 0) branch.parameter_weight = 1 / (high - low);
    BranchStepper<Problem> stepper(problem, branch);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        Parameters<M> middle = p;
        middle[Active] = 0.5 * (ends[k] + ends[k + 1]);
        for (const auto& e : enumerate<M>(middle, run).equilibria) {
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
                            for (int i = 0; i < n_angles<M>; ++i) to(i) = wrap(to(i));
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
