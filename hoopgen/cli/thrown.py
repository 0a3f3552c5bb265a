"""``hoopgen fan`` and ``landings``: a player's shots from the side, and where misses come down."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.measuring import catching_height_option
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    backend_option,
    examples,
    max_contacts_option,
    picture_option,
    seed_option,
    threads_option,
    together,
    units_option,
)
from hoopgen.cli.releasing import Releasing, from_option, release_options
from hoopgen.cli.types import whole

if TYPE_CHECKING:
    import hoopgen
    from hoopgen.inputs import Backend
    from hoopgen.variables import Releases

__all__ = ["fan", "landings"]

_FREE_THROW = "--speed 7.17 --elevation 52deg --backspin 3Hz --height 7ft --distance 13.75ft"
_PLAYER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"

_REBOUNDS = ("rebound_distance", "rebound_time", "rebound_angle")
"""What is said of them."""

_CONFIDENCE = 0.95
"""Of intervals, as `hoopgen estimate` has it."""

_WORK = together(seed_option, max_contacts_option, backend_option, threads_option)


@click.command(
    epilog=UNITS_IN_WORDS
    + examples(
        f"hoopgen fan {_FREE_THROW} \\",
        f"    {_PLAYER} --picture fan.svg",
        "hoopgen fan --from releases.csv --height 7ft --distance 13.75ft --picture fan.png",
        "hoopgen fan --scene golf.toml --position=-30cm,0,20cm --velocity 1.4,0,0 \\",
        "    --scatter vx=0.1 --scatter vy=0.05 --max-contacts 30 --picture pitches.png",
    )
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
def fan(releasing: Releasing, shots: int, paths: int, picture: Path | None, **work: Any) -> None:
    """Throw a player's shots and draw their paths from the side, by what becomes of them.

    Shots scatter about a release, or are drawn from measured ones, as for `hoopgen estimate`, which
    says the shares of more shots with their intervals.
    """
    from hoopgen.told import footer, in_a_note

    thrown, flown, told = _thrown(releasing, shots, record=picture is not None, **work)
    if picture is not None:
        from hoopgen import plots

        note = in_a_note(told)
        plots.save(plots.plot_fan(flown, thrown.parameters, paths=paths, note=note), picture)
    click.echo(f"{_ended(flown)}\n\n{footer(9, told)}")


@click.command(
    epilog=UNITS_IN_WORDS
    + examples(
        f"hoopgen landings {_FREE_THROW} \\",
        f"    {_PLAYER} --preset nba --picture misses.svg",
        "hoopgen landings --aim 5cm --elevation 52deg --height 7ft --x 4m --y 3m \\",
        f"    {_PLAYER} --catching-height 2.5m --picture rebounds.svg",
    )
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
def landings(
    releasing: Releasing,
    shots: int,
    catching_height: float | None,
    picture: Path | None,
    **work: Any,
) -> None:
    """Throw a player's shots and say where the missed ones come down to the floor.

    Where the ball's centre would be at floor level, after its last contact with the hoop; with
    --catching-height where it is caught, as `hoopgen estimate` says it of a measure.
    """
    import numpy as np

    import hoopgen
    from hoopgen.scenes import check_hoop
    from hoopgen.study.rebounds import CATCHING_HEIGHT, check_height
    from hoopgen.told import footer, in_a_note

    check_hoop("landings", releasing.engine)
    height = CATCHING_HEIGHT if catching_height is None else check_height(catching_height)
    thrown, flown, told = _thrown(releasing, shots, record=False, **work)
    scene, where = thrown.parameters, "floor" if catching_height is None else "rebound"
    names = (f"{where}_x", f"{where}_y")
    there = hoopgen.measure(thrown.states, flown, scene, names, catching_height=height)
    missed = flown.outcome == hoopgen.Outcome.MISSED
    x, y = (there[name][missed] for name in names)
    said = _where(np.hypot(x, y)) if catching_height is None else _caught(thrown, flown, height)
    click.echo(f"{_ended(flown)}\n{said}\n\n{footer(9, told)}")
    if picture is not None:  # of no misses there is none, which is then an error
        from hoopgen import plots

        place = (float(np.mean(thrown.states[:, 0])), float(np.mean(thrown.states[:, 1])))
        drawn = plots.plot_landings(
            x,
            y,
            scene,
            place=place,
            height=catching_height,
            scene=flown.scene,
            note=in_a_note(told),
        )
        plots.save(drawn, picture)


def _thrown(
    releasing: Releasing,
    count: int,
    *,
    record: bool,
    seed: int,
    max_contacts: int,
    backend: Backend,
    threads: int | None,
) -> tuple[Releases, hoopgen.Shots, dict[str, str]]:
    """Return a player's shots, what became of them, and what that rests on."""
    import hoopgen
    from hoopgen.study.throws import setting_of
    from hoopgen.told import told_setting

    setting = setting_of(*releasing.model(), releasing.engine)
    thrown = setting.model.draw(0, count, seed, setting.parameters)
    flown = hoopgen.simulate(
        thrown.states,
        thrown.parameters,
        scene=setting.scene,
        max_contacts=max_contacts,
        backend=backend,
        threads=threads,
        record=record,
    )
    return thrown, flown, told_setting(setting.identity(), setting.scene) | {"seed": str(seed)}


def _ended(flown: hoopgen.Shots) -> str:
    """Say how shots end."""
    import numpy as np

    from hoopgen.phrases import doubtful, percent

    shares = {one.name.lower(): np.mean(flown.outcome == one) for one in flown.scene.outcomes}
    said = [f"{percent(float(share))} {name}" for name, share in shares.items() if share]
    if flown.uncertain.any():
        capped = flown.uncertain & (flown.outcome == flown.scene.outcomes["CAPPED"])
        said.append(doubtful(int(flown.uncertain.sum()), int(capped.sum())))
    return f"shots    {len(flown):,}: {', '.join(said)}"


def _where(away: Any) -> str:
    """Say how far from the basket balls come down."""
    import numpy as np

    from hoopgen.phrases import counted
    from hoopgen.words import say

    there = away[np.isfinite(away)]
    if not len(there):
        return "land     none of the missed ones reaches the floor"
    half, most = (say("distance", float(np.quantile(there, share))) for share in (0.5, 0.9))
    return (
        f"land     half of {counted(len(there), 'missed shot')} within {half} of the point below "
        f"the ring's centre, 90% within {most}"
    )


def _caught(thrown: Releases, flown: hoopgen.Shots, height: float) -> str:
    """Say how far rebounds go, when they come down, and where to."""
    from hoopgen.study.spread import counts_of, spread_lines, spreads

    counts = counts_of(thrown, flown, _REBOUNDS, height)
    return "\n".join(spread_lines(spreads(counts, _REBOUNDS, _CONFIDENCE, height)))
