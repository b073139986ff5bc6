#include <string>

#include <pybind11/pybind11.h>

#include <equilibria/core/error.hpp>
#include <equilibria/storage/checkpoint_error.hpp>
#include <equilibria/version.hpp>

#include "bindings.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_core, m) {
    m.doc() = "The compiled part of the package equilibria; its functions are named in equilibria.Model";
    m.attr("__version__") = std::to_string(EQUILIBRIA_VERSION_MAJOR) + "." + std::to_string(EQUILIBRIA_VERSION_MINOR) +
                            "." + std::to_string(EQUILIBRIA_VERSION_PATCH);
    py::register_exception<equilibria::InvalidArgument>(m, "InvalidArgument", PyExc_ValueError).doc() =
        "An argument, a formula or a model that breaks a rule: names it, quotes its value and says what is allowed";
    py::register_exception<equilibria::CheckpointError>(m, "CheckpointError", PyExc_RuntimeError).doc() =
        "A file of a run's finished part that cannot be used: of another run, damaged, or in use";
    equilibria::python::add_expressions(m);
    equilibria::python::add_models(m);
    equilibria::python::add_motion(m);
    equilibria::python::add_continuation(m);
    equilibria::python::add_structures(m);
}
