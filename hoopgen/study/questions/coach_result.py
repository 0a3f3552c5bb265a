"""Advice for players: the gain of each change, in feet, inches, mph, degrees and rpm."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hoopgen.core.plotting import plotting_module
from hoopgen.core.units import DEGREE, FOOT, INCH, UNITS, System, use_units
from hoopgen.hoop.court_places import Place
from hoopgen.hoop.variables import VARIABLES
from hoopgen.report.provenance import describe_scene, footer
from hoopgen.report.quantities import format_variable
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.result import Result
from hoopgen.text.numbers import MINUS, format_percent, format_points
from hoopgen.text.tables import table

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

PARTS: Mapping[str, str] = {
    "speed": "short or long (speed)",
    "elevation": "arc",
    "azimuth": "left or right",
    "backspin": "spin",
}
"""Parts of a release that scatter, in words."""

_NAMES = 9
"""Width of the column of names, in letters."""

_MPH, _RPM = UNITS["speed"]["mph"], UNITS["spin"]["rpm"]


@dataclass(frozen=True)
class Advice:
    """One change, and what it does.

    Attributes
    ----------
    name
        The part whose spread is halved, or the habit that is changed, in words.
    variable
        Of the release, whose standard deviation or mean is changed.
    before, after
        What changes, SI.
    gain
        Share made after less that before.
    low, high
        Its interval: of the simulation and, of measured releases, of the sample.
    made
        Share made after the change.
    """

    name: str
    variable: str
    before: float
    after: float
    gain: float
    low: float
    high: float
    made: float


@dataclass(frozen=True, repr=False)
class Coaching(Result):
    """The advice to a player: the gain of each change, the largest first.

    Attributes
    ----------
    made, low, high
        Share made before, and its interval.
    player
        The release and its scatter.
    place
        From where; None where the measured releases say it.
    spreads
        Each part of the spread halved alone, the largest gain first.
    habits
        Each habit changed a little, with the spread as it is, the largest gain first.
    confidence
        Of the intervals.
    provenance
        Where the player comes from.
    parameters, scene
        The hoop.
    shots
        Number of shots before and after each change.
    seed
        Of the random numbers.
    units
        Of text, pictures and pages: "us", those of players, or "si"; numbers are SI.
    """

    made: float
    low: float
    high: float
    player: Scatter
    place: Place | None
    spreads: tuple[Advice, ...]
    habits: tuple[Advice, ...]
    confidence: float
    provenance: str
    parameters: Mapping[str, Any]
    scene: SceneLike
    shots: int
    seed: int
    units: System = "us"

    @property
    def origin(self) -> dict[str, str]:
        """The scene, the number of shots and the seed, in words."""
        return {
            "scene": describe_scene(engine_of(self.scene), self.parameters),
            "shots": f"{self.shots:,} before and after each change",
            "seed": str(self.seed),
        }

    @property
    def advice(self) -> str:
        """The advice in a sentence, with what the intervals leave open."""
        if not self.spreads:
            return "Nothing scatters, so there is nothing to be made steadier."
        best, *others = self.spreads
        if best.low <= 0.0:
            return "None of the parts is certain to matter: more shots, or more measured releases."
        text = (
            f"Practise {best.name} most: with half the spread you would make "
            f"{100.0 * best.gain:.1f} more in a hundred ({_points(best)})."
        )
        tied = [one.name for one in others if one.high > best.low]
        return text + (f" Not certain to be less: {', '.join(tied)}." if tied else "")

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; SI."""
        return {
            "made": {"value": self.made, "low": self.low, "high": self.high},
            "place": None if self.place is None else vars(self.place),
            "player": self.player.identity(),
            "spreads": [_record(one) for one in self.spreads],
            "habits": [_record(one) for one in self.habits],
            "advice": self.advice,
            "confidence": self.confidence,
            "provenance": self.provenance,
            "shots": self.shots,
            "seed": self.seed,
            "scene": self.origin["scene"],
            "parameters": dict(self.parameters),
        }

    def plot(self, *, ax: Drawn | None = None, title: str = "") -> Drawn:
        """Draw the gains as bars; as of `hoopgen.plots.plot_coach`.

        Parameters
        ----------
        ax
            The axes to draw on; None makes a figure.
        title
            The title; empty for the usual one.
        """
        drawn: Drawn = plotting_module().plot_coach(self, ax=ax, title=title)
        return drawn

    def page(self, path: str | PathLike[str], *, read: str = "") -> Path:
        """Write a page for players: the advice, pictures, and each part before and after.

        Parameters
        ----------
        path, read
            As for `hoopgen.plots.write_coach_page`.

        Returns
        -------
        Path
            The file.
        """
        written: Path = plotting_module().write_coach_page(self, path, read=read)
        return written

    def __str__(self) -> str:
        level = format_percent(self.confidence, None)
        lines = []
        if self.place is not None:
            lines.append(f"{self.place.name} ({self.place.source})")
        lines += [
            f"You make {format_percent(self.made)} ({format_percent(self.low)} to "
            f"{format_percent(self.high)}).",
            "",
            self.advice,
            "",
            table(
                ["half the spread of", "from", "to", "you would make", "gain", f"{level} interval"],
                [_row(one, self.units) for one in self.spreads],
                right=range(1, 6),
            ),
            "",
            table(
                ["or change", "from", "to", "you would make", "gain", f"{level} interval"],
                [_row(one, self.units) for one in self.habits],
                right=range(1, 6),
            ),
            "",
            self.provenance,
            "",
            footer(_NAMES, self.origin),
        ]
        return "\n".join(lines)


def _record(one: Advice) -> dict[str, Any]:
    return vars(one) | {"unit": VARIABLES[one.variable].unit}


def _points(one: Advice) -> str:
    return f"{format_points(one.low)} to {format_points(one.high)}"


def _row(one: Advice, units: System) -> list[str]:
    ends = [say(one.variable, value, units) for value in (one.before, one.after)]
    return [one.name, *ends, format_percent(one.made), format_points(one.gain), _points(one)]


def say(variable: str, value: float, units: System = "us") -> str:
    """Return a value in the units of players: feet, inches, mph, degrees and rpm; or of SI.

    Parameters
    ----------
    variable
        The name of the variable, which tells its unit.
    value
        The value, SI and rad.
    units
        "us" for the units of players, "si" for metres, m/s, degrees and Hz.
    """
    if units == "si" and VARIABLES[variable].kind != "angle":
        with use_units("si"):
            return format_variable(variable, value).replace("-", MINUS)
    if variable == "speed":
        text = f"{value / _MPH:.2f} mph"
    elif variable in ("backspin", "sidespin"):
        text = f"{value / _RPM:.0f} rpm"
    elif variable == "aim":
        text = f"{value / INCH:.1f} in"
    elif variable in ("height", "distance"):
        text = f"{value / FOOT:.1f} ft"
    else:
        text = f"{value / DEGREE:.2f}\N{DEGREE SIGN}"
    return text.replace("-", MINUS)
