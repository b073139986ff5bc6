#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <equilibria/formula/formula_model.hpp>
#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/run/threads.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>

#include "arrays.hpp"
#include "background.hpp"
#include "bindings.hpp"
#include "expression.hpp"
#include "reading.hpp"
#include "results.hpp"

namespace py = pybind11;

namespace equilibria::python {

namespace {

using Set = RootSet<RuntimeUnknowns>;

RunOptions run_options(std::uint64_t seed, unsigned thread_count) {
    RunOptions run;
    run.seed = seed;
    if (thread_count != 1) run.executor = threads(thread_count);
    return run;
}

FormulaStart start_of(const std::string& name) {
    if (name == "least_cost") return FormulaStart::least_cost;
    if (name == "total_degree") return FormulaStart::total_degree;
    if (name == "polyhedral") return FormulaStart::polyhedral;
    throw InvalidArgument("start", name, "must be least_cost, total_degree, polyhedral or a set of roots");
}

std::string polynomials_for(const std::string& program, const PolynomialSystem<double>& system) {
    std::ostringstream out;
    if (program == "phcpack")
        write_phcpack(out, system);
    else if (program == "bertini")
        write_bertini(out, system);
    else if (program == "homotopy_continuation")
        write_homotopy_continuation(out, system);
    else if (program == "macaulay2")
        write_macaulay2(out, system);
    else
        throw InvalidArgument("program", program, "must be phcpack, bertini, homotopy_continuation or macaulay2");
    return out.str();
}

/// take(q, to) for each row q of unknowns; `to` has `entries` numbers a row.
template <class Take>
py::array_t<double> for_rows(const FormulaModel& model, const Numbers& q, const std::vector<py::ssize_t>& entries,
                             const Take& take) {
    const int n = model.unknowns();
    require(q.ndim() >= 1 && q.shape(q.ndim() - 1) == n, "q", q.ndim() >= 1 ? q.shape(q.ndim() - 1) : 0,
            "must have a number for each unknown in its last dimension: " + std::to_string(n));
    std::vector<py::ssize_t> shape(q.shape(), q.shape() + q.ndim() - 1);
    py::ssize_t points = 1, width = 1;
    for (const py::ssize_t size : shape) points *= size;
    for (const py::ssize_t size : entries) shape.push_back(size), width *= size;
    py::array_t<double> y(shape);
    RuntimeArray<double> at(n);
    for (py::ssize_t k = 0; k < points; ++k) {
        for (int i = 0; i < n; ++i) at[i] = q.data()[k * n + i];
        take(at, y.mutable_data() + k * width);
    }
    return y;
}

/// Points of a sweep as rows of all parameters, and what is known of each.
py::dict sweep_rows(const FormulaModel& model, const Numbers& points, const RunOptions& run,
                    const SweepOptions& options, const py::object& progress, const Limit& limit) {
    const auto width = static_cast<py::ssize_t>(model.parameters.size());
    require(points.ndim() == 2 && points.shape(1) == width, "points", points.ndim() == 2 ? points.shape(1) : 0,
            "must have a row of all parameters for each point: " + std::to_string(width));
    const auto size = static_cast<std::size_t>(points.shape(0));
    std::vector<double> values(points.data(), points.data() + points.size());
    const ParameterPoints given{
        size, [&](std::uint64_t k) {
            RuntimeArray<double> p(static_cast<int>(width));
            for (int i = 0; i < p.size(); ++i)
                p[i] =
                    values[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
            return p;
        }};
    std::vector<SweptPoint> found;
    found.reserve(size);
    const SweepCounts counts = in_background(
        run, progress, Cancel::by_flag,
        [&](const RunOptions& how) {
            return sweep(model, given, [&](const SweptPoint& point) { found.push_back(point); }, how, options);
        },
        limit);
    py::dict y;
    y["count"] = column<std::int64_t>(found, [](const SweptPoint& p) { return p.real; });
    const auto indices = static_cast<std::size_t>(model.unknowns()) + 1;
    y["by_index"] = rows<std::int64_t>(found, indices, [&](const SweptPoint& p) {
        std::vector<std::int64_t> all = p.by_index;
        all.resize(indices);
        return all;
    });
    y["degenerate"] = column<std::int64_t>(found, [](const SweptPoint& p) { return p.degenerate; });
    y["distinct"] = column<std::int64_t>(found, [](const SweptPoint& p) { return p.distinct; });
    y["failed"] = column<std::int64_t>(found, [](const SweptPoint& p) { return p.failed; });
    y["clean"] = column<bool>(found, [](const SweptPoint& p) { return p.clean; });
    y["alarm"] = column<bool>(found, [](const SweptPoint& p) { return p.alarm; });
    y["vanishing_equation"] = column<bool>(found, [](const SweptPoint& p) { return p.vanishing_equation; });
    y["proved"] = column<std::int64_t>(found, [](const SweptPoint& p) { return p.proved; });
    y["paths"] = counts.paths;
    y["mixed_volume"] = counts.mixed_volume;
    y["seconds"] = counts.seconds;
    return y;
}

/// A set with its proof, where one is asked for, and the verdict that it gives.
EveryEquilibrium with_proof(const FormulaModel& model, Set set, const RunOptions& run, bool proved) {
    if (!proved) {
        EveryEquilibrium y;
        y.confirmed.assign(set.roots.size(), 0);
        y.set = std::move(set);
        return y;
    }
    const RunOptions whole{.seed = run.seed, .executor = run.executor};
    auto proof = prove(model, set, whole);
    return detail::with_verdict(std::move(set), std::move(proof), whole);
}

/// The set as the library has it, and as Python shows it; and its proof, or None.
py::tuple set_and_proof(EveryEquilibrium found, bool proved) {
    const auto set = std::make_shared<Set>(std::move(found.set));
    py::dict shown = to_python(*set);
    py::list directions;
    for (const DivergingPaths& away : found.at_infinity) {
        py::dict one;
        one["direction"] = column<double>(away.direction, [](double x) { return x; });
        one["paths"] = away.paths;
        one["residual"] = away.residual;
        directions.append(std::move(one));
    }
    shown["directions_at_infinity"] = std::move(directions);
    shown["confirmed"] = column<bool>(found.confirmed, [](char c) { return c != 0; });
    return py::make_tuple(set, shown, proved ? py::object(to_python(found.proof)) : py::none());
}

}  // namespace

void add_models(py::module_& m) {
    py::class_<Set, std::shared_ptr<Set>>(m, "RootSetData", "A root set as the compiled library has it");

    py::class_<FormulaModel>(m, "FormulaModel", "A model as data: names, values, and recorded formulas")
        .def(py::init([](const std::string& name, const std::vector<std::string>& angles,
                         const std::vector<std::string>& coordinates, const std::vector<std::string>& parameters,
                         const Numbers& values, bool has_potential, const SharedBuilder& builder,
                         const std::vector<Expression>& expressions) {
                 return formula_model({.name = name,
                                       .angles = angles,
                                       .coordinates = coordinates,
                                       .parameters = parameters,
                                       .values = runtime_array(values, "values"),
                                       .has_potential = has_potential,
                                       .steps = nullptr,
                                       .results = {}},
                                      *builder, formulas_of(expressions, *builder));
             }),
             py::arg("name"), py::arg("angles"), py::arg("coordinates"), py::arg("parameters"), py::arg("values"),
             py::arg("has_potential"), py::arg("builder"), py::arg("expressions"))
        .def_static(
            "parse", [](const std::string& text) { return model_of_text(text); }, py::arg("text"))
        .def_static(
            "read", [](const std::string& path) { return model_in_file(path); }, py::arg("path"))
        .def_readonly("name", &FormulaModel::name)
        .def_readonly("angles", &FormulaModel::angles)
        .def_readonly("coordinates", &FormulaModel::coordinates)
        .def_readonly("parameters", &FormulaModel::parameters)
        .def_readonly("has_potential", &FormulaModel::has_potential)
        .def_property_readonly("rates",
                               [](const FormulaModel& model) {
                                   return model.kinetics ? model.kinetics->rates : std::vector<std::string>();
                               })
        .def_property_readonly(
            "time", [](const FormulaModel& model) { return model.kinetics ? model.kinetics->time : std::string(); })
        .def_property_readonly("moves", [](const FormulaModel& model) { return model.kinetics != nullptr; })
        .def_property_readonly(
            "values",
            [](const FormulaModel& model) { return column<double>(model.values, [](double x) { return x; }); })
        .def("number_of_parameter",
             [](const FormulaModel& model, const std::string& name) {
                 return number_of_name(model.parameters, name, "parameter");
             })
        .def(
            "enumerate",
            [](const FormulaModel& model, const Numbers& p, std::uint64_t seed, unsigned thread_count,
               const std::string& start, bool more_digits, bool proved, const std::optional<double>& limit,
               const py::object& progress) {
                const auto at = runtime_array(p, "parameters");
                const FormulaStart how_to_start = start_of(start);
                return set_and_proof(
                    in_background(
                        run_options(seed, thread_count), progress, Cancel::by_flag,
                        [&](const RunOptions& run) {
                            if (proved && !more_digits) return every_equilibrium(model, at, run, how_to_start);
                            return with_proof(model, enumerate(model, at, run, how_to_start, more_digits), run, proved);
                        },
                        Limit{limit, true}),
                    proved);
            },
            py::arg("p"), py::arg("seed"), py::arg("threads"), py::arg("start"), py::arg("more_digits"),
            py::arg("prove"), py::arg("limit"), py::arg("progress"))
        .def(
            "enumerate_from",
            [](const FormulaModel& model, const std::shared_ptr<Set>& solved, const Numbers& p, std::uint64_t seed,
               unsigned thread_count, bool proved, const std::optional<double>& limit, const py::object& progress) {
                const auto at = runtime_array(p, "parameters");
                return set_and_proof(in_background(
                                         run_options(seed, thread_count), progress, Cancel::by_flag,
                                         [&](const RunOptions& run) {
                                             return with_proof(model, enumerate(model, *solved, at, run), run, proved);
                                         },
                                         Limit{limit, true}),
                                     proved);
            },
            py::arg("solved"), py::arg("p"), py::arg("seed"), py::arg("threads"), py::arg("prove"), py::arg("limit"),
            py::arg("progress"))
        .def(
            "prove",
            [](const FormulaModel& model, const std::shared_ptr<Set>& set, unsigned thread_count, int most_digits,
               const py::object& progress) {
                return to_python(in_background(
                    run_options(set->seed, thread_count), progress, Cancel::by_progress,
                    [&](const RunOptions& run) { return prove(model, *set, run, {.most_digits = most_digits}); }));
            },
            py::arg("roots"), py::arg("threads"), py::arg("most_digits"), py::arg("progress"))
        .def(
            "events",
            [](const FormulaModel& model, const Numbers& p, int active, double low, double high, std::uint64_t seed,
               unsigned thread_count, const std::optional<double>& limit, const py::object& progress) {
                const auto at = runtime_array(p, "parameters");
                return to_python(in_background(
                    run_options(seed, thread_count), progress, Cancel::by_progress,
                    [&](const RunOptions& run) { return find_events(model, at, active, {low, high}, run); },
                    Limit{limit}));
            },
            py::arg("p"), py::arg("active"), py::arg("low"), py::arg("high"), py::arg("seed"), py::arg("threads"),
            py::arg("limit"), py::arg("progress"))
        .def(
            "diagram",
            [](const FormulaModel& model, const Numbers& p, int active, double low, double high, std::uint64_t seed,
               unsigned thread_count, double largest_step, const std::optional<double>& limit,
               const py::object& progress) {
                const auto at = runtime_array(p, "parameters");
                BranchOptions branch = diagram_steps;
                branch.largest_step = largest_step;
                return to_python(in_background(
                                     run_options(seed, thread_count), progress, Cancel::by_progress,
                                     [&](const RunOptions& run) {
                                         return trace_diagram(model, at, active, {low, high}, run, branch);
                                     },
                                     Limit{limit}),
                                 model.unknowns());
            },
            py::arg("p"), py::arg("active"), py::arg("low"), py::arg("high"), py::arg("seed"), py::arg("threads"),
            py::arg("largest_step"), py::arg("limit"), py::arg("progress"))
        .def(
            "locus",
            [](const FormulaModel& model, const Numbers& p, std::array<int, 2> active, std::array<double, 2> x,
               std::array<double, 2> y, std::uint64_t seed, unsigned thread_count, int lines, int checks,
               const std::optional<double>& limit, const py::object& progress) {
                const auto at = runtime_array(p, "parameters");
                LocusOptions options;
                options.lines = lines;
                options.checks = checks;
                const Window window{{x[0], x[1]}, {y[0], y[1]}};
                return to_python(
                    in_background(
                        run_options(seed, thread_count), progress, Cancel::by_progress,
                        [&](const RunOptions& run) { return trace_locus(model, at, active, window, run, options); },
                        Limit{limit}),
                    model.unknowns());
            },
            py::arg("p"), py::arg("active"), py::arg("x"), py::arg("y"), py::arg("seed"), py::arg("threads"),
            py::arg("lines"), py::arg("checks"), py::arg("limit"), py::arg("progress"))
        .def(
            "sweep",
            [](const FormulaModel& model, const Numbers& points, std::uint64_t seed, unsigned thread_count, bool prove,
               const std::string& checkpoint, const std::optional<double>& limit, const py::object& progress) {
                SweepOptions options;
                options.prove = prove;
                RunOptions run = run_options(seed, thread_count);
                run.checkpoint = checkpoint;
                return sweep_rows(model, points, run, options, progress, {limit});
            },
            py::arg("points"), py::arg("seed"), py::arg("threads"), py::arg("prove"), py::arg("checkpoint"),
            py::arg("limit"), py::arg("progress"))
        .def(
            "export",
            [](const FormulaModel& model, const std::string& program, const Numbers& p) {
                return polynomials_for(program, polynomials_of(model, runtime_array(p, "parameters")));
            },
            py::arg("program"), py::arg("p"))
        .def(
            "residual",
            [](const FormulaModel& model, const Numbers& q, const Numbers& p) {
                const auto at = runtime_array(p, "parameters");
                const int n = model.unknowns();
                return for_rows(model, q, {n}, [&](const RuntimeArray<double>& unknowns, double* to) {
                    const auto f = equations_of(model, unknowns, at);
                    std::copy(f.begin(), f.end(), to);
                });
            },
            py::arg("q"), py::arg("p"))
        .def(
            "jacobian",
            [](const FormulaModel& model, const Numbers& q, const Numbers& p) {
                const auto at = runtime_array(p, "parameters");
                const int n = model.unknowns();
                return for_rows(model, q, {n, n}, [&](const RuntimeArray<double>& unknowns, double* to) {
                    const auto j = jacobian_of(model, unknowns, at);
                    std::copy(j[0], j[0] + n * n, to);
                });
            },
            py::arg("q"), py::arg("p"))
        .def(
            "potential",
            [](const FormulaModel& model, const Numbers& q, const Numbers& p) {
                const auto at = runtime_array(p, "parameters");
                return for_rows(model, q, {}, [&](const RuntimeArray<double>& unknowns, double* to) {
                    *to = potential_of(model, unknowns, at);
                });
            },
            py::arg("q"), py::arg("p"));
}

}  // namespace equilibria::python
