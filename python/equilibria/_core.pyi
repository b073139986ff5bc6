from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Progress = Optional[Callable[[int, int], object]]

__version__: str

class InvalidArgument(ValueError): ...
class CheckpointError(RuntimeError): ...

class Expression:
    def __add__(self, other: Any) -> Expression: ...
    def __radd__(self, other: Any) -> Expression: ...
    def __sub__(self, other: Any) -> Expression: ...
    def __rsub__(self, other: Any) -> Expression: ...
    def __mul__(self, other: Any) -> Expression: ...
    def __rmul__(self, other: Any) -> Expression: ...
    def __truediv__(self, other: Any) -> Expression: ...
    def __rtruediv__(self, other: Any) -> Expression: ...
    def __pow__(self, exponent: Any, modulus: None = None) -> Expression: ...
    def __rpow__(self, base: Any, modulus: None = None) -> Expression: ...
    def __neg__(self) -> Expression: ...
    def __pos__(self) -> Expression: ...
    def sin(self) -> Expression: ...
    def cos(self) -> Expression: ...
    def tan(self) -> Expression: ...
    def sqrt(self) -> Expression: ...
    def exp(self) -> Expression: ...
    def log(self) -> Expression: ...
    def square(self) -> Expression: ...

class FormulaBuilder:
    def __init__(self, angles: int, coordinates: int, parameters: int) -> None: ...
    def number(self, value: float) -> Expression: ...
    def angle(self, i: int) -> Expression: ...
    def coordinate(self, j: int) -> Expression: ...
    def parameter(self, k: int) -> Expression: ...
    def rate(self, i: int) -> Expression: ...
    def time(self) -> Expression: ...
    def begin_motion(self) -> None: ...

class RootSetData: ...

class FormulaModel:
    def __init__(
        self,
        name: str,
        angles: Sequence[str],
        coordinates: Sequence[str],
        parameters: Sequence[str],
        values: Reals,
        has_potential: bool,
        builder: FormulaBuilder,
        expressions: Sequence[Expression],
    ) -> None: ...
    @staticmethod
    def parse(text: str) -> FormulaModel: ...
    @staticmethod
    def read(path: str) -> FormulaModel: ...
    @property
    def name(self) -> str: ...
    @property
    def angles(self) -> List[str]: ...
    @property
    def coordinates(self) -> List[str]: ...
    @property
    def parameters(self) -> List[str]: ...
    @property
    def values(self) -> Reals: ...
    @property
    def has_potential(self) -> bool: ...
    @property
    def rates(self) -> List[str]: ...
    @property
    def time(self) -> str: ...
    @property
    def moves(self) -> bool: ...
    def number_of_parameter(self, name: str) -> int: ...
    def enumerate(
        self,
        p: Reals,
        seed: int,
        threads: int,
        start: str,
        more_digits: bool,
        prove: bool,
        limit: Optional[float],
        progress: Progress,
    ) -> Tuple[RootSetData, Dict[str, Any], Optional[Dict[str, Any]]]: ...
    def enumerate_from(
        self,
        solved: RootSetData,
        p: Reals,
        seed: int,
        threads: int,
        prove: bool,
        limit: Optional[float],
        progress: Progress,
    ) -> Tuple[RootSetData, Dict[str, Any], Optional[Dict[str, Any]]]: ...
    def prove(self, roots: RootSetData, threads: int, most_digits: int, progress: Progress) -> Dict[str, Any]: ...
    def events(
        self,
        p: Reals,
        active: int,
        low: float,
        high: float,
        seed: int,
        threads: int,
        limit: Optional[float],
        progress: Progress,
    ) -> Dict[str, Any]: ...
    def diagram(
        self,
        p: Reals,
        active: int,
        low: float,
        high: float,
        seed: int,
        threads: int,
        largest_step: float,
        limit: Optional[float],
        progress: Progress,
    ) -> Dict[str, Any]: ...
    def locus(
        self,
        p: Reals,
        active: Sequence[int],
        x: Sequence[float],
        y: Sequence[float],
        seed: int,
        threads: int,
        lines: int,
        checks: int,
        limit: Optional[float],
        progress: Progress,
    ) -> Dict[str, Any]: ...
    def sweep(
        self,
        points: Reals,
        seed: int,
        threads: int,
        prove: bool,
        checkpoint: str,
        limit: Optional[float],
        progress: Progress,
    ) -> Dict[str, Any]: ...
    def export(self, program: str, p: Reals) -> str: ...
    def residual(self, q: Reals, p: Reals) -> Reals: ...
    def jacobian(self, q: Reals, p: Reals) -> Reals: ...
    def potential(self, q: Reals, p: Reals) -> Reals: ...

def with_kinetics(
    model: FormulaModel,
    builder: FormulaBuilder,
    rates: Sequence[str],
    time: str,
    kinetic_energy: Expression,
    dissipation: Optional[Expression],
    generalised_forces: Sequence[Expression],
) -> FormulaModel: ...
def integrate_motion(
    model: FormulaModel,
    p: Reals,
    q: Reals,
    v: Reals,
    times: Reals,
    formulation: str,
    tolerance: float,
    largest_step: float,
    most_steps: int,
    progress: Progress,
) -> Dict[str, Any]: ...
def poles(model: FormulaModel, q: Reals, p: Reals) -> Tuple[NDArray[np.complex128], str]: ...
def kinetic_energy(model: FormulaModel, q: Reals, v: Reals, p: Reals) -> float: ...
def continue_branch(
    residual: Callable[[Reals, float], Reals],
    jacobian: Callable[[Reals, float], Any],
    parameter_derivative: Optional[Callable[[Reals, float], Reals]],
    q: Reals,
    p: float,
    low: float,
    high: float,
    direction: int,
    symmetric: bool,
    sparse: bool,
    most_steps: int,
    first_step: float,
    largest_step: float,
    parameter_weight: float,
) -> Dict[str, Any]: ...
def bifurcation_diagram(
    residual: Callable[[Reals, float], Reals],
    jacobian: Callable[[Reals, float], Any],
    parameter_derivative: Optional[Callable[[Reals, float], Reals]],
    q: Reals,
    p: float,
    low: float,
    high: float,
    symmetric: bool,
    sparse: bool,
    most_steps: int,
    first_step: float,
    largest_step: float,
    parameter_weight: float,
    most_branches: int,
    slices: int,
    checks: int,
    amplitude: float,
) -> Dict[str, Any]: ...
def critical_curve(
    residual: Callable[[Reals, float, float], Reals],
    jacobian: Callable[[Reals, float, float], Any],
    parameter_derivative: Optional[Callable[[Reals, float, float], Reals]],
    folds: bool,
    q: Reals,
    p: float,
    null_vector: Reals,
    left_null_vector: Reals,
    r: float,
    low: float,
    high: float,
    p_low: float,
    p_high: float,
    direction: int,
    symmetric: bool,
    sparse: bool,
    most_steps: int,
    first_step: float,
    largest_step: float,
    parameter_weight: float,
) -> Dict[str, Any]: ...

class BoundStructure:
    def __init__(self, text: str, images: bool) -> None: ...
    name: str
    nodes: Dict[str, int]
    notes: List[str]
    parameter: str
    conservative: bool
    measured: int
    window: Tuple[float, float]
    directions: Tuple[bool, bool]
    steps: Tuple[float, float, float]
    loaded: Dict[str, Any]
    drawn: Reals
    lines: List[List[int]]
    size: int
    def results(self, position: Reals, rotation: Reals, multipliers: Reals, p: float) -> str: ...
    def follow(
        self,
        direction: int,
        low: float,
        high: float,
        most_steps: int,
        first_step: float,
        largest_step: float,
        parameter_weight: float,
    ) -> Dict[str, Any]: ...
    def diagram(
        self,
        low: float,
        high: float,
        most_steps: int,
        first_step: float,
        largest_step: float,
        parameter_weight: float,
        most_branches: int,
        slices: int,
        checks: int,
        amplitude: float,
    ) -> Dict[str, Any]: ...
