"""What becomes of pendulums in the long run, seen once a period of the drive (once each 2π/√α where there is none).

All take theta0 [rad], omega0 [rad/s] and any of alpha, beta, torque, drive_amplitude, drive_frequency and drive_phase as
`pendula.solve` does, and broadcast them; a pendulum's bits depend on its own values only. After `transient` periods that are
left out, `periods` are measured: by rk4 in steps_per_period steps, or by taylor to `tolerance`. threads: at most so many; as
many as there are processors where left out. ValueError for anything outside; NaN where a pendulum diverges.
"""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from pendula import _core
from pendula._arguments import Array
from pendula._strobe import members

__all__ = ["Attractors", "Lyapunov", "Section", "attractors", "lyapunov", "mean_velocity", "section"]


class Section(NamedTuple):
    """States at successive strobes: arrays [..., period]."""

    theta: Array
    """Angle in [-π, π) [rad]."""
    omega: Array
    """Angular velocity [rad/s]."""
    turns: Array
    """Whole turns: the unwrapped angle is theta + 2π turns."""


class Lyapunov(NamedTuple):
    """Largest Lyapunov exponents and how far to trust them: numbers, or arrays of one shape."""

    exponent: Any
    """[s⁻¹]; the other one is −beta less this."""
    error: Any
    """Standard error [s⁻¹]; NaN from a single period."""
    horizon: Any
    """When rounding has grown to the size of the state [s]; infinite where the exponent is not positive."""
    history: Array
    """Estimates [..., row] from growing parts of the periods; the last is the exponent."""


class Attractors(NamedTuple):
    """The periodic orbits that pendulums settle on: numbers, or arrays of one shape."""

    label: Any
    """Each pendulum's attractors are 1, 2, … by period, rotation and place; 0 where the orbit is not periodic."""
    period: Any
    """In periods of the strobe; 0 where none was found."""
    rotation: Any
    """Turns a period of the strobe."""
    theta: Any
    """The orbit's point of the smallest angle in [-π, π) [rad]; the last point where the orbit is not periodic."""
    omega: Any
    """Its angular velocity [rad/s]."""


def section(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    transient: int = 200,
    periods: int = 100,
    steps_per_period: int = 1000,
    method: str = "rk4",
    tolerance: float = 1e-15,
    threads: int | None = None,
    **pendulum: npt.ArrayLike,
) -> Section:
    """The states at `periods` successive strobes, the first after the transient."""
    pendulums = members(
        {"theta0": theta0, "omega0": omega0, **pendulum},
        transient=transient,
        periods=periods,
        steps_per_period=steps_per_period,
        method=method,
        tolerance=tolerance,
        threads=threads,
    )
    theta, omega, turns = map(pendulums.shaped_rows, pendulums.call(_core.section))
    return Section(theta, omega, turns)


def mean_velocity(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    transient: int = 200,
    periods: int = 100,
    steps_per_period: int = 1000,
    method: str = "rk4",
    tolerance: float = 1e-15,
    threads: int | None = None,
    **pendulum: npt.ArrayLike,
) -> Any:
    """The mean angular velocity [rad/s] over the periods measured.

    Over drive_frequency it is the rotation number; of a Josephson junction it is the voltage.
    """
    pendulums = members(
        {"theta0": theta0, "omega0": omega0, **pendulum},
        transient=transient,
        periods=periods,
        steps_per_period=steps_per_period,
        method=method,
        tolerance=tolerance,
        threads=threads,
    )
    return pendulums.shaped(pendulums.call(_core.mean_velocity))


def lyapunov(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    transient: int = 200,
    periods: int = 1000,
    steps_per_period: int = 1000,
    method: str = "rk4",
    tolerance: float = 1e-15,
    threads: int | None = None,
    rows: int = 0,
    **pendulum: npt.ArrayLike,
) -> Lyapunov:
    """The largest Lyapunov exponent: the mean growth of a small displacement, by the linearised equation.

    rows: estimates in the history.
    """
    pendulums = members(
        {"theta0": theta0, "omega0": omega0, **pendulum},
        transient=transient,
        periods=periods,
        steps_per_period=steps_per_period,
        method=method,
        tolerance=tolerance,
        threads=threads,
    )
    if rows < 0:
        raise ValueError(f"rows must not be negative, got {rows}")
    values, history = pendulums.call(_core.lyapunov, rows=rows)
    exponent, error, horizon = map(pendulums.shaped, values)
    return Lyapunov(exponent, error, horizon, pendulums.shaped_rows(history))


def attractors(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    transient: int = 200,
    periods: int = 100,
    steps_per_period: int = 1000,
    method: str = "rk4",
    tolerance: float = 1e-15,
    threads: int | None = None,
    match: float = 1e-6,
    **pendulum: npt.ArrayLike,
) -> Attractors:
    """The periodic orbits that pendulums settle on, numbered for each of the pendulums that start in several ways.

    match: how near an orbit comes back to itself, or to another to be the same, in theta [rad] and omega/Ω.
    """
    pendulums = members(
        {"theta0": theta0, "omega0": omega0, **pendulum},
        transient=transient,
        periods=periods,
        steps_per_period=steps_per_period,
        method=method,
        tolerance=tolerance,
        threads=threads,
    )
    orbits = pendulums.call(_core.orbits, match=match)
    kinds = np.stack(np.broadcast_arrays(*pendulums.columns[2:], np.empty(pendulums.size))[:-1], axis=-1)
    label = np.zeros(pendulums.size, dtype=np.int64)
    different, kind = np.unique(kinds, axis=0, return_inverse=True)
    for number, values in enumerate(different):
        same = np.flatnonzero(kind.reshape(-1) == number)
        label[same] = _core.labels(tuple(values), pendulums.settings, match, np.ascontiguousarray(orbits[:, same]))
    return Attractors(*map(pendulums.shaped, (label, *orbits)))
