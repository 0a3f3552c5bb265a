"""``hoopgen fan`` and ``landings``: paths of a player's shots, and where misses come down."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import hoopgen
from hoopgen.report.provenance import describe_setting, footer, sentences
from hoopgen.report.quantities import for_json, format_variable
from hoopgen.scene.lookup import check_hoop
from hoopgen.study.questions.specification import FanQuestion, LandingsQuestion
from hoopgen.text.numbers import format_count, format_percent, format_uncertain

from .command import command
from .invalid_warnings import warn_invalid_shots
from .messages import echo_json, examples
from .options import UNITS_IN_WORDS, json_option, picture_option, units_option
from .question_options import question_options
from .release_options import Releasing, from_option, release_needs, release_options

if TYPE_CHECKING:
    from hoopgen.core.variables import Releases
    from hoopgen.engine.compiled_scene import CompiledScene
    from hoopgen.study.questions.landings import Landings
    from hoopgen.study.statistics.distributions import Spread

_FREE_THROW = "--speed 7.17 --elevation 52deg --backspin 3Hz --height 7ft --distance 13.75ft"
_PLAYER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"

_REBOUNDS = ("rebound_distance", "rebound_time", "rebound_angle")
"""Measures that describe rebounds."""

_WITHIN = (0.5, 0.9)
"""Shares of the misses for which a distance is given."""

_CONFIDENCE = 0.95
"""Confidence of intervals, as of `hoopgen estimate`."""


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

    Shots scatter about a release, or are drawn from measured ones, as for `hoopgen estimate`, which
    says the shares of more shots with their intervals.
    """
    sample = _sample(releasing, shots, record=picture is not None, **work)
    if picture is not None:
        scene, note = sample.released.parameters, sentences(sample.provenance)
        picture_of_paths = hoopgen.plots.plot_fan(sample.shots, scene, paths=paths, note=note)
        hoopgen.plots.save(picture_of_paths, picture)
    if as_json:
        _echo(sample.as_dict(), sample.shots.scene)
    else:
        click.echo(f"{sample.line}\n\n{footer(9, sample.provenance)}")


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
    sample = _sample(releasing, shots, record=False, **work)
    there = landings_of(sample.released, sample.shots, height)
    if height is None:
        text, record = _where(there), {"landings": _within(there)}
    else:
        measured = _caught(sample, height, work)
        text = "\n".join(spread_lines(measured))
        record = {"measured": {name: one.as_dict() for name, one in measured.items()}}
    if as_json:
        _echo(sample.as_dict() | record, sample.shots.scene)
    else:
        click.echo(f"{sample.line}\n{text}\n\n{footer(9, sample.provenance)}")
    if picture is not None:  # without misses there is none, which is then an error
        scene, note = sample.released.parameters, sentences(sample.provenance)
        places = hoopgen.plots.plot_landings(there.x, there.y, scene, note=note, **there.seen)
        hoopgen.plots.save(places, picture)


@dataclass(frozen=True)
class _Sample:
    """A sample of a player's shots, their results and their provenance."""

    setting: Any
    released: Releases
    shots: hoopgen.Shots
    seed: int

    @cached_property
    def provenance(self) -> dict[str, str]:
        """The provenance of the shots, in words."""
        description = describe_setting(self.setting.identity(), self.shots.scene)
        return description | {"seed": str(self.seed)}

    @cached_property
    def counts(self) -> dict[str, int]:
        """Number of shots by outcome."""
        outcome = self.shots.outcome
        return {one.name.lower(): int((outcome == one).sum()) for one in self.shots.scene.outcomes}

    @property
    def uncertain(self) -> tuple[int, int]:
        """The number of uncertain shots, and of capped ones among them."""
        uncertain, outcomes = self.shots.uncertain, self.shots.scene.outcomes
        capped = uncertain & (self.shots.outcome == outcomes["CAPPED"])
        return int(uncertain.sum()), int(capped.sum())

    @property
    def line(self) -> str:
        """The shares of the outcomes, in words."""
        total, counts = len(self.shots), self.counts.items()
        shares = [f"{format_percent(count / total)} {name}" for name, count in counts if count]
        if self.uncertain[0]:
            shares.append(format_uncertain(*self.uncertain))
        return f"shots    {total:,}: {', '.join(shares)}"

    def as_dict(self) -> dict[str, Any]:
        """Return everything, as an estimate has it."""
        uncertain, capped = self.uncertain
        return {
            "shots": len(self.shots),
            "counts": self.counts,
            "uncertain": uncertain,
            "uncertain_capped": capped,
            "seed": self.seed,
            "setting": dict(self.setting.identity()),
            "scene": self.provenance["scene"],
        }


def _sample(releasing: Releasing, count: int, *, seed: int, **options: Any) -> _Sample:
    """Sample a player's shots and simulate them, with options of `hoopgen.simulate`."""
    from hoopgen.study.jobs.monte_carlo import setting_of

    setting = setting_of(*releasing.model(), releasing.engine)
    released = setting.model.draw(0, count, seed, setting.parameters)
    shots = hoopgen.simulate(released.states, released.parameters, scene=setting.scene, **options)
    sample = _Sample(setting, released, shots, seed)
    warn_invalid_shots(setting.model, released, shots, sample.counts["invalid"], count)
    return sample


def _echo(record: Mapping[str, Any], scene: CompiledScene) -> None:
    from hoopgen.study.named_units import in_units

    echo_json(in_units({name: for_json(value) for name, value in record.items()}, scene))


def _within(there: Landings) -> dict[str, Any]:
    """Return within which distances of the basket shares of the balls come down, m."""
    import numpy as np

    away = there.away
    quantiles = {f"{p:g}": {"value": float(np.quantile(away, p))} for p in _WITHIN if len(away)}
    return {"unit": "m", "shots": len(away), "quantiles": quantiles}


def _where(there: Landings) -> str:
    """Return the distances of `_within` as text."""
    within = _within(there)
    if not within["shots"]:
        return "land     none of the missed ones reaches the floor"
    half, most = (format_variable("distance", one["value"]) for one in within["quantiles"].values())
    return (
        f"land     half of {format_count(within['shots'], 'missed shot')} within {half} of the "
        f"point below the ring's centre, 90% within {most}"
    )


def _caught(sample: _Sample, height: float, work: Mapping[str, Any]) -> dict[str, Spread]:
    """Return distances, times and directions of rebounds."""
    from hoopgen.study.models.resample import Resample
    from hoopgen.study.statistics.distributions import counts_of, spreads, spreads_of_sample
    from hoopgen.study.statistics.sample import sampled_rows

    counts = counts_of(sample.released, sample.shots, _REBOUNDS, height)
    distributions = spreads(counts, _REBOUNDS, _CONFIDENCE, height)
    setting = sample.setting
    if not isinstance(setting.model, Resample):
        return distributions
    options = {name: work[name] for name in ("max_contacts", "backend", "threads")}
    rows = sampled_rows(setting, measures=_REBOUNDS, catching_height=height, **options)
    return spreads_of_sample(distributions, rows)
