#include "expression.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/operators.h>
#include <pybind11/pybind11.h>

#include <equilibria/core/error.hpp>

#include "bindings.hpp"

namespace py = pybind11;

namespace equilibria::python {

namespace {

const char* kind_of(const Formula& formula) {
    switch (formula.kind) {
        case FormulaKind::constant: return "of parameters and numbers alone";
        case FormulaKind::angle: return "an angle";
        case FormulaKind::polynomial: return "of unknowns";
        case FormulaKind::motion: return "of a motion";
    }
    return "";
}

void require_same(const Expression& a, const FormulaBuilder& builder) {
    require(a.builder.get() == &builder, "expression", "of another model",
            "must be made of the unknowns and parameters that the model's function was given");
}

/// The operand b of an operator whose other operand is a; nothing where it is neither an expression nor a real number.
std::optional<Formula> operand(const Expression& a, const py::handle& b) {
    if (py::isinstance<Expression>(b)) {
        const auto& other = b.cast<const Expression&>();
        require_same(other, *a.builder);
        return other.formula;
    }
    if (PyBool_Check(b.ptr()) || PyComplex_Check(b.ptr()) || PyUnicode_Check(b.ptr()) || py::hasattr(b, "__len__") ||
        !(PyIndex_Check(b.ptr()) || py::hasattr(b, "__float__")))
        return std::nullopt;
    const double value = PyFloat_AsDouble(b.ptr());
    if (value == -1 && PyErr_Occurred()) throw py::error_already_set();
    return a.builder->number(value);
}

using Binary = Formula (FormulaBuilder::*)(const Formula&, const Formula&);
using Unary = Formula (FormulaBuilder::*)(const Formula&);

py::object not_implemented() { return py::reinterpret_borrow<py::object>(Py_NotImplemented); }

void binary(py::class_<Expression>& c, const char* name, const char* reflected, Binary operation) {
    c.def(
        name,
        [operation](const Expression& a, const py::object& b) -> py::object {
            const auto other = operand(a, b);
            if (!other) return not_implemented();
            return py::cast(Expression{a.builder, ((*a.builder).*operation)(a.formula, *other)});
        },
        py::is_operator());
    c.def(
        reflected,
        [operation](const Expression& a, const py::object& b) -> py::object {
            const auto other = operand(a, b);
            if (!other) return not_implemented();
            return py::cast(Expression{a.builder, ((*a.builder).*operation)(*other, a.formula)});
        },
        py::is_operator());
}

void unary(py::class_<Expression>& c, const char* name, Unary operation, const char* doc) {
    c.def(
        name, [operation](const Expression& a) { return Expression{a.builder, ((*a.builder).*operation)(a.formula)}; },
        doc);
}

[[noreturn]] void refuse_choice(const char* what) {
    throw InvalidArgument("formula", what,
                          "must not decide anything: a model's function is called once, to be recorded, and is one "
                          "formula for all values of unknowns and parameters");
}

}  // namespace

std::vector<Formula> formulas_of(const std::vector<Expression>& expressions, const FormulaBuilder& builder) {
    std::vector<Formula> formulas;
    for (const Expression& expression : expressions) {
        require_same(expression, builder);
        formulas.push_back(expression.formula);
    }
    return formulas;
}

void add_expressions(py::module_& m) {
    py::class_<Expression> c(m, "Expression",
                             "A formula of unknowns and parameters that is being written: + - * / ** with numbers and "
                             "other formulas, and the methods sin, cos, tan, sqrt, exp and log, which numpy's "
                             "functions call");
    binary(c, "__add__", "__radd__", &FormulaBuilder::sum);
    binary(c, "__sub__", "__rsub__", &FormulaBuilder::difference);
    binary(c, "__mul__", "__rmul__", &FormulaBuilder::product);
    binary(c, "__truediv__", "__rtruediv__", &FormulaBuilder::quotient);
    c.def(
        "__pow__",
        [](const Expression& a, const py::object& b, const py::object& modulus) -> py::object {
            const auto other = operand(a, b);
            if (!other || !modulus.is_none()) return not_implemented();
            return py::cast(Expression{a.builder, a.builder->power(a.formula, *other)});
        },
        py::arg("exponent"), py::arg("modulus") = py::none(), py::is_operator());
    c.def(
        "__rpow__",
        [](const Expression& a, const py::object& b, const py::object& modulus) -> py::object {
            const auto other = operand(a, b);
            if (!other || !modulus.is_none()) return not_implemented();
            return py::cast(Expression{a.builder, a.builder->power(*other, a.formula)});
        },
        py::arg("base"), py::arg("modulus") = py::none(), py::is_operator());
    unary(c, "__neg__", &FormulaBuilder::negative, "");
    c.def("__pos__", [](const Expression& a) { return a; });
    unary(c, "sin", &FormulaBuilder::sine,
          "The sine; of an angle, in radians, or of parameters; in a motion of anything");
    unary(c, "cos", &FormulaBuilder::cosine,
          "The cosine; of an angle, in radians, or of parameters; in a motion of anything");
    unary(c, "tan", &FormulaBuilder::tangent, "The tangent, of parameters; in a motion of anything");
    unary(c, "sqrt", &FormulaBuilder::square_root, "The square root, of parameters; in a motion of anything");
    unary(c, "exp", &FormulaBuilder::exponential, "The exponential function, of parameters; in a motion of anything");
    unary(c, "log", &FormulaBuilder::logarithm, "The natural logarithm, of parameters; in a motion of anything");
    c.def("square",
          [](const Expression& a) { return Expression{a.builder, a.builder->power(a.formula, a.builder->number(2))}; });
    c.def("__bool__", [](const Expression&) -> bool { refuse_choice("the truth of an expression"); });
    c.def("__float__", [](const Expression&) -> double { refuse_choice("the value of an expression as a number"); });
    c.def("__abs__", [](const Expression&) -> double { refuse_choice("the absolute value of an expression"); });
    for (const char* comparison : {"__eq__", "__ne__", "__lt__", "__le__", "__gt__", "__ge__"})
        c.def(comparison,
              [](const Expression&, const py::object&) -> bool { refuse_choice("the comparison of an expression"); });
    c.def("__hash__", [](const Expression& a) { return reinterpret_cast<std::uintptr_t>(&a); });
    c.def("__repr__",
          [](const Expression& a) { return std::string("<equilibria.Expression ") + kind_of(a.formula) + ">"; });

    py::class_<FormulaBuilder, SharedBuilder>(m, "FormulaBuilder",
                                              "Makes the expressions of one model's unknowns and parameters")
        .def(py::init<int, int, int>(), py::arg("angles"), py::arg("coordinates"), py::arg("parameters"))
        .def("number", [](const SharedBuilder& b, double value) { return Expression{b, b->number(value)}; })
        .def("angle", [](const SharedBuilder& b, int i) { return Expression{b, b->angle(i)}; })
        .def("coordinate", [](const SharedBuilder& b, int j) { return Expression{b, b->coordinate(j)}; })
        .def("parameter", [](const SharedBuilder& b, int k) { return Expression{b, b->parameter(k)}; })
        .def("rate", [](const SharedBuilder& b, int i) { return Expression{b, b->rate(i)}; })
        .def("time", [](const SharedBuilder& b) { return Expression{b, b->time()}; })
        .def("begin_motion", [](const SharedBuilder& b) { b->set_rules(FormulaRules::motion); });
}

}  // namespace equilibria::python
