/// \file
/// The parts of the extension module equilibria._core, which the modules of the package give names, tables and plots.
#pragma once

#include <pybind11/pybind11.h>

namespace equilibria::python {

void add_expressions(pybind11::module_& m);
void add_models(pybind11::module_& m);
void add_motion(pybind11::module_& m);
void add_continuation(pybind11::module_& m);
void add_structures(pybind11::module_& m);

}  // namespace equilibria::python
