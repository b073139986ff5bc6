/// \file
/// Joints of a structure's text, and its prescribed motions.
#pragma once

#include <cstddef>

#include <Eigen/Core>

#include <equilibria/fem/joints.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/detail/structure_json_draft.hpp>

namespace equilibria::fem::detail {

inline void add_joint(StructureDraft& draft, const JsonPlace& j) {
    enum { revolute, spherical, hinge, prismatic, displacement, rotation, drive, fork };
    const std::size_t type =
        j.at("type").choice({"revolute", "spherical", "hinge", "prismatic", "prescribed_displacement",
                             "prescribed_rotation", "rotation_drive", "fork"});
    draft.count(j, 1);
    const auto number = [&](const char* key, double otherwise) {
        const auto given = j.find(key);
        return given ? given->number() : otherwise;
    };
    Model& model = draft.model();
    if (type == displacement) {
        j.keys("a prescribed displacement", {"type", "node", "direction"}, {"rate", "kind"});
        const int k = draft.own_node(j.at("node"));
        model.add(PrescribedDisplacement{j.at("direction").direction(), draft.at(k), number("rate", 1)}, {k},
                  StructureDraft::kind(j));
    } else if (type == rotation) {
        j.keys("a prescribed rotation", {"type", "node", "axis"}, {"rate", "kind"});
        model.add(PrescribedRotation(j.at("axis").direction(), number("rate", 1)), {draft.own_node(j.at("node"))},
                  StructureDraft::kind(j));
    } else if (type == drive) {
        j.keys("a rotation drive", {"type", "nodes", "axis"}, {"rate", "offset", "kind"});
        model.add(RotationDrive(j.at("axis").direction(), number("rate", 1), number("offset", 0)), draft.two_nodes(j),
                  StructureDraft::kind(j));
    } else if (type == fork) {
        j.keys("a fork", {"type", "node", "axis", "upright"});
        model.add(ForkSupport(j.at("axis").direction(), j.at("upright").direction()), {draft.own_node(j.at("node"))});
    } else if (type == prismatic) {
        j.keys("a prismatic joint", {"type", "nodes", "axis"});
        const auto ends = draft.two_nodes(j);
        model.add(PrismaticJoint(j.at("axis").direction(), draft.at(ends[1]) - draft.at(ends[0])), ends);
    } else if (type == revolute) {
        j.keys("a revolute joint", {"type", "nodes", "axis"});
        const auto ends = draft.two_nodes(j);
        model.add(RevoluteJoint(j.at("axis").direction(), Eigen::Vector3d::Zero(), draft.gap(j, ends)), ends);
    } else if (type == hinge) {
        j.keys("a hinge", {"type", "nodes"});
        const auto ends = draft.two_nodes(j);
        draft.check_planar(j, ends);
        model.add(PlanarHinge{Eigen::Vector3d::Zero(), draft.gap(j, ends)}, ends);
    } else {
        j.keys("a spherical joint", {"type", "nodes"});
        const auto ends = draft.two_nodes(j);
        model.add(SphericalJoint{Eigen::Vector3d::Zero(), draft.gap(j, ends)}, ends);
    }
}

}  // namespace equilibria::fem::detail
