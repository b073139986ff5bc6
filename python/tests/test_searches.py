import numpy as np
import pytest

import equilibria as eq
from models import rotating_chain


def test_events_of_the_pendulum():
    # a bead on a rotating hoop: the pitchfork at omega = 1, and no other event
    model = eq.Model(
        lambda t, p: -eq.cos(t[0]) - p.omega**2 * eq.sin(t[0]) ** 2 / 2, angles=1, parameters={"omega": 0.0}
    )
    found = model.events("omega", (0.1, 3))
    assert found.complete and [e.kind for e in found.events] == ["pitchfork"]
    assert found.values == pytest.approx([1], abs=1e-12)
    assert [i.count for i in found.intervals] == [2, 4]
    assert "pitchfork" in str(found)


def test_events_diagram_and_sweep_agree():
    model = rotating_chain()
    events = model.events("omega", (0.1, 3))
    assert events.complete
    diagram = model.diagram("omega", (0.1, 3))
    assert [e.value for e in diagram.events] == pytest.approx(events.values)
    for interval in events.intervals:
        there = [p for p in diagram.pieces if p.parameter[0] <= interval.at <= p.parameter[-1]]
        assert sorted(p.index for p in there) == sorted(np.repeat([0, 1, 2], interval.by_index))
    for piece in diagram.pieces:
        middle = len(piece.parameter) // 2
        assert np.abs(model.residual(piece.q[middle], omega=piece.parameter[middle])).max() < 1e-9
        assert (np.diff(piece.parameter) >= 0).all()
    sweep = model.sweep({"omega": [i.at for i in events.intervals]})
    assert sweep.count.tolist() == [i.count for i in events.intervals]
    assert sweep.by_index.tolist() == [i.by_index.tolist() for i in events.intervals]


def test_sweep_of_a_grid_and_of_points():
    model = rotating_chain()
    alpha, omega = np.linspace(0.1, 0.9, 3), np.linspace(0.5, 4, 4)
    grid = model.sweep({"alpha": alpha, "omega": omega}, prove=True)
    assert grid.count.shape == (3, 4) and grid.by_index.shape == (3, 4, 3) and grid.clean.all()
    assert grid.count[2, 1] == len(model.enumerate(alpha=alpha[2], omega=omega[1]))
    assert (grid.proved == grid.distinct).all()
    points = model.sweep({"alpha": 0.5, "omega": omega}, grid=False)
    assert points.count.tolist() == grid.count[1].tolist()


def test_locus():
    locus = rotating_chain().locus(x=("alpha", 0.1, 0.9), y=("omega", 0.2, 3), lines=4, checks=6)
    assert locus.complete, locus.argument
    assert {curve.kind for curve in locus.curves} == {"fold", "pitchfork"}
    assert len(locus.regions) > 3 and all(region.clean and region.confirmed for region in locus.regions)
    assert sum(region.area for region in locus.regions) == pytest.approx(0.8 * 2.8, rel=1e-3)
    for region in locus.regions:
        x, y = region.point
        assert len(locus.model.enumerate(alpha=x, omega=y)) == region.count
    for curve in locus.curves:
        k = len(curve.points) // 2
        at = dict(zip(("alpha", "omega"), curve.points[k]))
        assert np.abs(locus.model.residual(curve.q[k], at)).max() < 1e-9
        assert abs(np.linalg.det(locus.model.jacobian(curve.q[k], at))) < 1e-7
    assert locus.borders.shape[1] == 3


def test_progress_is_told_and_may_stop_a_call():
    model = eq.Model(
        lambda t, p: -sum(eq.cos(a) for a in t)
        - p.c * eq.cos(t[0] + t[1] + t[2] + t[3] + t[4]) ** 2
        - 0.3 * eq.sin(t[0] - t[1]) * eq.cos(t[2]),
        angles=5,
        parameters={"c": 0.4},
    )
    told = []

    def progress(done, all):
        told.append((done, all))
        if len(told) == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        model.enumerate(progress=progress, start="total_degree")
    assert len(told) == 3


def test_plots(tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    model = rotating_chain()
    for k, drawn in enumerate(
        [
            model.enumerate().plot(),
            model.diagram("omega", (0.1, 3)).plot(unknown="t2"),
            model.locus(x=("alpha", 0.1, 0.9), y=("omega", 0.2, 3), lines=4, checks=0).plot(),
        ]
    ):
        drawn.figure.savefig(tmp_path / f"{k}.png")
        assert drawn.get_xlabel() and drawn.get_ylabel() and drawn.get_legend()
