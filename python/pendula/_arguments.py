"""What people pass, made float64; the core says what is legal."""

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


def real(name: str, value: npt.ArrayLike) -> Any:
    """A float as it is, all else as an array of float64, without a copy where it is one already.

    What ufuncs would not take as real numbers raises TypeError: text, objects, complex numbers, dates.
    """
    if isinstance(value, float):
        return value
    array = np.asarray(value)
    if array.dtype == np.float64 and array.dtype.isnative:
        return array
    if not np.can_cast(array.dtype, np.float64, "same_kind"):
        raise TypeError(f"{name} must be real numbers, got {array.dtype} {np.array2string(array, threshold=4, edgeitems=2)}")
    return array.astype(np.float64)


class Parameters(NamedTuple):
    """Where pendulums start and which they are: floats, or arrays of float64 that broadcast."""

    theta0: Any
    """Initial angle [rad]."""
    omega0: Any
    """Initial angular velocity [rad/s]."""
    alpha: Any = 1.0
    """Stiffness g/l [s⁻²], positive."""
    beta: Any = 0.0
    """Damping [s⁻¹], not negative."""
    torque: Any = 0.0
    """Constant torque [s⁻²]."""
    drive_amplitude: Any = 0.0
    """[s⁻²]."""
    drive_frequency: Any = 0.0
    """Angular frequency [rad/s], not negative; positive where the amplitude is not 0."""
    drive_phase: Any = 0.0
    """[rad]."""

    @property
    def shape(self) -> tuple[int, ...]:
        """The common shape; () of a single pendulum."""
        return broadcast_shape(*self)

    @property
    def is_conservative(self) -> bool:
        """Whether none of them has friction or forcing, so that the closed form holds."""
        return not (np.any(self.beta) or np.any(self.torque) or np.any(self.drive_amplitude))

    def closed_form(self) -> dict[str, Any]:
        """The closed form's arguments, as they broadcast against times."""
        return {name: along_time(getattr(self, name)) for name in ("theta0", "omega0", "alpha")}


def parameters(**values: npt.ArrayLike) -> Parameters:
    """`Parameters` of what was passed under their names."""
    for name in values:
        if name not in Parameters._fields:
            raise TypeError(f"{name!r} is no parameter of a pendulum; they are {', '.join(Parameters._fields)}")
    return Parameters(**{name: real(name, value) for name, value in values.items()})


def broadcast_shape(*values: Any) -> tuple[int, ...]:
    """The common shape of floats and arrays."""
    return np.broadcast_shapes(*(value.shape for value in values if not isinstance(value, float)))


def column(values: Any, shape: tuple[int, ...]) -> Any:
    """Values broadcast to `shape`, one behind the other; a single one as a float."""
    if isinstance(values, float):
        return values
    if values.size == 1:
        return values.item()
    return np.require(np.broadcast_to(values, shape).reshape(-1), requirements=["C", "A"])


def chosen_members(values: Any, members: npt.NDArray[np.intp]) -> Any:
    """Those values of a column that belong to some members."""
    return values if isinstance(values, float) else values[members]


def along_time(values: Any) -> Any:
    """Values of pendulums as they broadcast against arrays whose last axis is time."""
    return values if isinstance(values, float) else values[..., np.newaxis]


def thread_count(threads: int | None) -> int:
    """As the core counts them: 0 for as many as there are processors."""
    if threads is not None and threads < 1:
        raise ValueError(f"threads must be at least 1, got {threads}")
    return threads or 0
