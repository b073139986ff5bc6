"""Branches of a problem of one's own, residual(q, p) = 0: followed by arc length through folds, with what happens on
the way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, List, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import InvalidArgument, continue_branch
from .tables import Printed, number

Reals = NDArray[np.float64]


@dataclass(repr=False, eq=False)
class CriticalPoint(Printed):
    """Where the Jacobian is singular on a branch."""

    kind: str  #: fold, pitchfork, transcritical, isola centre, hilltop, cusp or multiple
    p: float
    q: Reals
    null_vector: Reals  #: its largest entry 1
    residual: float  #: the largest |entry|
    curvature: float  #: of folds and pitchforks p = p_c + curvature x^2 / 2 along the null vector
    step: int  #: between the points number step and step + 1 of the branch
    tangents: List[Tuple[Reals, float]]  #: (dq, dp) of the branches through the point, up to their lengths

    def _line(self) -> str:
        return f"{self.kind} at p={number(self.p, 10)}"


@dataclass(repr=False, eq=False)
class Branch(Printed):
    """The points of a branch, in the order in which they were reached, and its critical points."""

    q: Reals  #: (points, unknowns)
    p: Reals  #: (points,)
    negative: Optional[NDArray[np.int64]]  #: negative eigenvalues of the Jacobian; None where it is not symmetric
    determinant_sign: NDArray[np.int64]  #: of the Jacobian
    residual: Reals  #: the largest |entry|
    arc_length: Reals  #: from the start
    events: List[CriticalPoint]
    unexplained: List[Tuple[int, str]]  #: steps with changes of sign that the events do not account for, and why
    end: str  #: window (p left its range), steps, closed, or stopped (the smallest step did not converge)

    @property
    def stable(self) -> Optional[NDArray[np.bool_]]:
        """Of each point, whether no eigenvalue is negative; None where the Jacobian is not symmetric."""
        return None if self.negative is None else self.negative == 0

    def __len__(self) -> int:
        return len(self.p)

    def _line(self) -> str:
        return f"{len(self)} points and {len(self.events)} critical points, end: {self.end}"

    def _columns(self) -> List[str]:
        return ["kind", "p", "residual"]

    def _rows(self) -> List[List[str]]:
        return [[e.kind, number(e.p, 12), f"{e.residual:.1e}"] for e in self.events]


def follow(
    residual: Callable[[Reals, float], ArrayLike],
    jacobian: Callable[[Reals, float], Any],
    q0: ArrayLike,
    p0: float,
    low: float,
    high: float,
    parameter_derivative: Optional[Callable[[Reals, float], ArrayLike]] = None,
    symmetric: bool = True,
    direction: int = 1,
    most_steps: int = 1000,
    first_step: float = 0.05,
    largest_step: float = 0.2,
    parameter_weight: float = 0.0,
) -> Branch:
    """The branch of residual(q, p) = 0 from the solution near q0 at p0 on, towards larger p (direction 1) or smaller p
    (-1), through folds, until p leaves low .. high: the last point is on that border.

    residual(q, p): an array (n,). jacobian(q, p): its derivatives by q, (n, n), a numpy array or a matrix of
    scipy.sparse, always the same of the two. parameter_derivative(q, p): an array (n,); None: central differences.
    symmetric: whether the Jacobian is, as where the residual is the gradient of an energy; then negative eigenvalues
    are counted. Steps are lengths: of q, in its own units, together with parameter_weight times p. parameter_weight:
    lengths per unit of p; 0: chosen from the start and the window.

    Raises InvalidArgument for options out of range, and for derivatives that differ from differences of the residual
    at the start. What the functions raise passes through, KeyboardInterrupt as well.
    """
    q = np.atleast_1d(np.asarray(q0, dtype=float))
    if q.ndim != 1 or not np.isfinite(q).all():
        raise InvalidArgument(f"q0 = {q0!r}: must be a vector of finite numbers")
    if not low <= p0 <= high:
        raise InvalidArgument(f"p0 = {p0!r}: must be from low = {low!r} to high = {high!r}")
    first = jacobian(q, float(p0))
    sparse = hasattr(first, "tocsc")
    if sparse:

        def given(at: Reals, p: float) -> Any:
            return jacobian(at, p).tocsc()

    else:

        def given(at: Reals, p: float) -> Any:
            return np.atleast_2d(np.asarray(jacobian(at, p), dtype=float))

    def vector(function: Callable[[Reals, float], ArrayLike]) -> Callable[[Reals, float], Reals]:
        return lambda at, p: np.atleast_1d(np.asarray(function(at, p), dtype=np.float64))

    found = continue_branch(
        vector(residual),
        given,
        None if parameter_derivative is None else vector(parameter_derivative),
        q,
        float(p0),
        float(low),
        float(high),
        direction,
        bool(symmetric),
        sparse,
        most_steps,
        float(first_step),
        float(largest_step),
        float(parameter_weight),
    )
    found["events"] = [CriticalPoint(**event) for event in found["events"]]
    if not symmetric:
        found["negative"] = None
    return Branch(**found)
