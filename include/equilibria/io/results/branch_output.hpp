/// \file
/// Branches of a continuation problem as JSON and CSV: what is read off each configuration, critical points, graphs.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/io/results/csv.hpp>
#include <equilibria/io/results/json.hpp>

namespace equilibria {

/// What is written of a configuration of problem P.
template <class P>
struct BranchMeasures {
    std::string parameter = "parameter";                                  ///< its name and unit
    std::vector<std::string> names;                                       ///< of the measures
    std::function<std::vector<double>(const Configuration<P>&)> measure;  ///< their values at a configuration
    /// The parameter in its unit.
    std::function<double(const Configuration<P>&, double)> value = [](const Configuration<P>&, double p) { return p; };
};

/// A point of a branch as it is written.
struct BranchSample {
    double parameter = 0;          ///< in its unit
    std::vector<double> measures;  ///< in the order of their names
    /// Without negative eigenvalue; at a critical point, by the branch before it. Nothing where the inertia is not
    /// known, as where forces have no potential: an equilibrium may flutter there.
    std::optional<bool> stable;
    std::string at;  ///< name of the event function that is 0 there, else empty
};

/// Calls call(q, p, stable, at) for all points of a branch in their order: the critical point `from` that it leaves,
/// the steps, and between them the zeros of `functions` and the critical points.
template <class P, class Call>
void for_each_point(const Branch<P>& branch, const std::vector<EventFunction<P>>& functions,
                    const CriticalPoint<P>* from, const Call& call) {
    const auto none_negative = [](const std::optional<int>& negative) {
        return negative ? std::optional<bool>(*negative == 0) : std::nullopt;
    };
    if (from) call(from->q, from->p, from->negative_before ? std::optional<bool>(false) : std::nullopt, std::string());
    auto event = branch.events.begin();
    for (std::size_t k = 0; k < branch.points.size(); ++k) {
        const auto& point = branch.points[k];
        call(point.q, point.p, point.stable(), std::string());
        for (const auto& crossing : branch.crossings)
            if (crossing.step == k)
                call(crossing.point.q, crossing.point.p, crossing.point.stable(), functions[crossing.function].name);
        for (; event != branch.events.end() && event->step == k; ++event)
            call(event->point.q, event->point.p, none_negative(event->point.negative_before), std::string());
    }
}

/// A branch as samples, in the order of for_each_point.
template <class P>
std::vector<BranchSample> samples_of(const Branch<P>& branch, const BranchMeasures<P>& how,
                                     const std::vector<EventFunction<P>>& functions = {},
                                     const CriticalPoint<P>* from = nullptr) {
    std::vector<BranchSample> samples;
    for_each_point(branch, functions, from,
                   [&](const auto& q, double p, std::optional<bool> stable, const std::string& at) {
                       samples.push_back({how.value(q, p), how.measure(q), stable, at});
                   });
    return samples;
}

/// dp/dx of each branch through a bifurcation, x the unknown in which the null vector is 1; null along p alone.
inline Json slopes_of(const CriticalPointEvidence& c) {
    Json y = Json::array();
    if (c.null_vector.size() == 0) return y;
    Eigen::Index largest = 0;
    c.null_vector.cwiseAbs().maxCoeff(&largest);
    for (const Direction& t : c.tangents) {
        const double x = t.q(largest) / c.null_vector(largest);
        y.push_back(std::abs(x) > 1e-9 * std::abs(t.p) ? json_of(t.p / x) : Json(nullptr));
    }
    return y;
}

/// "kind", "parameter", "measures", "nullity", "iterations" (of Newton's method), "residual", "inertia_before" and
/// "inertia_after": negative eigenvalues along the branch, or null; "curvature" and "curvature_error", of pitchforks
/// and folds: p = p_c + curvature x^2 / 2, x the unknown in which the null vector is 1; "slopes" (slopes_of).
template <class P>
Json json_of(const CriticalPoint<P>& c, const BranchMeasures<P>& how) {
    const bool bends = c.kind == CriticalKind::pitchfork || c.kind == CriticalKind::fold;
    return {{"kind", to_string(c.kind)},
            {"parameter", json_of(how.value(c.q, c.p))},
            {"measures", json_list(how.measure(c.q))},
            {"nullity", c.nullity},
            {"iterations", c.iterations()},
            {"residual", c.residual},
            {"inertia_before", json_or_null(c.negative_before)},
            {"inertia_after", json_or_null(c.negative_after)},
            {"curvature", bends ? json_of(c.curvature) : Json(nullptr)},
            {"curvature_error", bends ? json_of(c.curvature_error) : Json(nullptr)},
            {"slopes", slopes_of(c)}};
}

/// "points", [parameter, measures ..] each, and "stable", as many: true, false, or null where it is not known.
inline Json json_of(const std::vector<BranchSample>& samples) {
    Json points = Json::array(), stable = Json::array();
    for (const auto& s : samples) {
        points.push_back(json_list(s.measures));
        points.back().insert(points.back().begin(), json_of(s.parameter));
        stable.push_back(json_or_null(s.stable));
    }
    return {{"points", std::move(points)}, {"stable", std::move(stable)}};
}

/// "verified", "summary", "points", "slices", "equilibria", "deflated", "not_checked", "mismatches".
inline Json json_of(const DiagramVerification& found) {
    return {{"verified", found.verified()},     {"summary", found.summary()},     {"points", found.points},
            {"slices", found.slices},           {"equilibria", found.equilibria}, {"deflated", found.deflated},
            {"not_checked", found.not_checked}, {"mismatches", found.mismatches}};
}

/// "parameter" and "measures" (their names), "nodes": critical points, each with the numbers of its "branches";
/// "branches": each with "points", "stable", "parent" (a node, or null), "deflated", "nodes", "end";
/// "unexplained_steps", "seen", "images", "not_followed", "not_switched", "circles", "verification",
/// "complete".
template <class P>
Json json_of(const BranchGraph<P>& graph, const BranchMeasures<P>& how) {
    Json nodes = Json::array(), branches = Json::array(), unexplained = Json::array();
    for (const auto& node : graph.nodes) {
        nodes.push_back(json_of(node.point, how));
        nodes.back()["branches"] = node.branches;
    }
    for (std::size_t k = 0; k < graph.branches.size(); ++k) {
        const auto& edge = graph.branches[k];
        const CriticalPoint<P>* from = edge.parent ? &graph.nodes[*edge.parent].point : nullptr;
        branches.push_back(json_of(samples_of(edge.branch, how, {}, from)));
        add_keys(branches.back(), {{"parent", json_or_null(edge.parent)},
                                   {"deflated", edge.deflated},
                                   {"nodes", edge.nodes},
                                   {"end", to_string(edge.branch.end)}});
        for (const auto& step : edge.branch.unexplained)
            unexplained.push_back("branch " + std::to_string(k) + ": " + step.reason);
    }
    return {{"parameter", how.parameter},
            {"measures", how.names},
            {"nodes", std::move(nodes)},
            {"branches", std::move(branches)},
            {"unexplained_steps", std::move(unexplained)},
            {"seen", graph.seen},
            {"images", graph.images},
            {"not_followed", graph.not_followed},
            {"not_switched", graph.not_switched},
            {"circles", graph.circles},
            {"verification", json_of(graph.verification)},
            {"complete", graph.complete()}};
}

/// A line a point: branch (from 0), parameter, the measures by their names, stable (empty where it is not known), at
/// (the event function that is 0 there, or empty).
inline CsvTable branches_csv(const std::vector<std::vector<BranchSample>>& branches,
                             const std::vector<std::string>& measures) {
    std::vector<std::string> columns{"branch", "parameter"};
    columns.insert(columns.end(), measures.begin(), measures.end());
    columns.insert(columns.end(), {"stable", "at"});
    CsvTable table(columns);
    for (std::size_t b = 0; b < branches.size(); ++b)
        for (const auto& s : branches[b])
            table.add(CsvRow().add(b).add(s.parameter).add_all(s.measures).add(s.stable).add(s.at));
    return table;
}

}  // namespace equilibria
