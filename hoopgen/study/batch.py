"""A table of releases in, a Parquet file of results out: the same rows in the same order."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from functools import partial
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray

from hoopgen.brief import listed
from hoopgen.inputs import check_count, doubles
from hoopgen.installed import need
from hoopgen.notebook import table as rendered
from hoopgen.outputs import check_output, followed
from hoopgen.parameters import resolve
from hoopgen.phrases import counted
from hoopgen.releases import from_zero
from hoopgen.results import SURFACES, Outcome, Shots
from hoopgen.simulation import simulate

from .chunks import opened, run, written
from .measures import MEASURES, Kind, kinds, measure
from .models import from_columns
from .named import UNIT_OF, named
from .origin import settle
from .tables import FORMATS, Column, Source, Stamp
from .told import say_scene
from .variables import STATE, VARIABLES, check_angles, check_names

__all__ = ["ROWS", "Batch", "batch"]


class Batch(dict[str, int]):
    """Number of shots by outcome, in lower case; and where the results are.

    Attributes
    ----------
    path
        The file written.
    scene
        In words: the preset, what differs from it, and what is each row's own.
    """

    def __init__(self, counts: Mapping[str, int], path: Path, scene: str = "") -> None:
        super().__init__(counts)
        self.path = path
        self.scene = scene

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self), self.path, self.scene)

    def to_pandas(self) -> Any:
        """Return the file's rows as a pandas.DataFrame.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        need("pandas", "to_pandas")
        return pq.read_table(self.path, partitioning=None).to_pandas()

    def _repr_html_(self) -> str:
        about = f"{counted(sum(self.values()), 'shot')} in {self.path}; {self.scene}"
        rows = [(name, f"{count:,}") for name, count in self.items()]
        return rendered(about, ("outcome", "shots"), rows)


ROWS = 1 << 16
"""Rows in a chunk: a small part of a second, and few megabytes."""


def batch(
    source: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    parameters: Mapping[str, Any] | None = None,
    release: Mapping[str, float] | None = None,
    measures: Sequence[str] = (),
    max_contacts: int | None = None,
    override: bool = False,
    format: str | None = None,
    own: Sequence[str] = (),
    prefix: str = "",
    delimiter: str | None = None,
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
        CSV, Parquet or Arrow; see `hoopgen.study.tables` for its columns. They say the releases,
        or the states; and parameters of the scene, in place of those below. A row with no number
        where one is needed becomes INVALID.
    out
        Parquet: the columns of `source` as they are; of CSV those that are read as numbers, null
        where a cell is none, and others with the type that all of their cells have
        (`hoopgen.study.tables.Source.typed`). After them outcome,
        kind (see `hoopgen.study.measures.Kind`), contacts, contacts by surface, first surface
        touched, time and state at the end plane (NaN for a shot that does not come to it),
        uncertain, and what is measured. Units are in the columns' names, ``end_time_s``, and in the
        fields' metadata; in the schema's, under "hoopgen", is what all shots share: scene, release,
        max_contacts, and hoopgen's version.
    parameters
        Of the scene; one number each. By default those that `source` says, if it is such a file of
        results, else `PAPER`.
    release
        Variables that all shots share, in place of columns; see `hoopgen.study.variables`.
    measures
        Names of `hoopgen.study.measures.MEASURES`, each a column.
    max_contacts
        A shot with so many contacts ends as capped; by default as many as `source` says, else 40.
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
    rows
        In a chunk.
    scheduler, threads, progress, report
        Who computes, and who hears of it; see `hoopgen.study.chunks.run`.

    Returns
    -------
    Batch
        Number of shots by outcome, a dict; the file is its ``path``, and its ``scene`` is said.

    Raises
    ------
    ValueError
        If an argument, the table or one of its columns is not as described, an argument
        contradicts what `source` says, chunks beside `out` are of another source or other
        arguments, or `source` changes while it is read.
    OSError
        If `source` cannot be read or `out` not written.
    """
    table, target = Source(Path(source), format or "", delimiter or ""), Path(out)
    if target.suffix.lower() not in FORMATS["parquet"]:
        raise ValueError(f"out: expected a file {' or '.join(FORMATS['parquet'])}, got {target}")
    target = followed(target)  # which the parts lie beside: on its file system
    if target.exists() and target.samefile(table.path):
        raise ValueError(f"out: {target} is the source")
    if not target.parent.is_dir():
        raise ValueError(f"out: there is no folder {target.parent}")
    check_output(target)
    if target.exists() and not target.is_file():
        raise ValueError(f"out: expected a file, which can be moved into its place; got {target}")
    if parameters is not None:
        resolve(parameters, 1)  # all of them, and none else
        parameters = _numbers("parameters", parameters)
    check_names("release", release or {}, VARIABLES)
    release = _numbers("release", release or {})
    check_angles("release", release)
    origin = settle(table, parameters, release, max_contacts, own, override=override)
    shots = _Shots(
        dict(origin.parameters), dict(origin.release), tuple(measures), origin.max_contacts
    )
    check_names("measures", shots.measures, MEASURES)
    rows = check_count("rows", rows)
    stamp = table.stamp()
    columns = table.columns(origin.own, shots.release)
    scene = say_scene(origin.parameters, columns)
    types = table.typed(columns)
    schema = _schema(table, types, shots, columns, prefix, origin.metadata(scene))
    digest, count = table.digest()
    work = _Rows(table, columns, shots, rows, digest, count, stamp)
    outcomes = np.zeros(len(Outcome), np.int64)
    with opened(target.with_name(f"{target.name}.parts"), work.identity()) as folder:
        # In the folder, where the next start removes what was left unfinished.
        unfinished = folder.path / f"{target.name}.tmp"
        with written(target, unfinished), _writer(unfinished, schema, table) as writer:
            chunks = run(
                work,
                folder,
                scheduler=scheduler,
                threads=threads,
                progress=progress,
                report=report,
            )
            for results in chunks:
                kept = table.cast(work.read.popleft(), types)
                cells = [*kept.columns, *results.columns]
                writer.write_table(pa.Table.from_arrays(cells, schema=schema), rows)
                outcomes += _by_outcome(results["outcome"])
            table.check_unchanged(stamp)  # its own columns were read until now
        folder.remove()
    counts = {outcome.name.lower(): int(outcomes[outcome]) for outcome in Outcome}
    return Batch(counts, target, scene)


def _numbers(name: str, values: Mapping[str, Any]) -> dict[str, float]:
    arrays = {key: doubles(f"{name}[{key!r}]", value) for key, value in values.items()}
    if "distance" in arrays:
        from_zero(arrays["distance"])
    for key, array in arrays.items():
        if array.ndim:
            raise ValueError(
                f"{name}[{key!r}]: expected one number; those by shot are a column of the table"
            )
    return {key: float(array) for key, array in arrays.items()}


def _schema(
    table: Source,
    given: pa.Schema,
    shots: _Shots,
    columns: Mapping[str, Column],
    prefix: str,
    about: Mapping[bytes, bytes],
) -> pa.Schema:
    """Return that of the file of results; arguments that shots cannot have are refused here."""
    read = pa.schema([given.field(column.name) for column in columns.values()])
    results = [
        column.with_name(prefix + column.name)
        for column in shots.results(table.values(read.empty_table(), columns)).schema
    ]
    both = [column.name for column in results if column.name in given.names]
    if both:
        raise ValueError(
            f"{table.path}: has columns named like results: {listed(both)}; give a prefix"
        )
    return pa.schema([*given, *results], {**(given.metadata or {}), **about})


@contextmanager
def _writer(file: Path, schema: pa.Schema, table: Source) -> Iterator[pq.ParquetWriter]:
    # A dictionary of doubles that hardly repeat is larger and slower than they are.
    repeat = [column.name for column in schema if not pa.types.is_floating(column.type)]
    # By its name: every write of a Python file would wait for the interpreter's lock.
    try:
        with pq.ParquetWriter(str(file), schema, compression="zstd", use_dictionary=repeat) as new:
            yield new
    except pa.ArrowNotImplementedError as error:  # of reading it is none: that names the file
        raise ValueError(f"{table.path}: Parquet has no such column: {error}") from error


def _by_outcome(column: pa.ChunkedArray) -> NDArray[np.int64]:
    counts = np.zeros(len(Outcome), np.int64)
    for part in column.chunks:
        counts += np.bincount(part.indices, minlength=len(Outcome))
    return counts


@dataclass(frozen=True)
class _Rows:
    """The results of a table's rows, as a stream of chunks."""

    table: Source
    columns: Mapping[str, Column]
    shots: _Shots
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
            **asdict(self.shots),
        }

    def tasks(self) -> Iterator[Callable[[], pa.Table]]:
        """Read, and give what simulates the rows of each chunk."""
        for table in self.table.tables(self.rows):
            given = self.table.values(table, self.columns)
            # Of what was read until now the digest tells: no chunk is kept of anything else.
            self.table.check_unchanged(self.stamp)
            self.read.append(table)
            yield partial(self.shots.results, given)


@dataclass(frozen=True)
class _Shots:
    """What is made of releases."""

    parameters: dict[str, float]
    release: dict[str, float]
    measures: tuple[str, ...]
    max_contacts: int

    def results(self, given: Mapping[str, NDArray[np.float64]]) -> pa.Table:
        """Return the results of releases or states, a column each, with their units."""
        number = len(next(iter(given.values())))
        shared = {name: np.full(number, value) for name, value in self.release.items()}
        releases = from_columns({**given, **shared}, self.parameters)
        states, scene = releases.states, releases.parameters
        shots = simulate(states, scene, max_contacts=self.max_contacts, threads=1)
        columns = _ends(shots)
        more = [name for name in self.measures if name not in columns]
        columns |= measure(states, shots, scene, more)
        cells = {name: pa.array(column) for name, column in columns.items()}
        schema = [
            pa.field(
                named(name),
                array.type,
                metadata={"unit": UNIT_OF[name]} if name in UNIT_OF else None,
            )
            for name, array in cells.items()
        ]
        return pa.Table.from_arrays(list(cells.values()), schema=pa.schema(schema))


def _ends(shots: Shots) -> dict[str, Any]:
    """Return the columns that every table of results has."""
    ended = (shots.outcome == Outcome.MADE) | (shots.outcome == Outcome.MISSED)
    end = zip(("time", *STATE), (shots.time, *shots.state.T), strict=True)
    return {
        "outcome": _words(shots.outcome, [outcome.name for outcome in Outcome]),
        "kind": _words(kinds(shots.outcome, shots.counts, shots.first), [k.name for k in Kind]),
        "contacts": shots.contacts,
        **{
            f"{name}_contacts": column
            for name, column in zip(SURFACES, shots.counts.T, strict=True)
        },
        "first": _words(shots.first, SURFACES),
        **{f"end_{name}": np.where(ended, column, np.nan) for name, column in end},
        "uncertain": shots.uncertain,
    }


def _words(indices: NDArray[Any], names: Sequence[str]) -> pa.DictionaryArray:
    """Return names by index, in small letters; none where it is negative."""
    return pa.DictionaryArray.from_arrays(
        pa.array(indices.astype(np.int8), mask=indices < 0), [name.lower() for name in names]
    )
