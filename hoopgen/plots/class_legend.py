"""Colours of shots by outcome and kind, and the legends that explain them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.colours import outcome_colours
from hoopgen.hoop.kinds import Kind
from hoopgen.results.shots import Outcome

from .style import LINES, MADE, MISSED, NOTE_SIZE, OTHER_OUTCOME_COLOURS, letter


@dataclass(frozen=True)
class Class:
    """A class of shots with one colour: an outcome and, if made or missed, a kind.

    Attributes
    ----------
    outcome
        Name of a `Outcome`, in lower case.
    kind
        Name of a `Kind`, in lower case; empty where the shot is neither made nor missed.
    colour, line
        Of areas that stand for its shots, and of their paths.
    width, dashes
        Of paths: points, 0 for that of the picture, and lengths of lines and gaps, none for a solid
        line.
    """

    outcome: str
    kind: str
    colour: str
    line: str
    width: float = 0.0
    dashes: tuple[float, ...] = ()

    @property
    def words(self) -> str:
        """The name of the class in words."""
        return ", ".join([self.outcome, *filter(None, self.kind.split("_"))])

    @property
    def stroke(self) -> Any:
        """The line style of its paths, of matplotlib."""
        return (0, self.dashes) if self.dashes else "-"


def _classes() -> tuple[Class, ...]:
    return (
        *(Class("made", kind, colour, LINES["made"][kind]) for kind, colour in MADE.items()),
        *(Class("missed", kind, colour, LINES["missed"][kind]) for kind, colour in MISSED.items()),
        *(Class(outcome, "", colour, colour) for outcome, colour in OTHER_OUTCOME_COLOURS.items()),
    )


CLASSES = _classes()
"""All that a shot can be."""


def outcome_classes(names: Sequence[str]) -> tuple[Class, ...]:
    """Return a class for each outcome of a scene: its ends, then all others."""
    ends = sum(name not in OTHER_OUTCOME_COLOURS for name in names)
    return tuple(
        Class(name, "", colour, colour) for name, colour in outcome_colours(names, ends).items()
    )


def _index() -> NDArray[np.int64]:
    """Return the index into `CLASSES` by outcome and kind; -1 if there is no such class."""
    index = np.full((len(Outcome), len(Kind)), -1)
    for place, one in enumerate(CLASSES):
        kinds = slice(None) if not one.kind else Kind[one.kind.upper()]
        index[Outcome[one.outcome.upper()], kinds] = place
    return index


_INDEX = _index()


def classify(outcome: ArrayLike, kind: ArrayLike) -> NDArray[np.int64]:
    """Return the index of each shot's class in `CLASSES`; outcome and kind have one shape.

    Parameters
    ----------
    outcome
        Codes of `hoopgen.Outcome`.
    kind
        Codes of kinds, of the same shape.

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
_PAD = 0.1
_SWATCH_ROOM = 0.3  # a swatch, and what is free around it and its name


def _columns(names: Sequence[str], width: float) -> int:
    longest = max(map(len, names), default=0)
    return max(1, int(width / (letter(NOTE_SIZE) * longest + _SWATCH_ROOM)))


def names_height(names: Sequence[str], width: float) -> float:
    """Return the height of a legend of names in a width, both in inches.

    Parameters
    ----------
    names
        The names.
    width
        The width, inches.
    """
    return -(-len(names) // _columns(names, width)) * _LINE + _PAD * bool(names)


def draw_names(figure: Figure, handles: Sequence[Artist], width: float) -> None:
    """Draw a legend of names at the foot of a page, in as many columns as fit.

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
    if not names:
        return
    figure.legend(
        handles=list(handles),
        loc="lower left",
        ncols=_columns(names, width),
        frameon=False,
        fontsize=NOTE_SIZE,
        borderaxespad=0.2,
        handlelength=1.4,
        columnspacing=1.2,
    )
