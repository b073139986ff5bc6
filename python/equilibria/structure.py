"""Structures with large rotations: read from JSON or built by code, followed through their critical points, and read off
as arrays and tables."""

from __future__ import annotations

import json
from dataclasses import dataclass
from os import PathLike
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import BoundStructure, InvalidArgument
from .tables import Printed, number

Reals = NDArray[np.float64]


@dataclass(repr=False, eq=False)
class StructurePoint(Printed):
    """A critical point of a structure: where its tangent stiffness is singular."""

    structure: Structure
    kind: str  #: fold, pitchfork, transcritical, isola centre, hilltop, cusp or multiple
    p: float  #: the load parameter
    nullity: int  #: how many modes there are
    residual: float  #: the largest |force| left
    curvature: float  #: p = p_c + curvature x^2 / 2 along the mode, at folds and pitchforks
    curvature_error: float  #: how far apart two orders of differences have a pitchfork's
    negative_before: Optional[int]  #: negative eigenvalues before it on its branch; None where they are not known
    negative_after: Optional[int]  #: likewise behind it
    position: Reals  #: (nodes, 3), of each node, in the structure's length
    rotation: Reals  #: (nodes, 3), the shortest rotation vectors, radians
    multipliers: Reals  #: what joints, prescribed motions and mixed elements have for unknowns
    mode: Reals  #: (nodes, 6): ux, uy, uz, and rotations about the node's axes, radians; the largest entry 1
    modes: List[Reals]  #: a basis of them, at multiple points
    step: Optional[int] = None  #: the branch that met it has it between its points number step and step + 1
    branches: Optional[List[int]] = None  #: numbers of those that meet here, in a diagram

    def results(self) -> Dict[str, Any]:
        """Displacements, reactions and section forces, as of `Structure.results`."""
        return self.structure.results(self.position, self.rotation, self.multipliers, self.p)

    def _line(self) -> str:
        return f"{self.kind} at {self.structure.parameter} = {number(self.p, 12)}"


@dataclass(repr=False, eq=False)
class StructureBranch(Printed):
    """States of a structure in the order in which they were reached, and its critical points."""

    structure: Structure
    p: Reals  #: (points,), the load parameter
    position: Reals  #: (points, nodes, 3)
    rotation: Reals  #: (points, nodes, 3), the shortest rotation vectors, radians
    multipliers: Reals  #: (points, multipliers)
    negative: NDArray[np.int64]  #: negative eigenvalues of the stiffness; -1 where they are not known
    determinant_sign: NDArray[np.int64]  #: the sign of the stiffness's determinant
    residual: Reals  #: the largest |force| left
    arc_length: Reals  #: from the start
    events: List[StructurePoint]
    unexplained: List[Tuple[int, str]]  #: steps with changes of sign that the events do not account for, and why
    end: str  #: window (p left its range), steps, closed, or stopped (the smallest step did not converge)
    parent: Optional[int] = None  #: the critical point that it leaves, in a diagram
    deflated: bool = False  #: found by deflation, in a diagram, joined to no bifurcation that was met
    nodes: Optional[List[int]] = None  #: numbers of its critical points, in a diagram

    @property
    def stable(self) -> Optional[NDArray[np.bool_]]:
        """Whether no eigenvalue is negative, at each point; None where they are not known, as under follower loads."""
        return None if (self.negative < 0).any() else self.negative == 0

    def displacement(self, node: Union[str, int]) -> Reals:
        """The displacement of a node, by its name or number: (points, 3)."""
        k = self.structure.node(node)
        return self.position[:, k] - self.structure.drawn[k]

    def results(self, point: int = -1) -> Dict[str, Any]:
        """Displacements, reactions and section forces of a point of it, as of `Structure.results`."""
        return self.structure.results(
            self.position[point], self.rotation[point], self.multipliers[point], float(self.p[point])
        )

    def __len__(self) -> int:
        return len(self.p)

    def _line(self) -> str:
        left = f", {len(self.unexplained)} unexplained steps" if self.unexplained else ""
        return f"{len(self)} points and {len(self.events)} critical points{left}, end: {self.end}"

    def _columns(self) -> List[str]:
        return ["kind", self.structure.parameter, "nullity", "residual"]

    def _rows(self) -> List[List[str]]:
        return [[e.kind, number(e.p, 12), str(e.nullity), f"{e.residual:.1e}"] for e in self.events]


@dataclass(repr=False, eq=False)
class StructureDiagram(Printed):
    """All branches that bifurcations join to a structure's first state, and those that deflation found beside them."""

    structure: Structure
    branches: List[StructureBranch]  #: two of them, one each way, make a curve
    nodes: List[StructurePoint]  #: critical points, each once
    seen: int  #: starts that lay on a branch which was followed before
    images: int  #: starts whose mirror image did
    not_followed: int  #: starts beyond most_branches
    not_switched: int  #: bifurcations from which no other branch was found
    circles: List[int]  #: nodes from which branches leave in every direction, turns of one: none is followed
    complete: bool  #: every branch was followed to its end, and every change of sign is explained
    verification: Dict[str, Any]  #: what slices and checks found: points, slices, deflated, mismatches, verified, summary

    def plot(self, ax: Any = None, node: Union[None, str, int] = None, component: int = -1) -> Any:
        """The load parameter over a displacement of a node (default: the structure's measured one); see
        `StructureBranch.displacement`. component: 0, 1, 2, or -1 for the one that moves most. Needs matplotlib."""
        from .plots import plot_structure

        return plot_structure(self, ax, node, component)

    def _line(self) -> str:
        doubts = "complete" if self.complete else "NOT COMPLETE"
        left = [
            f"{count} {words}"
            for count, words in (
                (sum(len(b.unexplained) for b in self.branches), "unexplained steps"),
                (self.not_switched, "bifurcations not left"),
                (len(self.circles), "circles of branches not followed"),
                (self.not_followed, "branches not followed"),
                (sum(b.end not in ("window", "closed") for b in self.branches), "branches without an end"),
            )
            if count
        ]
        return f"{len(self.branches)} branches and {len(self.nodes)} critical points, " + ", ".join([doubts] + left)

    def _columns(self) -> List[str]:
        return ["kind", self.structure.parameter, "nullity", "branches"]

    def _rows(self) -> List[List[str]]:
        return [[n.kind, number(n.p, 12), str(n.nullity), str(n.branches)] for n in self.nodes]


class Structure(Printed):
    """A structure of beams, bars, springs, rigid bodies and joints, under loads that a parameter multiplies.

        frame = Structure("frame.json")
        frame = Structure(nodes={"A": [0, 0, 0], "B": [0, 1, 0]}, elements=[..], parameter={"low": 0, "high": 9}, ..)

    What it is given as: a file in JSON, or the keys of such a file as keyword arguments (docs/structures.md). What is
    constant is brought on at once, `loaded` says how. Raises InvalidArgument for what the format refuses, with its
    place.
    """

    def __init__(
        self, file: Union[None, str, PathLike[str]] = None, *, symmetric_images: bool = False, **keys: Any
    ) -> None:
        """symmetric_images: of branches that are images of each other by the structure's symmetry one is followed."""
        if (file is None) == (not keys):
            raise InvalidArgument(f"file = {file!r}: must be given, or keys of the format, and not both")
        if file is not None:
            with open(file, encoding="utf-8") as opened:
                text = opened.read()
        else:
            text = json.dumps(keys, default=_plain)
        self._core = BoundStructure(text, symmetric_images)
        self.name: str = self._core.name
        #: names and numbers of the nodes; further ones are within beams
        self.nodes: Dict[str, int] = self._core.nodes
        self.notes: List[str] = self._core.notes  #: defaults that are to be known
        self.parameter: str = self._core.parameter  #: its name
        self.window: Tuple[float, float] = self._core.window  #: the parameter's
        self.conservative: bool = self._core.conservative  #: all loads have an energy
        self.loaded: Dict[str, Any] = self._core.loaded  #: share, passed, unexplained, summary of the first stage
        self.drawn: Reals = self._core.drawn  #: (nodes, 3), where the nodes are without load
        self.lines: List[List[int]] = self._core.lines  #: the nodes of each element

    def node(self, node: Union[str, int]) -> int:
        """The number of a node, by its name or number."""
        if isinstance(node, str):
            if node not in self.nodes:
                raise InvalidArgument(f"node = {node!r}: must be one of {', '.join(self.nodes)}")
            return self.nodes[node]
        if not 0 <= node < len(self.drawn):
            raise InvalidArgument(f"node = {node!r}: must be from 0 to {len(self.drawn) - 1}")
        return int(node)

    def follow(
        self,
        direction: Optional[int] = None,
        low: Optional[float] = None,
        high: Optional[float] = None,
        most_steps: int = 1000,
        first_step: Optional[float] = None,
        largest_step: Optional[float] = None,
        parameter_weight: Optional[float] = None,
    ) -> StructureBranch:
        """The branch from p = 0 on, towards larger p (direction 1) or smaller p (-1), through folds, until p leaves
        its window. What is None is as the file says, or chosen."""
        up, _ = self._core.directions
        if direction is None:
            direction = 1 if up else -1
        steps = self._steps(first_step, largest_step, parameter_weight)
        found = self._core.follow(direction, *self._window(low, high), most_steps, *steps)
        return self._branch(found)

    def critical_points(self, **options: Any) -> List[StructurePoint]:
        """The critical points of the first branch, each way that the file goes; options: as of `follow`."""
        up, down = self._core.directions
        ways = [1] * up + [-1] * down if "direction" not in options else [options.pop("direction")]
        return [event for way in ways for event in self.follow(way, **options).events]

    def diagram(
        self,
        low: Optional[float] = None,
        high: Optional[float] = None,
        most_steps: int = 1000,
        first_step: Optional[float] = None,
        largest_step: Optional[float] = None,
        parameter_weight: Optional[float] = None,
        most_branches: int = 200,
        slices: int = 0,
        checks: int = 0,
        amplitude: float = 0.0,
    ) -> StructureDiagram:
        """Every branch that bifurcations join to the state at p = 0, both ways, and those that leave these.

        slices: at so many values of p deflation looks for branches that are not joined. checks: at so many random points
        of each branch the eigenvalues are counted one by one; `verification` has what both found. amplitude: of the first point
        on a new branch; 0: chosen. What is None is as the file says, or chosen."""
        found = self._core.diagram(
            *self._window(low, high),
            most_steps,
            *self._steps(first_step, largest_step, parameter_weight),
            most_branches,
            slices,
            checks,
            float(amplitude),
        )
        found["branches"] = [self._branch(branch) for branch in found["branches"]]
        found["nodes"] = [StructurePoint(self, **node) for node in found["nodes"]]
        return StructureDiagram(self, **found)

    def results(self, position: ArrayLike, rotation: ArrayLike, multipliers: ArrayLike, p: float) -> Dict[str, Any]:
        """What is read off a state: "nodes" with their "displacement" and "rotation", "reactions" with "force" and
        "moment" by the supports on the structure, in fixed axes, both by the nodes' names; "elements", a list with
        the "element", the "place" and the forces there by their names (docs/structures.md)."""
        text = self._core.results(np.asarray(position), np.asarray(rotation), np.asarray(multipliers), float(p))
        return dict(json.loads(text))

    def plot(self, position: Optional[ArrayLike] = None, ax: Any = None, **style: Any) -> Any:
        """The structure as lines, as drawn or where its nodes are given; in space if it is none of the x-y plane.
        style: as of matplotlib's plot."""
        from .plots import plot_shape

        return plot_shape(self, self.drawn if position is None else np.asarray(position), ax, style)

    def _window(self, low: Optional[float], high: Optional[float]) -> Tuple[float, float]:
        own_low, own_high = self.window
        return (own_low if low is None else float(low), own_high if high is None else float(high))

    def _steps(self, *given: Optional[float]) -> List[float]:
        return [float(own if one is None else one) for own, one in zip(self._core.steps, given)]

    def _branch(self, found: Dict[str, Any]) -> StructureBranch:
        found["events"] = [StructurePoint(self, **event) for event in found["events"]]
        return StructureBranch(self, **found)

    def _line(self) -> str:
        name = f"{self.name}, " if self.name else ""
        return f"{name}{len(self.drawn)} nodes, {self._core.size} unknowns, {self.parameter} in {list(self.window)}"


def _plain(value: Any) -> Any:
    """Numpy's arrays and numbers as JSON."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(f"{value!r}: must be what JSON can say")
