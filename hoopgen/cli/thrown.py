"""``hoopgen fan`` and ``landings``: a player's shots from the side, and where misses come down."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.command import command
from hoopgen.cli.invalid import warn_invalid_shots
from hoopgen.cli.measuring import catching_height_option
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    backend_option,
    examples,
    json_option,
    max_contacts_option,
    picture_option,
    seed_option,
    threads_option,
    together,
    units_option,
)
from hoopgen.cli.releasing import Releasing, from_option, release_needs, release_options
from hoopgen.cli.types import whole

if TYPE_CHECKING:
    import hoopgen
    from hoopgen.inputs import Backend
    from hoopgen.study.landings import Landings
    from hoopgen.study.spread import Spread
    from hoopgen.variables import Releases

__all__ = ["fan", "landings"]

_FREE_THROW = "--speed 7.17 --elevation 52deg --backspin 3Hz --height 7ft --distance 13.75ft"
_PLAYER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"

_REBOUNDS = ("rebound_distance", "rebound_time", "rebound_angle")
"""What is said of them."""

_WITHIN = (0.5, 0.9)
"""Shares of the misses, of which the distance is said."""

_CONFIDENCE = 0.95
"""Of intervals, as `hoopgen estimate` has it."""

_WORK = together(seed_option, max_contacts_option, backend_option, threads_option)


@command(
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
@click.option(
    "--shots", type=whole(), default=2_000, show_default=True, help="Of which the shares are said."
)
@click.option(
    "--paths", type=whole(), default=150, show_default=True, help="Drawn: those of the first shots."
)
@picture_option("paths")
@_WORK
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
    """Throw a player's shots and draw their paths from the side, by what becomes of them.

    Shots scatter about a release, or are drawn from measured ones, as for `hoopgen estimate`, which
    says the shares of more shots with their intervals.
    """
    from hoopgen.told import footer, in_a_note

    thrown = _thrown(releasing, shots, record=picture is not None, **work)
    if picture is not None:
        from hoopgen import plots

        scene, note = thrown.released.parameters, in_a_note(thrown.told)
        plots.save(plots.plot_fan(thrown.flown, scene, paths=paths, note=note), picture)
    if as_json:
        _echo(thrown.as_dict())
    else:
        click.echo(f"{thrown.line}\n\n{footer(9, thrown.told)}")


@command(
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
@click.option("--shots", type=whole(), default=200_000, show_default=True, help="Thrown.")
@catching_height_option(
    "Rebounds in place of landings: where and when the ball's centre comes down to this height "
    "above the floor, and in which directions.",
    default=None,
)
@picture_option("places on the floor")
@_WORK
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
    """Throw a player's shots and say where the missed ones come down to the floor.

    Where the ball's centre would be at floor level, after its last contact with the hoop; with
    --catching-height where it is caught, as `hoopgen estimate` says it of a measure.
    """
    from hoopgen.scenes import check_hoop
    from hoopgen.study.landings import landings_of
    from hoopgen.study.rebounds import check_height
    from hoopgen.study.spread import spread_lines
    from hoopgen.told import footer, in_a_note

    check_hoop("landings", releasing.engine)
    height = None if catching_height is None else check_height(catching_height)
    thrown = _thrown(releasing, shots, record=False, **work)
    there = landings_of(thrown.released, thrown.flown, height)
    if height is None:
        said, found = _where(there), {"landings": _within(there)}
    else:
        measured = _caught(thrown, height, work)
        said = "\n".join(spread_lines(measured))
        found = {"measured": {name: one.as_dict() for name, one in measured.items()}}
    if as_json:
        _echo(thrown.as_dict() | found)
    else:
        click.echo(f"{thrown.line}\n{said}\n\n{footer(9, thrown.told)}")
    if picture is not None:  # of no misses there is none, which is then an error
        from hoopgen import plots

        scene, note = thrown.released.parameters, in_a_note(thrown.told)
        plots.save(plots.plot_landings(there.x, there.y, scene, note=note, **there.seen), picture)


@dataclass(frozen=True)
class _Thrown:
    """A player's shots, what became of them, and what that rests on."""

    thrower: Any
    released: Releases
    flown: hoopgen.Shots
    seed: int

    @property
    def setting(self) -> Mapping[str, Any]:
        """Release model and parameters, in types that JSON knows."""
        return dict(self.thrower.identity())

    @cached_property
    def told(self) -> dict[str, str]:
        """What it rests on, in words."""
        from hoopgen.told import told_setting

        return told_setting(self.setting, self.flown.scene) | {"seed": str(self.seed)}

    @cached_property
    def counts(self) -> dict[str, int]:
        """Shots by outcome."""
        outcome = self.flown.outcome
        return {one.name.lower(): int((outcome == one).sum()) for one in self.flown.scene.outcomes}

    @property
    def doubt(self) -> tuple[int, int]:
        """How many are uncertain, and how many of those are capped."""
        uncertain, outcomes = self.flown.uncertain, self.flown.scene.outcomes
        capped = uncertain & (self.flown.outcome == outcomes["CAPPED"])
        return int(uncertain.sum()), int(capped.sum())

    @property
    def line(self) -> str:
        """How they end."""
        from hoopgen.phrases import doubtful, percent

        total = len(self.flown)
        said = [f"{percent(count / total)} {name}" for name, count in self.counts.items() if count]
        if self.doubt[0]:
            said.append(doubtful(*self.doubt))
        return f"shots    {total:,}: {', '.join(said)}"

    def as_dict(self) -> dict[str, Any]:
        """Return everything, as an estimate has it."""
        uncertain, capped = self.doubt
        return {
            "shots": len(self.flown),
            "counts": self.counts,
            "uncertain": uncertain,
            "uncertain_capped": capped,
            "seed": self.seed,
            "setting": self.setting,
            "scene": self.told["scene"],
        }


def _thrown(
    releasing: Releasing,
    count: int,
    *,
    record: bool,
    seed: int,
    max_contacts: int,
    backend: Backend,
    threads: int | None,
) -> _Thrown:
    """Throw a player's shots."""
    import hoopgen
    from hoopgen.study.throws import setting_of

    setting = setting_of(*releasing.model(), releasing.engine)
    released = setting.model.draw(0, count, seed, setting.parameters)
    flown = hoopgen.simulate(
        released.states,
        released.parameters,
        scene=setting.scene,
        max_contacts=max_contacts,
        backend=backend,
        threads=threads,
        record=record,
    )
    thrown = _Thrown(setting, released, flown, seed)
    warn_invalid_shots(released, flown, thrown.counts["invalid"], count)
    return thrown


def _echo(found: Mapping[str, Any]) -> None:
    """Write what was found as JSON."""
    from hoopgen.study.named import in_units
    from hoopgen.words import for_json

    told = in_units({name: for_json(value) for name, value in found.items()})
    click.echo(json.dumps(told, indent=2, allow_nan=False))


def _within(there: Landings) -> dict[str, Any]:
    """Return within which distances of the basket shares of the balls come down, m."""
    import numpy as np

    away = there.away
    quantiles = {f"{p:g}": {"value": float(np.quantile(away, p))} for p in _WITHIN if len(away)}
    return {"unit": "m", "shots": len(away), "quantiles": quantiles}


def _where(there: Landings) -> str:
    """Say it."""
    from hoopgen.phrases import counted
    from hoopgen.words import say

    within = _within(there)
    if not within["shots"]:
        return "land     none of the missed ones reaches the floor"
    half, most = (say("distance", one["value"]) for one in within["quantiles"].values())
    return (
        f"land     half of {counted(within['shots'], 'missed shot')} within {half} of the point "
        f"below the ring's centre, 90% within {most}"
    )


def _caught(thrown: _Thrown, height: float, work: Mapping[str, Any]) -> dict[str, Spread]:
    """Return how far rebounds go, when they come down, and where to."""
    from hoopgen.study.resample import Resample
    from hoopgen.study.sample import thrown_rows
    from hoopgen.study.spread import counts_of, spreads, spreads_of_sample

    counts = counts_of(thrown.released, thrown.flown, _REBOUNDS, height)
    found, model = spreads(counts, _REBOUNDS, _CONFIDENCE, height), thrown.thrower.model
    if not isinstance(model, Resample):
        return found
    rows = thrown_rows(
        model,
        thrown.thrower.parameters,
        thrown.flown.scene,
        work["max_contacts"],
        work["backend"],
        work["threads"],
        _REBOUNDS,
        height,
    )
    return spreads_of_sample(found, rows)
