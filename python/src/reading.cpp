#include "reading.hpp"

#include <string>

#include <equilibria/io/read_model.hpp>
#include <equilibria/io/structure/structure_json.hpp>

namespace equilibria::python {

FormulaModel model_of_text(const std::string& text) { return parse_model(text); }
FormulaModel model_in_file(const std::string& path) { return read_model(path); }
fem::StructureInput structure_of_text(const std::string& text) { return fem::parse_structure(text); }

}  // namespace equilibria::python
