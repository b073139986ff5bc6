/// \file
/// Models and structures from text. Apart, since the reader's grammar and Python's headers both have a name `digit`.
#pragma once

#include <string>

#include <equilibria/formula/formula_model.hpp>
#include <equilibria/io/structure/structure_input.hpp>

namespace equilibria::python {

FormulaModel model_of_text(const std::string& text);
FormulaModel model_in_file(const std::string& path);
fem::StructureInput structure_of_text(const std::string& text);

}  // namespace equilibria::python
