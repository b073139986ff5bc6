import numpy as np
import pytest

import equilibria as eq
from equilibria.continuation import follow


def test_fold_of_the_shallow_arch():
    # a truss of two bars of rise 1 over half span 1: p = 2 h (1 - h) (2 - h) for the drop h
    def residual(q, p):
        return np.array([2 * q[0] * (1 - q[0]) * (2 - q[0]) - p])

    def jacobian(q, p):
        h = q[0]
        return np.array([[2 * (2 - 6 * h + 3 * h**2)]])

    branch = follow(residual, jacobian, [0.0], 0.0, -2.0, 4.0)
    folds = [e for e in branch.events if e.kind == "fold"]
    assert [e.p for e in folds] == pytest.approx([4 / (3 * 3**0.5), -4 / (3 * 3**0.5)], abs=1e-10)
    assert [e.q[0] for e in folds] == pytest.approx([1 - 3**-0.5, 1 + 3**-0.5], abs=1e-8)
    assert branch.stable[0] and not branch.stable.all() and branch.stable[-1]
    assert branch.end == "window" and branch.residual.max() < 1e-9


@pytest.mark.parametrize("kind", ["dense", "sparse"])
def test_buckling_of_a_chain(kind):
    # rigid links on rotational springs under an axial load, whose straight state is lost at pitchforks
    n = 6
    k = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)

    def residual(q, p):
        return k @ q - p * np.sin(q)

    def jacobian(q, p):
        y = k - p * np.diag(np.cos(q))
        if kind == "dense":
            return y
        return pytest.importorskip("scipy.sparse").csr_matrix(y)

    branch = follow(residual, jacobian, np.zeros(n), 0.0, -1.0, 1.0, parameter_derivative=lambda q, p: -np.sin(q))
    critical = np.linalg.eigvalsh(k)
    critical = critical[critical < 1]
    assert [e.kind for e in branch.events] == ["pitchfork"] * len(critical)
    assert [e.p for e in branch.events] == pytest.approx(critical, abs=1e-10)
    assert branch.negative.tolist() == [(np.linalg.eigvalsh(k) < p).sum() for p in branch.p]
    assert branch.q.shape == (len(branch), n) and "pitchfork" in str(branch)


def test_without_symmetry():
    branch = follow(
        lambda q, p: np.array([q[0] ** 2 + q[1] - p, 2 * q[0] - q[1]]),
        lambda q, p: np.array([[2 * q[0], 1.0], [2.0, -1.0]]),
        [0.0, 0.0],
        0.0,
        -3.0,
        3.0,
        symmetric=False,
        direction=-1,
    )
    assert branch.stable is None
    assert [(e.kind, e.p) for e in branch.events] == [("fold", pytest.approx(-1, abs=1e-10))]


def test_errors():
    good = dict(residual=lambda q, p: q - p, jacobian=lambda q, p: np.eye(1), q0=[0.0], p0=0.0, low=-1.0, high=1.0)
    assert len(follow(**good)) > 1
    for change, said in [
        (dict(jacobian=lambda q, p: 2 * np.eye(1)), "tangent"),
        (dict(jacobian=lambda q, p: np.eye(2)), "1 x 1"),
        (dict(residual=lambda q, p: np.zeros(2)), "vector of 1"),
        (dict(p0=3.0), "p0 = 3.0"),
        (dict(q0=[np.nan]), "q0"),
        (dict(direction=0), "direction = 0"),
        (dict(first_step=-1.0), "first_step"),
    ]:
        with pytest.raises(eq.InvalidArgument, match=said):
            follow(**{**good, **change})

    def broken(q, p):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        follow(**{**good, "residual": broken})
