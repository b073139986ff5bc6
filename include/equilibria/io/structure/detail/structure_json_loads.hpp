/// \file
/// Loads of a structure's text: on nodes, along elements, weights and pressures, on what elements and joints use or
/// supports fix.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/fem/line_load.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/structure_model.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/detail/structure_json_draft.hpp>

namespace equilibria::fem::detail {

/// Adds loads to a draft that has all of its elements, joints and supports.
class LoadReader {
public:
    explicit LoadReader(StructureDraft& draft) : draft_(draft), used_(draft.model().used()) {
        const auto held = draft.model().held();
        for (std::size_t k = 0; k < used_.size(); ++k)
            for (const Component c : spatial) used_[k][c] = used_[k][c] || held[k][c];
    }

    /// The node that the load is on; nothing where it is on elements.
    std::optional<int> add(const JsonPlace& l) {
        enum { dead, follower, distributed, self_weight, pressure };
        const auto type = l.find("type");
        const std::size_t which =
            type ? type->choice({"dead", "follower", "distributed", "self_weight", "pressure"}) : std::size_t{dead};
        if (which == distributed) return add_distributed(l), std::nullopt;
        if (which == self_weight) return add_weight(l), std::nullopt;
        if (which == pressure) return add_pressure(l), std::nullopt;
        return add_on_node(l, which == follower);
    }

private:
    int add_on_node(const JsonPlace& l, bool follows) {
        l.keys(follows ? "a follower load" : "a load", {"node"}, {"type", "force", "moment", "kind"});
        const LoadKind kind = StructureDraft::kind(l);
        const int k = draft_.node(l.at("node"));
        const auto force = l.find("force"), moment = l.find("moment");
        if (!force && !moment) l.refuse("must have a force or a moment");
        const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), f = force ? force->vector() : zero,
                              m = moment ? moment->vector() : zero;
        for (const Component c : spatial) {
            if (used_[holder(k, c)][c]) continue;
            if (follows)
                l.at("node").refuse(
                    std::string("must be a node whose components are all used by elements, or fixed: ") + to_string(c) +
                    " is not");
            if ((c < rx ? f(c) : m(c - rx)) != 0)
                (c < rx ? force : moment)
                    ->refuse(std::string("must act on what elements use: not along ") + to_string(c));
        }
        if (follows) {
            draft_.count(l, 1);
            draft_.model().add(FollowerLoad{f, m}, {k}, kind);
        } else {
            draft_.model().load(k, f, m, kind);
        }
        return k;
    }

    /// The elements that an entry names.
    std::vector<const DraftLine*> lines(const JsonPlace& l) const {
        const JsonPlace names = l.at("elements");
        if (names.size() == 0) names.refuse("must not be empty");
        std::vector<const DraftLine*> y;
        for (std::size_t k = 0; k < names.size(); ++k) y.push_back(&draft_.line(names[k]));
        return y;
    }
    /// A dead load per length; `given` is where it stands in the text.
    void add_along(const DraftLine& line, const Eigen::Vector3d& load, const JsonPlace& given, LoadKind kind) {
        for (const int node : line.nodes)
            for (const Component c : positions)
                if (load(c) != 0 && !used_[static_cast<std::size_t>(node)][c])
                    given.refuse(std::string("must act on what elements use: not along ") + to_string(c));
        with_beam_nodes(line.nodes_each, [&](auto n) { add_line_load<n>(draft_.model(), line.nodes, load, kind); });
    }
    void add_distributed(const JsonPlace& l) {
        l.keys("a distributed load", {"type", "elements", "force"}, {"kind"});
        const JsonPlace force = l.at("force");
        for (const DraftLine* line : lines(l)) add_along(*line, force.vector(), force, StructureDraft::kind(l));
    }
    void add_weight(const JsonPlace& l) {
        l.keys("a self-weight", {"type", "gravity"}, {"kind"});
        const JsonPlace gravity = l.at("gravity");
        bool heavy = false;
        for (const DraftLine& line : draft_.lines())
            if (line.mass > 0) {
                add_along(line, line.mass * gravity.vector(), gravity, StructureDraft::kind(l));
                heavy = true;
            }
        if (!heavy) l.refuse("must have something to weigh: no section and no truss has a \"mass\" per length");
    }
    void add_pressure(const JsonPlace& l) {
        l.keys("a pressure", {"type", "elements", "pressure"}, {"kind"});
        const JsonPlace names = l.at("elements");
        std::map<int, std::pair<int, int>> ends;  // of a node: how many lines begin and end there
        const auto all = lines(l);
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (!all[k]->planar_beam) names[k].refuse("must be a beam or an arc with a planar section");
            ++ends[all[k]->nodes.front()].first;
            ++ends[all[k]->nodes.back()].second;
        }
        const Model& model = draft_.model();
        for (const auto& [node, count] : ends) {
            if (count == std::pair(1, 1) || (model.fixed(node, ux) && model.fixed(node, uy))) continue;
            names.refuse(
                "must be a closed line in one direction, or one whose ends are fixed in ux and uy: else a "
                "pressure has no energy, as at " +
                StructureDraft::point(draft_.at(node)));
        }
        const double size = l.at("pressure").number();
        for (const DraftLine* line : all)
            with_beam_nodes(line->nodes_each, [&](auto n) {
                draft_.count(l, (line->nodes.size() - 1) / (n - 1));
                add_line_pressure<n>(draft_.model(), line->nodes, size, StructureDraft::kind(l));
            });
    }
    /// Of a node's component: the node, or the one whose rotation it shares.
    std::size_t holder(int node, Component c) const {
        return static_cast<std::size_t>(c < rx ? node : draft_.model().rotates_with(node));
    }

    StructureDraft& draft_;
    std::vector<std::array<bool, 6>> used_;  // components that elements and joints use, or supports fix
};

}  // namespace equilibria::fem::detail
