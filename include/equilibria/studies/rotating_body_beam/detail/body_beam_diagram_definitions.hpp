/// \file
/// How the branches of a body with a beam are followed through the equilibria of a few momenta, and curves of critical
/// points through those of a few diagrams; see body_beam_diagram.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/continuation/corrector.hpp>
#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/continuation/curves/critical_curve_trace.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/studies/rotating_body_beam/body_beam_diagram.hpp>
#include <equilibria/studies/rotating_body_beam/detail/body_beam_problem.hpp>

namespace equilibria::mechanisms::detail {

/// The evenly spaced middles of so many parts.
inline std::vector<double> slices_of(const Interval& range, int slices) {
    std::vector<double> y;
    for (int k = 0; k < slices; ++k) y.push_back(range.low + (k + 0.5) * range.width() / slices);
    return y;
}

/// Branches in a range of momenta, as they are found.
template <int K>
class BodyBeamBranches {
public:
    using Problem = BodyBeamProblem<K>;
    using Vector = Eigen::VectorXd;

    BodyBeamBranches(const typename Problem::Values& p, const Interval& momenta,
                     const ContinuationOptions& continuation)
        : problem_(p), momenta_{momenta.low / problem_.units().momentum(), momenta.high / problem_.units().momentum()} {
        options_.continuation = continuation;
        options_.continuation.range = momenta_;
    }

    bool pass(const BodyBeamEquilibrium& e) const {
        return std::any_of(found.branches.begin(), found.branches.end(), [&](const BodyBeamBranch& branch) {
            for (std::size_t k = 0; k + 1 < branch.points.size(); ++k) {
                const auto &a = branch.points[k], &b = branch.points[k + 1];
                if ((a.momentum - e.momentum) * (b.momentum - e.momentum) > 0 || a.momentum == b.momentum) continue;
                const auto at = problem_.between(a, b, e.momentum);
                if (at && problem_.same(*at, e)) return true;
            }
            return false;
        });
    }
    /// All branches that are joined to an equilibrium which none passes.
    void follow(const BodyBeamEquilibrium& e) {
        const auto& units = problem_.units();
        const auto graph =
            bifurcation_diagram(problem_, body_beam_unknowns<K>(e, units), e.momentum / units.momentum(), options_);
        found.followed = found.followed && graph.complete();
        for (const auto& node : graph.nodes) add(node.point);
        for (const auto& edge : graph.branches) add(graph, edge);
    }

    BodyBeamDiagram found;

private:
    using Graph = BranchGraph<Problem>;
    using Place = std::pair<double, Vector>;  ///< momentum, unknowns, in the problem's units

    void add(const CriticalPoint<Problem>& point) {
        std::vector<Vector> all = problem_.mirror_images(point.q);
        all.push_back(point.q);
        for (const Vector& q : all) {
            const auto at = problem_.equilibrium(q, point.p);
            if (std::none_of(found.critical_points.begin(), found.critical_points.end(),
                             [&](const auto& known) { return problem_.same(known.at, at); }))
                found.critical_points.push_back({point.kind, at});
        }
    }
    /// The pieces of a branch between its critical points.
    void add(const Graph& graph, const typename Graph::Edge& edge) {
        const auto& branch = edge.branch;
        std::vector<Place> piece;
        if (edge.parent) piece.emplace_back(graph.nodes[*edge.parent].point.p, graph.nodes[*edge.parent].point.q);
        std::size_t next = 0;
        for (std::size_t k = 0; k < branch.points.size(); ++k) {
            const auto& point = branch.points[k];
            if (momenta_.contains(point.p)) {
                piece.emplace_back(point.p, point.q);
            } else if (k > 0) {
                const double border = point.p > momenta_.high ? momenta_.high : momenta_.low;
                const auto& before = branch.points[k - 1];
                Vector q = before.q + (border - before.p) / (point.p - before.p) * (point.q - before.q);
                if (correct_at(problem_, q, border).converged()) piece.emplace_back(border, q);
            }
            for (; next < branch.events.size() && branch.events[next].step == k; ++next) {
                const auto& event = branch.events[next].point;
                piece.emplace_back(event.p, event.q);
                add(piece);
                piece.assign({{event.p, event.q}});
            }
        }
        add(piece);
    }
    /// A piece and its mirror images, none of them twice.
    void add(const std::vector<Place>& piece) {
        if (piece.size() < 2) return;
        add_one(piece);
        const std::size_t images = problem_.mirror_images(piece.front().second).size();
        for (std::size_t k = 0; k < images; ++k) {
            std::vector<Place> image;
            for (const auto& [p, q] : piece) image.emplace_back(p, problem_.mirror_images(q)[k]);
            add_one(image);
        }
    }
    void add_one(const std::vector<Place>& piece) {
        std::vector<BodyBeamEquilibrium> points;
        for (const auto& [p, q] : piece) points.push_back(problem_.equilibrium(q, p));
        const std::size_t half = points.size() / 2;
        const double p = 0.5 * (points[half - 1].momentum + points[half].momentum);
        const auto middle = problem_.between(points[half - 1], points[half], p);
        if (!middle || pass(*middle)) return;
        // where n turns through the plane at which -n takes its place the curve of n is cut
        BodyBeamBranch part{middle->index, {}};
        for (const auto& point : points) {
            if (!part.points.empty() && part.points.back().axis.dot(point.axis) < 0) {
                if (part.points.size() > 1) found.branches.push_back(part);
                part.points.clear();
            }
            part.points.push_back(point);
        }
        if (part.points.size() > 1) found.branches.push_back(std::move(part));
    }

    Problem problem_;
    Interval momenta_;  ///< in the problem's units
    DiagramOptions options_;
};

/// Curves of critical points, as they are followed: in the units that suit the body at the middle of the window.
template <int K>
class BodyBeamCriticalCurves {
public:
    using Model = BodyBeamEitherStrain<K, BeamControl::momentum>;
    using Values = typename Model::Values;
    using Vector = Eigen::VectorXd;

    BodyBeamCriticalCurves(Values p, int second, const Window& window, const ContinuationOptions& continuation)
        : units_(units_of(p, second, window)), second_(units_.scaled[second] / middle(window.x)),
          problems_{units_.scaled, second},
          window_{in_units(window.x, second_), in_units(window.y, 1 / units_.momentum())}, options_(continuation) {
        options_.range = window_.x;
    }

    /// The curve through a critical point of the diagram at the value y of the second parameter, unless one is known.
    void add(const BodyBeamCriticalPoint& critical, double y) {
        const double own = y * second_;
        const auto member = problems_(own);
        const CriticalPointSolver<typename BodyBeamProblems<K>::Member> solver(member);
        const Vector q = body_beam_unknowns<K>(critical.at, units_);
        const double momentum = critical.at.momentum / units_.momentum();
        if (passes(solver, q, momentum, own)) return;
        const auto start = solver.solve(q, momentum);
        if (!start || start->nullity > 1) {
            ++found.on_no_curve;
            return;
        }
        BodyBeamCurve curve{start->kind, {}, 0};
        Line line;
        for (const int direction : {-1, 1}) {
            if (start->kind == CriticalKind::fold)
                take(continue_folds(problems_, *start, own, direction, options_, window_.y), line, curve.residual);
            else
                take(continue_bifurcations(problems_, *start, own, direction, options_, window_.y), line,
                     curve.residual);
            if (direction == -1) std::reverse(line.begin(), line.end());
        }
        if (line.size() < 2) {
            ++found.on_no_curve;
            return;
        }
        for (const At& at : line) curve.points.push_back(place(at.y, at.momentum));
        found.curves.push_back(std::move(curve));
        lines_.push_back(std::move(line));
    }

    BodyBeamCurves found;

private:
    struct At {
        double y, momentum;
        Vector q;
    };
    using Line = std::vector<At>;

    static double middle(const Interval& range) { return 0.5 * (range.low + range.high); }
    static Interval in_units(const Interval& range, double factor) { return {range.low * factor, range.high * factor}; }
    static typename Model::Units units_of(Values& p, int second, const Window& window) {
        p[second] = middle(window.x);
        return Model::units(p);
    }
    std::array<double, 2> place(double y, double momentum) const { return {y / second_, momentum * units_.momentum()}; }

    template <class Trace>
    void take(const Trace& trace, Line& line, double& residual) {
        for (const auto& at : trace.branch.points) {
            line.push_back({at.p, at.q.p, at.q.q});
            residual = std::max(residual, at.residual);
        }
        for (const auto& special : trace.special)
            if (special.kind == CriticalKind::cusp && window_.contains(special.r, special.at.p)) {
                const auto cusp = place(special.r, special.at.p);
                if (std::none_of(found.cusps.begin(), found.cusps.end(), [&](const auto& known) {
                        return std::abs(known[0] / cusp[0] - 1) + std::abs(known[1] / cusp[1] - 1) < 1e-7;
                    }))
                    found.cusps.push_back(cusp);
            }
    }
    /// Mirror images have the moment and the momentum in common.
    template <class Solver>
    bool passes(const Solver& solver, const Vector& q, double momentum, double y) const {
        for (const Line& line : lines_)
            for (std::size_t k = 0; k + 1 < line.size(); ++k) {
                const At &a = line[k], &b = line[k + 1];
                if ((a.y - y) * (b.y - y) > 0 || a.y == b.y) continue;
                const double share = (y - a.y) / (b.y - a.y);
                const auto at =
                    solver.solve((1 - share) * a.q + share * b.q, (1 - share) * a.momentum + share * b.momentum);
                if (at &&
                    std::abs(at->p / momentum - 1) + std::abs(at->q(Model::multiplier) / q(Model::multiplier) - 1) <
                        1e-6)
                    return true;
            }
        return false;
    }

    typename Model::Units units_;
    double second_;  ///< the second parameter in these units over what it is
    BodyBeamProblems<K> problems_;
    Window window_;  ///< in these units
    ContinuationOptions options_;
    std::vector<Line> lines_;
};

}  // namespace equilibria::mechanisms::detail

namespace equilibria::mechanisms {

template <int K>
BodyBeamDiagram body_beam_diagram(const BodyBeamSolver<K, BeamControl::momentum>& solver,
                                  const typename BodyBeamSolver<K, BeamControl::momentum>::Values& p,
                                  const Interval& momenta, const BodyBeamDiagramOptions& options) {
    using Base = typename BodyBeamSolver<K, BeamControl::momentum>::Base;
    momenta.validate("momenta");
    require(momenta.low > 0, "momenta.low", momenta.low, "must be positive");
    options.validate();
    require(!detail::turns(p), "p", "a body that any turn about the third axis leaves as it is",
            "must be another one: this has circles of equilibria");
    auto at = p;
    at[Base::second_axis] = 1;
    detail::BodyBeamBranches<K> branches(at, momenta, options.continuation);
    auto& y = branches.found;
    for (const double middle : detail::slices_of(momenta, options.slices)) {
        // next to a momentum where roots meet, be they complex ones, a path may end undecided: a slice may lie
        // elsewhere
        BodyBeamEquilibria all;
        for (const double shift : {0.0, 0.021, -0.034}) {
            at[Base::momentum] = middle + shift * momenta.width() / options.slices;
            all = solver(at);
            if (all.accounted_for()) break;
        }
        y.slices.push_back(at[Base::momentum]);
        y.followed = y.followed && all.accounted_for();
        for (const auto& e : all.equilibria) {
            if (branches.pass(e)) continue;
            branches.follow(e);
            if (!branches.pass(e)) ++y.on_no_branch;
        }
    }
    std::stable_sort(y.branches.begin(), y.branches.end(),
                     [](const auto& a, const auto& b) { return a.index < b.index; });
    std::stable_sort(y.critical_points.begin(), y.critical_points.end(),
                     [](const auto& a, const auto& b) { return a.at.momentum < b.at.momentum; });
    return y;
}

template <int K>
BodyBeamCurves body_beam_curves(const BodyBeamSolver<K, BeamControl::momentum>& solver,
                                const typename BodyBeamSolver<K, BeamControl::momentum>::Values& p, int second,
                                const Window& window, const BodyBeamDiagramOptions& options) {
    using Base = typename BodyBeamSolver<K, BeamControl::momentum>::Base;
    window.validate();
    require(second >= Base::body_mass && second <= Base::stretching, "second", second,
            "must be the number of a mass, a moment, a place of the centre, the length or a stiffness");
    options.validate();
    auto at = p;
    at[Base::second_axis] = 1;
    detail::BodyBeamCriticalCurves<K> curves(at, second, window, options.continuation);
    curves.found.slices = detail::slices_of(window.x, options.slices);
    for (const double y : curves.found.slices) {
        at[second] = y;
        const auto diagram = body_beam_diagram(solver, at, window.y, options);
        curves.found.followed = curves.found.followed && diagram.complete();
        for (const auto& critical : diagram.critical_points) curves.add(critical, y);
    }
    return curves.found;
}

}  // namespace equilibria::mechanisms
