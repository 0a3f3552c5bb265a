"""The best release, said to a coach."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from hoopgen.layout import table
from hoopgen.phrases import counted, interval, percent, points

from .told import footer
from .variables import VARIABLES
from .words import between, say

if TYPE_CHECKING:
    from .margins import Margin
    from .optimum import Optimum

__all__ = ["advice"]

_GO_IN = {
    "any": "go in",
    "direct": "go in, the board not touched first",
    "bank": "go in off the board",
}

_INCH = 0.0254


def advice(best: Optimum, rival: Optimum | None = None) -> str:
    """Say the release, how often it goes in, what it forgives, and what that rests on.

    Parameters
    ----------
    best
        What was found.
    rival
        Of another way in: said is how far the first one leads.
    """
    lines = [*_shot(best), *([_against(best, rival)] if rival is not None else [])]
    margins = list(best.margins.values())
    lines += ["", _margins(margins, best.tolerance)] if margins else []
    return "\n".join([*lines, "", footer(9, best.told())])


def _shot(best: Optimum) -> list[str]:
    """Say the release, where the ball goes, and how often it goes in."""
    given = best.arguments
    spins = [f"{name} {say(name, given[name])}" for name in ("backspin", "sidespin") if given[name]]
    shot = f"{say('speed', given['speed'])} at {say('elevation', given['elevation'])}"
    lines = [
        f"shoot    {', '.join([shot, _towards(given['azimuth']), *spins])}",
        _where(best),
        f"success  {percent(best.probability)} {_GO_IN[best.by]} ({interval(best.low, best.high)} "
        f"with {percent(best.confidence, None)} confidence; {counted(best.shots, 'fresh shot')}"
        f"{f', {best.invalid:,} of them invalid' * bool(best.invalid)}, seed {best.seed})",
    ]
    for name, ends in best.flat.items():
        said = f"{VARIABLES[name].label} {between(name, *ends)}"
        lines.append(f"as good  {said}, within {counted(100 * best.tolerance, 'point')}")
    for name in best.at_bounds:
        said = f"{VARIABLES[name].label} may lie beyond {between(name, *best.bounds[name])}"
        lines.append(f"caution  the best {said}")
    return lines


def _where(best: Optimum) -> str:
    """Say where the ball goes: on the board, or down into the ring."""
    if best.by == "bank":
        from .bank import on_board  # which builds on this

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
        f"{points(difference)} points ({points(low)} to {points(high)})"
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
    head = ["one of them off", "best", "goes in", f"within {counted(100 * tolerance, 'point')}"]
    groups = [(2, 2, "without scatter"), (3, 3, "with scatter")]
    note = "\n* and further out again, by another bounce: `elsewhere` has where"
    return table(head, rows, right=(1,), groups=groups) + note * any(m.elsewhere for m in margins)
