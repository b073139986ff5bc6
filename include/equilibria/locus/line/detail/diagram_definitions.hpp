/// \file
/// See locus/line/diagram.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/model/torus.hpp>

namespace equilibria {

namespace detail {

/// Symmetric: of a model with a potential.
template <bool Symmetric>
struct DiagramProblem : EquilibriumProblem {
    static constexpr bool symmetric = Symmetric;
    using EquilibriumProblem::EquilibriumProblem;
};

template <class Problem>
void trace_pieces(BifurcationDiagram<RuntimeUnknowns>& diagram, const SearchedModel& model,
                  const EquilibriaAt& equilibria, const RuntimeArray<double>& p, int active, const Interval& range,
                  const RunOptions& run, const BranchOptions& branch) {
    const auto [low, high] = range;
    std::vector<double> ends{low};
    for (const auto& e : diagram.events)
        if (e.value - ends.back() > 1e-9 * (high - low)) ends.push_back(e.value);
    if (high - ends.back() > 1e-9 * (high - low)) ends.push_back(high);

    using Point = BranchPoint<Problem>;
    const Problem problem(*model.functions, p, active);
    BranchStepper<Problem> stepper(problem, branch);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        RuntimeArray<double> middle = p;
        middle[active] = 0.5 * (ends[k] + ends[k + 1]);
        for (const auto& e : equilibria(middle, run)) {
            using Piece = BranchPiece<RuntimeUnknowns>;
            Piece piece{e.index, {{middle[active], e.q}}};
            for (const int side : {-1, 1}) {
                const double end = side < 0 ? ends[k] : ends[k + 1];
                std::optional<Point> point = stepper.start(eigen_vector(e.q), middle[active], side);
                std::vector<Piece::Point> half;
                while (point && half.size() < 100000) {
                    const auto next = stepper.advance(*point);
                    if (!next) break;
                    const bool turned = next->tangent.p * side <= 0;  // around a fold or a pitchfork
                    if (!turned && (next->p - end) * side < 0) {
                        half.push_back({next->p, runtime_array(next->q)});
                        point = next;
                        continue;
                    }
                    Eigen::VectorXd last = point->q;
                    if (!turned) last += (end - point->p) / (next->p - point->p) * (next->q - point->q);
                    if (turned)  // the degenerate equilibrium itself
                        for (const auto& event : diagram.events) {
                            Eigen::VectorXd to = eigen_vector(event.q) - last;
                            for (int i = 0; i < model.sizes().angles; ++i) to(i) = wrap(to(i));
                            if (std::abs(event.value - end) > 1e-9 * (high - low) || to.cwiseAbs().maxCoeff() > 0.2)
                                continue;
                            last += to;
                        }
                    half.push_back({end, runtime_array(last)});
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
}

}  // namespace detail

EQUILIBRIA_INLINE BifurcationDiagram<RuntimeUnknowns> trace_diagram(const SearchedModel& model,
                                                                    const EquilibriaAt& equilibria,
                                                                    const RuntimeArray<double>& p, int active,
                                                                    const Interval& range, const RunOptions& run,
                                                                    BranchOptions branch) {
    BifurcationDiagram<RuntimeUnknowns> diagram;
    auto found = find_events(model, p, active, range, run);
    diagram.failed_paths = found.paths.failed;
    diagram.events = std::move(found.events);
    if (branch.parameter_weight == 0) branch.parameter_weight = 1 / (range.high - range.low);
    if (model.has_potential())
        detail::trace_pieces<detail::DiagramProblem<true>>(diagram, model, equilibria, p, active, range, run, branch);
    else
        detail::trace_pieces<detail::DiagramProblem<false>>(diagram, model, equilibria, p, active, range, run, branch);
    return diagram;
}

}  // namespace equilibria
