"""What people pass, made float64."""

from typing import Any

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
