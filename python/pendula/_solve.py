"""Trajectories, sampled."""

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from pendula import _core
from pendula._arguments import Array, Parameters, broadcast_shape, chosen_members, column, parameters, real, thread_count
from pendula._solution import Solution
from pendula._times import Times, at_intervals, at_times, one_axis

METHODS = ("rk4", "euler", "verlet", "taylor", "exact")  # in the order of the core's

# The assignment's factors of the characteristic time.
DT, EVERY, UNTIL = 0.0001, 0.02, 1.0


def solve(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    alpha: npt.ArrayLike = 1.0,
    beta: npt.ArrayLike = 0.0,
    torque: npt.ArrayLike = 0.0,
    drive_amplitude: npt.ArrayLike = 0.0,
    drive_frequency: npt.ArrayLike = 0.0,
    drive_phase: npt.ArrayLike = 0.0,
    t: npt.ArrayLike | None = None,
    until: npt.ArrayLike | None = None,
    every: npt.ArrayLike | None = None,
    method: str = "rk4",
    dt: npt.ArrayLike | None = None,
    tolerance: float = 1e-15,
    threads: int | None = None,
) -> Solution:
    """Solves θ'' = −α sin θ − β θ' + μ + Γ cos(Ω t + φ) and returns a `Solution`: arrays [..., time].

    theta0, omega0: initial angle [rad] and angular velocity [rad/s]. alpha: stiffness α = g/l [s⁻²], positive. beta: damping β
    [s⁻¹], not negative. torque: μ [s⁻²]. drive_amplitude: Γ [s⁻²]; drive_frequency: Ω [rad/s], positive where Γ is not 0;
    drive_phase: φ [rad]. They broadcast; a pendulum's bits depend on its own values only, and are those of the program.

    The times [s] are `t`, one axis from 0 or later, evenly spaced (any for `exact`); or from 0 to `until`, one each `every`.
    Left out, they are the program's: 1 and 0.02 of the characteristic time. dt: longest step, 0.0001 of it where left out;
    taylor chooses its own.

    method: rk4, euler; verlet (no friction); taylor, to `tolerance` in (0, 1); exact, the closed form (no friction or forcing).
    threads: at most so many; as many as there are processors where left out. ValueError for anything outside.
    """
    if method not in METHODS:
        raise ValueError(f"method must be one of {', '.join(METHODS)}, got {method!r}")
    if t is not None and (until is not None or every is not None):
        raise ValueError("t cannot be given together with until or every")
    pendulums = parameters(
        theta0=theta0,
        omega0=omega0,
        alpha=alpha,
        beta=beta,
        torque=torque,
        drive_amplitude=drive_amplitude,
        drive_frequency=drive_frequency,
        drive_phase=drive_phase,
    )
    _core.check(pendulums, METHODS.index(method), tolerance)
    tau = _core.characteristic_time(pendulums)
    step = DT * tau if dt is None else real("dt", dt)
    if t is None:
        between = EVERY * tau if every is None else real("every", every)
        last = UNTIL * tau if until is None else real("until", until)
        has_steps = method not in ("exact", "taylor")  # of a length that is chosen
        times = at_intervals(between, last, step if has_steps else between)
    elif method == "exact":
        times = Times(one_axis(t), 0.0, 0.0, 0.0)
    else:
        times = at_times(one_axis(t), step)
        if times.first > 0 and method in ("euler", "verlet"):
            raise ValueError(f"t must begin at 0 with method {method}, got {times.first}")
    if method == "exact":
        theta, omega, turns = _core.states(**pendulums.closed_form(), t=times.t)
    else:
        theta, omega, turns = _rows(pendulums, times, METHODS.index(method), tolerance, thread_count(threads))
    return Solution(times.t, theta, omega, turns, pendulums, method, step, tolerance)


def _rows(pendulums: Parameters, times: Times, method: int, tolerance: float, threads: int) -> Array:
    """theta, omega and turns: an array (3, ..., time)."""
    shape = broadcast_shape(*pendulums, times.every, times.steps_per_row)
    *columns, intervals = (column(values, shape) for values in (*pendulums, times.every))
    size, rows = math.prod(shape), times.t.shape[-1]

    def solve_all(columns: list[Any], every: Any, size: int, steps: float) -> Array:
        states: Array = _core.solve(tuple(columns), times.first, every, size, rows, steps, method, tolerance, threads)
        return states

    if isinstance(times.steps_per_row, float):
        states = solve_all(columns, intervals, size, times.steps_per_row)
    else:  # the core's ensembles have one number of steps a row
        steps = np.broadcast_to(times.steps_per_row, shape).reshape(-1)
        states = np.empty((3, rows, size))
        for count in np.unique(steps):
            members = np.flatnonzero(steps == count)
            *chosen, every = (chosen_members(values, members) for values in (*columns, intervals))
            states[..., members] = solve_all(chosen, every, members.size, float(count))
    return np.moveaxis(states.reshape(3, rows, *shape), 1, -1)
