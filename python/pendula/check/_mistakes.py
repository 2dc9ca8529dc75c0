"""Mistakes that students make, each as a row: in what a program with it differs from the right one.

They stand in the order in which students make them: where several explain a table, the first is told.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pendula.check._methods import Mistake
from pendula.check._program import DEGREE, GRAVITIES, ROUGH_PIS


def start(name: str, **changes: Any) -> Mistake:
    """A mistake in reading the initial state."""
    return Mistake(name, "start", changes)


def equation(name: str, values: dict[str, float | str] | None = None, **changes: Any) -> Mistake:
    """A mistake in the acceleration."""
    return Mistake(name, "equation", changes, values or {})


EQUATIONS = (
    *(equation("length_in_force", pull=g) for g in GRAVITIES),
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
        for pi in ROUGH_PIS
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
    *(stiffness("alpha_gravity", g, 0, alpha=g) for g in GRAVITIES),
    *(stiffness("alpha_of_length", g, -1, g=g) for g in GRAVITIES),
    *(stiffness("alpha_product", g * g, -1, g=g) for g in GRAVITIES),
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
    late("step_missing", more=-1),
    late("step_more", more=1),
    late("row_late", rows_late=1),
    late("row_early", rows_late=-1),
    late("omega_behind", omega_late=-1),
    late("omega_ahead", omega_late=1),
    late("omega_ahead", omega_late=1, first_is_right=True),
    Mistake("omega_absolute", "column", {"shows": "speed"}, is_rare=True),
    Mistake("omega_difference", "column", {"shows": "step difference"}, {"over": "Δt"}, is_rare=True),
    Mistake("omega_difference", "column", {"shows": "row difference"}, {"over": "t_cout"}, is_rare=True),
    *(Mistake("velocity_along", "column", {"shows": "along", "gravity": g}, {"g": g}, is_rare=True) for g in GRAVITIES),
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
