"""Pictures of results, by matplotlib, which is imported where one is asked for."""

from __future__ import annotations

import math
from typing import Any, Callable, Union

import numpy as np

from .results import Diagram, Locus, Motion, Reals, RootSet
from .structure import Structure, StructureDiagram

colours = {"fold": "#c0392b", "pitchfork": "#2456a6"}
markers = {"fold": "o", "pitchfork": "D", "transcritical": "X", "cusp": "^"}


def _axes(ax: Any) -> Any:
    import matplotlib.pyplot as plt

    return plt.subplots(layout="constrained")[1] if ax is None else ax


def _legend(ax: Any) -> None:
    """Above the axes, where it covers nothing."""
    if ax.get_legend_handles_labels()[1]:
        ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4, frameon=False, fontsize="small")


def _label(model: Any, number: int) -> str:
    name = str(model.unknowns[number])
    return f"{name} (rad)" if number < len(model.angles) else name


def _angle_axis(axis: Any) -> None:
    axis.set_major_locator(_multiples_of_half_pi())
    axis.set_major_formatter(lambda value, _: _fraction_of_pi(value))


def _multiples_of_half_pi() -> Any:
    from matplotlib.ticker import MultipleLocator

    return MultipleLocator(np.pi / 2)


def _fraction_of_pi(value: float) -> str:
    halves = round(2 * value / math.pi)
    names = {-2: "-π", -1: "-π/2", 0: "0", 1: "π/2", 2: "π"}
    return str(names.get(halves, f"{halves / 2:g}π"))


def _broken(values: Reals, parameter: Reals) -> Any:
    """An angle in (-pi, pi], its line broken where it goes once around."""
    values = np.pi - np.mod(np.pi - values, 2 * np.pi)
    jumps = np.flatnonzero(np.abs(np.diff(values)) > np.pi) + 1
    return np.insert(parameter, jumps, np.nan), np.insert(values, jumps, np.nan)


def plot_locus(locus: Locus, ax: Any = None) -> Any:
    from matplotlib import colormaps
    from matplotlib.collections import PolyCollection

    ax = _axes(ax)
    counts = sorted({region.count for region in locus.regions})
    shade = colormaps["YlGnBu"]
    for region in locus.regions:
        colour = shade(0.05 + 0.4 * counts.index(region.count) / max(1, len(counts) - 1))
        ax.add_collection(
            PolyCollection(region.polygons, facecolors=[colour], edgecolors=[colour], linewidths=0.3, zorder=0)
        )
    named = set()
    for curve in locus.curves:
        label = None if curve.kind in named else f"{curve.kind}s"
        named.add(curve.kind)
        ax.plot(*curve.points.T, color=colours.get(curve.kind, "k"), linewidth=1.4, label=label, zorder=2)
    for number, points in enumerate(locus.from_infinity):
        label = "from infinity" if number == 0 else None
        ax.plot(*points.T, color="0.4", linewidth=1.4, linestyle="--", label=label, zorder=2)
    if locus.cusps:
        ax.plot(
            *np.array([cusp.point for cusp in locus.cusps]).T,
            linestyle="none",
            marker="^",
            markersize=5,
            markerfacecolor="k",
            markeredgecolor="w",
            label="cusps",
            zorder=4,
        )
    (low_x, high_x), (low_y, high_y) = locus.window
    room = (high_x - low_x) * (high_y - low_y)
    for region in locus.regions:
        if region.area > 2e-4 * room:  # what a label would cover has none
            ax.text(*region.point, str(region.count), ha="center", va="center", fontsize=8, zorder=5)
    ax.set_xlim(low_x, high_x)
    ax.set_ylim(low_y, high_y)
    ax.set_xlabel(locus.axes[0])
    ax.set_ylabel(locus.axes[1])
    _legend(ax)
    return ax


def plot_diagram(diagram: Diagram, ax: Any = None, unknown: Union[int, str, Callable[..., Any]] = 0) -> Any:
    model = diagram.model
    ax = _axes(ax)
    if callable(unknown):
        of, is_angle, label = unknown, False, ""
    else:
        number = _number_of(model, unknown)
        is_angle, label = number < len(model.angles), _label(model, number)

        def of(q: Reals) -> Any:
            return q[:, number]

    named = set()
    for piece in diagram.pieces:
        x, y = piece.parameter, np.asarray(of(piece.q))
        if is_angle:
            x, y = _broken(y, x)
        name = "stable" if piece.stable else "unstable"
        ax.plot(
            x,
            y,
            color="k" if piece.stable else "0.45",
            linestyle="-" if piece.stable else "--",
            linewidth=1.5 if piece.stable else 0.9,
            solid_capstyle="round",
            label=None if name in named else name,
        )
        named.add(name)
    for event in diagram.events:
        y = np.asarray(of(event.q[None, :]))[0]
        ax.plot(
            event.value,
            y,
            linestyle="none",
            marker=markers.get(event.kind, "s"),
            markersize=4.5,
            color=colours.get(event.kind, "#7d3c98"),
            label=None if event.kind in named else event.kind,
            zorder=3,
        )
        named.add(event.kind)
    ax.set_xlim(*diagram.range)
    ax.set_xlabel(diagram.parameter)
    ax.set_ylabel(label)
    if is_angle:
        ax.set_ylim(-1.05 * np.pi, 1.05 * np.pi)
        _angle_axis(ax.yaxis)
    _legend(ax)
    return ax


def _number_of(model: Any, unknown: Union[int, str]) -> int:
    from ._core import InvalidArgument

    if isinstance(unknown, str) and unknown not in model.unknowns:
        raise InvalidArgument(f"unknown = {unknown!r}: must be one of {', '.join(model.unknowns)}")
    number = model.unknowns.index(unknown) if isinstance(unknown, str) else int(unknown)
    if not 0 <= number < len(model.unknowns):
        raise InvalidArgument(f"unknown = {number}: must be 0 to {len(model.unknowns) - 1}")
    return number


def plot_motion(motion: Motion, ax: Any = None, unknown: Union[None, int, str, Callable[..., Any]] = None) -> Any:
    model = motion.model
    ax = _axes(ax)
    if callable(unknown):
        ax.plot(motion.t, np.asarray(unknown(motion.q)), linewidth=1.5)
    else:
        numbers = range(len(model.unknowns)) if unknown is None else [_number_of(model, unknown)]
        for number in numbers:
            ax.plot(motion.t, motion.q[:, number], linewidth=1.5, label=_label(model, number))
        if len(numbers) == 1:
            ax.set_ylabel(_label(model, numbers[0]))
        else:
            _legend(ax)
    ax.set_xlabel("t")
    return ax


def plot_energies(motion: Motion, ax: Any = None) -> Any:
    ax = _axes(ax)
    ax.plot(motion.t, motion.kinetic, color="#d55e00", linewidth=1.5, label="kinetic")
    ax.plot(motion.t, motion.potential, color="#009e73", linewidth=1.5, label="potential")
    ax.plot(motion.t, motion.energy, color="k", linewidth=1.5, label="sum")
    ax.set_xlabel("t")
    ax.set_ylabel("energy")
    _legend(ax)
    return ax


def plot_roots(roots: RootSet, ax: Any = None) -> Any:
    model = roots.model
    ax = _axes(ax)
    one = len(model.unknowns) == 1
    x, y = roots.angles[:, 0], roots.energy if one else roots.angles[:, 1]
    if model.has_potential and len(model.angles) == len(model.unknowns) <= 2:
        grid = np.linspace(-np.pi, np.pi, 241)
        if one:
            ax.plot(grid, model.potential(grid[:, None], roots.parameters), color="0.6", linewidth=1, zorder=0)
        else:
            t1, t2 = np.meshgrid(grid, grid)
            v = model.potential(np.stack([t1, t2], axis=-1), roots.parameters)
            ax.contour(t1, t2, v, levels=24, colors="0.75", linewidths=0.6, linestyles="solid", zorder=0)
    for index in np.unique(roots.index):
        colour = f"C{int(index)}"
        for degenerate in (False, True):
            some = (roots.index == index) & (roots.degenerate == degenerate)
            if some.any():
                ax.plot(
                    x[some],
                    y[some],
                    linestyle="none",
                    marker="s" if degenerate else "o",
                    markersize=7,
                    markeredgecolor=colour,
                    markeredgewidth=1.5,
                    markerfacecolor=colour if index == 0 and not degenerate else "w",
                    label=f"index {index}" + (", degenerate" if degenerate else ", stable" if index == 0 else ""),
                )
    ax.set_xlabel(_label(model, 0))
    ax.set_ylabel("energy" if one else _label(model, 1))
    angles = len(model.angles)
    if angles > 0:
        ax.set_xlim(-1.05 * np.pi, 1.05 * np.pi)
        _angle_axis(ax.xaxis)
    if angles > 1:
        ax.set_ylim(-1.05 * np.pi, 1.05 * np.pi)
        _angle_axis(ax.yaxis)
    _legend(ax)
    return ax


def plot_structure(diagram: StructureDiagram, ax: Any = None, node: Any = None, component: int = -1) -> Any:
    structure = diagram.structure
    ax = _axes(ax)
    k = structure.node(structure._core.measured if node is None else node)
    moved = [branch.displacement(k) for branch in diagram.branches]
    if component == -1:
        component = int(np.argmax(np.ptp(np.concatenate(moved), axis=0))) if moved else 0
    named = set()
    for branch, at in zip(diagram.branches, moved):
        # the critical point that it leaves, its points and critical points; how stable the way to each is
        stable = branch.stable
        x, p, holds = [], [], []
        if branch.parent is not None:
            point = diagram.nodes[branch.parent]
            x.append((point.position[k] - structure.drawn[k])[component])
            p.append(point.p)
            holds.append(None)
        for number in range(len(branch)):
            x.append(at[number, component])
            p.append(branch.p[number])
            holds.append(None if stable is None else bool(stable[number]))
            for event in branch.events:
                if event.step == number:
                    x.append((event.position[k] - structure.drawn[k])[component])
                    p.append(event.p)
                    holds.append(None if event.negative_before is None else event.negative_before == 0)
        changes = [i for i in range(1, len(x) - 1) if holds[i + 1] != holds[i]]
        for first, last in zip([0] + changes, changes + [len(x) - 1]):
            kind = holds[last]
            name = "stability not known" if kind is None else "stable" if kind else "unstable"
            ax.plot(
                x[first : last + 1],
                p[first : last + 1],
                color="k" if kind else "0.45",
                linestyle="-" if kind is not False else "--",
                linewidth=1.5 if kind else 0.9,
                label=None if name in named else name,
            )
            named.add(name)
    for point in diagram.nodes:
        ax.plot(
            (point.position[k] - structure.drawn[k])[component],
            point.p,
            linestyle="none",
            marker=markers.get(point.kind, "s"),
            markersize=4.5,
            color=colours.get(point.kind, "#7d3c98"),
            label=None if point.kind in named else point.kind,
            zorder=3,
        )
        named.add(point.kind)
    names = {number: name for name, number in structure.nodes.items()}
    ax.set_xlabel(f"displacement {'xyz'[component]} of {names.get(k, f'node {k}')}")
    ax.set_ylabel(structure.parameter)
    _legend(ax)
    return ax


def plot_shape(structure: Structure, position: Reals, ax: Any, style: Any) -> Any:
    flat = bool(np.ptp(structure.drawn[:, 2]) == 0 and np.abs(position[:, 2] - structure.drawn[0, 2]).max() < 1e-9)
    if ax is None and not flat:
        import matplotlib.pyplot as plt

        ax = plt.figure().add_subplot(projection="3d")
    ax = _axes(ax)
    style = {"color": "k", "linewidth": 1.0, **style}
    for line in structure.lines:
        ax.plot(*position[line].T[: 2 if flat else 3], **style)
    if flat:
        ax.set_aspect("equal")
    return ax
