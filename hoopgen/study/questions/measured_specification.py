"""Questions about measured shots, specified as those of `specification` are.

A study file does not ask them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar

from hoopgen.core.units import System

from . import settings as of
from .settings import MEASURED, RESULTS, TableSettings, setting
from .specification import Ranges
from .values import BOUNDS, Choice, Each, Listed, Quantity, Share, Text, Whole


@dataclass(frozen=True, kw_only=True)
class CoachQuestion:
    """The part of a player's release that is worth practising most."""

    shared: ClassVar = (of.Sampling, of.Threads)
    makes: float | None = setting(
        "Share of shots that the player makes, by default 70%. One factor scales all of the "
        "spread.",
        Share(percent=True),
        None,
    )
    shots: int = setting("Number of shots before and after each change.", Whole(), 100_000)


@dataclass(frozen=True, kw_only=True)
class BestQuestion:
    """The shot that a player makes most often, from each place of the half court."""

    shared: ClassVar = (of.Sampling, of.Threads)
    makes: float | None = setting(
        "Share of free throws made by the default player; by default 70%.",
        Share(percent=True),
        None,
    )
    step: float = setting("Distance of neighbouring places.", Quantity("length", 0.5, 3.0), 1.5)
    shots: int = setting(
        "Number of shots of the last step of each search, and of the fresh estimates.",
        Whole(),
        5_000,
    )


@dataclass(frozen=True, kw_only=True)
class FitQuestion:
    """The releases of measured tracks."""

    shared: ClassVar = (of.Parsing,)
    noise: float | None = setting(
        "Standard deviation of a coordinate of a frame; by default estimated from all tracks.",
        Quantity("length"),
        None,
    )
    release_time: float | str | None = setting(
        "Time of the release, s, before which frames are in the hand; or detect, for the earliest "
        "frame that is consistent with the flight. By default the first frame of each track.",
        Text(metavar="SECONDS|detect"),
        None,
    )
    backspin: float | None = setting(
        "Backspin of all releases; without air the flight to the first contact does not show it.",
        Quantity("spin"),
        None,
    )
    backspin_sd: float | None = setting(
        "How uncertain the backspin is, as a standard deviation: then it is fitted, too, by the "
        "flight after the first contact, and in air by all of the flight.",
        Quantity("spin"),
        None,
    )
    track: str | None = setting(
        'Column of the labels of tracks; by default "track", and without it one track.',
        Text(metavar="COLUMN"),
        None,
        heading=MEASURED,
    )
    keep: Sequence[str] = setting(
        "Column to copy to the releases, such as a player: the first cell of each track.",
        Listed(Text(words="a column name", metavar="COLUMN")),
        (),
        heading=RESULTS,
    )
    format: str | None = of.table_format()
    columns: Mapping[str, str] | None = setting(
        "Columns to read as time, x, y or z, whatever they are called.",
        Each(Text(words="a column name")),
        None,
        option="column",
        heading=MEASURED,
        command="Such as time_ms=Timestamp; the unit is at the end of either name.",
    )
    where: Sequence[str] = of.table_where()
    units: System = of.table_units()


@dataclass(frozen=True, kw_only=True)
class CalibrateQuestion(TableSettings):
    """The restitution and friction with which the shots of a table most likely end as they did."""

    shared: ClassVar = (of.Parsing, of.Sampling)
    vary: Ranges = setting(
        "Parameters of the scene to find, one to three; of others than restitution and friction "
        "with their bounds.",
        BOUNDS,
        command="Such as restitution or ring_friction=0.1:1.0.",
    )
    made: str | None = setting(
        "Column that says whether each shot was made; by default made or outcome.",
        Text(metavar="COLUMN"),
        None,
        heading=MEASURED,
    )
    ignore: Sequence[str] = setting(
        "What the table says of the end and is not used.",
        Listed(Choice(("contacts", "first", "rebound"))),
        (),
        heading=MEASURED,
    )
    rebound_error: float = setting(
        "Standard error of each coordinate of the place of a rebound.",
        Quantity("length", 0.0),
        0.0,
        heading=MEASURED,
    )
    catching_height: float = of.catching_height()
    draws: int = setting("Shots of each release at each point of the grid.", Whole(2), 200)
