"""Runge-Kutta (3.10) written wrongly, and other methods, each as a row."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula.check._stepper import (
    CLASSICAL,
    EULER,
    EULER_CROMER,
    NONE,
    OMEGA_FIRST_OWN,
    OWN_INDEX,
    SECOND,
    SEEING_BOTH,
    SEEING_SUM,
    SEEING_THEMSELVES,
    SIMPSON,
    STAGES,
    THETA_FIRST_OWN,
    WITHOUT_D,
    ZEROS,
    classical,
    stepper,
    turned,
    with_sixth,
    without,
)

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from pendula.check._program import Program
    from pendula.check._stepper import Rows, Stepper


class Mistake(NamedTuple):
    """A row."""

    name: str
    """Of its page; several rows may have the same."""
    group: str
    """What of the program is wrong; two mistakes of a pair are from different groups."""
    changes: dict[str, Any]
    """Fields of Program."""
    values: Mapping[str, float | str] = MappingProxyType({})
    """What its page says beside."""
    is_rare: bool = False
    """Whether it is looked for only where nothing else is wrong with the states: pairs cost time."""

    def of(self, program: Program) -> Program:
        """The program with this mistake as well."""
        return replace(program, **self.changes)


def method(name: str, made: Stepper, **values: str) -> Mistake:
    """A mistake in the stepper."""
    return Mistake(name, "stepper", {"stepper": made}, values)


LINES = ("θ, ω", "θ", "ω")


def weighted(name: str, numbers: Sequence[float], lines: Sequence[str] = LINES, **values: str) -> tuple[Mistake, ...]:
    """Other weights in the lines of both equations, or of one."""
    made = {
        "θ, ω": classical(weights=numbers),
        "θ": classical(weights=numbers, omega_weights=SIMPSON),
        "ω": classical(omega_weights=numbers),
    }
    rows = (method(name, made[line], equation=line, **values) for line in lines)
    return tuple(row._replace(is_rare=row.values["equation"] != LINES[0]) for row in rows)


def of_one_line(name: str, angle: Rows) -> tuple[Mistake, ...]:
    """What the stages see, in the lines of both equations or of one: the velocities' stages are seen in the angle's line."""
    made = {"θ, ω": classical(angle=angle), "θ": classical(velocity=angle), "ω": classical(angle=angle, velocity=CLASSICAL)}
    return tuple(method(name, each, equation=line)._replace(is_rare=line != LINES[0]) for line, each in made.items())


def repeated(stage: str, source: str, angle: Rows) -> tuple[Mistake, ...]:
    """A stage that sees what another one sees."""
    rows = of_one_line("stage_repeated", angle)
    return tuple(row._replace(values={**row.values, "stage": stage, "source": source}, is_rare=True) for row in rows)


def left_out(stage: int, lines: Sequence[str]) -> tuple[Mistake, ...]:
    """A stage that is taken at the state itself and not at an estimate."""
    angle = tuple(() if i == stage else row for i, row in enumerate(CLASSICAL))
    rows = of_one_line("estimate_left_out", angle)
    return tuple(
        row._replace(values={**row.values, "stage": STAGES[stage]}, is_rare=True)
        for row in rows
        if row.values["equation"] in lines
    )


HALF, WHOLE = (1, 0.5, 0.5, 1), (1, 1, 1, 1)
HALVED = ((HALF, HALF, "θ, ω"), (WHOLE, HALF, "θ"), (HALF, WHOLE, "ω"))

ACCUMULATING = ((), (0.5,), (0.5, 0.5), (0.5, 0.5, 1))

OTHER_WEIGHTS = (
    ("1/8, 3/8, 3/8, 1/8", (1 / 8, 3 / 8, 3 / 8, 1 / 8)),
    ("1/6, 1/3, 1/3, 1/3", (1 / 6, 1 / 3, 1 / 3, 1 / 3)),
    ("1/3, 1/3, 1/3, 1/6", (1 / 3, 1 / 3, 1 / 3, 1 / 6)),
    ("1/6, 1/3, 1/2, 1/6", (1 / 6, 1 / 3, 1 / 2, 1 / 6)),
    ("1/6, 1/2, 1/3, 1/6", (1 / 6, 1 / 2, 1 / 3, 1 / 6)),
    ("1/2, 0, 0, 1/2", (1 / 2, 0, 0, 1 / 2)),
)

WEIGHTS = (
    *(row for i in (0, 3) for row in weighted("slope_left_out", without(i), stage=STAGES[i])),
    *(row for i in (1, 2) for row in weighted("slope_left_out", without(i), LINES[1:], stage=STAGES[i])),
    *(row._replace(is_rare=True) for i in (1, 2) for row in weighted("weights_two_missing", with_sixth(i), stage=STAGES[i])),
    *weighted("weights_equal", (0.25,) * 4),
    *(
        row._replace(is_rare=True)
        for told, weights in OTHER_WEIGHTS
        for row in weighted("weights_other", weights, weights=told)
    ),
    *weighted("weights_unsorted", (1 / 6, 1 / 6, 1 / 3, 1 / 3)),
    *weighted("weights_unsorted", (1 / 3, 1 / 6, 1 / 6, 1 / 3)),
    *weighted("weights_unsorted", (1 / 3, 1 / 3, 1 / 6, 1 / 6)),
    *(
        method("weights_sum", classical(weights=[6 * weight / divisor for weight in SIMPSON]), sum=total)._replace(is_rare=True)
        for divisor, total in ((3, "2"), (4, "1.5"), (1, "6"))
    ),
)

STEPPERS = (
    method("euler_cromer", EULER_CROMER),
    method("euler", EULER),
    method("own_slopes", classical(angle=NONE, own_angle=CLASSICAL, own_velocity=CLASSICAL)),
    method("own_slopes_theta", classical(velocity=NONE, own_velocity=CLASSICAL)),
    method("own_slopes_omega", classical(angle=NONE, velocity=CLASSICAL, own_angle=CLASSICAL)),
    method("own_slopes_omega_first", OMEGA_FIRST_OWN),
    method("own_slopes_omega_first", THETA_FIRST_OWN),
    method("own_slopes_h_missing", classical(angle=NONE, own_angle=CLASSICAL, own_velocity=CLASSICAL, power=0)),
    method("own_slopes_h_squared", classical(angle=NONE, own_angle=CLASSICAL, own_velocity=CLASSICAL, power=2)),
    method("verlet", stepper(((), (), (0, 1)), (0, 1), velocity=((), (0.5,)), omega_weights=(0.5, 0, 0.5))),
    method("verlet", stepper(((), (0.5,), ()), (0.5, 0, 0.5), velocity=((), (), (0, 1)), omega_weights=(0, 1))),
    method("midpoint", stepper(((), (0.5,)), (0, 1))),
    method("heun", stepper(((), (1,)), (0.5, 0.5))),
    method("euler_theta_first", stepper(((), (1,)), (1, 0), velocity=((), ()), omega_weights=(0, 1))),
    method("runge_kutta_3", stepper(((), (0.5,), (-1, 2)), (1 / 6, 2 / 3, 1 / 6))),
    method("h_missing_stages", classical(power=0)),
    method("h_missing_d", classical(power=(1, 1, 1, 0))),
    method("h_twice", classical(sum_power=2)),
    method("h_twice", classical(power=2, sum_power=2)),
    method("h_twice", classical(power=2)),
    *of_one_line("half_kept_d", ((), (0.5,), (0, 0.5), (0, 0, 0.5))),
    *of_one_line("halves_forgotten", ((), (1,), (0, 1), (0, 0, 1))),
    *of_one_line("half_forgotten_b", ((), (1,), (0, 0.5), (0, 0, 1))),
    *of_one_line("half_forgotten_c", ((), (0.5,), (0, 1), (0, 0, 1))),
    *left_out(1, LINES),
    *left_out(2, LINES),
    *left_out(3, LINES[:2]),  # that of ω is a misprint
    *repeated("C", "A", ((), (0.5,), (0.5, 0), (0, 0, 1))),
    *repeated("D", "A", ((), (0.5,), (0, 0.5), (1, 0, 0))),
    *repeated("D", "B", ((), (0.5,), (0, 0.5), (0, 1, 0))),
    *(
        method("half_of_sum", classical(theta=theta, omega=omega), equation=line)._replace(is_rare=True)
        for theta, omega, line in HALVED
    ),
    method("integer_half", classical(angle=((), (0,), (0, 0), (0, 0, 1)))),
    method("misprint_two_theta", classical(angle=WITHOUT_D, velocity=CLASSICAL, theta=(1, 1, 1, 2))),
    method("misprint_theta_c_alone", classical(theta=(1, 1, 1, 0))),
    method("misprint_theta_n", classical(angle=WITHOUT_D, velocity=CLASSICAL)),
    method("theta_before_omega", stepper(SEEING_SUM, SIMPSON, velocity=SEEING_THEMSELVES, omega_weights=SECOND)),
    method("theta_before_omega", stepper(SEEING_BOTH, SIMPSON, velocity=SEEING_THEMSELVES, omega_weights=SECOND)),
    method("omega_before_theta", stepper(SEEING_THEMSELVES, SECOND, velocity=SEEING_SUM, omega_weights=SIMPSON)),
    method("omega_before_theta", stepper(SEEING_THEMSELVES, SECOND, velocity=SEEING_BOTH, omega_weights=SIMPSON)),
    *weighted("weights_sixth", (1 / 6,) * 4),
    method("weights_third_missing", classical(weights=(1 / 6, 1 / 3, 0, 1 / 6))),
    method("weights_third_missing", classical(weights=(1 / 6, 0, 1 / 3, 1 / 6))),
    *WEIGHTS,
    *(method("wrong_sign_in_stage", turned(i), stage=STAGES[i]) for i in range(4)),
    method("own_index", OWN_INDEX),
    method("stages_accumulate", classical(angle=ACCUMULATING)),
    method("stages_accumulate", classical(angle=ACCUMULATING, weights=np.add(SIMPSON, (0.5, 0.5, 1, 0)).tolist())),
    method("integer_division", classical(weights=ZEROS)),
    method("estimates_of_theta_ignored", classical(angle=NONE, velocity=CLASSICAL)),
    method("estimates_of_omega_ignored", classical(velocity=NONE)),
)

SINGLE = Mistake("single_precision", "stepper", {"is_single": True})
