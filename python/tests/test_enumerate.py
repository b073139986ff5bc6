import resource
import sys
import threading

import numpy as np
import pytest

import equilibria as eq
from models import from_sympy, rotating_chain, text


def same(a, b, tolerance=1e-10):
    """Whether two arrays of equilibria in two angles are the same, whatever their order."""
    apart = np.abs(np.angle(np.exp(1j * (a[:, None] - b[None])))).max(axis=-1)
    return a.shape == b.shape and apart.min(axis=0).max() < tolerance and apart.min(axis=1).max() < tolerance


def test_double_pendulum_has_12_equilibria():
    roots = rotating_chain().enumerate()
    assert len(roots) == len(roots.equilibria) == 12
    assert roots.clean and roots.morse_applies and roots.morse
    assert roots.residual.max() < 1e-12
    assert np.abs(roots.model.residual(roots.angles)).max() < 1e-12
    assert sum((-1) ** k * count for k, count in enumerate(roots.by_index)) == 0
    paths = roots.paths
    assert sum(paths[k] for k in ("finite", "at_infinity", "singular", "failed", "cancelled")) == paths["total"]
    assert roots.roots.dtype == complex and roots.roots.shape == (len(roots.roots), 2)
    assert roots.parameters == {"alpha": 0.33, "omega": 2.0, "r": 1.5}
    for e in roots.equilibria:
        eigenvalues = np.linalg.eigvalsh(roots.model.jacobian(e.q))
        assert e.index == (eigenvalues < 0).sum() and not e.degenerate
        assert e.energy == pytest.approx(roots.model.potential(e.q), abs=1e-13)


def test_parameters_by_keyword_and_by_name():
    model = rotating_chain()
    assert model.enumerate(omega=0.5).by_index.tolist() == [1, 2, 1]
    assert model.enumerate(at={"omega": 0.5}).angles.tobytes() == model.enumerate(omega=0.5).angles.tobytes()
    assert model.parameters["omega"] == 2.0
    there = model.enumerate(start=model.enumerate(omega=1.7))
    assert same(there.angles, model.enumerate().angles) and there.clean


def test_every_start_finds_the_same():
    model = rotating_chain()
    first = model.enumerate()
    for start in ("total_degree", "polyhedral"):
        assert same(model.enumerate(start=start).angles, first.angles)
    assert model.enumerate(threads=2).roots.tobytes() == first.roots.tobytes()


def test_proof_is_complete():
    roots = rotating_chain().enumerate()
    proof = roots.prove()
    assert proof.complete and proof.distinct == proof.bound == len(roots.roots)
    assert proof.real == len(roots)
    assert proof.real + proof.non_real + proof.undecided + proof.duplicates == len(roots.roots)
    assert proof.by_index.tolist() == roots.by_index.tolist()
    assert proof.contradictions == 0


def test_enumerate_proves_by_default():
    model = rotating_chain()
    roots = model.enumerate()
    assert roots.complete and roots.completeness == "complete" and roots.missing_at_most == 0
    assert roots.proof.distinct == len(roots.roots) and roots.prove() is roots.proof
    assert roots.verdict in str(roots)
    plain = model.enumerate(prove=False)
    assert plain.proof is None and not plain.complete and plain.completeness == "open"
    assert plain.angles.tobytes() == roots.angles.tobytes()
    there = model.enumerate(start=roots, omega=1.9)
    assert there.proof.distinct == len(there.roots)


def test_trace_file_and_sympy_give_the_same_roots():
    traced = rotating_chain().enumerate().angles
    parsed = eq.Model.parse(text).enumerate().angles
    by_sympy = from_sympy()[1].enumerate().angles
    assert len(traced) == 12 and same(traced, parsed, 1e-12) and same(traced, by_sympy, 1e-12)


def test_reads_a_file(tmp_path):
    path = tmp_path / "chain.json"
    path.write_text(text)
    assert len(eq.Model.read(path).enumerate()) == 12
    with pytest.raises(eq.InvalidArgument, match="nowhere.json"):
        eq.Model.read(tmp_path / "nowhere.json")


def test_two_threads_at_once_give_the_same_bytes():
    model, found = rotating_chain(), {}

    def run(k):
        found[k] = [model.enumerate(seed=7).roots.tobytes() for _ in range(10)]

    workers = [threading.Thread(target=run, args=(k,)) for k in range(2)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert set(found[0]) == set(found[1]) == {model.enumerate(seed=7).roots.tobytes()}


@pytest.mark.skipif(sys.platform == "win32", reason="no resource usage there")
def test_memory_does_not_grow():
    def run(times):
        for k in range(times):
            model = eq.Model(lambda t, p: -eq.cos(t[0]) - p.m * t[0].sin(), angles=1, parameters={"m": 0.3})
            roots = model.enumerate(m=0.1 + k % 7)
            assert len(roots.equilibria) == 2
            with pytest.raises(eq.InvalidArgument):
                model.enumerate(n=1)

    run(1000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    run(10000)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 3000  # kB


def test_equations_and_coordinates():
    # a mass on a spring and a pendulum on it: x, and the pendulum's angle
    model = eq.Model(
        lambda t, x, p: p.k * x[0] ** 2 / 2 - x.height * p.m - p.m * eq.cos(t.a),
        angles=["a"],
        coordinates=["height"],
        parameters={"k": 2.0, "m": 3.0},
    )
    roots = model.enumerate()
    assert np.allclose(roots.angles[:, 1], 1.5) and len(roots) == 2 and roots.index.tolist() == [0, 1]

    circle = eq.Model(lambda t, x, p: [x[0] ** 2 + x[1] ** 2 - p.c, x[0] - x[1]], coordinates=2, parameters={"c": 2.0})
    assert not circle.has_potential
    roots = circle.enumerate()
    assert np.allclose(np.sort(roots.angles[:, 0]), [-1, 1]) and np.isnan(roots.energy).all()
    assert np.allclose(circle.jacobian([1.0, 1.0]), [[2, 2], [1, -1]])
    assert np.isnan(circle.potential([1.0, 1.0]))


def test_values_of_many_points():
    model = rotating_chain()
    q = np.random.default_rng(1).uniform(-3, 3, (4, 5, 2))
    v, f, j = model.potential(q), model.residual(q), model.jacobian(q)
    assert v.shape == (4, 5) and f.shape == (4, 5, 2) and j.shape == (4, 5, 2, 2)
    h = 1e-5
    for k in range(2):
        e = h * np.eye(2)[k]
        assert np.allclose((model.potential(q + e) - model.potential(q - e)) / (2 * h), f[..., k], atol=1e-8)
        assert np.allclose((model.residual(q + e) - model.residual(q - e)) / (2 * h), j[..., k], atol=1e-8)


def test_prints():
    roots = rotating_chain().enumerate()
    assert "\n" not in repr(roots) and "12 equilibria" in repr(roots)
    assert "t1 (rad)" in str(roots) and len(str(roots).splitlines()) > 13
    assert roots._repr_html_().count("<tr>") == 13
    assert repr(roots.equilibria[0]).startswith("<Equilibrium: t1=")
    assert "complete" in repr(roots.prove())


def test_export():
    model = rotating_chain()
    for program in ("phcpack", "bertini", "homotopy_continuation", "macaulay2"):
        assert "c1" in model.export(program, omega=1.5)
    with pytest.raises(eq.InvalidArgument, match="program = maple"):
        model.export("maple")


def test_any_name_is_an_attribute():
    model = eq.Model(
        lambda t, p: -sum(np.cos(t)) * p.index - p.count * eq.sin(t.values),
        angles=["values"],
        parameters={"index": 2, "count": 3},
    )
    assert model.potential([0.5]) == pytest.approx(-2 * np.cos(0.5) - 3 * np.sin(0.5))
    assert len(model.enumerate()) == 2
