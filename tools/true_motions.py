"""The pendulum's equation by two integrators that are independent of pendula (true_motions.c), for tools/make_truths.py.

`follow` and `turn` are Taylor series of order 28 in 80-bit arithmetic, for single orbits to about 1e-17. `march` is the method
of order 8 of DOP853 (Hairer, Norsett & Wanner I, II.5, by SciPy's table of its coefficients) with equal steps, for many.
"""

import ctypes
import math
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as dop853

NAMES = ("alpha", "beta", "torque", "drive_amplitude", "pivot_amplitude", "drive_frequency", "drive_phase")
FREQUENCY, PHASE = 5, 6
LANES, STAGES, MOST_STEPS = 8, 12, 8192
LONG = np.longdouble
PI = LONG("3.14159265358979323846264338327950288")
NODES, WEIGHTS, LAST = (np.ascontiguousarray(x, dtype=float) for x in (dop853.C[:STAGES], dop853.A[:STAGES, :STAGES], dop853.B))


def _compiled():
    folder = Path(tempfile.mkdtemp())
    options = ["-O3", "-march=native", "-ffast-math", "-mprefer-vector-width=512", "-shared", "-fPIC"]
    subprocess.run(
        ["gcc", *options, str(Path(__file__).with_suffix(".c")), "-o", str(folder / "motions.so"), "-lm"], check=True
    )
    return ctypes.CDLL(str(folder / "motions.so"))


LIBRARY = _compiled()


def _pointer(x):
    return ctypes.c_void_p(x.ctypes.data)


def _long(*values):
    return np.array(values, dtype=LONG)


def parameters(**given):
    """The seven parameters in the order of NAMES; alpha = 1 and the others 0 if they are not given."""
    values = {"alpha": 1.0} | given
    return tuple(float(values.get(name, 0.0)) for name in NAMES)


def period_of(p):
    return 2 * PI / LONG(p[FREQUENCY])


def followed(p, state, time, with_map=False):
    """The state after the time, theta unwrapped, in long double; and the 2 x 2 matrix of its derivatives by the start."""
    y, given, end = _long(*state, 1, 0, 0, 1), _long(*p), _long(time)
    LIBRARY.follow(_pointer(given), _pointer(y), _pointer(end), int(with_map))
    return (y[:2], y[2:].reshape(2, 2).T) if with_map else y[:2]


def turned(p, state, angle, longest=1e6):
    """The time in which theta grows by the angle, and omega then; None if it takes longer than the longest."""
    y, given, box = _long(*state, 0, 0, 0, 0), _long(*p), _long(0)
    angle, longest = _long(angle), _long(longest)
    LIBRARY.turn(_pointer(given), _pointer(y), _pointer(angle), _pointer(longest), _pointer(box))
    return None if box[0] < 0 else (box[0], y[1])


def steps_for(p):
    """Steps a period that keep the error of `march` in one period near 1e-12."""
    alpha, beta, torque, drive, pivot, frequency, _ = p
    rate = math.sqrt(alpha + abs(pivot) + abs(torque) + abs(drive)) + beta / 2 + frequency
    speed = min((abs(torque) + abs(drive)) / max(beta, 1e-9), 4 * rate)
    return max(32, math.ceil(2 * math.pi / frequency * 8 * max(rate, speed)))


def marched(problems, starts, periods, finer=1.0):
    """The advance of theta and the logarithmic growth of a displacement in each period: two arrays, problems x periods."""
    count = len(problems)
    advances, growths, ends = np.empty((count, periods)), np.empty((count, periods)), np.empty((count, 4))
    order = sorted(range(count), key=lambda i: steps_for(problems[i]))
    for first in range(0, count, LANES):
        block = order[first : first + LANES]
        lanes = block + block[-1:] * (LANES - len(block))
        p = np.ascontiguousarray(np.array([problems[i] for i in lanes]).T)
        y = np.ascontiguousarray(np.array([[*starts[i], 1.0, 0.3] if len(starts[i]) == 2 else starts[i] for i in lanes]).T)
        advance, growth = np.empty((periods, LANES)), np.empty((periods, LANES))
        number = math.ceil(finer * max(steps_for(problems[i]) for i in block))
        if number > MOST_STEPS:
            raise ValueError(f"{number} steps a period: {[problems[i] for i in block]}")
        tables = (NODES, WEIGHTS, LAST, advance, growth)
        LIBRARY.march(_pointer(p), _pointer(y), periods, number, *map(_pointer, tables))
        advances[block], growths[block], ends[block] = advance.T[: len(block)], growth.T[: len(block)], y.T[: len(block)]
    return advances, growths, ends
