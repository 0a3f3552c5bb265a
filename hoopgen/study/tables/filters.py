"""Filters of rows: comparisons of a column with a value, ``speed_mph >= 15``; nothing is evaluated.

A condition is a column's name, one of ``== != < <= > >=``, and a number or text, in quotes or
without. Of several all must hold. A cell that is empty, or is no number where the value is one,
meets no condition.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc

from hoopgen.text.shorten import brief, join_names

from .delimited import parsed

_COMPARISONS = {
    "==": pc.equal,
    "!=": pc.not_equal,
    "<=": pc.less_equal,
    ">=": pc.greater_equal,
    "<": pc.less,
    ">": pc.greater,
}

_CONDITION = re.compile(r"\s*(.+?)\s*(==|!=|<=|>=|<|>|=)\s*(.*?)\s*", re.DOTALL)
_QUOTED = re.compile(r"""(['"])(.*)\1""", re.DOTALL)
_NUMBER = re.compile(r"[+-]?(0|[1-9]\d*|(?=\.\d))(\.\d*)?([eE][+-]?\d+)?", re.ASCII)
"""A number; what has leading zeros is an identifier."""


@dataclass(frozen=True)
class Condition:
    """A comparison of a column with a value."""

    column: str  # its name
    comparison: str  # one of ``== != < <= > >=``
    value: float | str  # A number or text

    def __str__(self) -> str:
        return f"{self.column} {self.comparison} {self.value!r}"


def parse_conditions(where: str | Iterable[str]) -> tuple[Condition, ...]:
    """Return conditions from their texts."""
    return tuple(_parsed(text) for text in ([where] if isinstance(where, str) else where) if text)


def _parsed(text: str) -> Condition:
    found = _CONDITION.fullmatch(text)
    if found is None or not found[3]:
        raise ValueError(
            f"where: expected a column, one of {' '.join(_COMPARISONS)}, and a value, such as "
            f"'speed_mph >= 15' or 'player == Ann'; got {brief(text)}"
        )
    column, comparison, value = found.groups()
    comparison = "==" if comparison == "=" else comparison
    quoted = _QUOTED.fullmatch(value)
    if quoted:
        return Condition(column, comparison, quoted[2])
    number = _NUMBER.fullmatch(value)
    return Condition(column, comparison, float(value) if number else value)


def check_columns(conditions: Iterable[Condition], names: Sequence[str]) -> None:
    """Refuse conditions on columns that a table does not have.

    Parameters
    ----------
    conditions
        The conditions on rows.
    names
        The names of the columns that there are.

    Raises
    ------
    ValueError
        If a condition is on another column.
    """
    known = set(names)
    for condition in conditions:
        if condition.column not in known:
            raise ValueError(
                f"where: no column {brief(condition.column)}; the columns are {join_names(names)}"
            )


def chosen(
    batch: pa.RecordBatch, conditions: Iterable[Condition], comma: bool = False
) -> pa.RecordBatch:
    """Return the rows that meet all conditions.

    Parameters
    ----------
    comma
        Whether numbers in text may have decimal commas.
    """
    for condition in conditions:
        cells = _comparable(batch[condition.column], condition, comma)
        met = _COMPARISONS[condition.comparison](cells, pa.scalar(condition.value, cells.type))
        batch = batch.filter(met)
    return batch


def _comparable(cells: Any, condition: Condition, comma: bool) -> Any:
    """Return cells with the type of the value; null where a cell has no such value."""
    kind = cells.type
    if pa.types.is_dictionary(kind):
        cells, kind = cells.dictionary_decode(), kind.value_type
    text = pa.types.is_string(kind) or pa.types.is_large_string(kind)
    if text:
        cells = pc.if_else(pc.equal(pc.utf8_trim_whitespace(cells), ""), None, cells)
    if isinstance(condition.value, float):
        if text:
            return parsed(cells, pa.float64(), comma)
        if not _is_number(kind):
            raise ValueError(
                f"where: column {brief(condition.column)} holds no numbers, but {kind}"
            )
        return cells.cast(pa.float64(), safe=False)
    if _is_number(kind):
        raise ValueError(
            f"where: column {brief(condition.column)} holds numbers; got {brief(condition.value)}"
        )
    try:
        return cells if text else cells.cast(pa.string())
    except pa.ArrowException:
        raise ValueError(
            f"where: column {brief(condition.column)} cannot be compared, being {kind}"
        ) from None


def _is_number(kind: Any) -> bool:
    return bool(
        pa.types.is_integer(kind) or pa.types.is_floating(kind) or pa.types.is_decimal(kind)
    )
