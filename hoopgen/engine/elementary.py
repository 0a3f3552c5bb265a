"""Sine, cosine, tangent, arc tangent, hypotenuse and normal quantile, the same on every processor.

NumPy's and SciPy's own differ in their last bits between processors and versions. These are
generated (`derive/elementary`): in C if the library that was built with hoopgen gives NumPy's bits,
else in NumPy. What draws or aims releases uses them, so that a seed has the same shots everywhere.
"""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.generated.numpy import elementary as generated

from . import c_build
from .native import ENVIRONMENT_WORDS

Floats = NDArray[np.float64]

_BLOCK = 1 << 13
"""Numbers that NumPy computes at a time: their intermediate values fit into the caches."""

_FUNCTIONS = list(generated.FUNCTIONS)

_SAMPLE = np.array(
    [*np.linspace(-7.0, 7.0, 301), *np.geomspace(1e-300, 1e6, 200), 0.0, -0.0, 2.0**21, np.nan]
)


class Library:
    """The compiled elementary functions.

    Parameters
    ----------
    path
        The shared library.

    Raises
    ------
    OSError, AttributeError
        If it cannot be loaded.
    """

    def __init__(self, path: Path) -> None:
        library = ctypes.CDLL(str(path))
        self._compute = library.elementary_compute
        self._compute.restype = ctypes.c_int
        self._compute.argtypes = [
            ctypes.c_int,
            ctypes.c_size_t,
            ctypes.c_void_p,
            ctypes.c_void_p,
            ctypes.c_int,
        ]
        self._noise, self._states = library.elementary_noise, library.elementary_release_states
        self._noise.restype = self._states.restype = ctypes.c_int
        self._noise.argtypes = [
            *(ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p),
            *(ctypes.c_uint64, ctypes.c_uint64, ctypes.c_size_t, ctypes.c_void_p, ctypes.c_int),
        ]
        self._states.argtypes = [
            *(ctypes.c_size_t, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double),
            *(ctypes.c_void_p, ctypes.c_int),
        ]
        library.elementary_sources.restype = ctypes.c_char_p
        self.sources: str = library.elementary_sources().decode()
        self._enter, self._leave = library.elementary_enter, library.elementary_leave

    @contextmanager
    def default_environment(self) -> Iterator[None]:
        """Set this thread's default floating-point environment; restore the earlier one at exit."""
        before = (ctypes.c_uint64 * ENVIRONMENT_WORDS)()
        self._enter(before)
        try:
            yield
        finally:
            self._leave(before)

    def compute(
        self, name: str, arguments: Sequence[Floats], results: Sequence[Floats], width: int = 0
    ) -> int:
        """Write a function's results, and return the number of doubles in a vector.

        Parameters
        ----------
        name
            The function.
        arguments, results
            (n,) each, contiguous.
        width
            Doubles in a vector: 2, 4 or 8; 0 for the widest that the processor has.

        Returns
        -------
        int
            The width; -1 if the processor or the build lacks it, and nothing is written.
        """
        number, count = _FUNCTIONS.index(name), len(results[0])
        return int(self._compute(number, count, _places(arguments), _places(results), width))

    def noise(
        self,
        streams: NDArray[np.uint64],
        factor: Floats,
        deviations: Floats,
        seed: int,
        start: int,
        noise: Floats,
        width: int = 0,
    ) -> int:
        """Write the noise of variables, and return as `compute` does.

        Parameters
        ----------
        streams, factor, deviations
            (k,), (k, k) and (k,), as of `hoopgen.engine.draws.Noise`.
        seed
            From 0 to 2^64 - 1.
        start
            The first shot; the last one is below 2^64.
        noise
            (k, shots), contiguous.
        width
            As of `compute`.
        """
        count = noise.shape[1]
        given = [np.ascontiguousarray(one) for one in (streams, factor, deviations)]
        places = [one.ctypes.data for one in given]
        return int(self._noise(len(noise), *places, seed, start, count, _places(noise), width))

    def release_states(
        self, arguments: Sequence[Floats], ring: float, states: Floats, width: int = 0
    ) -> int:
        """Write the states of releases, and return as `compute` does.

        Parameters
        ----------
        arguments
            `hoopgen.engine.draws.ARGUMENTS`: (n,), contiguous, or one number.
        ring
            The height of the ring above the floor, m.
        states
            (n, 9), contiguous.
        width
            As of `compute`.
        """
        strides = (ctypes.c_int64 * len(arguments))(*(one.size != 1 for one in arguments))
        place = states.ctypes.data
        return int(self._states(len(states), _places(arguments), strides, ring, place, width))


def _places(arrays: Iterable[NDArray[Any]]) -> ctypes.Array[ctypes.c_void_p]:
    """Return the addresses of the first values of arrays."""
    places = [array.ctypes.data for array in arrays]
    return (ctypes.c_void_p * len(places))(*places)


@cache
def library(sources: Path | None = None) -> Library | None:
    """Return the compiled functions; None if they were not built, or give other bits than NumPy.

    They are of the C sources in a folder, by default that of the generated module.
    """
    try:
        found = Library(Path(__file__).with_name("_elementary.so"))
    except (OSError, AttributeError):
        return None
    sources = sources or Path(str(generated.__file__)).parents[1] / "c"
    if c_build.source_digest(sources, "elementary") not in ("", found.sources):
        return None
    with found.default_environment():
        agrees = all(_agrees(found, name) for name in _FUNCTIONS)
    return found if agrees else None


def _agrees(found: Library, name: str) -> bool:
    """Return whether C has the bits of NumPy in a function, or NaN in the same places."""
    arguments, outputs = generated.FUNCTIONS[name]
    given = [np.roll(_SAMPLE, shift) for shift in range(len(arguments))]
    results = [np.empty(len(_SAMPLE)) for _ in outputs]
    found.compute(name, given, results)
    expected = _in_numpy(name, given)
    return all(map(np.array_equal, results, expected, [True] * len(results)))


def _in_numpy(name: str, arguments: Sequence[Floats]) -> list[Floats]:
    """Return a function's results of arrays (n,), computed in NumPy."""
    count = len(arguments[0])
    results = [np.empty(count) for _ in generated.FUNCTIONS[name][1]]
    with np.errstate(all="ignore"):
        for start in range(0, count, _BLOCK):
            part = slice(start, start + _BLOCK)
            values = getattr(generated, name)(*(argument[part] for argument in arguments))
            for result, value in zip(results, values, strict=True):
                result[part] = value
    return results


def _evaluate(name: str, *arguments: ArrayLike) -> list[Floats]:
    """Return a function's results of arguments that broadcast."""
    given = np.broadcast_arrays(*(np.asarray(argument, np.float64) for argument in arguments))
    shape = given[0].shape
    flat = [np.ascontiguousarray(argument).reshape(-1) for argument in given]
    compiled = library()
    if compiled is None:
        results = _in_numpy(name, flat)
    else:
        results = [np.empty(len(flat[0])) for _ in generated.FUNCTIONS[name][1]]
        compiled.compute(name, flat, results)
    return [result.reshape(shape)[()] for result in results]


def sine_cosine(angle: ArrayLike) -> tuple[Floats, Floats]:
    """Return the sine and the cosine of angles, rad; infinite beyond 2^20 rad.

    Returns
    -------
    tuple of ndarray
        In the shape of the angles, each within one unit in the last place.
    """
    sine, cosine = _evaluate("sine_cosine", angle)
    return sine, cosine


def tangent(angle: ArrayLike) -> Floats:
    """Return the tangent of angles, rad, within four units in the last place."""
    return _evaluate("tangent", angle)[0]


def arc_tangent(ordinate: ArrayLike, abscissa: ArrayLike = 1.0) -> Floats:
    """Return angles of points from the axis of abscissas, -π to π; 0 at the origin.

    Parameters
    ----------
    ordinate, abscissa
        Coordinates, which broadcast.

    Returns
    -------
    ndarray
        rad, within two units in the last place.
    """
    return _evaluate("arc_tangent", ordinate, abscissa)[0]


def hypotenuse(ordinate: ArrayLike, abscissa: ArrayLike) -> Floats:
    """Return distances of points from the origin, within one unit in the last place.

    Parameters
    ----------
    ordinate, abscissa
        Coordinates, which broadcast.
    """
    return _evaluate("hypotenuse", ordinate, abscissa)[0]


def normal_quantile(probability: ArrayLike) -> Floats:
    """Return the standard normal numbers below which are given probabilities.

    Parameters
    ----------
    probability
        Within 0 and 1, multiples of 2^-53.

    Returns
    -------
    ndarray
        In the shape of the probabilities, within six units in the last place.
    """
    return _evaluate("normal_quantile", probability)[0]
