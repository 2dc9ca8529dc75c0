"""What becomes of pendulums in the long run, seen once a period of the drive (once each 2π/√α where there is none)."""

from __future__ import annotations

import sys
import warnings
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import numpy as np

from . import _core
from ._arguments import public, with_alpha
from ._core import Kind
from ._tables import Array, Attractors, Jumps, Lyapunov, MeanVelocity, Orbit, Section
from ._words import CARRIES, COLUMNS, JUMP_SETTINGS, MEASURES, PENDULUM, settings_of

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from typing import Unpack

    import numpy.typing as npt

    from ._tables import (
        AttractorsArguments,
        Carry,
        JumpsArguments,
        LyapunovArguments,
        MeanVelocityArguments,
        OrbitArguments,
        SectionArguments,
    )

    Function = TypeVar("Function", bound=Callable[..., Any])
    Columns = tuple[Array, ...]

__all__ = [
    "Attractors",
    "Jumps",
    "Kind",
    "Lyapunov",
    "MeanVelocity",
    "Orbit",
    "Section",
    "Shares",
    "attractors",
    "jumps",
    "lyapunov",
    "mean_velocity",
    "orbit",
    "section",
    "shares",
]

COMMON = """The parameters broadcast, and a pendulum's bits depend on its own values only. An error is a bound that covers the
    true value; a number that cannot be had is NaN, with a RuntimeWarning that says for how many pendulums and why. DataArrays
    and Series give results with the same labels. ValueError with the index for a value outside its interval, TypeError for what
    is no real number."""


def measured(function: Function) -> Function:
    """Makes of a function what users call, with the settings and the defaults that the core has for this measure."""
    function.__doc__ = (function.__doc__ or "").replace("{common}", COMMON)
    return public(*PENDULUM, *settings_of(function.__name__))(function)


@measured
def section(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **given: Unpack[SectionArguments]) -> Section:
    """States once a period, or on a plane: Poincaré's section.

    Returns `Section`: arrays [..., row] of angle, angular velocity, turns and time, the first after the transient. With
    plane="theta" or "omega" a row is a crossing of `level` in the `direction`; rows that do not come within the budget are NaN.

    {parameters}
    {common}
    """
    return Section(*_measure("section", theta0, omega0, given))


@measured
def mean_velocity(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **given: Unpack[MeanVelocityArguments]) -> MeanVelocity:
    """The mean angular velocity [rad/s], its error, and what becomes of the motion.

    Returns `MeanVelocity`. Over drive_frequency the velocity is the rotation number; of a Josephson junction it is the voltage.

    {parameters}
    {common}
    """
    return MeanVelocity(*_measure("mean_velocity", theta0, omega0, given))


@measured
def lyapunov(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **given: Unpack[LyapunovArguments]) -> Lyapunov:
    """The Lyapunov exponents [s⁻¹], their error, and what becomes of the motion.

    Returns `Lyapunov`: the larger exponent λ and the second, −β − λ, with one error; the horizon ln(2⁵²)/λ [s], infinite where
    λ is not above its error; Kaplan and Yorke's dimension; and the history [..., row] of estimates from growing parts of the
    measured periods.

    {parameters}
    {common}
    """
    return Lyapunov(*_measure("lyapunov", theta0, omega0, given))


@measured
def attractors(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **given: Unpack[AttractorsArguments]) -> Attractors:
    """The orbits that pendulums settle on, numbered for each of the pendulums that start in several ways.

    Returns `Attractors`. Each pendulum's are numbered 1, 2, … by period, rotation and place, so that labels depend on which
    states are given together; label and period are 0 where there is no such orbit, and theta and omega are the last state.
    `shares` gives the shares of the basins.

    {parameters}
    {common}
    """
    label, *orbit = _measure("attractors", theta0, omega0, given)
    return Attractors(np.nan_to_num(label).astype(np.int64), *orbit)


@measured
def orbit(theta0: npt.ArrayLike, omega0: npt.ArrayLike, **given: Unpack[OrbitArguments]) -> Orbit:
    """The periodic orbits, stable or not, to which Newton's method leads from the initial states.

    Returns `Orbit`: a point, its error, the rotation, Floquet's multipliers and exponents. NaN where the method does not
    converge. The initial states belong to times of the strobe; drive_phase has no part in it.

    {parameters}
    {common}
    """
    return Orbit(*_measure("orbit", theta0, omega0, given))


@public(*PENDULUM, *JUMP_SETTINGS)
def jumps(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    jump_tolerance: float,
    carry: Carry = "up",
    **given: Unpack[JumpsArguments],
) -> Jumps:
    """Where the branches of a carried sweep end: the jumps of hysteresis.

    The sweep runs along the last axis, where just one parameter varies; drive_phase cannot be swept. The interval between two
    neighbours is halved, each time from the last state on the branch, until half its width is at most jump_tolerance, in the
    unit of the parameter.

    Returns `Jumps`: arrays with one value for each pendulum. It is that of the jump between the pendulum and the neighbour from
    which it started; value, error and gap are NaN, and before and after -1, where there is none.

    {parameters}
    carry: up, down, or both along a new first axis; up if left out
    jump_tolerance: the largest error of value, positive
    ValueError with the index for a value outside its interval, TypeError for what is no real number.
    """
    settings, parameters = _parted(given)
    _require_used(settings)
    starts = {"theta0": theta0, "omega0": omega0}
    swept = [name for name, value in (starts | parameters).items() if np.ndim(value) > 0 and np.shape(value)[-1] != 1]
    if len(swept) != 1:
        raise ValueError(f"just one parameter must vary along the last axis, got {', '.join(swept) or 'none'}")
    threads = given.get("threads")

    def compute(order: str | None) -> Columns:
        return _core.jumps(swept[0], jump_tolerance, settings, carry=order, threads=threads, **starts, **parameters)

    return Jumps(*_carried("jumps", carry, compute))


class Shares(NamedTuple):
    """Shares of basins: arrays [..., label], where label 0 stands for none."""

    states: npt.NDArray[np.int64]
    """The number of initial states that end on the attractor."""
    share: Array
    """Their share of all."""
    error: Array
    """Half the width of the interval about `share` that covers the share of the basin in 95 % of the cases."""


def shares(label: npt.ArrayLike, *, axis: int | Sequence[int] | None = None) -> Shares:
    """The shares of basins among initial states that were drawn at random, by the labels of `attractors`.

    label: whole numbers from 0. axis: those along which the initial states run; all if left out. Other axes are of pendulums.
    Returns `Shares`. The error is Wilson's (J. Am. Stat. Assoc. 22, 1927) and holds for independent states, not for a grid.

        >>> shares([1, 1, 2, 1]).states
        array([0, 3, 1])
    """
    labels = np.asarray(label)
    if labels.size == 0 or not np.issubdtype(labels.dtype, np.integer) or labels.min() < 0:
        raise ValueError("label must be whole numbers from 0, and not empty")
    axes = tuple(range(labels.ndim)) if axis is None else axis
    each = [np.asarray(np.sum(labels == k, axis=axes)) for k in range(labels.max() + 1)]
    count = np.stack(each, axis=-1)
    trials = float(labels.size // (count.size // count.shape[-1]))
    return Shares(count, count / trials, _core.share_error(count, trials))


def _measure(name: str, theta0: npt.ArrayLike, omega0: npt.ArrayLike, given: Mapping[str, Any]) -> list[Any]:
    """The columns of a measure, with a warning where there are NaN."""
    settings, parameters = _parted(given)
    _require_used(settings)
    threads = given.get("threads")

    def compute(order: str | None) -> Columns:
        return _core.measure(name, settings, carry=order, theta0=theta0, omega0=omega0, threads=threads, **parameters)

    columns = _carried(name, given.get("carry"), compute)
    _warn_of_nan(MEASURES[name], columns, settings)
    return columns


def _parted(given: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Settings, and parameters as the extension takes them."""
    pendulum = {each.name for each in PENDULUM}
    settings = {name: value for name, value in given.items() if name not in pendulum and name not in ("carry", "threads")}
    return settings, {**with_alpha({name: value for name, value in given.items() if name in pendulum})}


def _require_used(settings: Mapping[str, Any]) -> None:
    """Raises ValueError for a setting that would change nothing, or that its method does not have."""
    method = settings.get("method", _core.strobe_method_names[0])
    by_plane = settings.get("plane", "strobe") != "strobe"
    if by_plane and method == "rk4":
        raise ValueError("plane needs method taylor, which finds the crossings between its steps")
    for name in ("level", "direction"):
        if name in settings and not by_plane:
            raise ValueError(f"{name} is for a section by a plane: it needs plane theta or omega")
    for name, other in (("steps_per_period", "taylor"), ("tolerance", "rk4")):
        if name in settings and method == other:
            raise ValueError(f"{name} does not go with method {other}")


def _carried(name: str, carry: str | None, compute: Callable[[str | None], Columns]) -> list[Any]:
    """The columns of a measure, or of both sweeps along a new first axis, with kinds as such."""
    if carry is not None and carry not in CARRIES:
        raise ValueError(f"carry must be one of {', '.join(CARRIES)}, or None, got {carry!r}")
    if carry == "both":
        columns: list[Any] = [np.stack(each) for each in zip(*map(compute, _core.carry_names), strict=True)]
    else:
        columns = [*compute(carry)]
    for place, column in enumerate(COLUMNS[name]):
        if column.is_kind:
            values = columns[place]
            columns[place] = Kind(int(values)) if np.ndim(values) == 0 else np.nan_to_num(values, nan=-1).astype(np.int8)
    return columns


# The column whose NaN are told.
TOLD = {
    "section": "theta",
    "mean_velocity": "mean_velocity",
    "lyapunov": "exponent",
    "attractors": "rotation",
    "orbit": "theta",
}


def _warn_of_nan(info: _core.Measure, columns: list[Any], settings: Mapping[str, Any]) -> None:
    """A RuntimeWarning where there are pendulums without the number that a measure is called for, with the reason."""
    names = [each.name for each in info.columns]
    is_nan = np.isnan(columns[names.index(TOLD[info.name])])
    if not is_nan.any():
        return
    if info.name == "section":
        is_nan = is_nan.any(axis=-1)
        is_strobed = settings.get("plane", "strobe") == "strobe"
        why = Kind.lost.__doc__ if is_strobed else "They do not cross the plane so often within the budget."
    elif info.name == "orbit":
        why = "Newton's method finds no periodic orbit from their initial states."
    else:
        kinds, counts = np.unique(np.asarray(columns[names.index("kind")])[is_nan], return_counts=True)
        why = " ".join(f"{n} {Kind(k).name}: {Kind(k).__doc__}" for k, n in zip(kinds, counts, strict=True))
    count, size = int(np.sum(is_nan)), int(np.size(is_nan))
    pendulums = "pendulum" if size == 1 else "pendulums"
    message = f"{info.name}: results are nan for {count} of {size} {pendulums}. {why}"
    warnings.warn(message, RuntimeWarning, stacklevel=_depth_of_caller())


def _depth_of_caller() -> int:
    """How far up the stack from the function that asks the first frame outside this package is."""
    depth, frame = 1, sys._getframe(1)
    while frame.f_back is not None and str(frame.f_globals.get("__name__", "")).split(".")[0] == "pendula":
        depth, frame = depth + 1, frame.f_back
    return depth
