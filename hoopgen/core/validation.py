"""Checks of what callers give, and its conversion to what the engines take."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.generated.numpy import hoop
from hoopgen.text.shorten import brief, join_names, suggestion

MAX_CONTACTS = 40
"""Contacts after which a shot is capped by default, as in the article."""

MAX_THREADS_PER_PROCESSOR = 4
"""Most threads for each processor."""


def as_doubles(name: str, value: ArrayLike, expected: str = "numbers") -> NDArray[np.float64]:
    """Return `value` as float64, with NaN for masked elements.

    Parameters
    ----------
    name
        The argument, for the error message.
    value
        The caller's value.
    expected
        A description of the expected value, for the error message.

    Raises
    ------
    TypeError
        If it is not real numbers: text that looks like them, times, None; or an array that does
        not give its memory away. The message begins with `name`.
    ValueError
        If a whole number is too large for a double, or an array is in the memory of a GPU.
    """
    value = _host_array(name, value)
    try:
        array = np.asarray(_fill_masked(value))
        if array.dtype == object:
            array = np.array([_as_double(v) for v in array.flat]).reshape(array.shape)
        # "same_kind" is numbers alone; NumPy would read text, and count a time's units.
        return array.astype(np.float64, casting="same_kind", copy=False)
    except OverflowError:
        raise ValueError(
            f"{name}: expected {expected} below 1.8e308 in size, got {brief(value)}"
        ) from None
    except (TypeError, ValueError, RecursionError):
        traced = type(value).__module__.startswith("jax.")
        hint = "; what JAX traces, hoopgen.jax.simulate takes" if traced else ""
        raise TypeError(f"{name}: expected {expected}, got {brief(value)}{hint}") from None


def as_number(name: str, value: Any, expected: str) -> float:
    """Return one number; truth values, text and arrays are refused.

    Parameters
    ----------
    name, value
        As for `as_doubles`.
    expected
        A description of the expected number, for the error message.

    Raises
    ------
    TypeError, ValueError
        If it is none; the message begins with `name`.
    """
    number = as_doubles(name, value, expected)
    if isinstance(value, bool | np.bool_) or number.ndim:
        raise ValueError(f"{name}: expected {expected}, got {brief(value)}")
    return float(number)


_HOST_DEVICES = (1, 3, 11)
"""Types of devices, as DLPack numbers them, whose memory the processor reads: its own, and what
CUDA or ROCm have pinned."""


def _host_array(name: str, value: Any) -> Any:
    """Return an array of another library, such as PyTorch, as one of NumPy with the same memory.

    Anything that is not an array in DLPack's way is returned as it is.
    """
    if isinstance(value, float | np.ndarray) or not hasattr(value, "__dlpack_device__"):
        return value
    try:
        on_host = value.__dlpack_device__()[0] in _HOST_DEVICES
        if on_host:
            return np.asarray(value) if hasattr(value, "__array__") else np.from_dlpack(value)
    except Exception as error:  # each library has its own
        said = f"{error}".partition("\n")[0]
        raise TypeError(f"{name}: the array of {_library(value)} cannot be read: {said}") from None
    raise ValueError(
        f"{name}: expected an array in the processor's memory, got one of {_library(value)} on a "
        "GPU, which simulate(..., backend='cuda') reads; or copy it first, with .cpu() in PyTorch, "
        ".get() in CuPy, jax.device_get in JAX"
    )


def _library(array: Any) -> str:
    return type(array).__module__.partition(".")[0]


def _fill_masked(value: Any) -> Any:
    """Return `value` with NaN for masked elements, which `np.asarray` would reveal."""
    if isinstance(value, np.ma.MaskedArray):
        return np.where(np.ma.getmaskarray(value), np.nan, value.data)
    if isinstance(value, list | tuple) and value and not isinstance(value[0], float | int):
        return [_fill_masked(one) for one in value]
    return value


def _as_double(value: Any) -> float:
    """Return an object as a number; float() is stricter than NumPy, which makes a NaN of None."""
    if np.asarray(value).dtype != object:
        return np.asarray(value).astype(np.float64, casting="same_kind").item()
    return float(value)


def is_whole(value: Any) -> bool:
    """Return whether `value` is a whole number; NumPy's spans of time are none."""
    return isinstance(value, int | np.integer) and not isinstance(value, np.timedelta64)


def check_states(states: ArrayLike) -> NDArray[np.float64]:
    """Return releases as float64 (n, 9), contiguous by row.

    Parameters
    ----------
    states
        Numbers of shape (n, 9) or (9,); or a table with columns x, y, z, vx, vy, vz, wx, wy and wz
        in any order, such as a DataFrame of pandas or polars, or a mapping of names to columns or,
        for one release, to numbers.

    Raises
    ------
    TypeError, ValueError
        If they are neither.
    """
    # An array is the usual case, in which a call for one shot takes microseconds.
    given = states if type(states) is np.ndarray else _columns_of(states)
    array = as_doubles("states", given, "numbers of shape (n, 9) or (9,)")
    if array.ndim == 1:
        array = array[None]
    if array.ndim != 2 or array.shape[1] != len(hoop.STATE):
        raise ValueError(
            f"states: expected shape (n, 9) or (9,), got {np.shape(states)}; "
            "a row is x y z vx vy vz wx wy wz"
        )
    return np.ascontiguousarray(array)


def _columns_of(states: Any) -> Any:
    """Return the columns of a table of states in order, (n, 9); anything else as it is."""
    names = states if isinstance(states, Mapping) else getattr(states, "columns", ())
    names = getattr(states, "column_names", names)  # of pyarrow, whose columns have no names
    if not any(isinstance(name, str) for name in names):
        return states  # pandas numbers the columns of an array
    missing = [name for name in hoop.STATE if name not in names]
    if missing:
        raise ValueError(
            f"states: expected columns {' '.join(hoop.STATE)}; {join_names(missing)} "
            f"{'is' if len(missing) == 1 else 'are'} missing"
        )
    columns = [as_doubles(f"states: {name}", states[name]) for name in hoop.STATE]
    try:
        return np.stack(columns, axis=-1)
    except ValueError:
        by_shape: dict[str, list[str]] = {}
        for name, column in zip(hoop.STATE, columns, strict=True):
            by_shape.setdefault(str(column.shape), []).append(name)
        shapes = " and ".join(f"{one} of {join_names(names)}" for one, names in by_shape.items())
        raise ValueError(f"states: expected columns of one length, got shapes {shapes}") from None


def check_leaving(
    leaving: ArrayLike | None, shots: int, surfaces: Sequence[str] = hoop.BODIES
) -> NDArray[np.int8] | None:
    """Return the surface that each shot leaves at the start, (shots,); None if none is given.

    Parameters
    ----------
    leaving
        Indices of surfaces, or their names.
    shots
        How many shots there are.
    surfaces
        The names of the scene's surfaces.

    Raises
    ------
    ValueError
        If they are not names, indices into the surfaces or -1, one or so many.
    """
    if leaving is None:
        return None
    leaving = _host_array("leaving", leaving)
    try:
        array = np.asarray(leaving)
    except ValueError:  # rows of different lengths
        array = np.empty((0, 0))
    if array.dtype.kind in "UTO" and array.size and not np.ma.is_masked(leaving):
        array = _by_name(array, surfaces)
    whole = array.dtype.kind in "iu" and not np.ma.is_masked(leaving)
    if not whole or array.shape not in ((), (shots,)):
        raise ValueError(
            f"leaving: expected whole numbers or names, one or {shots}, got {brief(leaving)}"
        )
    known = min(len(surfaces), np.iinfo(np.int8).max + 1)
    if np.any((array < -1) | (array >= known)):
        of = f" of {len(surfaces)} surfaces" if known < len(surfaces) else ""
        raise ValueError(f"leaving: expected -1 to {known - 1}{of}, got {brief(leaving)}")
    return np.ascontiguousarray(np.broadcast_to(array, shots), dtype=np.int8)


def _by_name(given: NDArray[Any], surfaces: Sequence[str]) -> NDArray[Any]:
    """Return the indices of surfaces that are given by name; what is no text stays."""
    if not all(isinstance(name, str) for name in given.flat):
        return given
    for name in given.flat:
        if name not in surfaces:
            raise ValueError(
                f"leaving: expected {join_names(surfaces)}, got "
                f"{brief(str(name))}{suggestion(str(name), surfaces)}"
            )
    order = {name: index for index, name in enumerate(surfaces)}
    return np.array([order[name] for name in given.flat]).reshape(given.shape)


def check_contacts(max_contacts: Any) -> int:
    """Return the number of contacts at which a shot is capped.

    Raises
    ------
    ValueError
        If it is no whole number from 1, or more than the engines count.
    """
    return check_count("max_contacts", max_contacts, most=2**31 - 1)


def check_time_limit(time_limit: Any) -> float:
    """Return the time limit of a shot since its release, s; infinity for None.

    Raises
    ------
    TypeError, ValueError
        If it is neither None nor a positive number, or so large that arithmetic could overflow.
    """
    if time_limit is None:
        return math.inf
    expected = "a positive number of seconds, or None"
    limit = as_number("time_limit", time_limit, expected)
    if not limit > 0:
        raise ValueError(f"time_limit: expected {expected}, got {brief(time_limit)}")
    if hoop.MAX_TIME < limit < math.inf:
        raise ValueError(
            f"time_limit: expected at most {hoop.MAX_TIME:g} seconds, or None; got {limit:g}"
        )
    return limit


def check_index(name: str, value: Any, length: int) -> int:
    """Return the index of a shot, from 0, for one that may count from the end.

    Parameters
    ----------
    name, value
        As for `as_doubles`.
    length
        The number of shots.

    Raises
    ------
    TypeError
        If it is no whole number.
    IndexError
        If there is no such shot.
    """
    if not is_whole(value):
        raise TypeError(f"{name}: expected a whole number, got {brief(value)}")
    if not -length <= value < length:
        allowed = f"from {-length} to {length - 1}" if length else "of none"
        raise IndexError(f"{name}: expected a shot {allowed}, got {brief(value)}")
    return int(value) % length


def check_count(
    name: str, value: Any, *, least: int = 1, most: int = 2**63 - 1, expected: str = ""
) -> int:
    """Return a whole number from `least` to `most`; truth values and times are refused.

    Parameters
    ----------
    name, value
        As for `as_doubles`.
    least, most
        The lowest and the highest allowed number.
    expected
        A description of the expected number; by default its lowest value.

    Raises
    ------
    ValueError
        If it is none; the message begins with `name` and says what is expected, by default the
        ends.
    """
    whole = is_whole(value) and not isinstance(value, bool)
    if not whole or not least <= value <= most:
        said = expected or f"a whole number from {least}"
        hint = ""
        if whole or (isinstance(value, float) and value.is_integer()):
            # An end that nobody comes near is told only to those who pass it.
            hint = f"; at most {most}" if value > most else ""
            if not whole and least <= value <= most:
                hint = f"; give it as an int, {int(value)}"
        raise ValueError(f"{name}: expected {said}, got {brief(value)}{hint}")
    return int(value)


def check_threads(threads: Any) -> int:
    """Return the number of threads; for None the processors of this process.

    Of more than `MAX_THREADS_PER_PROCESSOR` for each of those, so many: none would be done sooner.

    Raises
    ------
    ValueError
        If it is neither None nor a whole number from 1.
    """
    own = getattr(os, "sched_getaffinity", None)
    processors = len(own(0)) if own else os.cpu_count() or 1
    if threads is None:
        return processors
    count = check_count("threads", threads, expected="a whole number from 1, or None")
    return min(count, MAX_THREADS_PER_PROCESSOR * processors)
