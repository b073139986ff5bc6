import numpy as np
import pytest

import equilibria as eq
from equilibria.continuation import critical_curve, follow


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


def test_folds_meet_in_a_cusp():
    # x^3 - r x = p has folds at 27 p^2 = 4 r^3
    def residual(q, p, r):
        return np.array([q[0] ** 3 - r * q[0] - p])

    def jacobian(q, p, r):
        return np.array([[3 * q[0] ** 2 - r]])

    branch = follow(lambda q, p: residual(q, p, 1.0), lambda q, p: jacobian(q, p, 1.0), [-2.0], -6.0, -6.0, 6.0)
    fold = branch.events[0]
    assert fold.kind == "fold" and abs(fold.left_null_vector[0]) == 1
    curve = critical_curve(residual, jacobian, fold, 1.0, -1.0, 2.0, direction=-1)
    assert 27 * curve.p**2 == pytest.approx(4 * curve.r**3, abs=1e-9)
    assert curve.q[:, 0] ** 2 == pytest.approx(curve.r / 3, abs=1e-9)
    assert [s.kind for s in curve.special] == ["cusp"]
    assert [curve.special[0].r, curve.special[0].p] == pytest.approx([0, 0], abs=1e-7)
    assert curve.end == "window" and curve.r[-1] == pytest.approx(2) and not curve.unexplained
    assert curve.p[0] * curve.p[-1] < 0 and (curve.gamma == 0).all() and "cusp" in str(curve)
    stops = critical_curve(residual, jacobian, fold, 1.0, 0.5, 100.0, p_high=2.0)
    assert stops.end == "window" and stops.p[-1] == pytest.approx(2, abs=1e-6)


@pytest.mark.parametrize("kind", ["dense", "sparse"])
def test_pitchforks_of_a_chain_whose_first_spring_changes(kind):
    n = 5
    k = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    first = np.zeros((n, n))
    first[0, 0] = 1.0

    def jacobian(q, p, r):
        y = k + r * first - p * np.diag(np.cos(q))
        return y if kind == "dense" else pytest.importorskip("scipy.sparse").csr_matrix(y)

    def residual(q, p, r):
        return (k + r * first) @ q - p * np.sin(q)

    start = follow(lambda q, p: residual(q, p, 0.0), lambda q, p: jacobian(q, p, 0.0), np.zeros(n), 0.0, -1.0, 1.0)
    curve = critical_curve(residual, jacobian, start.events[0], 0.0, 0.0, 10.0)
    assert curve.end == "window" and not curve.unexplained and not curve.special
    lowest = [np.linalg.eigvalsh(k + r * first)[0] for r in curve.r]
    assert curve.p == pytest.approx(lowest, abs=1e-9)
    assert np.abs(curve.gamma).max() < 1e-12 and np.abs(curve.q).max() < 1e-9


def test_a_bifurcation_that_only_some_members_have():
    # p x - x^2 + (r^2 - 1) / 4 bifurcates at r = -1 and r = 1 alone
    def residual(q, p, r):
        return np.array([p * q[0] - q[0] ** 2 + (r * r - 1) / 4])

    def jacobian(q, p, r):
        return np.array([[p - 2 * q[0]]])

    start = follow(lambda q, p: residual(q, p, -1.0), lambda q, p: jacobian(q, p, -1.0), [0.0], -1.0, -1.0, 1.0)
    assert [e.kind for e in start.events] == ["transcritical"]
    curve = critical_curve(residual, jacobian, start.events[0], -1.0, -1.5, 1.5)
    assert curve.gamma == pytest.approx((1 - curve.r**2) / 4, abs=1e-9)
    assert [s.kind for s in curve.special if s.r > 0] == ["transcritical"]
    assert curve.special[-1].r == pytest.approx(1, abs=1e-9)
    start.events[0].kind = "multiple"
    with pytest.raises(eq.InvalidArgument, match="point.kind = 'multiple'"):
        critical_curve(residual, jacobian, start.events[0], -1.0, -1.5, 1.5)


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
