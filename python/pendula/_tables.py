"""The core's tables of parameters and measures as types. Written by tools/make_python_tables.py."""

from typing import NamedTuple, TypedDict

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


class PendulumArguments(TypedDict, total=False):
    """The parameters of pendulums: numbers, or arrays that broadcast."""

    alpha: npt.ArrayLike
    """α: stiffness g/l [s⁻²], positive; 1 if left out."""
    beta: npt.ArrayLike
    """β: damping [s⁻¹], not negative; 0 if left out."""
    torque: npt.ArrayLike
    """μ: constant torque [s⁻²]; 0 if left out."""
    drive_amplitude: npt.ArrayLike
    """Γ: amplitude of the drive [s⁻²]; 0 if left out."""
    pivot_amplitude: npt.ArrayLike
    """P: amplitude of the shaken pivot's acceleration over l [s⁻²]; 0 if left out."""
    drive_frequency: npt.ArrayLike
    """Ω: angular frequency of drive and pivot [rad/s], not negative; 0 if left out."""
    drive_phase: npt.ArrayLike
    """φ: phase of drive and pivot at t = 0 [rad]; 0 if left out."""


class ParameterValues(NamedTuple):
    """Initial values and parameters: floats, or arrays that broadcast."""

    theta0: float | Array
    """θ0: initial angle [rad]."""
    omega0: float | Array
    """ω0: initial angular velocity [rad/s]."""
    alpha: float | Array
    """α: stiffness g/l [s⁻²], positive."""
    beta: float | Array
    """β: damping [s⁻¹], not negative."""
    torque: float | Array
    """μ: constant torque [s⁻²]."""
    drive_amplitude: float | Array
    """Γ: amplitude of the drive [s⁻²]."""
    pivot_amplitude: float | Array
    """P: amplitude of the shaken pivot's acceleration over l [s⁻²]."""
    drive_frequency: float | Array
    """Ω: angular frequency of drive and pivot [rad/s], not negative."""
    drive_phase: float | Array
    """φ: phase of drive and pivot at t = 0 [rad]."""


class Section(NamedTuple):
    """States once a period of the drive.

    theta: θ, angle in [-π, π) [rad], [..., row]
    omega: ω, angular velocity [rad/s], [..., row]
    turns: whole turns, [..., row]
    """

    theta: Array
    omega: Array
    turns: Array


class Lyapunov(NamedTuple):
    """Largest Lyapunov exponent.

    exponent: λ, largest Lyapunov exponent [s⁻¹]
    error: its standard error [s⁻¹]
    horizon: when rounding has grown to the size of the state [s]
    history: λ, estimates from growing parts of the periods [s⁻¹], [..., row]
    """

    exponent: Array
    error: Array
    horizon: Array
    history: Array


class Attractors(NamedTuple):
    """Periodic orbits that pendulums settle on.

    label: number of the attractor, 0 for none
    period: in periods of the strobe, 0 for none
    rotation: turns a period of the strobe
    theta: θ, a point of the orbit [rad]
    omega: ω, its angular velocity [rad/s]
    """

    label: npt.NDArray[np.int64]
    period: Array
    rotation: Array
    theta: Array
    omega: Array
