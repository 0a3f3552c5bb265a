"""A page for players: what to practise most, and where shots come down before and after."""

from __future__ import annotations

import base64
import html
import io
import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.files import check_output, write
from hoopgen.core.units import DISPLAY_UNITS, INCH, System
from hoopgen.report.provenance import sentences
from hoopgen.simulation.simulate import simulate
from hoopgen.study.measures.measures import measure
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.questions.coach_result import Advice, Coaching, say
from hoopgen.text.numbers import format_interval, format_percent, format_points

from .coach import plot_coach
from .figure import Picture
from .style import COLOURS, INK, PAGE, style

_DOTS = 400
"""Shots of each panel; the shares beside them are of all."""

_MADE, _MISSED = "#1B6CA8", "#D05A2B"
_SHORT = {"speed": "speed", "elevation": "arc", "azimuth": "left-right", "backspin": "spin"}
_REACH = 17.0 * INCH  # m from the ring's centre
_TICKS: Mapping[System, float] = {"us": 10.0, "si": 25.0}
"""Distance of marks from the ring's centre, in short units: inches or centimetres."""
_LEFT, _AROUND, _MAX_HEIGHT = 0.5, 0.75, 2.35  # inches: left of and around panels; of the picture


@check_arguments
def plot_coach_shots(found: Coaching, *, title: str = "") -> Figure:
    """Draw where shots come down at the ring: now, and with half the spread of each part.

    Parameters
    ----------
    found
        Of `hoopgen.coach`.
    title
        Above the picture.

    Returns
    -------
    Figure
        A panel for each, seen from above; the shooter is below. Shots that touch the board first
        come down on the path that they had.
    """
    changed = [("now", found.player, found.made)]
    for one in found.spreads:
        sd = {**found.player.sd, one.variable: one.after}
        changed.append(
            (f"steadier: {_SHORT[one.variable]}", replace(found.player, sd=sd), one.made)
        )
    height = min(_MAX_HEIGHT, (PAGE - _LEFT) / len(changed) + _AROUND)
    figure = Picture(figsize=(PAGE, height), layout="constrained")
    panels = figure.subplots(1, len(changed), sharex=True, sharey=True, squeeze=False)[0]
    for axes, (label, player, made) in zip(panels, changed, strict=True):
        _draw(axes, player, found)
        axes.set_title(f"{label}\n{format_percent(made)} made", fontsize=7.5)
        axes.label_outer()
        axes.tick_params(labelsize=7.5)
    short = DISPLAY_UNITS[found.units]["short"]
    panels[0].set_ylabel(f"past the centre ({short.symbol})", fontsize=7.5)
    figure.supxlabel(f"to the right ({short.symbol}); blue went in, orange did not", fontsize=7.5)
    if title:
        figure.suptitle(title, x=0.01, ha="left", fontsize=9)
    return figure


def _draw(axes: Axes, player: Scatter, found: Coaching) -> None:
    depth, right, made = _shots(player, found)
    for which, colour in ((made, _MADE), (~made, _MISSED)):
        axes.scatter(right[which], depth[which], s=3.5, color=colour, alpha=0.6, lw=0, zorder=2)
    size = DISPLAY_UNITS[found.units]["short"].size
    ring, reach = float(found.parameters["ring_radius"]) / size, _REACH / size
    axes.add_patch(Circle((0.0, 0.0), ring, fill=False, ec=COLOURS["ring"], lw=2.2, zorder=3))
    board = float(found.parameters["board_distance"]) / size
    if board < reach:
        axes.plot([-reach, reach], [board, board], color=INK, lw=1.4, zorder=1)
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal")
    ticks = [way * _TICKS[found.units] for way in (-1, 0, 1)]
    axes.set_xticks(ticks)
    axes.set_yticks(ticks)


def _shots(player: Scatter, found: Coaching) -> tuple[Any, Any, NDArray[np.bool_]]:
    """Return depth and distance to the right at the ring, in short units, and which are made."""
    drawn = player.draw(0, _DOTS, 0, found.parameters)
    shots = simulate(drawn.states, drawn.parameters, scene=found.scene)
    where = measure(drawn.states, shots, drawn.parameters, ["depth", "left_right"])
    size = DISPLAY_UNITS[found.units]["short"].size
    return where["depth"] / size, -where["left_right"] / size, np.asarray(shots.made)


@check_arguments
def write_coach_page(found: Coaching, path: str | os.PathLike[str], *, read: str = "") -> Path:
    """Write a page for players, one file that needs no other.

    Parameters
    ----------
    found
        Of `hoopgen.coach`.
    path
        The file, .html.
    read
        Of measured releases, how the table was read, for the end of the page.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ValueError
        If the file's name does not end in .html.
    OSError
        If the file cannot be written.
    """
    target = Path(path)
    if target.suffix.lower() not in (".html", ".htm"):
        raise ValueError(f"out: expected a file .html, got {path}")
    check_output(target)
    return write(target, _page(found, read))


def _page(found: Coaching, read: str = "") -> str:
    """Return the page, HTML, with all texts escaped."""
    where = "Your shots" if found.place is None else f"Your {found.place.name}s"
    if found.place is not None and found.place.name.endswith(("key", "court")):
        where = f"Your shots from the {found.place.name}"
    level = format_percent(found.confidence, None)
    body = [
        f"<h1>{html.escape(where)}</h1>",
        f"<p class=made>You make <b>{format_percent(found.made)}</b> "
        f"({format_interval(found.low, found.high)}).</p>",
        f"<p class=advice>{html.escape(found.advice)}</p>",
        "<h2>Where your shots come down</h2>",
        "<p>The ring from above, you stand below. Each dot is the middle of the ball in one of "
        f"{_DOTS} simulated shots. The first panel is you now; in each other one, half of one part "
        "of your spread is gone.</p>",
        _image(plot_coach_shots(found), "where shots come down, before and after"),
        "<h2>Make one part steadier</h2>",
        _table("half the spread of", found.spreads, level, found.units),
        "<h2>Or change a habit</h2>",
        "<p>The spread stays as it is; the speed goes with the arc and the aim.</p>",
        _table("change", found.habits, level, found.units),
        _image(plot_coach(found), "how many more of a hundred shots go in with each change"),
        "<h2>What this rests on</h2>",
        f"<p>{html.escape(found.provenance)} Each number is of simulated shots; the intervals "
        f"({level}) are those of the simulation and, of measured releases, of the sample. "
        "Halving a spread is a comparison of parts, not a promise of what practice reaches.</p>",
    ]
    body.append(f"<p>{html.escape(sentences(found.origin, scene=True))}</p>")
    if found.place is not None:
        body.append(f"<p>{html.escape(found.place.source)}</p>")
    if read:
        body.append(f"<pre>{html.escape(read)}</pre>")
    return _PAGE.format(title=html.escape(where), body="\n".join(body))


def _table(head: str, rows: Sequence[Advice], level: str, units: System) -> str:
    cells = [
        "<tr>"
        + "".join(f"<th>{one}</th>" for one in (head, "from", "to", "made before", "made after"))
        + f"<th>more in a hundred</th><th>{level} interval</th></tr>"
    ]
    best = max((one.gain for one in rows), default=0.0)
    for one in rows:
        ends = [say(one.variable, value, units) for value in (one.before, one.after)]
        values = [one.name, *ends, format_percent(one.made - one.gain), format_percent(one.made)]
        values += [
            format_points(one.gain),
            f"{format_points(one.low)} to {format_points(one.high)}",
        ]
        mark = " class=best" if one.gain == best > 0.0 and one.low > 0.0 else ""
        cells.append(
            f"<tr{mark}>" + "".join(f"<td>{html.escape(value)}</td>" for value in values) + "</tr>"
        )
    return "<table>" + "".join(cells) + "</table>"


def _image(figure: Any, about: str) -> str:
    stream = io.BytesIO()
    with style():
        figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": "hoopgen"})
    data = base64.b64encode(stream.getvalue()).decode()
    return f'<img alt="{html.escape(about)}" src="data:image/svg+xml;base64,{data}">'


_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy"
 content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<title>{title}</title>
<style>
body {{ font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 60rem; margin: 2rem auto;
  padding: 0 1rem; }}
h1 {{ margin-bottom: 0; }}
h2 {{ margin: 2rem 0 0.4rem; font-size: 1.2rem; }}
.made {{ font-size: 1.3rem; margin: 0.2rem 0; }}
.advice {{ background: #eaf3fa; border-left: 5px solid #1b6ca8; padding: 0.8rem 1rem;
  font-size: 1.15rem; }}
table {{ border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }}
th, td {{ text-align: right; padding: 0.35rem 0.5rem; border-bottom: 1px solid #ddd; }}
th {{ font-weight: 600; font-size: 0.85rem; color: #555; }}
th:first-child, td:first-child {{ text-align: left; }}
.best td {{ background: #eaf3fa; font-weight: 600; }}
img {{ width: 100%; height: auto; margin: 0.5rem 0; }}
pre {{ white-space: pre-wrap; color: #555; font-size: 0.85rem; }}
@media (max-width: 40rem) {{ table {{ display: block; overflow-x: auto; }} }}
</style></head><body>
{body}
</body></html>
"""
