"""10,000 formulas drawn from a grammar: their values are sympy's, to rounding."""

import json
import math
import random

import pytest

import equilibria as eq

sympy = pytest.importorskip("sympy")

ANGLES, COORDINATES = ["t", "u"], ["x", "y"]
PARAMETERS = {"a": 0.7, "b": 1.3, "long_name": 0.45}
POINT = [0.4, -1.1, 0.8, -0.6]


class Draw:
    """Formulas as text, each with a bound of its summands' absolute values, which rounding is measured against."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def number(self):
        text = self.random.choice(["2", "3.5", ".25", "1e-1", "0.125", "1.5E0", "7"])
        return text, float(text)

    def constant(self, depth):
        """Of parameters alone: functions have arguments between 0.2 and 3, divisors are 0.2 or more."""
        kind = self.random.randrange(8 if depth > 0 else 2)
        if kind == 0:
            return self.number()
        if kind == 1:
            name = self.random.choice(list(PARAMETERS))
            return name, PARAMETERS[name]
        if kind == 2:
            function = self.random.choice(["sqrt", "exp", "log", "sin", "cos", "tan"])
            name = self.random.choice(list(PARAMETERS))
            return f"{function}({name} + .25)", 8.0
        if kind == 3:
            (top, size), name = self.constant(depth - 1), self.random.choice(list(PARAMETERS))
            return f"({top})/{name}", size / PARAMETERS[name]
        if kind == 4:
            (text, size), power = self.constant(depth - 1), self.random.choice([0, 1, 2, 3])
            return f"({text})^{power}", max(1.0, size) ** power
        if kind == 5:
            name = self.random.choice(list(PARAMETERS))
            return f"{name}^{self.random.choice(['-2', '0.5', '(a - b)', '-a'])}", 6.0
        return self.both(self.constant, depth)

    def angle(self, depth):
        kind = self.random.randrange(5 if depth > 0 else 1)
        if kind == 0:
            return self.random.choice(ANGLES)
        if kind == 1:
            return f"{self.random.choice(['2', '3', '-2'])}*{self.random.choice(ANGLES)}"
        if kind == 2:
            return f"({self.angle(depth - 1)}) {self.random.choice('+-')} {self.constant(0)[0]}"
        if kind == 3:
            return f"-({self.angle(depth - 1)})*2"
        return f"({self.angle(depth - 1)}) {self.random.choice('+-')} ({self.angle(depth - 1)})"

    def polynomial(self, depth):
        kind = self.random.randrange(7 if depth > 0 else 2)
        if kind == 0:
            return self.random.choice(COORDINATES), 1.0
        if kind == 1:
            return f"{self.random.choice(['sin', 'cos'])}( {self.angle(2)} )", 1.0
        if kind == 2:
            (text, size), power = self.polynomial(depth - 1), self.random.choice([0, 1, 2, 3])
            return f"({text})**{power}", max(1.0, size) ** power
        if kind == 3:
            (top, size), name = self.polynomial(depth - 1), self.random.choice(list(PARAMETERS))
            return f"({top})/(1 + {name})", size
        if kind == 4:
            (text, size), (by, other) = self.polynomial(depth - 1), self.constant(2)
            return f"({by})*({text})", size * other
        return self.both(self.polynomial, depth)

    def both(self, part, depth):
        (a, size), (b, other) = part(depth - 1), part(depth - 1)
        operation = self.random.choice(["+", "-", "*", " + ", " - ", " * "])
        sign = self.random.choice(["", "", "-", "- -"])
        if operation.strip() == "*":
            return f"{sign}({a}){operation}({b})", size * other
        return f"{sign}({a}){operation}({b})", size + other


def test_ten_thousand_formulas_have_sympys_values():
    symbols = {name: sympy.Symbol(name) for name in ANGLES + COORDINATES + list(PARAMETERS)}
    at = dict(zip(ANGLES + COORDINATES, POINT), **PARAMETERS)
    draw = Draw(2026)
    worst = 0.0
    for k in range(10000):
        text, size = draw.polynomial(1 + k % 5)
        model = eq.Model.parse(
            json.dumps({"angles": ANGLES, "coordinates": COORDINATES, "parameters": PARAMETERS, "potential": text})
        )
        expression = sympy.sympify(text.replace("^", "**"), locals=symbols)
        exact = sympy.lambdify(list(symbols.values()), expression, "mpmath")(*(at[name] for name in symbols))
        found = model.potential(POINT)
        assert math.isfinite(found), text
        # angles of up to 100 radians, and numbers of decimal digits that doubles round
        error = abs(found - float(exact)) / max(1.0, size)
        worst = max(worst, error)
        assert error < 1e-12, (text, found, exact)
    assert worst < 1e-12
