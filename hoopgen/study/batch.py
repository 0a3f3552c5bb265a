"""A table of releases in, a table of results out: the same rows in the same order."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from math import ceil
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.brief import listed
from hoopgen.engines import Engine
from hoopgen.hoop.kinds import ended_in
from hoopgen.hoop.releases import FROM_ZERO, from_zero
from hoopgen.inputs import check_count, doubles
from hoopgen.outputs import check_output, followed
from hoopgen.parameters import completed, resolve
from hoopgen.scenes import check_hoop, engine_of, outcomes_of, variables_of
from hoopgen.told import say_of
from hoopgen.variables import check_names

from .batched import Batch, in_memory
from .chunks import check_workers, opened, run, written
from .columns import Column, variable_of
from .flights import Flights
from .frames import sourced
from .measures import measures_of
from .models import check_turns
from .named import named
from .origin import settle
from .reasons import reasons
from .rebounds import CATCHING_HEIGHT, caught_at, check_height
from .sinks import RESULTS, check_sink, sink
from .tables import Source, Stamp

__all__ = ["ROWS", "Batch", "batch"]


SHOWN = 5
"""Invalid rows that are listed."""

ROWS = 1 << 16
"""Rows in a chunk: a small part of a second, and few megabytes."""


def batch(
    source: Any,
    out: str | os.PathLike[str] | None = None,
    *,
    parameters: Mapping[str, Any] | None = None,
    scene: Any = None,
    release: Mapping[str, float] | None = None,
    measures: Sequence[str] = (),
    catching_height: float = CATCHING_HEIGHT,
    max_contacts: int | None = None,
    override: bool = False,
    format: str | None = None,
    own: Sequence[str] = (),
    prefix: str = "",
    delimiter: str | None = None,
    reason: bool = False,
    rows: int = ROWS,
    scheduler: str | None = None,
    threads: int | None = None,
    progress: Callable[[int, int | None], None] | None = None,
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
        CSV, Parquet or Arrow; or a table in memory of pandas (from 2.2), Polars, or whatever has
        ``__arrow_c_stream__``. Its columns, see `hoopgen.study.columns`, say the releases, or the
        states; and parameters of the scene, in place of those below. A row with no number where one
        is needed becomes INVALID.
    out
        Parquet or CSV, as the suffix says; None keeps the results in memory. There are the columns
        of `source` as they are; of CSV those that are read as numbers, null where a cell is none,
        and others with the type that all of their cells have (`hoopgen.study.tables.Source.typed`);
        also text that a spreadsheet would take for a formula, such as ``=1+1``. After them outcome,
        kind (see `hoopgen.hoop.kinds.Kind`), contacts, contacts by surface, first surface
        touched, time and state at the end plane (NaN for a shot that does not come to it),
        uncertain, and what is measured. Units are in the columns' names, ``end_time_s``, and in the
        fields' metadata; in the schema's, under "hoopgen", is what all shots share: scene, release,
        max_contacts, and hoopgen's version. CSV has what all shots share in columns after the
        others, so that it can be read again, and a number that is none is empty.
    parameters
        Of the scene; one number each. By default those that `source` says, if it is such a file of
        results, else the scene's usual ones.
    scene
        As for `hoopgen.simulate`. Where there is no hoop the rows are states, and no kind is
        written. It has to be the scene of `source`, if that is such a file of results.
    release
        Variables that all shots share, in place of columns; see `hoopgen.hoop.variables`.
    measures
        Names of `hoopgen.study.measures.MEASURES`, each a column.
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
    reason
        Whether there is a column that says why a row is invalid.
    rows
        In a chunk.
    scheduler, threads, progress, report
        Who computes, and who hears of it; see `hoopgen.study.chunks.run`.

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
    if out is not None and Path(out).suffix.lower() not in RESULTS:
        raise ValueError(f"out: expected a file {' or '.join(RESULTS)}, got {out}")
    engine = engine_of(scene)
    if parameters is not None:
        resolve(parameters, 1, engine.table)  # none but them
        parameters = _numbers("parameters", completed(parameters, engine.table))
    check_names("release", release or {}, variables_of(engine))
    release = _numbers("release", release or {})
    check_turns("release", release, release)
    if measures:
        check_hoop("measures", engine)
    height = check_height(catching_height)
    check_workers(scheduler, threads)
    rows = check_count("rows", rows)
    computed = partial(run, scheduler=scheduler, threads=threads, progress=progress, report=report)
    with sourced(source, format or "", delimiter or "") as table, _target(out, table) as target:
        origin = settle(
            table, parameters, release, max_contacts, own, override=override, scene=engine
        )
        shots = Flights(
            dict(origin.parameters),
            dict(origin.release),
            tuple(measures),
            origin.max_contacts,
            engine,
            height,
        )
        check_names("measures", shots.measures, measures_of(engine))
        stamp = table.stamp()
        columns = table.columns(origin.own, shots.release, engine)
        said = say_of(engine, origin.parameters, columns)
        results = _Results(table, columns, table.typed(columns), shots, prefix, reason)
        schema = results.schema(origin.metadata(said))
        format = target.suffix.lower()
        check_sink(format, schema, table)
        shared = results.shared() if format == ".csv" else {}
        digest, count = table.digest()
        work = _Rows(table, columns, shots, rows, digest, count, stamp)
        with opened(target.with_name(f"{target.name}.parts"), work.identity()) as folder:
            # In the folder, where the next start removes what was left unfinished.
            unfinished = folder.path / f"{target.name}.tmp"
            with (
                written(target, unfinished),
                sink(unfinished, format, schema, rows, shared, table) as write,
            ):
                for chunk in computed(work, folder):
                    write(results.table(work.read.popleft(), chunk, schema))
                table.check_unchanged(stamp)  # its own columns were read until now
            folder.remove()
        ended = outcomes_of(engine)
        if engine.has_hoop:
            ended = tuple(one.name.lower() for one in ended_in(engine.rolls))
        counts = dict(zip(ended, results.outcomes.tolist(), strict=False))
        told = ", ".join(f"{column.name} as {name}" for name, column in columns.items())
        return Batch(
            counts,
            None if out is None else target,
            said,
            read=told + (", with decimal commas" if table.comma else ""),
            invalid=tuple(results.invalid),
            table=in_memory(target) if out is None else None,
        )


@contextmanager
def _target(out: str | os.PathLike[str] | None, table: Source) -> Iterator[Path]:
    """Give the file of results, looked at; where none is wanted, one for as long as needed."""
    if out is None:
        with TemporaryDirectory(prefix="hoopgen-") as folder:
            yield Path(folder, "results.arrow")
        return
    target = followed(Path(out))  # which the parts lie beside: on its file system
    if target.exists() and target.samefile(table.path):
        raise ValueError(f"out: {target} is the source")
    if not target.parent.is_dir():
        raise ValueError(f"out: there is no folder {target.parent}")
    check_output(target)
    if target.exists() and not target.is_file():
        raise ValueError(f"out: expected a file, which can be moved into its place; got {target}")
    yield target


def _numbers(name: str, values: Mapping[str, Any]) -> dict[str, float]:
    arrays = {key: doubles(f"{name}[{key!r}]", value) for key, value in values.items()}
    for key in FROM_ZERO:
        if key in arrays:
            from_zero(key, arrays[key])
    for key, array in arrays.items():
        if array.ndim:
            raise ValueError(
                f"{name}[{key!r}]: expected one number; those by shot are a column of the table"
            )
    return {key: float(array) for key, array in arrays.items()}


@dataclass
class _Results:
    """What is written: the rows of a table, and what became of them."""

    source: Source
    columns: Mapping[str, Column]
    types: pa.Schema
    shots: Flights
    prefix: str
    reason: bool
    outcomes: NDArray[np.int64] = field(init=False)
    """Counts of the rows that were written."""
    invalid: list[tuple[int, str]] = field(default_factory=list)
    """Rows, from 1, and reasons; the first ones."""

    def __post_init__(self) -> None:
        self.outcomes = np.zeros(len(self.shots.scene.outcomes), np.int64)

    def schema(self, about: Mapping[bytes, bytes]) -> pa.Schema:
        """Return that of the results; arguments that shots cannot have are refused here."""
        given = self.types
        read = pa.schema([given.field(column.name) for column in self.columns.values()])
        empty = self.source.values(read.empty_table(), self.columns)
        results = list(self.shots.results(empty).schema)
        if self.reason:
            results.append(pa.field("reason", pa.string()))
        results = [column.with_name(self.prefix + column.name) for column in results]
        both = [column.name for column in results if column.name in given.names]
        if both:
            raise ValueError(
                f"{self.source}: has columns named like results: {listed(both)}; give a prefix"
            )
        return pa.schema([*given, *results], {**(given.metadata or {}), **about})

    def shared(self) -> dict[str, float]:
        """Return columns of what all shots share, with which CSV can be read again.

        Raises
        ------
        ValueError
            If columns that are not read have the names of such variables.
        """
        scene = {n: v for n, v in self.shots.parameters.items() if n not in self.columns}
        variables = {**self.shots.release, **scene}
        height = caught_at(self.shots.measures, self.shots.catching_height)
        limits = {"max_contacts": self.shots.max_contacts, **height}
        ours = {f"{self.prefix}{named(name)}": value for name, value in limits.items()}
        for name in self.types.names:
            if name in ours or _variable(name, self.shots.scene) in variables:
                raise ValueError(
                    f"out: CSV has what all rows share in columns, and {self.source} has "
                    f"{name} already; write .parquet, or rename it"
                )
        shared = {named(name, self.shots.scene): value for name, value in variables.items()}
        return {**shared, **ours}

    def table(self, read: pa.Table, results: pa.Table, schema: pa.Schema) -> pa.Table:
        """Return the next rows, with their results, and count them."""
        outcomes = _codes(results["outcome"])
        rows = np.flatnonzero(outcomes == self.shots.scene.outcomes["INVALID"])
        wanted = rows if self.reason else rows[: max(0, SHOWN - len(self.invalid))]
        why = self._reasons(read, wanted)
        before = int(self.outcomes.sum())
        first = zip(wanted[: SHOWN - len(self.invalid)], why, strict=False)
        self.invalid += [(before + int(row) + 1, said) for row, said in first]
        self.outcomes += np.bincount(outcomes, minlength=len(self.outcomes))
        cells = [*self.source.cast(read, self.types).columns, *results.columns]
        if self.reason:
            told: NDArray[np.object_] = np.full(read.num_rows, None)
            told[rows] = why
            cells.append(pa.array(told, pa.string()))
        return pa.Table.from_arrays(cells, schema=schema)

    def _reasons(self, read: pa.Table, rows: NDArray[np.int64]) -> list[str]:
        if not len(rows):
            return []
        taken = read.take(rows)
        given = self.source.values(taken, self.columns)
        found = self.shots.releases(given)
        return reasons(taken, self.columns, given, found, self.shots.scene)


def _variable(column: str, scene: Engine) -> str:
    """Return the variable that a column would be read as, or nothing."""
    try:
        return variable_of(column, scene)[0]
    except ValueError:  # of a column that is not read
        return ""


def _codes(column: pa.ChunkedArray) -> NDArray[np.int64]:
    """Return the outcomes of rows as numbers."""
    parts = [part.indices.to_numpy(zero_copy_only=False) for part in column.chunks]
    return np.concatenate([np.empty(0, np.int64), *parts])


@dataclass(frozen=True)
class _Rows:
    """The results of a table's rows, as a stream of chunks."""

    table: Source
    columns: Mapping[str, Column]
    shots: Flights
    rows: int
    digest: str
    count: int | None
    stamp: Stamp
    read: deque[pa.Table] = field(default_factory=deque)
    """What was read, and not yet written."""

    @property
    def chunks(self) -> int | None:
        """How many, if the table has the rows that it seems to have."""
        return None if self.count is None else max(1, ceil(self.count / self.rows))

    def identity(self) -> dict[str, Any]:
        """Return all that the results depend on."""
        between = {"delimiter": self.table.between} if self.table.format == "csv" else {}
        return {
            "source": {"digest": self.digest, "format": self.table.format, **between},
            "columns": {name: column.name for name, column in self.columns.items()},
            "rows": self.rows,
            **self.shots.identity(),
        }

    def tasks(self) -> Iterator[Callable[[], pa.Table]]:
        """Read, and give what simulates the rows of each chunk."""
        for table in self.table.tables(self.rows):
            given = self.table.values(table, self.columns)
            # Of what was read until now the digest tells: no chunk is kept of anything else.
            self.table.check_unchanged(self.stamp)
            self.read.append(table)
            yield partial(self.shots.results, given)
