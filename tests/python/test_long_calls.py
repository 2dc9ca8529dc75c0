"""Long calls let other threads run, end at Ctrl-C, and leak nothing."""

import os
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pendula
import pytest
from doubles import same_bits

MANY = np.linspace(0.1, 3, 2_000_000)
LONG_CALLS = {
    "analyze": lambda: pendula.analyze(MANY, 0.1),
    "exact": lambda: pendula.exact(MANY, 0.1, 1.0),
    "rk4, one pendulum": lambda: pendula.solve(1.0, 0.0, dt=1e-6, every=1e3, until=1e3),
    "rk4": lambda: pendula.solve(MANY[:1000], 0.0, dt=1e-5, every=1e3, until=1e3, threads=2),
    "taylor, one pendulum": lambda: pendula.solve(1.0, 0.0, every=1e9, until=1e9, method="taylor"),
    "verlet": lambda: pendula.solve(MANY[:1000], 0.0, dt=1e-5, every=1e3, until=1e3, method="verlet"),
    "euler, one pendulum": lambda: pendula.solve(1.0, 0.0, dt=1e-6, every=1e3, until=1e3, method="euler"),
    "crossings": lambda: pendula.crossings(MANY[:1000], 0.0, of="omega", at=5.0, until=1e9, threads=2),
    "measured_period": lambda: pendula.measured_period(1.0, 0.0, until=1e9),
    "attractors": lambda: pendula.measure.attractors(MANY[:1000], 0.0, periods=10**6),
    "lyapunov by taylor": lambda: pendula.measure.lyapunov(MANY[:1000], 0.0, periods=10**6, method="taylor"),
    "measure": lambda: pendula.measure.mean_velocity(MANY[:1000], 0.0, periods=10**6),
}


@pytest.mark.parametrize("call", LONG_CALLS.values(), ids=LONG_CALLS.keys())
def test_ctrl_c_ends_a_long_call_within_a_second(call):
    pressed = []

    def press():
        pressed.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.3, press)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        call()
        timer.join()
    assert time.monotonic() - pressed[0] < 1


def test_other_threads_run_during_a_long_call():
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(time.monotonic())

    ticking = threading.Thread(target=tick)
    ticking.start()
    start = time.monotonic()
    pendula.solve(1.0, 0.0, dt=1e-6, every=3, until=3)
    end = time.monotonic()
    done.set()
    ticking.join()
    assert sum(start < moment < end for moment in ticks) >= 5


def test_threads_calling_at_once_get_what_each_gets_alone():
    starts = np.linspace(0.1, 3, 64)
    times = np.linspace(0, 50, 1000)

    def work(theta0):
        orbit = pendula.exact(theta0, 0.5, times)
        steps = pendula.solve(theta0, [0.5, 2.5], dt=0.01, every=1, until=20, threads=2)
        return np.concatenate([*orbit, steps.theta.ravel()])

    alone = [work(theta0) for theta0 in starts]
    with ThreadPoolExecutor(8) as pool:
        together = list(pool.map(work, starts))
    assert same_bits(together, alone)


def resident_bytes():
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def calls():
    array = np.ones(3)
    pendula.exact(1.0, 0.5, 2.0)
    pendula.exact(array, 0.5, [[1], [2]])
    pendula.analyze(array, 0.5)
    pendula.solve(array, 0.5, dt=0.1, every=0.5, until=1)
    for bad in ({"alpha": -1}, {"theta0": [1, np.nan]}, {"alpha": [1, 2]}, {"omega0": "x"}):
        with pytest.raises((ValueError, TypeError)):
            pendula.solve(**{"theta0": array, "omega0": 0.0} | bad)


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is read from /proc")
def test_memory_is_flat_over_a_hundred_thousand_calls():
    def repeat(count):
        for _ in range(count // 8):  # as many calls as `calls` makes
            calls()
        return resident_bytes()

    before = repeat(10_000)
    assert repeat(100_000) - before < 2**20  # a leak of ten bytes a call
