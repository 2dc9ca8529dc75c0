"""How doubles are compared."""

import numpy as np


def same_bits(a, b):
    """Whether two arrays are the same doubles: 0 and -0 differ, NaN is NaN."""
    a, b = np.broadcast_arrays(np.asarray(a, float), np.asarray(b, float))
    return bool(np.all((a == b) & (np.signbit(a) == np.signbit(b)) | np.isnan(a) & np.isnan(b)))
