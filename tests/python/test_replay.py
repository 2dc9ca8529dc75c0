"""Programs that are numbers, through the extension: shapes, refusals, and a right one against solve."""

import os
import pickle
import signal
import subprocess
import sys
import threading

import numpy as np
import pendula
import pytest
from doubles import same_bits
from pendula import _core

REPLAY = """
import pickle, sys
from pendula import _core
pickle.dump(_core.replay(**pickle.load(sys.stdin.buffer)), sys.stdout.buffer)
"""


def runge_kutta(h, size=1, **changes):
    """What _core.replay takes of right programs that print at once and after 500 and 1000 steps."""
    a = h * np.array([[0, 0, 0, 0], [0.5, 0, 0, 0], [0, 0.5, 0, 0], [0, 0, 1, 0]])
    b = h * np.array([1, 2, 2, 1]) / 6
    none = np.zeros(4)
    stages = np.column_stack([np.ones((4, 2)), a.sum(axis=1), a, 0 * a, 0 * a, a])
    given = {
        "start": np.array([1.0, 0.3]),
        "terms": np.array([2.0, 0.1, 0.2, 0.5, 0.7, 0.3]),
        "force": np.array(_core.Force.sine, np.int32),
        "scale": np.array(1.0),
        "dt": np.array(h),
        "stages": stages,
        "sums": np.array([[*b, *none], [*none, *b]]),
        "steps": np.array([0, 500, 1000]),
        "single": np.array(False),
    }
    return {name: np.repeat(value[None], size, axis=0) for name, value in given.items()} | changes


def test_a_right_program_is_solve():
    theta, omega = _core.replay(**runge_kutta(0.01, 3))
    pendulum = {"alpha": 2.0, "beta": 0.1, "torque": 0.2, "drive_amplitude": 0.5, "drive_frequency": 0.7, "drive_phase": 0.3}
    solved = pendula.solve(1.0, 0.3, until=10.0, every=5.0, dt=0.01, method="rk4", **pendulum)
    assert theta.shape == omega.shape == (3, 3)
    assert np.all(abs(theta - solved.unwrapped) <= 1e-13)  # some roundings in each of 1000 steps, which friction forgets
    assert np.all(abs(omega - solved.omega) <= 1e-13)


def test_floats_and_forces_are_chosen_program_by_program():
    choices = {"single": np.array([False, True, False]), "force": np.array([0, 0, _core.Force.linear], np.int32)}
    theta, _ = _core.replay(**runge_kutta(0.01, 3, **choices))
    assert theta[0, 0] == theta[2, 0] == 1.0
    assert 1e-8 < abs(theta[1, -1] - theta[0, -1]) < 1e-3
    assert abs(theta[2, -1] - theta[0, -1]) > 0.01
    assert np.all(theta[1] == theta[1].astype(np.float32))


def test_no_programs_and_no_rows_give_empty_arrays():
    assert _core.replay(**runge_kutta(0.01, 0))[0].shape == (0, 3)
    assert _core.replay(**runge_kutta(0.01, 2, steps=np.zeros((2, 0), np.int64)))[1].shape == (2, 0)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"terms": np.zeros((2, 5))}, r"terms must have shape \(2, 6\), got \(2, 5\)"),
        ({"sums": np.zeros((2, 2, 6))}, r"sums must have shape \(2, 2, 8\), got \(2, 2, 6\)"),
        ({"steps": np.array([[0, 1]])}, r"steps must have shape \(2, 2\), got \(1, 2\)"),
        ({"steps": np.array([[0, 1], [0, -1]])}, "steps must be a whole number from 0 to .* got -1 at index 1 .member 1."),
        ({"steps": np.array([[0, 1], [2, 1]])}, "steps must not decrease, got 1 after 2"),
        ({"steps": np.array([[0, 1], [0, 2**53 + 1]])}, "more than 2.53"),
        ({"force": np.array([0, 7], np.int32)}, "force must be one of sine, cosine, linear, cubic, quintic"),
        ({"stages": np.zeros((2, 0, 3)), "sums": np.zeros((2, 2, 0))}, "stages must be a whole number from 1 to 8, got 0"),
        ({"stages": np.zeros((2, 9, 39)), "sums": np.zeros((2, 2, 18))}, "stages must be a whole number from 1 to 8, got 9"),
        ({"threads": -1}, "threads must be a whole number from 0 to 256, got -1"),
    ],
)
def test_what_is_not_legal_is_refused_with_the_reason(changes, message):
    with pytest.raises(ValueError, match=message):
        _core.replay(**runge_kutta(0.01, 2, **changes))


def test_steps_that_are_not_whole_are_refused():
    with pytest.raises(TypeError):
        _core.replay(**runge_kutta(0.01, 1, steps=np.array([[0.0, 1.5]])))


def test_every_instruction_set_gives_the_same_bits():
    """Of all forces, with doubles and with floats."""
    programs = runge_kutta(0.01, 10)
    programs |= {"force": np.arange(10, dtype=np.int32) % 5, "single": np.arange(10) >= 5, "scale": np.linspace(0.5, 2, 10)}
    rows = {}
    for name in ("baseline", "avx2", "avx512"):
        done = subprocess.run(
            [sys.executable, "-c", REPLAY],
            input=pickle.dumps(programs),
            env=os.environ | {"PENDULA_ISA": name},
            capture_output=True,
        )
        if done.returncode == 0:
            rows[name] = pickle.loads(done.stdout)
        else:
            assert b"PENDULA_ISA must be one of the instruction sets of this processor" in done.stderr
    assert "baseline" in rows
    for found in rows.values():
        assert np.all(np.isfinite(found))
        assert same_bits(found, _core.replay(**programs))


def test_ctrl_c_ends_a_long_replay():
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        _core.replay(**runge_kutta(0.01, 2, steps=np.full((2, 1), 10**15)))
    timer.join()
