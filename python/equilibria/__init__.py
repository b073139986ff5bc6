"""Every equilibrium of a mechanical system, proved, classified and traced.

    import equilibria as eq

    model = eq.Model(lambda t, p: -eq.cos(t[0]) - p.k * eq.cos(t[1] - t[0]), angles=2, parameters={"k": 0.5})
    print(model.enumerate())

Angles are radians throughout. What breaks a rule raises InvalidArgument, a ValueError that names the argument, quotes
its value and says what is allowed.
"""

try:
    from ._built_for import instructions as _instructions  # type: ignore  # written by a native build
except ImportError:
    pass
else:
    from .processor import require as _require

    _require(_instructions)

from ._core import CheckpointError, Expression, InvalidArgument, __version__
from . import continuation
from .functions import cos, exp, log, pi, sin, sqrt, tan
from .model import Model
from .results import (
    Curve,
    Diagram,
    Equilibrium,
    Event,
    Events,
    Interval,
    Locus,
    Motion,
    Piece,
    Proof,
    Region,
    RootSet,
    SpecialPoint,
    Sweep,
)
from .structure import Structure, StructureBranch, StructureDiagram, StructurePoint

__all__ = [
    "CheckpointError",
    "Curve",
    "Diagram",
    "Equilibrium",
    "Event",
    "Events",
    "Expression",
    "Interval",
    "InvalidArgument",
    "Locus",
    "Model",
    "Motion",
    "Piece",
    "Proof",
    "Region",
    "RootSet",
    "SpecialPoint",
    "Structure",
    "StructureBranch",
    "StructureDiagram",
    "StructurePoint",
    "Sweep",
    "__version__",
    "continuation",
    "cos",
    "exp",
    "log",
    "pi",
    "sin",
    "sqrt",
    "tan",
]
