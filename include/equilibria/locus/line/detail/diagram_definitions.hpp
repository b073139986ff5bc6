/// \file
/// See locus/line/diagram.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch_stepper.hpp>
#include <equilibria/core/eigen_copies.hpp>
#include <equilibria/locus/line/coordinate_sizes.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/locus/line/model_problem.hpp>
#include <equilibria/model/torus.hpp>

namespace equilibria {

namespace detail {

EQUILIBRIA_INLINE std::string diagram_argument(std::size_t pieces, std::uint64_t unfollowed, std::uint64_t unplaced,
                                               std::uint64_t unmet) {
    std::ostringstream out;
    out << pieces << " branches between the events, ";
    if (unfollowed > 0)
        out << unfollowed << " ENDS OF THEM NOT REACHED";
    else
        out << "all followed to both ends";
    out << "; " << unplaced << " equilibria of other enumerations lie on none, and " << unmet
        << " branches pass none of those";
    return out.str();
}

/// Equilibria with each coordinate in the unit of its size. Its tangent is factored with pivoting throughout: that of a
/// saddle may have a zero diagonal.
class DiagramProblem : public EquilibriumProblem {
public:
    static constexpr bool symmetric = false;
    DiagramProblem(const ModelDerivatives<>& model, const RuntimeArray<double>& parameters, int active,
                   const std::vector<double>& sizes)
        : EquilibriumProblem(model, parameters, active), weights_(static_cast<Eigen::Index>(sizes.size())) {
        for (Eigen::Index i = 0; i < weights_.size(); ++i)
            weights_(i) = 1 / (sizes[static_cast<std::size_t>(i)] * sizes[static_cast<std::size_t>(i)]);
    }
    Eigen::VectorXd weights(const Eigen::VectorXd&) const { return weights_; }

private:
    Eigen::VectorXd weights_;
};

/// Follows the equilibria of each interval to its ends.
class DiagramTracer {
public:
    DiagramTracer(BifurcationDiagram<RuntimeUnknowns>& diagram, const SearchedModel& model,
                  const EquilibriaAt& equilibria, const RuntimeArray<double>& p, int active, const Interval& range,
                  const RunOptions& run)
        : diagram_(diagram), model_(model), p_(p), active_(active), range_(range) {
        for (const EventGap& gap : diagram.search.intervals) {
            first_.push_back(equilibria(at(gap.at), run));
            second_.push_back(equilibria(at(gap.also_at), run));
        }
        find_sizes();
    }

    void run(const BranchOptions& branch) {
        const DiagramProblem problem(*model_.functions, p_, active_, sizes_);
        Stepper stepper(problem, branch);
        for (std::size_t k = 0; k < first_.size(); ++k) {
            const EventGap& gap = diagram_.search.intervals[k];
            const std::size_t begin = diagram_.pieces.size();
            for (const auto& e : first_[k]) add_piece(stepper, gap, e, gap.at);
            std::vector<char> met(diagram_.pieces.size() - begin, 0);
            for (const auto& e : second_[k]) {
                bool placed = false;
                for (std::size_t i = 0; i < met.size() && !placed; ++i)
                    if (!met[i] && passes(stepper, diagram_.pieces[begin + i], e.q, gap.also_at)) {
                        met[i] = 1;
                        placed = true;
                    }
                if (placed) continue;
                ++diagram_.unplaced;
                add_piece(stepper, gap, e, gap.also_at);
            }
            for (std::size_t i = 0; i < met.size(); ++i) {
                const auto& points = diagram_.pieces[begin + i].points;
                diagram_.unmet += !met[i] && points.back().parameter >= gap.also_at;
            }
        }
        for (const auto& piece : diagram_.pieces)
            for (const PieceEnd end : piece.ends) diagram_.unfollowed += end == PieceEnd::stopped;
    }

private:
    using Stepper = BranchStepper<DiagramProblem>;
    using Point = BranchPoint<DiagramProblem>;
    using Piece = BranchPiece<RuntimeUnknowns>;
    using Equilibria = std::vector<Equilibrium<RuntimeUnknowns>>;
    using Event = LineEvent<RuntimeUnknowns>;
    /// How many times as far out as the largest equilibrium a branch that goes to infinity is followed.
    static constexpr double far = 10;

    RuntimeArray<double> at(double value) const {
        RuntimeArray<double> p = p_;
        p[active_] = value;
        return p;
    }
    void find_sizes() {
        const auto& intervals = diagram_.search.intervals;
        sizes_.assign(static_cast<std::size_t>(model_.unknowns()), 1);
        if (model_.sizes().coordinates == 0 || intervals.empty()) return;
        std::vector<RuntimeArray<double>> equilibria;
        for (const auto* all : {&first_, &second_})
            for (const Equilibria& there : *all)
                for (const auto& e : there) equilibria.push_back(e.q);
        std::ranges::copy(coordinate_sizes(model_, at(intervals.front().at), equilibria),
                          sizes_.begin() + model_.sizes().angles);
    }

    void add_piece(Stepper& stepper, const EventGap& gap, const Equilibrium<RuntimeUnknowns>& e, double from) {
        Piece piece{e.index, {{from, e.q}}, {}};
        for (const int side : {-1, 1}) {
            auto [half, end] = follow(stepper, gap, e.q, from, side);
            piece.ends[side < 0 ? 0 : 1] = end;
            if (side < 0)
                piece.points.insert(piece.points.begin(), half.rbegin(), half.rend());
            else
                piece.points.insert(piece.points.end(), half.begin(), half.end());
        }
        diagram_.pieces.push_back(std::move(piece));
    }

    bool is_at(const Event& event, double end) const { return std::abs(event.value - end) <= 1e-9 * range_.width(); }
    bool has_event(double end, CriticalKind kind) const {
        return std::any_of(diagram_.events.begin(), diagram_.events.end(),
                           [&](const Event& event) { return event.kind == kind && is_at(event, end); });
    }
    /// The increment to the degenerate equilibrium at the end that is next to q, if there is one.
    std::optional<Eigen::VectorXd> to_event(const Eigen::VectorXd& q, double end) const {
        std::optional<Eigen::VectorXd> nearest;
        double distance = 0.2;
        for (const auto& event : diagram_.events) {
            if (!event.has_equilibrium() || !is_at(event, end)) continue;
            Eigen::VectorXd to = eigen_vector(event.q) - q;
            for (int i = 0; i < model_.sizes().angles; ++i) to(i) = wrap(to(i));
            const double length = scaled(to);
            if (length < distance) distance = length, nearest = to;
        }
        return nearest;
    }
    /// The largest entry, each in its unit.
    double scaled(const Eigen::VectorXd& d) const {
        double y = 0;
        for (Eigen::Index i = 0; i < d.size(); ++i)
            y = std::max(y, std::abs(d(i)) / sizes_[static_cast<std::size_t>(i)]);
        return y;
    }
    bool is_far(const Eigen::VectorXd& q) const {
        for (int i = model_.sizes().angles; i < q.size(); ++i)
            if (std::abs(q(i)) > far * sizes_[static_cast<std::size_t>(i)]) return true;
        return false;
    }

    /// The points behind q on one side, up to the end of the interval.
    std::pair<std::vector<Piece::Point>, PieceEnd> follow(Stepper& stepper, const EventGap& gap,
                                                          const RuntimeArray<double>& q, double from, int side) const {
        const double end = side < 0 ? gap.low : gap.high;
        const bool at_range = std::abs(end - (side < 0 ? range_.low : range_.high)) <= 1e-9 * range_.width();
        const bool to_infinity = has_event(end, CriticalKind::from_infinity);
        std::vector<Piece::Point> half;
        const auto finish = [&](const Eigen::VectorXd& last, PieceEnd why) {
            half.push_back({end, runtime_array(last)});
            return std::pair(std::move(half), why);
        };
        const PieceEnd reached = at_range ? PieceEnd::range : PieceEnd::event;
        std::optional<Point> point = stepper.start(eigen_vector(q), from, side);
        while (point && half.size() < 100000) {
            const auto next = stepper.advance(*point);
            const bool close = std::abs(point->p - end) < 1e-3 * gap.width();
            if (!next) {
                if (!close) break;
                if (const auto to = to_event(point->q, end)) return finish(point->q + *to, PieceEnd::event);
                if (has_event(end, CriticalKind::continuum)) return finish(point->q, PieceEnd::event);
                break;
            }
            const bool turned = next->tangent.p * side <= 0;  // around a fold or a pitchfork
            if (turned) {
                const auto to = to_event(point->q, end);
                if (!to) break;
                return finish(point->q + *to, PieceEnd::event);
            }
            if ((next->p - end) * side >= 0) {
                const double part = (end - point->p) / (next->p - point->p);
                return finish(point->q + part * (next->q - point->q), reached);
            }
            half.push_back({next->p, runtime_array(next->q)});
            point = next;
            if (to_infinity && is_far(point->q)) return {std::move(half), PieceEnd::infinity};
        }
        return {std::move(half), PieceEnd::stopped};
    }

    /// Whether a piece passes the equilibrium q at that value of the parameter.
    bool passes(Stepper& stepper, const Piece& piece, const RuntimeArray<double>& q, double value) const {
        const auto& points = piece.points;
        const auto behind = std::lower_bound(points.begin(), points.end(), value,
                                             [](const Piece::Point& point, double v) { return point.parameter < v; });
        if (behind == points.end() || (behind == points.begin() && behind->parameter > value)) return false;
        Eigen::VectorXd there = eigen_vector(behind->q);
        if (behind != points.begin()) {
            const auto& before = *(behind - 1);
            const double part = (value - before.parameter) / (behind->parameter - before.parameter);
            there = (1 - part) * eigen_vector(before.q) + part * there;
        }
        const auto near = [&](const Eigen::VectorXd& point, double distance) {
            Eigen::VectorXd to = eigen_vector(q) - point;
            for (int i = 0; i < model_.sizes().angles; ++i) to(i) = wrap(to(i));
            return scaled(to) < distance;
        };
        if (!near(there, 0.1)) return false;
        const auto exact = stepper.start(there, value, 1);
        return exact && near(exact->q, 1e-6);
    }

    BifurcationDiagram<RuntimeUnknowns>& diagram_;
    const SearchedModel& model_;
    RuntimeArray<double> p_;
    int active_;
    Interval range_;
    std::vector<Equilibria> first_, second_;  ///< by interval
    std::vector<double> sizes_;               ///< of the unknowns: 1 of angles
};

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
    diagram.search = std::move(static_cast<EventSearch&>(found));
    if (branch.parameter_weight == 0) branch.parameter_weight = 1 / (range.high - range.low);
    detail::DiagramTracer(diagram, model, equilibria, p, active, range, run).run(branch);
    return diagram;
}

}  // namespace equilibria
