"""Branches of a problem of one's own, residual(q, p) = 0: followed by arc length through folds, with what happens on
the way."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import InvalidArgument, bifurcation_diagram, continue_branch
from ._core import critical_curve as trace_critical_curve
from .tables import Printed, number

Reals = NDArray[np.float64]


@dataclass(repr=False, eq=False)
class CriticalPoint(Printed):
    """Where the Jacobian is singular on a branch."""

    kind: str  #: fold, pitchfork, transcritical, isola centre, hilltop, cusp or multiple
    p: float
    q: Reals
    null_vector: Reals  #: its largest entry 1
    left_null_vector: Reals  #: of the transposed Jacobian, its largest entry 1
    residual: float  #: the largest |entry|
    curvature: float  #: of folds and pitchforks p = p_c + curvature x^2 / 2 along the null vector
    curvature_error: float  #: how far apart two orders of differences have a pitchfork's
    nullity: int  #: how many null vectors there are
    negative_before: Optional[int]  #: negative eigenvalues before it on its branch; None where they are not known
    negative_after: Optional[int]  #: and behind it
    tangents: List[Tuple[Reals, float]]  #: (dq, dp) of the branches through the point, up to their lengths
    step: Optional[int] = None  #: of the branch that met it: between its points number step and step + 1
    branches: Optional[List[int]] = None  #: of a diagram: the numbers of those that meet here

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
    parent: Optional[int] = None  #: of a diagram: the critical point that it leaves
    deflated: bool = False  #: of a diagram: found by deflation, joined to no bifurcation that was met
    nodes: Optional[List[int]] = None  #: of a diagram: the numbers of its critical points

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


@dataclass(repr=False, eq=False)
class BranchDiagram(Printed):
    """Branches that bifurcations join, and those that deflation found beside them."""

    branches: List[Branch]  #: two of them, one each way, make a curve
    nodes: List[CriticalPoint]  #: critical points, each once
    seen: int  #: starts that lay on a branch which was followed before
    images: int  #: starts whose mirror image did
    not_followed: int  #: starts beyond most_branches
    not_switched: int  #: bifurcations from which no other branch was found
    circles: List[int]  #: nodes from which branches leave in every direction, turns of one: none is followed
    complete: bool  #: every branch was followed to its end, and every change of sign is explained
    verification: Dict[str, Any]  #: what slices and checks found: points, slices, deflated, mismatches, verified, summary

    def _line(self) -> str:
        doubts = "complete" if self.complete else "NOT COMPLETE"
        return f"{len(self.branches)} branches and {len(self.nodes)} critical points, {doubts}"

    def _columns(self) -> List[str]:
        return ["kind", "p", "nullity", "branches"]

    def _rows(self) -> List[List[str]]:
        return [[n.kind, number(n.p, 12), str(n.nullity), str(n.branches)] for n in self.nodes]


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
    functions, q, sparse = _problem(residual, jacobian, parameter_derivative, q0, p0, low, high)
    found = continue_branch(
        *functions,
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
    return _branch(found, symmetric)


def diagram(
    residual: Callable[[Reals, float], ArrayLike],
    jacobian: Callable[[Reals, float], Any],
    q0: ArrayLike,
    p0: float,
    low: float,
    high: float,
    parameter_derivative: Optional[Callable[[Reals, float], ArrayLike]] = None,
    symmetric: bool = True,
    most_steps: int = 1000,
    first_step: float = 0.05,
    largest_step: float = 0.2,
    parameter_weight: float = 0.0,
    most_branches: int = 200,
    slices: int = 0,
    checks: int = 0,
    amplitude: float = 0.0,
) -> BranchDiagram:
    """All branches of residual(q, p) = 0 that bifurcations join to the solution near q0 at p0, both ways, within low ..
    high, and those that leave these.

    slices: at so many values of p deflation looks for branches that are not joined. checks: at so many random points
    of each branch the eigenvalues are counted one by one; `verification` has what both found. amplitude: of the first point on a
    new branch, a length; 0: the first step's. All else is as for `follow`.
    """
    functions, q, sparse = _problem(residual, jacobian, parameter_derivative, q0, p0, low, high)
    found = bifurcation_diagram(
        *functions,
        q,
        float(p0),
        float(low),
        float(high),
        bool(symmetric),
        sparse,
        most_steps,
        float(first_step),
        float(largest_step),
        float(parameter_weight),
        most_branches,
        slices,
        checks,
        float(amplitude),
    )
    found["branches"] = [_branch(branch, symmetric) for branch in found["branches"]]
    found["nodes"] = [CriticalPoint(**node) for node in found["nodes"]]
    return BranchDiagram(**found)


@dataclass(repr=False, eq=False)
class CurvePoint(Printed):
    """A special point of a curve of critical points."""

    kind: str  #: of folds: cusp, hilltop, or the bifurcation in which r turns back; of bifurcations: hilltop, or theirs
    r: float
    p: float
    gamma: float  #: 0 on curves of folds
    q: Reals
    residual: float  #: of the curve's equations, the largest |entry|
    step: int  #: between the curve's points number step and step + 1

    def _line(self) -> str:
        return f"{self.kind} at r={number(self.r, 10)}, p={number(self.p, 10)}"


@dataclass(repr=False, eq=False)
class CriticalCurve(Printed):
    """Folds, or bifurcations, in the plane of two parameters r and p."""

    r: Reals  #: (points,)
    p: Reals  #: (points,)
    gamma: Reals  #: (points,) 0 where the problem bifurcates: what is added to one equation so that a bifurcation stays
    q: Reals  #: (points, unknowns)
    residual: Reals  #: of the curve's equations, the largest |entry|
    special: List[CurvePoint]
    unexplained: List[Tuple[int, str]]  #: steps with changes of sign that special points do not account for, and why
    end: str  #: window (r or p left its range: the last point is on its border), steps, closed, or stopped (no step converged)

    def __len__(self) -> int:
        return len(self.r)

    def _line(self) -> str:
        return f"{len(self)} points and {len(self.special)} special points, end: {self.end}"

    def _columns(self) -> List[str]:
        return ["kind", "r", "p", "residual"]

    def _rows(self) -> List[List[str]]:
        return [[s.kind, number(s.r, 12), number(s.p, 12), f"{s.residual:.1e}"] for s in self.special]


def critical_curve(
    residual: Callable[[Reals, float, float], ArrayLike],
    jacobian: Callable[[Reals, float, float], Any],
    point: CriticalPoint,
    r0: float,
    low: float,
    high: float,
    p_low: float = -math.inf,
    p_high: float = math.inf,
    parameter_derivative: Optional[Callable[[Reals, float, float], ArrayLike]] = None,
    symmetric: bool = True,
    direction: int = 1,
    most_steps: int = 1000,
    first_step: float = 0.05,
    largest_step: float = 0.2,
    parameter_weight: float = 0.0,
) -> CriticalCurve:
    """The critical points of residual(q, p, r) = 0 in two parameters, from one of them on: `point`, which `follow` or
    `diagram` found for r = r0. Towards larger r (direction 1) or smaller r (-1), through cusps, until r leaves low ..
    high, or p leaves p_low .. p_high.

    point: of kind fold, pitchfork, transcritical or isola centre. A curve of folds has cusps, points where r turns back
    in a bifurcation, and points with a second null vector as special points. A curve of bifurcations goes through the
    problems residual + gamma e_j: gamma stays 0 where a symmetry keeps the bifurcation; elsewhere the problem itself
    bifurcates where gamma passes 0, a special point. All else is as for `follow`, r in the place of p in
    parameter_weight.

    Raises InvalidArgument for another kind of point, and as `follow` does.
    """
    if point.kind not in ("fold", "pitchfork", "transcritical", "isola centre"):
        raise InvalidArgument(
            f"point.kind = {point.kind!r}: must be fold, pitchfork, transcritical or isola centre; for a hilltop or a "
            "multiple point begin at a simple one at another r0"
        )
    if not low <= r0 <= high:
        raise InvalidArgument(f"r0 = {r0!r}: must be from low = {low!r} to high = {high!r}")
    if not p_low <= point.p <= p_high:
        raise InvalidArgument(f"point.p = {point.p!r}: must be from p_low = {p_low!r} to p_high = {p_high!r}")
    r0 = float(r0)
    q = np.asarray(point.q, dtype=float)
    functions, sparse = _functions(residual, jacobian, parameter_derivative, (q, point.p, r0))
    found = trace_critical_curve(
        *functions,
        point.kind == "fold",
        q,
        point.p,
        point.null_vector,
        point.left_null_vector,
        r0,
        float(low),
        float(high),
        float(p_low),
        float(p_high),
        direction,
        bool(symmetric),
        sparse,
        most_steps,
        float(first_step),
        float(largest_step),
        float(parameter_weight),
    )
    found["special"] = [CurvePoint(**special) for special in found["special"]]
    return CriticalCurve(**found)


def _branch(found: Any, symmetric: bool) -> Branch:
    found["events"] = [CriticalPoint(**event) for event in found["events"]]
    if not symmetric:
        found["negative"] = None
    return Branch(**found)


def _problem(
    residual: Callable[[Reals, float], ArrayLike],
    jacobian: Callable[[Reals, float], Any],
    parameter_derivative: Optional[Callable[[Reals, float], ArrayLike]],
    q0: ArrayLike,
    p0: float,
    low: float,
    high: float,
) -> Tuple[Tuple[Any, Any, Any], Reals, bool]:
    """The functions as the compiled part takes them, the start, and whether the Jacobian is sparse."""
    q = np.atleast_1d(np.asarray(q0, dtype=float))
    if q.ndim != 1 or not np.isfinite(q).all():
        raise InvalidArgument(f"q0 = {q0!r}: must be a vector of finite numbers")
    if not low <= p0 <= high:
        raise InvalidArgument(f"p0 = {p0!r}: must be from low = {low!r} to high = {high!r}")
    functions, sparse = _functions(residual, jacobian, parameter_derivative, (q, float(p0)))
    return functions, q, sparse


def _functions(
    residual: Callable[..., ArrayLike],
    jacobian: Callable[..., Any],
    parameter_derivative: Optional[Callable[..., ArrayLike]],
    start: Tuple[Any, ...],
) -> Tuple[Tuple[Any, Any, Any], bool]:
    """The functions as the compiled part takes them, and whether the Jacobian is sparse: as at the start."""
    sparse = hasattr(jacobian(*start), "tocsc")
    if sparse:

        def given(*at: Any) -> Any:
            return jacobian(*at).tocsc()

    else:

        def given(*at: Any) -> Any:
            return np.atleast_2d(np.asarray(jacobian(*at), dtype=float))

    def vector(function: Callable[..., ArrayLike]) -> Callable[..., Reals]:
        return lambda *at: np.atleast_1d(np.asarray(function(*at), dtype=np.float64))

    by_parameter = None if parameter_derivative is None else vector(parameter_derivative)
    return (vector(residual), given, by_parameter), sparse
