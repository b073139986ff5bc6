/// \file
/// Elements of a structure's text: beams by structure_json_beams.hpp, trusses, springs and rigid bodies.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
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
        e.keys("a truss", {"type", "nodes", "ea"},
               {"name", "strain", "planar", "mass", "prestress", "unstressed_length", "kind"});
        const auto ends = draft_.two_nodes(e);
        draft_.check_length(e, ends);
        Strain strain = Strain::green;
        if (const auto given = e.find("strain"))
            strain = given->choice({"green", "engineering"}) == 0 ? Strain::green : Strain::engineering;
        const double ea = e.at("ea").positive();
        draft_.count(e, 1);
        const auto length = unstressed_length(e, ea, (draft_.at(ends[1]) - draft_.at(ends[0])).norm(), strain);
        const auto mass = e.find("mass");
        if (planar_key(e)) {
            draft_.check_planar(e, ends);
            add_truss<2>(e, ea, ends, strain, length);
        } else {
            add_truss<3>(e, ea, ends, strain, length);
        }
        draft_.add_line(e, {{ends.begin(), ends.end()}, 2, false, mass ? mass->positive() : 0});
    }
    template <int Dimension>
    void add_truss(const JsonPlace& e, double ea, const std::array<int, 2>& ends, Strain strain,
                   const std::optional<double>& length) {
        const Eigen::Vector3d &a = draft_.at(ends[0]), &b = draft_.at(ends[1]);
        if (length)
            draft_.model().add(StressedTruss<Dimension>(ea, a, b, *length, strain), ends,
                               StructureDraft::kind(e, LoadKind::constant));
        else
            draft_.model().add(Truss<Dimension>(ea, a, b, strain), ends);
    }
    /// A truss's length without force, if that is not the drawn one.
    static std::optional<double> unstressed_length(const JsonPlace& e, double ea, double drawn, Strain strain) {
        const auto length = e.find("unstressed_length"), prestress = e.find("prestress"), kind = e.find("kind");
        if (length && prestress) prestress->refuse("must not be given with an unstressed length: one says the other");
        if (length) return length->positive();
        if (!prestress) {
            if (kind) kind->refuse("is for a prestress or an unstressed length, and the truss has none");
            return {};
        }
        const auto y = StressedTruss<3>::length_of_force(ea, drawn, prestress->number(), strain);
        if (!y)
            prestress->refuse(strain == Strain::green
                                  ? "must be above -0.19245 ea, the largest thrust of Green's strain"
                                  : "must be above -ea");
        return y;
    }
    void add_rotation_spring(const JsonPlace& e) {
        const bool grounded = e.find("node").has_value();
        e.keys("a rotation spring", {"type", grounded ? "node" : "nodes", "stiffness"}, {"planar"});
        const JsonPlace given = e.at("stiffness");
        draft_.count(e, 1);
        Model& model = draft_.model();
        if (planar_key(e)) {
            if (grounded)
                model.add(PlanarGroundSpring{given.positive()}, {draft_.own_node(e.at("node"))});
            else
                model.add(PlanarRotationSpring{given.positive()}, draft_.two_nodes(e));
            return;
        }
        if (!given.json().is_array() && !grounded) {
            model.add(RotationSpring{given.positive()}, draft_.two_nodes(e));
            return;
        }
        const Eigen::Vector3d stiffness =
            given.json().is_array() ? spring_vector(given) : Eigen::Vector3d::Constant(given.positive()).eval();
        if (grounded)
            model.add(RotationSprings<1>{stiffness}, {draft_.own_node(e.at("node"))});
        else
            model.add(RotationSprings<2>{stiffness}, draft_.two_nodes(e));
    }
    static Eigen::Vector3d spring_vector(const JsonPlace& given) {
        const Eigen::Vector3d y = given.vector();
        if (!(y.minCoeff() >= 0 && y.maxCoeff() > 0)) given.refuse("must not be negative, nor 0 all over");
        return y;
    }
    void add_point_spring(const JsonPlace& e) {
        e.keys("a point spring", {"type", "node", "stiffness"});
        const int k = draft_.own_node(e.at("node"));
        const Eigen::Vector3d stiffness = spring_vector(e.at("stiffness"));
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
