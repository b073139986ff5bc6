"""What searches return. Arrays are numpy's; angles are radians, in (-pi, pi] for equilibria; unknowns are in the order
of Model.unknowns, angles first. Each prints as a line (repr), a table (str), and as HTML in a notebook."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._core import RootSetData
from .tables import Printed, by_index, fixed, number

if TYPE_CHECKING:
    from .model import Model

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]


@dataclass(repr=False, eq=False)
class Equilibrium(Printed):
    """A real root, classified."""

    unknowns: List[str]
    q: Reals  #: angles, then coordinates
    energy: float  #: the potential there; NaN of a model without one
    index: int  #: negative eigenvalues of the Hessian; without a potential those with which dq/dt = -F(q) departs
    nullity: int  #: eigenvalues that count as zero
    margin: float  #: the smallest |eigenvalue| over the largest
    residual: float  #: max |F_i| over F_i's largest coefficient
    condition: float  #: of the Jacobian
    multiplicity: int

    @property
    def degenerate(self) -> bool:
        """Whether the Jacobian is singular there."""
        return self.nullity > 0

    @property
    def stable(self) -> bool:
        """A strict minimum of the potential; without one, a point that dq/dt = -F(q) comes back to."""
        return self.index == 0 and self.nullity == 0

    def _line(self) -> str:
        at = ", ".join(f"{name}={number(value, 6)}" for name, value in zip(self.unknowns, self.q))
        kind = "degenerate" if self.degenerate else "stable" if self.stable else f"index {self.index}"
        return f"{at}, {kind}"


@dataclass(repr=False, eq=False)
class RootSet(Printed):
    """All roots of a model at given parameters, and the real ones, the equilibria, by index, then nullity."""

    model: "Model" = field(repr=False)
    parameters: Dict[str, float]
    roots: NDArray[np.complex128]  #: (roots, unknowns); real parts of angles in (-pi, pi]
    root_residual: Reals
    root_condition: Reals
    root_paths: Integers  #: how many paths ended at each: its multiplicity
    singular_root: Flags
    angles: Reals  #: (equilibria, unknowns): the real roots, angles first, then coordinates
    energy: Reals
    index: Integers
    nullity: Integers
    margin: Reals
    residual: Reals
    condition: Reals
    multiplicity: Integers
    path: Integers
    families: List[Dict[str, Any]]  #: curves and surfaces of solutions, of which no root is one
    failures: List[Dict[str, Any]]  #: paths that failed, and why
    alarms: str  #: what betrays lost or doubled roots; empty: nothing
    paths: Dict[str, int]  #: finite + at_infinity + singular + failed + cancelled == total
    by_index: Integers  #: nondegenerate equilibria of index 0 .. n
    clean: bool  #: nothing speaks against the count of equilibria
    morse_applies: bool  #: whether the Morse relations of the torus must hold
    morse: bool  #: whether they do
    seed: int
    seconds: float
    start: str  #: the start system
    why_start: str
    summary: str  #: in words
    #: what is known of other roots: "complete", a theorem; "explained", each path is accounted for; "open"
    completeness: str
    missing_at_most: Optional[int]  #: isolated roots, each counted with its multiplicity; None: not known
    verdict: str  #: completeness and its evidence, in words
    confirmed: Flags  #: of each singular root, whether its multiplicity was confirmed
    directions_at_infinity: List[Dict[str, Any]]  #: explained paths, by their direction
    _data: RootSetData = field(repr=False)
    proof: Optional["Proof"] = field(repr=False, default=None)  #: of the roots; None where none was asked for

    @staticmethod
    def _of(
        model: "Model", p: Reals, data: RootSetData, found: Mapping[str, Any], proof: Optional[Mapping[str, Any]]
    ) -> "RootSet":
        y = RootSet(model=model, parameters=dict(zip(model.parameters, p.tolist())), _data=data, **found)
        if proof is not None:
            y.proof = Proof._of(y, proof)
        return y

    @property
    def complete(self) -> bool:
        """Whether a theorem says that no root is missing."""
        return self.completeness == "complete"

    def __len__(self) -> int:
        """The number of equilibria."""
        return len(self.index)

    @property
    def degenerate(self) -> Flags:
        """Of each equilibrium, whether its Jacobian is singular."""
        return self.nullity > 0

    @property
    def stable(self) -> Flags:
        """Of each equilibrium, see Equilibrium.stable."""
        return np.array((self.index == 0) & (self.nullity == 0), dtype=bool)

    @property
    def equilibria(self) -> List[Equilibrium]:
        """The equilibria one by one."""
        names = self.model.unknowns
        return [
            Equilibrium(names, q, float(e), int(i), int(z), float(m), float(r), float(c), int(k))
            for q, e, i, z, m, r, c, k in zip(
                self.angles,
                self.energy,
                self.index,
                self.nullity,
                self.margin,
                self.residual,
                self.condition,
                self.multiplicity,
            )
        ]

    def prove(self, threads: int = 1, most_digits: int = 68) -> "Proof":
        """What can be proved of this set; see Model.prove."""
        return self.model.prove(self, threads=threads, most_digits=most_digits)

    def plot(self, ax: Any = None) -> Any:
        """The equilibria of one unknown against the energy, or of the first two against each other over the potential;
        filled: stable. Returns matplotlib's axes."""
        from .plots import plot_roots

        return plot_roots(self, ax)

    def _line(self) -> str:
        return (
            f"{len(self)} equilibria ({int(self.stable.sum())} stable) among {len(self.roots)} complex roots at "
            f"{', '.join(f'{k}={number(v, 6)}' for k, v in self.parameters.items()) or 'no parameters'}, "
            f"{'clean' if self.clean else 'not clean'}, {'nothing proved' if self.proof is None else self.completeness}"
        )

    def _columns(self) -> List[str]:
        angles = len(self.model.angles)
        names = [f"{name} (rad)" if k < angles else name for k, name in enumerate(self.model.unknowns)]
        return names + ["energy", "index", "residual", "condition", ""]

    def _rows(self) -> List[List[str]]:
        return [
            [fixed(value) for value in e.q]
            + [number(e.energy), str(e.index), f"{e.residual:.1e}", f"{e.condition:.1e}"]
            + ["degenerate" if e.degenerate else "stable" if e.stable else ""]
            for e in self.equilibria
        ]

    def _foot(self) -> str:
        return self.summary.rstrip() + ("" if self.proof is None else "\n" + self.verdict)


@dataclass(repr=False, eq=False)
class Proof(Printed):
    """What is proved of a set of roots. Every number counts proofs."""

    roots: RootSet = field(repr=False)
    exists: Flags  #: of each root: exactly one root lies in the polydisc of its radius
    root_distinct: Flags
    reality: List[str]  #: of each root: real, non-real or undecided
    index_proved: Flags
    root_index: Integers
    digits: Integers  #: decimal digits of each proof's arithmetic; 0: nothing was proved
    radius: Reals  #: the largest distance of an unknown from its given value; angles in radians
    distinct: int  #: roots proved to exist and to differ from each other
    real: int
    non_real: int
    undecided: int
    duplicates: int
    index: int  #: real roots with a proved index
    contradictions: int  #: roots of which something else is proved than the enumeration says
    by_index: Integers
    bound: Optional[int]  #: proved, of the number of isolated complex roots
    bound_name: str
    complete: bool  #: no root is missing: `distinct` is the bound
    reason: str  #: why, or why not
    seconds: float
    summary: str

    @staticmethod
    def _of(roots: RootSet, found: Mapping[str, Any]) -> "Proof":
        return Proof(roots=roots, **found)

    def _line(self) -> str:
        return (
            f"{self.distinct} of {len(self.exists)} roots proved, {self.real} of them real, "
            f"{'complete' if self.complete else 'not complete'}"
        )

    def _foot(self) -> str:
        return self.summary.rstrip()


@dataclass(repr=False, eq=False)
class Event(Printed):
    """A degenerate equilibrium on a line of the parameter space."""

    kind: str  #: fold, pitchfork, transcritical, cusp, ..
    value: float  #: of the parameter
    q: Reals
    null_vector: Reals  #: of length 1
    residual: float
    correction: float  #: of the last step of Newton's method: about the error; NaN of other kinds than fold, pitchfork
    third: float  #: phi''' of the reduced potential along the null vector
    fourth: float  #: phi''''
    slope: float  #: of folds v . dF/dp; else the derivative by p of the eigenvalue that vanishes, along the branch
    index: int  #: negative eigenvalues beside the one that vanishes
    change: Integers  #: of the numbers of equilibria of index 0 .. n as the parameter grows; or empty
    at_infinity: Tuple[int, int]  #: equilibria that go to infinity as the parameter grows, and that come from there

    def _line(self) -> str:
        return f"{self.kind} at {number(self.value)}"


@dataclass(repr=False, eq=False)
class Interval(Printed):
    """Values of the parameter between neighbouring events."""

    low: float
    high: float
    at: float  #: where the equilibria were counted
    also_at: float  #: where they were counted again
    confirmed: bool  #: both have the same table
    count: int
    by_index: Integers
    clean: bool

    def _line(self) -> str:
        return f"{number(self.low, 6)} to {number(self.high, 6)}, {self.count} equilibria ({by_index(self.by_index)})"


@dataclass(repr=False, eq=False)
class Events(Printed):
    """All events on a line, and the equilibria between them."""

    model: "Model" = field(repr=False)
    parameter: str
    range: Tuple[float, float]
    events: List[Event]  #: by value
    intervals: List[Interval]
    paths: Dict[str, int]  #: of the critical system
    complex_solutions: int  #: of it, distinct ones
    start: str
    complete: bool  #: nothing speaks against the list
    argument: str  #: why nothing is missing, or what speaks against it
    seconds: float

    @staticmethod
    def _of(model: "Model", parameter: str, range: Tuple[float, float], found: Mapping[str, Any]) -> "Events":
        return Events(
            model=model,
            parameter=parameter,
            range=range,
            events=[Event(**e) for e in found["events"]],
            intervals=[Interval(**i) for i in found["intervals"]],
            **{k: v for k, v in found.items() if k not in ("events", "intervals")},
        )

    def __len__(self) -> int:
        return len(self.events)

    @property
    def values(self) -> Reals:
        """The parameter's values at the events."""
        return np.array([e.value for e in self.events])

    def _line(self) -> str:
        return (
            f"{len(self)} events for {self.parameter} from {number(self.range[0], 6)} to {number(self.range[1], 6)}, "
            f"{'complete' if self.complete else 'not complete'}"
        )

    def _columns(self) -> List[str]:
        return [self.parameter, "kind", *self.model.unknowns, "error"]

    def _rows(self) -> List[List[str]]:
        return [[number(e.value, 12), e.kind, *map(fixed, e.q), f"{e.correction:.1e}"] for e in self.events]

    def _foot(self) -> str:
        counts = "; ".join(interval._line() for interval in self.intervals)
        return f"{counts}\n{self.argument}"


@dataclass(repr=False, eq=False)
class Piece(Printed):
    """A piece of a branch between two events."""

    index: int  #: of its equilibria
    parameter: Reals  #: (points,), increasing
    q: Reals  #: (points, unknowns)
    ends: Tuple[str, str]  #: why it has its first and its last point: range, event, infinity, stopped

    @property
    def stable(self) -> bool:
        """Whether its equilibria are minima of the potential."""
        return self.index == 0

    def _line(self) -> str:
        return (
            f"index {self.index}, {len(self.parameter)} points from {number(self.parameter[0], 6)} to "
            f"{number(self.parameter[-1], 6)}"
        )


@dataclass(repr=False, eq=False)
class Diagram(Printed):
    """All equilibria against one parameter."""

    model: "Model" = field(repr=False)
    parameter: str
    range: Tuple[float, float]
    pieces: List[Piece]
    events: List[Event]
    failed_paths: int
    complete: bool  #: nothing speaks against all branches being there, from end to end
    argument: str  #: what speaks for it, or against it

    @staticmethod
    def _of(model: "Model", parameter: str, range: Tuple[float, float], found: Mapping[str, Any]) -> "Diagram":
        return Diagram(
            model=model,
            parameter=parameter,
            range=range,
            pieces=[Piece(**piece) for piece in found["pieces"]],
            events=[Event(**e) for e in found["events"]],
            failed_paths=found["failed_paths"],
            complete=found["complete"],
            argument=found["argument"],
        )

    def plot(self, ax: Any = None, unknown: Union[int, str, Callable[[Reals], Reals]] = 0) -> Any:
        """An unknown, by name or number, or a function of arrays (points, unknowns), against the parameter: solid where
        stable, dashed where not, folds and other events marked. Returns matplotlib's axes."""
        from .plots import plot_diagram

        return plot_diagram(self, ax, unknown)

    def _line(self) -> str:
        return (
            f"{len(self.pieces)} pieces of branches and {len(self.events)} events for {self.parameter} from "
            f"{number(self.range[0], 6)} to {number(self.range[1], 6)}"
        )

    def _columns(self) -> List[str]:
        return ["index", "points", "from", "to"]

    def _rows(self) -> List[List[str]]:
        return [
            [str(p.index), str(len(p.parameter)), number(p.parameter[0]), number(p.parameter[-1])] for p in self.pieces
        ]


@dataclass(repr=False, eq=False)
class Curve(Printed):
    """A curve of folds or pitchforks in a plane of two parameters."""

    kind: str  #: fold or pitchfork
    points: Reals  #: (points, 2)
    q: Reals  #: (points, unknowns): the degenerate equilibria
    ends: Tuple[str, str]  #: border, closed, symmetric (at its mirror image), degenerate, step or length

    def _line(self) -> str:
        return f"{self.kind}, {len(self.points)} points, ends: {', '.join(self.ends)}"


@dataclass(repr=False, eq=False)
class SpecialPoint(Printed):
    """A cusp, a tricritical pitchfork, or a point where a parameter is extremal on a curve."""

    kind: str
    point: Reals  #: (2,)
    q: Reals
    null_vector: Reals
    residual: float
    correction: float  #: of the last step of Newton's method: about the error
    derivatives: Reals  #: phi''' .. phi^(8) of the reduced potential

    def _line(self) -> str:
        return f"{self.kind} at {number(self.point[0])}, {number(self.point[1])}"


@dataclass(repr=False, eq=False)
class Region(Printed):
    """A region of constant count."""

    point: Reals  #: (2,), well inside
    count: int  #: equilibria there
    by_index: Integers
    area: float
    clean: bool  #: nothing speaks against the enumeration at the point
    confirmed: bool  #: no other enumeration inside the region differed
    polygons: List[Reals]  #: (corners, 2) each, counterclockwise; they overlap nowhere, and their union is the region

    def _line(self) -> str:
        around = ", ".join(number(value, 4) for value in self.point)
        return f"{self.count} equilibria ({by_index(self.by_index)}) around {around}"


@dataclass(repr=False, eq=False)
class Locus(Printed):
    """The bifurcation locus in a window of the plane of two parameters."""

    model: "Model" = field(repr=False)
    axes: Tuple[str, str]  #: names of the parameters x and y
    window: Tuple[Tuple[float, float], Tuple[float, float]]  #: ranges of x and y
    curves: List[Curve]
    special_points: List[SpecialPoint]
    regions: List[Region]
    from_infinity: List[Reals]  #: (points, 2) each: curves on which equilibria come from infinity
    #: (.., 3): two regions, the one with the smaller y first, and the curve between them; numbers from len(curves) on
    #: are those of from_infinity
    borders: Integers
    complete: bool  #: nothing speaks against it
    argument: str  #: why no curve and no cusp is missing, or what speaks against it
    failed_paths: int
    seconds: float

    @staticmethod
    def _of(model: "Model", axes: Tuple[str, str], window: Any, found: Mapping[str, Any]) -> "Locus":
        rest = {k: v for k, v in found.items() if k not in ("curves", "points", "regions")}
        return Locus(
            model=model,
            axes=axes,
            window=window,
            curves=[Curve(**curve) for curve in found["curves"]],
            special_points=[SpecialPoint(**point) for point in found["points"]],
            regions=[Region(**region) for region in found["regions"]],
            **rest,
        )

    @property
    def cusps(self) -> List[SpecialPoint]:
        """The cusps among the special points."""
        return [point for point in self.special_points if point.kind == "cusp"]

    def plot(self, ax: Any = None) -> Any:
        """Curves (folds and pitchforks of different colours), cusps marked, regions with their counts of equilibria.
        Returns matplotlib's axes."""
        from .plots import plot_locus

        return plot_locus(self, ax)

    def _line(self) -> str:
        folds = sum(curve.kind == "fold" for curve in self.curves)
        return (
            f"{folds} fold curves, {len(self.curves) - folds} pitchfork curves, {len(self.cusps)} cusps and "
            f"{len(self.regions)} regions of {self.axes[0]} and {self.axes[1]}, "
            f"{'complete' if self.complete else 'not complete'}"
        )

    def _columns(self) -> List[str]:
        return ["equilibria", "by index", *self.axes, "area"]

    def _rows(self) -> List[List[str]]:
        return [
            [str(r.count), by_index(r.by_index), number(r.point[0], 6), number(r.point[1], 6), number(r.area, 4)]
            for r in self.regions
        ]

    def _foot(self) -> str:
        return "\n".join([point._line() for point in self.cusps] + [self.argument])


@dataclass(repr=False, eq=False)
class Motion(Printed):
    """A motion at given times, and the evidence of its integration. Energies are in the model's unit."""

    model: "Model" = field(repr=False)
    parameters: Dict[str, float]
    formulation: str  #: lagrange or hamilton
    t: Reals  #: (points,): the times that it came to
    q: Reals  #: (points, unknowns): angles in radians, not turned into (-pi, pi], then coordinates
    v: Reals  #: (points, unknowns): their rates, a unit of time
    momentum: Reals  #: (points, unknowns): dT/dv
    kinetic: Reals  #: (points,): kinetic energy
    potential: Reals  #: (points,): potential energy
    work: Reals  #: (points,): of the generalised forces since the start
    dissipated: Reals  #: (points,): lost by damping since the start
    balance: Reals  #: (points,): kinetic + potential + dissipated - work, less its value at the start: an error
    status: str  #: "finished", or why it ended
    time: float  #: how far it came
    steps: int  #: that were tried
    evaluations: int  #: of the equations of motion
    largest_balance: float  #: the largest |balance| of all steps over the largest of the energies that it is made of

    @staticmethod
    def _of(model: "Model", p: Reals, formulation: str, found: Mapping[str, Any]) -> "Motion":
        parameters = dict(zip(model.parameters, p.tolist()))
        return Motion(model=model, parameters=parameters, formulation=formulation, **found)

    def __len__(self) -> int:
        """The number of points."""
        return len(self.t)

    @property
    def finished(self) -> bool:
        """Whether it came to the last of the times."""
        return self.status == "finished"

    @property
    def energy(self) -> Reals:
        """(points,): kinetic + potential."""
        return self.kinetic + self.potential

    def plot(self, ax: Any = None, unknown: Union[None, int, str, Callable[[Reals], Reals]] = None) -> Any:
        """Every unknown against the time, or one, by name or number, or a function of arrays (points, unknowns). Returns
        matplotlib's axes."""
        from .plots import plot_motion

        return plot_motion(self, ax, unknown)

    def plot_energy(self, ax: Any = None) -> Any:
        """Kinetic and potential energy and their sum against the time. Returns matplotlib's axes."""
        from .plots import plot_energies

        return plot_energies(self, ax)

    def _line(self) -> str:
        return (
            f"{len(self)} points to t = {number(self.t[-1] if len(self) else 0.0, 6)}, {self.status}, energy balance "
            f"{self.largest_balance:.1e} of the energy"
        )

    def _columns(self) -> List[str]:
        angles = len(self.model.angles)
        names = [f"{name} (rad)" if k < angles else name for k, name in enumerate(self.model.unknowns)]
        return ["t", *names, *self.model.rates, "kinetic", "potential", "balance"]

    def _rows(self) -> List[List[str]]:
        shown = range(0, len(self), max(1, -(-(len(self) - 1) // 20)))
        return [
            [number(self.t[k], 6), *map(fixed, self.q[k]), *map(fixed, self.v[k])]
            + [number(self.kinetic[k], 6), number(self.potential[k], 6), f"{self.balance[k]:.1e}"]
            for k in shown
        ]

    def _foot(self) -> str:
        every = max(1, -(-(len(self) - 1) // 20))
        some = f"every {every}th point; " if every > 1 else ""
        return f"{some}{self.formulation}, {self.steps} steps, {self.evaluations} evaluations"


@dataclass(repr=False, eq=False)
class Sweep(Printed):
    """The number of equilibria at many points; arrays have the shape of the points."""

    model: "Model" = field(repr=False)
    parameters: Dict[str, Reals]  #: those that were varied
    count: Integers  #: equilibria
    by_index: Integers  #: (.., n + 1): nondegenerate ones of index 0 .. n
    degenerate: Integers
    distinct: Integers  #: complex roots
    failed: Integers  #: paths
    clean: Flags  #: nothing speaks against the count
    alarm: Flags
    vanishing_equation: Flags  #: an equation vanishes there, and nothing was counted
    proved: Integers  #: roots, where asked for
    paths: int  #: at all points together
    mixed_volume: int  #: paths at a point
    seconds: float

    @staticmethod
    def _of(model: "Model", parameters: Dict[str, Reals], found: Mapping[str, Any]) -> "Sweep":
        shape = next(iter(parameters.values())).shape
        shaped = {
            key: value.reshape(shape + value.shape[1:]) if isinstance(value, np.ndarray) else value
            for key, value in found.items()
        }
        return Sweep(model=model, parameters=parameters, **shaped)

    def _line(self) -> str:
        return f"{self.count.size} points of {', '.join(self.parameters)}, {int(self.clean.sum())} of them clean"

    def _columns(self) -> List[str]:
        return ["equilibria", "points"]

    def _rows(self) -> List[List[str]]:
        counts, points = np.unique(self.count, return_counts=True)
        return [[str(c), str(k)] for c, k in zip(counts, points)]
