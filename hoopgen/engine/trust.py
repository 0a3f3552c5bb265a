"""Whether a compiled engine gives NumPy's bits here: looked at once, before it is trusted.

Flags, a compiler's mistake or a damaged file can change results without a word. Some hundred shots
are compared, on every width of the processor, and a stamp that says so makes later loads cost
nothing. A stamp is about one library, one NumPy and these sources; one that cannot be
read or does not say that is no stamp, and the shots are compared again.
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
from hoopgen.core.private import private_folder

from . import arithmetic, numpy_backend, raw

__all__ = ["WIDTHS", "Batch", "batches", "differences", "spread", "trusted", "user_cache", "widths"]

WIDTHS = (1, 4, 8, 16)
"""Vector widths that the source can be built for; which there are depends on the processor."""

MOST = 40
"""Contacts: enough for a swirl, which makes the most of every rounding."""

LIMIT = 1.0
"""s: a time limit in the midst of things."""

LONGEST = 1.5
"""s: one for balls that may roll for ever; NumPy takes long for a few of them."""

# What no player does: each number of a release takes each of these values in turn.
_ODD = (np.nan, np.inf, -np.inf, 0.0, -0.0, 5e-324, -1e-310, 1e-160, 1e160, -1e300)


Batch = tuple[
    NDArray[np.float64], Sequence[NDArray[np.float64] | float], NDArray[np.int8] | None, float
]
"""Releases, parameters, the surfaces that the shots leave, and a time limit."""


class Engine(Protocol):
    """A compiled scene, as native.Library is one."""

    def run(
        self,
        states: NDArray[np.float64],
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        max_contacts: int,
        out: raw.Raw,
        stop: NDArray[np.int32],
        width: int = 0,
        time_limit: float = math.inf,
    ) -> None:
        """Simulate shots and write what `out` has room for."""


def trusted(library: Path, engine: Engine, kernels: ModuleType, shots: Sequence[Batch]) -> str:
    """Return in what an engine differs from NumPy, "" if it does not; a stamp remembers that.

    Parameters
    ----------
    library
        The file that the engine was loaded from.
    kernels
        The generated NumPy module of its scene.
    shots
        That are compared.

    Raises
    ------
    RuntimeError
        If this thread does not compute doubles as IEEE 754 says.
    """
    key = _key(library, engine, kernels, shots)
    name = f"{library.name.partition('.')[0]}-{key[:16]}.checked"
    if key and any(_read(folder / name) == key for folder in _folders(library)):
        return ""
    found = differences(engine, kernels, shots)
    if key and not found:
        any(_write(folder / name, key) for folder in _folders(library))
    return found


def differences(engine: Engine, kernels: ModuleType, shots: Iterable[Batch]) -> str:
    """Return the widths and the fields in which an engine differs from NumPy, "" if in none.

    Raises
    ------
    RuntimeError
        If this thread does not compute doubles as IEEE 754 says.
    """
    arithmetic.check_arithmetic()
    found: dict[int, list[str]] = {}
    layout = raw.Layout(kernels)
    every = layout.fields + layout.bounds
    for states, parameters, leaving, limit in shots:
        stop = np.zeros(1, np.int32)
        wanted = _room(len(states), layout, every)
        numpy_backend.run(kernels, states, parameters, leaving, MOST, wanted, time_limit=limit)
        for width in widths(engine, kernels):
            wrong = found.setdefault(width, [])
            # Without `uncertain` another path through the engine is taken.
            for fields in (every, layout.fields[:-1]):
                got = _room(len(states), layout, fields)
                try:
                    engine.run(
                        states, parameters, leaving, MOST, got, stop, width, time_limit=limit
                    )
                except RuntimeError:
                    wrong.append("arithmetic")
                    continue
                wrong += _unlike(every, wanted, got)
    return "; ".join(
        f"width {width}: {', '.join(dict.fromkeys(wrong))}"
        for width, wrong in found.items()
        if wrong
    )


# ------------------------------------------------------------------------------------------ shots


def spread(rows: int, columns: int) -> NDArray[np.float64]:
    """Return numbers that fill -1/2 to 1/2 evenly, the same with every NumPy."""
    primes: list[int] = []
    number = 2
    while len(primes) < columns:
        if all(number % prime for prime in primes):
            primes.append(number)
        number += 1
    steps = np.sqrt(np.array(primes, float))
    fractions: NDArray[np.float64] = np.outer(np.arange(1, rows + 1), steps) % 1.0
    return fractions - 0.5


def batches(kernels: ModuleType, releases: NDArray[np.float64]) -> list[Batch]:
    """Return shots: with parameters that all share; with their own, and leaving surfaces.

    And such that a time limit ends, most of them before anything else does.

    Parameters
    ----------
    releases
        (n, 9); numbers that are none, or hardly any, take places of the first one in turn besides.
    """
    odd = np.tile(releases[:1], (len(_ODD) * releases.shape[1], 1))
    for row, shot in enumerate(odd):
        shot[row % releases.shape[1]] = _ODD[row // releases.shape[1]]
    states = np.concatenate([releases, odd])
    defaults = [default for default, _, _ in kernels.PARAMETERS.values()]
    own = np.array(defaults) * (1.0 + 0.2 * spread(len(states), len(defaults)))
    if defaults:
        own[:: len(_ODD), 0] = np.resize(_ODD, len(own[:: len(_ODD)]))
    columns = [np.ascontiguousarray(column) for column in own.T]
    longest = LONGEST if kernels.LOG_ROWS > 1 else math.inf
    surfaces = len(kernels.BODIES)
    leaving = np.arange(len(states)) % (4 * surfaces)
    known = min(surfaces, np.iinfo(np.int8).max + 1)
    left = np.where(leaving < known, leaving, -1).astype(np.int8)
    return [
        (states, defaults, None, longest),
        (states, defaults, None, LIMIT),
        (states, columns, left, longest),
    ]


def _room(shots: int, layout: raw.Layout, fields: Sequence[str]) -> raw.Raw:
    return layout.allocate(shots, fields).joined(layout.allocate_events(shots, MOST))


def widths(engine: Engine, kernels: ModuleType) -> list[int]:
    """Return the widths that this processor and this build have."""
    nothing = np.empty((0, len(kernels.STATE)))
    parameters = [0.0] * len(kernels.PARAMETERS)
    there = []
    for width in WIDTHS:
        try:
            engine.run(nothing, parameters, None, 1, raw.Raw(), np.zeros(1, np.int32), width)
        except ValueError:
            continue
        except RuntimeError:
            pass  # there, and of no use
        there.append(width)
    return there


def _unlike(fields: Sequence[str], wanted: raw.Raw, got: raw.Raw) -> list[str]:
    """Return the fields in which results differ, of those that there are; NaN is NaN."""
    wrong = []
    for name in (*fields, "event_counts"):
        left, right = getattr(wanted, name), getattr(got, name)
        if right is not None and not _same(left, right):
            wrong.append(name)
    assert wanted.events is not None
    assert wanted.event_counts is not None
    assert got.events is not None
    if "event_counts" not in wrong:
        used = np.arange(wanted.events.shape[1]) < wanted.event_counts[:, None]
        left, right = wanted.events[used], got.events[used]
        if not all(_same(left[name], right[name]) for name in left.dtype.names or ()):
            wrong.append("events")
    return wrong


def _same(left: NDArray[Any], right: NDArray[Any]) -> bool:
    """Return whether arrays have the same bits, but for the sign and the rest of what is NaN."""
    if left.dtype.kind != "f":
        return left.tobytes() == right.tobytes()
    alike = [np.where(np.isnan(array), np.nan, array) for array in (left, right)]
    return alike[0].tobytes() == alike[1].tobytes()


# ----------------------------------------------------------------------------------------- stamps


def _key(library: Path, engine: Engine, kernels: ModuleType, shots: Sequence[Batch]) -> str:
    """Return what a stamp says: a digest of all that is compared; "" where it cannot be read."""
    import hashlib  # loads OpenSSL, which importing hoopgen need not

    said = f"NumPy {np.__version__}, widths {widths(engine, kernels)}"
    digest = hashlib.sha256(said.encode())
    for states, *_ in shots:
        digest.update(states.tobytes())
    try:
        for file in (library, kernels.__file__, numpy_backend.__file__, raw.__file__, __file__):
            digest.update(hashlib.sha256(Path(str(file)).read_bytes()).digest())
    except OSError:
        return ""
    return digest.hexdigest()


def user_cache() -> Path:
    """Return hoopgen's folder among the user's caches, which need not be there.

    Raises
    ------
    RuntimeError
        If the user has no home.
    """
    given = os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", "")
    folder = Path(given) if Path(given).is_absolute() else Path.home() / ".cache"
    return folder / "hoopgen"


def _folders(library: Path) -> Iterator[Path]:
    """Give where stamps lie: beside the library; or, where none can be written, the user's cache.

    Who can write there could as well write the library's loader, or is the user.
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
    """Write a stamp, in the place of whatever is there; return whether it is there."""
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
