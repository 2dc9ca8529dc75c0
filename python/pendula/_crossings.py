"""When pendulums cross an angle or a velocity, and the periods that follow from it."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from . import _core
from ._arguments import public, with_alpha
from ._words import PENDULUM

if TYPE_CHECKING:
    from typing import Literal, Unpack

    import numpy.typing as npt

    from ._tables import Array, Direction, PendulumArguments

__all__ = ["Crossings", "crossings", "measured_period"]


class Crossings(NamedTuple):
    """Crossings in the order of time: [crossing] of one pendulum, [..., crossing] of many."""

    t: Array
    """Time [s]."""
    theta: Array
    """Angle in [-π, π) [rad], as in `Solution`."""
    omega: Array
    """Angular velocity [rad/s]."""
    is_rising: npt.NDArray[np.bool_]
    """Whether the crossed quantity increases."""


@public(*PENDULUM)
def crossings(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    until: npt.ArrayLike,
    of: Literal["theta", "omega"] = "theta",
    at: npt.ArrayLike = 0.0,
    direction: Direction = "both",
    tolerance: float = 1e-15,
    threads: int | None = None,
    **pendulum: Unpack[PendulumArguments],
) -> Crossings:
    """The times at which θ or ω crosses a level, from t = 0 up to `until`.

    Of θ'' = −(α + P cos(Ω t + φ)) sin θ − β θ' + μ + Γ cos(Ω t + φ), by Taylor's method.

    of: "theta", which crosses the angles at + 2πm for every whole number m, or "omega", which crosses the one velocity `at`.
    Turning points are of="omega", at=0. at [rad or rad/s], finite. direction: "both", "rising" or "falling".
    until [s], not negative. tolerance: of Taylor's method, in (0, 1). threads: at most so many, from 1 to 256; as many as there
    are processors where left out.
    {parameters}
    at, until and the parameters broadcast; a pendulum's bits depend on its own values only.

    Returns `Crossings`: for one pendulum arrays of one axis; for an array of pendulums arrays [..., crossing], which end in NaN
    (is_rising in False) where a pendulum has fewer crossings than another. No crossing is missed or found twice; where the
    quantity turns within about 1e-16 of a level, rounding decides whether there are two crossings or none. A start on the level
    is no crossing. The error of a time is that of the quantity divided by its rate of change: 1e-13 over the rate, up to t = 50
    (tests/cpp/crossings_test.cpp, tests/cpp/section_test.cpp).

    ValueError with the index for a value outside its interval, TypeError for what is no real number. The crossings of a motion
    that leaves the doubles end there, with a RuntimeWarning.
    """
    t, theta, omega, rising = _core.crossings(
        theta0=theta0,
        omega0=omega0,
        until=until,
        of=of,
        at=at,
        direction=direction,
        tolerance=tolerance,
        threads=threads,
        **with_alpha(pendulum),
    )
    return Crossings(t, theta, omega, rising.astype(np.bool_))


@public(*PENDULUM)
def measured_period(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    until: npt.ArrayLike,
    tolerance: float = 1e-15,
    threads: int | None = None,
    **pendulum: Unpack[PendulumArguments],
) -> Array:
    """The period [s]: the mean time between crossings of θ through multiples of 2π in the direction of the first.

    That is the period of an oscillation about the bottom or of a rotation. Where the motion repeats only after several
    crossings, it is the mean over them.

    until: the time up to which crossings count [s], not negative. tolerance: of Taylor's method, in (0, 1). threads: at most so
    many, from 1 to 256; as many as there are processors where left out.
    {parameters}
    until and the parameters broadcast; a pendulum's bits depend on its own values only.

    Returns a number, or an array in the common shape; NaN where there are fewer than two such crossings, or where the motion
    leaves the doubles. The error is that of two crossings (`crossings`), divided by the number of periods. ValueError with the
    index for a value outside its interval, TypeError for what is no real number.
    """
    return _core.measured_period(
        theta0=theta0, omega0=omega0, until=until, tolerance=tolerance, threads=threads, **with_alpha(pendulum)
    )
