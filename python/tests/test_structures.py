import json

import numpy as np
import pytest

import equilibria as eq
from equilibria.continuation import diagram

COLUMN = {
    "nodes": {"A": [0, 0, 0], "B": [0, 1, 0]},
    "sections": {"s": {"ea": "rigid", "ga": "rigid", "ei": 1, "mass": 1}},
    "elements": [{"type": "beam", "name": "column", "nodes": ["A", "B"], "section": "s", "order": "cubic"}],
    "supports": [{"node": "A", "fix": ["all"]}],
    "loads": [{"node": "B", "force": [0, -1, 0]}],
    "parameter": {"name": "P", "low": 0, "high": 10},
}


def test_a_column_and_its_diagram():
    column = eq.Structure(**COLUMN)
    assert column.nodes == {"A": 0, "B": 1} and column.window == (0, 10) and column.conservative
    (point,) = column.critical_points()
    assert point.kind == "pitchfork" and point.p == pytest.approx(np.pi**2 / 4, rel=1e-6)
    # G. Kirchhoff's elastica: P = P_c (1 + theta^2 / 8), theta the turn of the end
    assert point.curvature / abs(point.mode[1, 5]) ** 2 == pytest.approx(np.pi**2 / 16, rel=1e-3)
    assert (point.negative_before, point.negative_after, point.nullity) == (0, 1, 1)
    found = column.diagram()
    assert found.complete and found.not_switched == 0 and "complete" in repr(found)
    assert [node.kind for node in found.nodes] == ["pitchfork"]
    assert not found.verification["verified"] and found.verification["points"] == 0
    again = column.diagram(slices=3, checks=4).verification
    assert again["verified"] and again["points"] >= 12 and again["slices"] == 3, again["summary"]
    sides = [branch for branch in found.branches if branch.parent == 0]
    assert len(sides) == 2 and all(branch.stable.all() for branch in sides)
    assert sides[0].displacement("B")[-1, 0] == pytest.approx(-sides[1].displacement("B")[-1, 0], abs=1e-6)


def test_a_file_and_keys_are_the_same(tmp_path):
    path = tmp_path / "column.json"
    path.write_text(json.dumps(COLUMN))
    keys = dict(COLUMN, nodes={"A": np.zeros(3), "B": np.array([0, 1, 0])})
    a, b = eq.Structure(path).follow(), eq.Structure(**keys).follow()
    assert (a.p == b.p).all() and (a.position == b.position).all()
    assert a.p[0] == 0 and a.p[-1] == 10 and a.end == "window"
    with pytest.raises(eq.InvalidArgument, match="must be given, or keys of the format, and not both"):
        eq.Structure(path, **COLUMN)
    with pytest.raises(eq.InvalidArgument, match=r'elements\[0\].section = "t": must be the name of a section'):
        eq.Structure(**dict(COLUMN, elements=[{"type": "beam", "nodes": ["A", "B"], "section": "t"}]))
    with pytest.raises(eq.InvalidArgument, match="node = 'C': must be one of A, B"):
        eq.Structure(path).follow().displacement("C")


def test_reactions_balance_the_loads_on_every_branch():
    loads = [{"type": "self_weight", "gravity": [0, -1, 0], "kind": "constant"}] + COLUMN["loads"]
    column = eq.Structure(**dict(COLUMN, loads=loads))
    assert column.loaded["share"] == 1 and column.loaded["passed"] == []
    for branch in column.diagram(high=5).branches:
        for k in (0, len(branch) // 2, -1):
            results = branch.results(k)
            assert results["reactions"]["A"]["force"] == pytest.approx([0, 1 + branch.p[k], 0], abs=1e-8)
            assert results["nodes"]["B"]["displacement"] == pytest.approx(branch.displacement("B")[k])
            assert len(results["elements"]) == 24 and results["elements"][0]["element"] == "column"
    assert column.critical_points()[0].results()["reactions"]["A"]["moment"] == pytest.approx([0, 0, 0], abs=1e-9)


def test_constant_loads_that_are_not_carried():
    toggle = eq.Structure(
        nodes={"A": [-1, 0, 0], "B": [0, 0.1, 0], "C": [1, 0, 0]},
        elements=[{"type": "truss", "nodes": pair, "ea": 1, "planar": True} for pair in (["A", "B"], ["B", "C"])],
        supports=[{"node": "A", "fix": ["position"]}, {"node": "C", "fix": ["position"]}],
        loads=[{"node": "B", "force": [0, 1, 0]}],
        parameter={"low": -1e-3, "high": 1e-3, "direction": "down"},
    )
    folds = toggle.critical_points()
    limit = 2 * 0.1**3 / (3 * 3**0.5 * 1.01**1.5)
    assert [f.kind for f in folds] == ["fold", "fold"]
    assert [f.p for f in folds] == pytest.approx([-limit, limit], rel=1e-9)


def test_follower_loads_say_no_stability():
    column = eq.Structure(**dict(COLUMN, nodes={"A": [0, 0, 0], "B": [0, 1, 0]}))
    assert column.follow().stable is not None
    space = {"ea": 1e4, "ga2": 1e4, "ga3": 1e4, "gj": 1, "ei2": 1, "ei3": 2}
    beck = eq.Structure(
        **dict(
            COLUMN,
            sections={"s": space},
            elements=[{"type": "beam", "nodes": ["A", "B"], "section": "s"}],
            loads=[{"type": "follower", "node": "B", "force": [0, -1, 0]}],
        )
    )
    assert not beck.conservative and beck.follow().stable is None


def test_pictures():
    plt = pytest.importorskip("matplotlib.pyplot")
    plt.switch_backend("Agg")
    column = eq.Structure(**COLUMN)
    found = column.diagram()
    ax = found.plot()
    assert ax.get_ylabel() == "P" and ax.get_xlabel().startswith("displacement") and "of B" in ax.get_xlabel()
    assert len(column.plot(found.branches[0].position[-1]).lines) == 8
    plt.close("all")


def test_a_diagram_of_ones_own_problem():
    # x (p - x^2) and a circle that nothing joins: x^2 + (p - 3)^2 = 1/4
    def residual(q, p):
        x = q[0]
        return np.array([x * (p - x**2) * (x**2 + (p - 3) ** 2 - 0.25) - 0.0])

    def jacobian(q, p):
        x = q[0]
        return np.array([[(p - 3 * x**2) * (x**2 + (p - 3) ** 2 - 0.25) + x * (p - x**2) * 2 * x]])

    found = diagram(residual, jacobian, [0.0], -1.0, -2.0, 2.0)
    assert found.complete and [(n.kind, round(n.p, 9)) for n in found.nodes] == [("pitchfork", 0.0)]
    assert len(found.branches) == 4 and [b.parent for b in found.branches] == [None, None, 0, 0]
    for branch in found.branches[2:]:
        assert branch.q[-1, 0] ** 2 == pytest.approx(branch.p[-1], abs=1e-8)


def test_a_round_column_has_a_circle_of_branches():
    section = {"ea": "rigid", "ga2": "rigid", "ga3": "rigid", "gj": 0.8, "ei2": 1, "ei3": 1}
    changes = {
        "nodes": {"A": [0, 0, 0], "B": [0, 0, 1]},
        "sections": {"s": section},
        "loads": [{"node": "B", "force": [0, 0, -1]}],
        "parameter": {"low": 0, "high": 5},
    }
    column = eq.Structure(**{**COLUMN, **changes})
    found = column.diagram()
    assert found.circles == [0] and found.nodes[0].nullity == 2 and len(found.branches) == 2
    assert found.nodes[0].p == pytest.approx(np.pi**2 / 4, rel=1e-6)
    assert not found.complete and "1 circles of branches not followed" in repr(found)
