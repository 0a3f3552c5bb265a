"""The fingerprint of a scene: one number that is the same wherever its shots have the same bits."""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.backend_names import BackendName
from hoopgen.engine import verification

from .engine import Engine
from .hoop import hoop_releases

SHOTS = 100_000
"""Number of shots of a fingerprint."""

MAX_CONTACTS = 40
TIME_LIMIT = 5.0
"""Limits of these shots: contacts, and s."""

_SPREAD = (2.0, 2.0, 2.0, 10.0, 10.0, 10.0, 40.0, 40.0, 40.0)
"""Ranges of position (m), velocity (m/s) and spin (rad/s) about 0, in a scene without a hoop."""


def fixed_releases(engine: Engine, shots: int = SHOTS) -> NDArray[np.float64]:
    """Return releases that are the same on every machine, (shots, 9).

    They are fractions of multiples of square roots, in operations that IEEE 754 defines. At a hoop
    they are of the eight kinds of `hoop_releases`, equally many of each; elsewhere they are
    spread evenly around the origin.

    Parameters
    ----------
    engine
        The scene.
    shots
        A multiple of 8.
    """
    if engine.has_hoop:
        return hoop_releases(shots // 8)
    releases: NDArray[np.float64] = verification.even_numbers(shots, len(_SPREAD)) * _SPREAD
    return releases


def fingerprint(
    engine: Engine, backend: BackendName = "auto", releases: NDArray[np.float64] | None = None
) -> str:
    """Return the SHA-256 of all results of releases, in hexadecimal digits.

    Its input is the bytes of each result in the order of `engine.layout.results`, bounds on errors
    included, little-endian, with one bit pattern for NaN: 0x7ff8000000000000.

    Parameters
    ----------
    engine
        The scene; its parameters have their defaults.
    backend
        As for `hoopgen.simulate`.
    releases
        (n, 9); by default the `fixed_releases` of the scene.
    """
    wanted = tuple(engine.layout.results)
    found = engine.simulate(
        fixed_releases(engine) if releases is None else releases,
        max_contacts=MAX_CONTACTS,
        time_limit=TIME_LIMIT,
        backend=backend,
        fields=wanted,
    )
    digest = hashlib.sha256()
    for name in wanted:
        digest.update(canonical_bytes(getattr(found, name)))
    return digest.hexdigest()


def canonical_bytes(values: NDArray[Any]) -> bytes:
    """Return an array's bytes, little-endian; every NaN is 0x7ff8000000000000, or 0x7fc00000."""
    if values.dtype.kind == "f":
        values = np.where(np.isnan(values), np.array(np.nan, values.dtype), values)
    return values.astype(values.dtype.newbyteorder("<")).tobytes()
