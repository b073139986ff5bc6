"""Formulas of sympy's expressions: their tree, walked once."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Mapping

from ._core import Expression, FormulaBuilder, InvalidArgument


def converted(expression: Any, names: Mapping[Any, Expression], builder: FormulaBuilder) -> Expression:
    """The formula of a sympy expression whose symbols (or applied functions) are the keys of `names`.

    Raises InvalidArgument for a symbol or a function that a model cannot have.
    """
    import sympy

    known: Dict[Any, Expression] = dict(names)
    functions = {
        sympy.sin: Expression.sin,
        sympy.cos: Expression.cos,
        sympy.tan: Expression.tan,
        sympy.exp: Expression.exp,
        sympy.log: Expression.log,
    }

    def number(value: float) -> Expression:
        return builder.number(value)

    def power(base: Any, exponent: Any) -> Expression:
        if base == sympy.E:
            return of(exponent).exp()
        if exponent == sympy.Rational(1, 2):
            return of(base).sqrt()
        if exponent.is_Integer and int(exponent) < 0:
            return 1.0 / of(base) ** int(-exponent)
        if exponent == sympy.Rational(-1, 2):
            return 1.0 / of(base).sqrt()
        return of(base) ** of(exponent)

    def product(factors: Any) -> Expression:
        # quotients as such: a / b is one operation, a * (1 / b) are two and another rounding
        above: List[Any] = []
        below: List[Any] = []
        for factor in factors:
            negative = factor.is_Pow and factor.exp.is_Rational and factor.exp.is_negative
            (below if negative else above).append(1 / factor if negative else factor)
        y = of(above[0]) if above else number(1.0)
        for factor in above[1:]:
            y = y * of(factor)
        for factor in below:
            y = y / of(factor)
        return y

    def made(e: Any) -> Expression:
        if e.is_Integer:
            return number(float(e))
        if e.is_Rational:
            return number(float(e.p)) / number(float(e.q))
        if e.is_Float:
            return number(float(e))
        if e is sympy.pi:
            return number(math.pi)
        if e.is_NumberSymbol:
            return number(float(e))
        if e.is_Add:
            y = of(e.args[0])
            for term in e.args[1:]:
                sign, positive = (-1, -term) if term.could_extract_minus_sign() else (1, term)
                y = y - of(positive) if sign < 0 else y + of(positive)
            return y
        if e.is_Mul:
            if e.args[0] == -1:
                return -product(e.args[1:])
            return product(e.args)
        if e.is_Pow:
            return power(e.base, e.exp)
        if e.func in functions and len(e.args) == 1:
            return functions[e.func](of(e.args[0]))
        allowed = ", ".join(str(name) for name in names) or "none"
        if e.is_Symbol:
            raise InvalidArgument(f"symbol = {e}: must be an angle, a coordinate or a parameter, which are: {allowed}")
        raise InvalidArgument(
            f"expression = {e}: must be made of the symbols {allowed}, of real numbers, and of sums, products, powers, "
            "sin, cos, tan, sqrt, exp and log"
        )

    def of(e: Any) -> Expression:
        if e not in known:
            known[e] = made(e)
        return known[e]

    sympify: Any = sympy.sympify
    return of(sympify(expression))
