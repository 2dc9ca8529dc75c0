"""When `solve` looks at its pendulums, and how many steps lie between."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from pendula import _core
from pendula._arguments import Array, along_time, real


class Times(NamedTuple):
    """Row j is at t[..., j] = first + j every; `every` and `steps_per_row` are floats, or arrays of as many as pendulums."""

    t: Array
    first: float
    every: Any
    steps_per_row: Any


def at_times(t: Array, dt: Any) -> Times:
    """Evenly spaced times, as far as rounding lets them be, in steps of at most `dt`."""
    first, every = _even_spacing(t)
    longest = max(first, every)
    _, steps = _core.schedule(dt, longest, longest)
    return Times(np.asarray(first + np.arange(t.size) * every), first, every, steps)


def at_intervals(every: Any, until: Any, dt: Any) -> Times:
    """Rows from 0 on, as the program has them."""
    rows, steps = _core.schedule(dt, every, until)
    fewest, most = (int(np.min(rows)), int(np.max(rows))) if np.size(rows) else (0, 0)
    if fewest != most:
        raise ValueError(f"until/every must give all pendulums as many rows, got from {fewest} to {most}")
    return Times(np.arange(most) * along_time(every), 0.0, every, steps)


def one_axis(t: npt.ArrayLike) -> Array:
    """Times as an array of one axis."""
    times: Array = real("t", t)
    if np.ndim(times) != 1:
        raise ValueError(f"t must have one axis, got shape {np.shape(times)}")
    return times


def _even_spacing(t: Array) -> tuple[float, float]:
    """(first, every) of evenly spaced times."""
    if t.size < 2:
        return (float(t[0]) if t.size else 0.0), 1.0
    first = float(t[0])
    # From 0 on, numpy's arange and linspace give multiples of the second time.
    every = float(t[1]) if first == 0 else float(t[-1] - first) / (t.size - 1)
    slack = 4 * np.spacing(np.abs(t).max())  # a difference, a quotient, a product and a sum, each rounded once
    if not (first >= 0 and every > 0 and np.all(np.abs(first + np.arange(t.size) * every - t) <= slack)):
        raise ValueError(f"t must begin at 0 or later and grow by even steps (with method exact it need not), got {t}")
    return first, every
