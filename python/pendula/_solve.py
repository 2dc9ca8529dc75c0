"""Trajectories, sampled."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core
from ._arguments import Parameters, public, with_alpha
from ._solution import Solution
from ._words import PENDULUM

if TYPE_CHECKING:
    from typing import Unpack

    import numpy.typing as npt

    from ._tables import Method, PendulumArguments


@public(*PENDULUM, apart=("t",))
def solve(
    theta0: npt.ArrayLike,
    omega0: npt.ArrayLike,
    *,
    t: npt.ArrayLike | None = None,
    until: npt.ArrayLike | None = None,
    every: npt.ArrayLike | None = None,
    method: Method = "rk4",
    dt: npt.ArrayLike | None = None,
    tolerance: float = 1e-15,
    threads: int | None = None,
    **pendulum: Unpack[PendulumArguments],
) -> Solution:
    """Trajectories of θ'' = −(α + P cos(Ω t + φ)) sin θ − β θ' + μ + Γ cos(Ω t + φ).

    {parameters}
    They broadcast, DataArrays by the names of their axes; `Solution.to_xarray` has the labels of DataArrays and Series. A
    pendulum's bits depend on its own values only, and are those of the program.

    The times [s] are `t`, one axis of times that do not decrease, from 0 on (of any sign and order for `exact`); or from 0 to
    `until`, one each `every`. Left out, they are the program's: 1 and 0.02 of the characteristic time. Times that are evenly
    spaced, but for rounding, become t[0] + j every; others are taken as they are. dt [s], positive: the longest step, 0.0001 of
    the characteristic time where left out; equal steps lead from each time to the next. taylor chooses its own and exact has
    none: there a dt has to be legal, and changes nothing.

    method: rk4, euler; verlet (no friction); taylor, to `tolerance` in (0, 1); exact, the closed form (no friction or forcing).
    threads: at most so many, from 1 to 256; as many as there are processors where left out.

    Returns a `Solution`: arrays [..., time]. rk4, euler and verlet converge at orders 4, 1 and 2 (tests/cpp/methods_test.cpp);
    taylor at 1e-15 is within 1e-12 rad up to t = 50 where the motion is chaotic, 1e-13 elsewhere (tests/cpp/taylor_test.cpp).

    ValueError with the index for a value outside its interval, for what a method cannot do, and for steps so long that friction
    makes them unstable; TypeError for what is no real number. A motion that leaves the doubles is NaN from there on, with a
    RuntimeWarning.
    """
    times, theta, omega, turns, step, values = _core.solve(
        theta0=theta0,
        omega0=omega0,
        t=t,
        until=until,
        every=every,
        method=method,
        dt=dt,
        tolerance=tolerance,
        threads=threads,
        **with_alpha(pendulum),
    )
    return Solution(times, theta, omega, turns, Parameters._make(values), method, step, tolerance)
