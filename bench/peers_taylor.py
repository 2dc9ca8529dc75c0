"""The peer of taylor_bench.cpp: heyoka at the same tolerance, for one trajectory and for batches of the size it recommends."""

import time
from pathlib import Path

import heyoka
import numpy as np

VERSIONS = {"heyoka": heyoka.__version__}
SPAN, TOLERANCE, RELEASED, MEMBERS = 100.0, 1e-15, 1.5, 256  # as in taylor_bench.cpp
TABLE = Path(__file__).parent.parent / "tests/data/driven.txt"


def equation(alpha, beta, torque, amplitude, frequency, phase):
    theta, omega = heyoka.make_vars("theta", "omega")
    force = -alpha * heyoka.sin(theta)
    if beta is not None:
        force += torque - beta * omega + amplitude * heyoka.cos(frequency * heyoka.time + phase)
    return [(theta, omega), (omega, force)]


SYSTEMS = {"undamped": equation(1.0, None, None, None, None, None), "driven": equation(1.0, 0.5, 0.0, 1.15, 2 / 3, 0.0)}


def one(system):
    integrator = heyoka.taylor_adaptive(system, [RELEASED, 0.0], tol=TOLERANCE)

    def call():
        integrator.time = 0.0
        integrator.state[:] = RELEASED, 0.0
        integrator.propagate_until(SPAN)

    return call, SPAN


def ensemble(system):
    size = heyoka.recommended_simd_size()
    start = np.zeros((MEMBERS // size, 2, size))
    start[:, 0, :] = RELEASED + np.arange(MEMBERS).reshape(-1, size) / MEMBERS
    integrator = heyoka.taylor_adaptive_batch(system, start[0].copy(), tol=TOLERANCE)

    def call():
        for batch in start:
            integrator.set_time(0.0)
            integrator.state[:] = batch
            integrator.propagate_until(SPAN)

    return call, SPAN * MEMBERS


def cases():
    """Yields name, call, and the units of time of one trajectory that a call computes."""
    for name, system in SYSTEMS.items():
        yield f"taylor_{name}/heyoka", *one(system)
        yield f"taylor_ensemble_{name}/heyoka", *ensemble(system)


def largest_error():
    """As in taylor_bench.cpp: the largest error over the driven pendulums of the reference table, up to t = 50."""
    integrator = heyoka.taylor_adaptive(equation(*(heyoka.par[i] for i in range(6))), [0.0, 0.0], pars=[0.0] * 6, tol=TOLERANCE)
    largest = 0.0
    for line in TABLE.read_text().splitlines():
        kind, *words = line.split()
        if kind == "problem":
            numbers = [float.fromhex(word) for word in words[1:]]
            integrator.pars[:], integrator.state[:], integrator.time = numbers[:6], numbers[6:], 0.0
        if kind == "at":
            t, theta, theta_rest, omega, omega_rest = map(float.fromhex, words)
            integrator.propagate_until(t)
            largest = max(largest, abs(integrator.state[0] - theta - theta_rest), abs(integrator.state[1] - omega - omega_rest))
    return float(largest)


def errors():
    error = largest_error()
    return {f"taylor_{kind}{name}/heyoka": error for kind in ("", "ensemble_") for name in SYSTEMS}


if __name__ == "__main__":  # prints nanoseconds per unit of time of one trajectory
    for case, call, items in cases():
        best = float("inf")
        for _ in range(100):
            before = time.thread_time_ns()
            call()
            best = min(best, time.thread_time_ns() - before)
        print(f"{case} {best / items:.0f}")
    print(f"largest error {largest_error():.1e}")
