/// \file
/// Bifurcation diagrams: every branch that is joined to a start, followed from bifurcation to bifurcation, and those
/// that deflation finds beside them, as a graph of branches and critical points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/diagrams/deflation.hpp>
#include <equilibria/core/compiled.hpp>

namespace equilibria {

/// How far a bifurcation diagram is followed.
struct DiagramOptions {
    ContinuationOptions continuation{};  ///< its range is finite where slices are asked for
    double amplitude = 0;                ///< of the first point on a new branch, as a step; 0: the first step's length
    int most_branches = 200;             ///< starts beyond these are counted and not followed
    int slices = 0;  ///< values of p at which deflated Newton looks for branches that no bifurcation joins
    DeflationOptions deflation{};  ///< of the search in the slices
    int checks = 0;  ///< random points of each branch at which the eigenvalues of K are counted one by one

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        continuation.validate();
        deflation.validate();
        require(amplitude >= 0 && std::isfinite(amplitude), "amplitude", amplitude, "must be 0 (chosen) or positive");
        require(most_branches >= 1, "most_branches", most_branches, "must be at least 1");
        require(slices >= 0, "slices", slices, "must be 0 or positive");
        require(checks >= 0, "checks", checks, "must be 0 or positive");
        if (slices > 0) {
            require(std::isfinite(continuation.range.low), "range.low", continuation.range.low,
                    "must be finite where slices are asked for");
            require(std::isfinite(continuation.range.high), "range.high", continuation.range.high,
                    "must be finite where slices are asked for");
        }
    }
};

/// What was done to find faults of a diagram, after it was followed.
struct DiagramVerification {
    static constexpr int most_unknowns = 1000;  ///< the largest K whose eigenvalues are counted

    int points = 0;       ///< random points of branches at which the eigenvalues of K were counted
    int slices = 0;       ///< values of p at which deflation looked for equilibria that lie on no branch
    int equilibria = 0;   ///< how many the branches have in these slices
    int deflated = 0;     ///< equilibria that deflation found beside them; their branches were followed
    int not_checked = 0;  ///< points that were not reached, too near to a critical one, or of a K that is too large
    std::vector<std::string> mismatches;  ///< points whose eigenvalues are not what the branch says, in words

    /// Eigenvalues were counted and slices searched, and neither found a fault. This is evidence, no proof.
    bool verified() const { return points > 0 && slices > 0 && deflated == 0 && mismatches.empty(); }
    /// "verified: .. points, .. slices", or what was found, or that nothing was done.
    std::string summary() const {
        const auto count = [](int k, const char* one, const char* many) {
            return std::to_string(k) + " " + (k == 1 ? one : many);
        };
        if (points == 0 && slices == 0) return "not verified: no eigenvalues were counted, and no slices searched";
        std::string y = verified() ? "verified: " : "NOT VERIFIED: ";
        y += "eigenvalues at " + count(points, "point", "points");
        if (!mismatches.empty())
            y += ", of which " + std::to_string(mismatches.size()) + " are not as the branches say";
        y += "; " + count(equilibria, "equilibrium", "equilibria") + " in " + count(slices, "slice", "slices");
        if (slices > 0)
            y += deflated == 0 ? ", deflation found no other"
                               : ", deflation found " + count(deflated, "other", "others");
        return y;
    }
};

/// Branches and the critical points on them.
template <class P>
struct BranchGraph {
    /// A critical point, met by one branch or more.
    struct Node {
        CriticalPoint<P> point;             ///< where it is, and of which kind
        std::vector<std::size_t> branches;  ///< that go through it or leave it
    };
    /// A branch from its start in one direction: two of them make a curve.
    struct Edge {
        Branch<P> branch;                   ///< its points and events
        std::optional<std::size_t> parent;  ///< the node that it leaves; nothing for the start's and those of deflation
        bool deflated = false;              ///< found by deflation
        std::vector<std::size_t> nodes;     ///< of branch.events, in their order
    };

    std::vector<Node> nodes;     ///< critical points; each once, however many branches meet there
    std::vector<Edge> branches;  ///< in the order in which they were followed
    int seen = 0;                ///< starts that lay on a branch which was followed before
    int images = 0;              ///< starts whose mirror image did
    int not_followed = 0;        ///< starts beyond most_branches
    int not_switched = 0;        ///< bifurcations from which no other branch was found
    /// Nodes from which branches leave in every direction (leave_in_every_direction), turns of one: none is followed.
    std::vector<std::size_t> circles;
    DiagramVerification verification{};  ///< what was done to find faults

    /// Every branch was followed to its end, with every change of sign explained.
    bool complete() const {
        if (not_followed > 0 || not_switched > 0 || !circles.empty() || branches.empty()) return false;
        return std::all_of(branches.begin(), branches.end(), [](const Edge& e) {
            return e.branch.unexplained.empty() &&
                   (e.branch.end == BranchEnd::window || e.branch.end == BranchEnd::closed);
        });
    }
};

/// The same graph, with the configurations of the problem's own type.
template <ContinuationProblem P>
BranchGraph<P> typed(const BranchGraph<Erased>& graph) {
    BranchGraph<P> y;
    for (const auto& [point, branches] : graph.nodes) y.nodes.push_back({typed<P>(point), branches});
    for (const auto& [branch, parent, deflated, nodes] : graph.branches)
        y.branches.push_back({typed<P>(branch), parent, deflated, nodes});
    y.seen = graph.seen;
    y.images = graph.images;
    y.not_followed = graph.not_followed;
    y.not_switched = graph.not_switched;
    y.circles = graph.circles;
    y.verification = graph.verification;
    return y;
}

/// Of a problem of any type, see below.
template <class Matrix>
BranchGraph<Erased> bifurcation_diagram(const AnyProblem<Matrix>& problem, const AnyConfiguration& q, double p,
                                        const DiagramOptions& options);

/// Follows every branch that is joined to the equilibrium near q at the parameter p, within the window of
/// options.continuation. A problem with a symmetry may declare it by `std::vector<Configuration> images(q)`, the
/// configurations that are equivalent to q: of branches that are images of each other one is followed. Without branches
/// where there is no equilibrium near q. Throws InvalidArgument for options out of range and for a problem that fails
/// check_derivatives.
template <ContinuationProblem P>
BranchGraph<P> bifurcation_diagram(const P& problem, const Configuration<P>& q, double p,
                                   const DiagramOptions& options) {
    return typed<P>(bifurcation_diagram(AnyProblemOf<P>(problem), AnyConfiguration::of(q), p, options));
}

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/continuation/diagrams/detail/branch_graph_definitions.hpp>
#endif
