"""The example of docs/python.md runs, is short, and is right."""

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
