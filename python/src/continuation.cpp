#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
#include <equilibria/core/error.hpp>

#include "arrays.hpp"
#include "bindings.hpp"

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

    Vector residual(const Vector& q, double p) const { return vector(residual_function(q, p), "residual"); }
    Matrix tangent(const Vector& q, double p) const {
        auto y = jacobian_function(q, p).template cast<Matrix>();
        require(y.rows() == size && y.cols() == size, "jacobian",
                std::to_string(y.rows()) + " x " + std::to_string(y.cols()),
                "must be of the size " + std::to_string(size) + " x " + std::to_string(size));
        if constexpr (!std::is_same_v<Matrix, Eigen::MatrixXd>) y.makeCompressed();
        return y;
    }
    Vector parameter_derivative(const Vector& q, double p) const {
        if (!parameter_function.is_none()) return vector(parameter_function(q, p), "parameter_derivative");
        const double h = detail::third_root_of_rounding * std::max(1e-3, std::abs(p));
        return (residual(q, p + h) - residual(q, p - h)) / (2 * h);
    }

private:
    Vector vector(const py::object& given, const char* name) const {
        const auto values = given.cast<Numbers>();
        require(values.ndim() == 1 && values.size() == size, name, values.size(),
                "must be a vector of " + std::to_string(size) + " numbers");
        return Eigen::Map<const Vector>(values.data(), size);
    }
};

template <class Problem>
py::dict branch_of(const Problem& problem, const Eigen::VectorXd& q, double p, int direction,
                   const ContinuationOptions& options) {
    const auto branch = continue_branch(problem, q, p, direction, options);
    const auto n = static_cast<std::size_t>(problem.size);
    py::dict y;
    y["q"] = rows<double>(branch.points, n, [](const auto& at) -> const auto& { return at.q; });
    y["p"] = column<double>(branch.points, [](const auto& at) { return at.p; });
    y["negative"] = column<std::int64_t>(branch.points, [](const auto& at) { return at.negative.value_or(-1); });
    y["determinant_sign"] = column<std::int64_t>(branch.points, [](const auto& at) { return at.determinant_sign; });
    y["residual"] = column<double>(branch.points, [](const auto& at) { return at.residual; });
    y["arc_length"] = column<double>(branch.points, [](const auto& at) { return at.arc_length; });
    py::list events;
    for (const auto& event : branch.events) {
        py::dict one;
        one["kind"] = to_string(event.point.kind);
        one["p"] = event.point.p;
        one["q"] = py::cast(event.point.q);
        one["null_vector"] = py::cast(event.point.null_vector);
        one["residual"] = event.point.residual;
        one["curvature"] = event.point.curvature;
        one["step"] = event.step;
        py::list tangents;
        for (const Direction& tangent : event.point.tangents)
            tangents.append(py::make_tuple(py::cast(tangent.q), tangent.p));
        one["tangents"] = std::move(tangents);
        events.append(std::move(one));
    }
    y["events"] = std::move(events);
    py::list unexplained;
    for (const UnexplainedStep& step : branch.unexplained) unexplained.append(py::make_tuple(step.step, step.reason));
    y["unexplained"] = std::move(unexplained);
    y["end"] = to_string(branch.end);
    return y;
}

}  // namespace

void add_continuation(py::module_& m) {
    m.def(
        "continue_branch",
        [](const py::function& residual, const py::function& jacobian, const py::object& parameter_derivative,
           const Eigen::VectorXd& q, double p, double low, double high, int direction, bool symmetric, bool sparse,
           int most_steps, double first_step, double largest_step, double parameter_weight) {
            ContinuationOptions options;
            options.range = {low, high};
            options.most_steps = most_steps;
            options.branch.first_step = first_step;
            options.branch.largest_step = largest_step;
            options.branch.parameter_weight = parameter_weight;
            const auto with = [&](auto problem) {
                problem.residual_function = residual;
                problem.jacobian_function = jacobian;
                problem.parameter_function = parameter_derivative;
                problem.size = q.size();
                return branch_of(problem, q, p, direction, options);
            };
            using Dense = Eigen::MatrixXd;
            using Sparse = Eigen::SparseMatrix<double>;
            if (sparse) return symmetric ? with(PythonProblem<Sparse, true>{}) : with(PythonProblem<Sparse, false>{});
            return symmetric ? with(PythonProblem<Dense, true>{}) : with(PythonProblem<Dense, false>{});
        },
        py::arg("residual"), py::arg("jacobian"), py::arg("parameter_derivative"), py::arg("q"), py::arg("p"),
        py::arg("low"), py::arg("high"), py::arg("direction"), py::arg("symmetric"), py::arg("sparse"),
        py::arg("most_steps"), py::arg("first_step"), py::arg("largest_step"), py::arg("parameter_weight"));
}

}  // namespace equilibria::python
