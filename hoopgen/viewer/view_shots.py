"""Pages of shots, or of a sample of the rows of a file, in motion."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.files import PAGES, check_not_read, check_output
from hoopgen.core.parameters import ParameterValues
from hoopgen.results.shots import Shots
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.lookup import engine_of
from hoopgen.text.shorten import brief

from .page import write_page
from .page_file import Page


@check_arguments
def view(
    shots: Shots | str | os.PathLike[str],
    parameters: ParameterValues | None = None,
    path: str | os.PathLike[str] | None = None,
    *,
    title: str = "",
    about: str = "",
    labels: Sequence[str] | str | None = None,
    scene: SceneLike = None,
    columns: Mapping[str, str] | None = None,
) -> Page:
    """Write a page that shows shots in motion; notebooks display it.

    It is one file of about 0.7 MB, needs no network, and opens in any browser with WebGL. A
    notebook that shows it becomes larger by as much. Invalid shots are left out; `about` may say
    so.

    One shot is played, or all at once; it goes from contact to contact by buttons or by Shift with
    an arrow key, and is light or dark as the system is, or as its reader says. Lengths and speeds
    are said in metres or in feet: as `hoopgen.core.units.use_units` has them, until the reader
    changes it. Around a hoop it has a net and court lines, drawn for orientation and not simulated,
    which can be left out; so is the ball's fall to the floor after the end. A scene whose bodies
    are cylinders along one axis is looked at along it first.

    Parameters
    ----------
    shots
        Of `hoopgen.simulate` with ``record=True``, all fields; at most
        `hoopgen.viewer.page.MAX_SHOTS`. Or a file, a table of releases or the results of
        `hoopgen.batch`: 50 of its rows are flown, in their own scene.
    parameters
        Of the scene, one number each or (n,); by default those they were simulated with,
        or that a file of results says, else the scene's usual ones.
    path
        Where to; ends in .html. Without, no file is written.
    title
        At the top; by default the outcome, or the number of shots.
    about
        A line below it, after which the scene is said.
    labels
        What each shot is called, n words or lines; by default "Shot 1", "Shot 2", ... Of a file the
        name of a column that says it; by default "Row 1", ...
    scene
        Of a file, as for `hoopgen.simulate`, by default that which results say; shots have theirs.
    columns
        Of a file, names of columns by the variable that they are read as, as for `hoopgen.batch`.

    Returns
    -------
    Page
        It stands for the file written, its ``path``, wherever a path does; the same shots give the
        same bytes.

    Raises
    ------
    TypeError
        If `shots` is neither shots nor a file.
    ValueError
        If the path ends in something else, there is no valid shot or too many, or the labels or
        parameters are not as described; or the scene cannot be drawn: of those of one's own, those
        of the pieces of `hoopgen.scene` can.
    AttributeError
        If the shots were simulated without ``record=True``.
    OSError
        If the file cannot be written; what was there before stays.
    """
    target = None if path is None else check_output(path, PAGES)
    if not isinstance(shots, Shots):
        from .view_table import view_table  # reads by pyarrow, which shots do without

        if target is not None:
            check_not_read("path", target, "view", [Path(shots)])
        if about:
            raise ValueError("about: of a file it is which rows are shown; leave out")
        if labels is not None and not isinstance(labels, str):
            raise ValueError(f"labels: of a file, expected a column's name, got {brief(labels)}")
        here: dict[str, Any] = {"columns": columns, "label": labels, "parameters": parameters}
        return view_table(shots, target, title=title, scene=scene, **here)
    if columns is not None:
        raise ValueError("columns: shots are no table; leave out")
    if scene is not None and engine_of(scene) is not shots.scene:
        raise ValueError("scene: shots were flown in their own; leave out")
    given = shots.parameters if parameters is None else parameters
    return write_page(shots, given, target, title=title, about=about, labels=labels)
