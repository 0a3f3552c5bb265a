"""Noise and states of releases: in C where its library serves, else in NumPy, the same bits.

Philox (Salmon et al. 2011, *Parallel random numbers: as easy as 1, 2, 3*) is keyed by the seed and
a stream, and counts shots. The other operations are those of `derive/studies` and
`derive/elementary`. In C one call draws the noise of all variables of a block of shots, and one
makes their states; what lies between two operations stays in the nearest cache.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.variables import STATE
from hoopgen.generated.numpy import studies

from . import array_pool, elementary

Floats = NDArray[np.float64]

ARGUMENTS = (
    *("speed", "elevation", "azimuth", "backspin", "sidespin"),
    *("height", "distance", "angle"),
)
"""The arguments of a release, in the order of the C library."""

_OF_STATE = ("speed", "backspin", "sidespin", "height", "distance")
"""Arguments of the kernel of states, beside angles."""

_WORDS = 4
"""64-bit words that one step of Philox's counter gives."""

_SKIPPED_BITS = np.uint64(12)
"""Bits of a word that a uniform number does not use."""

_MAX_SHOT = 2**64
"""The first shot that the C library cannot count; NumPy draws it and those after it."""

_SAMPLE, _SEED, _START = 301, 2**63 + 5, 2**40 + 3
"""Shots with which C is compared with NumPy: their number, their seed and the first one."""


def uniforms(seed: int, stream: int, start: int, stop: int) -> Floats:
    """Return numbers of shots `start` to `stop` - 1, uniform in the open interval (0, 1).

    Parameters
    ----------
    seed, stream
        From 0 to 2^64 - 1; the halves of the key.
    start, stop
        The first shot, and the one after the last.

    Returns
    -------
    ndarray
        (stop - start,), odd multiples of 2^-53.
    """
    skip = start % _WORDS
    generator = np.random.Philox(key=seed + (stream << 64), counter=start // _WORDS)
    words = np.asarray(generator.random_raw(skip + stop - start))[skip:]
    words >>= _SKIPPED_BITS
    return studies.uniform_number(words.astype(np.float64))[0]  # type: ignore[no-any-return]


@dataclass(frozen=True)
class Noise:
    """Noise of variables: deviations times a factor times standard normal numbers.

    Attributes
    ----------
    streams
        The stream of the random numbers of each of the k variables.
    factor
        (k, k), the lower triangular factor of the correlations.
    deviations
        (k,), of the variables, in their units.
    """

    streams: tuple[int, ...]
    factor: Floats
    deviations: Floats

    def draw(self, seed: int, start: int, stop: int) -> Floats:
        """Return the noise of shots `start` to `stop` - 1.

        Parameters
        ----------
        seed
            From 0 to 2^64 - 1.
        start, stop
            The first shot, and the one after the last.

        Returns
        -------
        ndarray
            (k, stop - start); infinite where a deviation is too large for doubles.
        """
        shape = (len(self.streams), stop - start)
        noise: Floats = array_pool.empty(shape, np.dtype(np.float64))
        library = _library()
        if library is None or stop > _MAX_SHOT:
            self.draw_in_numpy(seed, start, noise)
        else:
            self.draw_compiled(library, seed, start, noise)
        return noise

    def draw_compiled(
        self, library: elementary.Library, seed: int, start: int, noise: Floats
    ) -> None:
        """Write the noise in C, of as many shots as there are columns.

        Parameters
        ----------
        library
            The compiled functions.
        seed, start
            As of `draw`.
        noise
            (k, shots), contiguous.
        """
        streams = np.array(self.streams, np.uint64)
        library.noise(streams, self.factor, self.deviations, seed, start, noise)

    def draw_in_numpy(self, seed: int, start: int, noise: Floats) -> None:
        """Write the noise in NumPy.

        Parameters
        ----------
        seed, start, noise
            As of `draw_compiled`.
        """
        stop = start + noise.shape[1]
        normals = [
            elementary.normal_quantile(uniforms(seed, stream, start, stop))
            for stream in self.streams
        ]
        with np.errstate(over="ignore"):
            for k, row in enumerate(self.factor):
                # A sum in a fixed order: a matrix product's could depend on the number of shots.
                total: Any = None
                for weight, normal in zip(row[: k + 1], normals, strict=False):
                    if weight == 0.0:
                        continue
                    if total is None:
                        (total,) = studies.first_term(weight, normal)
                    else:
                        (total,) = studies.next_term(total, weight, normal)
                (noise[k],) = studies.deviation_of_sum(total, self.deviations[k])


def release_states(arguments: Mapping[str, Floats], shape: tuple[int, ...], ring: float) -> Floats:
    """Return the states of releases, not finite where an argument is not.

    Parameters
    ----------
    arguments
        All `ARGUMENTS`, doubles that broadcast to the shape.
    shape
        The shape of the releases.
    ring
        The height of the ring above the floor, m.

    Returns
    -------
    ndarray
        (..., 9), the shape before the last axis.
    """
    library = _library()
    if library is None:
        with np.errstate(over="ignore", invalid="ignore"):
            return states_in_numpy(arguments, shape, ring)
    states: Floats = array_pool.empty((*shape, len(STATE)), np.dtype(np.float64))
    given = (arguments[name] for name in ARGUMENTS)
    columns = [
        np.ascontiguousarray(one if one.size == 1 else np.broadcast_to(one, shape)) for one in given
    ]
    library.release_states(columns, ring, states.reshape(-1, len(STATE)))
    return states


def states_in_numpy(
    arguments: Mapping[str, NDArray[Any]],
    shape: tuple[int, ...],
    ring: float,
    sine_cosine: Callable[[Any], tuple[Any, Any]] = elementary.sine_cosine,
) -> NDArray[Any]:
    """Return the states of releases as `release_states` does, of any kind of number.

    Parameters
    ----------
    arguments
        All `ARGUMENTS`; of doubles, or of objects that add and multiply, such as balls.
    shape, ring
        As of `release_states`.
    sine_cosine
        Function that returns the sine and the cosine of an array of such objects.
    """
    # Nothing is broadcast before it is stored: what all shots share is computed once.
    found = studies.release_state(
        **{name: arguments[name] for name in _OF_STATE},
        ring_height=ring,
        **turns(arguments, sine_cosine),
    )
    state = np.empty((*shape, len(found)), np.result_type(*arguments.values()))
    for component, values in enumerate(found):
        state[..., component] = values
    state += 0.0  # no negative zeros
    return state


def turns(
    arguments: Mapping[str, NDArray[Any]],
    sine_cosine: Callable[[Any], tuple[Any, Any]] = elementary.sine_cosine,
) -> dict[str, Any]:
    """Return the sine and the cosine of each angle of releases, by their names in kernels.

    Parameters
    ----------
    arguments, sine_cosine
        As of `states_in_numpy`; of the arguments, the angles.
    """
    (heading,) = studies.release_heading(arguments["azimuth"], arguments["angle"])
    angles = {"heading": heading, "elevation": arguments["elevation"], "angle": arguments["angle"]}
    return {
        f"{name}_{angle}": value
        for angle, values in angles.items()
        for name, value in zip(("sin", "cos"), sine_cosine(values), strict=True)
    }


def _library() -> elementary.Library | None:
    """Return the compiled functions; None if there are none, or they draw other bits than NumPy."""
    found = elementary.library()
    return found if found is not None and _agrees(found) else None


@cache
def _agrees(found: elementary.Library) -> bool:
    """Return whether C draws the bits of NumPy."""
    factor = np.array([[1.0, 0.0, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.28, 0.96]])
    noise = Noise((0, 3, 2**64 - 1), factor, np.array([0.1, 3.0, 0.02]))
    compiled, expected = np.empty((2, 3, _SAMPLE))
    with found.default_environment():
        noise.draw_compiled(found, _SEED, _START, compiled)
        noise.draw_in_numpy(_SEED, _START, expected)
        one, two, three = expected
        shared = dict.fromkeys(ARGUMENTS, np.float64(0.5))
        releases = shared | {"speed": 7.0 + one, "azimuth": three, "backspin": two}
        states = np.empty((_SAMPLE, len(STATE)))
        found.release_states([np.asarray(releases[name]) for name in ARGUMENTS], 3.0, states)
        in_numpy = states_in_numpy(releases, (_SAMPLE,), 3.0)
    return np.array_equal(compiled, expected) and np.array_equal(states, in_numpy)
