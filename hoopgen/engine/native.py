"""The C engine, through ctypes: no call holds the interpreter's lock.

It serves if it was built from the sources that are here, and has given NumPy's bits (trust.py).
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import arithmetic, sources, trust
from .raw import LOG, Raw
from .trust import WIDTHS, Batch

__all__ = ["WIDTHS", "Library", "Refused", "Share", "checked"]


class Error(IntEnum):
    """Codes that a call returns instead of a width, with nothing run, as in the header."""

    WIDTH = -1
    ARITHMETIC = -2
    MEMORY = -3
    SHOTS = -4
    STATES = -5
    PARAMETERS = -6
    STRIDES = -7
    LEAVING = -8
    MAX_CONTACTS = -9
    TIME_LIMIT = -10
    RESULTS = -11
    EVENTS = -12
    NEXT = -13
    PARTS = -14


_NOTHING = ctypes.c_char * 0
"""Of no size, so that it may begin wherever an array does, without shots too."""


_AGAIN = "install again without CFLAGS and LDFLAGS of your own"


@dataclass
class Share:
    """How threads that run the same shots share them.

    Attributes
    ----------
    parts
        Which part of the shots that are left a thread takes at a time.
    next
        The first shot that none has begun.
    """

    parts: int = 1
    next: ctypes.c_size_t = field(default_factory=ctypes.c_size_t)


class Library:
    """A compiled scene.

    Parameters
    ----------
    path
        The shared library.
    kernels
        The generated NumPy module of its scene: its name, which those of the functions begin with,
        and its table of results.

    Raises
    ------
    OSError
        If it cannot be loaded.
    """

    def __init__(self, path: Path, kernels: ModuleType) -> None:
        scene: str = kernels.SCENE
        self._arrays = (*(result.name for result in kernels.RESULTS), *LOG)
        self._results: type[ctypes.Structure] = type(
            "Results",
            (ctypes.Structure,),
            {"_fields_": [(name, ctypes.c_void_p) for name in self._arrays]},
        )
        count = len(kernels.PARAMETERS)
        self._numbers = ctypes.c_double * count
        self._pointers = ctypes.c_void_p * count
        self._strides = ctypes.c_int64 * count
        library = ctypes.CDLL(str(path))
        self._simulate = getattr(library, f"{scene}_share")
        self._simulate.restype = ctypes.c_int
        self._simulate.argtypes = [
            ctypes.c_size_t,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_int32,
            ctypes.c_double,
            ctypes.c_int,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_size_t,
        ]
        self._sources = getattr(library, f"{scene}_sources", None)
        if self._sources is not None:
            self._sources.restype = ctypes.c_char_p

    @property
    def sources(self) -> str:
        """What the build said of the sources; "" if it is older than that."""
        return "" if self._sources is None else self._sources().decode()

    def run(
        self,
        states: NDArray[np.float64],
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        max_contacts: int,
        out: Raw,
        stop: NDArray[np.int32],
        width: int = 0,
        time_limit: float = math.inf,
        share: Share | None = None,
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
        time_limit
            Time since the release at which a shot ends, s; infinite: none.
        share
            What it has in common with other threads that run the same shots into the same `out`,
            of which each then runs some; None: it runs all.

        Raises
        ------
        ValueError
            If that width is not there, or another argument is not as described.
        RuntimeError
            If doubles are not computed as IEEE 754 says: in this thread, or by how it was built.
        MemoryError
            If there is none for the shots in flight.
        """
        rows = [(k, own) for k, own in enumerate(parameters) if not isinstance(own, float)]
        numbers = self._numbers(*[p if isinstance(p, float) else 0.0 for p in parameters])
        start = ctypes.addressof(numbers)
        pointers = self._pointers(*range(start, start + ctypes.sizeof(numbers), 8))
        strides = self._strides()
        for k, own in rows:
            pointers[k], strides[k] = _address(own), 1
        arrays = out.arrays
        results = self._results(*[_address(arrays.get(name)) for name in self._arrays])
        share = share or Share()
        used = self._simulate(
            len(states),
            _address(states),
            pointers,
            strides,
            _address(leaving),
            max_contacts,
            time_limit,
            width,
            _address(stop),
            ctypes.byref(results),
            ctypes.byref(share.next),
            share.parts,
        )
        if used >= 0:
            return
        if used == Error.ARITHMETIC:
            arithmetic.check_arithmetic()
            raise RuntimeError("the C engine was built with flags that change arithmetic")
        if used == Error.MEMORY:
            raise MemoryError("there is no memory for the shots in flight")
        said = {
            Error.WIDTH: f"width {width}: this processor or build does not have it",
            Error.SHOTS: f"states: expected no more rows than fit in memory, got {len(states):,}",
            Error.LEAVING: "leaving: expected -1 or the index of a surface for each shot",
            Error.MAX_CONTACTS: f"max_contacts: expected at least 1, got {max_contacts}",
            Error.TIME_LIMIT: f"time_limit: expected more than 0 s, got {time_limit}",
            Error.EVENTS: "out: expected both `events` and `event_counts` or neither, and a log "
            f"that fits in memory; got {', '.join(arrays)} and max_contacts {max_contacts}",
            Error.PARTS: f"share: expected at least 1 part, got {share.parts}",
        }
        raise ValueError(said.get(used, f"the C engine refuses its arguments, with code {used}"))


def _address(array: NDArray[Any] | None) -> int | None:
    """Return where an array's data begin; `ndarray.ctypes` takes four times as long to say."""
    if array is None:
        return None
    try:
        return ctypes.addressof(_NOTHING.from_buffer(array))  # type: ignore[arg-type]
    except (TypeError, ValueError, BufferError):  # it must not be written
        return array.__array_interface__["data"][0]  # type: ignore[no-any-return]


@dataclass(frozen=True)
class Refused:
    """Why there is no C engine, and what to do: both go on after "the C engine"."""

    reason: str
    remedy: str


def checked(
    path: Path, kernels: ModuleType, c_sources: Path, shots: Sequence[Batch]
) -> Library | Refused:
    """Return the engine of a library that came with hoopgen, or why it cannot be trusted.

    Parameters
    ----------
    path
        The shared library.
    kernels
        The generated NumPy module of its scene.
    c_sources
        The folder of what it should have been built from.
    shots
        With which it is compared with NumPy.

    Raises
    ------
    RuntimeError
        If this thread does not compute doubles as IEEE 754 says, so that nothing can be compared.
    """
    arithmetic.check_arithmetic()
    try:
        library = Library(path, kernels)
    except (OSError, AttributeError):
        return Refused("was not built", "install again with a C compiler")
    if not arithmetic.exact():
        return Refused("makes subnormals zero in this process when it is loaded", _AGAIN)
    # Without the sources, as in a bundle, there is nothing that could be newer.
    if sources.word(c_sources, kernels.SCENE) not in ("", library.sources):
        return Refused("was built from other sources than these", "`pip install -e .` again")
    differences = trust.trusted(path, library, kernels, shots)
    if differences:
        return Refused(f"does not give NumPy's results ({differences})", _AGAIN)
    return library
