"""Whether a compiled engine gives NumPy's bits here: looked at once, before it is trusted.

Flags, a compiler's mistake or a damaged file can change results without a word. A few hundred shots
of every kind are compared, on every width of the processor, and a stamp that says so makes later
loads cost nothing. A stamp is about one library, one NumPy and these sources; one that cannot be
read or does not say that is no stamp, and the shots are compared again.
"""

from __future__ import annotations

import contextlib
import math
import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from types import ModuleType
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from . import arithmetic, numpy_backend, raw

__all__ = ["WIDTHS", "differences", "trusted"]

WIDTHS = (1, 4, 8, 16)
"""Vector widths that the source can be built for; which there are depends on the processor."""

EACH = 32
"""Shots of a kind."""

MOST = 40
"""Contacts: enough for a swirl, which makes the most of every rounding."""

LIMIT = 1.0
"""s: a time limit in the midst of things."""

# A release, and how far its shots lie apart, by kind: x y z, vx vy vz, wx wy wz.
_KINDS = (
    # a free throw, through the ring, onto it and short of it
    ((4.19, 0, -0.61, -4.5, 0, 5.577, 0, 19, 0), (0, 0, 0, 0.3, 0.1, 0.3, 2, 8, 2)),
    # a bank shot, 45 degrees from the side
    ((2.1, 2.1, -0.85, -3.2, -2.4, 5.6, 3, 4, 0), (0, 0, 0, 0.5, 0.5, 0.4, 9, 9, 9)),
    # a swirl
    ((0.2286, -0.945, -0.61, -0.838, 2.134, 3.856, 0, 0, 1), (0, 0, 0, 4e-3, 9e-3, 1e-2, 0, 0, 2)),
    # dropped onto the ring
    ((0, 0, 1.1, 0, 0, 0, 0, 0, 0), (0.7, 0.7, 1.8, 0.6, 0.6, 0.6, 40, 40, 40)),
    # dropped onto the bridge
    ((-0.247, 0, 0.36, 0, 0, 0, 0, 0, 0), (0.03, 0.16, 0.46, 0.6, 0.6, 2, 9, 9, 9)),
    # over the board from behind
    ((-1.2, 0, 0.1, 2.2, 0, 4, 0, 0, 0), (1.4, 1, 1.8, 3.4, 0.6, 3, 0, 0, 0)),
    # a side of the backboard
    ((1, 0.9, 0.2, -2.5, 0, 3, 0, 0, 0), (0, 0.2, 0.8, 1, 0.2, 2, 30, 30, 30)),
    # from anywhere
    ((0.7, 0, 0.2, 0, 0, 2, 0, 0, 0), (4, 3, 2.5, 9, 9, 9, 60, 60, 60)),
)

# What no player does: each number of a release takes each of these values in turn.
_ODD = (np.nan, np.inf, -np.inf, 0.0, -0.0, 5e-324, -1e-310, 1e-160, 1e160, -1e300)


Batch = tuple[
    NDArray[np.float64], Sequence[NDArray[np.float64] | float], NDArray[np.int8] | None, float
]


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


def trusted(library: Path, engine: Engine, kernels: ModuleType) -> str:
    """Return in what an engine differs from NumPy, "" if it does not; a stamp remembers that.

    Parameters
    ----------
    library
        The file that the engine was loaded from.
    kernels
        The generated NumPy module of its scene.

    Raises
    ------
    RuntimeError
        If this thread does not compute doubles as IEEE 754 says.
    """
    key = _key(library, engine, kernels)
    name = f"{library.name.partition('.')[0]}-{key[:16]}.checked"
    if key and any(_read(folder / name) == key for folder in _folders(library)):
        return ""
    found = differences(engine, kernels)
    if key and not found:
        any(_write(folder / name, key) for folder in _folders(library))
    return found


def differences(engine: Engine, kernels: ModuleType, batches: Iterable[Batch] | None = None) -> str:
    """Return the widths and the fields in which an engine differs from NumPy, "" if in none.

    Parameters
    ----------
    batches
        Other shots than those of this file: releases, parameters, the surfaces they leave, and
        a time limit.

    Raises
    ------
    RuntimeError
        If this thread does not compute doubles as IEEE 754 says.
    """
    arithmetic.check_arithmetic()
    found: dict[int, list[str]] = {}
    for states, parameters, leaving, limit in _batches(kernels) if batches is None else batches:
        stop = np.zeros(1, np.int32)
        wanted = _room(len(states), kernels, raw.FIELDS + raw.BOUNDS)
        numpy_backend.run(kernels, states, parameters, leaving, MOST, wanted, time_limit=limit)
        for width in _widths(engine, kernels):
            wrong = found.setdefault(width, [])
            # Without `uncertain` another path through the engine is taken.
            for fields in (raw.FIELDS + raw.BOUNDS, raw.FIELDS[:-1]):
                got = _room(len(states), kernels, fields)
                try:
                    engine.run(
                        states, parameters, leaving, MOST, got, stop, width, time_limit=limit
                    )
                except RuntimeError:
                    wrong.append("arithmetic")
                    continue
                wrong += _unlike(wanted, got)
    return "; ".join(
        f"width {width}: {', '.join(dict.fromkeys(wrong))}"
        for width, wrong in found.items()
        if wrong
    )


# ------------------------------------------------------------------------------------------ shots


def _between(rows: int, columns: int) -> NDArray[np.float64]:
    """Return numbers that fill -1/2 to 1/2 evenly, the same with every NumPy."""
    steps = np.sqrt([2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0])
    fractions: NDArray[np.float64] = np.outer(np.arange(1, rows + 1), steps[:columns]) % 1.0
    return fractions - 0.5


def _batches(kernels: ModuleType) -> Iterator[Batch]:
    """Give the shots: with parameters that all share; with their own, and leaving surfaces.

    And such that a time limit ends, most of them before anything else does.
    """
    spread = _between(EACH, raw.STATE_SIZE)
    kinds = [np.asarray(centre) + np.asarray(width) * spread for centre, width in _KINDS]
    odd = np.tile(kinds[0][:1], (len(_ODD) * raw.STATE_SIZE, 1))
    for row, shot in enumerate(odd):
        shot[row % raw.STATE_SIZE] = _ODD[row // raw.STATE_SIZE]
    states = np.concatenate([*kinds, odd])
    defaults = [default for default, _, _ in kernels.PARAMETERS.values()]
    yield states, defaults, None, math.inf
    yield states, defaults, None, LIMIT

    own = np.array(defaults) * (1.0 + 0.2 * _between(len(states), len(defaults)))
    own[:: len(_ODD), 0] = np.resize(_ODD, len(own[:: len(_ODD)]))
    columns = [np.ascontiguousarray(column) for column in own.T]
    surfaces = len(kernels.BODIES)
    leaving = np.arange(len(states)) % (4 * surfaces)
    yield states, columns, np.where(leaving < surfaces, leaving, -1).astype(np.int8), math.inf


def _room(shots: int, kernels: ModuleType, fields: Sequence[str]) -> raw.Raw:
    results = raw.allocate(shots, len(kernels.BODIES), fields)
    return results.joined(raw.allocate_events(shots, MOST))


def _widths(engine: Engine, kernels: ModuleType) -> list[int]:
    """Return the widths that this processor and this build have."""
    nothing = np.empty((0, raw.STATE_SIZE))
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


def _unlike(wanted: raw.Raw, got: raw.Raw) -> list[str]:
    """Return the fields in which results differ, of those that there are; NaN is NaN."""
    wrong = []
    for name in (*raw.FIELDS, *raw.BOUNDS, "event_counts"):
        left, right = getattr(wanted, name), getattr(got, name)
        if right is not None and left.tobytes() != right.tobytes():
            wrong.append(name)
    assert wanted.events is not None
    assert wanted.event_counts is not None
    assert got.events is not None
    if "event_counts" not in wrong:
        used = np.arange(MOST + 1) < wanted.event_counts[:, None]
        if wanted.events[used].tobytes() != got.events[used].tobytes():
            wrong.append("events")
    return wrong


# ----------------------------------------------------------------------------------------- stamps


def _key(library: Path, engine: Engine, kernels: ModuleType) -> str:
    """Return what a stamp says: a digest of all that is compared; "" where it cannot be read."""
    import hashlib  # loads OpenSSL, which importing hoopgen need not

    said = f"NumPy {np.__version__}, widths {_widths(engine, kernels)}"
    digest = hashlib.sha256(said.encode())
    try:
        for file in (library, kernels.__file__, numpy_backend.__file__, raw.__file__, __file__):
            digest.update(hashlib.sha256(Path(str(file)).read_bytes()).digest())
    except OSError:
        return ""
    return digest.hexdigest()


def _folders(library: Path) -> Iterator[Path]:
    """Give where stamps lie: beside the library; or, where none can be written, the user's cache.

    Who can write there could as well write the library's loader, or is the user.
    """
    yield library.parent / "__pycache__"
    given = os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", "")
    with contextlib.suppress(RuntimeError, OSError):  # no home; no folder of one's own
        folder = Path(given) if Path(given).is_absolute() else Path.home() / ".cache"
        folder /= "hoopgen"
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = folder.stat()
        if os.name == "nt" or (status.st_uid == os.getuid() and not status.st_mode & 0o022):
            yield folder


def _read(file: Path) -> str:
    try:
        return file.read_text(encoding="ascii").strip()
    except (OSError, ValueError):
        return ""


def _write(file: Path, key: str) -> bool:
    """Write a stamp; return whether it is there. Part of one says something else, and is none."""
    try:
        file.parent.mkdir(exist_ok=True)
        file.write_text(key, encoding="ascii")
    except OSError:
        return False
    return True
