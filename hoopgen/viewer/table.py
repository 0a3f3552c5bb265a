"""A page of some rows of a table of releases, or of results, which are flown in their own scene."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from hoopgen.inputs import Backend
from hoopgen.outputs import PAGES, check_output
from hoopgen.phrases import counted
from hoopgen.scenes import engine_of
from hoopgen.simulation import simulate
from hoopgen.study.limits import MEMORY
from hoopgen.study.reading import Reading

from .page import written
from .sample import Sample, sample
from .shown import Page

__all__ = ["SHOTS", "view_table"]

SHOTS = 50
"""On a page, unless asked for otherwise."""


def view_table(
    source: str | os.PathLike[str],
    path: str | os.PathLike[str] | None = None,
    *,
    count: int = SHOTS,
    seed: int = 0,
    title: str = "",
    parameters: Mapping[str, Any] | None = None,
    release: Mapping[str, float] | None = None,
    max_contacts: int | None = None,
    override: bool = False,
    format: str | None = None,
    delimiter: str | None = None,
    own: Sequence[str] = (),
    columns: Mapping[str, str] | None = None,
    where: str | Sequence[str] = (),
    implausible: bool = False,
    memory: int = MEMORY,
    label: str | None = None,
    backend: Backend = "auto",
    scene: Any = None,
) -> Page:
    """Write a page on which a sample of a table is seen in motion; in a notebook, show it.

    Parameters
    ----------
    source, count, seed, parameters, release, max_contacts, override, label
        As for `hoopgen.viewer.sample.sample`.
    format, delimiter, own, columns, where, implausible, memory
        As for `hoopgen.batch`.
    path, title
        As for `hoopgen.view`.
    backend, scene
        As for `hoopgen.simulate`.

    Raises
    ------
    ValueError, OSError
        As of those.
    """
    target = None if path is None else check_output(path, PAGES)
    file, engine = Path(source), engine_of(scene)
    reading = Reading.of(
        format=format,
        delimiter=delimiter,
        own=own,
        columns=columns,
        where=where,
        implausible=implausible,
        memory=memory,
    )
    chosen = sample(
        file,
        count,
        seed,
        parameters,
        release=release,
        max_contacts=max_contacts,
        override=override,
        reading=reading,
        label=label,
        scene=engine,
    )
    states, parameters = chosen.releases.states, chosen.releases.parameters
    most = chosen.max_contacts
    shots = simulate(
        states, parameters, scene=engine, max_contacts=most, backend=backend, record=True
    )
    invalid = int(np.count_nonzero(shots.outcome == engine.outcomes["INVALID"]))
    about = _about(file, chosen, seed, invalid)
    page = written(shots, parameters, target, title=title, about=about, labels=chosen.labels)
    return replace(page, read=str(chosen.interpretation))


def _about(file: Path, chosen: Sample, seed: int, invalid: int) -> str:
    """Say which rows are shown."""
    count = len(chosen.rows)
    if count == chosen.total:
        text = f"{'all ' * (count > 1)}{counted(count, 'row')} of {file.name}"
    else:
        rows = f"{count:,} of {counted(chosen.total, 'row')} of {file.name}"
        text = f"{rows}, chosen at random (seed {seed})"
    return f"{text}; {invalid} invalid, left out" if invalid else text
