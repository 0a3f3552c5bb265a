"""``hoopgen aim``: the release that comes down through the ring's centre, and what it forgives."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.brief import brief, listed
from hoopgen.cli.command import command
from hoopgen.cli.generic import Parsed
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    by_option,
    examples,
    folder_option,
    picture_option,
    scene_options,
    scheduler_option,
    threads_option,
    units_option,
    variable_option,
)
from hoopgen.cli.own import no_scene_option
from hoopgen.cli.types import OUT, quantity
from hoopgen.layout import table
from hoopgen.phrases import counted
from hoopgen.told import say_scene
from hoopgen.units import parse_quantity, shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from hoopgen.study.aim import Arc
    from hoopgen.study.player import By

    Columns = Mapping[str, NDArray[np.float64]]

__all__ = ["aim"]

_MOST = 10_000
"""Distances of one table."""

_ENOUGH = 1e-6
"""Of a step: an end of a range that is short of a whole number of steps by no more is its last
value, since 0.1 is no binary number."""


def _distances(text: str) -> tuple[float, ...]:
    """Read a length; several, ``3m,4m,5m``; or a range with its step or count, ``1m:7m:0.5m``."""
    parts = text.split(":")
    if len(parts) == 1:
        found = tuple(parse_quantity(part, "length") for part in text.split(","))
    elif len(parts) == 3:
        found = _range(*parts)
    else:
        raise ValueError(f"{brief(text)} is not from:to:step, such as 1m:7m:0.5m")
    if min(found) < 0.0:
        raise ValueError(f"expected 0 m or more, got {min(found):.6g} m")
    return found


def _range(first: str, last: str, by: str) -> tuple[float, ...]:
    """Return a range; `by` is a step if it has a unit, else a count."""
    low, high = parse_quantity(first, "length"), parse_quantity(last, "length")
    if by.strip().isdecimal():
        count = int(by)
        step = (high - low) / (count - 1) if count > 1 else 0.0
    else:
        step = parse_quantity(by, "length")
        steps = (high - low) / step if step > 0.0 else -1.0  # more than any number is infinite
        count = 1 + math.floor(min(steps, _MOST) + _ENOUGH)
    if not (low < high and step > 0.0 and 2 <= count <= _MOST):
        raise ValueError(
            f"{first}:{last}:{by}: expected from below to, and a step (with its unit) or a count "
            f"that makes 2 to {_MOST:,} distances"
        )
    return tuple(low + k * step for k in range(count))


@command(
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen aim --distance 13.75ft --height 7ft",
        "hoopgen aim --distance 13.75ft --height 7ft --entry 45deg --backspin 3Hz --depth 2in",
        "hoopgen aim --distance 1m:7m:0.5m --height 0.6m --speed 9.5 --csv table.csv \\",
        "    --picture table.svg",
        "hoopgen aim --distance 12ft --height 7ft --elevation 55deg --set ball_radius=11.9cm",
    )
)
@variable_option(
    "distance",
    type=Parsed(_distances, "LENGTH [m] | FROM:TO:STEP"),
    required=True,
    help="On the floor plan, to the centre of the ring; several, or a range, give a table.",
)
@variable_option("height", required=True)
@variable_option("entry", help="Wanted angle below the horizontal at the ring.")
@variable_option("elevation", help="Wanted angle of release above the horizontal.")
@variable_option("speed", help="Wanted speed at release.")
@click.option(
    "--arc",
    type=click.Choice(["high", "low"]),
    default="high",
    show_default=True,
    help="Which of the two flights with that speed.",
)
@click.option(
    "--depth",
    type=quantity("length"),
    default=0.0,
    help="Aim so far past the centre of the ring.",
)
@variable_option("angle", default=0.0)
@variable_option("backspin", default=0.0)
@variable_option("sidespin", default=0.0)
@by_option
@no_scene_option
@scene_options
@threads_option
@folder_option
@scheduler_option
@click.option("--csv", "file", type=OUT, help="Write the table: m, m/s, degrees, Hz, s.")
@picture_option("shot; of several distances the table, with what each release forgives")
@units_option
def aim(
    distance: tuple[float, ...],
    arc: Arc,
    by: By,
    parameters: Mapping[str, float],
    file: Path | None,
    picture: Path | None,
    threads: int | None,
    folder: Path | None,
    scheduler: str | None,
    **wanted: Any,
) -> None:
    """Aim: the release that comes down through the centre of the ring, and how far it may be off.

    The slowest one, or one with a wanted entry angle, elevation or speed. Its flight leads through
    a point of the ring's plane, and no other can be aimed at; the ring and the board may be met
    before, which is said. How far off each of speed, elevation and azimuth alone may be is found by
    simulation.
    """
    from hoopgen.cli.progress import shown
    from hoopgen.study.aim import aim as aimed
    from hoopgen.study.aim_table import aim_table, write_csv
    from hoopgen.words import say

    spins = {name: wanted.pop(name) for name in ("backspin", "sidespin")}
    if len(distance) == 1:
        # Of one number it says why there is no such release.
        aimed(distance=distance[0], arc=arc, parameters=parameters, **wanted)
    work: dict[str, Any] = {"threads": threads, "folder": folder, "scheduler": scheduler}
    with shown() as progress:
        options = {**spins, **wanted, **work, "progress": progress}
        columns = aim_table(distance, arc=arc, by=by, parameters=parameters, **options)
    if len(distance) == 1:
        shot = {name: float(column[0]) for name, column in columns.items()}
        flown, _ = _flown(columns, parameters)[0]
        click.echo(_one(shot, wanted, by, flown))
    else:
        click.echo(_many(columns))
        early = [row for row, (_, early) in enumerate(_flown(columns, parameters)) if early]
        if early:
            places = listed(say("distance", columns["distance"][row]) for row in early)
            said = f"{len(early):,} of {counted(len(columns['distance']), 'flight')}"
            click.echo(
                f"hoopgen: {said} touch something before the point aimed at, from {places}; a "
                "steeper --entry may clear it",
                err=True,
            )
    click.echo(f"\nscene   {say_scene(parameters)}")
    if file is not None:
        write_csv(file, columns, parameters)
    if picture is not None:
        _draw(columns, parameters, picture)


def _flown(columns: Columns, parameters: Mapping[str, float]) -> list[tuple[str, bool]]:
    """Return what each release does, in words, and whether something is met before the point."""
    import hoopgen
    from hoopgen.hoop.variables import ARGUMENTS
    from hoopgen.study.aim import flight_in_words, met_before

    release = {name: columns[name] for name in ARGUMENTS if name in columns}
    shots = hoopgen.simulate(hoopgen.release(**release), parameters, record=True)
    return [
        (flight_in_words(shots, row, time), met_before(shots, row, time) is not None)
        for row, time in enumerate(columns["time"].tolist())
    ]


def _draw(columns: Columns, parameters: Mapping[str, float], picture: Path) -> None:
    """Draw one release, followed to its end, or a table of them."""
    import hoopgen
    from hoopgen import plots
    from hoopgen.hoop.variables import ARGUMENTS

    if len(columns["distance"]) > 1:
        plots.save(plots.plot_aim(columns, parameters), picture)
        return
    release = {name: columns[name] for name in ARGUMENTS if name in columns}
    path = hoopgen.simulate(hoopgen.release(**release), parameters, record=True).trajectory(0)
    drawn = plots.plot_trajectory(path, path.parameters, outcome=path.outcome)
    plots.save(drawn, picture)


def _one(shot: Mapping[str, float], wanted: Mapping[str, float], by: str, flown: str) -> str:
    """Say one release, what it does and what it forgives."""
    from hoopgen.hoop.variables import VARIABLES
    from hoopgen.study.aim_table import OFF
    from hoopgen.words import say

    spins = [f"{name} {say(name, shot[name])}" for name in ("backspin", "sidespin") if shot[name]]
    depth = wanted["depth"]
    where = f"{say('aim', abs(depth))} {'past' if depth > 0 else 'short of'} its centre"
    lines = [
        f"shoot   {say('speed', shot['speed'])} at {say('elevation', shot['elevation'])}"
        + "".join(f", {spin}" for spin in spins),
        f"flight  comes down through the ring's plane after {shot['time']:.3f} s at "
        f"{say('entry', shot['entry_angle'])}, {where if depth else 'at its centre'}",
    ]
    lines.append(f"flown   {flown}")
    if math.isnan(shot["low_speed"]):
        way = {"any": "in", "direct": "in directly", "bank": "in off the board"}[by]
        return "\n".join([*lines, f"result  does not go {way}: hoopgen shot shows why"])
    rows = []
    for name in OFF:
        value, low, high = shot.get(name, 0.0), shot[f"low_{name}"], shot[f"high_{name}"]
        off = f"{_signed(name, low - value)} to {_signed(name, high - value)}"
        rows.append([VARIABLES[name].label, say(name, low), say(name, high), off])
    head = ["one of them off", "goes in from", "to", "off by"]
    return "\n".join([*lines, "", table(head, rows, right=(1, 2))])


def _signed(name: str, value: float) -> str:
    from hoopgen.words import say

    text = say(name, value)
    return text if value < 0 else f"+{text}"


def _many(columns: Columns) -> str:
    """Lay out a table of releases."""
    from hoopgen.hoop.variables import VARIABLES
    from hoopgen.study.aim_table import OFF
    from hoopgen.words import say

    def cell(name: str, value: float) -> str:
        return "-" if math.isnan(value) else say(name, value, unit=False)

    kinds = {
        "distance": "distance",
        "speed": "speed",
        "elevation": "elevation",
        "entry_angle": "entry",
        **{f"{end}_{name}": name for name in OFF for end in ("low", "high")},
    }
    rows = [
        [cell(kind, columns[name][row]) for name, kind in kinds.items()]
        for row in range(len(columns["distance"]))
    ]
    symbols = {kind: shown(kind).symbol for kind in ("length", "speed", "angle")}
    head = [f"dist. ({symbols['length']})", f"speed ({symbols['speed']})"]
    head += [f"elev. ({symbols['angle']})", f"entry ({symbols['angle']})"]
    head += [word for name in OFF for word in (f"from ({symbols[VARIABLES[name].kind]})", "to")]
    groups = [(4 + 2 * k, 5 + 2 * k, name) for k, name in enumerate(OFF)]
    return table(head, rows, right=range(len(head)), groups=groups)
