"""Pages of a sample of rows of a table of releases or results, simulated in their scene."""

from __future__ import annotations

import os
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np

from hoopgen.core.backend_names import BackendName
from hoopgen.core.files import PAGES, check_output
from hoopgen.simulation.lookup import engine_of
from hoopgen.simulation.simulate import simulate
from hoopgen.study.tables.provenance import scene_in
from hoopgen.study.tables.reading import ReadingOptions
from hoopgen.text.numbers import format_count

from .page import write_page
from .page_file import Page
from .row_sample import Sample, sample

DEFAULT_SHOTS = 50
"""On a page, unless asked for otherwise."""


def view_table(
    source: str | os.PathLike[str],
    path: str | os.PathLike[str] | None = None,
    *,
    count: int = DEFAULT_SHOTS,
    seed: int = 0,
    title: str = "",
    backend: BackendName = "auto",
    scene: Any = None,
    **options: Any,
) -> Page:
    """Write a page that shows a sample of a table in motion; notebooks display it.

    Parameters
    ----------
    source, count, seed
        As for `hoopgen.viewer.row_sample.sample`.
    path, title
        As for `hoopgen.view`.
    backend, scene
        As for `hoopgen.simulate`; by default the scene that a file of results says.
    **options
        As for `hoopgen.viewer.row_sample.sample`; and how the table is read, as for
        `hoopgen.batch`: format, delimiter, own, columns, where, implausible, memory.

    Raises
    ------
    ValueError, OSError
        As of those.
    """
    target = None if path is None else check_output(path, PAGES)
    file = Path(source)
    read = [one.name for one in fields(ReadingOptions) if one.name in options]
    reading = ReadingOptions.from_options(**{name: options.pop(name) for name in read})
    engine = scene_in(reading.source(file)) if scene is None else engine_of(scene)
    chosen = sample(file, count, seed, reading=reading, scene=engine, **options)
    states, parameters = chosen.releases.states, chosen.releases.parameters
    most = chosen.max_contacts
    shots = simulate(
        states, parameters, scene=engine, max_contacts=most, backend=backend, record=True
    )
    invalid = int(np.count_nonzero(shots.outcome == engine.outcomes["INVALID"]))
    about = _about(file, chosen, seed, invalid)
    page = write_page(shots, parameters, target, title=title, about=about, labels=chosen.labels)
    return replace(page, read=str(chosen.interpretation))


def _about(file: Path, chosen: Sample, seed: int, invalid: int) -> str:
    """Describe which rows are on the page."""
    count = len(chosen.rows)
    if count == chosen.total:
        text = f"{'all ' * (count > 1)}{format_count(count, 'row')} of {file.name}"
    else:
        rows = f"{count:,} of {format_count(chosen.total, 'row')} of {file.name}"
        text = f"{rows}, chosen at random (seed {seed})"
    return f"{text}; {invalid} invalid, left out" if invalid else text
