/// \file
/// Loads of a structure's text: dead and follower ones, on what elements and joints use or supports fix.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <equilibria/fem/loads.hpp>
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

    /// The node that the load is on.
    int add(const JsonPlace& l) {
        const auto type = l.find("type");
        const bool follows = type && type->choice({"dead", "follower"}) == 1;
        if (follows)
            l.keys("a follower load", {"type", "node"}, {"force", "moment"});
        else
            l.keys("a load", {"node"}, {"type", "force", "moment", "kind"});
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
            draft_.model().add(FollowerLoad{f, m}, {k});
        } else {
            const auto kind = l.find("kind");
            const bool constant = kind && kind->choice({"proportional", "constant"}) == 1;
            draft_.model().load(k, f, m, constant ? LoadKind::constant : LoadKind::proportional);
        }
        return k;
    }

private:
    /// Of a node's component: the node, or the one whose rotation it shares.
    std::size_t holder(int node, Component c) const {
        return static_cast<std::size_t>(c < rx ? node : draft_.model().rotates_with(node));
    }

    StructureDraft& draft_;
    std::vector<std::array<bool, 6>> used_;  // components that elements and joints use, or supports fix
};

}  // namespace equilibria::fem::detail
