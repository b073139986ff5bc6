"""The examples of docs/python.md and docs/structures.md run, are short, and are right."""

import re
from pathlib import Path

import pytest

page = Path(__file__).resolve().parents[2] / "docs" / "python.md"


def test_example(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib").use("Agg")
    code = re.search(r"<!-- example -->\n```python\n(.*?)```", page.read_text(), re.S).group(1)
    assert sum(bool(line.strip()) for line in code.splitlines()) <= 20
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(compile(code, str(page), "exec"), names)
    assert len(names["roots"]) == 12 and "12 equilibria" in capsys.readouterr().out
    locus = names["locus"]
    assert locus.complete and sorted({r.count for r in locus.regions}) == [4, 6, 8, 10, 12, 16]
    # Baillieul's cusp of Figure 3.2
    assert min(abs(c.point[0] - 0.32989618) + abs(c.point[1] - 1.9379135) for c in locus.cusps) < 1e-7
    assert (tmp_path / "figure_3_2.png").stat().st_size > 10000


def test_example_of_a_motion(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib").use("Agg")
    code = re.search(r"<!-- motion -->\n```python\n(.*?)```", page.read_text(), re.S).group(1)
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(compile(code, str(page), "exec"), names)
    assert names["motion"].finished and names["motion"].largest_balance < 1e-10
    assert "['marginal', 'unstable']" in capsys.readouterr().out
    assert (tmp_path / "motion.png").stat().st_size > 10000


def test_example_of_a_curve(capsys):
    code = re.search(r"<!-- curve -->\n```python\n(.*?)```", page.read_text(), re.S).group(1)
    names = {}
    exec(compile(code, str(page), "exec"), names)
    curve = names["curve"]
    assert curve.end == "window" and curve.r[-1] == pytest.approx(2)
    assert curve.p == pytest.approx(4 * curve.r**3 / 27**0.5, rel=1e-8)
    assert capsys.readouterr().out.startswith("2.0 6.158402")


def test_example_of_a_structure(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib").use("Agg")
    text = page.with_name("structures.md").read_text()
    (tmp_path / "portal.json").write_text(re.search(r"<!-- portal.json -->\n```json\n(.*?)```", text, re.S).group(1))
    code = re.search(r"<!-- structures -->\n```python\n(.*?)```", text, re.S).group(1)
    monkeypatch.chdir(tmp_path)
    names = {}
    exec(compile(code, "structures.md", "exec"), names)
    assert names["diagram"].complete and names["frame"].loaded["passed"] == []
    # the loads that the page's table has
    table = [float(p) for p in re.findall(r"^(?:pitchfork|fold) +([0-9.]+)", text, re.M)]
    assert sorted(node.p for node in names["diagram"].nodes) == pytest.approx(sorted(table), rel=1e-8)
    # half of the constant loads on each support
    weight = 9.81 * (31 * 8 + 42 * 6) + 5000 * 6
    assert names["main"].results(0)["reactions"]["A"]["force"][1] == pytest.approx(weight / 2, rel=1e-6)
    assert "pitchfork at P (kN) = 668.947467" in capsys.readouterr().out
    assert (tmp_path / "diagram.png").stat().st_size > 5000 and (tmp_path / "shapes.png").stat().st_size > 3000
