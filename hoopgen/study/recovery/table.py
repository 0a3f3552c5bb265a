"""A table of tracks in, a table of releases out."""

from __future__ import annotations

import os
from collections.abc import Hashable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.files import check_output, resolve_link, temporary_beside
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.units import System, file_unit
from hoopgen.report.provenance import describe_scene
from hoopgen.scene.lookup import SceneLike
from hoopgen.study.jobs.chunk_store import written
from hoopgen.study.named_units import named
from hoopgen.study.tables.columns import numbers
from hoopgen.study.tables.limits import MEMORY
from hoopgen.study.tables.provenance import Origin
from hoopgen.study.tables.reading import ArrowTable, ReadingOptions, sourced
from hoopgen.study.tables.results import check_sink, check_suffix, sink
from hoopgen.study.tables.source import Source
from hoopgen.study.tables.track_columns import FRAME, describe_columns, frame_columns
from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief, cut, join_names

from .fit_release import fit_release
from .fitted_releases import FittedReleases

TRACK = "track"
"""The default column of labels."""

_ROWS = 1 << 20


@dataclass(frozen=True)
class FittedTable:
    """Releases fitted to the tracks of a table.

    Attributes
    ----------
    fitted
        The releases, in the order in which tracks first appear.
    read
        In words, line by line: which column was read as what, and rows that were left out.
    path
        The file of releases; None if none was asked for.
    """

    fitted: FittedReleases
    read: str
    path: Path | None


@dataclass(frozen=True)
class _Frames:
    """The rows of a table of tracks."""

    labels: list[str]
    values: dict[str, NDArray[np.float64]]
    kept: dict[str, list[str | None]]
    unlabelled: int


def fit_table(
    source: str | os.PathLike[str] | ArrowTable,
    out: str | os.PathLike[str] | None = None,
    *,
    parameters: ParameterValues | None = None,
    scene: SceneLike = None,
    noise: float | None = None,
    release_time: float | str | None = None,
    backspin: float | None = None,
    backspin_sd: float | None = None,
    track: str | None = None,
    keep: Sequence[str] = (),
    format: str | None = None,
    columns: Mapping[str, str] | None = None,
    where: Sequence[str] = (),
    units: System = "si",
    delimiter: str | None = None,
    memory: int = MEMORY,
) -> FittedTable:
    """Fit the releases of a table of tracks, one row a frame.

    Parameters
    ----------
    source
        A file or a table in memory, as for `hoopgen.batch`; see
        `hoopgen.study.tables.track_columns` for its columns. Of a row without a time or a position
        the frame is a gap.
    out
        Parquet, CSV or Arrow: the releases, one row a track, with standard errors, as
        `FittedReleases.columns` says. `batch` and `estimate --from` read it; its metadata say the
        scene.
    parameters, scene, noise, release_time, backspin, backspin_sd
        As for `hoopgen.fit_release`; the release time may be text.
    track
        Column of the tracks' labels; by default "track". Without it all rows are one track.
    keep
        Columns of the table to write into `out` too: of each track the first cell.
    format, columns, where, delimiter, memory
        As for `hoopgen.batch`; `columns` by time, x, y and z.
    units
        Of the columns of `out`: "si", or "us" for feet, mph and degrees.

    Raises
    ------
    TypeError, ValueError
        If an argument, the table or one of its columns is not as described.
    OSError
        If `source` cannot be read or `out` not written.
    """
    target = None if out is None else _target(out)
    file_unit("m", units)  # none but them
    time = _release_time(release_time)
    reading = ReadingOptions.from_options(
        format=format, delimiter=delimiter, where=where, memory=memory
    )
    with sourced(source, reading) as table:
        if target is not None and target.exists() and target.samefile(table.path):
            raise ValueError(f"out: {target} is the source")
        names = table.schema().names
        label = _label_column(track, names)
        absent = [name for name in keep if name not in names]
        if absent:
            raise ValueError(f"keep: no column {join_names(absent)}; there are {join_names(names)}")
        others = [name for name in names if name != label]
        found = frame_columns(others, columns)
        frames = _read(table, found, label, keep)
        used = {one.name for one in found.values()} | {*keep}
        read = describe_columns(found, label, [name for name in others if name not in used])
        fitted = fit_release(
            frames.values["time"],
            np.stack([frames.values[axis] for axis in FRAME[1:]], axis=1),
            tracks=frames.labels,
            scene=scene,
            parameters=parameters,
            noise=noise,
            release_time=time,
            backspin=backspin,
            backspin_sd=backspin_sd,
        )
        if target is not None:
            _write(fitted, target, label or TRACK, frames, units, table)
    return FittedTable(fitted, _describe_reading(read, frames), target)


def _describe_reading(read: str, frames: _Frames) -> str:
    """Describe the reading of a table, with the rows that were left out."""
    stacked = np.stack(list(frames.values.values()))
    gaps = int((~np.isfinite(stacked)).any(axis=0).sum())
    lines = [read]
    if gaps:
        lines.append(f"gaps: {format_count(gaps, 'row')} without a time or a position")
    if frames.unlabelled:
        lines.append(f"left out: {format_count(frames.unlabelled, 'row')} without a track")
    return "\n".join(lines)


def _target(out: str | os.PathLike[str]) -> Path:
    target = resolve_link(Path(out))
    check_suffix("out", target)
    return check_output(target)


def _release_time(given: float | str | None) -> Any:
    """Return a release time, which may be text, as `fit_release` takes it."""
    if not isinstance(given, str) or given == "detect":
        return given
    try:
        return float(given.strip().removesuffix("s"))
    except ValueError:
        raise ValueError(
            f"release_time: expected a number of seconds or detect, got {brief(given)}"
        ) from None


def _label_column(track: str | None, names: Sequence[str]) -> str | None:
    """Return the column of the labels; None if there is none and the caller names none."""
    if track is not None:
        if track not in names:
            raise ValueError(f"track: no column {cut(track)}; there are {join_names(names)}")
        return track
    return next((name for name in names if name.strip().lower() == TRACK), None)


def _read(table: Source, columns: Mapping[str, Any], label: str | None, keep: Any) -> _Frames:
    labels: list[str | None] = []
    parts: list[dict[str, NDArray[np.float64]]] = []
    kept: dict[str, list[str | None]] = {name: [] for name in keep}
    for part in table.tables(_ROWS):
        parts.append({n: numbers(part, column, table.comma) for n, column in columns.items()})
        rows = part.num_rows
        labels += ["1"] * rows if label is None else table.labels(part, label)
        for name in kept:
            kept[name] += table.labels(part, name)
    values = {name: np.concatenate([one[name] for one in parts]) for name in columns}
    if None in labels:
        there = np.array([one is not None for one in labels])
        values = {name: value[there] for name, value in values.items()}
        rows_there = np.flatnonzero(there)
        kept = {name: [cells[row] for row in rows_there] for name, cells in kept.items()}
    clear = [one for one in labels if one is not None]
    return _Frames(clear, values, kept, len(labels) - len(clear))


def _write(
    fitted: FittedReleases,
    target: Path,
    label: str,
    frames: _Frames,
    units: System,
    source: Source,
) -> None:
    """Write releases with the provenance by which they are simulated in their scene."""
    columns = fitted.columns(units)
    rows: dict[Hashable, int] = {one: row for row, one in reversed(list(enumerate(frames.labels)))}
    table: dict[str, Any] = {label: pa.array(list(map(str, columns.pop("track"))), pa.string())}
    for name, cells in frames.kept.items():
        table[name] = pa.array([cells[rows[one]] for one in fitted.labels], pa.string())
    shared = {n: float(v) for n, v in fitted.parameters.items() if not np.ndim(v)}
    columns |= {named(n, fitted.scene): v for n, v in fitted.parameters.items() if np.ndim(v)}
    both = [name for name in columns if name in table]
    if both:
        raise ValueError(f"keep: the releases have a column {join_names(both)} of their own")
    table |= columns
    scene = fitted.scene
    values = {**scene.parameters, **shared}
    origin = Origin(values, {}, scene.max_contacts, engine=scene)
    described = describe_scene(scene, values)
    made = pa.table(table).replace_schema_metadata(origin.metadata(described))
    suffix = target.suffix.lower()
    check_sink(suffix, made.schema, source)
    part = temporary_beside(target)
    with ExitStack() as stack:
        stack.enter_context(written(target, part))
        write = stack.enter_context(sink(part, suffix, made.schema, _ROWS, source))
        write(made)
