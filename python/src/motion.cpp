#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <equilibria/formula/formula_model.hpp>
#include <equilibria/studies/formula_model/formula_motion.hpp>

#include "arrays.hpp"
#include "background.hpp"
#include "bindings.hpp"
#include "expression.hpp"

namespace py = pybind11;

namespace equilibria::python {

namespace {

FormulaFormulation formulation_of(const std::string& name) {
    if (name == "lagrange") return FormulaFormulation::lagrange;
    if (name == "hamilton") return FormulaFormulation::hamilton;
    throw InvalidArgument("formulation", name, "must be lagrange or hamilton");
}

py::dict to_python(const Motion<RuntimeUnknowns>& motion, int unknowns) {
    const auto n = static_cast<std::size_t>(unknowns);
    const auto& points = motion.points;
    py::dict y;
    y["t"] = column<double>(points, [](const auto& x) { return x.time; });
    y["q"] = rows<double>(points, n, [](const auto& x) -> const auto& { return x.q; });
    y["v"] = rows<double>(points, n, [](const auto& x) -> const auto& { return x.velocity; });
    y["momentum"] = rows<double>(points, n, [](const auto& x) -> const auto& { return x.momentum; });
    y["kinetic"] = column<double>(points, [](const auto& x) { return x.kinetic; });
    y["potential"] = column<double>(points, [](const auto& x) { return x.potential; });
    y["work"] = column<double>(points, [](const auto& x) { return x.work; });
    y["dissipated"] = column<double>(points, [](const auto& x) { return x.dissipated; });
    y["balance"] = column<double>(points, [](const auto& x) { return x.balance; });
    y["status"] = to_string(motion.status);
    y["time"] = motion.time;
    y["steps"] = motion.steps;
    y["evaluations"] = motion.evaluations;
    y["largest_balance"] = motion.largest_balance;
    return y;
}

std::optional<Formula> formula_of(const std::optional<Expression>& expression, const FormulaBuilder& builder) {
    if (!expression) return std::nullopt;
    return formulas_of({*expression}, builder)[0];
}

}  // namespace

void add_motion(py::module_& m) {
    m.def(
        "with_kinetics",
        [](const FormulaModel& model, const SharedBuilder& builder, const std::vector<std::string>& rates,
           const std::string& time, const Expression& kinetic_energy, const std::optional<Expression>& dissipation,
           const std::vector<Expression>& generalised_forces) {
            return with_kinetics(model, *builder,
                                 {.rates = rates,
                                  .time = time,
                                  .kinetic_energy = *formula_of(kinetic_energy, *builder),
                                  .dissipation = formula_of(dissipation, *builder),
                                  .generalised_forces = formulas_of(generalised_forces, *builder)});
        },
        py::arg("model"), py::arg("builder"), py::arg("rates"), py::arg("time"), py::arg("kinetic_energy"),
        py::arg("dissipation"), py::arg("generalised_forces"));
    m.def(
        "integrate_motion",
        [](const FormulaModel& model, const Numbers& p, const Numbers& q, const Numbers& v, const Numbers& times,
           const std::string& formulation, double tolerance, double largest_step, std::uint64_t most_steps,
           const py::object& progress) {
            const auto at = runtime_array(p, "parameters");
            const MotionState<RuntimeUnknowns> start{runtime_array(q, "start"), runtime_array(v, "rates")};
            require(times.ndim() == 1, "times", times.ndim(), "must have one dimension");
            const std::vector<double> asked(times.data(), times.data() + times.size());
            const MotionOptions options{tolerance, tolerance, largest_step, most_steps};
            const FormulaFormulation which = formulation_of(formulation);
            return to_python(in_background(RunOptions(), progress, Cancel::by_flag,
                                           [&](const RunOptions& run) {
                                               return integrate_motion(model, at, start, asked, options, run, which);
                                           }),
                             model.unknowns());
        },
        py::arg("model"), py::arg("p"), py::arg("q"), py::arg("v"), py::arg("times"), py::arg("formulation"),
        py::arg("tolerance"), py::arg("largest_step"), py::arg("most_steps"), py::arg("progress"));
    m.def(
        "poles",
        [](const FormulaModel& model, const Numbers& q, const Numbers& p) {
            const auto counted = count_poles(model, runtime_array(q, "q"), runtime_array(p, "parameters"));
            py::array_t<std::complex<double>> y(counted.poles.size());
            std::copy(counted.poles.begin(), counted.poles.end(), y.mutable_data());
            return py::make_tuple(y, std::string(to_string(counted.verdict())));
        },
        py::arg("model"), py::arg("q"), py::arg("p"));
    m.def(
        "kinetic_energy",
        [](const FormulaModel& model, const Numbers& q, const Numbers& v, const Numbers& p) {
            return kinetic_energy_of(model, runtime_array(q, "q"), runtime_array(v, "v"),
                                     runtime_array(p, "parameters"));
        },
        py::arg("model"), py::arg("q"), py::arg("v"), py::arg("p"));
}

}  // namespace equilibria::python
