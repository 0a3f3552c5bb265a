"""Effects of air by distance: speed, angles, lift and the share made."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

import hoopgen
from benchmarks.free_throw import LINE, SEVENTY
from benchmarks.report import table
from hoopgen import HOOP, PAPER, PAPER_AIR, Scatter
from hoopgen.core.units import DEGREE, FOOT
from hoopgen.simulation.engine import Engine
from hoopgen.study.questions.aimed_release import Aim
from hoopgen.study.questions.estimate_result import Estimate
from hoopgen.text.numbers import format_percent

HEADING = "## What air changes"

FEET = (13.75, 19.0, 23.75, 30.0, 41.75)
"""Distances from the ring's centre: free throw, mid-range, the NBA's three-pointer, deep, and from
the middle line."""

ANGLES = tuple(np.arange(44.0, 61.0, 2.0).tolist())
"""Release angles among which the best is looked for, degrees."""

HEIGHT, SPIN, DEPTH = LINE["height"], LINE["backspin"], 0.05


@dataclass(frozen=True)
class Flight:
    """The flights from a distance, each without and with air.

    Attributes
    ----------
    feet
        Distance, ft.
    speed, elevation, entry
        Of the slowest release through the centre, m/s and degrees.
    moved
        By how much 0.1 m/s more carry it past the centre, m.
    short
        By how much the release of the parabola comes down short of the centre in air, without spin
        and with it, m.
    made, angle
        Largest share of made shots among the release angles, and that angle, degrees.
    """

    feet: float
    speed: tuple[float, float]
    elevation: tuple[float, float]
    entry: tuple[float, float]
    moved: tuple[float, float]
    short: tuple[float, float]
    made: tuple[float, float]
    angle: tuple[float, float]


def flights(shots: int, feet: Sequence[float] = FEET) -> list[Flight]:
    """Return the flights from each distance.

    Parameters
    ----------
    shots
        Shots at each release angle.
    feet
        The distances, ft.
    """
    return [_flight(one, shots) for one in feet]


def _flight(feet: float, shots: int) -> Flight:
    from_there: dict[str, Any] = {"height": HEIGHT, "distance": feet * FOOT}
    scenes = ((HOOP, PAPER), (hoopgen.AIR, PAPER_AIR))
    slowest = [hoopgen.aim(**from_there, backspin=SPIN, scene=scene) for scene, _ in scenes]
    parabola = hoopgen.aim(**from_there)
    states = np.stack(
        [hoopgen.release(**parabola.arguments, backspin=spin) for spin in (0.0, SPIN)]
    )
    _, ends = hoopgen.AIR.fall(states, 0.0, PAPER_AIR)
    best = []
    for scene, parameters in scenes:
        shares = []
        for angle in ANGLES:
            there = {**from_there, "backspin": SPIN, "aim": DEPTH, "elevation": angle * DEGREE}
            player = Scatter(there, SEVENTY)
            found = hoopgen.estimate(player, parameters, scene=scene, shots=shots)
            assert isinstance(found, Estimate)
            shares.append(found.probability)
        best.append((max(shares), ANGLES[int(np.argmax(shares))]))
    return Flight(
        feet=feet,
        speed=_pair(one.speed for one in slowest),
        elevation=_pair(np.degrees(one.elevation) for one in slowest),
        entry=_pair(np.degrees(one.entry_angle) for one in slowest),
        moved=_pair(_moved(*one) for one in zip(scenes, slowest, strict=True)),
        short=_pair(ends[:, 0]),
        made=_pair(made for made, _ in best),
        angle=_pair(angle for _, angle in best),
    )


def _moved(scene: tuple[Engine, Mapping[str, float]], found: Aim) -> float:
    """Return the distance past the centre to which 0.1 m/s more carries a release, m."""
    engine, parameters = scene
    faster = found.arguments | {"speed": found.speed + 0.1}
    _, ends = engine.fall(hoopgen.release(**faster)[None], 0.0, parameters)
    return -float(ends[0, 0])


def _pair(values: Iterable[Any]) -> tuple[float, float]:
    """Return two numbers, without and with air."""
    first, second = (float(one) for one in values)
    return first, second


def section(found: Sequence[Flight], shots: int) -> list[str]:
    """Return the lines of the section.

    Parameters
    ----------
    found
        As of `flights`.
    shots
        Shots at each release angle.
    """
    rows = [
        [
            f"{one.feet:g} ft",
            _both(one.speed, "{:.2f}", " m/s"),
            f"{100.0 * (one.speed[1] / one.speed[0] - 1.0):+.1f}%",
            _both(one.elevation, "{:.1f}", "°"),
            _both(one.entry, "{:.1f}", "°"),
            _both(_pair(100.0 * value for value in one.moved), "{:.0f}", " cm"),
            f"{100.0 * one.short[0]:.0f} cm",
            f"{100.0 * (one.short[0] - one.short[1]):.0f} cm",
        ]
        for one in found
    ]
    shares = [
        [
            f"{one.feet:g} ft",
            " → ".join(format_percent(made) for made in one.made),
            _both(one.angle, "{:.0f}", "°"),
        ]
        for one in found
    ]
    head = ["distance", "least speed", "more", "its release angle", "its entry angle"]
    head += ["0.1 m/s moves it by", "falls short by", "of which 3 Hz of backspin give back"]
    return [
        HEADING,
        "",
        "`AIR` has drag, buoyancy and the Magnus force, with the defaults of `PAPER_AIR`; C_d lies "
        "in the literature's 0.45 to 0.54, C_m = 0.6 is a guess. The release is 7 ft up with 3 Hz "
        "of backspin. Each pair is without air → in air. The first table has the slowest release "
        "through the ring's centre, and how far 0.1 m/s more carry it past; the last two columns "
        "say how far short that of the parabola comes down in air without spin, and how much of "
        "it the backspin's lift makes up.",
        "",
        *table(head, rows),
        f"The second has the best of the release angles from {ANGLES[0]:.0f}° to "
        f"{ANGLES[-1]:.0f}° in steps of {ANGLES[1] - ANGLES[0]:.0f}°, for the player above who "
        f"aims 5 cm past the centre ({shots:,} shots at each angle, the same random numbers; near "
        "the best the share is flat, so the angle is uncertain by a step or two). The player aims "
        "again for the air.",
        "",
        *table(["distance", "share made", "release angle"], shares),
        "In air the ball comes down steeper, and an error of the speed moves it less, so the same "
        "spread makes more shots. Brancazio's angle of least speed is the one without air; in air "
        "it is flatter, the more so from further away. No row of Okubo and Hubbard, Gablonsky and "
        "Lang, or Barzykina is beside these: we could read no number of theirs that is of such a "
        "shot.",
        "",
    ]


def _both(pair: tuple[float, float], form: str, unit: str) -> str:
    """Return a pair as text, without air and in air."""
    return " → ".join(form.format(one) + unit for one in pair)
