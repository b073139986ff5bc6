"""The functions that formulas are made of. They take expressions of a model, and numbers as well."""

from __future__ import annotations

import math
from typing import TypeVar

from ._core import Expression

T = TypeVar("T", Expression, float)

pi = math.pi


def sin(x: T) -> T:
    """The sine of an angle (radians), or of an expression of parameters."""
    if isinstance(x, Expression):
        return x.sin()
    return math.sin(x)


def cos(x: T) -> T:
    """The cosine of an angle (radians), or of an expression of parameters."""
    if isinstance(x, Expression):
        return x.cos()
    return math.cos(x)


def tan(x: T) -> T:
    """The tangent of an expression of parameters."""
    if isinstance(x, Expression):
        return x.tan()
    return math.tan(x)


def sqrt(x: T) -> T:
    """The square root of an expression of parameters."""
    if isinstance(x, Expression):
        return x.sqrt()
    return math.sqrt(x)


def exp(x: T) -> T:
    """The exponential function of an expression of parameters."""
    if isinstance(x, Expression):
        return x.exp()
    return math.exp(x)


def log(x: T) -> T:
    """The natural logarithm of an expression of parameters."""
    if isinstance(x, Expression):
        return x.log()
    return math.log(x)
