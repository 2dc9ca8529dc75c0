"""Pendulums to be measured, as the core takes them."""

import math
from typing import Any, NamedTuple

import numpy as np

from pendula import _core
from pendula._arguments import Array, column, parameters, thread_count

METHODS = {"rk4": 0, "taylor": 3}  # the core's numbers


class Members(NamedTuple):
    """Checked pendulums and settings."""

    columns: tuple[Any, ...]
    settings: tuple[float, float, float, int, float]
    shape: tuple[int, ...]
    threads: int

    @property
    def size(self) -> int:
        """How many pendulums."""
        return math.prod(self.shape)

    def call(self, measure: Any, **more: Any) -> Any:
        """What one of the core's measures gives."""
        return measure(self.columns, self.settings, self.size, self.threads, **more)

    def shaped(self, values: Array) -> Any:
        """Values [size] in the shape of the pendulums; a single one as a number."""
        return values.reshape(self.shape)[()]

    def shaped_rows(self, values: Array) -> Array:
        """Values [row, size] in the shape of the pendulums, rows last."""
        return np.moveaxis(values.reshape(values.shape[0], *self.shape), 0, -1)


def members(
    given: dict[str, Any],
    *,
    transient: int,
    periods: int,
    steps_per_period: int,
    method: str,
    tolerance: float,
    threads: int | None,
) -> Members:
    """`Members` of what was passed to a measure."""
    if method not in METHODS:
        raise ValueError(f"method must be one of {', '.join(METHODS)}, got {method!r}")
    pendulums = parameters(**given)
    settings = (float(transient), float(periods), float(steps_per_period), METHODS[method], tolerance)
    _core.check_measure(pendulums, settings)
    columns = tuple(column(values, pendulums.shape) for values in pendulums)
    return Members(columns, settings, pendulums.shape, thread_count(threads))
