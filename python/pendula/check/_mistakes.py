"""Mistakes that students make, each as a row: in what a program with it differs from the right one.

They stand in the order in which students make them: where several explain a table, the first is told.
"""

from __future__ import annotations

import math
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula.check._program import DEGREE, Program
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


def start(name: str, **changes: Any) -> Mistake:
    """A mistake in reading the initial state."""
    return Mistake(name, "start", changes)


def method(name: str, made: Stepper, **values: str) -> Mistake:
    """A mistake in the stepper."""
    return Mistake(name, "stepper", {"stepper": made}, values)


# Runge-Kutta (3.10) written wrongly, and other methods.

STAGES = "ABCD"
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


def equation(name: str, values: dict[str, float | str] | None = None, **changes: Any) -> Mistake:
    """A mistake in the acceleration."""
    return Mistake(name, "equation", changes, values or {})


EQUATIONS = (
    *(equation("length_in_force", pull=g) for g in (9.8, 9.81, 9.80665, 10.0)),
    equation("linear", force="linear"),
    equation("upside_down", sign=-1.0),
    equation("cosine", force="cosine"),
    equation("sine_cubic", force="cubic"),
    equation("sine_quintic", force="quintic"),
    *(equation("sine_of_degrees", {"factor": factor}, scale=factor) for factor in (1 / DEGREE, DEGREE)),
    *(equation("damping", {"beta": beta}, beta=beta) for beta in (0.1, 0.2, 0.5)),
    *(
        equation("stage_without_alpha", {"stage": ", ".join(stages)}, bare=stages)._replace(is_rare=True)
        for stages in ("A", "B", "C", "D", "BCD")
    ),
    equation("acceleration_printed", shows="acceleration"),  # of the sine; so it is no pair with another equation
)


# Of what was read.

BOTH = ("theta0", "omega0")
SINGLE_PI = float(np.float32(math.pi)) / math.pi


def conversions(name: str, radians: float, degrees: float) -> tuple[Mistake, ...]:
    """A wrong factor of the angle, of the velocity, or of both, where they are given in radians and in degrees."""
    factors = (radians, degrees)
    return (
        *(start(f"{each}_{name}", **{each: factors}) for each in BOTH),
        start(f"both_{name}", theta0=factors, omega0=factors),
    )


STARTS = (
    *conversions("in_degrees", 1, 1 / DEGREE),
    *conversions("as_degrees", DEGREE, 1),
    *conversions("degrees_inverted", 1, DEGREE**-2),
    start("omega0_is_root_alpha", start="root"),
    start("start_exchanged", start="exchanged"),
    start("omega0_forgotten", omega0=(0, 0)),
    start("theta0_forgotten", theta0=(0, 0)),
    start("omega0_sign", omega0=(-1, -1)),
    start("theta0_sign", theta0=(-1, -1)),
    start("theta0_integer", whole="theta0"),
    start("omega0_integer", whole="omega0"),
    *(
        Mistake("rough_pi", "start", {"theta0": (1, pi / math.pi), "omega0": (1, pi / math.pi), "pi": used}, {"pi": pi})
        for pi in (3.14, 3.1415, 3.1416, 3.14159)
        for used in (pi, math.pi)
    ),
    *(
        Mistake("single_constants", "start", {"theta0": (1, SINGLE_PI), "omega0": (1, SINGLE_PI), "pi": used})
        for used in (SINGLE_PI * math.pi, math.pi)
    ),
    start("single_constants", start="single"),
)


def stiffness(name: str, factor: float, power: float, **values: float) -> Mistake:
    """Another number in the place of α."""
    return Mistake(name, "alpha", {"alpha": (factor, power)}, values)


ALPHAS = (
    Mistake("alpha_integer", "alpha", {"whole": "alpha"}),
    stiffness("alpha_root", 1, 0.5),
    stiffness("alpha_square", 1, 2),
    stiffness("alpha_inverse", 1, -1),
    stiffness("alpha_unused", 1, 0),
    *(stiffness("alpha_gravity", g, 0, alpha=g) for g in (9.8, 9.81, 9.80665, 10.0)),
    *(stiffness("alpha_product", g * g, -1, g=g) for g in (9.8, 9.81, 9.80665, 10.0)),
)


def late(name: str, **changes: Any) -> Mistake:
    """States of other times than those printed."""
    return Mistake(name, "rows", changes)


ROWS = (
    late("step_late", steps_late=1),
    late("step_early_but_first", steps_late=-1),  # there is no step before the first
    late("step_late_but_first", steps_late=1, first_is_right=True),
    late("step_is_interval", is_coarse=True),
    late("time_twice", pace=0.5),
    late("row_late", rows_late=1),
    late("row_early", rows_late=-1),
    late("omega_behind", omega_late=-1),
    late("omega_ahead", omega_late=1),
    late("omega_ahead", omega_late=1, first_is_right=True),
    Mistake("omega_absolute", "column", {"shows": "speed"}, is_rare=True),
    Mistake("omega_difference", "column", {"shows": "step difference"}, {"over": "Δt"}, is_rare=True),
    Mistake("omega_difference", "column", {"shows": "row difference"}, {"over": "t_cout"}, is_rare=True),
    *(
        Mistake("velocity_along", "column", {"shows": "along", "gravity": g}, {"g": g}, is_rare=True)
        for g in (9.8, 9.81, 9.80665, 10.0)
    ),
    late("theta_behind", theta_late=-1)._replace(is_rare=True),
    late("theta_ahead", theta_late=1)._replace(is_rare=True),
    late("theta_ahead", theta_late=1, first_is_right=True)._replace(is_rare=True),
)


def printed(name: str, **changes: Any) -> Mistake:
    """The right state printed wrongly."""
    return Mistake(name, "printing", changes)


PRINTINGS = (
    printed("angle_in_degrees", theta_factor=1 / DEGREE),
    printed("velocity_in_degrees", omega_factor=1 / DEGREE),
    printed("omega_negated", omega_factor=-1.0),
    printed("theta_negated", theta_factor=-1.0),
    printed("theta_absolute", form="absolute"),
    printed("omega_normalised", form="normalised"),
)

SINGLE = Mistake("single_precision", "stepper", {"is_single": True})
