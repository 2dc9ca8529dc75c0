"""The arguments of the public functions: by name, with the core's defaults and meanings, with labels or without."""

from __future__ import annotations

import difflib
import functools
import inspect
import sys
from typing import TYPE_CHECKING, TypeVar, cast

import numpy as np

from . import _core
from ._labels import labels_of
from ._tables import ParameterValues, PendulumArguments
from ._words import DRIVEN, INITIAL, PENDULUM

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any, Self, Unpack

    import numpy.typing as npt

    from ._tables import Array
    from ._words import Argument

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
        require_known("Parameters", pendulum, [*cls._fields, "gravity", "length"])
        by_place = dict(zip(cls._fields[2:], others, strict=False))
        by_name = with_alpha({**by_place, **pendulum})
        return cls._make(_core.as_parameters(theta0=theta0, omega0=omega0, **by_name))

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


def require_known(function: str, given: Iterable[str], names: Iterable[str]) -> None:
    """Raises TypeError for the first name that is no argument, with the nearest that is one."""
    for name in given:
        if name in names:
            continue
        near = difflib.get_close_matches(name, names, 1)
        more = f"did you mean {near[0]!r}?" if near else f"its arguments are {', '.join(names)}"
        raise TypeError(f"{name!r} is no argument of {function}; {more}")


def with_alpha(given: Mapping[str, object]) -> Mapping[str, Any]:
    """As the extension takes them: with alpha in place of gravity and length."""
    if "gravity" not in given and "length" not in given:
        return given
    both = ("gravity", "length")
    rest: dict[str, Any] = {name: value for name, value in given.items() if value is not None or name not in both}
    if rest.keys().isdisjoint(both):
        return rest
    if "alpha" in rest:
        raise ValueError("alpha cannot be given together with gravity and length")
    if "gravity" not in rest or "length" not in rest:
        raise ValueError("gravity and length go together: alpha is gravity/length")
    rest["alpha"] = _core.stiffness(rest.pop("gravity"), rest.pop("length"))
    return rest


# Modules whose types have labels; of the other types, those that are common.
LABELLED = ("pandas", "xarray")
PLAIN = frozenset({float, int, str, type(None), np.ndarray, np.float64, np.int64, list, tuple})


def public(*arguments: Argument, apart: tuple[str, ...] = ()) -> Callable[[Function], Function]:
    """Makes of a function of numbers and arrays what users call.

    Its `**` takes these arguments; others are refused with the nearest name. Series and DataArrays become arrays, and results
    get their labels; arguments `apart` do not run over pendulums and give none.
    `help` shows all arguments with their defaults, and {parameters} in the docstring becomes what the core says of them.
    """

    def made(function: Function) -> Function:
        signature = _shown(function, arguments)
        names = list(signature.parameters)
        known = frozenset(names)
        name_of_function = function.__name__

        @functools.wraps(function)
        def call(*places: object, **given: Any) -> object:
            if given and not given.keys() <= known:
                require_known(name_of_function, given, names)
            if sys.modules.keys().isdisjoint(LABELLED):  # as quick as one pendulum deserves
                return function(*places, **given)
            if PLAIN.issuperset(map(type, places)) and PLAIN.issuperset(map(type, given.values())):
                return function(*places, **given)
            by_place = dict(zip(names, places, strict=False))
            labels, values = labels_of(by_place | given, apart)
            places = (*values.values(),)[: len(by_place)] + places[len(by_place) :]
            result = function(*places, **{name: values[name] for name in given})
            return labels.put(result, name_of_function, given.get("carry")) if labels else result

        call.__signature__ = signature  # type: ignore[attr-defined]
        initial = [each for each in INITIAL if each.name in names]
        call.__doc__ = (function.__doc__ or "").replace("{parameters}", _paragraph([*initial, *arguments]))
        return cast("Function", call)

    return made


def _shown(function: Callable[..., object], arguments: tuple[Argument, ...]) -> inspect.Signature:
    """The call without types, which docs have in words."""
    own = [each.replace(annotation=inspect.Parameter.empty) for each in inspect.signature(function).parameters.values()]
    places = [each for each in own if each.kind == each.POSITIONAL_OR_KEYWORD]
    by_name = [each for each in own if each.kind == each.KEYWORD_ONLY]
    added = [inspect.Parameter(each.name, inspect.Parameter.KEYWORD_ONLY, default=each.default) for each in arguments]
    return inspect.Signature([*places, *added, *by_name])


def _paragraph(arguments: list[Argument]) -> str:
    lines = [f"{each.name}: {each.line}" for each in arguments]
    is_driven = any(each.name == "drive_frequency" for each in arguments)
    return "\n    ".join([*lines, DRIVEN] if is_driven else lines)


__all__ = ["INITIAL", "PENDULUM", "Parameters", "along_time", "public", "require_known", "with_alpha"]
