"""A student's program as data: what it takes for the problem, its period, its stepper, its rows and how it prints them."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import lru_cache
from tempfile import TemporaryFile
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple, TypeAlias

import numpy as np

from pendula import _core
from pendula._closed_form import analyze, exact
from pendula._command import BAD_USAGE, RefusedError, Text, printed
from pendula.check._stepper import RUNGE_KUTTA, STAGES, Stepper

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt

    Floats: TypeAlias = npt.NDArray[np.float64]
    Integers: TypeAlias = npt.NDArray[np.int64]

DEGREE = math.pi / 180
ROUGH_PIS = (3.14, 3.1415, 3.1416, 3.14159)
GRAVITIES = (9.8, 9.81, 9.80665, 10.0)  # m/s²
MOST_CHARACTERS = 1 << 20  # of a file with problems

TOO_LONG: Text = ("the file with the problems has more than {0} bytes", "el fichero con los problemas tiene más de {0} bytes")


class Problem(NamedTuple):
    """A problem as the program pendula reads it."""

    theta0: float
    omega0: float
    alpha: float
    dt: float
    """The longest step: factorΔ τ [s]."""
    every: float
    """Time between rows [s]."""
    until: float
    tau: float
    regime: int
    """The assignment's k."""
    theta_max: float
    rows: float
    theta0_unit: str = "r"
    omega0_unit: str = "r"

    @property
    def steps_per_row(self) -> float:
        """factorcout/factorΔ, which need be no whole number."""
        return self.every / self.dt


class Start(NamedTuple):
    """A pendulum and its initial state."""

    theta0: float
    omega0: float
    alpha: float


# Programs.


@dataclass(frozen=True)
class Program:
    """What a program does. The default does what was asked for."""

    theta0: tuple[float, float] = (1.0, 1.0)
    """Factors on the initial angle where it is given in radians and in degrees."""
    omega0: tuple[float, float] = (1.0, 1.0)
    start: str = "given"
    """Or exchanged; or root: ω0 is √α; or single: all numbers are read in single precision."""
    whole: str = ""
    """theta0, omega0 or alpha: what is kept in a variable for whole numbers."""
    alpha: tuple[float, float] = (1.0, 1.0)
    """Factor, and power of the α given."""
    pi: float = math.pi
    stepper: Stepper = field(default=RUNGE_KUTTA, compare=False)
    force: str = "sine"
    """What stands for the sine in the acceleration; one of the core's `Force`."""
    scale: float = 1.0
    """Factor of the angle in it."""
    sign: float = 1.0
    """Of the acceleration."""
    pull: float = 0.0
    """What stands for α in it, unless that is 0."""
    bare: str = ""
    """The stages, A to D, in which α is missing."""
    beta: float = 0.0
    torque: float = 0.0
    drive: tuple[float, float] = (0.0, 0.0)
    """Amplitude and angular frequency."""
    is_single: bool = False
    steps_late: int = 0
    """By how many steps the states are later than the times printed."""
    rows_late: int = 0
    pace: float = 1.0
    """How many steps are taken for one that is counted."""
    more: int = 0
    """How many steps too many are taken between two rows."""
    is_coarse: bool = False
    """Whether the step is the time between rows."""
    first_is_right: bool = False
    """Whether the first row is not late."""
    theta_late: int = 0
    """By how many steps the angle alone is later than the times printed."""
    omega_late: int = 0
    shows: str = "velocity"
    """Or acceleration, speed (|ω|), along (l ω, with the length of `gravity`), or the angle's difference to the step or the row
    before, by the time between them: what is printed in the velocity's column."""
    gravity: float = 9.81
    """[m/s²]"""
    theta_factor: float = 1.0
    """Of the angle, as it is printed."""
    omega_factor: float = 1.0
    form: str = "signed"
    """Or absolute: |θ| is printed; or normalised: ω is wrapped like an angle."""

    @property
    def starts_elsewhere(self) -> bool:
        """Whether the first row may be another one than the initial state."""
        return any((self.steps_late, self.rows_late, self.theta_late, self.omega_late)) or self.shows != "velocity"


RIGHT = Program()


def taken(program: Program, problem: Problem) -> Start:
    """What a program takes for the pendulum and its initial state."""
    theta0 = problem.theta0 * program.theta0[problem.theta0_unit == "s"]
    omega0 = problem.omega0 * program.omega0[problem.omega0_unit == "s"]
    factor, power = program.alpha
    alpha = float(factor * np.float64(problem.alpha) ** power)  # infinite, where it is no double
    theta0, omega0, alpha = (
        float(math.trunc(each)) if name == program.whole and math.isfinite(each) else each
        for name, each in (("theta0", theta0), ("omega0", omega0), ("alpha", alpha))
    )
    if program.start == "exchanged":
        theta0, omega0 = omega0, theta0
    elif program.start == "single":
        theta0, omega0, alpha = (float(np.float32(each)) for each in (theta0, omega0, alpha))
    elif program.start == "root":
        omega0 = math.sqrt(alpha)
    return Start(theta0, omega0, alpha)


# Motion.


@lru_cache(maxsize=4096)
def analysis(start: Start) -> tuple[int, float, float]:
    """(k, θM, τ) of the assignment. Raises ValueError where there is no such pendulum."""
    found = analyze(*start[:2], alpha=start.alpha)
    return int(found.regime), float(found.theta_max), float(found.tau)


LATEST = 1e9  # periods; no table's digits tell the phase of a later time


def closed_form(start: Start, t: Floats) -> tuple[Floats, Floats]:
    """(theta, omega) of the frictionless pendulum; the angle counts whole turns.

    A row that claims to be later than LATEST is wrong by its time, whatever its state.
    """
    latest = LATEST * analysis(start)[2]
    theta, omega = exact(start.theta0, start.omega0, np.clip(t, -latest, latest), alpha=start.alpha)
    return np.asarray(theta), np.asarray(omega)


class Clock(NamedTuple):
    """When a program's rows are."""

    steps: Integers
    """[row]: the number of steps before it."""
    dt: float
    """Step [s]."""
    doubt: float
    """How far off the step may be, relatively."""
    unsure: Floats
    """[row]: how far the times printed leave the row's time open [s]."""
    coarser: float = 1.0
    """How many times longer than dt a program's steps may be, of which the last before a row is shorter."""

    def first(self, rows: int) -> Clock:
        """The clock of the first rows alone."""
        return self._replace(steps=self.steps[:rows], unsure=self.unsure[:rows])

    @property
    def t(self) -> Floats:
        """[row]: its time [s]."""
        return self.steps * np.float64(self.dt)


class Motion(NamedTuple):
    """States of programs, [program, row]; the angle counts whole turns."""

    theta: Floats
    omega: Floats


def paced(program: Program, clock: Clock) -> Clock:
    """The steps that a program takes where the right one takes those of the clock."""
    if program.is_coarse or program.more:
        per_row = max(1, int(np.median(np.diff(clock.steps)))) if clock.steps.size > 1 else 1
        rows = clock.steps // per_row
        return (
            clock._replace(steps=rows, dt=clock.dt * per_row)
            if program.is_coarse
            else clock._replace(steps=clock.steps + rows * program.more)
        )
    if program.pace != 1:
        return clock._replace(steps=np.round(clock.steps * program.pace).astype(np.int64))
    return clock


def replay(programs: Sequence[Program], clocks: Sequence[Clock], starts: Sequence[Start]) -> Motion:
    """What the programs print, each with its clock, from what it takes for the pendulum."""
    motion = _states(programs, clocks, starts)
    for i, name in enumerate(("theta_late", "omega_late")):
        apart = [j for j, program in enumerate(programs) if getattr(program, name)]
        if apart:
            late = [replace(programs[j], steps_late=programs[j].steps_late + getattr(programs[j], name)) for j in apart]
            motion[i][apart] = _states(late, [clocks[j] for j in apart], [starts[j] for j in apart])[i]
    for j, program in enumerate(programs):
        if program.shows != "velocity":
            motion.omega[j] = _shown(program, clocks[j], starts[j], motion.theta[j], motion.omega[j])
    return motion


def _shown(program: Program, clock: Clock, start: Start, theta: Floats, omega: Floats) -> Floats:
    """What a program prints in the velocity's column."""
    shown = omega.copy()
    if program.shows == "acceleration":
        shown = -_terms(program, start)[0] * np.sin(theta)
    elif program.shows == "speed":
        shown = np.abs(omega)
    elif program.shows == "along":
        shown *= program.gravity / start.alpha
    elif program.shows == "step difference":
        before = _states([replace(program, steps_late=program.steps_late - 1)], [clock], [start]).theta[0]
        shown[1:] = (theta - before)[1:] / clock.dt
    elif program.shows == "row difference":
        shown[1:] = np.diff(theta) / (np.maximum(np.diff(clock.steps), 1) * clock.dt)
    return shown


def _states(programs: Sequence[Program], clocks: Sequence[Clock], starts: Sequence[Start]) -> Motion:
    """What the programs compute."""
    rows = max((clock.steps.size for clock in clocks), default=0)
    theta, omega = np.empty((2, len(programs), rows))
    sizes = np.array([program.stepper.theta.size for program in programs], int)
    for size in np.unique(sizes):
        group = np.flatnonzero(sizes == size)
        each = [(programs[i], starts[i], clocks[i]) for i in group.tolist()]
        numbers = [_numbers(program, clock.dt, start.alpha) for program, start, clock in each]
        theta[group], omega[group] = _core.replay(
            start=np.array([start[:2] for _, start, _ in each]),
            terms=np.array([_terms(program, start) for program, start, _ in each]),
            force=np.array([int(getattr(_core.Force, program.force)) for program, *_ in each], np.int32),
            scale=np.array([program.scale for program, *_ in each]),
            dt=np.array([clock.dt for *_, clock in each]),
            stages=np.array([stages for stages, _ in numbers]),
            sums=np.array([sums for _, sums in numbers]),
            steps=np.array([_recorded(program, clock) for program, _, clock in each]),
            single=np.array([program.is_single for program, *_ in each]),
        )
    return Motion(theta, omega)


def _numbers(program: Program, dt: float, alpha: float) -> tuple[Floats, Floats]:
    """The stepper's coefficients, with those of accelerations without α less by that."""
    stages, sums = program.stepper.numbers(dt)
    if not program.bare:
        return stages, sums
    size, bare = program.stepper.theta.size, [STAGES.index(letter) for letter in program.bare]
    less = np.ones(size)
    less[bare] /= alpha
    angle, own_angle, own_velocity, velocity = np.split(stages[:, 3:], 4, axis=1)
    stages = np.hstack([stages[:, :3], angle, own_angle * less, own_velocity, velocity * less])
    return stages, np.hstack([sums[:, :size], sums[:, size:] * less])


def _terms(program: Program, start: Start) -> tuple[float, ...]:
    return (program.sign * (program.pull or start.alpha), program.beta, program.torque, *program.drive, 0.0)


def _recorded(program: Program, clock: Clock) -> Integers:
    """After how many steps each row's state is taken."""
    steps = clock.steps
    if program.rows_late and steps.size > 1:
        between = int(steps[-1] - steps[0]) // (steps.size - 1)
        steps = steps + program.rows_late * between
    steps = np.maximum(steps + program.steps_late, 0)
    if program.first_is_right:
        steps = np.append(clock.steps[:1], steps[1:])
    return steps


def problems(file: BinaryIO, lang: str = "en") -> list[Problem]:
    """The problems of a file as the program pendula reads them. RefusedError where it refuses them, with its own words."""
    text = file.read(MOST_CHARACTERS + 1)
    if len(text) > MOST_CHARACTERS:
        raise RefusedError(BAD_USAGE, TOO_LONG, MOST_CHARACTERS)
    # Comments are left out, and the units are the fifth and the seventh of eight values.
    tokens = [token for line in text.decode("latin-1").splitlines() for token in line.split("#")[0].split()]
    with TemporaryFile() as copy:
        copy.write(text)
        copy.seek(0)
        read = list(printed(["--dry-run", "--lang", lang], copy))
    return [_problem(values, tokens[8 * i + 4], tokens[8 * i + 6]) for i, values in enumerate(read)]


def _problem(values: dict[str, Any], theta0_unit: str, omega0_unit: str) -> Problem:
    same = {name: float(values[name]) for name in ("theta0", "omega0", "alpha", "dt", "every", "until", "tau", "rows")}
    theta_max = float(values["thetaM"])
    return Problem(**same, regime=int(values["k"]), theta_max=theta_max, theta0_unit=theta0_unit, omega0_unit=omega0_unit)
