/// \file
/// What searches return, as dictionaries of numpy's arrays, numbers and texts: the fields of the classes in
/// equilibria/results.py.
#pragma once

#include <pybind11/pybind11.h>

#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/plane/locus_result.hpp>

namespace equilibria::python {

pybind11::dict to_python(const RootSet<RuntimeUnknowns>& set);
pybind11::dict to_python(const ProofOfRoots& proof);
pybind11::dict to_python(const LineEvents<RuntimeUnknowns>& events);
pybind11::dict to_python(const BifurcationDiagram<RuntimeUnknowns>& diagram, int unknowns);
pybind11::dict to_python(const Locus<RuntimeUnknowns>& locus, int unknowns);

}  // namespace equilibria::python
