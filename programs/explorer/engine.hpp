// What the engine answers beside the documents of `equilibria`.
#pragma once

#include <string>

#include <equilibria/io/strict_json.hpp>

namespace explorer {

enum class Structure { star_dome, right_angle_frame };

/// How a structure buckles: the places of its nodes without load, the nodes of each element, and all branches with the
/// shapes along them.
std::string structure_document(Structure which);

/// The answer to `solve`, `diagram`, `locus` or `motion` where the request's model is the study "body_beam": a rotating
/// body with an elastic beam of one mode a direction (docs/body-beam.md). Its unknowns are the axis, the modes, the
/// moment of inertia about the axis and the speed; its equilibria are counted up to the sense of turning.
std::string body_beam_document(const std::string& command, const equilibria::detail::JsonPlace& request);

}  // namespace explorer
