"""Peers in Python: SciPy's elliptic functions, and RK4 compiled by Numba."""

from math import cos, sin
from pathlib import Path

import numba
import numpy as np
import scipy
from scipy.special import ellipj

VERSIONS = {"SciPy": scipy.__version__, "Numba": numba.__version__, "NumPy": np.__version__}
STEPS = {"fine": 7.4e-4, "middle": 0.008, "coarse": 0.07, "driven": 0.003, "driven_coarse": 0.07}  # as in rk4_bench.cpp
TABLE = Path(__file__).parent.parent / "tests/data/closed_form.txt"


def samples(alpha, omega0, t):
    """Angle and velocity of an oscillation that starts at the bottom."""
    root = np.sqrt(alpha)
    k = omega0 / (2 * root)
    sn, cn, dn, _ = ellipj(root * t, k * k)
    return 2 * np.arctan2(k * sn, dn), 2 * k * root * cn


def error_near_separatrix():
    """As in closed_form_bench.cpp: the largest error over oscillations from the bottom near the separatrix."""
    largest = 0
    for line in TABLE.read_text().splitlines():
        kind, *words = line.split()
        if kind == "case":
            group, numbers = words[0], [float.fromhex(word) for word in words[1:]]
            alpha, theta0, omega0, k, tau = *numbers[:4], numbers[6]
        if kind == "at" and group == "near" and k == -1 and theta0 == 0:
            t, want_theta, _, want_omega, _, _ = map(float.fromhex, words)
            if abs(t) <= 31 * tau:
                theta, omega = samples(alpha, omega0, t)
                largest = max(largest, abs(theta - want_theta), abs((omega - want_omega) / omega0))
    return float(largest)


@numba.njit(fastmath=True)
def rk4(theta, omega, alpha, h, steps):
    """The inner loop is over the members: their operations are independent and overlap, which is faster."""
    for _ in range(steps):
        for i in range(theta.size):
            x, v = theta[i], omega[i]
            ka = -alpha * sin(x)
            vb = v + 0.5 * h * ka
            kb = -alpha * sin(x + 0.5 * h * v)
            vc = v + 0.5 * h * kb
            kc = -alpha * sin(x + 0.5 * h * vb)
            vd = v + h * kc
            kd = -alpha * sin(x + h * vc)
            theta[i] = x + h / 6 * (v + 2 * (vb + vc) + vd)
            omega[i] = v + h / 6 * (ka + 2 * (kb + kc) + kd)


@numba.njit(fastmath=True)
def rk4_driven(theta, omega, alpha, beta, amplitude, frequency, h, steps):
    """All members have the same drive, so that its cosines are computed once for each step."""
    for n in range(steps):
        start = amplitude * cos(frequency * h * n)
        middle = amplitude * cos(frequency * h * (n + 0.5))
        end = amplitude * cos(frequency * h * (n + 1))
        for i in range(theta.size):
            x, v = theta[i], omega[i]
            ka = start - alpha * sin(x) - beta * v
            vb = v + 0.5 * h * ka
            kb = middle - alpha * sin(x + 0.5 * h * v) - beta * vb
            vc = v + 0.5 * h * kb
            kc = middle - alpha * sin(x + 0.5 * h * vb) - beta * vc
            vd = v + h * kc
            kd = end - alpha * sin(x + h * vc) - beta * vd
            theta[i] = x + h / 6 * (v + 2 * (vb + vc) + vd)
            omega[i] = v + h / 6 * (ka + 2 * (kb + kc) + kd)


def cases():
    """Yields name, call, and the number of items that a call computes. The first call compiles."""
    members, steps = 256, 2000
    start, still = np.linspace(0.01, 2.5, members), np.zeros(members)

    def ensemble(step, *constants):
        return lambda: step(start.copy(), still.copy(), *constants, steps), members * steps

    for name, omega0, tau in (("samples", 1.0, 6.743), ("samples_near", 1.999999895801368, 37.699)):
        t = np.linspace(0, tau, 1000, endpoint=False)
        yield f"{name}/scipy", lambda t=t, omega0=omega0: samples(1.0, omega0, t), t.size
    for name, h in STEPS.items():
        if name.startswith("driven"):
            yield f"rk4_ensemble_{name}/numba", *ensemble(rk4_driven, 1.0, 0.5, 1.15, 2 / 3, h)
        else:
            yield f"rk4_ensemble_{name}/numba", *ensemble(rk4, 1.0, h)


def errors():
    return {"samples_near/scipy": error_near_separatrix()}
