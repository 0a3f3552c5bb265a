"""Questions, each specified once: its settings are the fields of a dataclass.

They are keywords of a Python function, options of a command and keys of a study file.
`hoopgen.cli.question_options` makes options of them, `hoopgen.studyfile.schema` tables of a study
file, and a test compares the signatures of the functions.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, ClassVar, Literal, TypeAlias

from hoopgen.core.units import System
from hoopgen.hoop.variables import VARIABLES

from . import settings as of
from .settings import RELEASE, RESULTS, Path, TableSettings, setting
from .values import (
    AXES,
    BOUNDS,
    CHANGE,
    OUTPUT,
    PLACES,
    Choice,
    Flag,
    Listed,
    Quantities,
    Quantity,
    Share,
    Text,
    Whole,
)

MARGINS = ("speed", "elevation", "azimuth", "backspin", "height", "distance")
"""Variables whose margins are given unless others are asked for."""

TOLERANCES = ("speed", "elevation", "azimuth")
"""Variables of an aimed release of which it is found how far one alone may be off."""

Ranges: TypeAlias = Mapping[str, tuple[float, float] | None] | Sequence[str]

_over = partial(
    setting,
    "Variables to search over; without bounds, over the usual range.",
    BOUNDS,
    file='`["elevation", "aim"]`, or `over.elevation = ["45 deg", "60 deg"]`.',
)
_search_shots = partial(
    setting,
    "Number of shots of the last step of the search, and of the fresh estimate. With measured "
    "releases each row judges once, for a release that was found without it.",
    Whole(),
)
_figures = partial(setting, default=(), option=None, argument=False)


@dataclass(frozen=True, kw_only=True)
class EstimateQuestion:
    """The probability that a shot is made; in a scene of one's own, that of each end."""

    shared: ClassVar = (of.Sampling, of.Engines, of.Computation)
    shots: int | None = of.shots()
    precision: float | None = of.precision()
    max_contacts: int | None = of.max_contacts()
    measures: Sequence[str] = of.measures(
        "Measures whose distribution is described; of rebound_angle, the rebounds by direction."
    )
    catching_height: float = of.catching_height()
    gradient: Sequence[str] = setting(
        "At a hoop: derivatives of the probability by the means and deviations of what scatters, "
        "and by parameters of the scene.",
        Listed(Text(words="a name", metavar="NAME")),
        (),
        command="Such as mean.speed, sd.elevation or restitution.",
        file='`["mean.speed", "sd.elevation", "restitution"]`.',
    )
    figures: Sequence[str] = _figures(
        "Paths of the first shots; where misses reach the floor; where they come down to the "
        "catching height.",
        Listed(Choice(("fan", "landings", "rebounds"))),
    )


@dataclass(frozen=True, kw_only=True)
class CompareQuestion:
    """The change of the probability between two settings, over the same random numbers."""

    shared: ClassVar = (of.Sampling, of.Engines, of.Computation)
    versus: Any = setting(
        "Changes to compare with, over the same random numbers.",
        CHANGE,
        argument=False,
        file="They stand in the tables of where shots come from: `versus.release.backspin = 0`.",
    )
    shots: int | None = of.shots()
    precision: float | None = of.precision()
    by: str | None = of.end()
    max_contacts: int | None = of.max_contacts()


@dataclass(frozen=True, kw_only=True)
class SolveQuestion:
    """The factor times all of the scatter with which a wanted share of the shots is made."""

    shared: ClassVar = (of.Sampling, of.Engines, of.Computation)
    share: float = setting(
        "Share of shots made for which the factor of the scatter is found: 0.7 for a player "
        "who makes 70%.",
        Share(percent=True),
        option="solve",
    )
    by: str | None = of.end()
    shots: int | None = setting(
        "Number of shots with each factor, and of the fresh estimate at the one found; by default "
        "100,000.",
        Whole(),
        None,
    )
    max_contacts: int | None = of.max_contacts()


@dataclass(frozen=True, kw_only=True)
class MapQuestion:
    """The probability that a shot is made over its variables; without scatter, its outcome."""

    shared: ClassVar = (of.Sampling, of.Engines, of.Computation)
    over: Mapping[str, Any] = setting(
        "Variables and their values, which replace those of the release.",
        AXES,
        command="Such as elevation=45deg:60deg:61 or restitution=0.6,0.7,0.8.",
        file='`over.elevation = { from = "45 deg", to = "60 deg", count = 31 }`, or a list. The '
        "first is drawn across.",
    )
    shots: int | None = setting(
        "Number of shots of each cell, with scatter; by default 10,000.", Whole(), None
    )
    max_contacts: int | None = of.max_contacts()
    figures: Sequence[str] = _figures("The map.", Listed(Choice(("map",))))


@dataclass(frozen=True, kw_only=True)
class OptimumQuestion:
    """The release with the greatest probability, and what it forgives."""

    shared: ClassVar = (of.Sampling, of.Computation)
    over: Ranges = _over()
    by: str = of.success()
    shots: int = _search_shots(100_000)
    tolerance: float = of.tolerance()
    margins: Sequence[str] | None = setting(
        f"Variables whose margins are computed; by default {', '.join(MARGINS)}.",
        Listed(Choice(tuple(VARIABLES))),
        None,
        option=None,
    )


@dataclass(frozen=True, kw_only=True)
class BankQuestion:
    """The best bank shot against the best direct shot, from places on the court."""

    shared: ClassVar = (of.Sampling, of.Computation)
    places: Any = setting(
        "Distance and angle, or x and y: every combination is a place.",
        PLACES,
        argument=False,
        command="Such as distance=2m:5m:4, in place of one place.",
    )
    over: Ranges = _over(
        default=("elevation", "aim", "azimuth"),
        command="By default elevation, aim and azimuth, those that are not given.",
    )
    shots: int = _search_shots(20_000)
    figures: Sequence[str] = _figures(
        "Where bank shots touch the board, and from where they are better.",
        Listed(Choice(("aim_points",))),
    )


@dataclass(frozen=True, kw_only=True)
class AimQuestion:
    """The release through the ring's centre from each distance, and what it forgives: a table.

    Height, angle and spins are those of the release. Of `entry`, `elevation` and `speed` one may
    be given; without, it is the slowest release.
    """

    shared: ClassVar = (of.Computation,)
    distance: Any = setting(
        "Distance on the floor plan to the ring's centre; several give a table.",
        Quantities("length"),
        command="Such as 3m,4m,5m or 1m:7m:0.5m, whose last part is the step, a length too.",
        heading=RELEASE,
    )
    entry: float | None = setting(
        "Wanted angle below the horizontal at the ring.", Quantity("angle"), None, heading=RELEASE
    )
    elevation: float | None = setting(
        "Wanted angle of release above the horizontal.", Quantity("angle"), None, heading=RELEASE
    )
    speed: float | None = setting(
        "Wanted speed at release.", Quantity("speed"), None, heading=RELEASE
    )
    arc: Literal["high", "low"] = setting(
        "High or low flight of the two with that speed.", Choice(("high", "low")), "high"
    )
    depth: float = setting("Distance past the ring's centre of the aim.", Quantity("length"), 0.0)
    by: str = of.success()


@dataclass(frozen=True, kw_only=True)
class Tallies:
    """The outputs besides the results of a table."""

    by: str | None = setting(
        "Count results also by the values of a column, with intervals.",
        Text(metavar="COLUMN"),
        None,
    )
    events: Path | None = setting(
        ".csv, .parquet or .arrow: the event log, a row for each event of each row.",
        OUTPUT,
        None,
        heading=RESULTS,
    )
    units: System = of.table_units()
    reason: bool = setting(
        "Add a column with the reason why a row is invalid.", Flag(), False, heading=RESULTS
    )


@dataclass(frozen=True, kw_only=True)
class BatchQuestion(TableSettings):
    """A table of releases, simulated row by row.

    Of where shots come from it takes the scene, and what its own `release` says, which all rows
    share.
    """

    shared: ClassVar = (of.Parsing, Tallies, of.Workers)
    file: str = of.table_file()
    measures: Sequence[str] = of.measures("Columns to add.")
    catching_height: float = of.catching_height()
    prefix: str = setting(
        "Prefix of the names of the results' columns.", Text(r".*", "text"), "", heading=RESULTS
    )
    max_contacts: int | None = of.max_contacts()


@dataclass(frozen=True, kw_only=True)
class CounterfactualQuestion:
    """The smallest changes of a release with which its shot ends otherwise."""

    shared: ClassVar = ()
    vary: Sequence[str] | None = setting(
        "Variable to change, each alone; by default speed, elevation and azimuth, in a scene "
        "of your own vx, vy and vz. Parameters of the scene are variables, too.",
        Listed(Text(words="a variable's name", metavar="NAME")),
        None,
    )
    by: str | None = of.end()
    steady: float = setting(
        "Share of a change for which the other result must continue beyond it; 0 accepts the "
        "nearest change, however narrow its interval is.",
        Quantity("number", low=0.0),
        0.05,
    )
    max_contacts: int | None = of.max_contacts()
    prove: bool = setting(
        "Prove the results on both sides of each change in ball arithmetic.",
        Flag(),
        True,
        option=None,
    )


@dataclass(frozen=True, kw_only=True)
class FanQuestion:
    """Paths of a player's shots, seen from the side."""

    shared: ClassVar = (of.Seeded, of.Engines, of.Threads)
    shots: int = setting("Number of shots from which the shares are computed.", Whole(), 2_000)
    paths: int = setting("Number of paths drawn, those of the first shots.", Whole(), 150)
    max_contacts: int | None = of.max_contacts()


@dataclass(frozen=True, kw_only=True)
class LandingsQuestion:
    """Places where a player's misses come down."""

    shared: ClassVar = (of.Seeded, of.Engines, of.Threads)
    shots: int = setting("Number of shots.", Whole(), 200_000)
    catching_height: float | None = setting(
        "Show rebounds in place of landings: the places, times and directions at which the "
        "ball's centre comes down to this height above the floor.",
        Quantity("length"),
        None,
    )
    max_contacts: int | None = of.max_contacts()


QUESTIONS: Mapping[str, Any] = {
    "estimate": EstimateQuestion,
    "compare": CompareQuestion,
    "solve": SolveQuestion,
    "map": MapQuestion,
    "optimum": OptimumQuestion,
    "bank": BankQuestion,
    "aim": AimQuestion,
    "batch": BatchQuestion,
}
"""Questions of a study file, by their kind."""
