// What the engine answers beside the documents of `equilibria`.
#pragma once

#include <string>

namespace explorer {

enum class Structure { star_dome, right_angle_frame };

/// How a structure buckles: the places of its nodes without load, the nodes of each element, and all branches with the
/// shapes along them.
std::string structure_document(Structure which);

}  // namespace explorer
