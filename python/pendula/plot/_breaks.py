"""Lines that leave by one side of the interval [-π, π) and come back by the other."""

from __future__ import annotations

from typing import Any

import numpy as np


def broken(theta: Any, turns: Any, *others: Any) -> tuple[Any, ...]:
    """The angle and what goes with it, with three points more wherever the angle is wrapped: the edge, a NaN, the other edge.

    theta: in [-π, π); turns: the whole turns beside it, which tell a wrapped angle from a fast one; one axis each. What goes
    with them is interpolated at the edge. Where more than one turn passes between two rows there is only the NaN.
    """
    passed = np.diff(turns)
    places = np.flatnonzero(passed)
    if places.size == 0:
        return (theta, *others)
    edge = np.where(np.abs(passed[places]) == 1, np.pi * passed[places], np.nan)
    step = np.diff(theta)[places] + 2 * np.pi * passed[places]
    fraction = (edge - theta[places]) / step
    extra = np.stack([edge, np.full(places.size, np.nan), -edge], axis=1)
    return (_insert(theta, places, extra), *(_insert(values, places, _at(values, places, fraction)) for values in others))


def _at(values: Any, places: Any, fraction: Any) -> Any:
    """Values between `places` and the next, beside each of the three points."""
    between = values[places] + fraction * np.diff(values)[places]
    return np.stack([between, np.full(places.size, np.nan), between], axis=1)


def _insert(values: Any, places: Any, extra: Any) -> Any:
    return np.insert(np.asarray(values, float), np.repeat(places + 1, 3), extra.reshape(-1))
