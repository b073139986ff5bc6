/// \file
/// Bifurcation diagrams: every branch that is joined to a start, followed from bifurcation to bifurcation, and those
/// that deflation finds beside them, as a graph of branches and critical points.
#pragma once

#include <deque>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/deflation.hpp>

namespace equilibria {

struct DiagramOptions {
    ContinuationOptions continuation{};  ///< its range is finite where slices are asked for
    double amplitude = 0;                ///< of the first point on a new branch, as a step; 0: the first step's length
    int most_branches = 200;
    int slices = 0;  ///< values of p at which deflated Newton looks for branches that no bifurcation joins
    DeflationOptions deflation{};

    void validate() const {
        continuation.validate();
        deflation.validate();
        require(amplitude >= 0 && std::isfinite(amplitude), "amplitude", amplitude, "must be 0 (chosen) or positive");
        require(most_branches >= 1, "most_branches", most_branches, "must be at least 1");
        require(slices >= 0, "slices", slices, "must be 0 or positive");
        if (slices > 0) {
            require(std::isfinite(continuation.range.low), "range.low", continuation.range.low,
                    "must be finite where slices are asked for");
            require(std::isfinite(continuation.range.high), "range.high", continuation.range.high,
                    "must be finite where slices are asked for");
        }
    }
};

/// Branches and the critical points on them.
template <class P>
struct BranchGraph {
    struct Node {
        CriticalPoint<P> point;
        std::vector<std::size_t> branches;  ///< that go through it or leave it
    };
    /// A branch from its start in one direction: two of them make a curve.
    struct Edge {
        Branch<P> branch;
        std::optional<std::size_t> parent;  ///< the node that it leaves; nothing for the start's and those of deflation
        bool deflated = false;              ///< found by deflation
        std::vector<std::size_t> nodes;     ///< of branch.events, in their order
    };

    std::vector<Node> nodes;
    std::vector<Edge> branches;
    int seen = 0;          ///< starts that lay on a branch which was followed before
    int images = 0;        ///< starts whose mirror image did
    int not_followed = 0;  ///< starts beyond most_branches
    int not_switched = 0;  ///< bifurcations from which no other branch was found

    /// Every branch was followed to its end, with every change of sign explained.
    bool complete() const {
        if (not_followed > 0 || not_switched > 0 || branches.empty()) return false;
        return std::all_of(branches.begin(), branches.end(), [](const Edge& e) {
            return e.branch.unexplained.empty() &&
                   (e.branch.end == BranchEnd::window || e.branch.end == BranchEnd::closed);
        });
    }
};

namespace detail {

template <ContinuationProblem P>
class GraphBuilder {
public:
    using Point = BranchPoint<P>;

    GraphBuilder(const P& problem, const DiagramOptions& options)
        : problem_(problem), options_(options), stepper_(problem, options.continuation.branch) {
        if (options_.amplitude == 0) options_.amplitude = options.continuation.branch.first_step;
    }

    BranchGraph<P> run(const Configuration<P>& q, double p) {
        start(q, p, false);
        follow_all();
        for (int k = 0; k < options_.slices; ++k) {
            const double low = options_.continuation.range.low, high = options_.continuation.range.high;
            search(low + (high - low) * (k + 0.4713) / options_.slices);
            follow_all();
        }
        return std::move(graph_);
    }

private:
    struct Start {
        Point point;
        std::optional<std::size_t> parent;
        bool deflated;
    };

    void start(const Configuration<P>& q, double p, bool deflated) {
        auto point = stepper_.start(q, p, 1);
        if (!point) return;
        waiting_.push_back({*point, {}, deflated});
        BranchStepper<P>::flip(point->tangent);
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
            typename BranchGraph<P>::Edge edge;
            edge.branch = follow(stepper_, next.point, options_.continuation);
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
            const CriticalPoint<P>& point = branch.events[e].point;
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
            if (starts.empty()) ++graph_.not_switched;
            for (Point& at : starts) waiting_.push_back({std::move(at), node, false});
        }
    }

    static Point at(const Configuration<P>& q, double p) {
        Point y;
        y.q = q;
        y.p = p;
        return y;
    }
    bool same(const CriticalPoint<P>& a, const CriticalPoint<P>& b) const {
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
        if constexpr (requires { problem_.images(next.point.q); })
            for (const Configuration<P>& image : problem_.images(next.point.q))
                for (const auto& edge : graph_.branches) {
                    Point mirrored = at(image, next.point.p);
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
        std::vector<Configuration<P>> there;
        const auto add = [&](const Configuration<P>& q) {
            there.push_back(q);
            if constexpr (requires { problem_.images(q); })
                for (const Configuration<P>& image : problem_.images(q))
                    if (stepper_.length(stepper_.difference(at(image, p), q, p)) > 1e-9) there.push_back(image);
        };
        for (const auto& edge : graph_.branches)
            for (std::size_t k = 0; k + 1 < edge.branch.points.size(); ++k) {
                const Point &a = edge.branch.points[k], &b = edge.branch.points[k + 1];
                if ((a.p - p) * (b.p - p) > 0 || a.p == b.p) continue;
                const Direction chord = stepper_.difference(a, b.q, b.p);
                const double share = (p - a.p) / (b.p - a.p);
                if (const auto on = stepper_.start(retract(problem_, a.q, Eigen::VectorXd(share * chord.q)), p, 1))
                    add(on->q);
            }
        std::vector<Configuration<P>> guesses;
        for (std::size_t k = 0; k < there.size(); ++k) {
            const Eigen::VectorXd v = generic_vector(stepper_.metric().size(), static_cast<Eigen::Index>(k));
            const double length = std::sqrt(v.dot(stepper_.metric().cwiseProduct(v)));
            for (const double side : {0.1, -0.1, 1.0, -1.0})
                guesses.push_back(retract(problem_, there[k], Eigen::VectorXd(side / length * v)));
        }
        for (const auto& q : deflated_search(problem_, p, guesses, there, options_.deflation)) start(q, p, true);
    }

    const P& problem_;
    DiagramOptions options_;
    BranchStepper<P> stepper_;
    BranchGraph<P> graph_;
    std::deque<Start> waiting_;
};

}  // namespace detail

/// Follows every branch that is joined to the equilibrium near q at the parameter p, within the window of
/// options.continuation. A problem with a symmetry may declare it by `std::vector<Configuration> images(q)`, the
/// configurations that are equivalent to q: of branches that are images of each other one is followed. Without branches
/// where there is no equilibrium near q. Throws InvalidArgument for options out of range and for a problem that fails
/// check_derivatives.
template <ContinuationProblem P>
BranchGraph<P> bifurcation_diagram(const P& problem, const Configuration<P>& q, double p,
                                   const DiagramOptions& options) {
    options.validate();
    check_derivatives(problem, q, p);
    return detail::GraphBuilder<P>(problem, options).run(q, p);
}

}  // namespace equilibria
