"""The C engine through ctypes; calls release the interpreter's lock.

It serves if it was built from the sources that are here and gave NumPy's bits (`verification`).
"""

from __future__ import annotations

import ctypes
import math
import operator
import struct
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from enum import IntEnum
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import arithmetic, c_build, verification
from .result_arrays import LOG, ResultArrays
from .verification import WIDTHS, Batch

__all__ = ["WIDTHS", "Library", "Rejection", "Share", "check_library"]


class Error(IntEnum):
    """Error codes that a call returns instead of a width, as in the header."""

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


ENVIRONMENT_WORDS = 8
"""Words of a floating-point environment, as in the header."""

_EMPTY = ctypes.c_char * 0
"""A type of size 0, so that it also fits an array without shots."""


_REINSTALL = "install again without CFLAGS and LDFLAGS of your own"


@dataclass
class Share:
    """The part of the shots that a thread takes of those that several run.

    Attributes
    ----------
    parts
        A thread takes one part in so many of the remaining shots at a time.
    next
        The first shot that no thread has begun.
    """

    parts: int = 1
    next: ctypes.c_size_t = field(default_factory=ctypes.c_size_t)


@dataclass(frozen=True)
class _CallArguments:
    """Parameters as the library takes them, which the next call mostly takes again.

    Attributes
    ----------
    values
        The parameters; none if any is an array, which would live on.
    numbers
        The numbers that pointers point to.
    pointers, strides
        By parameter, the place of its values, and the step from one shot's to the next one's.
    """

    values: Sequence[NDArray[np.float64] | float]
    numbers: ctypes.Array[ctypes.c_double]
    pointers: ctypes.Array[ctypes.c_void_p]
    strides: ctypes.Array[ctypes.c_int64]


class Library:
    """A compiled scene.

    Parameters
    ----------
    path
        The shared library.
    kernels
        The generated NumPy module of its scene. Names of C functions begin with the scene's name.

    Raises
    ------
    OSError
        If it cannot be loaded.
    """

    def __init__(self, path: Path, kernels: ModuleType) -> None:
        scene: str = kernels.SCENE
        self._arrays = (*(result.name for result in kernels.RESULTS), *LOG)
        self._results = struct.Struct(f"{len(self._arrays)}P")
        count = len(kernels.PARAMETERS)
        self._numbers = ctypes.c_double * count
        self._pointers = ctypes.c_void_p * count
        self._strides = ctypes.c_int64 * count
        self._last = self._arguments([0.0] * count)
        self._scene, self._library = scene, ctypes.CDLL(str(path))
        self._simulate = getattr(self._library, f"{scene}_share")
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
        self._sources = getattr(self._library, f"{scene}_sources", None)
        if self._sources is not None:
            self._sources.restype = ctypes.c_char_p

    @property
    def sources(self) -> str:
        """The digest of the sources that the build stored; "" of an older build."""
        return "" if self._sources is None else self._sources().decode()

    @property
    def results(self) -> tuple[str, ...]:
        """The names of the arrays in the order of the struct of results; the event log is last."""
        return self._arrays

    @property
    def function(self) -> int:
        """The address of the scene's function for several threads, as in its header."""
        return ctypes.cast(self._simulate, ctypes.c_void_p).value or 0

    def _arguments(self, parameters: Sequence[NDArray[np.float64] | float]) -> _CallArguments:
        """Return the parameters as the library takes them."""
        numbers = self._numbers(*[p if isinstance(p, float) else 0.0 for p in parameters])
        start = ctypes.addressof(numbers)
        pointers = self._pointers(*range(start, start + ctypes.sizeof(numbers), 8))
        strides = self._strides()
        rows = [(k, own) for k, own in enumerate(parameters) if not isinstance(own, float)]
        for k, own in rows:
            pointers[k], strides[k] = _address(own), 1
        return _CallArguments(() if rows else tuple(parameters), numbers, pointers, strides)

    @cached_property
    def missing_width(self) -> int:
        """The width of its build, if this processor lacks it and one lane serves; else 0."""
        return int(getattr(self._library, f"{self._scene}_missing_width")())

    @contextmanager
    def default_environment(self) -> Iterator[None]:
        """Set this thread's default floating-point environment; restore the earlier one at exit."""
        before = (ctypes.c_uint64 * ENVIRONMENT_WORDS)()
        getattr(self._library, f"{self._scene}_enter")(before)
        try:
            yield
        finally:
            getattr(self._library, f"{self._scene}_leave")(before)

    def run(
        self,
        states: NDArray[np.float64],
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        max_contacts: int,
        out: ResultArrays,
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
            Vector lanes; 0 for the widest, or for one lane if there is one shot.
        time_limit
            Time since the release at which a shot ends, s; infinite: none.
        share
            The share of threads that run the same shots into the same `out`, of which each runs
            some; None: this call runs all.

        Raises
        ------
        ValueError
            If the library does not have that width, or another argument is not as described.
        RuntimeError
            If doubles are not computed as IEEE 754 says, because of how it was built.
        MemoryError
            If there is no memory for the shots in flight.
        """
        given = self._last
        if len(given.values) != len(parameters) or not all(
            map(operator.is_, given.values, parameters)
        ):
            given = self._last = self._arguments(parameters)
        arrays = out.arrays
        # As `_address`, without a call for each array: all of these can be written.
        addresses = [
            ctypes.addressof(_EMPTY.from_buffer(arrays[name])) if name in arrays else 0  # type: ignore[arg-type]
            for name in self._arrays
        ]
        share = share or Share()
        used = self._simulate(
            len(states),
            _address(states),
            given.pointers,
            given.strides,
            None if leaving is None else _address(leaving),
            max_contacts,
            time_limit,
            width,
            _address(stop),
            self._results.pack(*addresses),
            ctypes.byref(share.next),
            share.parts,
        )
        if used >= 0:
            return
        if used == Error.ARITHMETIC:
            raise verification.InexactBuildError(
                "the C engine was built with flags that change arithmetic"
            )
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


def _address(array: NDArray[Any]) -> int:
    """Return the address of an array's data; `ndarray.ctypes` takes four times as long."""
    try:
        return ctypes.addressof(_EMPTY.from_buffer(array))  # type: ignore[arg-type]
    except (TypeError, ValueError, BufferError):  # it must not be written
        return array.__array_interface__["data"][0]  # type: ignore[no-any-return]


@dataclass(frozen=True)
class Rejection:
    """The reason why there is no C engine, and a remedy; both continue "the C engine"."""

    reason: str
    remedy: str


def check_library(
    path: Path, kernels: ModuleType, c_sources: Path, shots: Callable[[], Sequence[Batch]]
) -> Library | Rejection:
    """Return the C engine of a library that comes with hoopgen, or the reason to reject it.

    Parameters
    ----------
    path
        The shared library.
    kernels
        The generated NumPy module of its scene.
    c_sources
        The folder of the sources that it should have been built from.
    shots
        Function that returns the shots with which it is compared with NumPy.
    """
    was_exact = arithmetic.is_exact()
    try:
        library = Library(path, kernels)
    except (OSError, AttributeError):
        return Rejection("was not built", "install again with a C compiler")
    if was_exact and not arithmetic.is_exact():
        return Rejection("makes subnormals zero in this process when it is loaded", _REINSTALL)
    # Without the sources, as in a bundle, there is nothing that could be newer.
    if c_build.source_digest(c_sources, kernels.SCENE) not in ("", library.sources):
        return Rejection("was built from other sources than these", "`pip install -e .` again")
    with library.default_environment():
        differences = verification.verify(path, library, kernels, shots())
    if differences:
        return Rejection(f"does not give NumPy's results ({differences})", _REINSTALL)
    return library
