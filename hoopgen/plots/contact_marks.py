"""Numbered badges of contacts, and the legend that explains them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from hoopgen.core.event_log import Event, impacts, rolls
from hoopgen.results.shots import SURFACES

from .label_placement import Box, place_labels
from .occlusion import is_hidden
from .style import COLOURS, POINTS_PER_INCH, letter
from .views import Points, View

LEGEND_ROW = 0.22
"""Height of a row of the key, inches."""

_LEGEND_COLUMN = 1.68
_MIN_BADGE_WIDTH, _BADGE_GAP = 0.4, 0.03  # room for a badge, at least, and after it, inches
_TEXT_SIZE = 7.0
_MAX_BADGES = 60
"""Badges of contacts, at most; a shot of the article's has 40 contacts."""

_MERGE_DISTANCE = 0.75  # ball radii: contacts nearer together than this share a badge
_SHAPES = {"ring": "round,pad=0.3,rounding_size=0.75", "backboard": "square,pad=0.3"}
_SHAPE = "round,pad=0.3,rounding_size=0.2"


@dataclass(frozen=True)
class Mark:
    """A contact, or several in a row at one place, that a badge marks.

    Attributes
    ----------
    label
        In the badge: ``"2"``, ``"9-40"``, ``"rolls"``, ``"end"``; empty for what has no place.
    kind
        A surface's name, ``"release"`` or ``"end"``; of another scene, ``"body"``; of the dashed
        line where shots end ``"line"``, which is in the key alone.
    text
        In the key; empty for none.
    position
        Of the ball's centre, shape (3,), m.
    own
        The colour of a body of another scene.
    time
        When it comes to be, s.
    """

    label: str
    kind: str
    text: str
    position: Points
    own: str = ""
    time: float = 0.0

    @property
    def colour(self) -> str:
        """The colour of the badge."""
        return self.own or COLOURS["end" if self.kind == "line" else self.kind]


def collect_marks(
    release: Points,
    events: NDArray[Any],
    ball_radius: float,
    outcome: IntEnum | None,
    bodies: Mapping[str, str] | None = None,
    line: str = "",
) -> tuple[Mark, ...]:
    """Turn a shot's events into badges: release, contacts, and the end.

    Parameters
    ----------
    release
        Where the ball starts.
    events
        Of the shot.
    ball_radius
        m.
    outcome
        If it is to be said.
    bodies
        Of another scene than the hoop, in the order of its results, and their colours.
    line
        What the dashed line is where shots end; empty where none is drawn.
    """
    names = SURFACES if bodies is None else tuple(bodies)
    contacts = impacts(events)
    marks = [Mark("release", "release", "", release)]
    groups = _groups(contacts, _MERGE_DISTANCE * ball_radius)
    marks += [_contact_mark(contacts, first, last, bodies) for first, last in groups]
    if groups and (more := len(contacts) - 1 - groups[-1][1]):
        marks.append(Mark("", "end", f"and {more:,} contacts more", release))
    said = "" if outcome is None else f", {outcome.name.lower()}"
    for row, _, _ in rolls(events)[:_MAX_BADGES]:
        marks += _roll_marks(events, row, names, bodies)
    if len(events) and events["surface"][-1] == len(names):
        end = events[-1]
        time = float(end["time"])
        marks.append(Mark("end", "end", f"{time:.3f} s{said}", end["before"][:3], time=time))
    elif outcome is not None:
        said = _why_unended(outcome, len(contacts), hoop=bodies is None)
        marks.append(Mark("", "end", said, release))
    if line:
        marks.append(Mark("", "line", line, release))
    return tuple(marks)


def _why_unended(outcome: IntEnum, contacts: int, *, hoop: bool) -> str:
    """Describe why a shot has no end."""
    if outcome.name == "CAPPED":
        return f"capped after {contacts} contacts"
    return f"{outcome.name.lower()}{': not down through the end plane' if hoop else ''}"


def _roll_marks(
    events: NDArray[Any], row: int, names: tuple[str, ...], bodies: Mapping[str, str] | None
) -> Iterator[Mark]:
    """Mark where contact begins that lasts, and where the ball leaves."""
    event, after = events[row], events[row + 1]
    name = names[int(event["surface"])]
    kind, own = (name, "") if bodies is None else ("body", bodies[name])
    text = f"{name} {event['time']:.3f}\N{EN DASH}{after['time']:.3f} s"
    yield Mark("rolls", kind, text, event["before"][:3], own, float(event["time"]))
    if after["kind"] == Event.LEAVE:
        time = float(after["time"])
        yield Mark("leaves", kind, f"{name} {time:.3f} s", after["before"][:3], own, time)


def _groups(contacts: NDArray[Any], reach: float) -> list[tuple[int, int]]:
    """Group the contacts into runs on one surface within reach of the run's first one.

    There are no more than have room for a badge.
    """
    groups: list[tuple[int, int]] = []
    for row in range(len(contacts)):
        if groups:
            first = groups[-1][0]
            away = contacts["before"][row, :3] - contacts["before"][first, :3]
            same = contacts["surface"][row] == contacts["surface"][first]
            if same and np.linalg.norm(away) < reach:
                groups[-1] = (first, row)
                continue
        if len(groups) == _MAX_BADGES:
            break
        groups.append((row, row))
    return groups


def _contact_mark(
    contacts: NDArray[Any], first: int, last: int, bodies: Mapping[str, str] | None
) -> Mark:
    name = (*(bodies or SURFACES),)[int(contacts["surface"][first])]
    kind, own = (name, "") if bodies is None else ("body", bodies[name])
    start, stop = float(contacts["time"][first]), float(contacts["time"][last])
    position = contacts["before"][first, :3]
    if first == last:
        return Mark(f"{first + 1}", kind, f"{name} {start:.3f} s", position, own, start)
    text = f"{name} {start:.3f}\N{EN DASH}{stop:.3f} s"
    return Mark(f"{first + 1}\N{EN DASH}{last + 1}", kind, text, position, own, start)


def draw_badges(
    axes: Axes,
    view: View,
    marks: tuple[Mark, ...],
    obstacles: Points,
    bounds: tuple[float, float, float, float],
    ball_radius: float,
    scale: float,
    bodies: Sequence[Patch],
) -> None:
    """Draw each badge near its ball, with a line to the ball's centre.

    Where a body hides the centre, the line is dashed and its end hollow.

    Parameters
    ----------
    axes, view
        Where, and from where it is seen.
    marks
        What to label; those without a place in the scene are left out.
    obstacles
        Points in the picture better left visible, shape (n, 2).
    bounds
        Left, right, bottom, top of the picture, m.
    ball_radius
        m.
    scale
        Inches of the picture per metre.
    bodies
        The shapes of the bodies.
    """
    shown = [mark for mark in marks if mark.label]
    boxes = [_box(mark, view, ball_radius, scale) for mark in shown]
    places = place_labels(boxes, obstacles, bounds)
    centres = np.array([mark.position for mark in shown]).reshape(-1, 3)
    behind = is_hidden(bodies, view, centres).tolist()
    for mark, box, centre, covered in zip(shown, boxes, places, behind, strict=True):
        colour = mark.colour
        axes.plot(
            [box.anchor[0], centre[0]],
            [box.anchor[1], centre[1]],
            color=colour,
            lw=0.6,
            ls=(0, (3, 2)) if covered else "-",
            zorder=90,
            marker="o",
            ms=2.6,
            mfc=COLOURS["paper"] if covered else colour,
            mew=0.6 if covered else 1.0,
            markevery=[0],
        )
        _write_badge(axes, centre, mark)


def _box(mark: Mark, view: View, ball_radius: float, scale: float) -> Box:
    points = POINTS_PER_INCH * scale  # per metre
    width = _badge_width(mark) / points
    at = view.flatten(mark.position)
    return Box(
        (float(at[0]), float(at[1])), ball_radius + 2.0 / points, width, 1.9 * _TEXT_SIZE / points
    )


def _badge_width(mark: Mark) -> float:
    """Return the approximate width of a badge, points."""
    return 0.68 * _TEXT_SIZE * len(mark.label) + 6.0


def _write_badge(axes: Axes, centre: tuple[float, float], mark: Mark) -> Artist:
    colour = mark.colour
    disc = mark.kind in ("ring", "body") and len(mark.label) == 1
    hollow = mark.kind in ("bridge", "release", "end")
    return axes.text(
        *centre,
        mark.label,
        ha="center",
        va="center",
        fontsize=_TEXT_SIZE,
        fontweight="bold",
        color=colour if hollow else COLOURS["paper"],
        zorder=100,
        bbox={
            "boxstyle": "circle,pad=0.22" if disc else _SHAPES.get(mark.kind, _SHAPE),
            "fc": COLOURS["paper"] if hollow else colour,
            "ec": colour,
            "lw": 0.8,
        },
    )


def mark_legend_rows(marks: tuple[Mark, ...], width: float) -> int:
    """Return the number of rows of the legend on a page of a width, inches.

    Parameters
    ----------
    marks
        The marks.
    width
        The width of the page, inches.
    """
    entries = sum(bool(mark.text) for mark in marks)
    return -(-entries // _columns(marks, width))


def draw_mark_legend(
    figure: Figure, marks: tuple[Mark, ...], left: float, bottom: float
) -> list[tuple[Mark, list[Artist]]]:
    """Draw the legend at a place in inches; return its entries and their artists.

    Parameters
    ----------
    figure
        The page.
    marks
        The marks.
    left, bottom
        The place of the legend, inches.
    """
    width, height = figure.get_size_inches()
    entries = [mark for mark in marks if mark.text]
    columns = _columns(marks, width - left)
    rows = -(-len(entries) // columns)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), label="key", zorder=-1)
    axes.set_axis_off()
    axes.set_xlim(0.0, width)
    axes.set_ylim(0.0, height)
    drawn: list[tuple[Mark, list[Artist]]] = []
    for number, mark in enumerate(entries):
        row, column = divmod(number, columns)
        x = left + column * _column(marks)
        y = bottom + (rows - row - 0.5) * LEGEND_ROW
        parts: list[Artist] = []
        if mark.label:
            parts.append(_write_badge(axes, (x + _entry_indent(mark) / 2.0, y), mark))
        elif mark.kind == "line":
            ends = [x + 0.06, x + _MIN_BADGE_WIDTH - 0.02]
            parts += axes.plot(ends, [y, y], color=mark.colour, lw=0.9, ls=(0, (5, 3)))
        at = x + (_entry_indent(mark) + _BADGE_GAP if _entry_indent(mark) else 0.1)
        parts.append(axes.text(at, y, mark.text, ha="left", va="center", fontsize=_TEXT_SIZE + 0.5))
        drawn.append((mark, parts))
    return drawn


def _entry_indent(mark: Mark) -> float:
    """Return the width of the badge before a text of the legend, inches."""
    if not mark.label:
        return _MIN_BADGE_WIDTH if mark.kind == "line" else 0.0
    return max(_MIN_BADGE_WIDTH, _badge_width(mark) / POINTS_PER_INCH)


def _column(marks: tuple[Mark, ...]) -> float:
    """Return the width of a column of the legend, inches: that of its longest entry."""
    wide = (
        _entry_indent(mark) + 2.0 * _BADGE_GAP + 0.1 + letter(_TEXT_SIZE + 0.5) * len(mark.text)
        for mark in marks
        if mark.text
    )
    return max(_LEGEND_COLUMN, *wide, _LEGEND_COLUMN)


def _columns(marks: tuple[Mark, ...], width: float) -> int:
    return max(1, int((width + 0.1) // _column(marks)))
