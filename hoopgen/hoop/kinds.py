"""Kinds of shots at a hoop: what each touched on its way."""

from __future__ import annotations

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy.hoop import BODIES, Outcome

_RING, _BOARD, _BRIDGE = (BODIES.index(name) for name in ("ring", "backboard", "bridge"))


class Kind(IntEnum):
    """The bodies that a shot touched on its way."""

    SWISH = 0
    """Made, and touched nothing."""
    RIM = 1
    """Touched the ring or the bridge, never the board."""
    BANK = 2
    """Touched the board, never the ring or the bridge."""
    BANK_RIM = 3
    """Touched the board first, then the ring or the bridge too."""
    RIM_BOARD = 4
    """Touched the ring or the bridge first, then the board too."""
    AIRBALL = 5
    """Missed, and touched nothing."""
    NONE = 6
    """Touched nothing, and was neither made nor missed: short, endless or invalid."""


def kinds(
    outcome: NDArray[np.uint8], counts: NDArray[np.int32], first: NDArray[np.int8]
) -> NDArray[np.uint8]:
    """Return the kind of each shot.

    Parameters
    ----------
    outcome, counts, first
        As in `Shots`: (n,), (n, k) and (n,).

    Returns
    -------
    ndarray
        uint8 (n,), a `Kind`.
    """
    return np.asarray(_KIND_OF[touches(counts, first), outcome])


TOUCHES = 8
"""The number of codes of `touches`."""


def touches(counts: NDArray[np.int32], first: NDArray[np.int8]) -> NDArray[np.uint8]:
    """Return codes of what shots touched: 1 board, 2 ring or bridge, 4 board first; their sums.

    Parameters
    ----------
    counts, first
        As of `kinds`.
    """
    # In bytes throughout: wider numbers take three times as long.
    touched = (counts > 0).view(np.uint8)
    code: NDArray[np.uint8] = (first == _BOARD).view(np.uint8) << 1
    code |= touched[:, _RING] | touched[:, _BRIDGE]
    code <<= 1
    code |= touched[:, _BOARD]
    return code


def sum_by_kind(numbers: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return numbers of shots by kind and outcome, from those by code and outcome.

    Parameters
    ----------
    numbers
        (..., `TOUCHES`, outcomes), shots by the code of `touches`.

    Returns
    -------
    ndarray
        int64 (..., kinds, outcomes).
    """
    *settings, _, outcomes = numbers.shape
    found = np.zeros((*settings, len(Kind), outcomes), np.int64)
    for code, row in enumerate(_KIND_OF[:, :outcomes]):
        found[..., row, np.arange(outcomes)] += numbers[..., code, :]
    return found


def hoop_outcomes(rolls: bool) -> tuple[Outcome, ...]:
    """Return the outcomes that a shot can have: LODGED and ENDLESS only where a ball may roll."""
    return tuple(one for one in Outcome if rolls or one <= Outcome.INVALID)


def _kind_of() -> NDArray[np.uint8]:
    """Return kinds by the code of `touches` and by outcome."""
    table = np.full((TOUCHES, len(Outcome)), Kind.NONE, dtype=np.uint8)
    table[0, Outcome.MADE], table[0, Outcome.MISSED] = Kind.SWISH, Kind.AIRBALL
    touched = {1: Kind.BANK, 2: Kind.RIM, 3: Kind.RIM_BOARD, 5: Kind.BANK, 7: Kind.BANK_RIM}
    for bits, kind in touched.items():
        table[bits] = kind
    return table


_KIND_OF = _kind_of()


def kind_table() -> list[list[int]]:
    """Return the table of kinds by what was touched and by outcome, for other languages.

    Its rows count 1 for the board, 2 for the ring or the bridge, 4 for the board first.
    """
    return [[int(kind) for kind in row] for row in _KIND_OF]
