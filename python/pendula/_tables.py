"""The core's tables of parameters and measures as types. Written by tools/make_python_tables.py."""

from typing import Literal, NamedTuple, TypedDict

import numpy as np
import numpy.typing as npt

from ._core import Kind

Array = npt.NDArray[np.float64]
Method = Literal["rk4", "euler", "verlet", "taylor", "exact"]
StrobeMethod = Literal["taylor", "rk4"]
Plane = Literal["strobe", "theta", "omega"]
Direction = Literal["both", "rising", "falling"]
Carry = Literal["up", "down", "both"]


class Stiffness(TypedDict, total=False):
    """alpha, or gravity and length: numbers, or arrays that broadcast."""

    alpha: npt.ArrayLike
    """α, stiffness g/l [s⁻²], positive; 1 if left out."""
    gravity: npt.ArrayLike
    """g, acceleration of gravity [m/s²], positive; with length, in place of alpha."""
    length: npt.ArrayLike
    """l, length of the pendulum [m], positive; alpha is gravity/length."""


class FloatStiffness(TypedDict, total=False):
    """alpha, or gravity and length of one pendulum."""

    alpha: float
    """α, stiffness g/l [s⁻²], positive; 1 if left out."""
    gravity: float
    """g, acceleration of gravity [m/s²], positive; with length, in place of alpha."""
    length: float
    """l, length of the pendulum [m], positive; alpha is gravity/length."""


class PendulumArguments(Stiffness, total=False):
    """The parameters of pendulums: numbers, or arrays that broadcast."""

    beta: npt.ArrayLike
    """β, damping [s⁻¹], not negative; 0 if left out."""
    torque: npt.ArrayLike
    """μ, constant torque [s⁻²], finite; 0 if left out."""
    drive_amplitude: npt.ArrayLike
    """Γ, amplitude of the drive [s⁻²], finite; 0 if left out."""
    pivot_amplitude: npt.ArrayLike
    """P, amplitude of the shaken pivot's acceleration over l [s⁻²], finite; 0 if left out."""
    drive_frequency: npt.ArrayLike
    """Ω, angular frequency of drive and pivot [rad/s], not negative; 0 if left out."""
    drive_phase: npt.ArrayLike
    """φ, phase of drive and pivot at t = 0 [rad], finite; 0 if left out."""


class ParameterValues(NamedTuple):
    """Initial values and parameters: floats, or arrays that broadcast."""

    theta0: float | Array
    """θ0, initial angle [rad], finite."""
    omega0: float | Array
    """ω0, initial angular velocity [rad/s], finite."""
    alpha: float | Array
    """α, stiffness g/l [s⁻²], positive."""
    beta: float | Array
    """β, damping [s⁻¹], not negative."""
    torque: float | Array
    """μ, constant torque [s⁻²], finite."""
    drive_amplitude: float | Array
    """Γ, amplitude of the drive [s⁻²], finite."""
    pivot_amplitude: float | Array
    """P, amplitude of the shaken pivot's acceleration over l [s⁻²], finite."""
    drive_frequency: float | Array
    """Ω, angular frequency of drive and pivot [rad/s], not negative."""
    drive_phase: float | Array
    """φ, phase of drive and pivot at t = 0 [rad], finite."""


class SectionArguments(PendulumArguments, total=False):
    """What measure.section takes by name."""

    transient: int
    """periods before the measurement; 200 if left out."""
    periods: int
    """measured periods; 100 if left out."""
    budget: int
    """periods after which a motion that has not settled is given up; 10000 if left out."""
    steps_per_period: int
    """steps of rk4 in a period; 1000 if left out."""
    tolerance: float
    """of taylor; 1e-15 if left out."""
    strobe_phase: float
    """phase of the drive at the times of the strobe [rad]; 0 if left out."""
    level: float
    """where a section cuts theta or omega [rad or rad/s]; 0 if left out."""
    method: StrobeMethod
    """of integration, taylor or rk4; taylor if left out."""
    plane: Plane
    """of the section, at `level`, strobe or theta or omega; strobe if left out."""
    direction: Direction
    """of the crossings, both or rising or falling; both if left out."""
    carry: Carry | None
    """along the last axis each starts from where its neighbour ended, up or down; both, along a new first axis."""
    threads: int | None
    """at most so many, from 1 to 256; as many as there are processors if left out."""


class MeanVelocityArguments(PendulumArguments, total=False):
    """What measure.mean_velocity takes by name."""

    transient: int
    """periods before the measurement; 200 if left out."""
    periods: int
    """measured periods; 400 if left out."""
    budget: int
    """periods after which a motion that has not settled is given up; 10000 if left out."""
    steps_per_period: int
    """steps of rk4 in a period; 1000 if left out."""
    tolerance: float
    """of taylor; 1e-15 if left out."""
    strobe_phase: float
    """phase of the drive at the times of the strobe [rad]; 0 if left out."""
    match: float
    """the distance at which a motion is on a periodic orbit [rad]; 1e-06 if left out."""
    method: StrobeMethod
    """of integration, taylor or rk4; taylor if left out."""
    carry: Carry | None
    """along the last axis each starts from where its neighbour ended, up or down; both, along a new first axis."""
    threads: int | None
    """at most so many, from 1 to 256; as many as there are processors if left out."""


class LyapunovArguments(PendulumArguments, total=False):
    """What measure.lyapunov takes by name."""

    transient: int
    """periods before the measurement; 200 if left out."""
    periods: int
    """measured periods; 1000 if left out."""
    budget: int
    """periods after which a motion that has not settled is given up; 10000 if left out."""
    steps_per_period: int
    """steps of rk4 in a period; 1000 if left out."""
    tolerance: float
    """of taylor; 1e-15 if left out."""
    strobe_phase: float
    """phase of the drive at the times of the strobe [rad]; 0 if left out."""
    rows: int
    """rows of the history of estimates; 0 if left out."""
    match: float
    """the distance at which a motion is on a periodic orbit [rad]; 1e-06 if left out."""
    method: StrobeMethod
    """of integration, taylor or rk4; taylor if left out."""
    carry: Carry | None
    """along the last axis each starts from where its neighbour ended, up or down; both, along a new first axis."""
    threads: int | None
    """at most so many, from 1 to 256; as many as there are processors if left out."""


class AttractorsArguments(PendulumArguments, total=False):
    """What measure.attractors takes by name."""

    transient: int
    """periods before the measurement; 200 if left out."""
    periods: int
    """measured periods; 400 if left out."""
    budget: int
    """periods after which a motion that has not settled is given up; 10000 if left out."""
    steps_per_period: int
    """steps of rk4 in a period; 1000 if left out."""
    tolerance: float
    """of taylor; 1e-15 if left out."""
    strobe_phase: float
    """phase of the drive at the times of the strobe [rad]; 0 if left out."""
    match: float
    """the distance at which a motion is on a periodic orbit [rad]; 1e-06 if left out."""
    method: StrobeMethod
    """of integration, taylor or rk4; taylor if left out."""
    carry: Carry | None
    """along the last axis each starts from where its neighbour ended, up or down; both, along a new first axis."""
    threads: int | None
    """at most so many, from 1 to 256; as many as there are processors if left out."""


class OrbitArguments(PendulumArguments, total=False):
    """What measure.orbit takes by name."""

    steps_per_period: int
    """steps of rk4 in a period; 1000 if left out."""
    tolerance: float
    """of taylor; 1e-15 if left out."""
    strobe_phase: float
    """phase of the drive at the times of the strobe [rad]; 0 if left out."""
    orbit_period: int
    """periods after which the orbit closes; 1 if left out."""
    method: StrobeMethod
    """of integration, taylor or rk4; taylor if left out."""
    threads: int | None
    """at most so many, from 1 to 256; as many as there are processors if left out."""


class JumpsArguments(PendulumArguments, total=False):
    """What measure.jumps takes by name."""

    transient: int
    """periods before the measurement; 200 if left out."""
    periods: int
    """measured periods; 400 if left out."""
    budget: int
    """periods after which a motion that has not settled is given up; 10000 if left out."""
    steps_per_period: int
    """steps of rk4 in a period; 1000 if left out."""
    tolerance: float
    """of taylor; 1e-15 if left out."""
    strobe_phase: float
    """phase of the drive at the times of the strobe [rad]; 0 if left out."""
    match: float
    """the distance at which a motion is on a periodic orbit [rad]; 1e-06 if left out."""
    method: StrobeMethod
    """of integration, taylor or rk4; taylor if left out."""
    threads: int | None
    """at most so many, from 1 to 256; as many as there are processors if left out."""


class Section(NamedTuple):
    """What measure.section finds: numbers for one pendulum, arrays for several."""

    theta: Array
    """θ, angle in [-π, π) [rad], [..., row]."""
    omega: Array
    """ω, angular velocity [rad/s], [..., row]."""
    turns: Array
    """whole turns, [..., row]."""
    t: Array
    """t, time [s], [..., row]."""


class MeanVelocity(NamedTuple):
    """What measure.mean_velocity finds: numbers for one pendulum, arrays for several."""

    mean_velocity: Array
    """⟨ω⟩, mean angular velocity [rad/s]."""
    error: Array
    """a bound of its error [rad/s]."""
    kind: Kind | npt.NDArray[np.int8]
    """what becomes of the motion; Kind(k).name is the word for an element k."""
    theta: Array
    """θ, angle at the end [rad]."""
    omega: Array
    """ω, angular velocity at the end [rad/s]."""


class Lyapunov(NamedTuple):
    """What measure.lyapunov finds: numbers for one pendulum, arrays for several."""

    exponent: Array
    """λ, largest Lyapunov exponent [s⁻¹]."""
    error: Array
    """a bound of its error [s⁻¹]."""
    horizon: Array
    """when rounding has grown to the size of the state [s]."""
    second: Array
    """λ₂, the other exponent, -β - λ, with the same error [s⁻¹]."""
    dimension: Array
    """D, Kaplan and Yorke's dimension in the plane of the section."""
    dimension_error: Array
    """a bound of its error."""
    kind: Kind | npt.NDArray[np.int8]
    """what becomes of the motion; Kind(k).name is the word for an element k."""
    theta: Array
    """θ, angle at the end [rad]."""
    omega: Array
    """ω, angular velocity at the end [rad/s]."""
    history: Array
    """λ, estimates from growing parts of the periods [s⁻¹], [..., row]."""


class Attractors(NamedTuple):
    """What measure.attractors finds: numbers for one pendulum, arrays for several."""

    label: npt.NDArray[np.int64]
    """number of the attractor, 0 for none."""
    kind: Kind | npt.NDArray[np.int8]
    """what becomes of the motion; Kind(k).name is the word for an element k."""
    period: Array
    """in periods of the strobe, 0 for none."""
    rotation: Array
    """turns in a period of the strobe."""
    theta: Array
    """θ, a point of the orbit [rad]."""
    omega: Array
    """ω, its angular velocity [rad/s]."""
    error: Array
    """a bound of the error of rotation."""
    exponent: Array
    """λ, largest Lyapunov exponent [s⁻¹]."""
    exponent_error: Array
    """a bound of its error [s⁻¹]."""


class Orbit(NamedTuple):
    """What measure.orbit finds: numbers for one pendulum, arrays for several."""

    theta: Array
    """θ, a point of the orbit [rad]."""
    omega: Array
    """ω, its angular velocity [rad/s]."""
    error: Array
    """a bound of the error of theta and omega/Ω [rad]."""
    rotation: Array
    """turns in a period of the strobe."""
    first: Array
    """m₁, real part of Floquet's larger multiplier."""
    second: Array
    """m₂, real part of the other multiplier."""
    imaginary: Array
    """imaginary part of the first, minus that of the second."""
    exponent: Array
    """λ, largest exponent of Floquet [s⁻¹]."""
    exponent_error: Array
    """a bound of its error [s⁻¹]."""


class Jumps(NamedTuple):
    """What measure.jumps finds: numbers for one pendulum, arrays for several."""

    value: Array
    """where the branch ends []."""
    error: Array
    """half the width of the interval of value []."""
    gap: Array
    """distance of the orbits before and behind."""
    before: Kind | npt.NDArray[np.int8]
    """what becomes of the motion before; Kind(k).name is the word for an element k."""
    after: Kind | npt.NDArray[np.int8]
    """what becomes of the member's motion; Kind(k).name is the word for an element k."""
