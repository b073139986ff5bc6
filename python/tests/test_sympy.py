import numpy as np
import pytest

import equilibria as eq

sympy = pytest.importorskip("sympy")


def test_values_are_those_of_sympy_at_random_points():
    t, u, x = sympy.symbols("t u x")
    a, b = sympy.symbols("a b", positive=True)
    expressions = [
        -sympy.cos(t) - a * sympy.cos(t - 2 * u + b) ** 3 + sympy.Rational(1, 3) * sympy.sin(u),
        (a * sympy.cos(t) + sympy.sqrt(b) * sympy.sin(u)) ** 2 / (a + b) + x**4 - x * sympy.pi,
        sympy.exp(-a) * sympy.cos(t + sympy.pi / 6) + sympy.log(b) * x**2 + sympy.tan(a) * sympy.sin(u) ** 2,
        sympy.cos(t) * b ** sympy.Rational(3, 2) / a**2 + 1.25 * sympy.sin(u) * x / sympy.sqrt(a) - a**b,
        -(sympy.cos(t) - x) * (sympy.sin(u) - 2) - sympy.E * x,
    ]
    draw = np.random.default_rng(2)
    for v in expressions:
        values = {a: 0.7, b: 1.9}
        model = eq.Model.from_sympy(v, angles=[t, u], coordinates=[x], parameters=values)
        f = [sympy.diff(v, s) for s in (t, u, x)]
        number = sympy.lambdify((t, u, x, a, b), [v, *f])
        for _ in range(20):
            q = draw.uniform(-3, 3, 3)
            p = dict(zip("ab", draw.uniform(0.2, 2, 2)))
            expected = number(*q, p["a"], p["b"])
            assert model.potential(q, p) == pytest.approx(expected[0], rel=1e-12, abs=1e-12)
            assert model.residual(q, **p) == pytest.approx(expected[1:], rel=1e-11, abs=1e-11)


def test_equations_and_functions_of_time():
    time = sympy.Symbol("time")
    theta = sympy.Function("theta")(time)
    k = sympy.Symbol("k")
    model = eq.Model.from_sympy(sympy.Matrix([sympy.sin(theta) - k]), angles=[theta], parameters={k: 0.5})
    assert model.unknowns == ["theta"] and not model.has_potential
    assert sorted(model.enumerate().angles[:, 0]) == pytest.approx([np.pi / 6, 5 * np.pi / 6])
