"""Results of a table by the values of one of its columns: shots by outcome, and shares."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import nan
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.text.numbers import format_interval, format_percent
from hoopgen.text.shorten import brief, cut
from hoopgen.text.tables import table

CONFIDENCE = 0.95
"""Confidence of the intervals of groups."""

MAX_GROUPS = 10_000
"""Different values of the column."""


@dataclass(frozen=True)
class Group:
    """Shots of the rows that have one value in a column.

    Attributes
    ----------
    shots
        By outcome.
    probability
        Share of the first outcome, which is "made" at a hoop, among the shots that are not invalid;
        NaN if all are.
    low, high
        Wilson's 95% interval of it.
    """

    shots: Mapping[str, int]
    probability: float
    low: float
    high: float

    @classmethod
    def from_counts(cls, shots: Mapping[str, int]) -> Group:
        """Return a group from the numbers of its shots by outcome."""
        first = next(iter(shots))
        valid = sum(count for name, count in shots.items() if name != "invalid")
        low, high = wilson_interval(shots[first], valid, CONFIDENCE)
        return cls(dict(shots), shots[first] / valid if valid else nan, float(low), float(high))


class GroupCounts:
    """Counts shots by group and outcome, part by part."""

    def __init__(self, column: str, outcomes: Sequence[str]) -> None:
        self.column = column
        self._number = len(outcomes)
        self._counts: dict[str, NDArray[np.int64]] = {}

    def add(self, cells: pa.ChunkedArray, codes: NDArray[np.int64]) -> None:
        """Count the shots of some rows.

        Parameters
        ----------
        cells
            The column that groups the rows, (n,), of any type that has a text.
        codes
            The outcome of each row, (n,).

        Raises
        ------
        ValueError
            If cells of this type name no group, such as lists.
        """
        if pa.types.is_dictionary(cells.type):
            cells = cells.cast(cells.type.value_type)
        try:
            words = cells.cast(pa.string()).combine_chunks()
        except pa.ArrowException:
            raise ValueError(
                f"by: column {brief(self.column)} holds {cells.type}, which names no group"
            ) from None
        parts = words.chunks if isinstance(words, pa.ChunkedArray) else [words]
        coded = pa.concat_arrays(parts).fill_null("").dictionary_encode()
        names, number = coded.dictionary.to_pylist(), self._number
        pairs = coded.indices.to_numpy(zero_copy_only=False) * number + codes
        found = np.bincount(pairs, minlength=len(names) * number).reshape(-1, number)
        for name, counts in zip(names, found, strict=False):
            self._counts[name] = self._counts.get(name, 0) + counts
        if len(self._counts) > MAX_GROUPS:
            raise ValueError(
                f"by: column {brief(self.column)} has more than {MAX_GROUPS:,} different values"
            )

    def groups(self, ended: Iterable[str]) -> dict[str, Group]:
        """Return the groups by the values of the column, in the order of those.

        Parameters
        ----------
        ended
            Names of the outcomes that there can be.
        """
        return {
            name: Group.from_counts(dict(zip(ended, self._counts[name].tolist(), strict=False)))
            for name in sorted(self._counts)
        }


def groups_text(column: str, groups: Mapping[str, Group]) -> str:
    """Return a table of groups as text.

    Parameters
    ----------
    column
        The name of the column that groups the rows.
    groups
        The counts of each group, by its value in that column.

    Returns
    -------
    str
        A table with the shots by outcome, the share of the first outcome and its interval.
    """
    names = [name for name in next(iter(groups.values())).shots if name] if groups else []
    there = [name for name in names if any(group.shots[name] for group in groups.values())]
    first = names[0] if names else ""
    headers = [cut(column), "shots", *there, f"{first} (share)", "95% interval"]
    rows = [_row(name, group, there) for name, group in groups.items()]
    return table(headers, rows, right=range(1, len(there) + 3))


def _row(name: str, group: Group, there: Sequence[str]) -> list[str]:
    counts: list[Any] = [sum(group.shots.values()), *(group.shots[one] for one in there)]
    share = [format_percent(group.probability), format_interval(group.low, group.high)]
    return [cut(name) or "(none)", *(f"{count:,}" for count in counts), *share]
