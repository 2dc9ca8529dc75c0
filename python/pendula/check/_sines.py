"""Ways to get the sinusoid (3.4) wrong, each with the column that it gives."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pendula import _core, analyze
from pendula.check._asked import PERIOD, Start, closed_form

if TYPE_CHECKING:
    from collections.abc import Callable

EPSILON = float(np.finfo(float).eps)


class Sinusoid(NamedTuple):
    """A hypothesis."""

    name: str
    """In TEXTS; empty where nothing is wrong."""
    column: Callable[[Start, Any], Any]
    """Of the pendulum that was solved, at the times that were printed."""


def slack(start: Start, t: Any) -> Any:
    """How far off it may be for a period known to 1e-6, and for what rounding leaves of θM as the arccosine (3.2).

    The cosine's last bit is δ of θM, and √(2δ) of the phase where θ0 is θM.
    """
    theta_max, tau = np.abs(analyze(start.theta0, start.omega0, alpha=start.alpha)[1:])
    if theta_max == 0:
        return np.zeros_like(t)
    delta = min(1.0, 4 * EPSILON / (theta_max * max(float(np.sin(theta_max)), EPSILON)))
    return theta_max * (PERIOD * (1 + 2 * np.pi * np.abs(t) / tau) + delta + np.sqrt(2 * delta))


def right(start: Start, t: Any) -> Any:
    """As the assignment has it."""
    return _core.sine(*start, t)


def other_sign(start: Start, t: Any) -> Any:
    """The phase as if the velocity had the other sign: that of the arcsine alone, where the velocity is negative."""
    return _core.sine(start.theta0, -start.omega0, start.alpha, t)


def no_phase(start: Start, t: Any) -> Any:
    """The phase of a pendulum of the same amplitude that starts at the bottom."""
    theta_max, tau = analyze(start.theta0, start.omega0, alpha=start.alpha)[1:]
    _, omega = closed_form(Start(theta_max, 0.0, start.alpha), -tau / 4)
    return _core.sine(0.0, omega, start.alpha, t)


def quarter_turn(start: Start, t: Any) -> Any:
    """The cosine for the sine."""
    return right(start, t + start.tau / 4)


def initial_amplitude(start: Start, t: Any) -> Any:
    """θ0 for θM."""
    theta_max = analyze(start.theta0, start.omega0, alpha=start.alpha).theta_max
    return right(start, t) * (start.theta0 / theta_max)


def small_period(start: Start, t: Any) -> Any:
    """The period of small oscillations."""
    return right(start, t * (start.tau / Start(0.0, 0.0, start.alpha).tau))


def double_period(start: Start, t: Any) -> Any:
    """Twice the period."""
    return right(start, t / 2)


def angle(start: Start, t: Any) -> Any:
    """The pendulum's own angle."""
    return closed_form(start, t)[0]


SINUSOIDS = (
    Sinusoid("", right),
    Sinusoid("sine other sign", other_sign),
    Sinusoid("sine no phase", no_phase),
    Sinusoid("sine quarter turn", quarter_turn),
    Sinusoid("sine initial amplitude", initial_amplitude),
    Sinusoid("sine small period", small_period),
    Sinusoid("sine double period", double_period),
    Sinusoid("sine is the angle", angle),
)
