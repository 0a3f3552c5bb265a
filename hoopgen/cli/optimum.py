"""``hoopgen optimum``: the best release for a player's scatter, in words."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    WAYS,
    by_option,
    confidence_option,
    examples,
    json_option,
    seed_option,
)
from hoopgen.cli.releasing import Releasing, release_options
from hoopgen.cli.table import table
from hoopgen.cli.types import BOUNDS, COUNT
from hoopgen.study.told import footer
from hoopgen.study.variables import VARIABLES
from hoopgen.study.words import between, percent, say

if TYPE_CHECKING:
    from hoopgen.study.margins import Margin
    from hoopgen.study.optimum import Optimum
    from hoopgen.study.player import By

__all__ = ["optimum"]

_GO_IN = {
    "any": "go in",
    "direct": "go in, the board not touched first",
    "bank": "go in off the board",
}

_AIMING = ("speed", "aim", "azimuth")
"""Variables whose usual ranges are other ones for another way in."""

_INCH = 0.0254


@click.command(
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen optimum --over elevation --over aim --height 7ft --distance 13.75ft \\",
        "    --backspin 3Hz --scatter speed=0.07 --scatter elevation=1.3 --scatter azimuth=1",
        "hoopgen optimum --over elevation=45:60 --over aim=-5cm:12cm --height 7ft \\",
        "    --distance 13.75ft --scatter speed=0.1 --scatter elevation=1.5",
        "hoopgen optimum --over elevation --over aim --over azimuth --by bank --versus direct \\",
        "    --height 7ft --distance 10ft --angle 60 --backspin 3Hz \\",
        "    --scatter speed=0.07 --scatter elevation=1.3 --scatter azimuth=1",
    )
)
@click.option(
    "--over",
    type=BOUNDS,
    multiple=True,
    required=True,
    help="A variable to search over; without low and high, over the usual range. May be repeated.",
)
@release_options
@by_option
@click.option(
    "--versus",
    type=click.Choice(WAYS),
    help="Find the best shot of this way too, aimed within the usual range; say which is better.",
)
@click.option(
    "--shots",
    type=COUNT,
    default=100_000,
    show_default=True,
    help="Of the last step of the search, and of the estimate.",
)
@seed_option
@confidence_option
@json_option
def optimum(
    over: Sequence[tuple[str, tuple[float, float] | None]],
    releasing: Releasing,
    by: By,
    versus: By | None,
    shots: int,
    seed: int,
    confidence: float,
    as_json: bool,
) -> None:
    """Find the release that goes in most often, given a player's scatter.

    All candidates are thrown with the same random errors. The probability is of fresh shots. What
    the release forgives comes with it: how far off each variable alone may be.
    """
    from hoopgen.study.margins import MARGINS
    from hoopgen.study.optimum import optimum as best_release

    def find(
        way: By, bounds: Mapping[str, tuple[float, float] | None], margins: Sequence[str]
    ) -> Optimum:
        return best_release(
            bounds,
            releasing.values,
            releasing.sd,
            releasing.correlation,
            releasing.parameters,
            by=way,
            shots=shots,
            seed=seed,
            confidence=confidence,
            margins=margins,
        )

    best, rival = find(by, dict(over), MARGINS), None
    if versus is not None:
        # Another way in is aimed elsewhere.
        rival = find(versus, {n: None if n in _AIMING else ends for n, ends in over}, ())
    if as_json:
        click.echo(json.dumps(_record(best, rival), indent=2, allow_nan=False))
        return
    click.echo(_advice(best))
    if rival is not None:
        click.echo(_against(best, rival))
    click.echo()
    click.echo(_margins(list(best.margins.values()), best.tolerance))
    click.echo(f"\n{footer(9, best.told())}")


def _record(best: Optimum, rival: Optimum | None) -> dict[str, Any]:
    record = best.as_dict()
    if rival is not None:
        difference, low, high = best.lead(rival)
        record["versus"] = rival.as_dict() | {"lead": difference, "low": low, "high": high}
    return record


def _advice(best: Optimum) -> str:
    """Say the release to a coach."""
    given = best.arguments
    spins = [f"{name} {say(name, given[name])}" for name in ("backspin", "sidespin") if given[name]]
    shot = f"{say('speed', given['speed'])} at {say('elevation', given['elevation'])}"
    lines = [
        f"shoot    {', '.join([shot, _towards(given['azimuth']), *spins])}",
        _where(best),
        f"success  {percent(best.probability)} {_GO_IN[best.by]} ({100 * best.low:.1f} to "
        f"{percent(best.high)} with {best.confidence:.0%} confidence; {best.shots:,} fresh shots"
        f"{f', {best.invalid:,} of them invalid' * bool(best.invalid)})",
    ]
    for name, ends in best.flat.items():
        said = f"{VARIABLES[name].label} {between(name, *ends)}"
        lines.append(f"as good  {said}, within {100 * best.tolerance:g} point")
    for name in best.at_bounds:
        said = f"{VARIABLES[name].label} may lie beyond {between(name, *best.bounds[name])}"
        lines.append(f"caution  the best {said}")
    return "\n".join(lines)


def _where(best: Optimum) -> str:
    """Say where the ball goes: on the board, or down into the ring."""
    if best.by == "bank":
        from hoopgen.study.bank import on_board

        touch = on_board(best.arguments, best.parameters)
        side = "right" if touch["touch_y"] >= 0 else "left"
        return (
            f"flight   touches the board {say('aim', touch['touch_z'])} above the ring, "
            f"{say('aim', abs(touch['touch_y']))} to the {side} of its middle"
        )
    inside = best.parameters["ring_radius"] - best.parameters["wire_radius"]
    return (
        f"flight   comes down at {say('entry', best.entry_angle)}, {_past(best.depth)}: "
        f"{(inside + best.depth) / _INCH:.1f} in from the front of the ring"
    )


def _towards(azimuth: float) -> str:
    said = say("azimuth", abs(azimuth))
    if said == say("azimuth", 0.0):
        return "straight at the ring"
    return f"{said} to the {'left' if azimuth > 0 else 'right'} of the ring's centre"


def _past(depth: float) -> str:
    return f"{say('aim', abs(depth))} {'past' if depth >= 0 else 'short of'} the centre"


def _against(best: Optimum, rival: Optimum) -> str:
    difference, low, high = best.lead(rival)
    given = rival.arguments
    return (
        f"versus   {percent(rival.probability)} {_GO_IN[rival.by]}, from "
        f"{say('speed', given['speed'])} at {say('elevation', given['elevation'])}: "
        f"{100 * difference:+.1f} points ({100 * low:+.1f} to {100 * high:+.1f})"
    )


def _margins(margins: Sequence[Margin], tolerance: float) -> str:
    rows = [
        [
            VARIABLES[margin.name].label,
            say(margin.name, margin.value),
            margin.said(margin.low, margin.high) + "*" * bool(margin.elsewhere),
            margin.said(*margin.steady) if margin.steady else "",
        ]
        for margin in margins
    ]
    head = ["one of them off", "best", "goes in", f"within {100 * tolerance:g} point"]
    groups = [(2, 2, "without scatter"), (3, 3, "with scatter")]
    note = "\n* and further out again, by another bounce: --json has where"
    return table(head, rows, right=(1,), groups=groups) + note * any(m.elsewhere for m in margins)
