// Reads a structure's file for buckling.
#include <equilibria/io/structure/structure_json.hpp>

#include "buckling/model.hpp"

equilibria::fem::StructureInput read_model(const std::string& path) { return equilibria::fem::read_structure(path); }
