/// \file
/// Branches, critical points and diagrams as dictionaries, whatever their configurations are.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>

#include "arrays.hpp"

namespace equilibria::python {

/// A dictionary of keys and values in turn.
template <class... Rest>
pybind11::dict dict(const Rest&... rest) {
    pybind11::dict y;
    const auto all = pybind11::make_tuple(rest...);
    for (std::size_t k = 0; k + 1 < all.size(); k += 2) y[all[k]] = all[k + 1];
    return y;
}

inline ContinuationOptions continuation_options(double low, double high, int most_steps, double first_step,
                                                double largest_step, double parameter_weight) {
    ContinuationOptions y;
    y.range = {low, high};
    y.most_steps = most_steps;
    y.branch.first_step = first_step;
    y.branch.largest_step = largest_step;
    y.branch.parameter_weight = parameter_weight;
    return y;
}

/// "kind", "p", "nullity", "residual", "curvature", "curvature_error", "negative_before" and "negative_after".
inline pybind11::dict evidence_of(const CriticalPointEvidence& point) {
    pybind11::dict y;
    y["kind"] = to_string(point.kind);
    y["p"] = point.p;
    y["nullity"] = point.nullity;
    y["residual"] = point.residual;
    y["curvature"] = point.curvature;
    y["curvature_error"] = point.curvature_error;
    y["negative_before"] = pybind11::cast(point.negative_before);
    y["negative_after"] = pybind11::cast(point.negative_after);
    return y;
}

/// (step, reason) of each step that its events do not account for.
template <class B>
pybind11::list unexplained_of(const B& branch) {
    pybind11::list y;
    for (const UnexplainedStep& step : branch.unexplained) y.append(pybind11::make_tuple(step.step, step.reason));
    return y;
}

/// All of a branch but its configurations and its critical points: "p", "negative" (-1: not known),
/// "determinant_sign", "residual", "arc_length", "unexplained", "end".
template <class B>
pybind11::dict columns_of(const B& branch) {
    pybind11::dict y;
    y["p"] = column<double>(branch.points, [](const auto& at) { return at.p; });
    y["negative"] = column<std::int64_t>(branch.points, [](const auto& at) { return at.negative.value_or(-1); });
    y["determinant_sign"] = column<std::int64_t>(branch.points, [](const auto& at) { return at.determinant_sign; });
    y["residual"] = column<double>(branch.points, [](const auto& at) { return at.residual; });
    y["arc_length"] = column<double>(branch.points, [](const auto& at) { return at.arc_length; });
    y["unexplained"] = unexplained_of(branch);
    y["end"] = to_string(branch.end);
    return y;
}

/// "branches" (with "parent", "deflated" and "nodes"), "nodes" (with "branches"), "circles", "verification", "seen",
/// "images", "not_followed", "not_switched" and "complete".
template <class Graph>
pybind11::dict graph_of(const Graph& graph, const auto& branch_of, const auto& point_of) {
    pybind11::list branches, nodes;
    for (const auto& edge : graph.branches) {
        pybind11::dict one = branch_of(edge.branch);
        one["parent"] = pybind11::cast(edge.parent);
        one["deflated"] = edge.deflated;
        one["nodes"] = pybind11::cast(edge.nodes);
        branches.append(std::move(one));
    }
    for (const auto& node : graph.nodes) {
        pybind11::dict one = point_of(node.point);
        one["branches"] = pybind11::cast(node.branches);
        nodes.append(std::move(one));
    }
    const DiagramVerification& found = graph.verification;
    const pybind11::dict verification =
        dict("points", found.points, "slices", found.slices, "equilibria", found.equilibria, "deflated", found.deflated,
             "not_checked", found.not_checked, "mismatches", found.mismatches, "verified", found.verified(), "summary",
             found.summary());
    return dict("branches", branches, "nodes", nodes, "circles", graph.circles, "verification", verification, "seen",
                graph.seen, "images", graph.images, "not_followed", graph.not_followed, "not_switched",
                graph.not_switched, "complete", graph.complete());
}

}  // namespace equilibria::python
