"""Each broken rule gives one clear InvalidArgument, and the interpreter goes on."""

import math

import numpy as np
import pytest

import equilibria as eq
from models import rotating_chain


def pendulum(function=lambda t, p: -eq.cos(t[0]) - p.m * eq.sin(t[0]), **parameters):
    return eq.Model(function, angles=1, parameters=parameters or {"m": 1.0})


@pytest.mark.parametrize(
    "function, said",
    [
        (lambda t, p: t[0] ** 2, "a power of an angle"),
        (lambda t, p: t[0], "whole formula that is an angle"),
        (lambda t, p: p.m * t[0] + eq.cos(t[0]), "only inside sin and cos"),
        (lambda t, p: eq.cos(p.m * t[0]), "integer multiples"),
        (lambda t, p: eq.cos(t[0] / 2), "half angle"),
        (lambda t, p: eq.cos(eq.cos(t[0])), "cos of an expression of unknowns"),
        (lambda t, p: p.m / t[0], "division by an angle"),
        (lambda t, p: p.m / eq.cos(t[0]), "division by an expression of unknowns"),
        (lambda t, p: eq.cos(t[0]) ** 0.5, "the power 0.5"),
        (lambda t, p: eq.cos(t[0]) ** p.m, "a power by a parameter"),
        (lambda t, p: 2 ** eq.cos(t[0]), "a power by an expression of unknowns"),
        (lambda t, p: eq.sqrt(eq.cos(t[0])), "sqrt of an expression of unknowns"),
        (lambda t, p: eq.tan(t[0]), "tan of an angle"),
        (lambda t, p: p.n * eq.cos(t[0]), "parameter = n: must be m"),
        (lambda t, p: eq.cos(t[1]), "number of angle = 1: must be 0 to 0"),
        (lambda t, p: eq.cos(t.b), "angle = b: must be t1"),
        (lambda t, p: eq.cos(t[0]) if p.m else 0, "the truth of an expression"),
        (lambda t, p: eq.cos(t[0]) if p.m > 0 else 0, "the comparison of an expression"),
        (lambda t, p: eq.cos(t[0]) * (p.m == 1), "the comparison of an expression"),
        (lambda t, p: math.cos(t[0]), "value of an expression as a number"),
        (lambda t, p: abs(eq.cos(t[0])), "absolute value"),
        (lambda t, p: math.nan * eq.cos(t[0]), "must be finite"),
        (lambda t, p: eq.cos(t[0]) / 0, "must not be 0"),
        (lambda t, p: None, "must be an expression"),
        (lambda t, p: [eq.cos(t[0]), eq.cos(t[0])], "number of equations"),
        (lambda t, p: [], "number of equations"),
    ],
)
def test_formula(function, said):
    with pytest.raises(eq.InvalidArgument, match=said) as error:
        pendulum(function)
    assert isinstance(error.value, ValueError) and "\n" not in str(error.value)


def test_expression_of_another_model():
    kept = []
    pendulum(lambda t, p: kept.append(p.m) or eq.cos(t[0]))
    with pytest.raises(eq.InvalidArgument, match="another model"):
        pendulum(lambda t, p: kept[0] * eq.cos(t[0]))
    with pytest.raises(eq.InvalidArgument, match="another model"):
        pendulum(lambda t, p: kept[0])


def test_other_types_are_type_errors():
    for other in ("2", None, 1j, True, [1]):
        with pytest.raises(TypeError):
            pendulum(lambda t, p: other * eq.cos(t[0]))


@pytest.mark.parametrize(
    "call, said",
    [
        (lambda m: m.enumerate(k=2), "parameter = k: must be alpha, omega or r"),
        (lambda m: m.enumerate(alpha=math.nan), "alpha = nan: must be finite"),
        (lambda m: m.enumerate(alpha="much"), "alpha = 'much': must be a number"),
        (lambda m: m.enumerate(seed=-1), "seed = -1"),
        (lambda m: m.enumerate(threads=-1), "threads = -1"),
        (lambda m: m.enumerate(start="nowhere"), "start = nowhere"),
        (lambda m: m.enumerate(start=rotating_chain().enumerate()), "another model"),
        (lambda m: m.prove(None), "roots"),
        (lambda m: m.enumerate().prove(most_digits=20), "15, 34 or 68"),
        (lambda m: m.events("omega", (2, 1)), "smaller to the larger"),
        (lambda m: m.events("omega", (1, 1)), "smaller to the larger"),
        (lambda m: m.events("omega", 1), "range = 1"),
        (lambda m: m.events("omega", (0, math.inf)), "finite"),
        (lambda m: m.events("x", (0, 1)), "parameter = x"),
        (lambda m: m.diagram("omega", (2, 1)), "smaller to the larger"),
        (lambda m: m.locus(x=("alpha", 0, 1), y=("alpha", 0, 1)), "two different parameters"),
        (lambda m: m.locus(x=("alpha", 1, 0), y=("omega", 0, 1)), "smaller to the larger"),
        (lambda m: m.locus(x="alpha", y=("omega", 0, 1)), "x = 'alpha'"),
        (lambda m: m.locus(x=("alpha", 0, 1), y=("omega", 0, 1), lines=1), "lines = 1"),
        (lambda m: m.sweep({}), "must name a parameter"),
        (lambda m: m.sweep({"beta": [1]}), "parameter = beta"),
        (lambda m: m.sweep({"alpha": [math.nan]}), "finite"),
        (lambda m: m.sweep({"alpha": ["much"]}), "arrays of numbers"),
        (lambda m: m.residual([1, 2, 3]), "q = 3"),
        (lambda m: m.residual("q"), "q = 'q'"),
        (lambda m: m.diagram("omega", (0.5, 1)).plot(unknown="t3"), "unknown = 't3'"),
    ],
)
def test_arguments(call, said):
    with pytest.raises(eq.InvalidArgument, match=said):
        call(rotating_chain())


def test_names_and_values():
    for arguments, said in [
        (dict(angles=["a", "a"]), "twice"),
        (dict(angles=["sin"]), "sin"),
        (dict(angles=["two words"]), "letters"),
        (dict(angles="t1"), "list of names"),
        (dict(angles=-1), "angles = -1"),
        (dict(angles=1, parameters={"m": math.inf}), "m = inf"),
        (dict(angles=1, parameters={"m": "1 kg"}), "m = '1 kg'"),
        (dict(angles=1, parameters={"m": [1, 2]}), "m = "),
    ]:
        with pytest.raises(eq.InvalidArgument, match=said):
            eq.Model(lambda t, p: eq.cos(t[0]), **arguments)
    with pytest.raises(eq.InvalidArgument, match="unknown"):
        eq.Model(lambda t, p: p.a, parameters={"a": 1})


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "JSON|text"),
        ('{"angles": ["a"], "potential": "cos(b)"}', "no name b"),
        ('{"angles": ["a"], "potential": "a^2"}', "line 1, column"),
        ('{"angles": ["a"], "potential": "cos(a"}', "line 1, column"),
        ('{"angles": ["a"], "force": "cos(a)"}', "force"),
    ],
)
def test_texts(text, said):
    with pytest.raises(eq.InvalidArgument, match=said):
        eq.Model.parse(text)


def test_sympy_expressions():
    sympy = pytest.importorskip("sympy")
    a, b, x = sympy.symbols("a b x")
    for expression, said in [
        (sympy.cos(a) + b, "symbol = b"),
        (sympy.Abs(sympy.cos(a)), "expression = Abs"),
        (sympy.cos(a / 2), "half angle"),
        (1 / sympy.cos(a), "division by"),
        (sympy.I * sympy.cos(a), "expression = I"),
        (sympy.nan, "expression = nan"),
        ([sympy.cos(a), sympy.sin(a)], "number of equations"),
    ]:
        with pytest.raises(eq.InvalidArgument, match=said):
            eq.Model.from_sympy(expression, angles=[a])


def test_interpreter_is_alive_and_numpy_works():
    model = eq.Model(
        lambda t, p: -np.cos(t[0]) * np.float64(2)
        - np.sin(t[1] - t[0]) * np.int64(3)
        + np.sqrt(p.k) * np.cos(t[1])
        + np.dot(np.array([0.5, 0.25]), np.array([np.cos(t[0]), np.cos(t[1])])),
        angles=2,
        parameters={"k": 4.0},
    )
    q = np.array([0.3, -1.2])
    v = -2 * np.cos(q[0]) - 3 * np.sin(q[1] - q[0]) + 2 * np.cos(q[1]) + 0.5 * np.cos(q[0]) + 0.25 * np.cos(q[1])
    assert model.potential(q) == pytest.approx(v, abs=1e-14)
    assert model.enumerate().clean
