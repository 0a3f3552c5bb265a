"""What the colours of shots mean: made or missed, by kind; and the key that says so."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from numpy.typing import ArrayLike, NDArray

from hoopgen.colours import ended
from hoopgen.hoop.kinds import Kind
from hoopgen.phrases import percent
from hoopgen.plots.page import add_axes
from hoopgen.plots.style import EDGES, INK, LINES, MADE, MISSED, NEITHER, SMALL, letter
from hoopgen.results import Outcome

__all__ = [
    "CLASSES",
    "Class",
    "by_outcome",
    "classify",
    "draw_key",
    "draw_names",
    "key_height",
    "names_height",
]


@dataclass(frozen=True)
class Class:
    """Shots of one colour: one outcome and, of made and missed ones, one kind.

    Attributes
    ----------
    outcome
        Name of a `Outcome`, in lower case.
    kind
        Name of a `Kind`, in lower case; empty where the shot is neither made nor missed.
    colour, line
        Of areas that stand for its shots, and of their paths.
    """

    outcome: str
    kind: str
    colour: str
    line: str

    @property
    def words(self) -> str:
        """Say what its shots are."""
        return ", ".join([self.outcome, *filter(None, self.kind.split("_"))])


def _classes() -> tuple[Class, ...]:
    return (
        *(Class("made", kind, colour, LINES["made"][kind]) for kind, colour in MADE.items()),
        *(Class("missed", kind, colour, LINES["missed"][kind]) for kind, colour in MISSED.items()),
        *(Class(outcome, "", colour, colour) for outcome, colour in NEITHER.items()),
    )


CLASSES = _classes()
"""All that a shot can be."""


def by_outcome(names: Sequence[str]) -> tuple[Class, ...]:
    """Return a class for each outcome of a scene, in small letters: its ends, then all others."""
    ends = sum(name not in NEITHER for name in names)
    return tuple(Class(name, "", colour, colour) for name, colour in ended(names, ends).items())


def _index() -> NDArray[np.int64]:
    """Return the place in `CLASSES` by outcome and kind; -1 where no shot can be that."""
    index = np.full((len(Outcome), len(Kind)), -1)
    for place, one in enumerate(CLASSES):
        kinds = slice(None) if not one.kind else Kind[one.kind.upper()]
        index[Outcome[one.outcome.upper()], kinds] = place
    return index


_INDEX = _index()


def classify(outcome: ArrayLike, kind: ArrayLike) -> NDArray[np.int64]:
    """Return the place of each shot in `CLASSES`; outcome and kind have one shape.

    Raises
    ------
    ValueError
        If there is an outcome or a kind that is none, or both together are no shot's.
    """
    outcomes, kinds = np.asarray(outcome, dtype=np.intp), np.asarray(kind, dtype=np.intp)
    for name, codes, all_of in (("outcome", outcomes, Outcome), ("kind", kinds, Kind)):
        if codes.size and not 0 <= codes.min() <= codes.max() < len(all_of):
            allowed = ", ".join(f"{one.value} {one.name}" for one in all_of)
            raise ValueError(f"{name}: expected codes of {allowed}")
    places = _INDEX[outcomes, kinds]
    if (places < 0).any():
        where = int(np.argmax(places.ravel() < 0))
        what = Outcome(int(outcomes.flat[where])).name, Kind(int(kinds.flat[where])).name
        raise ValueError(f"kind: no shot is {what[0]} and {what[1]}")
    return np.asarray(places)


# Inches.
_LINE = 0.165
_SWATCH, _SWATCH_HEIGHT = 0.17, 0.1
_WIDEST = 0.8  # column of the key
_SAID, _UNSAID = 0.62, 0.34  # the narrowest, with shares and without
_ROWS_NAME, _LINES_NAME = 0.48, 0.75

_SIZE, _SMALL = 7.5, 6.5  # points


@dataclass(frozen=True)
class _Table:
    """The key: lines of kinds, and of outcomes that have none, against made and missed."""

    names: tuple[str, ...]
    across: bool
    step: float  # from a line to the next, inches

    @property
    def height(self) -> float:
        """Inches."""
        if self.across:
            return (3.0 + self.wrapped) * _LINE
        return (1.0 + len(self.names)) * _LINE

    @property
    def wrapped(self) -> bool:
        """Whether headings have two lines."""
        return self.across and self.step < _SAID

    def place(self, line: float, row: float) -> tuple[float, float]:
        """Return left and middle of a cell from the upper left corner; -1 is a heading."""
        if self.across:
            x = 0.0 if line < 0.0 else _ROWS_NAME + line * self.step
            return x, -(row + 1.5 + (self.wrapped if row >= 0.0 else self.wrapped / 2.0)) * _LINE
        return (0.0 if row < 0.0 else _LINES_NAME + row * _SAID), -(line + 1.5) * _LINE


def _table(shares: Mapping[Class, float] | Mapping[Class, None], width: float) -> _Table:
    """Set kinds side by side where there is room, else one above the other."""
    here = {one.kind or one.outcome for one in shares}
    names = [kind.name.lower() for kind in Kind] + list(NEITHER)
    lines = tuple(name for name in names if name in here)
    said = any(share is not None for share in shares.values())
    step = min(_WIDEST, (width - _ROWS_NAME) / max(1, len(lines)))
    return _Table(lines, step >= (_SAID if said else _UNSAID), step)


def key_height(shares: Mapping[Class, float] | Mapping[Class, None], width: float) -> float:
    """Return the height of the key in a width, inches both."""
    return _table(shares, width).height


def draw_key(
    figure: Figure,
    shares: Mapping[Class, float] | Mapping[Class, None],
    left: float,
    top: float,
    width: float,
    *,
    areas: bool = True,
    lines: bool = False,
) -> Axes:
    """Write the key: a table of kinds against made and missed.

    Parameters
    ----------
    figure
        The page.
    shares
        The classes that are in the picture, and the share of shots to be said beside each, if any.
    left, top, width
        Of the key, inches.
    areas, lines
        Whether there are areas in the picture, and whether there are paths.

    Returns
    -------
    matplotlib.axes.Axes
        Of the whole page, in inches.
    """
    across, up = (float(side) for side in figure.get_size_inches())
    axes = add_axes(figure, 0.0, 0.0, across, up, "key")
    axes.set_axis_off()
    axes.set(xlim=(0.0, across), ylim=(0.0, up))
    table = _table(shares, width)
    rows = {"made": 0.0, "missed": 1.0}
    places = {name: float(line) for line, name in enumerate(table.names)}

    def write(cell: tuple[float, float], text: str, size: float = _SIZE) -> None:
        at = left + cell[0], top + cell[1]
        axes.text(*at, text, va="center_baseline", fontsize=size, color=INK, linespacing=1.0)

    for name, line in places.items():
        words = name.replace("_", ",\n" if table.wrapped else ", ")
        write(table.place(line, -1.0), words, _SMALL if table.wrapped else _SIZE)
    for name, row in rows.items():
        if any(one.outcome == name for one in shares):
            write(table.place(-1.0, row), name)
    for one, share in shares.items():
        x, y = table.place(places[one.kind or one.outcome], rows.get(one.outcome, 0.5))
        _draw_swatch(axes, left + x, top + y, one, areas=areas, lines=lines)
        if share is not None:
            write((x + _SWATCH + 0.04, y), percent(share))
    return axes


def _draw_swatch(
    axes: Axes, left: float, middle: float, one: Class, *, areas: bool, lines: bool
) -> None:
    """Draw the colour of a class: its areas', its paths', or that of paths before that of areas."""
    corner = left, middle - _SWATCH_HEIGHT / 2.0
    fill = one.colour if areas else one.line
    axes.add_patch(Rectangle(corner, _SWATCH, _SWATCH_HEIGHT, fc=fill, ec=EDGES, lw=0.4))
    if areas and lines:
        ends = [left, left + _SWATCH]
        axes.plot(ends, [middle, middle], color=one.line, lw=2.2, solid_capstyle="butt")


# ---------------------------------------------------------------------------------- of names alone

_BESIDE = 0.36  # inches: a swatch, and what is free around it and its name


def _columns(names: Sequence[str], width: float) -> int:
    longest = max(map(len, names), default=0)
    return max(1, int(width / (letter(SMALL) * longest + _BESIDE)))


def names_height(names: Sequence[str], width: float) -> float:
    """Return the height of a key of names in a width, inches both."""
    return -(-len(names) // _columns(names, width)) * _LINE + _SWATCH_HEIGHT


def draw_names(figure: Figure, handles: Sequence[Artist], width: float) -> None:
    """Write the key at the foot of a page: names, each beside its colour, as many as fit a row.

    Parameters
    ----------
    figure
        The page.
    handles
        Lines or areas, with their labels.
    width
        There is for it, inches.
    """
    names = [str(handle.get_label()) for handle in handles]
    figure.legend(
        handles=list(handles),
        loc="lower left",
        ncols=_columns(names, width),
        frameon=False,
        fontsize=SMALL,
        borderaxespad=0.2,
        handlelength=1.4,
        columnspacing=1.2,
    )
