"""The parameters of pendulums as arguments: by name, with the core's defaults and meanings."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from . import _core
from ._tables import ParameterValues, PendulumArguments

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any, Self, Unpack

    import numpy.typing as npt

    from ._tables import Array

Function = TypeVar("Function", bound="Callable[..., Any]")


class Parameters(ParameterValues):
    """Where pendulums start and which they are: floats, or arrays of float64 that broadcast.

    theta0, omega0: initial angle [rad] and angular velocity [rad/s]; then the other arguments of `pendula.solve`, by name or in
    their order. TypeError for what is no real number, ValueError where shapes do not fit.
    """

    __slots__ = ()

    def __new__(
        cls, theta0: npt.ArrayLike, omega0: npt.ArrayLike, *others: npt.ArrayLike, **pendulum: Unpack[PendulumArguments]
    ) -> Self:
        """Whatever real numbers are given, as floats and float64."""
        by_name = PendulumArguments(**dict(zip(cls._fields[2:], others, strict=False)))  # type: ignore[typeddict-item]
        return cls._make(_core.as_parameters(theta0=theta0, omega0=omega0, **by_name, **known(pendulum, cls._fields)))

    @property
    def shape(self) -> tuple[int, ...]:
        """The common shape; () of a single pendulum."""
        return np.broadcast_shapes(*map(np.shape, self))

    @property
    def is_conservative(self) -> bool:
        """Whether none of them has friction or forcing, so that the closed form holds."""
        return _core.are_conservative(**self._asdict())


def along_time(values: float | Array) -> float | Array:
    """Values of pendulums as they broadcast against arrays whose last axis is time."""
    return values[..., np.newaxis] if isinstance(values, np.ndarray) else values


Given = TypeVar("Given", bound="Mapping[str, object]")


def known(given: Given, names: Iterable[str]) -> Given:
    """What was given by name, if all names are known."""
    for name in given:
        if name not in names:
            fields = ", ".join(Parameters._fields)
            raise TypeError(
                f"{name!r} is no parameter of a pendulum, nor another argument of this call; parameters are {fields}"
            )
    return given


def with_parameters(**settings: object) -> Callable[[Function], Function]:
    """Makes `help` show the parameters by name, and settings with their defaults, where a function takes them by `**`.

    {parameters} in its docstring becomes what the core's table says of them.
    """

    def shown(function: Function) -> Function:
        own = [each for each in inspect.signature(function).parameters.values() if each.kind != each.VAR_KEYWORD]
        added = {each.name: each.default for each in _core.parameters if not each.is_initial}
        by_name = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default) for name, default in added.items()]
        more = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default) for name, default in settings.items()]
        places = [each for each in own if each.kind != each.KEYWORD_ONLY]
        function.__signature__ = inspect.Signature([*places, *by_name, *own[len(places) :], *more])  # type: ignore[attr-defined]
        function.__doc__ = (function.__doc__ or "").replace("{parameters}", PARAGRAPH)
        return function

    return shown


INTERVALS = {
    _core.Rule.finite: "finite",
    _core.Rule.positive: "positive",
    _core.Rule.not_negative: "not negative",
    _core.Rule.fraction: "between 0 and 1",
}
DRIVEN = "A driven pendulum, of which either amplitude is not 0, needs a positive drive_frequency."
PARAGRAPH = (
    "\n    ".join(
        f"{each.name}: {each.symbol}, {each.meaning} [{each.unit}], {INTERVALS[each.interval]}"
        + ("" if each.is_initial else f"; {each.default:g} if left out")
        for each in _core.parameters
    )
    + f"\n    {DRIVEN}"
)
