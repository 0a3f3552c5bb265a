"""Verification that a compiled engine gives NumPy's bits on this processor, before its first use.

Compiler flags, compiler errors or a damaged file can change results silently. At first use some
hundred shots are compared on every vector width of the processor. A stamp file records the verdict
for one library, one version of NumPy and these sources, so that later loads cost nothing. Without a
valid stamp the shots are compared again.
"""

from __future__ import annotations

import contextlib
import math
import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.lock import read_file
from hoopgen.core.private_folders import private_folder

from . import numpy_backend, numpy_flights, result_arrays

WIDTHS = (1, 4, 8, 16)
"""Vector widths that the source can be built for; the processor has some of them."""

MAX_CONTACTS = 40
"""Contacts: enough for a swirl, which makes the most of every rounding."""

TIME_LIMIT = 1.0
"""A time limit in the midst of things, s; the only one where balls may roll for ever."""

# Extreme values: each number of a release takes each of them in turn.
_ODD_NUMBERS = (np.nan, np.inf, -np.inf, 0.0, -0.0, 5e-324, -1e-310, 1e-160, 1e160, -1e300)


Batch = tuple[
    NDArray[np.float64], Sequence[NDArray[np.float64] | float], NDArray[np.int8] | None, float
]
"""Releases, parameters, surfaces that the shots leave, and a time limit, s."""

Expected = list[tuple[Batch, result_arrays.ResultArrays]]
"""Batches with NumPy's results."""


class InexactBuildError(RuntimeError):
    """An engine does not compute doubles as IEEE 754 says, because of how it was built."""


class CompiledEngine(Protocol):
    """The interface of a compiled scene, such as `native.Library`."""

    def run(
        self,
        states: NDArray[np.float64],
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        max_contacts: int,
        out: result_arrays.ResultArrays,
        stop: NDArray[np.int32],
        width: int = 0,
        time_limit: float = math.inf,
    ) -> None:
        """Simulate shots and write what `out` has room for.

        Parameters
        ----------
        states
            Releases, (n, 9).
        parameters
            The kernels' inputs in order, each a number or (n,).
        leaving
            The surface that each shot leaves, (n,), or -1; None for none.
        max_contacts
            The number of contacts at which a shot is capped.
        out
            The result arrays, of which each may be None.
        stop
            A flag, (1,), that interrupts the call when it is not 0.
        width
            The vector width.
        time_limit
            The time limit of a shot, s.
        """


def verify(
    library: Path, engine: CompiledEngine, kernels: ModuleType, shots: Sequence[Batch]
) -> str:
    """Return the differences of an engine from NumPy, "" if none; a stamp stores the verdict.

    This thread must compute doubles as IEEE 754 prescribes.

    Parameters
    ----------
    library
        File that the engine was loaded from.
    kernels
        The generated NumPy module of its scene.
    shots
        Shots that are compared.
    """
    key = _key(library, engine, kernels, shots)
    name = f"{library.name.partition('.')[0]}-{key[:16]}.checked"
    if key and any(_read(folder / name) == key for folder in _folders(library)):
        return ""
    found = differences(engine, kernels, expected(kernels, shots))
    if key and not found:
        any(_write(folder / name, key) for folder in _folders(library))
    return found


def expected(kernels: ModuleType, shots: Iterable[Batch], *, bounds: bool = True) -> Expected:
    """Return batches with NumPy's results, which take time if balls roll.

    This thread must compute doubles as IEEE 754 prescribes.

    Parameters
    ----------
    kernels
        The generated NumPy module of a scene.
    shots
        The batches.
    bounds
        Whether results that need bounds on errors are among them.
    """
    layout = result_arrays.Layout(kernels)
    fields = layout.fields + layout.bounds if bounds else _path(layout)
    given = list(shots)
    found: dict[int, result_arrays.ResultArrays] = {}
    # NumPy takes hardly longer for all that have the same limit than for one of them.
    for limit in dict.fromkeys(limit for *_, limit in given):
        alike = [k for k, batch in enumerate(given) if batch[3] == limit]
        states, parameters, leaving, _ = _together([given[k] for k in alike], limit)
        wanted = _room(len(states), layout, fields)
        numpy_backend.run(
            kernels, states, parameters, leaving, MAX_CONTACTS, wanted, time_limit=limit
        )
        start = 0
        for k in alike:
            found[k] = wanted.rows(start, start + len(given[k][0]))
            found[k].arrays["events"]["shot"] -= start
            start += len(given[k][0])
    return [(batch, found[k]) for k, batch in enumerate(given)]


def _together(batches: Sequence[Batch], limit: float) -> Batch:
    """Return several batches with the same time limit as one."""
    counts = [len(states) for states, *_ in batches]

    def joined(values: Iterable[Any], dtype: type) -> NDArray[Any]:
        each = zip(values, counts, strict=True)
        return np.concatenate([np.full(count, value, dtype) for value, count in each])

    columns = zip(*(parameters for _, parameters, _, _ in batches), strict=True)
    left = [-1 if leaving is None else leaving for _, _, leaving, _ in batches]
    return (
        np.concatenate([states for states, *_ in batches]),
        [joined(values, np.float64) for values in columns],
        joined(left, np.int8),
        limit,
    )


def differences(engine: CompiledEngine, kernels: ModuleType, shots: Expected) -> str:
    """Return the widths and fields in which an engine differs from NumPy, "" if none.

    Parameters
    ----------
    engine
        The compiled scene.
    kernels
        The generated NumPy module of the scene.
    shots
        Batches that the engine simulates, with NumPy's results.
    """
    found: dict[int, list[str]] = {}
    layout = result_arrays.Layout(kernels)
    for (states, parameters, leaving, limit), wanted in shots:
        stop = np.zeros(1, np.int32)
        every = tuple(name for name in layout.results if name in wanted.arrays)
        for width in available_widths(engine, kernels):
            wrong = found.setdefault(width, [])
            # Without diagnostic results another path through the engine is taken.
            for fields in dict.fromkeys((every, _path(layout))):
                got = _room(len(states), layout, fields)
                given = (states, parameters, leaving, MAX_CONTACTS, got, stop, width)
                try:
                    engine.run(*given, time_limit=limit)
                except InexactBuildError:
                    wrong.append("arithmetic")
                    continue
                wrong += _differing_fields(every, wanted, got)
    return "; ".join(
        f"width {width}: {', '.join(dict.fromkeys(wrong))}"
        for width, wrong in found.items()
        if wrong
    )


# ------------------------------------------------------------------------------------------ shots


def even_numbers(rows: int, columns: int) -> NDArray[np.float64]:
    """Return numbers evenly spread over -1/2 to 1/2, the same with every NumPy.

    Parameters
    ----------
    rows, columns
        The shape of the result.
    """
    steps = np.sqrt(np.array(first_primes(columns), float))
    fractions: NDArray[np.float64] = np.outer(np.arange(1, rows + 1), steps) % 1.0
    return fractions - 0.5


def first_primes(count: int) -> list[int]:
    """Return the smallest primes, so many of them."""
    primes: list[int] = []
    number = 2
    while len(primes) < count:
        if all(number % prime for prime in primes):
            primes.append(number)
        number += 1
    return primes


def batches(
    kernels: ModuleType, releases: NDArray[np.float64], time_limit: float = TIME_LIMIT
) -> list[Batch]:
    """Return batches of shots: with shared parameters, with their own, and leaving surfaces.

    One has shared parameters, one a time limit that ends most shots, and one has parameters for
    each shot and surfaces that the shots leave. Where balls may roll for ever all have that limit.

    Parameters
    ----------
    releases
        States (n, 9). Copies of the first one with extreme values are added.
    time_limit
        The limit, s.
    """
    odd = np.tile(releases[:1], (len(_ODD_NUMBERS) * releases.shape[1], 1))
    for row, shot in enumerate(odd):
        shot[row % releases.shape[1]] = _ODD_NUMBERS[row // releases.shape[1]]
    states = np.concatenate([releases, odd])
    defaults = [default for default, _, _ in kernels.PARAMETERS.values()]
    own = np.array(defaults) * (1.0 + 0.2 * even_numbers(len(states), len(defaults)))
    if defaults:
        own[:: len(_ODD_NUMBERS), 0] = np.resize(_ODD_NUMBERS, len(own[:: len(_ODD_NUMBERS)]))
    columns = [np.ascontiguousarray(column) for column in own.T]
    limits = {time_limit if kernels.NEEDS_TIME_LIMIT else math.inf, time_limit}
    surfaces = len(kernels.BODIES)
    leaving = np.arange(len(states)) % (4 * surfaces)
    known = min(surfaces, np.iinfo(np.int8).max + 1)
    left = np.where(leaving < known, leaving, -1).astype(np.int8)
    shared = [(states, defaults, None, limit) for limit in sorted(limits, reverse=True)]
    return [*shared, (states, columns, left, max(limits))]


def _path(layout: result_arrays.Layout) -> tuple[str, ...]:
    """Return the names of the results that need no bounds on errors."""
    return tuple(name for name in layout.fields if not layout.results[name].is_diagnostic)


def _room(
    shots: int, layout: result_arrays.Layout, fields: Sequence[str]
) -> result_arrays.ResultArrays:
    errors = any(layout.results[name].switch for name in fields)
    log = layout.allocate_events(shots, MAX_CONTACTS, errors=errors)
    return layout.allocate(shots, fields).joined(log)


def available_widths(engine: CompiledEngine, kernels: ModuleType) -> list[int]:
    """Return the vector widths of this processor and build.

    Parameters
    ----------
    engine, kernels
        As for `differences`.
    """
    nothing = np.empty((0, len(kernels.STATE)))
    parameters, none = [0.0] * len(kernels.PARAMETERS), result_arrays.ResultArrays()
    there = []
    for width in WIDTHS:
        try:
            engine.run(nothing, parameters, None, 1, none, np.zeros(1, np.int32), width)
        except ValueError:
            continue
        except InexactBuildError:
            pass  # the width exists, but its arithmetic is wrong
        there.append(width)
    return there


def _differing_fields(
    fields: Sequence[str], wanted: result_arrays.ResultArrays, got: result_arrays.ResultArrays
) -> list[str]:
    """Return the names of the fields in which results differ; NaN equals NaN."""
    wrong = []
    for name in (*fields, "event_counts"):
        left, right = getattr(wanted, name), getattr(got, name)
        if right is not None and not _have_same_bits(left, right):
            wrong.append(name)
    assert wanted.events is not None
    assert wanted.event_counts is not None
    assert got.events is not None
    if "event_counts" not in wrong:
        used = np.arange(wanted.events.shape[1]) < wanted.event_counts[:, None]
        for log in ("events", "event_errors"):
            both = [getattr(of, log) for of in (wanted, got)]
            if any(one is None for one in both):
                continue
            left, right = (one[used] for one in both)
            if not all(_have_same_bits(left[name], right[name]) for name in left.dtype.names):
                wrong.append(log)
    return wrong


def _have_same_bits(left: NDArray[Any], right: NDArray[Any]) -> bool:
    """Return whether arrays have the same bits, except within NaNs."""
    if left.dtype.kind != "f":
        return left.tobytes() == right.tobytes()
    alike = [np.where(np.isnan(array), np.nan, array) for array in (left, right)]
    return alike[0].tobytes() == alike[1].tobytes()


# ----------------------------------------------------------------------------------------- stamps


def _key(library: Path, engine: CompiledEngine, kernels: ModuleType, shots: Sequence[Batch]) -> str:
    """Return the content of a stamp: a digest of all that is compared; "" if it cannot be read."""
    import hashlib  # loads OpenSSL, which importing hoopgen need not

    said = f"NumPy {np.__version__}, widths {available_widths(engine, kernels)}"
    digest = hashlib.sha256(said.encode())
    for states, *_ in shots:
        digest.update(states.tobytes())
    try:
        for file in (
            library,
            kernels.__file__,
            numpy_backend.__file__,
            numpy_flights.__file__,
            result_arrays.__file__,
            __file__,
        ):
            digest.update(hashlib.sha256(Path(str(file)).read_bytes()).digest())
    except OSError:
        return ""
    return digest.hexdigest()


def user_cache() -> Path:
    """Return hoopgen's folder in the user's cache; it may not exist.

    Raises
    ------
    RuntimeError
        If the user has no home folder.
    """
    given = os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", "")
    folder = Path(given) if Path(given).is_absolute() else Path.home() / ".cache"
    return folder / "hoopgen"


def _folders(library: Path) -> Iterator[Path]:
    """Yield the folders for stamps: beside the library, else in the user's cache.

    Whoever can write beside the library could change its loader too.
    """
    yield library.parent / "__pycache__"
    with contextlib.suppress(RuntimeError, OSError):  # no home; no folder of one's own
        yield private_folder(user_cache())


def _read(file: Path) -> str:
    try:
        return read_file(file).decode("ascii").strip()
    except (OSError, ValueError):
        return ""


def _write(file: Path, key: str) -> bool:
    """Write a stamp over an old one; return whether it was written."""
    part = file.with_name(f"{file.name}.{os.getpid()}")
    try:
        file.parent.mkdir(exist_ok=True)
        part.write_text(key, encoding="ascii")
        part.replace(file)
    except OSError:
        with contextlib.suppress(OSError):
            part.unlink()
        return False
    return True
