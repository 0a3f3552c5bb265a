"""The thresholds by which NumPy chooses between ways of writing the same."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    """Thresholds, the costs in additions.

    Attributes
    ----------
    max_inline_cost
        A body that costs no more is done for every row: to skip it would cost as much.
    max_inline_cost_in_turns
        The same in a body that repeats, where what some rows need is not taken by all in each turn.
    min_operations_in_rows
        A kernel with fewer operations on the way to its results is not given rows to write into.
    """

    max_inline_cost: int = 40
    max_inline_cost_in_turns: int = 10
    min_operations_in_rows: int = 6
