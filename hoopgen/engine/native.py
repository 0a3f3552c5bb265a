"""The C engine, through ctypes: no call holds the interpreter's lock."""

from __future__ import annotations

import ctypes
import importlib.machinery
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy.hoop import RESULTS

from .raw import LOG, Raw

WIDTHS = (1, 2, 4, 8)
"""Vector widths that the source can be built for; which there are depends on the processor."""

_ARRAYS = (*(result.name for result in RESULTS), *LOG)
"""Pointers of the C struct, in order."""


class _Results(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in _ARRAYS]


class Library:
    """A compiled scene.

    Parameters
    ----------
    path
        The shared library.
    scene
        Name of the scene, which its functions' names begin with.

    Raises
    ------
    OSError
        If it cannot be loaded.
    """

    def __init__(self, path: Path, scene: str) -> None:
        library = ctypes.CDLL(str(path))
        self._simulate = getattr(library, f"{scene}_simulate")
        self._simulate.restype = ctypes.c_int
        self._simulate.argtypes = [
            ctypes.c_size_t,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_int32,
            ctypes.c_int,
            ctypes.c_void_p,
            ctypes.c_void_p,
        ]

    def run(
        self,
        states: NDArray[np.float64],
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        max_contacts: int,
        out: Raw,
        stop: NDArray[np.int32],
        width: int = 0,
    ) -> None:
        """Simulate shots and write what `out` has room for.

        Parameters
        ----------
        states
            (n, 9), C order.
        parameters
            Each a number or (n,), contiguous.
        leaving
            (n,), the surface that each shot touches at the start and leaves, -1 for none.
        stop
            (1,); a nonzero value from another thread ends the run early.
        width
            Vector lanes, 0 for the widest.

        Raises
        ------
        ValueError
            If that width is not there.
        """
        count = len(parameters)
        shared = [p if isinstance(p, float) else 0.0 for p in parameters]
        numbers = (ctypes.c_double * count)(*shared)
        start = ctypes.addressof(numbers)
        pointers = (ctypes.c_void_p * count)(
            *(
                start + 8 * k if isinstance(p, float) else _address(p)
                for k, p in enumerate(parameters)
            )
        )
        strides = (ctypes.c_int64 * count)(*(not isinstance(p, float) for p in parameters))
        results = _Results(*(_address(getattr(out, name)) for name in _ARRAYS))
        used = self._simulate(
            len(states),
            _address(states),
            pointers,
            strides,
            _address(leaving),
            max_contacts,
            width,
            _address(stop),
            ctypes.byref(results),
        )
        if used < 0:
            raise ValueError(f"width {width}: this processor or build does not have it")


def _address(array: NDArray[Any] | None) -> int | None:
    """Return where an array's data begin; `ndarray.ctypes` takes four times as long to say."""
    return None if array is None else array.__array_interface__["data"][0]


@cache
def installed() -> Library | None:
    """Return the hoop's compiled engine, or None where it was not built."""
    suffix = importlib.machinery.EXTENSION_SUFFIXES[0]
    path = Path(__file__).with_name("_hoop" + suffix)
    try:
        return Library(path, "hoop")
    except OSError:
        return None
