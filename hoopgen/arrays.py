"""Numbers from callers."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray


def doubles(name: str, value: ArrayLike, expected: str = "numbers") -> NDArray[np.float64]:
    """Return `value` as float64.

    Raises
    ------
    TypeError
        If it is not real numbers; the message begins with `name`.
    """
    try:
        array = np.asarray(value)
        if array.dtype == object:  # float() is stricter: NumPy makes a NaN of None
            array = np.array([float(v) for v in array.flat]).reshape(array.shape)
        if not np.iscomplexobj(array):
            return array.astype(np.float64, copy=False)
    except (TypeError, ValueError):
        pass
    raise TypeError(f"{name}: expected {expected}, got {value!r}")
