"""The pendulum without friction and forcing: what it does, and where it is at any time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Generic, NamedTuple, TypeVar, overload

import numpy as np

from . import _core
from ._arguments import public, with_alpha
from ._core import Regime
from ._words import STIFFNESS

if TYPE_CHECKING:
    from typing import Unpack

    import numpy.typing as npt

    from ._tables import Array, FloatStiffness, Stiffness

__all__ = ["Analysis", "Regime", "analyze", "exact"]

Kind = TypeVar("Kind")
Number = TypeVar("Number")


class Analysis(NamedTuple, Generic[Kind, Number]):
    """What a pendulum does: numbers, or arrays of one shape."""

    regime: Kind
    """`Regime`, or an array of its values."""
    theta_max: Number
    """Limit angle [rad]: the amplitude in (0, π), or π; −π on the separatrix for ω < 0."""
    tau: Number
    """Characteristic time [s]: the period, or the time to 0.999 `theta_max` on the separatrix."""


@overload
def analyze(theta0: float, omega0: float, **stiffness: Unpack[FloatStiffness]) -> Analysis[Regime, np.float64]: ...
@overload
def analyze(
    theta0: npt.ArrayLike, omega0: npt.ArrayLike, **stiffness: Unpack[Stiffness]
) -> Analysis[npt.NDArray[np.int8], Array]: ...
@public(*STIFFNESS)
def analyze(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **stiffness: Unpack[Stiffness]) -> object:
    """Regime, amplitude and characteristic time of θ'' = −α sin θ (3.2, 3.5 to 3.8), by the arithmetic-geometric mean.

    {parameters}
    They broadcast.

    Returns `Analysis`. The regime is the separatrix where one unit in the last place of the three can make it so. theta_max and
    tau are right to 4 ulp (tests/cpp/analysis_test.cpp). ValueError with the index for a value outside its interval, TypeError
    for what is no real number.
    """
    return Analysis(*_core.analyze(theta0, omega0, **with_alpha(stiffness)))


@overload
def exact(theta0: float, omega0: float, t: float, **stiffness: Unpack[FloatStiffness]) -> tuple[np.float64, np.float64]: ...
@overload
def exact(
    theta0: npt.ArrayLike, omega0: npt.ArrayLike, t: npt.ArrayLike, **stiffness: Unpack[Stiffness]
) -> tuple[Array, Array]: ...
@public(*STIFFNESS)
def exact(theta0: npt.ArrayLike, omega0: npt.ArrayLike, t: npt.ArrayLike, **stiffness: Unpack[Stiffness]) -> object:
    """The state at time t of θ'' = −α sin θ, in closed form (Jacobi's elliptic functions; docs/numerics.md).

    t: times of either sign [s], finite
    {parameters}
    They broadcast; each pendulum is prepared once, whatever the times.

    Returns (theta, omega). theta [rad] is not wrapped: it goes on from θ0 and counts turns. Before whole turns are added it is
    within 1e-14 rad, and omega [rad/s] within 1e-14 of its maximum, for |t| <= 30 tau; within 1e-13 to 1e6 tau
    (tests/cpp/exact_test.cpp). The sum with the turns is rounded once: after many turns, `solve` with method="exact" gives
    angle and turns apart. ValueError with the index for a value outside its interval, TypeError for what is no real number.
    """
    return _core.exact(theta0, omega0, t, **with_alpha(stiffness))


@overload
def amplitude(tau: float, **stiffness: Unpack[FloatStiffness]) -> np.float64: ...
@overload
def amplitude(tau: npt.ArrayLike, **stiffness: Unpack[Stiffness]) -> Array: ...
@public(*STIFFNESS)
def amplitude(tau: npt.ArrayLike, **stiffness: Unpack[Stiffness]) -> object:
    """The amplitude [rad] of the pendulum θ'' = −α sin θ whose period is tau: the inverse of `analyze` for oscillations.

    tau: period [s], finite, at least 2π/√α, that of small swings
    {parameters}
    They broadcast.

    Let go at rest from the amplitude, in [0, π], the pendulum swings with this period. It is right to 2 ulp for the doubles
    given (tests/cpp/analysis_test.cpp), and is the double of π from some 151/√α on. ValueError with the index for a value
    outside its interval, TypeError for what is no real number.
    """
    return _core.amplitude(tau, **with_alpha(stiffness))


@overload
def to_radians(degrees: float) -> np.float64: ...
@overload
def to_radians(degrees: npt.ArrayLike) -> Array: ...
@public()
def to_radians(degrees: npt.ArrayLike) -> object:
    """Degrees as radians, rounded once: `pendula.analyze(pendula.to_radians(90), 0)`.

    degrees: any real numbers, also of degrees a second. These are the doubles that the program has for `--theta0 90deg`;
    numpy.radians can differ from them in the last place. Angles are radians everywhere else: a keyword of `analyze` or `solve`
    could mean the velocities, the phases and the results as well, or not. TypeError for what is no real number.
    """
    return _core.to_radians(degrees)
