"""Calibration of a scene by a table of measured releases and of what was seen of their ends."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import ParameterValues
from hoopgen.hoop.releases import CATCHING_HEIGHT
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.statistics.tally import check_scene
from hoopgen.study.tables.columns import Column, numbers, unit_at_end
from hoopgen.study.tables.limits import MEMORY
from hoopgen.study.tables.provenance import origin_of, results_in
from hoopgen.study.tables.reading import ArrowTable, ReadingOptions, sourced
from hoopgen.study.tables.source import Source
from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief, cut, join_names

from .calibrate import calibrate
from .calibrated_scene import CalibratedScene

_MADE = {"made", "make", "true", "yes", "y", "1", "1.0", "in", "hit"}
_MISSED = {"missed", "miss", "false", "no", "n", "0", "0.0", "out"}
_MISSED |= {"capped", "short", "lodged", "endless"}  # ends of hoopgen's own, none of them made

_ROWS = 1 << 20


@dataclass(frozen=True)
class CalibratedTable:
    """A scene calibrated by a table.

    Attributes
    ----------
    scene
        The calibrated parameters.
    read
        In words, line by line: which column was read as what, and rows that were left out.
    """

    scene: CalibratedScene
    read: str


def calibrate_table(
    source: str | os.PathLike[str] | ArrowTable,
    vary: Mapping[str, tuple[float, float] | None] | Sequence[str],
    *,
    parameters: ParameterValues | None = None,
    scene: SceneLike = None,
    errors: Mapping[str, float] | None = None,
    made: str | None = None,
    ignore: Sequence[str] = (),
    rebound_error: float = 0.0,
    catching_height: float = CATCHING_HEIGHT,
    draws: int = 200,
    seed: int = 0,
    confidence: float = 0.95,
    format: str | None = None,
    own: Sequence[str] = (),
    columns: Mapping[str, str] | None = None,
    where: Sequence[str] = (),
    implausible: bool = False,
    delimiter: str | None = None,
    memory: int = MEMORY,
    override: bool = False,
) -> CalibratedTable:
    """Calibrate a scene by a table of measured releases and of how their shots ended.

    Parameters
    ----------
    source
        A file or a table in memory, as for `hoopgen.batch`. Columns `made` or `outcome` (made,
        missed; true, false; 1, 0), `contacts`, `first` (the body touched first, or none),
        `rebound_x` and `rebound_y` (with a unit at the end, else m) say what was seen; those of
        ``sd_speed_m_s`` and the like the standard errors, as `hoopgen fit` writes them. What a
        file of results says are results was simulated, and not seen: these columns are not read.
    vary, scene, rebound_error, catching_height, draws, seed, confidence
        As for `hoopgen.calibrate`.
    parameters
        Of the scene; None for what a file of results says, and else the scene's usual ones.
    errors
        Standard errors by variable, in place of columns.
    made
        Column that says whether each shot was made, if it is called otherwise; a result, too.
    ignore
        What the table says and is not used: contacts, first, rebound.
    format, own, columns, where, implausible, delimiter, memory
        As for `hoopgen.batch`.
    override
        True if `parameters` and `scene` replace those that a file of results says; else they may
        differ from these in the parameters that vary alone.

    Raises
    ------
    TypeError, ValueError
        If an argument, the table or one of its columns is not as described.
    OSError
        If `source` cannot be read.
    """
    engine = engine_of(scene)
    strange = [name for name in ignore if name not in ("contacts", "first", "rebound")]
    if strange:
        raise ValueError(f"ignore: expected contacts, first or rebound, got {brief(strange[0])}")
    reading = ReadingOptions.from_options(
        format=format, own=own, columns=columns, where=where, implausible=implausible,
        delimiter=delimiter, memory=memory,
    )  # fmt: skip
    with sourced(source, reading) as table:
        names, results = table.schema().names, results_in(table)
        found = _outcome_columns(names, made, own, ignore, results)
        reading = replace(reading, own=tuple(dict.fromkeys((*own, *found.values()))))
        if parameters is not None and not override and (origin := origin_of(table, engine)):
            # Parameters that vary have no value that could contradict the file.
            varied = {name: value for name, value in origin.parameters.items() if name in vary}
            parameters = check_scene(parameters, engine) | varied
        read = reading.interpreted(table, parameters, override=override, scene=engine)
        measured, invalid = read.measured(table)
        variances = read.error_variances(table)
        ends = _outcomes(table, found)
    good = np.isfinite(np.stack(list(measured.values()))).all(axis=0)
    known = np.isin(ends["made"], (0.0, 1.0))
    rows = good & known
    if not rows.any():
        raise ValueError("source: no row has both a release and an outcome")
    release: dict[str, Any] = {name: one[rows] for name, one in measured.items()}
    own_scene = {name: release.pop(name) for name in engine.table.defaults if name in release}
    sd: dict[str, Any] = {n: np.sqrt(one[rows]) for n, one in variances.items() if n in release}
    scene_found = calibrate(
        {**read.origin.release, **release, **{name: one[rows] for name, one in ends.items()}},
        vary,
        scene=engine,
        parameters={**read.origin.parameters, **own_scene},
        errors={**sd, **(errors or {})},
        rebound_error=rebound_error,
        catching_height=catching_height,
        draws=draws,
        seed=seed,
        confidence=confidence,
    )
    said = [f"outcomes: {', '.join(f'{name} from {cut(col)}' for name, col in found.items())}"]
    columns_read = set(found.values())
    meaning = replace(
        read.interpretation,
        not_read={n: v for n, v in read.interpretation.not_read.items() if n not in columns_read},
        results=tuple(n for n in results if n not in columns_read),
    )
    said += [str(meaning), str(invalid)]
    if (left := int((good & ~known).sum())) > 0:
        said.append(f"left out: {format_count(left, 'row')} without an outcome")
    return CalibratedTable(scene_found, "\n".join(line for line in said if line))


def _outcome_columns(
    names: Sequence[str],
    made: str | None,
    own: Sequence[str],
    ignore: Sequence[str],
    results: Sequence[str],
) -> dict[str, str]:
    """Return the columns of outcomes, by `OUTCOMES`; of `results` only one that is named."""
    if made is not None and made not in names:
        raise ValueError(f"made: no column {cut(made)}; there are {join_names(names)}")
    plain = {n.strip().lower(): n for n in names if n not in own and n not in results}
    column = made or plain.get("made") or plain.get("outcome")
    if column is None:
        if "outcome" in results:
            raise ValueError(
                "made: the column outcome is a result of a simulation, and no column made or "
                "outcome says what was seen; name that which does, one of "
                f"{join_names([n for n in names if n not in results])}; or outcome itself"
            )
        raise ValueError(
            "made: no column made or outcome; name that which says whether each shot was made, one "
            f"of {join_names(names)}"
        )
    found = {"made": column}
    for name in ("contacts", "first"):
        if name in plain and name not in ignore:
            found[name] = plain[name]
    for axis in ("rebound_x", "rebound_y"):
        here = [name for low, name in plain.items() if low == axis or low.startswith(f"{axis}_")]
        if here and "rebound" not in ignore:
            found[axis] = here[0]
    return found


def _outcomes(table: Source, found: Mapping[str, str]) -> dict[str, NDArray[Any]]:
    """Return the observations in the columns of outcomes; NaN or nothing for an empty cell."""
    parts: dict[str, list[Any]] = {name: [] for name in found}
    for part in table.tables(_ROWS):
        for name, column in found.items():
            if name == "made":
                parts[name].append(_made(table.labels(part, column), column))
            elif name == "first":
                cells = [one or "" for one in table.labels(part, column)]
                parts[name].append(np.array(cells, dtype=object))
            else:
                unit = unit_at_end(column, "length") if name.startswith("rebound") else None
                parts[name].append(numbers(part, Column(column, unit or 1.0), table.comma))
    return {name: np.concatenate(one) for name, one in parts.items()}


def _made(cells: Sequence[str | None], column: str) -> NDArray[np.float64]:
    words = {**dict.fromkeys(_MADE, 1.0), **dict.fromkeys(_MISSED, 0.0)}
    found = []
    for cell in cells:
        plain = "" if cell is None else cell.strip().lower()
        if plain and plain not in words and plain != "invalid":
            raise ValueError(
                f"made: column {cut(column)}: expected made or missed, true or false, 1 or 0; "
                f"got {brief(cell)}"
            )
        found.append(words.get(plain, np.nan))
    return np.array(found)
