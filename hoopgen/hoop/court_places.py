"""Named places of the court from which shots are taken, by the rule books.

The measures are those of `court_lines`, where the rule books are named. A player stands behind a
line, and releases the ball about above it: a place is on the outer edge of its line. Left and right
are as the shooter sees them who faces the basket; a place without a side is that on the right.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import atan2, hypot, sqrt
from types import MappingProxyType

from hoopgen.core.argument_types import check_mapping
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.units import INCH
from hoopgen.core.validation import as_doubles
from hoopgen.text.shorten import brief, suggestion

from .court_lines import COURTS, Court, court_of
from .presets import FIBA, PAPER


@dataclass(frozen=True)
class Place:
    """A place on the floor.

    Attributes
    ----------
    name
        As in `PLACES`, with a side where there are two.
    court
        Of the rule book, "NBA" or "FIBA".
    x, y
        From the ring's centre, m; +x away from the board, +y to the shooter's right.
    source
        What the rule book says, in words.
    """

    name: str
    court: str
    x: float
    y: float
    source: str

    @property
    def distance(self) -> float:
        """The distance to the ring's centre on the floor plan, m."""
        return hypot(self.x, self.y)

    @property
    def angle(self) -> float:
        """The angle around the ring, rad: 0 straight in front of the board."""
        return atan2(self.y, self.x)

    @property
    def variables(self) -> dict[str, float]:
        """Return `distance` and `angle`, variables of a release."""
        return {"distance": self.distance, "angle": self.angle}


@dataclass(frozen=True)
class _Rule:
    """A place by the measures of a court and its board's distance, in the rule book's words."""

    at: Callable[[Court, float], tuple[float, float]]
    source: str
    sides: bool = False


PLACES: Mapping[str, _Rule] = MappingProxyType(
    {
        "free throw": _Rule(
            lambda court, board: (court.free_throw - board, 0.0),
            "the free-throw line, {free_throw} from the board",
        ),
        "top of the key": _Rule(
            lambda court, board: (court.free_throw - board + court.circle, 0.0),
            "where the free-throw circle ends, {circle} beyond the free-throw line, which is "
            "{free_throw} from the board",
        ),
        "elbow": _Rule(
            lambda court, board: (court.free_throw - board, 0.5 * court.lane),
            "where the free-throw line, {free_throw} from the board, meets the side of the lane, "
            "{lane} wide",
            True,
        ),
        "top three": _Rule(
            lambda court, board: (court.arc, 0.0),
            "the three-point line, {arc} from the ring's centre",
        ),
        "wing three": _Rule(
            lambda court, board: (court.arc * sqrt(0.5), court.arc * sqrt(0.5)),
            "the three-point line, {arc} from the ring's centre, 45 degrees to the side",
            True,
        ),
        "corner three": _Rule(
            lambda court, board: (0.0, court.corner),
            "the three-point line in the corner, {corner} from the middle of the court, level with "
            "the ring's centre",
            True,
        ),
        "half court": _Rule(
            lambda court, board: (court.half_length - court.baseline - board, 0.0),
            "the middle of the division line, {half_length} from the baseline",
        ),
    }
)
"""Places by name. The article's, the NBA's and other hoops have the NBA's court, FIBA's its own."""

_ALIASES = {
    "free throw line": "free throw",
    "foul line": "free throw",
    "key": "top of the key",
    "top of key": "top of the key",
    "top of the arc": "top three",
    "straight on three": "top three",
    "three": "top three",
    "corner": "corner three",
    "wing": "wing three",
    "division line": "half court",
    "halfcourt": "half court",
}

_SIDES = ("left", "right")
_SPELLED = {"3": "three", "3pt": "three", "pointer": ""}


def _plain(name: str) -> str:
    words = name.lower().replace("-", " ").replace("_", " ").split()
    return " ".join(filter(None, (_SPELLED.get(word, word) for word in words)))


def find_place(
    name: str, parameters: ParameterValues | None = None, court: str | None = None
) -> Place:
    """Return a named place.

    Parameters
    ----------
    name
        One of `PLACES`, with "left" or "right" before it where there are two; hyphens and capital
        letters do not matter, and 3 is three.
    parameters
        Of the hoop, by which the court is that of the NBA or of FIBA, and from whose board lines
        are measured; by default `hoopgen.PAPER`, for FIBA's court `hoopgen.FIBA`.
    court
        "NBA" or "FIBA", whatever the parameters are.

    Raises
    ------
    TypeError, ValueError
        If there is no such place or court.
    """
    if not (court is None or (isinstance(court, str) and court in COURTS)):
        raise ValueError(f"court: expected {' or '.join(COURTS)}, got {brief(court)}")
    hoop = parameters
    if hoop is None:
        hoop = FIBA if court == "FIBA" else PAPER
    check_mapping("parameters", hoop)
    if not isinstance(name, str):
        raise TypeError(f"place: expected the name of a place, got {brief(name)}")
    words = _plain(name)
    side, _, rest = words.partition(" ")
    if side not in _SIDES:
        side, rest = "", words
    plain = _ALIASES.get(rest, rest)
    if plain not in PLACES or (side and not PLACES[plain].sides):
        two = ", ".join(one for one, rule in PLACES.items() if rule.sides)
        raise ValueError(
            f"place: expected one of {', '.join(PLACES)}, with left or right before {two}; "
            f"got {brief(name)}{suggestion(rest, [*PLACES, *_ALIASES])}"
        )
    book = court_of(hoop) if court is None else court
    measures, rule = COURTS[book], PLACES[plain]
    given = hoop.get("board_distance", PAPER["board_distance"])
    board = as_doubles("parameters['board_distance']", given)
    if board.ndim:
        raise ValueError(
            f"parameters['board_distance']: a place needs one number, got {brief(given)}"
        )
    x, y = rule.at(measures, float(board))
    said = rule.source.format_map({key: _length(book, size) for key, size in _sizes(measures)})
    label = f"{side or 'right'} {plain}" if rule.sides else plain
    return Place(label, book, x, -y if side == "left" else y, f"{book} rules: {said}")


def place(
    name: str, parameters: ParameterValues | None = None, court: str | None = None
) -> dict[str, float]:
    """Return the distance and the angle of a named place of the court.

    They are variables of a release: ``hoopgen.release(7.2, 0.9, height=2.1, **place("elbow"))``,
    or ``Scatter({"speed": 7.2, ..., **place("left corner three", hoopgen.FIBA)})``.

    Parameters
    ----------
    name
        One of `hoopgen.hoop.court_places.PLACES`, such as "free throw" or "corner three"; with
        "left" or "right" before it where there are two, as the shooter sees them.
    parameters
        Of the hoop, which say whether the court is the NBA's or FIBA's; by default the NBA's.
    court
        "NBA" or "FIBA", whatever the parameters are.

    Returns
    -------
    dict
        distance, m, and angle, rad.

    Raises
    ------
    TypeError, ValueError
        If there is no such place or court.
    """
    return find_place(name, parameters, court).variables


def _sizes(court: Court) -> list[tuple[str, float]]:
    return [(name, size) for name, size in vars(court).items() if not isinstance(size, bool)]


def _length(book: str, size: float) -> str:
    """Return a measure of a rule book in its own unit."""
    if book == "FIBA":
        return f"{size:.4g} m"
    feet, inches = divmod(round(size / INCH), 12)
    return f"{feet} ft {inches} in" if inches else f"{feet} ft"
