"""The event log of a table's shots: lists beside the results, and when written a table."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyarrow as pa

from hoopgen.core.units import System
from hoopgen.results.frames import event_columns, event_numbers
from hoopgen.results.shots import Shots

EVENTS = "\0events"
"""The column of event logs, which is no column of the results."""

_NUMBERS = (pa.field("row", pa.int64()), pa.field("event", pa.int64()))


def events_by_row(shots: Shots, units: System) -> pa.ListArray:
    """Return the event log as a list of each shot's events.

    Parameters
    ----------
    shots
        Shots that were simulated with ``record=True``.
    units
        The system of units, "si" or "us".
    """
    log = shots.events
    columns = event_columns(log, shots.scene, units)
    cells = [_cells(column) for column in columns.values()]
    fields = [pa.field("event", pa.int64())]
    fields += [pa.field(name, one.type) for name, one in zip(columns, cells, strict=True)]
    events = pa.StructArray.from_arrays([pa.array(event_numbers(log)), *cells], fields=fields)
    ends = np.searchsorted(log["shot"], np.arange(len(shots) + 1))
    return pa.ListArray.from_arrays(pa.array(ends, pa.int32()), events)


def _cells(column: Any) -> Any:
    if isinstance(column, tuple):
        codes, words = column
        return pa.DictionaryArray.from_arrays(pa.array(codes.astype(np.int16)), words)
    return pa.array(column)


def event_log(column: pa.ChunkedArray, before: int) -> pa.Table:
    """Return lists of events as a table, with the row of each, from 1.

    Parameters
    ----------
    column
        As of `events_by_row`, of some rows.
    """
    parts = []
    for lists in column.chunks:
        rows = np.repeat(np.arange(len(lists)), lists.value_lengths().to_numpy()) + before + 1
        before += len(lists)
        table = pa.Table.from_struct_array(lists.flatten())
        parts.append(table.add_column(0, _NUMBERS[0], pa.array(rows, pa.int64())))
    return pa.concat_tables(parts)


def log_schema(column: pa.DataType) -> pa.Schema:
    """Return the schema of a log, from the type of `events_by_row`."""
    return pa.schema([_NUMBERS[0], *column.value_type.fields])
