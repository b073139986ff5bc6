"""Ctrl-C while the library computes."""

import os
import signal
import threading
import time

import pytest

import equilibria as eq

pytestmark = pytest.mark.skipif(os.name != "posix", reason="sends itself a signal")


def row(n):
    """Pendulums in a row, coupled by springs, as torsion springs' potentials in cosines."""
    return eq.Model(
        lambda t, p: -p.g * sum(eq.cos(a) for a in t) - p.k * sum(eq.cos(a - b) for a, b in zip(t, t[1:])),
        angles=n,
        parameters={"k": 0.4, "g": 1.0},
    )


def interrupted_after(seconds, call):
    """How long a call went on after Ctrl-C."""
    sent = []

    def send():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, send)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            call()
        return time.monotonic() - sent[0]
    finally:
        timer.cancel()


def test_enumerate():
    model = row(8)
    assert interrupted_after(0.3, lambda: model.enumerate(start="total_degree")) < 1
    assert len(row(2).enumerate()) == 4  # the interpreter and the library go on


def test_sweep():
    model = row(3)
    values = [0.1 + 0.8 * k / 20000 for k in range(20000)]
    assert interrupted_after(0.3, lambda: model.sweep({"k": values})) < 1


def test_search():
    model = row(4)
    assert interrupted_after(0.3, lambda: model.locus(("k", -5, 5), ("g", -5, 5))) < 5


def test_other_python_threads_run_meanwhile():
    model, counted, ended = row(6), [0], threading.Event()

    def count():
        while not ended.is_set():
            counted[0] += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    begin = time.monotonic()
    model.enumerate(start="total_degree")
    seconds = time.monotonic() - begin
    ended.set()
    other.join()
    assert counted[0] > 100 * min(seconds, 10)


def test_a_limit_ends_calls():
    model = row(8)
    begin = time.monotonic()
    roots = model.enumerate(start="total_degree", limit=0.3)
    assert time.monotonic() - begin < 2
    assert roots.completeness == "open"
    assert roots.paths["cancelled"] > 0
    with pytest.raises(TimeoutError, match="limit = 0.3: the call has not ended"):
        row(4).locus(("k", -5, 5), ("g", -5, 5), limit=0.3)
    values = [0.1 + 0.8 * k / 20000 for k in range(20000)]
    with pytest.raises(TimeoutError):
        row(3).sweep({"k": values}, limit=0.3)
    assert len(row(2).enumerate(limit=60)) == 4
    for wrong in (0, -1, "soon", float("nan")):
        with pytest.raises(eq.InvalidArgument, match="limit"):
            row(2).enumerate(limit=wrong)
