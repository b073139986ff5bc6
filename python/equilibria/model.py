"""Models: the potential or the equations of a mechanical system, and everything that is done with them."""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Expression, FormulaBuilder, FormulaModel, InvalidArgument
from .progress import Progress, reporting
from .results import Diagram, Events, Locus, Motion, Proof, RootSet, Sweep

Names = Union[int, Sequence[str]]


class Values:
    """What a model's function is given: expressions by number, `t[0]`, and by name, `t["t1"]` or `t.t1`."""

    def __init__(self, names: Sequence[str], expressions: Sequence[Expression], what: str) -> None:
        self.__names, self.__expressions, self.__what = list(names), tuple(expressions), what

    def __len__(self) -> int:
        return len(self.__expressions)

    def __iter__(self) -> Iterator[Expression]:
        return iter(self.__expressions)

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            if key not in self.__names:
                raise InvalidArgument(f"{self.__what} = {key}: must be {_either(self.__names)}")
            return self.__expressions[self.__names.index(key)]
        try:
            return self.__expressions[key]
        except IndexError:
            raise InvalidArgument(f"number of {self.__what} = {key}: must be {_numbers(len(self))}") from None

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]


def _numbers(size: int) -> str:
    return f"0 to {size - 1}" if size > 0 else "a number, of which there are none"


def _either(names: Sequence[str]) -> str:
    if not names:
        return "a name, of which there are none"
    return " or ".join(filter(None, [", ".join(names[:-1]), names[-1]]))


def _names(given: Names, letter: str, argument: str) -> List[str]:
    if isinstance(given, bool):
        raise InvalidArgument(f"{argument} = {given}: must be names, or how many there are")
    if isinstance(given, (int, np.integer)):
        if given < 0:
            raise InvalidArgument(f"{argument} = {given}: must be names, or how many there are")
        return [f"{letter}{k + 1}" for k in range(given)]
    if isinstance(given, str):
        raise InvalidArgument(f"{argument} = {given!r}: must be a list of names, or how many there are")
    return [str(name) for name in given]


def _integer(value: Any, argument: str, low: int, high: int) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not low <= value <= high:
        raise InvalidArgument(f"{argument} = {value!r}: must be an integer from {low} to {high}")
    return int(value)


def _run(seed: Any, threads: Any, limit: Any = None) -> Dict[str, Any]:
    try:
        seconds = None if limit is None else float(limit)
    except (TypeError, ValueError):
        seconds = -1.0
    if seconds is not None and not seconds > 0:
        raise InvalidArgument(f"limit = {limit!r}: must be a positive number of seconds, or None")
    return {
        "seed": _integer(seed, "seed", 0, 2**64 - 1),
        "threads": _integer(threads, "threads", 0, 1024),
        "limit": seconds,
    }


def _range(given: Any, argument: str) -> Tuple[float, float]:
    try:
        low, high = (float(value) for value in given)
    except (TypeError, ValueError):
        raise InvalidArgument(f"{argument} = {given!r}: must be two numbers, the smaller one first") from None
    return low, high


class Model:
    """A mechanical system by its potential V, or by its equations F = 0, in angles, coordinates and parameters.

    function: called once, with expressions, and recorded: `function(t, p)`, or `function(t, x, p)` where there are
        coordinates. `t`, `x` and `p` are the angles, the coordinates and the parameters, by number or by name. It
        returns the potential; or a list of equations, one for each unknown, angles' first. numpy's functions and those
        of this package (`eq.sin`, ..) work on expressions.
    angles: names of the unknown angles, or how many there are (t1, t2, ..). Radians.
    parameters: names and values.
    coordinates: names of the other unknowns, or how many there are (x1, x2, ..).
    equations: whether the function returns equations; None: it does if it returns a list, a tuple or an array.

    A model that moves has a kinetic energy beside its potential, and may have damping and other forces:

    kinetic_energy: `function(t, v, p)`, or `function(t, x, v, p)` where there are coordinates: a quadratic form in v, the
        rates of the unknowns, angles' first, by number or by name.
    dissipation: Rayleigh's function, of the same arguments; the damping forces are its derivatives by v, with the other
        sign.
    generalised_forces: `function(time, t, v, p)`, or `function(time, t, x, v, p)`: a list, one for each unknown, of all
        forces that neither the potential nor the dissipation gives.
    rates: names of the rates; None: t1_rate, .., of the unknowns' names.

    The rules: an angle stands inside sin and cos alone, as a sum of integer multiples of angles and constant phases;
    angles and coordinates enter by polynomials of their sines, cosines and values; parameters by any of +, -, *, /,
    **, sin, cos, tan, sqrt, exp, log. In the functions of a motion unknowns, rates and the time enter by any of these as
    well, but for angles themselves. What breaks a rule raises InvalidArgument where it happens.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        angles: Names = 0,
        parameters: Optional[Mapping[str, float]] = None,
        coordinates: Names = 0,
        equations: Optional[bool] = None,
        name: str = "",
        kinetic_energy: Optional[Callable[..., Any]] = None,
        dissipation: Optional[Callable[..., Any]] = None,
        generalised_forces: Optional[Callable[..., Any]] = None,
        rates: Optional[Sequence[str]] = None,
    ) -> None:
        angle_names = _names(angles, "t", "angles")
        coordinate_names = _names(coordinates, "x", "coordinates")
        values = {str(key): value for key, value in (parameters or {}).items()}
        builder = FormulaBuilder(len(angle_names), len(coordinate_names), len(values))
        t = Values(angle_names, [builder.angle(k) for k in range(len(angle_names))], "angle")
        x = Values(coordinate_names, [builder.coordinate(k) for k in range(len(coordinate_names))], "coordinate")
        p = Values(list(values), [builder.parameter(k) for k in range(len(values))], "parameter")
        place = (t, x) if coordinate_names else (t,)
        formulas = _listed(function(*place, p))
        if equations is None:
            equations = isinstance(formulas, list)
        listed = formulas if isinstance(formulas, list) else [formulas]
        self._data = _formula_model(
            name, angle_names, coordinate_names, values, not equations, builder, [_formula(f, builder) for f in listed]
        )
        _require_kinetic_energy(kinetic_energy, dissipation, generalised_forces, rates)
        if kinetic_energy is None:
            return
        unknowns = angle_names + coordinate_names
        rate_names = _rate_names(rates, unknowns, list(values))
        builder.begin_motion()
        v = Values(rate_names, [builder.rate(k) for k in range(len(unknowns))], "rate")
        forces: List[Any] = []
        if generalised_forces is not None:
            forces = _forces(_listed(generalised_forces(builder.time(), *place, v, p)))
        self._data = _core.with_kinetics(
            self._data,
            builder,
            rate_names,
            _unused("time", unknowns + list(values) + rate_names) if forces else "",
            _formula(kinetic_energy(*place, v, p), builder),
            None if dissipation is None else _formula(dissipation(*place, v, p), builder),
            [_formula(f, builder) for f in forces],
        )

    @classmethod
    def _of(cls, data: FormulaModel) -> "Model":
        model = cls.__new__(cls)
        model._data = data
        return model

    @classmethod
    def read(cls, path: Union[str, "os.PathLike[str]"]) -> "Model":
        """The model in a file of JSON, as `parse` has it. Raises InvalidArgument where it cannot be read."""
        return cls._of(FormulaModel.read(os.fspath(path)))

    @classmethod
    def parse(cls, text: str) -> "Model":
        """The model that a text in JSON says: "angles", "coordinates", "parameters" with their values, "definitions",
        and "potential" or "equations", which are formulas such as "-cos(t1) - k*cos(t1 - t2)^2"; of one that moves also
        "rates", "kinetic_energy", "dissipation", "generalised_forces" and "time".

        Raises InvalidArgument for what is none, with line and column.
        """
        return cls._of(FormulaModel.parse(text))

    @classmethod
    def from_sympy(
        cls,
        expression: Any,
        angles: Sequence[Any],
        parameters: Optional[Mapping[Any, float]] = None,
        coordinates: Sequence[Any] = (),
        name: str = "",
        kinetic_energy: Any = None,
        dissipation: Any = None,
        generalised_forces: Optional[Sequence[Any]] = None,
        rates: Optional[Sequence[Any]] = None,
        time: Any = None,
    ) -> "Model":
        """The model of a potential that is a sympy expression, or of equations: a list or a column of them.

        angles, coordinates: sympy's symbols, or applied functions such as theta(t). parameters: symbols and their
        values. Names of unknowns are the symbols'. Raises InvalidArgument for what a model cannot have.

        kinetic_energy, dissipation: expressions, of a model that moves; generalised_forces: one for each unknown. rates:
        symbols; None: of unknowns that are applied functions their derivatives, theta(t).diff(t). time: a symbol; None:
        what those functions are of.
        """
        import sympy

        from .from_sympy import converted

        sympify: Any = sympy.sympify
        angles, coordinates = ([sympify(s) for s in symbols] for symbols in (angles, coordinates))
        values = {sympify(symbol): value for symbol, value in (parameters or {}).items()}
        builder = FormulaBuilder(len(angles), len(coordinates), len(values))
        unknowns = [*angles, *coordinates]
        _require_kinetic_energy(kinetic_energy, dissipation, generalised_forces, rates)
        known = {symbol: builder.angle(k) for k, symbol in enumerate(angles)}
        known.update({symbol: builder.coordinate(k) for k, symbol in enumerate(coordinates)})
        known.update({symbol: builder.parameter(k) for k, symbol in enumerate(values)})
        has_potential = not isinstance(expression, (list, tuple, sympy.MatrixBase))
        listed = [expression] if has_potential else list(expression)
        data = _formula_model(
            name,
            [_sympy_name(s) for s in angles],
            [_sympy_name(s) for s in coordinates],
            {_sympy_name(s): value for s, value in values.items()},
            has_potential,
            builder,
            [converted(e, known, builder) for e in listed],
        )
        if kinetic_energy is None:
            return cls._of(data)
        names = [_sympy_name(s) for s in unknowns]
        derivatives, time = _sympy_rates(unknowns, rates, None if time is None else sympify(time))
        rate_names = _rate_names(
            None if rates is None else [_sympy_name(s) for s in derivatives], names, [_sympy_name(s) for s in values]
        )
        builder.begin_motion()
        known.update({symbol: builder.rate(k) for k, symbol in enumerate(derivatives)})
        energies = [None if e is None else converted(e, known, builder) for e in (kinetic_energy, dissipation)]
        if time is not None:
            known[time] = builder.time()
        forces = [] if generalised_forces is None else _forces(list(generalised_forces))
        time_name = _unused("time" if time is None else _sympy_name(time), names + data.parameters + rate_names)
        return cls._of(
            _core.with_kinetics(
                data,
                builder,
                rate_names,
                time_name if forces else "",
                energies[0],
                energies[1],
                [converted(e, known, builder) for e in forces],
            )
        )

    @property
    def name(self) -> str:
        return self._data.name

    @property
    def angles(self) -> List[str]:
        """Names of the unknown angles."""
        return self._data.angles

    @property
    def coordinates(self) -> List[str]:
        """Names of the other unknowns."""
        return self._data.coordinates

    @property
    def unknowns(self) -> List[str]:
        """Names of the unknowns, angles first: the order of every array of unknowns."""
        return self.angles + self.coordinates

    @property
    def parameters(self) -> Dict[str, float]:
        """The parameters' values where no others are given."""
        return dict(zip(self._data.parameters, self._data.values.tolist()))

    @property
    def has_potential(self) -> bool:
        """Whether the model is given by its potential."""
        return self._data.has_potential

    @property
    def moves(self) -> bool:
        """Whether the model has a kinetic energy."""
        return self._data.moves

    @property
    def rates(self) -> List[str]:
        """Names of the rates of the unknowns, in their order, of a model that moves."""
        return self._data.rates

    def __repr__(self) -> str:
        values = ", ".join(f"{key}={value:.6g}" for key, value in self.parameters.items())
        what = "potential" if self.has_potential else "equations"
        return f"<Model{' ' + repr(self.name) if self.name else ''}: {what} of {', '.join(self.unknowns)}; {values}>"

    def _at(self, at: Optional[Mapping[str, float]], given: Mapping[str, float]) -> NDArray[np.float64]:
        values = self._data.values
        for name, value in {**(at or {}), **given}.items():
            number = self._data.number_of_parameter(str(name))
            if isinstance(value, bool) or np.ndim(value) != 0:
                raise InvalidArgument(f"{name} = {value!r}: must be a number")
            try:
                values[number] = float(value)
            except (TypeError, ValueError):
                raise InvalidArgument(f"{name} = {value!r}: must be a number") from None
            if not np.isfinite(values[number]):
                raise InvalidArgument(f"{name} = {value!r}: must be finite")
        return values

    def potential(self, q: ArrayLike, at: Optional[Mapping[str, float]] = None, **parameters: float) -> Any:
        """V at unknowns q, an array (.., n) of angles in radians and coordinates; NaN of a model without one."""
        return self._data.potential(_unknowns(q), self._at(at, parameters))[()]

    def residual(
        self, q: ArrayLike, at: Optional[Mapping[str, float]] = None, **parameters: float
    ) -> NDArray[np.float64]:
        """F at unknowns q, (.., n): the potential's gradient, or the equations. Array (.., n)."""
        return self._data.residual(_unknowns(q), self._at(at, parameters))

    def jacobian(
        self, q: ArrayLike, at: Optional[Mapping[str, float]] = None, **parameters: float
    ) -> NDArray[np.float64]:
        """dF/dq at unknowns q, (.., n), row after row: the potential's Hessian. Array (.., n, n)."""
        return self._data.jacobian(_unknowns(q), self._at(at, parameters))

    def enumerate(
        self,
        seed: int = 1,
        threads: int = 1,
        start: Union[str, RootSet] = "least_cost",
        more_digits: bool = False,
        prove: bool = True,
        progress: Progress = False,
        limit: Optional[float] = None,
        at: Optional[Mapping[str, float]] = None,
        **parameters: float,
    ) -> RootSet:
        """All equilibria at these parameters (those of the model where none are given), and all complex roots.

        prove: each root by Krawczyk's test, with a verdict on what may be missing: the set's proof, completeness and
        verdict. Without, nothing is claimed.

        seed: of the random numbers; the same seed gives the same bytes. threads: 0 for all of the machine's; changes no
        result. start: "least_cost", "total_degree" or "polyhedral", or the roots of this model at other parameters,
        which are followed from there. more_digits: paths that fail in double are tracked with 50 digits. progress: True
        (drawn by tqdm where it is installed) or a function of (done, all) paths. limit: seconds after which the call
        returns what it has found; the verdict and the counts say what was left. at: parameters by name, for names that
        are arguments here.

        Ctrl-C ends the call within a moment, by KeyboardInterrupt.
        """
        p = self._at(at, parameters)
        run = _run(seed, threads, limit)
        with reporting(progress, "enumerate") as report:
            run["prove"] = bool(prove)
            if isinstance(start, RootSet):
                if start.model._data is not self._data:
                    raise InvalidArgument("start = roots of another model: must be those of this one")
                found = self._data.enumerate_from(start._data, p, progress=report, **run)
            else:
                found = self._data.enumerate(p, start=str(start), more_digits=bool(more_digits), progress=report, **run)
        return RootSet._of(self, p, *found)

    def prove(self, roots: RootSet, threads: int = 1, most_digits: int = 68) -> Proof:
        """What can be proved of a set of roots by interval arithmetic: that each exists, differs from the others, is
        real or not, has its index; and, where a bound is reached, that none is missing.

        most_digits: the most that a proof may take, 15, 34 or 68; with 68 the proof that the set has already is
        returned. Ctrl-C counts when the proof is finished.
        """
        if not isinstance(roots, RootSet) or roots.model._data is not self._data:
            raise InvalidArgument("roots: must be a set that this model's enumerate returned")
        if roots.proof is not None and most_digits == 68:
            return roots.proof
        run = _run(roots.seed, threads)
        return Proof._of(
            roots,
            self._data.prove(
                roots._data,
                threads=run["threads"],
                most_digits=_integer(most_digits, "most_digits", 15, 68),
                progress=None,
            ),
        )

    def events(
        self,
        parameter: str,
        range: Tuple[float, float],
        seed: int = 1,
        threads: int = 1,
        progress: Progress = False,
        limit: Optional[float] = None,
        at: Optional[Mapping[str, float]] = None,
        **parameters: float,
    ) -> Events:
        """All values of one parameter in a range at which the number or the indices of the equilibria change.

        The model must be polynomial in that parameter. progress: as of enumerate, of the present of several systems.
        Ctrl-C ends the call at the next report of progress: where branches are followed, no report is made. limit:
        seconds after which it is ended so, by TimeoutError.
        """
        active = self._data.number_of_parameter(str(parameter))
        low, high = _range(range, "range")
        with reporting(progress, "events") as report:
            found = self._data.events(
                self._at(at, parameters), active, low, high, progress=report, **_run(seed, threads, limit)
            )
        return Events._of(self, str(parameter), (low, high), found)

    def diagram(
        self,
        parameter: str,
        range: Tuple[float, float],
        seed: int = 1,
        threads: int = 1,
        largest_step: float = 0.02,
        progress: Progress = False,
        limit: Optional[float] = None,
        at: Optional[Mapping[str, float]] = None,
        **parameters: float,
    ) -> Diagram:
        """All equilibria against one parameter, as branches between its events, at least every `largest_step` along.

        As of events otherwise.
        """
        active = self._data.number_of_parameter(str(parameter))
        low, high = _range(range, "range")
        with reporting(progress, "diagram") as report:
            found = self._data.diagram(
                self._at(at, parameters),
                active,
                low,
                high,
                largest_step=float(largest_step),
                progress=report,
                **_run(seed, threads, limit),
            )
        return Diagram._of(self, str(parameter), (low, high), found)

    def locus(
        self,
        x: Tuple[str, float, float],
        y: Tuple[str, float, float],
        seed: int = 1,
        threads: int = 1,
        lines: int = 12,
        checks: int = 20,
        progress: Progress = False,
        limit: Optional[float] = None,
        at: Optional[Mapping[str, float]] = None,
        **parameters: float,
    ) -> Locus:
        """The bifurcation locus in a window of the plane of two parameters: curves of folds and of pitchforks, cusps,
        and the regions between the curves with their equilibria counted by index.

        x, y: a parameter with the smaller and the larger value. lines: in each direction, solved as a check. checks:
        points in each direction whose equilibria are counted and compared. As of events otherwise.
        """
        axes = []
        for argument, axis in (("x", x), ("y", y)):
            if isinstance(axis, str) or len(axis) != 3:
                raise InvalidArgument(f"{argument} = {axis!r}: must be the name of a parameter and two numbers")
            axes.append((self._data.number_of_parameter(str(axis[0])), _range(axis[1:], argument)))
        with reporting(progress, "locus") as report:
            found = self._data.locus(
                self._at(at, parameters),
                [axes[0][0], axes[1][0]],
                axes[0][1],
                axes[1][1],
                lines=_integer(lines, "lines", 2, 10000),
                checks=_integer(checks, "checks", 0, 10000),
                progress=report,
                **_run(seed, threads, limit),
            )
        return Locus._of(self, (str(x[0]), str(y[0])), (axes[0][1], axes[1][1]), found)

    def sweep(
        self,
        values: Mapping[str, ArrayLike],
        grid: bool = True,
        seed: int = 1,
        threads: int = 1,
        prove: bool = False,
        progress: Progress = False,
        limit: Optional[float] = None,
        checkpoint: Union[str, "os.PathLike[str]", None] = None,
        at: Optional[Mapping[str, float]] = None,
        **parameters: float,
    ) -> Sweep:
        """How many equilibria of each index there are at many points of the parameter space.

        values: of one or more parameters. grid: every combination of their one-dimensional arrays, the last one
        fastest; otherwise the arrays, of one shape or broadcast to it, are the points. prove: each root, by Krawczyk's
        test. checkpoint: a file that keeps the points that are finished; the same call goes on from there, with any number
        of threads. One of another call, or a damaged one, raises CheckpointError. Ctrl-C ends the call within a moment,
        and so does limit, in seconds, by TimeoutError.
        """
        if not values:
            raise InvalidArgument("values = {}: must name a parameter with its values")
        fixed = self._at(at, parameters)
        numbers = [self._data.number_of_parameter(str(name)) for name in values]
        try:
            arrays = [np.asarray(value, dtype=float) for value in values.values()]
            if grid:
                for name, array in zip(values, arrays):
                    if array.ndim > 1:
                        raise InvalidArgument(f"{name} = an array of {array.ndim} dimensions: must have one")
                arrays = np.meshgrid(*arrays, indexing="ij")
            else:
                arrays = np.broadcast_arrays(*arrays)
        except InvalidArgument:
            raise
        except (TypeError, ValueError) as error:
            raise InvalidArgument(f"values: must be arrays of numbers that go together: {error}") from None
        points = np.tile(fixed, (arrays[0].size, 1))
        for number, array in zip(numbers, arrays):
            points[:, number] = array.ravel()
        if points.size and not np.isfinite(points).all():
            raise InvalidArgument("values: must be finite")
        with reporting(progress, "sweep") as report:
            found = self._data.sweep(
                points,
                prove=bool(prove),
                checkpoint="" if checkpoint is None else os.fspath(checkpoint),
                progress=report,
                **_run(seed, threads, limit),
            )
        return Sweep._of(self, {str(name): array for name, array in zip(values, arrays)}, found)

    def kinetic_energy(
        self, q: ArrayLike, v: ArrayLike, at: Optional[Mapping[str, float]] = None, **parameters: float
    ) -> float:
        """T at unknowns q and rates v, arrays (n,), of a model that moves."""
        return _core.kinetic_energy(self._data, _unknowns(q), _unknowns(v, "v"), self._at(at, parameters))

    def poles(
        self, q: ArrayLike, at: Optional[Mapping[str, float]] = None, **parameters: float
    ) -> NDArray[np.complex128]:
        """The poles of the motion about an equilibrium q, an array (n,), linearised at the time 0: 2 n complex numbers a
        unit of time, those with the largest real part last. The equilibrium is asymptotically stable where all real
        parts are negative."""
        return _core.poles(self._data, _unknowns(q), self._at(at, parameters))[0]

    def stability(self, q: ArrayLike, at: Optional[Mapping[str, float]] = None, **parameters: float) -> str:
        """What poles, Routh's table and Hurwitz's minors say of the motion about an equilibrium q, an array (n,):
        "stable" (asymptotically), "unstable", or "marginal" where poles are on the imaginary axis, as without damping,
        or the criteria do not agree."""
        return _core.poles(self._data, _unknowns(q), self._at(at, parameters))[1]

    def motion(
        self,
        start: Union[ArrayLike, Mapping[str, float]],
        rates: Union[ArrayLike, Mapping[str, float], None] = None,
        times: ArrayLike = 10.0,
        formulation: str = "lagrange",
        tolerance: float = 1e-12,
        largest_step: float = 0.0,
        most_steps: int = 10_000_000,
        progress: Progress = False,
        at: Optional[Mapping[str, float]] = None,
        **parameters: float,
    ) -> Motion:
        """The motion from a place at the time 0, by Dormand and Prince's method with dense output, and its energy balance.

        start: the unknowns at the time 0, an array (n,) of angles in radians and coordinates, or numbers by name, others
        0. rates: theirs, an array (n,) or numbers by the names of `rates`; None: from rest. times: at which the motion is
        asked for, an array (points,), none below 0, none below the one before; or a number: 201 even times from 0 to it.
        formulation: "lagrange", Lagrange's equations of the second kind, or "hamilton", the canonical ones. tolerance: of
        a step, relative and absolute. largest_step: in units of time; 0: no bound. progress: as of enumerate, of the
        times.

        What stops a motion, a singular mass matrix for instance, is its status, and the points before are kept. Ctrl-C
        ends the call within a moment, by KeyboardInterrupt.
        """
        try:
            asked = np.asarray(times, dtype=float)
        except (TypeError, ValueError):
            raise InvalidArgument(f"times = {times!r}: must be an array of real numbers, or a number") from None
        if asked.ndim == 0:
            if not (np.isfinite(asked) and asked > 0):
                raise InvalidArgument(f"times = {times!r}: must be positive where it is one number")
            asked = float(asked) * np.arange(201) / 200
        if not 1e-15 <= tolerance < 1:
            raise InvalidArgument(f"tolerance = {tolerance}: must be from 1e-15 to 1, 1 excluded")
        p = self._at(at, parameters)
        q = self._start(start, self.unknowns, "start")
        v = np.zeros(len(self.unknowns)) if rates is None else self._start(rates, self.rates, "rates")
        with reporting(progress, "motion") as report:
            found = _core.integrate_motion(
                self._data,
                p,
                q,
                v,
                np.ascontiguousarray(asked),
                str(formulation),
                tolerance=float(tolerance),
                largest_step=float(largest_step),
                most_steps=_integer(most_steps, "most_steps", 1, 2**63 - 1),
                progress=report,
            )
        return Motion._of(self, p, str(formulation), found)

    def _start(self, given: Any, names: Sequence[str], argument: str) -> NDArray[np.float64]:
        if not isinstance(given, Mapping):
            values = _unknowns(given, argument)
            if values.shape != (len(self.unknowns),):
                raise InvalidArgument(
                    f"{argument} = an array of shape {values.shape}: must have a number for each unknown: "
                    f"{', '.join(self.unknowns)}"
                )
            for name, value in zip(names, values):
                if not np.isfinite(value):
                    raise InvalidArgument(f"{argument}: {name} = {value}: must be finite")
            return values
        y = np.zeros(len(self.unknowns))
        for name, value in given.items():
            if name not in names:
                raise InvalidArgument(f"{argument} = {name}: must be {_either(names)}")
            try:
                y[names.index(name)] = float(value)
            except (TypeError, ValueError):
                raise InvalidArgument(f"{name} = {value!r}: must be a number") from None
            if not np.isfinite(y[names.index(name)]):
                raise InvalidArgument(f"{argument}: {name} = {value}: must be finite")
        return y

    def export(self, program: str, at: Optional[Mapping[str, float]] = None, **parameters: float) -> str:
        """The equations as polynomials in the cosine c1 and the sine s1 of each angle, with c1^2 + s1^2 = 1, and in the
        coordinates x1, .., as input of another solver: "phcpack", "bertini", "homotopy_continuation" or "macaulay2".
        """
        return self._data.export(str(program), self._at(at, parameters))


def _formula(value: Any, builder: FormulaBuilder) -> Expression:
    if isinstance(value, Expression):
        return value
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return _formula(value.item(), builder)
    if isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool):
        return builder.number(float(value))
    raise InvalidArgument(
        f"what the function returns = {value!r}: must be an expression of unknowns and parameters, or a list of them"
    )


def _formula_model(
    name: str,
    angles: List[str],
    coordinates: List[str],
    parameters: Mapping[str, Any],
    has_potential: bool,
    builder: FormulaBuilder,
    formulas: List[Expression],
) -> FormulaModel:
    values = []
    for key, value in parameters.items():
        try:
            values.append(float(value))
        except (TypeError, ValueError):
            raise InvalidArgument(f"{key} = {value!r}: must be a number") from None
    return FormulaModel(
        name, angles, coordinates, list(parameters), np.array(values, dtype=float), has_potential, builder, formulas
    )


def _listed(formulas: Any) -> Any:
    """What a function returned: one thing, or a list."""
    if isinstance(formulas, np.ndarray):
        return formulas.ravel().tolist() if formulas.ndim else formulas.item()
    return list(formulas) if isinstance(formulas, tuple) else formulas


def _forces(given: Any) -> List[Any]:
    if not isinstance(given, list):
        raise InvalidArgument(f"generalised_forces = {given!r}: must be a list, one for each unknown")
    if not given:
        raise InvalidArgument("number of generalised_forces = 0: must be one for each unknown")
    return given


def _require_kinetic_energy(kinetic_energy: Any, dissipation: Any, generalised_forces: Any, rates: Any) -> None:
    others = {"dissipation": dissipation, "generalised_forces": generalised_forces, "rates": rates}
    for argument, value in others.items():
        if kinetic_energy is None and value is not None:
            raise InvalidArgument(f"{argument} = without kinetic_energy: must stand beside one")


def _unused(name: str, names: Sequence[str]) -> str:
    while name in names:
        name += "_"
    return name


def _rate_names(rates: Optional[Sequence[str]], unknowns: Sequence[str], parameters: Sequence[str]) -> List[str]:
    if rates is None:
        return [_unused(f"{name}_rate", [*unknowns, *parameters]) for name in unknowns]
    if isinstance(rates, str):
        raise InvalidArgument(f"rates = {rates!r}: must be a list of names, one for each unknown")
    names = [str(name) for name in rates]
    if len(names) != len(unknowns):
        raise InvalidArgument(f"number of rates = {len(names)}: must be one for each unknown: {len(unknowns)}")
    return names


def _unknowns(q: ArrayLike, argument: str = "q") -> NDArray[np.float64]:
    try:
        return np.ascontiguousarray(q, dtype=float)
    except (TypeError, ValueError):
        raise InvalidArgument(f"{argument} = {q!r}: must be an array of real numbers") from None


def _sympy_rates(unknowns: Sequence[Any], rates: Optional[Sequence[Any]], time: Any) -> Tuple[List[Any], Any]:
    """The symbols or derivatives of the rates, and the time's symbol, where there is one."""
    import sympy

    sympify: Any = sympy.sympify
    if time is None:
        times = {s.args[0] for s in unknowns if not s.is_Symbol and len(s.args) == 1}
        time = times.pop() if len(times) == 1 else None
    if rates is not None:
        return [sympify(s) for s in rates], time
    for s in unknowns:
        if s.is_Symbol or time is None or s.args != (time,):
            raise InvalidArgument(
                f"rates = None: must be a symbol for each unknown, {s} being no function of one time alone"
            )
    return [s.diff(time) for s in unknowns], time


def _sympy_name(symbol: Any) -> str:
    name = symbol.name if getattr(symbol, "is_Symbol", False) else symbol.func.__name__
    return "".join(c if c.isascii() and c.isalnum() else "_" for c in name)
