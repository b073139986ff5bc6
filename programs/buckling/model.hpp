// The structure that a file says. Its reader is a unit of its own, read_model.cpp: it takes as long to compile as all
// else of buckling, and compiles beside it.
#pragma once

#include <equilibria/io/structure/structure_input.hpp>
#include <string>

/// Throws InvalidArgument where the file cannot be read or says no structure (io/structure/structure_json.hpp).
equilibria::fem::StructureInput read_model(const std::string& path);
