/// \file
/// See continuation/diagrams/branch_graph.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/continuation/factorization/generic_vector.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>

namespace equilibria {

namespace detail {

template <class Matrix>
class GraphBuilder {
public:
    using Point = BranchPoint<Erased>;

    GraphBuilder(const AnyProblem<Matrix>& problem, const DiagramOptions& options)
        : problem_(problem), options_(options), stepper_(problem, options.continuation.stepping()) {
        if (options_.amplitude == 0) options_.amplitude = options.continuation.branch.first_step;
    }

    BranchGraph<Erased> run(const AnyConfiguration& q, double p) {
        start(q, p, false);
        follow_all();
        for (int k = 0; k < options_.slices; ++k) {
            const double low = options_.continuation.range.low, high = options_.continuation.range.high;
            search(low + (high - low) * (k + 0.4713) / options_.slices);
            follow_all();
        }
        for (std::size_t k = 0; k < graph_.branches.size() && options_.checks > 0; ++k) check(k);
        return std::move(graph_);
    }

private:
    struct Start {
        Point point;
        std::optional<std::size_t> parent;
        bool deflated;
    };

    void start(const AnyConfiguration& q, double p, bool deflated) {
        auto point = stepper_.start(q, p, 1);
        if (!point) return;
        waiting_.push_back({*point, {}, deflated});
        AnyBranchStepper<Matrix>::flip(point->tangent);
        waiting_.push_back({std::move(*point), {}, deflated});
    }

    void follow_all() {
        while (!waiting_.empty()) {
            Start next = std::move(waiting_.front());
            waiting_.pop_front();
            if (known(next)) continue;
            if (static_cast<int>(graph_.branches.size()) >= options_.most_branches) {
                ++graph_.not_followed;
                continue;
            }
            BranchGraph<Erased>::Edge edge;
            edge.branch = follow(stepper_, next.point, options_.continuation, {});
            edge.parent = next.parent;
            edge.deflated = next.deflated;
            const std::size_t number = graph_.branches.size();
            if (edge.parent) graph_.nodes[*edge.parent].branches.push_back(number);
            graph_.branches.push_back(std::move(edge));
            enter_nodes(number);
        }
    }

    /// The critical points of a branch become nodes, and other branches through new ones wait to be followed.
    void enter_nodes(std::size_t number) {
        for (std::size_t e = 0; e < graph_.branches[number].branch.events.size(); ++e) {
            const auto& branch = graph_.branches[number].branch;
            const CriticalPoint<Erased>& point = branch.events[e].point;
            std::optional<std::size_t> node;
            for (std::size_t k = 0; k < graph_.nodes.size() && !node; ++k)
                if (same(graph_.nodes[k].point, point)) node = k;
            const bool is_new = !node;
            if (is_new) {
                node = graph_.nodes.size();
                graph_.nodes.push_back({point, {}});
            }
            auto& through = graph_.nodes[*node].branches;
            if (through.empty() || through.back() != number) through.push_back(number);
            graph_.branches[number].nodes.push_back(*node);
            if (!is_new || !is_bifurcation(point.kind) || point.kind == CriticalKind::isola_center) continue;
            auto starts =
                switch_branch(stepper_, point, branch.points[branch.events[e].step].tangent, options_.amplitude);
            if (leave_in_every_direction(point.nullity, starts.size())) {
                graph_.circles.push_back(*node);
                continue;
            }
            if (starts.empty()) ++graph_.not_switched;
            for (Point& at : starts) waiting_.push_back({std::move(at), node, false});
        }
    }

    static Point at(const AnyConfiguration& q, double p) {
        Point y;
        y.q = q;
        y.p = p;
        return y;
    }
    bool same(const CriticalPoint<Erased>& a, const CriticalPoint<Erased>& b) const {
        return stepper_.length(stepper_.difference(at(a.q, a.p), b.q, b.p)) <
               1e-3 * options_.continuation.branch.first_step;
    }
    /// Whether a branch that was followed passes through the start or an image of it; not so of the two halves from one
    /// start.
    bool known(const Start& next) {
        for (const auto& edge : graph_.branches) {
            const Point& first = edge.branch.points.front();
            // the other half from the same point
            if (!next.parent && !edge.parent && edge.branch.end != BranchEnd::closed &&
                stepper_.length(stepper_.difference(first, next.point.q, next.point.p)) < 1e-9)
                continue;
            if (lies_on(stepper_, edge.branch, next.point)) {
                ++graph_.seen;
                return true;
            }
        }
        for (const AnyConfiguration& image : problem_.images(next.point.q))
            for (const auto& edge : graph_.branches) {
                const Point mirrored = at(image, next.point.p);
                if (stepper_.length(stepper_.difference(mirrored, next.point.q, next.point.p)) > 1e-9 &&
                    lies_on(stepper_, edge.branch, mirrored)) {
                    ++graph_.images;
                    return true;
                }
            }
        return false;
    }

    /// Looks for equilibria at p that lie on no branch.
    void search(double p) {
        std::vector<AnyConfiguration> there;
        const auto add = [&](const AnyConfiguration& q) {
            there.push_back(q);
            for (const AnyConfiguration& image : problem_.images(q))
                if (stepper_.length(stepper_.difference(at(image, p), q, p)) > 1e-9) there.push_back(image);
        };
        for (const auto& edge : graph_.branches)
            for (std::size_t k = 0; k + 1 < edge.branch.points.size(); ++k) {
                const Point &a = edge.branch.points[k], &b = edge.branch.points[k + 1];
                if ((a.p - p) * (b.p - p) > 0 || a.p == b.p) continue;
                const Direction chord = stepper_.difference(a, b.q, b.p);
                const double share = (p - a.p) / (b.p - a.p);
                if (const auto on = stepper_.start(problem_.retract(a.q, Eigen::VectorXd(share * chord.q)), p, 1))
                    add(on->q);
            }
        std::vector<AnyConfiguration> guesses;
        for (std::size_t k = 0; k < there.size(); ++k) {
            const Eigen::VectorXd v = generic_vector(stepper_.metric().size(), static_cast<Eigen::Index>(k));
            const double length = std::sqrt(v.dot(stepper_.metric().cwiseProduct(v)));
            for (const double side : {0.1, -0.1, 1.0, -1.0})
                guesses.push_back(problem_.retract(there[k], Eigen::VectorXd(side / length * v)));
        }
        ++graph_.verification.slices;
        graph_.verification.equilibria += static_cast<int>(there.size());
        for (const auto& q : deflated_search(problem_, p, guesses, there, options_.deflation)) {
            ++graph_.verification.deflated;
            start(q, p, true);
        }
    }

    /// Counts eigenvalues at random points of a branch.
    void check(std::size_t number) {
        auto& report = graph_.verification;
        const auto& branch = graph_.branches[number].branch;
        if (branch.points.size() < 2) return;
        for (int c = 0; c < options_.checks; ++c) {
            const double at = uniform(generator_, branch.points.front().arc_length, branch.points.back().arc_length);
            std::size_t k = 0;
            while (k + 2 < branch.points.size() && branch.points[k + 1].arc_length < at) ++k;
            const Point &a = branch.points[k], &b = branch.points[k + 1];
            const double share = (at - a.arc_length) / (b.arc_length - a.arc_length);
            const Direction chord = stepper_.difference(a, b.q, b.p), increment{share * chord.q, share * chord.p};
            const auto on = stepper_.onto(a.q, a.p, increment, chord, chord);
            const auto counted = on ? eigenvalues(on->q, on->p) : std::nullopt;
            if (!counted) {
                ++report.not_checked;
                continue;
            }
            ++report.points;
            // what the branch says there: between critical points on one step, any of what they lead to
            std::vector<int> said{sign_count(a)};
            for (const auto& event : branch.events)
                if (event.step == k && event.point.negative_after) said.push_back(*event.point.negative_after);
            said.push_back(sign_count(b));
            if (!problem_.properties().symmetric && said[0] != said.back()) continue;
            if (std::ranges::find(said, *counted) == said.end())
                report.mismatches.push_back("branch " + std::to_string(number) + ", p = " + to_text(on->p) + ": " +
                                            std::to_string(*counted) + ", and " + std::to_string(said[0]) +
                                            " on the branch");
        }
    }
    /// Negative eigenvalues; of an unsymmetric K the determinant's sign.
    int sign_count(const Point& at) const {
        return problem_.properties().symmetric ? at.negative.value_or(-1) : at.determinant_sign;
    }
    /// Negative eigenvalues one by one, or the determinant's sign by another factorisation; nothing where one is 0 to
    /// rounding or K too large.
    std::optional<int> eigenvalues(const AnyConfiguration& q, double p) const {
        const Eigen::MatrixXd k(problem_.linearization(q, p).tangent);
        if (k.rows() > DiagramVerification::most_unknowns) return {};
        if (!problem_.properties().symmetric) {
            const Eigen::FullPivLU<Eigen::MatrixXd> lu(k);
            const auto pivots = lu.matrixLU().diagonal();
            if (!(pivots.cwiseAbs().minCoeff() > 1e-12 * pivots.cwiseAbs().maxCoeff())) return {};
            int sign = lu.permutationP().determinant() * lu.permutationQ().determinant() > 0 ? 1 : -1;
            for (const double pivot : pivots) sign = pivot < 0 ? -sign : sign;
            return sign;
        }
        // rows and columns of like sizes: congruence leaves the signs
        Eigen::MatrixXd scaled = k;
        for (int round = 0; round < 4; ++round) {
            const Eigen::VectorXd by = scaled.cwiseAbs().rowwise().maxCoeff().unaryExpr(
                [](double size) { return size > 0 ? 1 / std::sqrt(size) : 1.0; });
            scaled = by.asDiagonal() * scaled * by.asDiagonal();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
        const auto& values = solver.eigenvalues();
        if (!(values.cwiseAbs().minCoeff() > 1e-13 * values.cwiseAbs().maxCoeff())) return {};
        return static_cast<int>((values.array() < 0).count()) - problem_.multipliers();
    }

    const AnyProblem<Matrix>& problem_;
    DiagramOptions options_;
    Generator generator_{0x9e3779b97f4a7c15};
    AnyBranchStepper<Matrix> stepper_;
    BranchGraph<Erased> graph_;
    std::deque<Start> waiting_;
};

}  // namespace detail

template <class Matrix>
BranchGraph<Erased> bifurcation_diagram(const AnyProblem<Matrix>& problem, const AnyConfiguration& q, double p,
                                        const DiagramOptions& options) {
    options.validate();
    check_derivatives(problem, q, p, 1e-4);
    return detail::GraphBuilder<Matrix>(problem, options).run(q, p);
}

}  // namespace equilibria
