/// \file
/// Elements of a structure's text: beams by structure_json_beams.hpp, trusses, springs and rigid bodies.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/fem/rigid_link.hpp>
#include <equilibria/fem/springs.hpp>
#include <equilibria/fem/truss.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/detail/structure_json_beams.hpp>
#include <equilibria/io/structure/detail/structure_json_draft.hpp>

namespace equilibria::fem::detail {

/// Adds elements to a draft that has all of its nodes.
class ElementReader {
public:
    ElementReader(StructureDraft& draft, SectionTable sections)
        : draft_(draft), beams_(draft, std::move(sections)), in_body_(draft.nodes().size()) {}

    void add(const JsonPlace& e) {
        enum { beam, arc, truss, rotation_spring, point_spring, rigid_body };
        switch (e.at("type").choice({"beam", "arc", "truss", "rotation_spring", "point_spring", "rigid_body"})) {
            case beam: return beams_.add(e, false);
            case arc: return beams_.add(e, true);
            case truss: return add_truss(e);
            case rotation_spring: return add_rotation_spring(e);
            case point_spring: return add_point_spring(e);
            case rigid_body: return add_body(e);
        }
    }

private:
    static bool planar_key(const JsonPlace& e) {
        const auto planar = e.find("planar");
        return planar && planar->boolean();
    }
    void add_truss(const JsonPlace& e) {
        e.keys("a truss", {"type", "nodes", "ea"}, {"strain", "planar"});
        const auto ends = draft_.two_nodes(e);
        draft_.check_length(e, ends);
        Strain strain = Strain::green;
        if (const auto given = e.find("strain"))
            strain = given->choice({"green", "engineering"}) == 0 ? Strain::green : Strain::engineering;
        const double ea = e.at("ea").positive();
        draft_.count(e, 1);
        if (planar_key(e)) {
            draft_.check_planar(e, ends);
            draft_.model().add(Truss<2>(ea, draft_.at(ends[0]), draft_.at(ends[1]), strain), ends);
        } else {
            draft_.model().add(Truss<3>(ea, draft_.at(ends[0]), draft_.at(ends[1]), strain), ends);
        }
    }
    void add_rotation_spring(const JsonPlace& e) {
        e.keys("a rotation spring", {"type", "nodes", "stiffness"}, {"planar"});
        const auto ends = draft_.two_nodes(e);
        const double stiffness = e.at("stiffness").positive();
        draft_.count(e, 1);
        if (planar_key(e))
            draft_.model().add(PlanarRotationSpring{stiffness}, ends);
        else
            draft_.model().add(RotationSpring{stiffness}, ends);
    }
    void add_point_spring(const JsonPlace& e) {
        e.keys("a point spring", {"type", "node", "stiffness"});
        const int k = draft_.own_node(e.at("node"));
        const Eigen::Vector3d stiffness = e.at("stiffness").vector();
        if (!(stiffness.minCoeff() >= 0 && stiffness.maxCoeff() > 0))
            e.at("stiffness").refuse("must not be negative, nor 0 all over");
        draft_.count(e, 1);
        draft_.model().add(PointSpring<3>{stiffness, draft_.at(k)}, {k});
    }
    void add_body(const JsonPlace& e) {
        e.keys("a rigid body", {"type", "nodes"}, {"planar"});
        const JsonPlace names = e.at("nodes");
        if (names.size() < 2) names.refuse("must be at least 2 nodes");
        std::vector<int> nodes;
        for (std::size_t k = 0; k < names.size(); ++k) {
            nodes.push_back(draft_.own_node(names[k]));
            auto taken = in_body_.begin() + nodes.back();
            if (*taken) names[k].refuse("must be named once in one rigid body: all nodes of a body stand in one list");
            *taken = true;
        }
        draft_.count(e, nodes.size() - 1);
        if (!planar_key(e)) return add_rigid_body(draft_.model(), nodes);
        draft_.check_planar(e, nodes);
        add_rigid_body<2>(draft_.model(), nodes);
    }

    StructureDraft& draft_;
    BeamReader beams_;
    std::vector<bool> in_body_;  // nodes of rigid bodies
};

}  // namespace equilibria::fem::detail
