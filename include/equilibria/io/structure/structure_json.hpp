/// \file
/// Structures as JSON, read strictly (strict_json.hpp; needs nlohmann/json):
///
///     {
///       "name": "frame",                                                                    optional
///       "nodes": {"A": [0, 0, 0], "B": [240, 0, 0], "C": [240, -240, 0]},
///       "sections": {"blade": {"ea": 1.28e6, "ga2": 4.9e5, "ga3": "rigid", "gj": 6e4, "ei2": 38470, "ei3": 9.6e7,
///                              "mass": 2.1, "shear_centre": [0.3, 0], "polar_radius": 0.6, "wagner": [0, 0]},
///                    "strip": {"ea": "rigid", "ga": "rigid", "ei": 1}},
///       "elements": [
///         {"type": "beam", "nodes": ["A", "B"], "section": "blade", "second": [0, 1, 0], "elements": 8,
///          "order": "quadratic", "name": "girder"},
///         {"type": "arc", "nodes": ["A", "B"], "through": [120, 50, 0], "section": "blade"},
///         {"type": "truss", "nodes": ["A", "B"], "ea": 1000, "strain": "green", "planar": false, "mass": 0.3,
///          "prestress": 40},
///         {"type": "rotation_spring", "nodes": ["A", "B"], "stiffness": 3, "planar": false},
///         {"type": "rotation_spring", "node": "A", "stiffness": [0, 5, 2]},
///         {"type": "point_spring", "node": "A", "stiffness": [1, 1, 1]},
///         {"type": "rigid_body", "nodes": ["A", "B", "C"], "planar": false}],
///       "supports": [{"node": "A", "fix": ["ux", "uy", "uz", "rx", "ry", "rz"]}],           optional
///       "joints": [                                                                         optional
///         {"type": "revolute", "nodes": ["A", "B"], "axis": [0, 0, 1]},
///         {"type": "spherical", "nodes": ["A", "B"]},
///         {"type": "hinge", "nodes": ["A", "B"]},
///         {"type": "prismatic", "nodes": ["A", "B"], "axis": [1, 0, 0]},
///         {"type": "fork", "node": "A", "axis": [1, 0, 0], "upright": [0, 0, 1]},
///         {"type": "prescribed_displacement", "node": "A", "direction": [1, 0, 0], "rate": 1, "kind": "constant"},
///         {"type": "prescribed_rotation", "node": "A", "axis": [0, 0, 1], "rate": 1},
///         {"type": "rotation_drive", "nodes": ["A", "B"], "axis": [0, 0, 1], "rate": 1, "offset": 0}],
///       "loads": [                                                                          optional
///         {"node": "C", "force": [1, 0, 0], "moment": [0, 0, 0], "kind": "proportional"},
///         {"node": "C", "type": "follower", "force": [1, 0, 0], "moment": [0, 0, 0]},
///         {"type": "distributed", "elements": ["girder"], "force": [0, -1, 0]},
///         {"type": "self_weight", "gravity": [0, -9.81, 0], "kind": "constant"},
///         {"type": "pressure", "elements": ["arch"], "pressure": 1}],
///       "parameter": {"name": "p", "low": -1, "high": 2, "direction": "both", "first_step": 0.02,
///                     "largest_step": 0.2, "parameter_weight": 0.5},
///       "measure": "C"                                                                      optional
///     }
///
/// nodes: in the order of the text they are numbered from 0; each must be one of an element's or a joint's.
/// sections: of beams in space, or of planar ones, as their keys say. Stiffnesses are positive, or "rigid" except one
///     of gj, ei2 and ei3, and a planar section's ei. In space "shear_centre" is its place in axes 2 and 3 from the
///     nodes' line, "polar_radius" the mean distance of the section from it (root of the mean square; by default its
///     own distance, the least that there can be), "wagner" the two coefficients of bending: fem::ShearCentre.
/// beam, arc: straight, or circular through a third point; 8 "elements" unless given, of order "linear", "quadratic"
///     (default) or "cubic", with 2, 3 or 4 nodes each. With a planar section all lies in the plane z = 0. Else
///     "second" is where axis 2 of the cross-section points to, as nearly as it can; by default z, or y for a straight
///     beam within 0.001 radians of z, and for an arc the normal of its plane, about which it turns to the left.
/// "planar" (default false): of a truss, for ux and uy alone; of a rotation spring, rz; of a rigid body, ux, uy and rz.
/// truss: "strain" is "green" (default) or "engineering". "prestress" is its force where it is drawn, tension positive;
///     or "unstressed_length" says it. It comes with the constant loads, or with p if its "kind" is "proportional".
/// rotation_spring: of two nodes, or of one against the ground; a stiffness about all axes, or about each fixed axis as
///     it is without load.
/// "mass": per length, of sections and trusses, for a self-weight.
/// "name": by which loads know a beam, an arc or a truss.
/// supports: components as above, or "position", "rotation" and "all" of them.
/// joints: the two nodes of a revolute or spherical one, or of a hinge, which is planar, are at one place. Vectors have
///     any length but 0; a displacement or rotation is "rate" p (default 1; 0 holds the node), or "rate" if "constant".
///     A fork holds a beam's end against twist alone: see fem::ForkSupport.
/// loads: of size p ("proportional", default) or "constant". Constant ones, constant motions and prestress come in a
///     first stage, from 0 to 1; p begins at 0 after it (fem::loaded_state). "dead" ones (default) keep their
///     direction, "follower" loads turn with their node. A distributed load is dead, per length of the elements without
///     load; a self-weight "gravity" times "mass". A pressure acts per length of the deformed line, from the right hand
///     side of its direction in the x-y plane; the line is closed or its ends are fixed.
/// parameter: p, called "p" unless it has a name, within its window, from low to high; all else is optional.
///     "direction" is "up", "down" or "both": where p goes from the unloaded state, p = 0. By default p goes both ways
///     from a 0 within the window, else towards the window. Steps are lengths: root mean squares over the nodes,
///     of displacements in shares of the structure's size and of rotations in radians, together with "parameter_weight"
///     times p (branch_options.hpp).
/// measure: the node that is looked at; by default the first one with a load, or else the last one.
///
/// What is not called planar is spatial: it uses uz, rx and ry too. Where planar elements meet it these components are
/// fixed, at one of the nodes of a joint, at the node of a follower load.
#pragma once

#include <string>
#include <string_view>

#include <equilibria/io/read_text.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/detail/structure_json_reader.hpp>
#include <equilibria/io/structure/structure_input.hpp>

namespace equilibria::fem {

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
    return parse_structure(equilibria::read_text(path, limits.bytes), limits);
}

}  // namespace equilibria::fem
