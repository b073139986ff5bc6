#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/curves/critical_curve_trace.hpp>
#include <equilibria/core/error.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "branches.hpp"

namespace py = pybind11;

namespace equilibria::python {

namespace {

/// A problem whose functions are Python's. They are called by the calling thread alone, which holds the interpreter's
/// lock; what they throw passes through the library.
template <class Matrix, bool Symmetric>
struct PythonProblem {
    using Vector = Eigen::VectorXd;
    static constexpr bool symmetric = Symmetric;

    py::function residual_function, jacobian_function;
    py::object parameter_function;  ///< or None: central differences of the residual
    Eigen::Index size;
    std::optional<double> second;  ///< a second parameter, which the functions then take as well

    Vector residual(const Vector& q, double p) const { return vector(call(residual_function, q, p), "residual"); }
    Matrix tangent(const Vector& q, double p) const {
        auto y = call(jacobian_function, q, p).template cast<Matrix>();
        require(y.rows() == size && y.cols() == size, "jacobian",
                std::to_string(y.rows()) + " x " + std::to_string(y.cols()),
                "must be of the size " + std::to_string(size) + " x " + std::to_string(size));
        if constexpr (!std::is_same_v<Matrix, Eigen::MatrixXd>) y.makeCompressed();
        return y;
    }
    Vector parameter_derivative(const Vector& q, double p) const {
        if (!parameter_function.is_none()) return vector(call(parameter_function, q, p), "parameter_derivative");
        const double h = detail::third_root_of_rounding * std::max(1e-3, std::abs(p));
        return (residual(q, p + h) - residual(q, p - h)) / (2 * h);
    }

private:
    py::object call(const py::object& function, const Vector& q, double p) const {
        return second ? function(q, p, *second) : function(q, p);
    }
    Vector vector(const py::object& given, const char* name) const {
        const auto values = given.cast<Numbers>();
        require(values.ndim() == 1 && values.size() == size, name, values.size(),
                "must be a vector of " + std::to_string(size) + " numbers");
        return Eigen::Map<const Vector>(values.data(), size);
    }
};

py::dict point_of_problem(const auto& point) {
    py::dict y = evidence_of(point);
    y["q"] = py::cast(point.q);
    y["null_vector"] = py::cast(point.null_vector);
    y["left_null_vector"] = py::cast(point.left_null_vector);
    py::list tangents;
    for (const Direction& tangent : point.tangents) tangents.append(py::make_tuple(py::cast(tangent.q), tangent.p));
    y["tangents"] = std::move(tangents);
    return y;
}

template <class Problem>
py::dict branch_of(const Problem& problem, const Branch<Problem>& branch) {
    py::dict y = columns_of(branch);
    y["q"] = rows<double>(branch.points, static_cast<std::size_t>(problem.size),
                          [](const auto& at) -> const auto& { return at.q; });
    py::list events;
    for (const auto& event : branch.events) {
        py::dict one = point_of_problem(event.point);
        one["step"] = event.step;
        events.append(std::move(one));
    }
    y["events"] = std::move(events);
    return y;
}

/// The problems for all values of a second parameter.
template <class Problem>
struct PythonFamily {
    Problem functions;

    Problem operator()(double r) const {
        Problem y = functions;
        y.second = r;
        return y;
    }
};

py::dict curve_of(const auto& trace, Eigen::Index size) {
    py::dict y;
    // the one event that ends a curve is that p leaves its range: there its last point is put
    auto points = trace.branch.points;
    BranchEnd end = trace.branch.end;
    if (end == BranchEnd::event) {
        points.back() = trace.branch.crossings.back().point;
        end = BranchEnd::window;
    }
    y["r"] = column<double>(points, [](const auto& at) { return at.p; });
    y["p"] = column<double>(points, [](const auto& at) { return at.q.p; });
    y["gamma"] = column<double>(points, [](const auto& at) { return at.q.gamma; });
    y["q"] = rows<double>(points, static_cast<std::size_t>(size), [](const auto& at) -> const auto& { return at.q.q; });
    y["residual"] = column<double>(points, [](const auto& at) { return at.residual; });
    py::list special;
    for (const auto& point : trace.special)
        special.append(dict("kind", to_string(point.kind), "r", point.r, "p", point.at.p, "gamma", point.at.gamma, "q",
                            point.at.q, "step", point.step, "residual", point.residual));
    y["special"] = std::move(special);
    y["unexplained"] = unexplained_of(trace.branch);
    y["end"] = to_string(end);
    return y;
}

/// call(problem) of a problem whose functions these are.
py::dict with_problem(const py::function& residual, const py::function& jacobian, const py::object& by_parameter,
                      Eigen::Index size, bool symmetric, bool sparse, const auto& call) {
    const auto with = [&](auto problem) {
        problem.residual_function = residual;
        problem.jacobian_function = jacobian;
        problem.parameter_function = by_parameter;
        problem.size = size;
        return call(problem);
    };
    using Dense = Eigen::MatrixXd;
    using Sparse = Eigen::SparseMatrix<double>;
    if (sparse) return symmetric ? with(PythonProblem<Sparse, true>{}) : with(PythonProblem<Sparse, false>{});
    return symmetric ? with(PythonProblem<Dense, true>{}) : with(PythonProblem<Dense, false>{});
}

}  // namespace

void add_continuation(py::module_& m) {
    m.def(
        "continue_branch",
        [](const py::function& residual, const py::function& jacobian, const py::object& parameter_derivative,
           const Eigen::VectorXd& q, double p, double low, double high, int direction, bool symmetric, bool sparse,
           int most_steps, double first_step, double largest_step, double parameter_weight) {
            const auto options =
                continuation_options(low, high, most_steps, first_step, largest_step, parameter_weight);
            return with_problem(residual, jacobian, parameter_derivative, q.size(), symmetric, sparse,
                                [&](const auto& problem) {
                                    return branch_of(problem, continue_branch(problem, q, p, direction, options));
                                });
        },
        py::arg("residual"), py::arg("jacobian"), py::arg("parameter_derivative"), py::arg("q"), py::arg("p"),
        py::arg("low"), py::arg("high"), py::arg("direction"), py::arg("symmetric"), py::arg("sparse"),
        py::arg("most_steps"), py::arg("first_step"), py::arg("largest_step"), py::arg("parameter_weight"));
    m.def(
        "bifurcation_diagram",
        [](const py::function& residual, const py::function& jacobian, const py::object& parameter_derivative,
           const Eigen::VectorXd& q, double p, double low, double high, bool symmetric, bool sparse, int most_steps,
           double first_step, double largest_step, double parameter_weight, int most_branches, int slices, int checks,
           double amplitude) {
            DiagramOptions options;
            options.continuation =
                continuation_options(low, high, most_steps, first_step, largest_step, parameter_weight);
            options.most_branches = most_branches;
            options.slices = slices;
            options.checks = checks;
            options.amplitude = amplitude;
            return with_problem(residual, jacobian, parameter_derivative, q.size(), symmetric, sparse,
                                [&](const auto& problem) {
                                    return graph_of(
                                        bifurcation_diagram(problem, q, p, options),
                                        [&](const auto& branch) { return branch_of(problem, branch); },
                                        [](const auto& point) { return point_of_problem(point); });
                                });
        },
        py::arg("residual"), py::arg("jacobian"), py::arg("parameter_derivative"), py::arg("q"), py::arg("p"),
        py::arg("low"), py::arg("high"), py::arg("symmetric"), py::arg("sparse"), py::arg("most_steps"),
        py::arg("first_step"), py::arg("largest_step"), py::arg("parameter_weight"), py::arg("most_branches"),
        py::arg("slices"), py::arg("checks"), py::arg("amplitude"));
    m.def(
        "critical_curve",
        [](const py::function& residual, const py::function& jacobian, const py::object& parameter_derivative,
           bool folds, const Eigen::VectorXd& q, double p, const Eigen::VectorXd& null_vector,
           const Eigen::VectorXd& left_null_vector, double r, double low, double high, double p_low, double p_high,
           int direction, bool symmetric, bool sparse, int most_steps, double first_step, double largest_step,
           double parameter_weight) {
            const auto options =
                continuation_options(low, high, most_steps, first_step, largest_step, parameter_weight);
            return with_problem(
                residual, jacobian, parameter_derivative, q.size(), symmetric, sparse, [&](const auto& problem) {
                    using Problem = std::remove_cvref_t<decltype(problem)>;
                    CriticalPoint<Problem> start;
                    start.q = q;
                    start.p = p;
                    start.null_vector = null_vector;
                    start.left_null_vector = left_null_vector;
                    const PythonFamily<Problem> problems{problem};
                    const Interval within{p_low, p_high};
                    return folds ? curve_of(continue_folds(problems, start, r, direction, options, within), q.size())
                                 : curve_of(continue_bifurcations(problems, start, r, direction, options, within),
                                            q.size());
                });
        },
        py::arg("residual"), py::arg("jacobian"), py::arg("parameter_derivative"), py::arg("folds"), py::arg("q"),
        py::arg("p"), py::arg("null_vector"), py::arg("left_null_vector"), py::arg("r"), py::arg("low"),
        py::arg("high"), py::arg("p_low"), py::arg("p_high"), py::arg("direction"), py::arg("symmetric"),
        py::arg("sparse"), py::arg("most_steps"), py::arg("first_step"), py::arg("largest_step"),
        py::arg("parameter_weight"));
}

}  // namespace equilibria::python
