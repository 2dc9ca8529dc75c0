import enum
from collections.abc import Sequence
from typing import Annotated

import numpy
import numpy.typing
from numpy.typing import NDArray

version: str

class Rule(enum.Enum):
    """The intervals that parameters lie in."""

    finite = 0

    positive = 1

    not_negative = 2

    fraction = 3

class Parameter:
    """What there is to know of a parameter, or of an initial value."""

    @property
    def name(self) -> str: ...
    @property
    def symbol(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def default(self) -> float: ...
    @property
    def interval(self) -> Rule: ...
    @property
    def is_angle(self) -> bool: ...
    @property
    def is_initial(self) -> bool:
        """Of the start, not of the pendulum."""

class ResultColumn:
    """A column of results."""

    @property
    def name(self) -> str: ...
    @property
    def symbol(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def has_rows(self) -> bool:
        """More than one value."""

    @property
    def is_kind(self) -> bool:
        """The values are those of Kind."""

class Setting:
    """A number among the settings of a measure."""

    @property
    def name(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def default(self) -> float: ...

class Measure:
    """What there is to know of a measure."""

    @property
    def name(self) -> str: ...
    @property
    def meaning(self) -> str: ...
    @property
    def settings(self) -> tuple[Setting, ...]: ...
    @property
    def columns(self) -> tuple[ResultColumn, ...]: ...

parameters: tuple[Parameter, ...]

measures: tuple[Measure, ...]

jump_columns: tuple[ResultColumn, ...]

method_names: tuple[str, ...]

strobe_method_names: tuple[str, ...]

plane_names: tuple[str, ...]

direction_names: tuple[str, ...]

carry_names: tuple[str, ...]

class Status(enum.IntEnum):
    """How a program ends."""

    done = 0

    bad_data = 1

    bad_usage = 2

    not_written = 3

    interrupted = 130

def language_of(arguments: Sequence[str]) -> str:
    """The language of messages, as the program chooses it."""

def as_parameters(
    theta0: numpy.typing.ArrayLike | None = 0.0,
    omega0: numpy.typing.ArrayLike | None = 0.0,
    alpha: numpy.typing.ArrayLike | None = 1.0,
    beta: numpy.typing.ArrayLike | None = 0.0,
    torque: numpy.typing.ArrayLike | None = 0.0,
    drive_amplitude: numpy.typing.ArrayLike | None = 0.0,
    pivot_amplitude: numpy.typing.ArrayLike | None = 0.0,
    drive_frequency: numpy.typing.ArrayLike | None = 0.0,
    drive_phase: numpy.typing.ArrayLike | None = 0.0,
) -> tuple[float | numpy.typing.NDArray[numpy.float64], ...]:
    """What people pass, made float or float64 and known to broadcast."""

def are_conservative(
    theta0: numpy.typing.ArrayLike | None = 0.0,
    omega0: numpy.typing.ArrayLike | None = 0.0,
    alpha: numpy.typing.ArrayLike | None = 1.0,
    beta: numpy.typing.ArrayLike | None = 0.0,
    torque: numpy.typing.ArrayLike | None = 0.0,
    drive_amplitude: numpy.typing.ArrayLike | None = 0.0,
    pivot_amplitude: numpy.typing.ArrayLike | None = 0.0,
    drive_frequency: numpy.typing.ArrayLike | None = 0.0,
    drive_phase: numpy.typing.ArrayLike | None = 0.0,
) -> bool:
    """Whether none of them has friction or forcing."""

class Regime(enum.IntEnum):
    """The kinds of motion; the values are the assignment's k."""

    oscillation = -1

    separatrix = 0

    rotation = 1

def analyze(
    theta0: numpy.typing.ArrayLike | None, omega0: numpy.typing.ArrayLike | None, alpha: numpy.typing.ArrayLike | None = 1.0
) -> tuple[Regime | numpy.typing.NDArray[numpy.int8], numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]:
    """regime, theta_max and tau"""

def exact(
    theta0: numpy.typing.ArrayLike | None,
    omega0: numpy.typing.ArrayLike | None,
    t: numpy.typing.ArrayLike | None,
    alpha: numpy.typing.ArrayLike | None = 1.0,
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]:
    """theta, not wrapped, and omega"""

def states(
    theta0: numpy.typing.ArrayLike | None,
    omega0: numpy.typing.ArrayLike | None,
    alpha: numpy.typing.ArrayLike | None,
    t: numpy.typing.ArrayLike | None,
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]:
    """theta in [-π, π), omega and turns"""

def sine(
    theta0: numpy.typing.ArrayLike | None,
    omega0: numpy.typing.ArrayLike | None,
    alpha: numpy.typing.ArrayLike | None,
    t: numpy.typing.ArrayLike | None,
) -> numpy.typing.NDArray[numpy.float64]:
    """the sinusoid (3.4), in [-π, π)"""

def energy(
    theta: numpy.typing.ArrayLike | None, omega: numpy.typing.ArrayLike | None, alpha: numpy.typing.ArrayLike | None
) -> numpy.typing.NDArray[numpy.float64]: ...
def amplitude(
    tau: numpy.typing.ArrayLike | None, alpha: numpy.typing.ArrayLike | None = 1.0
) -> numpy.typing.NDArray[numpy.float64]:
    """the inverse of analyze for oscillations"""

def stiffness(
    gravity: numpy.typing.ArrayLike | None, length: numpy.typing.ArrayLike | None
) -> numpy.typing.NDArray[numpy.float64]:
    """gravity/length"""

def to_radians(degrees: numpy.typing.ArrayLike | None) -> numpy.typing.NDArray[numpy.float64]: ...
def wrap(theta: numpy.typing.ArrayLike | None) -> numpy.typing.NDArray[numpy.float64]: ...
def unwrap(
    theta: numpy.typing.ArrayLike | None, turns: numpy.typing.ArrayLike | None
) -> numpy.typing.NDArray[numpy.float64]: ...
def solve(
    *,
    t: numpy.typing.ArrayLike | None = None,
    until: numpy.typing.ArrayLike | None = None,
    every: numpy.typing.ArrayLike | None = None,
    dt: numpy.typing.ArrayLike | None = None,
    method: str | None = "rk4",
    tolerance: float | None = 1e-15,
    threads: int | None = None,
    theta0: numpy.typing.ArrayLike | None = 0.0,
    omega0: numpy.typing.ArrayLike | None = 0.0,
    alpha: numpy.typing.ArrayLike | None = 1.0,
    beta: numpy.typing.ArrayLike | None = 0.0,
    torque: numpy.typing.ArrayLike | None = 0.0,
    drive_amplitude: numpy.typing.ArrayLike | None = 0.0,
    pivot_amplitude: numpy.typing.ArrayLike | None = 0.0,
    drive_frequency: numpy.typing.ArrayLike | None = 0.0,
    drive_phase: numpy.typing.ArrayLike | None = 0.0,
) -> tuple[
    numpy.typing.NDArray[numpy.float64],
    numpy.typing.NDArray[numpy.float64],
    numpy.typing.NDArray[numpy.float64],
    numpy.typing.NDArray[numpy.float64],
    float | numpy.typing.NDArray[numpy.float64] | None,
    tuple[float | numpy.typing.NDArray[numpy.float64], ...],
]: ...
def crossings(
    *,
    until: numpy.typing.ArrayLike | None,
    of: str | None = "theta",
    at: numpy.typing.ArrayLike | None = 0.0,
    direction: str | None = "both",
    tolerance: float | None = 1e-15,
    threads: int | None = None,
    theta0: numpy.typing.ArrayLike | None = 0.0,
    omega0: numpy.typing.ArrayLike | None = 0.0,
    alpha: numpy.typing.ArrayLike | None = 1.0,
    beta: numpy.typing.ArrayLike | None = 0.0,
    torque: numpy.typing.ArrayLike | None = 0.0,
    drive_amplitude: numpy.typing.ArrayLike | None = 0.0,
    pivot_amplitude: numpy.typing.ArrayLike | None = 0.0,
    drive_frequency: numpy.typing.ArrayLike | None = 0.0,
    drive_phase: numpy.typing.ArrayLike | None = 0.0,
) -> tuple[
    numpy.typing.NDArray[numpy.float64],
    numpy.typing.NDArray[numpy.float64],
    numpy.typing.NDArray[numpy.float64],
    numpy.typing.NDArray[numpy.float64],
]: ...
def measured_period(
    *,
    until: numpy.typing.ArrayLike | None,
    tolerance: float | None = 1e-15,
    threads: int | None = None,
    theta0: numpy.typing.ArrayLike | None = 0.0,
    omega0: numpy.typing.ArrayLike | None = 0.0,
    alpha: numpy.typing.ArrayLike | None = 1.0,
    beta: numpy.typing.ArrayLike | None = 0.0,
    torque: numpy.typing.ArrayLike | None = 0.0,
    drive_amplitude: numpy.typing.ArrayLike | None = 0.0,
    pivot_amplitude: numpy.typing.ArrayLike | None = 0.0,
    drive_frequency: numpy.typing.ArrayLike | None = 0.0,
    drive_phase: numpy.typing.ArrayLike | None = 0.0,
) -> numpy.typing.NDArray[numpy.float64]: ...

class Kind(enum.IntEnum):
    """
    What becomes of a motion in the long run. `Kind(k).name` is the word for a value of an array of kinds.
    """

    unsettled = 0
    """None of the others up to the budget."""

    fixed_point = 1
    """
    At rest: at the bottom, where torque and gravity balance, or at the top.
    """

    periodic = 2
    """On a periodic orbit of the strobe map."""

    rotating = 3
    """Without drive: a limit cycle that turns over and over."""

    quasi_periodic = 4
    """On an orbit that fills a curve: the exponent is 0 within its error."""

    chaotic = 5
    """The exponent is above three times its error."""

    conservative = 6
    """
    Without friction, drive and shaken pivot: the energy stays, and nothing is approached.
    """

    unbounded = 7
    """Without friction: a torque accelerates the motion for ever."""

    lost = 8
    """The motion leaves the range of doubles."""

def measure(
    measure: str | None,
    settings: dict[str, object],
    *,
    carry: str | None = None,
    threads: int | None = None,
    theta0: numpy.typing.ArrayLike | None = 0.0,
    omega0: numpy.typing.ArrayLike | None = 0.0,
    alpha: numpy.typing.ArrayLike | None = 1.0,
    beta: numpy.typing.ArrayLike | None = 0.0,
    torque: numpy.typing.ArrayLike | None = 0.0,
    drive_amplitude: numpy.typing.ArrayLike | None = 0.0,
    pivot_amplitude: numpy.typing.ArrayLike | None = 0.0,
    drive_frequency: numpy.typing.ArrayLike | None = 0.0,
    drive_phase: numpy.typing.ArrayLike | None = 0.0,
) -> tuple[numpy.typing.NDArray[numpy.float64], ...]: ...
def jumps(
    along: str | None,
    jump_tolerance: float | None,
    settings: dict[str, object],
    *,
    carry: str | None,
    threads: int | None = None,
    theta0: numpy.typing.ArrayLike | None = 0.0,
    omega0: numpy.typing.ArrayLike | None = 0.0,
    alpha: numpy.typing.ArrayLike | None = 1.0,
    beta: numpy.typing.ArrayLike | None = 0.0,
    torque: numpy.typing.ArrayLike | None = 0.0,
    drive_amplitude: numpy.typing.ArrayLike | None = 0.0,
    pivot_amplitude: numpy.typing.ArrayLike | None = 0.0,
    drive_frequency: numpy.typing.ArrayLike | None = 0.0,
    drive_phase: numpy.typing.ArrayLike | None = 0.0,
) -> tuple[numpy.typing.NDArray[numpy.float64], ...]: ...
def share_error(
    count: numpy.typing.ArrayLike | None, trials: numpy.typing.ArrayLike | None
) -> numpy.typing.NDArray[numpy.float64]: ...

class Force(enum.IntEnum):
    """What a program has in the place of the sine."""

    sine = 0

    cosine = 1

    linear = 2

    cubic = 3

    quintic = 4

def replay(
    start: Annotated[NDArray[numpy.float64], {"shape": (None, None), "order": "C", "device": "cpu", "writable": False}],
    terms: Annotated[NDArray[numpy.float64], {"shape": (None, None), "order": "C", "device": "cpu", "writable": False}],
    force: Annotated[NDArray[numpy.int32], {"shape": (None,), "order": "C", "device": "cpu", "writable": False}],
    scale: Annotated[NDArray[numpy.float64], {"shape": (None,), "order": "C", "device": "cpu", "writable": False}],
    dt: Annotated[NDArray[numpy.float64], {"shape": (None,), "order": "C", "device": "cpu", "writable": False}],
    stages: Annotated[NDArray[numpy.float64], {"shape": (None, None, None), "order": "C", "device": "cpu", "writable": False}],
    sums: Annotated[NDArray[numpy.float64], {"shape": (None, None, None), "order": "C", "device": "cpu", "writable": False}],
    steps: Annotated[NDArray[numpy.int64], {"shape": (None, None), "order": "C", "device": "cpu", "writable": False}],
    single: Annotated[NDArray[numpy.bool_], {"shape": (None,), "order": "C", "device": "cpu", "writable": False}],
    threads: int = 0,
) -> tuple[numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]:
    """
    Rows of programs that make steps by numbers (pendula/replay.hpp): theta, not wrapped, and omega, [program, row].
    """
