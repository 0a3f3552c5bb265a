"""The thresholds by which C chooses between ways of writing the same."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    """Thresholds, in additions.

    Attributes
    ----------
    max_inline_cost
        A body that costs no more is done for every lane: to skip it would cost as much.
    min_outlined_cost
        A rare body that costs more gets a worklist of its own, even if it does not repeat.
    """

    max_inline_cost: int = 40
    min_outlined_cost: int = 1000
