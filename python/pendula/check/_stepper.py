"""Explicit methods with stages, as numbers: Runge-Kutta's (3.10), and what students make of it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    Floats: TypeAlias = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Stepper:
    """An explicit method with stages: the angle, the velocity and the acceleration of each are

        x = theta[s] θ + Σ_j h^power[s] (angle[s, j] v_j + own_angle[s, j] a_j)
        v = omega[s] ω + Σ_j h^power[s] (velocity[s, j] a_j + own_velocity[s, j] v_j)
        a = the acceleration at x, v and the time t + h time[s]

    and the step adds h^sum_power Σ_j theta_sum[j] v_j to θ and h^sum_power Σ_j omega_sum[j] a_j to ω.
    """

    theta: Floats
    omega: Floats
    time: Floats
    angle: Floats
    own_angle: Floats
    velocity: Floats
    own_velocity: Floats
    theta_sum: Floats
    omega_sum: Floats
    power: Floats
    sum_power: float

    @lru_cache(maxsize=4096)  # noqa: B019
    def numbers(self, h: float) -> tuple[Floats, Floats]:
        """The coefficients as `replay` takes them: [stage, 3 + 4 stages] and [angle or velocity, 2 stages]."""
        with np.errstate(over="ignore", invalid="ignore"):
            scale = np.power(h, self.power)[:, None]
            matrices = [each * scale for each in (self.angle, self.own_angle, self.own_velocity, self.velocity)]
            total = np.power(h, self.sum_power)
        nothing = np.zeros_like(self.theta_sum)
        parts = np.column_stack([self.theta, self.omega, self.time * h])
        sums = [np.concatenate([self.theta_sum, nothing]), np.concatenate([nothing, self.omega_sum])]
        return np.hstack([parts, *matrices]), np.stack(sums) * total


Rows: TypeAlias = "Sequence[Sequence[float]]"


def stepper(
    angle: Rows,
    weights: Sequence[float],
    *,
    velocity: Rows | None = None,
    omega_weights: Sequence[float] | None = None,
    own_angle: Rows = (),
    own_velocity: Rows = (),
    theta: Sequence[float] = (),
    omega: Sequence[float] = (),
    power: float | Sequence[float] = 1,
    sum_power: float = 1,
) -> Stepper:
    """A stepper whose velocities see the accelerations as its angles see the velocities, unless other weights are given."""
    stages = max(len(angle), len(weights), len(omega_weights or ()))
    matrices = [_square(each, stages) for each in (angle, own_angle, angle if velocity is None else velocity, own_velocity)]
    parts, faster_parts = (np.append(np.array(each, float), np.ones(stages - len(each))) for each in (theta, omega))
    sums = [_padded(each, stages) for each in (weights, weights if omega_weights is None else omega_weights)]
    time = np.clip(np.maximum(matrices[0].sum(axis=1), matrices[2].sum(axis=1)), 0, 1)
    powers = np.broadcast_to(np.array(power, float), stages)
    seen, own_seen, faster, own_faster = matrices
    return Stepper(parts, faster_parts, time, seen, own_seen, faster, own_faster, sums[0], sums[1], powers, sum_power)


def _padded(row: Sequence[float], stages: int) -> Floats:
    return np.append(np.array(row, float), np.zeros(stages - len(row)))


def _square(rows: Rows, stages: int) -> Floats:
    filled = [_padded(row, stages) for row in rows] + [np.zeros(stages)] * (stages - len(rows))
    return np.array(filled)


STAGES = "ABCD"
CLASSICAL = ((), (0.5,), (0, 0.5), (0, 0, 1))
SIMPSON = (1 / 6, 1 / 3, 1 / 3, 1 / 6)
RUNGE_KUTTA = stepper(CLASSICAL, SIMPSON)


# Runge-Kutta (3.10) written wrongly. Rows are stages A to D, entries weights of the slopes of the stages before.

NONE = ((), (), (), ())
WITHOUT_D = ((), (0.5,), (0, 0.5), ())


def classical(**changes: Any) -> Stepper:
    """Runge-Kutta (3.10) but for these changes."""
    return stepper(**{"angle": CLASSICAL, "weights": SIMPSON, **changes})


def after(rows: Sequence[Sequence[float]], weights: Sequence[float]) -> list[list[float]]:
    """Four more stages behind the first four, which see these rows of themselves and, before, the sum of the first four."""
    return [[], [], [], [], *([*weights, *row] for row in rows)]


ZEROS = (0.0,) * 4
# The velocity is done with first, by slopes of its own, and the angle's slopes start from the new one; or the reverse.
OMEGA_FIRST_OWN = stepper(
    NONE,
    (*ZEROS, *SIMPSON),
    own_angle=CLASSICAL,
    velocity=after(((), (), (), ()), SIMPSON),
    own_velocity=after(CLASSICAL, ZEROS),
    omega_weights=SIMPSON,
)
THETA_FIRST_OWN = stepper(
    after(((), (), (), ()), SIMPSON),
    SIMPSON,
    own_angle=after(CLASSICAL, ZEROS),
    velocity=(),
    own_velocity=CLASSICAL,
    omega_weights=(*ZEROS, *SIMPSON),
)
# All slopes are as in (3.10), but those of the second quantity are taken again where the first is already new.
SEEING_SUM = [*CLASSICAL, *after(CLASSICAL, SIMPSON)[4:]]
SEEING_THEMSELVES = [*CLASSICAL, *after(CLASSICAL, ZEROS)[4:]]
SEEING_BOTH = [*CLASSICAL, *([*np.add(SIMPSON, (*row, *ZEROS)[:4])] for row in CLASSICAL)]
SECOND = (*ZEROS, *SIMPSON)

EULER = stepper(((),), (1,))
EULER_CROMER = stepper(((), ()), (0, 1), velocity=((), (1,)), omega_weights=(1, 0))

# Each stage of the velocity sees the angle's increment of its own stage, which is known already: seven evaluations.
OWN_INDEX = stepper(
    ((), (), (0, 0.5), (), (0, 0, 0, 0.5), (), (0, 0, 0, 0, 0, 1)),
    (1 / 6, 1 / 3, 0, 1 / 3, 0, 1 / 6, 0),
    velocity=((), (0.5,), (), (0, 0, 0.5), (), (0, 0, 0, 0, 1), ()),
    omega_weights=(1 / 6, 0, 1 / 3, 0, 1 / 3, 0, 1 / 6),
)


def without(stage: int) -> tuple[float, ...]:
    """The weights of (3.10) without that of one stage."""
    return tuple(0.0 if i == stage else weight for i, weight in enumerate(SIMPSON))


def turned(stage: int) -> Stepper:
    """Runge-Kutta (3.10) with the acceleration of one stage turned round."""
    signs = [-1.0 if i == stage else 1.0 for i in range(4)]
    velocity = [[weight * signs[i] for i, weight in enumerate(row)] for row in CLASSICAL]
    return classical(velocity=velocity, omega_weights=[a * b for a, b in zip(SIMPSON, signs, strict=True)])


def with_sixth(stage: int) -> tuple[float, ...]:
    """The weights of (3.10), but for one stage that has 1/6."""
    return tuple(1 / 6 if i == stage else weight for i, weight in enumerate(SIMPSON))
