"""The pendulum without friction and forcing: what it does, and where it is at any time."""

from enum import IntEnum
from typing import Any, NamedTuple, overload

import numpy as np
import numpy.typing as npt

from pendula import _core
from pendula._arguments import Array, real


class Regime(IntEnum):
    """The kinds of motion; the values are the assignment's k."""

    oscillation = -1
    separatrix = 0
    rotation = 1


class Analysis(NamedTuple):
    """What a pendulum does: numbers, or arrays of one shape."""

    regime: Any
    """`Regime`, or an array of its values."""
    theta_max: Any
    """Limit angle [rad]: the amplitude in (0, π), or π; −π on the separatrix for ω < 0."""
    tau: Any
    """Characteristic time [s]: the period, or the time to 0.999 `theta_max` on the separatrix."""


def analyze(theta0: npt.ArrayLike, omega0: npt.ArrayLike, *, alpha: npt.ArrayLike = 1.0) -> Analysis:
    """Regime, amplitude and characteristic time of θ'' = −α sin θ (3.2, 3.5 to 3.8), by the arithmetic-geometric mean.

    theta0: initial angle θ0 [rad], finite. omega0: initial angular velocity ω0 [rad/s], finite. alpha: stiffness α = g/l [s⁻²],
    positive. They broadcast. The regime is the separatrix where one unit in the last place of the three can make it so.
    theta_max and tau are right to 4 ulp. ValueError for anything outside.
    """
    k, theta_max, tau = _core.analyze(real("theta0", theta0), real("omega0", omega0), real("alpha", alpha))
    regime = k.astype(np.int8) if isinstance(k, np.ndarray) else Regime(int(k))
    return Analysis(regime, theta_max, tau)


@overload
def exact(theta0: float, omega0: float, t: float, *, alpha: float = 1.0) -> tuple[np.float64, np.float64]: ...
@overload
def exact(
    theta0: npt.ArrayLike, omega0: npt.ArrayLike, t: npt.ArrayLike, *, alpha: npt.ArrayLike = 1.0
) -> tuple[Array, Array]: ...
def exact(theta0: npt.ArrayLike, omega0: npt.ArrayLike, t: npt.ArrayLike, *, alpha: npt.ArrayLike = 1.0) -> tuple[Any, Any]:
    """(theta, omega) at time t of θ'' = −α sin θ, in closed form (Jacobi's elliptic functions).

    theta0: initial angle θ0 [rad], finite. omega0: initial angular velocity ω0 [rad/s], finite. t: times of either sign [s],
    finite. alpha: stiffness α = g/l [s⁻²], positive. They broadcast; each pendulum is prepared once, whatever the times.
    theta [rad] is not wrapped: it goes on from θ0 and counts turns. Within 1e-14 rad, and omega [rad/s] within 1e-14 of its
    maximum, for |t| <= 30 tau; 1e-13 to 1e6 tau. ValueError for anything outside.
    """
    theta, omega = _core.exact(real("theta0", theta0), real("omega0", omega0), real("alpha", alpha), real("t", t))
    return theta, omega
