"""``hoopgen fan`` and ``landings``: paths of a player's shots, and where misses come down."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import hoopgen
from hoopgen.report.quantities import for_json, format_variable
from hoopgen.scene.lookup import check_hoop
from hoopgen.study.questions.specification import FanQuestion, LandingsQuestion
from hoopgen.text.numbers import format_count, format_percent

from .command import command
from .messages import echo_json, examples
from .options import UNITS_IN_WORDS, json_option, picture_option, units_option
from .question_options import question_options
from .release_options import Releasing, from_option, release_needs, release_options
from .shot_sample import CONFIDENCE, NAMES, ShotSample, sample_shots

if TYPE_CHECKING:
    from hoopgen.engine.compiled_scene import CompiledScene
    from hoopgen.study.questions.landings import Landings
    from hoopgen.study.statistics.distributions import Spread

_FREE_THROW = "--speed 7.17 --elevation 52deg --backspin 3Hz --height 7ft --distance 13.75ft"
_PLAYER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"

_REBOUNDS = ("rebound_distance", "rebound_time", "rebound_angle")
"""Measures that describe rebounds."""

_FLOOR = ("floor_x", "floor_y")
"""Measures that describe landings."""

_WITHIN = (0.5, 0.9)
"""Shares of the misses for which a distance is given."""


@command(
    short_help="Draw the paths of a player's shots from the side.",
    needs=release_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        f"hoopgen fan {_FREE_THROW} \\",
        f"    {_PLAYER} --picture fan.svg",
        "hoopgen fan --from releases.csv --height 7ft --distance 13.75ft --picture fan.png",
        "hoopgen fan --scene golf.toml --position=-30cm,0,20cm --velocity 1.4,0,0 \\",
        "    --scatter vx=0.1 --scatter vy=0.05 --max-contacts 30 --picture pitches.png",
    ),
)
@release_options
@from_option
@question_options(FanQuestion)
@picture_option("paths")
@units_option
@json_option
def fan(
    releasing: Releasing,
    shots: int,
    paths: int,
    picture: Path | None,
    as_json: bool,
    **work: Any,
) -> None:
    """Sample a player's shots and draw their paths from the side, by outcome.

    Shots scatter about a release, or are drawn from measured ones, as for `hoopgen estimate`, whose
    more shots have narrower intervals.
    """
    sample = sample_shots(releasing, shots, record=picture is not None, **work)
    if picture is not None:
        scene, note = sample.released.parameters, sample.note
        picture_of_paths = hoopgen.plots.plot_fan(sample.shots, scene, paths=paths, note=note)
        hoopgen.plots.save(picture_of_paths, picture)
    if as_json:
        _echo(sample.shares.as_dict(), sample.shots.scene)
    else:
        click.echo(f"{sample.line}\n\n{sample.footer}")


@command(
    short_help="Find where a player's missed shots come down.",
    needs=release_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        f"hoopgen landings {_FREE_THROW} \\",
        f"    {_PLAYER} --preset nba --picture misses.svg",
        "hoopgen landings --aim 5cm --elevation 52deg --height 7ft --x 4m --y 3m \\",
        f"    {_PLAYER} --catching-height 2.5m --picture rebounds.svg",
    ),
)
@release_options
@from_option
@question_options(LandingsQuestion)
@picture_option("places on the floor")
@units_option
@json_option
def landings(
    releasing: Releasing,
    shots: int,
    catching_height: float | None,
    picture: Path | None,
    as_json: bool,
    **work: Any,
) -> None:
    """Sample a player's shots and find where the missed ones come down to the floor.

    That is where the ball's centre would be at floor level, after its last contact with the hoop;
    with --catching-height where it is caught, as `hoopgen estimate` describes it by a measure.
    """
    from hoopgen.study.measures.rebounds import check_height
    from hoopgen.study.questions.landings import landings_of
    from hoopgen.study.statistics.distributions import spread_lines

    check_hoop("landings", releasing.engine)
    height = None if catching_height is None else check_height(catching_height)
    work |= {"measures": _FLOOR if height is None else _REBOUNDS}
    work |= {} if height is None else {"catching_height": height}
    sample = sample_shots(releasing, shots, **work)
    there, note = landings_of(sample.released, sample.shots, height), sample.note
    if height is None:
        distances = _distances(there, sample)
        text, record = distances.text, {"landings": distances.as_dict()}
        note = ". ".join(filter(None, [distances.note, note]))
    else:
        measured = _caught(sample, height)
        text = "\n".join(spread_lines(measured))
        record = {"measured": {name: one.as_dict() for name, one in measured.items()}}
    if as_json:
        _echo(sample.shares.as_dict() | record, sample.shots.scene)
    else:
        click.echo(f"{sample.line}\n{text}\n\n{sample.footer}")
    if picture is not None:
        scene = sample.released.parameters
        places = hoopgen.plots.plot_landings(there.x, there.y, scene, note=note, **there.seen)
        hoopgen.plots.save(places, picture)


@dataclass(frozen=True)
class _Distances:
    """Distances from the point below the ring's centre within which shares of the misses land.

    Attributes
    ----------
    shots, misses
        Number of misses that reach the floor, and of all.
    quantiles
        By share the distance, and the ends of its interval, that of the simulation alone; m.
        Infinite where the shots are too few for an end.
    sample
        Of measured releases, by share the interval that contains the uncertainty of the sample.
    still
        Whether nothing scatters.
    """

    shots: int
    misses: int
    quantiles: Mapping[float, tuple[float, float, float]]
    sample: Mapping[float, tuple[float, float]]
    still: bool

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        ends = ("value", "low", "high")
        record: dict[str, Any] = {
            "unit": "m",
            "shots": self.shots,
            "quantiles": {
                f"{p:g}": dict(zip(ends, one, strict=True)) for p, one in self.quantiles.items()
            },
        }
        sample = {f"{p:g}": {"low": low, "high": high} for p, (low, high) in self.sample.items()}
        return record | ({"sample": sample} if sample else {})

    @property
    def text(self) -> str:
        """The distances with their intervals."""
        if not self.misses:
            return f"{'land':{NAMES}}no shot was missed"
        if not self.shots:
            return f"{'land':{NAMES}}none of the missed ones reaches the floor"
        half, most = (format_variable("distance", one[0]) for one in self.quantiles.values())
        line = (
            f"{'land':{NAMES}}half of {format_count(self.shots, 'missed shot')} within {half} of "
            f"the point below the ring's centre, 90% within {most}"
        )
        return "\n".join([line, *([f"{'':{NAMES}}({self.note})"] if self.note else [])])

    @property
    def note(self) -> str:
        """The intervals of the distances; empty where there is nothing to be estimated."""
        if self.still or not self.quantiles:
            return ""
        ends = {p: (low, high) for p, (_, low, high) in self.quantiles.items()}
        level = format_percent(CONFIDENCE, None)
        if not self.sample:
            return f"{level} intervals of these distances: {_ends(ends)}"
        return (
            f"{level} intervals of these distances, of the simulation alone: {_ends(ends)}; of the "
            f"sample: {_ends(self.sample)}"
        )


def _ends(found: Mapping[float, tuple[float, float]]) -> str:
    """Return intervals of distances in words."""
    texts = []
    for p, (low, high) in found.items():
        least = max(low, 0.0)
        text = f"{format_variable('distance', least)} or more"
        if high < inf:
            least_alone = format_variable("distance", least, unit=False)
            text = f"{least_alone} to {format_variable('distance', high)}"
        texts.append(f"{format_percent(p, 0)} within {text}")
    return ", ".join(texts)


def _distances(there: Landings, sample: ShotSample) -> _Distances:
    """Return within which distances of the basket shares of the balls come down, m."""
    import numpy as np

    from hoopgen.results.shots import Outcome
    from hoopgen.study.statistics.sample import Rows

    away, scene = there.away, sample.shots.scene
    if not len(away):
        return _Distances(0, len(there.x), {}, {}, sample.shares.still)
    landed = Rows(sample.shots.outcome, None, scene, {"away": away})
    values = {p: float(np.quantile(away, p)) for p in _WITHIN}
    quantiles = {p: (one, *landed.quantile("away", p, CONFIDENCE)) for p, one in values.items()}
    if sample.shares.still:
        quantiles = {p: (one, one, one) for p, one in values.items()}
    of_sample = {}
    if sample.rows is not None:
        x, y = (sample.rows.measured[name] for name in _FLOOR)
        missed = sample.rows.outcome == Outcome.MISSED
        rows = replace(sample.rows, measured={"away": np.where(missed, np.hypot(x, y), np.nan)})
        of_sample = {p: rows.quantile("away", p, CONFIDENCE) for p in _WITHIN}
    return _Distances(len(away), len(there.x), quantiles, of_sample, sample.shares.still)


def _echo(record: Mapping[str, Any], scene: CompiledScene) -> None:
    from hoopgen.study.named_units import in_units

    echo_json(in_units({name: for_json(value) for name, value in record.items()}, scene))


def _caught(sample: ShotSample, height: float) -> dict[str, Spread]:
    """Return distances, times and directions of rebounds."""
    from hoopgen.study.statistics.distributions import counts_of, spreads, spreads_of_sample

    counts = counts_of(sample.released, sample.shots, _REBOUNDS, height)
    distributions = spreads(counts, _REBOUNDS, CONFIDENCE, height)
    return distributions if sample.rows is None else spreads_of_sample(distributions, sample.rows)
