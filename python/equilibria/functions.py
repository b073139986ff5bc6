"""The functions that formulas are made of. They take expressions of a model, and numbers as well."""

from __future__ import annotations

import math
from typing import Union, overload

from ._core import Expression

pi = math.pi


def _of(name: str, doc: str):
    of_number = getattr(math, name)

    @overload
    def function(x: Expression) -> Expression: ...
    @overload
    def function(x: float) -> float: ...
    def function(x: Union[Expression, float]) -> Union[Expression, float]:
        return getattr(x, name)() if isinstance(x, Expression) else of_number(x)

    function.__name__ = function.__qualname__ = name
    function.__doc__ = doc
    return function


sin = _of("sin", "The sine of an angle (radians), or of an expression of parameters.")
cos = _of("cos", "The cosine of an angle (radians), or of an expression of parameters.")
tan = _of("tan", "The tangent of an expression of parameters.")
sqrt = _of("sqrt", "The square root of an expression of parameters.")
exp = _of("exp", "The exponential function of an expression of parameters.")
log = _of("log", "The natural logarithm of an expression of parameters.")
