/// \file
/// Structures as JSON, read strictly (strict_json.hpp; needs nlohmann/json):
///
///     {
///       "name": "frame",                                                                    optional
///       "nodes": {"A": [0, 0, 0], "B": [240, 0, 0], "C": [240, -240, 0]},
///       "sections": {"blade": {"ea": 1.28e6, "ga2": 4.9e5, "ga3": "rigid", "gj": 6e4, "ei2": 38470, "ei3": 9.6e7},
///                    "strip": {"ea": "rigid", "ga": "rigid", "ei": 1}},
///       "elements": [
///         {"type": "beam", "nodes": ["A", "B"], "section": "blade", "second": [0, 1, 0], "elements": 8,
///          "order": "quadratic"},
///         {"type": "arc", "nodes": ["A", "B"], "through": [120, 50, 0], "section": "blade"},
///         {"type": "truss", "nodes": ["A", "B"], "ea": 1000, "strain": "green", "planar": false},
///         {"type": "rotation_spring", "nodes": ["A", "B"], "stiffness": 3, "planar": false},
///         {"type": "point_spring", "node": "A", "stiffness": [1, 1, 1]},
///         {"type": "rigid_body", "nodes": ["A", "B", "C"], "planar": false}],
///       "supports": [{"node": "A", "fix": ["ux", "uy", "uz", "rx", "ry", "rz"]}],           optional
///       "joints": [                                                                         optional
///         {"type": "revolute", "nodes": ["A", "B"], "axis": [0, 0, 1]},
///         {"type": "spherical", "nodes": ["A", "B"]},
///         {"type": "hinge", "nodes": ["A", "B"]},
///         {"type": "prismatic", "nodes": ["A", "B"], "axis": [1, 0, 0]},
///         {"type": "prescribed_displacement", "node": "A", "direction": [1, 0, 0], "rate": 1},
///         {"type": "prescribed_rotation", "node": "A", "axis": [0, 0, 1], "rate": 1},
///         {"type": "rotation_drive", "nodes": ["A", "B"], "axis": [0, 0, 1], "rate": 1, "offset": 0}],
///       "loads": [                                                                          optional
///         {"node": "C", "force": [1, 0, 0], "moment": [0, 0, 0], "kind": "proportional"},
///         {"node": "C", "type": "follower", "force": [1, 0, 0], "moment": [0, 0, 0]}],
///       "parameter": {"name": "p", "low": -1, "high": 2, "first_step": 0.02, "largest_step": 0.2},
///       "measure": "C"                                                                      optional
///     }
///
/// nodes: in the order of the text they are numbered from 0; each must be one of an element's or a joint's.
/// sections: of beams in space, or of planar ones, as their keys say. Stiffnesses are positive, or "rigid" except one
///     of gj, ei2 and ei3, and a planar section's ei.
/// beam, arc: straight, or circular through a third point; 8 "elements" unless given, of order "linear", "quadratic"
///     (default) or "cubic", with 2, 3 or 4 nodes each. With a planar section all lies in the plane z = 0. Else
///     "second" is where axis 2 of the cross-section points to, as nearly as it can; by default z, or y for a straight
///     beam within 0.001 radians of z, and for an arc the normal of its plane, about which it turns to the left.
/// "planar" (default false): of a truss, for ux and uy alone; of a rotation spring, rz; of a rigid body, ux, uy and rz.
/// truss: "strain" is "green" (default) or "engineering".
/// supports: components as above, or "position", "rotation" and "all" of them.
/// joints: the two nodes of a revolute or spherical one, or of a hinge, which is planar, are at one place. Vectors have
///     any length but 0; a displacement or rotation is "rate" p (default 1; 0 holds the node).
/// loads: dead ones of size p ("proportional", default) or "constant", or follower loads of size p.
/// parameter: p, called "p" unless it has a name, from low to high; steps are optional.
/// measure: the node that is looked at; by default the first one with a load, or else the last one.
///
/// What is not called planar is spatial: it uses uz, rx and ry too. Where planar elements meet it these components are
/// fixed, at one of the nodes of a joint, at the node of a follower load.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/core/error.hpp>
#include <equilibria/fem/arc.hpp>
#include <equilibria/fem/joints.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/model.hpp>
#include <equilibria/fem/redundant_constraints.hpp>
#include <equilibria/fem/rigid_link.hpp>
#include <equilibria/fem/springs.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/fem/truss.hpp>
#include <equilibria/io/strict_json.hpp>

namespace equilibria::fem {

/// How much of a text is taken.
struct ParseLimits {
    std::size_t bytes = std::size_t{64} << 20;  ///< of the text, which takes up to 25 times its size while it is read
    std::size_t depth = 16;                     ///< of objects and lists in each other; the format has 4
    int elements = 100'000;                     ///< of the model, with joints; in a Structure each may take 70 kB
    int constraints = 2000;                     ///< see redundant_constraints: more of them are not looked at

    void validate() const {
        require(bytes >= 1, "bytes", bytes, "must be at least 1");
        require(depth >= 4, "depth", depth, "must be at least 4, as deep as the format");
        require(elements >= 1 && elements <= 10'000'000, "elements", elements, "must be 1 to 10000000");
        require(constraints >= 0, "constraints", constraints, "must not be negative");
    }
};

/// What a text says: see the file.
struct StructureInput {
    std::string name;
    Model model;
    std::map<std::string, int> nodes;  ///< their numbers; further nodes of the model are those within beams
    int measured = 0;                  ///< a node
    std::string parameter = "p";
    double low = 0, high = 0;
    std::optional<double> first_step, largest_step;
    bool conservative = true;  ///< the model is one for Structure; else for NonconservativeStructure
};

namespace detail {

using equilibria::detail::JsonError;
using equilibria::detail::JsonPlace;
using equilibria::detail::JsonText;

class StructureReader {
public:
    StructureReader(const JsonText& text, const ParseLimits& limits)
        : text_(text), root_(text.root, ""), limits_(limits) {}

    StructureInput read() {
        root_.keys("a structure", {"nodes", "elements", "parameter"},
                   {"name", "sections", "supports", "joints", "loads", "measure"});
        if (const auto name = root_.find("name")) y_.name = name->string();
        read_nodes();
        read_sections();
        if (root_.at("elements").size() == 0) root_.at("elements").refuse("must not be empty");
        for_each("elements", [&](const JsonPlace& e) { add_element(e); });
        for_each("joints", [&](const JsonPlace& j) { add_joint(j); });
        for (const auto& [name, node] : y_.nodes)
            if (!touched_[static_cast<std::size_t>(node)])
                root_.at("nodes").at(name).refuse("is used by no element and no joint");
        for_each("supports", [&](const JsonPlace& s) { add_support(s); });
        find_used();
        for_each("loads", [&](const JsonPlace& l) { add_load(l); });
        read_parameter();
        if (const auto measure = root_.find("measure")) measured_ = node(*measure);
        y_.measured = measured_.value_or(static_cast<int>(y_.nodes.size()) - 1);
        build();
        return std::move(y_);
    }

private:
    /// Calls read(entry) for each entry of a list of the root's.
    void for_each(const std::string& key, const auto& read) {
        const auto list = root_.find(key);
        if (!list) return;
        for (std::size_t k = 0; k < list->size(); ++k) {
            const JsonPlace entry = (*list)[k];
            try {
                read(entry);
            } catch (const JsonError&) {
                throw;
            } catch (const InvalidArgument& e) {
                entry.refuse(std::string("cannot be added: ") + e.what());
            }
            const auto& groups = y_.model.groups();
            owners_.resize(groups.size());
            for (std::size_t g = 0; g < groups.size(); ++g)
                if (const std::size_t size = groups[g]->size();
                    size > (owners_[g].empty() ? 0 : owners_[g].back().first))
                    owners_[g].emplace_back(size, entry);
        }
    }

    void read_nodes() {
        const JsonPlace nodes = root_.at("nodes");
        if (nodes.object().empty()) nodes.refuse("must not be empty");
        for (const std::string& name : text_.order.at("nodes")) {
            const int k = y_.nodes[name] = y_.model.add_node(nodes.at(name).vector());
            size_ = std::max(size_, at(k).norm());
        }
        touched_.resize(y_.nodes.size());
        bodies_.resize(y_.nodes.size());
    }

    int node(const JsonPlace& name) const {
        const auto found = y_.nodes.find(name.string());
        if (found == y_.nodes.end()) name.refuse("must be the name of a node");
        return found->second;
    }
    /// A node of an element's or a joint's.
    int own_node(const JsonPlace& name) {
        const int k = node(name);
        touched_[static_cast<std::size_t>(k)] = true;
        return k;
    }
    std::array<int, 2> two_nodes(const JsonPlace& entry) {
        const JsonPlace names = entry.at("nodes");
        if (names.size() != 2) names.refuse("must be a list of 2 nodes");
        const std::array<int, 2> y{own_node(names[0]), own_node(names[1])};
        if (y[0] == y[1]) names.refuse("must be different nodes");
        return y;
    }
    const Eigen::Vector3d& at(int node) const { return y_.model.at(node); }
    static std::string point(const Eigen::Vector3d& x) {
        return "(" + to_text(x(0)) + ", " + to_text(x(1)) + ", " + to_text(x(2)) + ")";
    }
    void check_length(const JsonPlace& entry, const std::array<int, 2>& nodes) const {
        const double length = (at(nodes[1]) - at(nodes[0])).norm();
        if (!(length > 0)) entry.at("nodes").refuse("must not both be at " + point(at(nodes[0])));
        if (!std::isfinite(length)) entry.at("nodes").refuse("must be at a finite distance");
    }
    void check_planar(const JsonPlace& entry, std::span<const int> nodes) const {
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (at(nodes[k])(2) != 0)
                entry.at("nodes")[k].refuse("must be in the plane z = 0, as all that is planar, not at " +
                                            point(at(nodes[k])));
    }
    /// So many more elements of the model.
    void count(const JsonPlace& entry, std::size_t more) {
        const std::size_t most = static_cast<std::size_t>(limits_.elements);
        if (more > most - elements_)
            entry.refuse("must not take the model above " + std::to_string(most) + " elements (ParseLimits)");
        elements_ += more;
    }

    static double stiffness(const JsonPlace& value) {
        if (value.json() == "rigid") return rigid;
        if (!value.json().is_number() || !(value.number() > 0)) value.refuse("must be a positive number or \"rigid\"");
        return value.number();
    }
    void read_sections() {
        const auto sections = root_.find("sections");
        if (!sections) return;
        for (const auto& [name, value] : sections->object().items()) {
            const JsonPlace s = sections->at(name);
            if (s.find("ga") || s.find("ei")) {
                s.keys("a planar section", {"ea", "ga", "ei"});
                planar_[name] = {stiffness(s.at("ea")), stiffness(s.at("ga")), s.at("ei").positive()};
            } else {
                s.keys("a section", {"ea", "ga2", "ga3", "gj", "ei2", "ei3"});
                const Section section{stiffness(s.at("ea")), stiffness(s.at("ga2")), stiffness(s.at("ga3")),
                                      stiffness(s.at("gj")), stiffness(s.at("ei2")), stiffness(s.at("ei3"))};
                if (std::isinf(std::min({section.gj, section.ei2, section.ei3})))
                    s.refuse("must not have gj, ei2 and ei3 all rigid");
                spatial_[name] = section;
            }
        }
    }

    void add_element(const JsonPlace& e) {
        enum { beam, arc, truss, rotation_spring, point_spring, rigid_body };
        switch (e.at("type").choice({"beam", "arc", "truss", "rotation_spring", "point_spring", "rigid_body"})) {
            case beam: return add_beam(e, false);
            case arc: return add_beam(e, true);
            case truss: return add_truss(e);
            case rotation_spring: return add_rotation_spring(e);
            case point_spring: return add_point_spring(e);
            case rigid_body: return add_body(e);
        }
    }

    void add_beam(const JsonPlace& e, bool curved) {
        const std::string& section = e.at("section").string();
        const bool planar = planar_.contains(section);
        if (!planar && !spatial_.contains(section)) e.at("section").refuse("must be the name of a section");
        if (planar && e.find("second")) e.at("second").refuse("is no key of a beam with a planar section");
        if (curved)
            e.keys("an arc", {"type", "nodes", "section", "through"}, {"second", "elements", "order"});
        else
            e.keys("a beam", {"type", "nodes", "section"}, {"second", "elements", "order"});
        const auto ends = two_nodes(e);
        check_length(e, ends);
        if (planar) check_planar(e, ends);
        int elements = 8;
        if (const auto given = e.find("elements")) elements = given->integer(1, limits_.elements);
        count(e, static_cast<std::size_t>(elements));
        std::size_t order = 1;
        if (const auto given = e.find("order")) order = given->choice({"linear", "quadratic", "cubic"});
        const int steps = elements * static_cast<int>(order + 1);

        std::optional<Arc> arc;
        if (curved) arc = read_arc(e, ends, planar, steps);
        if (planar) {
            const PlanarSection& s = planar_.at(section);
            double first = 0, turn = 0;
            if (arc) {
                first = std::atan2(arc->tangent(1), arc->tangent(0));
                turn = arc->normal(2) > 0 ? arc->angle : -arc->angle;
            }
            const auto frame = [&](double t) { return PlanarSectionFrame{arc->at(t), first + turn * t}; };
            with_nodes(order, [&]<int N>() {
                if (arc)
                    add_planar_beam<N>(y_.model, s, frame, elements, ends[0], ends[1]);
                else
                    add_straight_planar_beam<N>(y_.model, s, ends[0], ends[1], elements);
            });
        } else {
            const Section& s = spatial_.at(section);
            const Eigen::Vector3d second = read_second(e, ends, arc);
            const auto frame = [&](double t) { return section_frame(arc->at(t), arc->direction(t), second); };
            with_nodes(order, [&]<int N>() {
                if (arc)
                    fem::add_beam<N>(y_.model, s, frame, elements, ends[0], ends[1]);
                else
                    add_straight_beam<N>(y_.model, s, ends[0], ends[1], second, elements);
            });
        }
    }
    static void with_nodes(std::size_t order, const auto& add) {
        if (order == 0)
            add.template operator()<2>();
        else if (order == 1)
            add.template operator()<3>();
        else
            add.template operator()<4>();
    }
    Arc read_arc(const JsonPlace& e, const std::array<int, 2>& ends, bool planar, int steps) const {
        const JsonPlace through = e.at("through");
        const auto arc = Arc::through(at(ends[0]), through.vector(), at(ends[1]));
        if (!arc)
            through.refuse("must not be on a line with the nodes, at " + point(at(ends[0])) + " and " +
                           point(at(ends[1])));
        if (planar && through.vector()(2) != 0) through.refuse("must be in the plane z = 0, as the section is planar");
        const double right_angle = std::numbers::pi / 2 * (1 + 1e-9);
        if (arc->angle > right_angle * steps)
            e.refuse("must have more elements, so that neighbouring nodes turn by at most a right angle, not " +
                     to_text(arc->angle / steps) + " radians");
        return *arc;
    }
    Eigen::Vector3d read_second(const JsonPlace& e, const std::array<int, 2>& ends,
                                const std::optional<Arc>& arc) const {
        const Eigen::Vector3d axis = (at(ends[1]) - at(ends[0])).normalized(), z = Eigen::Vector3d::UnitZ();
        const auto given = e.find("second");
        if (!given) return arc ? arc->normal : axis.cross(z).norm() > 1e-3 ? z : Eigen::Vector3d::UnitY();
        const Eigen::Vector3d second = given->direction();
        if (!arc && axis.cross(second).norm() < 1e-6) given->refuse("must not be along the beam");
        if (arc && arc->clearance(second) < 0.1)
            given->refuse("must be 0.1 radians off all tangents of the arc: the nearest is off by " +
                          to_text(arc->clearance(second)));
        return second;
    }

    static bool planar_key(const JsonPlace& e) {
        const auto planar = e.find("planar");
        return planar && planar->boolean();
    }
    void add_truss(const JsonPlace& e) {
        e.keys("a truss", {"type", "nodes", "ea"}, {"strain", "planar"});
        const auto ends = two_nodes(e);
        check_length(e, ends);
        Strain strain = Strain::green;
        if (const auto given = e.find("strain"))
            strain = given->choice({"green", "engineering"}) == 0 ? Strain::green : Strain::engineering;
        const double ea = e.at("ea").positive();
        count(e, 1);
        if (planar_key(e)) {
            check_planar(e, ends);
            y_.model.add(Truss<2>(ea, at(ends[0]), at(ends[1]), strain), ends);
        } else {
            y_.model.add(Truss<3>(ea, at(ends[0]), at(ends[1]), strain), ends);
        }
    }
    void add_rotation_spring(const JsonPlace& e) {
        e.keys("a rotation spring", {"type", "nodes", "stiffness"}, {"planar"});
        const auto ends = two_nodes(e);
        const double stiffness = e.at("stiffness").positive();
        count(e, 1);
        if (planar_key(e))
            y_.model.add(PlanarRotationSpring{stiffness}, ends);
        else
            y_.model.add(RotationSpring{stiffness}, ends);
    }
    void add_point_spring(const JsonPlace& e) {
        e.keys("a point spring", {"type", "node", "stiffness"});
        const int k = own_node(e.at("node"));
        const Eigen::Vector3d stiffness = e.at("stiffness").vector();
        if (!(stiffness.minCoeff() >= 0 && stiffness.maxCoeff() > 0))
            e.at("stiffness").refuse("must not be negative, nor 0 all over");
        count(e, 1);
        y_.model.add(PointSpring<3>{stiffness, at(k)}, {k});
    }
    void add_body(const JsonPlace& e) {
        e.keys("a rigid body", {"type", "nodes"}, {"planar"});
        const JsonPlace names = e.at("nodes");
        if (names.size() < 2) names.refuse("must be at least 2 nodes");
        std::vector<int> nodes;
        for (std::size_t k = 0; k < names.size(); ++k) {
            nodes.push_back(own_node(names[k]));
            auto taken = bodies_.begin() + nodes.back();
            if (*taken) names[k].refuse("must be named once in one rigid body: all nodes of a body stand in one list");
            *taken = true;
        }
        count(e, nodes.size() - 1);
        if (!planar_key(e)) return add_rigid_body(y_.model, nodes);
        check_planar(e, nodes);
        add_rigid_body<2>(y_.model, nodes);
    }

    void add_joint(const JsonPlace& j) {
        enum { revolute, spherical, hinge, prismatic, displacement, rotation, drive };
        const std::size_t type =
            j.at("type").choice({"revolute", "spherical", "hinge", "prismatic", "prescribed_displacement",
                                 "prescribed_rotation", "rotation_drive"});
        count(j, 1);
        const auto number = [&](const char* key, double otherwise) {
            const auto given = j.find(key);
            return given ? given->number() : otherwise;
        };
        Model& model = y_.model;
        if (type == displacement) {
            j.keys("a prescribed displacement", {"type", "node", "direction"}, {"rate"});
            const int k = own_node(j.at("node"));
            model.add(PrescribedDisplacement{j.at("direction").direction(), at(k), number("rate", 1)}, {k});
        } else if (type == rotation) {
            j.keys("a prescribed rotation", {"type", "node", "axis"}, {"rate"});
            model.add(PrescribedRotation(j.at("axis").direction(), number("rate", 1)), {own_node(j.at("node"))});
        } else if (type == drive) {
            j.keys("a rotation drive", {"type", "nodes", "axis"}, {"rate", "offset"});
            model.add(RotationDrive(j.at("axis").direction(), number("rate", 1), number("offset", 0)), two_nodes(j));
        } else if (type == prismatic) {
            j.keys("a prismatic joint", {"type", "nodes", "axis"});
            const auto ends = two_nodes(j);
            model.add(PrismaticJoint(j.at("axis").direction(), at(ends[1]) - at(ends[0])), ends);
        } else if (type == revolute) {
            j.keys("a revolute joint", {"type", "nodes", "axis"});
            const auto ends = two_nodes(j);
            model.add(RevoluteJoint(j.at("axis").direction(), Eigen::Vector3d::Zero(), gap(j, ends)), ends);
        } else if (type == hinge) {
            j.keys("a hinge", {"type", "nodes"});
            const auto ends = two_nodes(j);
            check_planar(j, ends);
            model.add(PlanarHinge{Eigen::Vector3d::Zero(), gap(j, ends)}, ends);
        } else {
            j.keys("a spherical joint", {"type", "nodes"});
            const auto ends = two_nodes(j);
            model.add(SphericalJoint{Eigen::Vector3d::Zero(), gap(j, ends)}, ends);
        }
    }
    /// From the second to the first node of a joint that holds them at one place: rounding alone.
    Eigen::Vector3d gap(const JsonPlace& j, const std::array<int, 2>& ends) const {
        const Eigen::Vector3d &a = at(ends[0]), &b = at(ends[1]);
        if (!((a - b).norm() <= 1e-9 * size_))
            j.at("nodes").refuse("must be at one place, but are at " + point(a) + " and " + point(b));
        return a - b;
    }

    void add_support(const JsonPlace& s) {
        s.keys("a support", {"node", "fix"});
        const int k = node(s.at("node"));
        const JsonPlace words = s.at("fix");
        if (words.size() == 0) words.refuse("must not be empty");
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::size_t word =
                words[i].choice({"ux", "uy", "uz", "rx", "ry", "rz", "position", "rotation", "all"});
            for (std::size_t c = 0; c < 6; ++c)
                if (word == c || word == 8 || (word == 6 && c < 3) || (word == 7 && c >= 3))
                    y_.model.fix(k, {Component(c)});
        }
    }

    /// Which components elements and joints use, or supports fix, as Structure has it.
    void find_used() {
        used_.resize(static_cast<std::size_t>(y_.model.nodes()));
        for (const auto& group : y_.model.groups())
            for (std::size_t e = 0; e < group->size(); ++e)
                for (int k = 0; k < group->n_nodes(); ++k)
                    for (int c = 0; c < group->n_components(); ++c) {
                        const Component component = group->components()[c];
                        used_[holder(group->nodes(e)[k], component)][component] = true;
                    }
        for (int k = 0; k < y_.model.nodes(); ++k)
            for (const Component c : spatial)
                if (y_.model.fixed(k, c)) used_[holder(k, c)][c] = true;
    }
    /// Of a node's component: the node, or the one whose rotation it shares.
    std::size_t holder(int node, Component c) const {
        return static_cast<std::size_t>(c < rx ? node : y_.model.rotates_with(node));
    }

    void add_load(const JsonPlace& l) {
        constexpr const char* names[] = {"ux", "uy", "uz", "rx", "ry", "rz"};
        const auto type = l.find("type");
        const bool follows = type && type->choice({"dead", "follower"}) == 1;
        if (follows)
            l.keys("a follower load", {"type", "node"}, {"force", "moment"});
        else
            l.keys("a load", {"node"}, {"type", "force", "moment", "kind"});
        const int k = node(l.at("node"));
        const auto force = l.find("force"), moment = l.find("moment");
        if (!force && !moment) l.refuse("must have a force or a moment");
        const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), f = force ? force->vector() : zero,
                              m = moment ? moment->vector() : zero;
        for (const Component c : spatial) {
            if (used_[holder(k, c)][c]) continue;
            if (follows)
                l.at("node").refuse(
                    std::string("must be a node whose components are all used by elements, or fixed: ") + names[c] +
                    " is not");
            if ((c < rx ? f(c) : m(c - rx)) != 0)
                (c < rx ? force : moment)->refuse(std::string("must act on what elements use: not along ") + names[c]);
        }
        if (follows) {
            count(l, 1);
            y_.model.add(FollowerLoad{f, m}, {k});
        } else {
            const auto kind = l.find("kind");
            const bool constant = kind && kind->choice({"proportional", "constant"}) == 1;
            y_.model.load(k, f, m, constant ? LoadKind::constant : LoadKind::proportional);
        }
        if (!measured_) measured_ = k;
    }

    void read_parameter() {
        const JsonPlace p = root_.at("parameter");
        p.keys("the parameter", {"low", "high"}, {"name", "first_step", "largest_step"});
        if (const auto name = p.find("name")) y_.parameter = name->string();
        y_.low = p.at("low").number();
        y_.high = p.at("high").number();
        if (!(y_.low < y_.high)) p.at("low").refuse("must be below high, " + to_text(y_.high));
        if (const auto step = p.find("first_step")) y_.first_step = step->positive();
        if (const auto step = p.find("largest_step")) y_.largest_step = step->positive();
        if (y_.first_step && y_.largest_step && *y_.first_step > *y_.largest_step)
            p.at("first_step").refuse("must not be above largest_step, " + to_text(*y_.largest_step));
    }

    /// Makes a structure of the model: to see what it is, and that its start is sound.
    void build() {
        try {
            std::optional<Structure> structure;
            try {
                structure.emplace(y_.model);
            } catch (const InvalidArgument&) {
                y_.conservative = false;
            }
            if (structure)
                check(*structure);
            else
                check(NonconservativeStructure(y_.model));
        } catch (const JsonError&) {
            throw;
        } catch (const InvalidArgument& e) {
            throw JsonError("structure", equilibria::detail::in_short(y_.name),
                            std::string("cannot be built: ") + e.what());
        }
    }
    template <bool Conservative>
    void check(const BasicStructure<Conservative>& structure) const {
        const StructureState start = structure.initial();
        const Eigen::SparseMatrix<double> k = structure.tangent(start, 0);
        if (!structure.residual(start, 0).allFinite() || !k.coeffs().allFinite())
            throw JsonError(
                "structure", equilibria::detail::in_short(y_.name),
                "must have finite forces and stiffnesses at the start: some number is too large or too small");
        const auto found = redundant_constraints(structure, k, limits_.constraints);
        if (!found.multipliers.empty())
            owner(found.multipliers.front())
                .refuse("must not be over-constrained: at the start " + std::to_string(found.multipliers.size()) +
                        " of the structure's " + std::to_string(found.constraints) +
                        " constraints depend on the others, or it is a dead point; let a joint or a support hold less");
    }
    /// The entry of the text that a multiplier belongs to.
    const JsonPlace& owner(int multiplier) const {
        const auto& groups = y_.model.groups();
        for (std::size_t g = 0;; ++g) {
            const int each = groups[g]->multipliers(), all = each * static_cast<int>(groups[g]->size());
            if (multiplier >= all) {
                multiplier -= all;
                continue;
            }
            const std::size_t e = static_cast<std::size_t>(multiplier / each);
            return std::upper_bound(owners_[g].begin(), owners_[g].end(), e,
                                    [](std::size_t k, const auto& o) { return k < o.first; })
                ->second;
        }
    }

    const JsonText& text_;
    JsonPlace root_;
    ParseLimits limits_;
    StructureInput y_;
    std::map<std::string, PlanarSection> planar_;
    std::map<std::string, Section> spatial_;
    double size_ = 0;  // the largest distance of a node from the origin
    std::size_t elements_ = 0;
    std::vector<bool> touched_;  // nodes of elements and joints
    std::vector<bool> bodies_;   // nodes of rigid bodies
    std::vector<std::array<bool, 6>> used_;
    std::vector<std::vector<std::pair<std::size_t, JsonPlace>>> owners_;  // of a group's elements up to a number
    std::optional<int> measured_;
};

}  // namespace detail

/// The structure that a text says. Throws InvalidArgument for a text that is not one, as the file has it; beyond the
/// format, elements without length, nodes that nothing uses, loads on what no element holds, and constraints that are
/// redundant at the start, such as joints of a spatial four-bar that are all revolute.
inline StructureInput parse_structure(std::string_view text, const ParseLimits& limits = {}) {
    limits.validate();
    const auto json = equilibria::detail::parse_json(text, limits.bytes, limits.depth);
    return detail::StructureReader(json, limits).read();
}

/// The structure in a file. Throws InvalidArgument also where the file cannot be read.
inline StructureInput read_structure(const std::string& path, const ParseLimits& limits = {}) {
    limits.validate();
    return parse_structure(equilibria::detail::read_text(path, limits.bytes), limits);
}

}  // namespace equilibria::fem
