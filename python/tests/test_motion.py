"""Motions: energies, periods, the published motion of a mechanism, ways to write a model, and what is refused."""

import math
import os
import signal
import threading
import time

import numpy as np
import pytest

import equilibria as eq
from models import mechanism, rotating_chain


def pendulum(damping=0.0):
    return eq.Model(
        lambda t, p: -p.m * p.g * p.l * eq.cos(t[0]),
        angles=1,
        parameters={"m": 2.0, "g": 9.81, "l": 1.3, "b": damping},
        kinetic_energy=lambda t, v, p: p.m * p.l**2 * v[0] ** 2 / 2,
        dissipation=lambda t, v, p: p.b * v[0] ** 2 / 2,
    )


def elastic(**more):
    return eq.Model(
        lambda t, x, p: 0.5 * p.k * (x[0] - 1) ** 2 - x[0] * eq.cos(t[0]),
        angles=["t"],
        coordinates=["x"],
        parameters={"k": 3.0},
        **{"kinetic_energy": lambda t, x, v, p: 0.5 * (v[1] ** 2 + x[0] ** 2 * v[0] ** 2), **more},
    )


def complete_elliptic_integral(k):
    a, b = 1.0, math.sqrt(1 - k * k)
    while abs(a - b) > 1e-15:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return math.pi / 2 / a


@pytest.mark.parametrize("angle", [0.1, 1.0, 2.5, 3.0])
@pytest.mark.parametrize("formulation", ["lagrange", "hamilton"])
def test_period_of_a_pendulum(angle, formulation):
    period = 4 * math.sqrt(1.3 / 9.81) * complete_elliptic_integral(math.sin(angle / 2))
    motion = pendulum().motion([angle], times=[period / 4, period / 2, period], formulation=formulation)
    assert motion.finished and motion.q[:, 0] == pytest.approx([0, -angle, angle], abs=1e-9)


def test_energy_is_conserved_without_damping_and_balanced_with_it():
    free = elastic().motion({"t": 0.5, "x": 1.2}, rates={"x_rate": 0.1}, times=20)
    assert free.t.shape == (201,) and free.q.shape == free.v.shape == free.momentum.shape == (201, 2)
    assert free.q[0].tolist() == [0.5, 1.2] and free.v[0].tolist() == [0, 0.1]
    assert np.ptp(free.energy) < 1e-10 and free.largest_balance < 1e-10
    assert free.momentum[:, 0] == pytest.approx(free.q[:, 1] ** 2 * free.v[:, 0], abs=1e-14)
    damped = pendulum(0.7).motion([2.0], rates=[1.0], times=np.linspace(0, 20, 41))
    assert damped.finished and damped.largest_balance < 1e-10
    assert (np.diff(damped.energy) < 0).all() and damped.dissipated[-1] > 30
    assert np.abs(damped.energy + damped.dissipated - damped.energy[0]).max() < 1e-8
    model = damped.model
    assert damped.kinetic[5] == pytest.approx(model.kinetic_energy(damped.q[5], damped.v[5]), rel=1e-14)
    assert damped.potential[5] == pytest.approx(model.potential(damped.q[5]), rel=1e-14)


def test_published_motion_of_a_mechanism():
    model = mechanism()
    assert model.moves and model.rates == ["w1", "w2"]
    for formulation in ("lagrange", "hamilton"):
        motion = model.motion([4 * np.pi / 13, np.pi / 7], times=[1, 2, 10], formulation=formulation)
        expected = [
            [1.395008075400, 0.066900953195],
            [1.532278874235, -0.387246112382],
            [1.548212362758, 0.104114829458],
        ]
        assert np.abs(motion.q - expected).max() < 1e-10
        assert motion.largest_balance < 1e-10 and motion.work[-1] != 0


def test_poles_and_stability():
    model = mechanism()
    roots = model.enumerate(decay=0)
    stable = []
    for e in roots.equilibria:
        poles = model.poles(e.q, decay=0)
        assert poles.shape == (4,) and (poles.real > 0).sum() == e.index
        stable.append(model.stability(e.q, decay=0) == "stable")
    assert stable == roots.stable.tolist()
    swings = pendulum().poles([0.0])
    assert swings == pytest.approx(np.array([-1j, 1j]) * math.sqrt(9.81 / 1.3), abs=1e-12)
    assert pendulum().stability([0.0]) == "marginal" and pendulum().stability([np.pi]) == "unstable"


def test_the_same_motion_from_text_and_from_sympy():
    expected = elastic().motion([0.5, 1.2], times=10)
    text = eq.Model.parse(
        """{"angles": ["t"], "coordinates": ["x"], "parameters": {"k": 3},
        "potential": "0.5*k*(x - 1)^2 - x*cos(t)", "rates": ["w", "v"], "kinetic_energy": "0.5*(v^2 + x^2*w^2)"}"""
    )
    assert text.rates == ["w", "v"]
    assert np.abs(text.motion([0.5, 1.2], rates={"w": 0}, times=10).q - expected.q).max() < 1e-12
    sympy = pytest.importorskip("sympy")
    s, k = sympy.symbols("s k")
    t, x = sympy.Function("t")(s), sympy.Function("x")(s)
    v, energy = k * (x - 1) ** 2 / 2 - x * sympy.cos(t), (x.diff(s) ** 2 + x**2 * t.diff(s) ** 2) / 2
    given = dict(angles=[t], coordinates=[x], parameters={k: 3})
    model = eq.Model.from_sympy(v, kinetic_energy=energy, **given)
    assert model.rates == ["t_rate", "x_rate"]
    assert np.abs(model.motion([0.5, 1.2], times=10).q - expected.q).max() < 1e-11
    a, y, w, u, tau = sympy.symbols("a y w u tau")
    driven = eq.Model.from_sympy(
        k * (y - 1) ** 2 / 2 - y * sympy.cos(a),
        angles=[a],
        coordinates=[y],
        parameters={k: 3},
        kinetic_energy=(u**2 + y**2 * w**2) / 2,
        dissipation=u**2 / 20,
        generalised_forces=[0, sympy.cos(2 * tau)],
        rates=[w, u],
        time=tau,
    )
    traced = elastic(
        dissipation=lambda t, x, v, p: v[1] ** 2 / 20, generalised_forces=lambda s, t, x, v, p: [0, eq.cos(2 * s)]
    )
    other = traced.motion([0.5, 1.2], times=10)
    assert other.largest_balance < 1e-10 and abs(other.work[-1]) > 1e-3
    assert np.abs(driven.motion([0.5, 1.2], times=10).q - other.q).max() < 1e-11
    with pytest.raises(eq.InvalidArgument, match="must be a symbol for each unknown"):
        eq.Model.from_sympy(sympy.cos(a), angles=[a], kinetic_energy=w**2)
    with pytest.raises(eq.InvalidArgument, match="symbol = w"):
        eq.Model.from_sympy(w * sympy.cos(a), angles=[a], rates=[w], kinetic_energy=w**2)


def test_equilibria_of_a_model_that_moves_are_the_same_bytes():
    still = eq.Model(
        lambda t, x, p: 0.5 * p.k * (x[0] - 1) ** 2 - x[0] * eq.cos(t[0]),
        angles=["t"],
        coordinates=["x"],
        parameters={"k": 3.0},
    )
    assert not still.moves and still.rates == []
    assert elastic().enumerate().roots.tobytes() == still.enumerate().roots.tobytes()


def test_what_stops_a_motion_is_a_status():
    motion = elastic().motion([0.0, 0.0])
    assert motion.status == "the mass matrix is singular" and not motion.finished and len(motion) == 1
    few = elastic().motion([0.0, 1.2], times=[0.01, 1000], most_steps=200)
    assert few.status == "too many steps" and len(few) == 1 and few.time < 1000


def test_printed_and_drawn(tmp_path):
    motion = elastic().motion([0.5, 1.2])
    assert "201 points to t = 10, finished" in repr(motion)
    assert str(motion).count("\n") == 23 and "every 10th point" in str(motion)
    assert "<table>" in motion._repr_html_() and "x_rate" in motion._repr_html_()
    pytest.importorskip("matplotlib").use("Agg")
    drawn = [motion.plot(), motion.plot(unknown="x"), motion.plot(unknown=lambda q: q[:, 1]), motion.plot_energy()]
    for k, axes in enumerate(drawn):
        axes.figure.savefig(tmp_path / f"{k}.png")
        assert axes.get_xlabel() == "t"
    with pytest.raises(eq.InvalidArgument, match="unknown = 'y'"):
        motion.plot(unknown="y")


@pytest.mark.parametrize(
    "call, said",
    [
        (lambda m: m.motion([1.0]), "start = an array of shape"),
        (lambda m: m.motion("here"), "start = 'here': must be an array"),
        (lambda m: m.motion({"y": 1}), "start = y: must be t or x"),
        (lambda m: m.motion({"x": "much"}), "x = 'much': must be a number"),
        (lambda m: m.motion([0, math.nan]), "start: x = nan: must be finite"),
        (lambda m: m.motion([0, 1], rates={"x_rate": math.inf}), "rates: x_rate = inf: must be finite"),
        (lambda m: m.motion([0, 1], rates=[1]), "rates = an array of shape"),
        (lambda m: m.motion([0, 1], rates={"x": 1}), "rates = x: must be t_rate or x_rate"),
        (lambda m: m.motion([0, 1], times=0), "times = 0: must be positive"),
        (lambda m: m.motion([0, 1], times="soon"), "times = 'soon'"),
        (lambda m: m.motion([0, 1], times=[1, 0.5]), r"times\[1\] = 0.5"),
        (lambda m: m.motion([0, 1], times=[[1.0]]), "times = 2: must have one dimension"),
        (lambda m: m.motion([0, 1], formulation="newton"), "formulation = newton: must be lagrange or hamilton"),
        (lambda m: m.motion([0, 1], tolerance=2), "^tolerance = 2: must be from 1e-15 to 1"),
        (lambda m: m.motion([0, 1], most_steps=0), "most_steps = 0"),
        (lambda m: m.motion([0, 1], largest_step=-1), "largest_step = -1"),
        (lambda m: m.motion([0, 1], q=2), "parameter = q: must be k"),
        (lambda m: m.poles([0, 0]), "mass = "),
        (lambda m: rotating_chain().motion([0, 1]), "must have one: it does not move"),
        (lambda m: rotating_chain().poles([0, 1]), "must have one: it does not move"),
        (lambda m: elastic(kinetic_energy=lambda t, x, v, p: v[0]), "must be a quadratic form in the rates"),
        (lambda m: elastic(kinetic_energy=lambda t, x, v, p: v.y**2), "rate = y: must be t_rate or x_rate"),
        (lambda m: elastic(kinetic_energy=lambda t, x, v, p: v[0] ** 2 * t[0]), "an angle may enter"),
        (lambda m: elastic(kinetic_energy=lambda t, x, v, p: None), "must be an expression"),
        (lambda m: elastic(rates=["w"]), "number of rates = 1: must be one for each unknown: 2"),
        (lambda m: elastic(rates="wv"), "rates = 'wv': must be a list of names"),
        (lambda m: elastic(rates=["w", "x"]), "name = x: must not be used twice"),
        (lambda m: elastic(generalised_forces=lambda s, t, x, v, p: s), "generalised_forces = .*: must be a list"),
        (lambda m: elastic(generalised_forces=lambda s, t, x, v, p: [s]), "generalised_forces = 1: must be one for"),
        (lambda m: elastic(generalised_forces=lambda s, t, x, v, p: []), "generalised_forces = 0: must be one for"),
        (lambda m: elastic(kinetic_energy=None, dissipation=lambda: 0), "dissipation = without kinetic_energy"),
        (lambda m: elastic(kinetic_energy=None, rates=["w", "v"]), "rates = without kinetic_energy"),
        (lambda m: elastic(equations=True), "number of equations = 1"),
    ],
)
def test_refused(call, said):
    with pytest.raises(eq.InvalidArgument, match=said) as error:
        call(elastic())
    assert "\n" not in str(error.value)


def test_time_and_equations_are_refused():
    kept = []
    with pytest.raises(eq.InvalidArgument, match="dissipation = a formula of the time"):
        eq.Model(
            lambda t, p: eq.cos(t[0]),
            angles=1,
            kinetic_energy=lambda t, v, p: v[0] ** 2,
            generalised_forces=lambda s, t, v, p: kept.append(s) or [s],
            dissipation=lambda t, v, p: kept[0] * v[0] ** 2,
        )
    with pytest.raises(eq.InvalidArgument, match="must stand beside a potential"):
        eq.Model(lambda t, p: [eq.sin(t[0])], angles=1, kinetic_energy=lambda t, v, p: v[0] ** 2)


@pytest.mark.skipif(os.name != "posix", reason="sends itself a signal")
def test_interrupt_ends_a_motion():
    model, sent = pendulum(), []

    def send():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.3, send)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            model.motion([2.0], times=[1e5])
        assert time.monotonic() - sent[0] < 1
    finally:
        timer.cancel()


def test_progress_of_a_motion():
    told = []
    pendulum().motion([2.0], times=np.linspace(0, 200, 2001), progress=lambda done, all: told.append((done, all)))
    assert told and told[-1] == (2001, 2001)


def test_sweep_keeps_a_checkpoint(tmp_path):
    model = rotating_chain()
    values, kept = {"omega": np.linspace(0.5, 4, 30)}, tmp_path / "sweep.ckpt"
    whole = model.sweep(values)

    def stop(done, all):
        raise RuntimeError("enough")

    try:
        model.sweep(values, checkpoint=kept, progress=stop)
    except RuntimeError:
        pass
    again = model.sweep(values, checkpoint=str(kept), threads=2)
    assert kept.exists() and again.count.tolist() == whole.count.tolist()
    assert model.sweep(values, checkpoint=kept).distinct.tolist() == whole.distinct.tolist()
    with pytest.raises(eq.CheckpointError, match="sweep.ckpt"):
        model.sweep({"omega": np.linspace(0.5, 3, 30)}, checkpoint=kept)
