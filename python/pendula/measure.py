"""What becomes of pendulums in the long run, seen once a period of the drive (once each 2π/√α where there is none)."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

import numpy as np

from . import _core
from ._arguments import Parameters, known, with_parameters
from ._tables import Array, Attractors, Lyapunov, PendulumArguments, Section

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Unpack

    import numpy.typing as npt

    Function = TypeVar("Function", bound=Callable[..., Any])

__all__ = ["Attractors", "Lyapunov", "Section", "attractors", "lyapunov", "mean_velocity", "section"]


class MeasureArguments(PendulumArguments, total=False):
    """What all measures take by name."""

    transient: int
    """Periods left out before the first that counts, from 0."""
    periods: int
    """That are measured, from 1."""
    steps_per_period: int
    """Of rk4, from 1."""
    method: str
    """rk4 or taylor."""
    tolerance: float
    """Of taylor, in (0, 1)."""
    threads: int | None
    """At most so many, from 1 to 256; None for as many as there are processors."""


NAMES = frozenset(Parameters._fields) | MeasureArguments.__annotations__.keys()
ARGUMENTS = """{parameters}
    They broadcast; a pendulum's bits depend on its own values only, but for the labels of attractors.

    transient: periods that are left out first, a whole number from 0. periods: that are measured, a whole number from 1; by rk4
    in steps_per_period steps, a whole number from 1 and enough to be stable, or by taylor to `tolerance` in (0, 1).
    threads: at most so many, from 1 to 256; as many as there are processors where left out.

    ValueError with the index for a value outside its interval, TypeError for what is no real number. Where the motion leaves
    the doubles results are NaN, with a RuntimeWarning."""


def measured(function: Function) -> Function:
    """Shows what a measure takes and its defaults, which are the core's."""
    (info,) = (each for each in _core.measures if each.name == function.__name__)
    strobe = _core.Strobe()
    common = [name for name in MeasureArguments.__annotations__ if name not in PendulumArguments.__annotations__]
    settings = {name: getattr(strobe, name, None) for name in common} | {"periods": info.periods}
    whole = {name: int(value) for name, value in settings.items() if isinstance(value, float) and value.is_integer()}
    function.__doc__ = (function.__doc__ or "").replace("{arguments}", ARGUMENTS)
    return with_parameters(**settings | whole)(function)


@measured
def section(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **given: Unpack[MeasureArguments]) -> Section:
    """The states at `periods` successive strobes, the first after the transient (Poincaré's section).

    {arguments}

    Returns `Section`: arrays [..., period].
    """
    return Section(*_core.measure("section", theta0=theta0, omega0=omega0, **known(given, NAMES)))


@measured
def mean_velocity(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **given: Unpack[MeasureArguments]) -> Array:
    """The mean angular velocity [rad/s] over the periods measured, from turns and the difference of two angles.

    {arguments}

    Over drive_frequency it is the rotation number; of a Josephson junction it is the voltage.
    """
    return _core.measure("mean_velocity", theta0=theta0, omega0=omega0, **known(given, NAMES))[0]


@measured
def lyapunov(theta0: npt.ArrayLike, omega0: npt.ArrayLike, *, rows: int = 0, **given: Unpack[MeasureArguments]) -> Lyapunov:
    """The largest Lyapunov exponent: the mean growth of a small displacement, by the linearised equation.

    Benettin et al., Meccanica 15 (1980). rows: estimates in the history, a whole number from 0 to periods.
    {arguments}

    Returns `Lyapunov`: the exponent λ [s⁻¹], of which the other is −β − λ; its standard error [s⁻¹], NaN from a single period;
    the horizon ln(2⁵²)/λ [s], infinite where λ is not positive; and the history [..., row] of estimates from growing parts of
    the periods, whose last is the exponent.
    """
    return Lyapunov(*_core.measure("lyapunov", theta0=theta0, omega0=omega0, rows=rows, **known(given, NAMES)))


@measured
def attractors(
    theta0: npt.ArrayLike, omega0: npt.ArrayLike, *, match: float = 1e-6, **given: Unpack[MeasureArguments]
) -> Attractors:
    """The periodic orbits that pendulums settle on, numbered for each of the pendulums that start in several ways.

    match: how near an orbit comes back to itself, or to another to be the same, in theta [rad] and omega/Ω, positive.
    {arguments}

    Returns `Attractors`. Each pendulum's are numbered 1, 2, … by period, rotation and place; where the orbit is not periodic
    label and period are 0, and theta and omega its last point. Else these are the orbit's point of the smallest angle.
    """
    label, *orbit = _core.measure("attractors", theta0=theta0, omega0=omega0, match=match, **known(given, NAMES))
    return Attractors(np.nan_to_num(label).astype(np.int64), *orbit)
