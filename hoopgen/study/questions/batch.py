"""A table of releases in, a table of results out: the same rows in the same order."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from functools import partial
from math import ceil
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments, is_names
from hoopgen.core.files import check_output, resolve_link, temporary_beside
from hoopgen.core.parameters import ParameterValues, complete, resolve
from hoopgen.core.units import System, file_unit
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.core.variables import check_names
from hoopgen.hoop.releases import FROM_ZERO, from_zero
from hoopgen.report.provenance import describe_scene
from hoopgen.scene.lookup import SceneLike, check_hoop, variables_of
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.chunk_store import opened, written
from hoopgen.study.jobs.chunks import Progress, begin_work, run
from hoopgen.study.jobs.executors import check_workers
from hoopgen.study.measures.measures import measures_of
from hoopgen.study.measures.rebounds import CATCHING_HEIGHT, check_height
from hoopgen.study.models.release_model import check_turns
from hoopgen.study.tables.batch_result import Batch, in_memory
from hoopgen.study.tables.columns import Column
from hoopgen.study.tables.flights import Flights
from hoopgen.study.tables.limits import MEMORY
from hoopgen.study.tables.provenance import scene_in
from hoopgen.study.tables.reading import ArrowTable, ReadingOptions, sourced
from hoopgen.study.tables.results import Results, check_sink, check_suffix, sink
from hoopgen.study.tables.source import Source, Stamp
from hoopgen.text.shorten import brief

ROWS = 1 << 16
"""Rows in a chunk: a small part of a second, and few megabytes."""


@check_arguments
def batch(
    source: str | os.PathLike[str] | ArrowTable,
    out: str | os.PathLike[str] | None = None,
    *,
    parameters: ParameterValues | None = None,
    scene: SceneLike = None,
    release: Mapping[str, float] | None = None,
    measures: Sequence[str] = (),
    catching_height: float = CATCHING_HEIGHT,
    max_contacts: int | None = None,
    override: bool = False,
    format: str | None = None,
    own: Sequence[str] = (),
    prefix: str = "",
    delimiter: str | None = None,
    columns: Mapping[str, str] | None = None,
    where: str | Sequence[str] = (),
    by: str | None = None,
    events: str | os.PathLike[str] | None = None,
    implausible: bool = False,
    units: System = "si",
    memory: int = MEMORY,
    reason: bool = False,
    rows: int = ROWS,
    scheduler: str | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
    report: Callable[[str], None] | None = None,
) -> Batch:
    """Simulate the releases of a table, and write it with the results.

    The table is read and written in chunks, so that it may be larger than the memory. Finished
    chunks lie in a folder beside `out`, named ``<out>.parts``, until all are: after an
    interruption the same call goes on from there. It reads the table again and simulates only what
    is missing. The same table and arguments give the same file, byte for byte.

    Parameters
    ----------
    source
        CSV, Parquet, Arrow or .xlsx; or a table in memory of pandas (from 2.2), Polars, or
        whatever has ``__arrow_c_stream__``. Its columns, see `hoopgen.study.tables.columns`, say
        the releases, or the states; and parameters of the scene, in place of those below. A row
        with no number where one is needed becomes INVALID, and so does one with an implausible
        number or with more or fewer cells than the header.
    out
        CSV (.csv, .tsv), Parquet (.parquet, .pq) or Arrow (.arrow, .arrows, .feather, .ipc), as the
        suffix says; None keeps the results in memory. There are the columns of `source` as they
        are; of CSV those that are read as numbers, null where a cell is none
        (in CSV its text), and others with the type that all of their cells have
        (`hoopgen.study.tables.source.Source.typed`); also text that a spreadsheet would take for a
        formula, such as ``=1+1``. After them outcome, kind (see `hoopgen.hoop.kinds.Kind`),
        contacts, contacts by surface, first surface touched, time and state at the end plane (NaN
        for a shot that does not come to it), uncertain, and what is measured. Units are in the
        columns' names, ``end_time_s``, and in the fields' metadata; in the schema's, under
        "hoopgen", is what all shots share: scene, release, max_contacts, and hoopgen's version. In
        CSV that is a comment line before the header, ``# hoopgen: {…}``, and a number that is none
        is empty. Where `source` is such a file of results, new ones take the place of those.
    parameters
        Of the scene; one number each. By default those that `source` says, if it is such a file of
        results, else the scene's usual ones.
    scene
        As for `hoopgen.simulate`; by default the scene that `source` says, if that is such a file
        of results and the scene comes with hoopgen or is from a scene file, whose text results
        have. Where there is no hoop the rows are states, and no kind is written.
    release
        Variables that all shots share, in place of columns; see `hoopgen.hoop.variables`.
    measures
        Names of `hoopgen.study.measures.measures.MEASURES`, each a column.
    catching_height
        Of rebounds, as for `hoopgen.measure`.
    max_contacts
        A shot with so many contacts ends as capped; by default as many as `source` says, else as
        is usual in the scene.
    override
        Whether parameters, release and max_contacts may contradict what `source` says.
    format
        "csv", "parquet" or "arrow"; by default as the suffix of `source` says.
    own
        Columns of `source` that are not to be read, though they are named like variables.
    prefix
        Of the names of the results, where `source` has columns of the same name.
    delimiter
        Between the cells of CSV, ";" or "tab"; by default as its first line says. Where it is no
        comma, numbers may have decimal commas.
    columns
        Names of columns by the variable that they are read as, whatever they are called; the unit
        is at the end of either name: ``{"speed": "release_speed_mph"}``, ``{"speed_mph": "v"}``.
    where
        Conditions that rows meet, or are left out: a column, one of ``== != < <= > >=``, and a
        value, such as "speed_mph >= 15" or "player == Ann"; see `hoopgen.study.tables.filters`.
    by
        Column by whose values results are counted: `Batch.groups`.
    events
        As `out`: the event log, a row each event, with the number of its row in the results,
        from 1, and its own among the events of that row.
    implausible
        Whether rows with implausible numbers are simulated, too; see
        `hoopgen.study.models.plausible`.
    units
        Of the columns of results: "si", or "us" for feet, mph, degrees and Hz.
    memory
        Bytes that rows which are read at once may take.
    reason
        Whether there is a column that says why a row is invalid.
    rows
        In a chunk.
    scheduler, threads, progress, report
        Who computes, and who hears of it; see `hoopgen.study.jobs.chunks.run`.

    Returns
    -------
    Batch
        Number of shots by outcome, a dict; the file is its ``path``, or `Batch.to_arrow` gives the
        results; what was read and which rows are invalid is said.

    Raises
    ------
    TypeError
        If `source` is neither a path nor a table.
    ValueError
        If an argument, the table or one of its columns is not as described, an argument
        contradicts what `source` says, chunks beside `out` are of another source or other
        arguments, or `source` changes while it is read.
    OSError
        If `source` cannot be read or `out` not written.
    """
    if out is not None:
        check_suffix("out", out)
    if not is_names((columns or {}).values()):
        raise TypeError(f"columns: expected names of the table's columns, got {brief(columns)}")
    release = _numbers("release", release or {})
    check_turns("release", release, release)
    height = check_height(catching_height)
    file_unit("m", units)  # none but them
    check_workers(scheduler, threads)
    rows = check_count("rows", rows)
    computed = partial(run, scheduler=scheduler, threads=threads, progress=progress, report=report)
    log = None if events is None else _checked_events(events, out)
    reading = ReadingOptions.from_options(
        format=format,
        delimiter=delimiter,
        own=own,
        columns=columns,
        where=where,
        implausible=implausible,
        memory=memory,
    )
    with ExitStack() as files:
        table = files.enter_context(sourced(source, reading))
        engine = scene_in(table) if scene is None else engine_of(scene)
        if parameters is not None:
            resolve(parameters, 1, engine.table)  # none but them
            parameters = _numbers("parameters", complete(parameters, engine.table))
        check_names("release", release, variables_of(engine))
        if len(measures):
            check_hoop("measures", engine)
        target = files.enter_context(_target(out, table))
        if log is not None and log.exists() and log.samefile(table.path):
            raise ValueError(f"events: {events} is the source")
        asked: dict[str, Any] = {"override": override, "scene": engine}
        found = reading.interpreted(table, parameters, release, max_contacts, **asked)
        origin = found.origin
        shots = Flights(
            dict(origin.parameters),
            dict(origin.release),
            tuple(measures),
            origin.max_contacts,
            engine,
            height,
            units,
            log is not None,
        )
        check_names("measures", shots.measures, measures_of(engine))
        stamp = table.stamp()
        text = describe_scene(engine, origin.parameters, found.columns)
        format = target.suffix.lower()
        results = Results(table, found.columns, shots, origin, prefix, reason, by, format)
        schema = results.schema(text)
        check_sink(format, schema, table)
        begin_work()
        digest, count = table.digest()
        work = _TableJob(table, found.columns, shots, rows, digest, count, stamp)
        with opened(target.with_name(f"{target.name}.parts"), work.identity()) as folder:
            # In the folder, where the next start removes what was left unfinished.
            unfinished = folder.temporary()
            with ExitStack() as stack:
                stack.enter_context(written(target, unfinished))
                write = stack.enter_context(sink(unfinished, format, schema, rows, table))
                if log is not None:
                    part = temporary_beside(log)
                    stack.enter_context(written(log, part))
                    also = sink(part, log.suffix.lower(), results.log_schema, rows, table)
                    results.log = stack.enter_context(also)
                for chunk in computed(work, folder):
                    write(results.table(*work.read.popleft(), chunk, schema))
                table.check_unchanged(stamp)  # its own columns were read until now
            folder.remove()
        return Batch(
            dict(zip(results.ended, results.outcomes.tolist(), strict=False)),
            None if out is None else target,
            text,
            read=str(found.interpretation),
            invalid=results.invalid,
            table=in_memory(target) if out is None else None,
            groups=results.groups,
            events=log,
        )


def _checked_events(events: str | os.PathLike[str], out: str | os.PathLike[str] | None) -> Path:
    """Return the file of the event log, looked at."""
    log = resolve_link(Path(events))
    check_suffix("events", log)
    if out is not None and log == resolve_link(Path(out)):
        raise ValueError(f"events: {events} is the file of results")
    return check_output(log)


@contextmanager
def _target(out: str | os.PathLike[str] | None, table: Source) -> Iterator[Path]:
    """Give the file of results, looked at; where none is wanted, one for as long as needed."""
    if out is None:
        with TemporaryDirectory(prefix="hoopgen-") as folder:
            yield Path(folder, "results.arrows")
        return
    target = resolve_link(Path(out))  # which the parts lie beside: on its file system
    if target.exists() and target.samefile(table.path):
        raise ValueError(f"out: {target} is the source")
    if not target.parent.is_dir():
        raise ValueError(f"out: there is no folder {target.parent}")
    check_output(target)
    if target.exists() and not target.is_file():
        raise ValueError(f"out: expected a file, which can be moved into its place; got {target}")
    yield target


def _numbers(name: str, values: Mapping[str, Any]) -> dict[str, float]:
    arrays = {key: as_doubles(f"{name}[{key!r}]", value) for key, value in values.items()}
    for key in FROM_ZERO:
        if key in arrays:
            from_zero(key, arrays[key])
    for key, array in arrays.items():
        if array.ndim:
            raise ValueError(
                f"{name}[{key!r}]: expected one number; those by shot are a column of the table"
            )
    return {key: float(array) for key, array in arrays.items()}


@dataclass(frozen=True)
class _TableJob:
    """The results of a table's rows, as a stream of chunks."""

    table: Source
    columns: Mapping[str, Column]
    shots: Flights
    rows: int
    digest: str
    count: int | None
    stamp: Stamp
    read: deque[tuple[pa.Table, NDArray[np.int64]]] = field(default_factory=deque)
    """Rows that were read and are not yet written, and their numbers."""

    @property
    def chunks(self) -> int | None:
        """The number of chunks, if the table has the rows that it seems to have."""
        return None if self.count is None else max(1, ceil(self.count / self.rows))

    def identity(self) -> dict[str, object]:
        """Return all that the results depend on."""
        between = {"delimiter": self.table.between} if self.table.format == "csv" else {}
        where = {"where": list(map(str, self.table.conditions))} if self.table.conditions else {}
        columns = self.columns.items()
        return {
            "source": {"digest": self.digest, "format": self.table.format, **between, **where},
            "columns": {name: column.name for name, column in columns},
            "units": {name: column.unit for name, column in columns},
            "limits": {name: column.limits for name, column in columns},
            "rows": self.rows,
            **self.shots.identity(),
        }

    def tasks(self) -> Iterator[Callable[[], pa.Table]]:
        """Read, and give what simulates the rows of each chunk."""
        for part, (table, numbers) in enumerate(self.table.numbered(self.rows)):
            # A last part may have one row, and that a wrong angle.
            given = self.table.values(table, self.columns, check=part == 0)
            # Of what was read until now the digest tells: no chunk is kept of anything else.
            self.table.check_unchanged(self.stamp)
            self.read.append((table, numbers))
            yield partial(self.shots.results, given)
