"""``hoopgen aim``: the release that comes down through a point, and what it forgives."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

import hoopgen
from hoopgen.core.units import Kind, display_unit, parse_quantity
from hoopgen.hoop.flights import is_in_air
from hoopgen.hoop.variables import ARGUMENTS, VARIABLES
from hoopgen.report.provenance import describe_scene
from hoopgen.report.quantities import for_json, format_launch, format_variable
from hoopgen.simulation.lookup import BUILT_IN
from hoopgen.study.questions.settings import ASKED, RELEASE
from hoopgen.study.questions.specification import TOLERANCES, AimQuestion
from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief, join_names
from hoopgen.text.tables import table

from .command import command
from .distances import DISTANCES
from .messages import echo_json, examples, shown
from .options import (
    UNITS_IN_WORDS,
    json_option,
    picture_option,
    scene_options,
    units_option,
    variable_option,
)
from .path_types import OUT
from .place_option import place_option
from .question_options import SettingOption, question_options
from .scene_option import engine_of, given, position_option, scene_option
from .types import Parsed, number_cell

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from hoopgen.hoop.parabolas import Arc
    from hoopgen.simulation.engine import Engine
    from hoopgen.study.jobs.objective import By
    from hoopgen.study.questions.aimed_release import Aim

    Columns = Mapping[str, NDArray[np.float64]]

_AT_HOOP = {
    **{name: f"--{name}" for name in ("distance", "height", "angle", "depth", "by")},
    "file": "--csv",
}
"""Options of a shot at a hoop, by their parameters."""


_MAX_REASONS = 10
"""Rows of a table for which the text says why they have no release."""


def _vector(components: str, kind: Kind) -> Parsed[tuple[float, ...]]:
    """Return the type of a vector whose components are written with commas between."""

    def read(text: str) -> tuple[float, ...]:
        parts = text.split(",")
        if len(parts) != len(components.split(",")):
            raise ValueError(f"{brief(text)} is not {components}")
        return tuple(parse_quantity(part, kind) for part in parts)

    return Parsed(read, f"{components} [{display_unit(kind).symbol}]")


_POINT = _vector("X,Y,Z", "length")


def _target(text: str) -> tuple[float, ...] | str:
    """Read a point, or the name of a body."""
    return text if text.isidentifier() else _POINT.read(text)


def _needs(typed: Mapping[str, Any]) -> list[str]:
    """Return the missing options of the place: of a hoop, or of another scene."""
    if typed.get("scene_name", "hoop") not in BUILT_IN:
        strays = {"distance", "height"} & set(typed)
        return [] if strays else [f"--{n}" for n in ("position", "target") if n not in typed]
    if "position" in typed:
        return []  # of another scene, which is said first
    needed = {"height": "--height", "distance": "--distance (or --place)"}
    return [option for name, option in needed.items() if name not in typed]


@command(
    short_help="Find the release through a point, and how far it may be off.",
    needs=_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen aim --place 'free throw' --height 7ft",
        "hoopgen aim --distance 13.75ft --height 7ft --entry 45deg --backspin 3Hz --depth 2in",
        "hoopgen aim --distance 1m:7m:0.5m --height 0.6m --speed 9.5 --csv table.csv \\",
        "    --picture table.svg",
        "hoopgen aim --distance 4m --height 1.2m --entry 50deg --moving=-0.5,1.5 --scene air",
    ),
)
@question_options(
    AimQuestion,
    optional=("distance",),
    distance={"type": DISTANCES},
)
@variable_option("height")
@variable_option("angle", default=0.0)
@variable_option("backspin", default=0.0)
@variable_option("sidespin", default=0.0)
@place_option
@click.option(
    "--target",
    cls=SettingOption,
    heading=ASKED,
    type=Parsed(_target, f"{_POINT.name} | BODY"),
    help="Point that the ball comes down through, from the ring's centre, in place of --depth; "
    "with --scene in its coordinates, or the name of a body.",
)
@position_option
@click.option(
    "--moving",
    cls=SettingOption,
    heading=RELEASE,
    type=_vector("VX,VY", "speed"),
    help="Velocity of the place over the floor; speed and angles are relative to it.",
)
@scene_option
@scene_options
@click.option("--csv", "file", type=OUT, help="Write the table: m, m/s, degrees, Hz, s.")
@picture_option("shot; of several distances the table, with what each release forgives")
@units_option
@json_option
def aim(
    distance: tuple[float, ...],
    arc: Arc,
    by: By,
    target: tuple[float, ...] | str | None,
    position: tuple[float, ...] | None,
    moving: tuple[float, ...] | None,
    parameters: Mapping[str, float],
    file: Path | None,
    picture: Path | None,
    as_json: bool,
    threads: int | None,
    folder: Path | None,
    scheduler: str | None,
    **wanted: Any,
) -> None:
    """Aim: the release that comes down through the centre of the ring, and how far it may be off.

    The slowest one, or one with a wanted entry angle, elevation or speed. Its flight leads through
    the ring's centre, --depth past it, or any --target; the ring and the board may be met before,
    which is said. How far off each of speed, elevation and azimuth alone may be, so that the ball
    still goes in, is found by simulation. With --scene air or court-air the flight is through air,
    where spins matter, too. In a scene of one's own the ball is released at --position and comes
    down through --target.
    """
    if file is not None and moving is not None:
        raise click.UsageError(
            "--csv writes releases from places at rest, as hoopgen batch flies them; "
            "leave --moving or --csv"
        )
    from hoopgen.study.questions.aim import aim as aimed
    from hoopgen.study.questions.aim import why_no_release
    from hoopgen.study.questions.aim_table import aim_table, write_csv
    from hoopgen.study.questions.aimed_release import flight_in_words, met_before

    spins = {name: wanted.pop(name) for name in ("backspin", "sidespin")}
    engine = engine_of()
    if not engine.has_hoop:
        angles = {name: wanted[name] for name in ("entry", "elevation", "speed")} | spins
        at = {"position": position, "target": target, "moving": moving}
        _aim_in_scene(engine, picture, as_json, arc=arc, parameters=parameters, **angles, **at)
        return
    flight = {**wanted, **(spins if is_in_air(engine.parameters) else {}), "arc": arc}
    flight |= {"target": target, "moving": moving, "parameters": parameters, "scene": engine}
    if len(distance) == 1:
        # A single number gives the error that says why there is no such release.
        aimed(distance=distance[0], **flight)
    computation: dict[str, Any] = {"threads": threads, "folder": folder, "scheduler": scheduler}
    with shown() as progress:
        options = {**spins, **wanted, **computation, "progress": progress}
        options |= {"target": target, "moving": moving}
        columns = aim_table(
            distance, arc=arc, by=by, parameters=parameters, scene=engine, **options
        )
    release = {name: columns[name] for name in ARGUMENTS if name in columns}
    states = hoopgen.release(**release)
    if moving is not None:
        states[..., 3:5] += moving
    shots = hoopgen.simulate(states, parameters, scene=engine, record=True)
    times = columns["time"].tolist()
    missing = np.flatnonzero(np.isnan(columns["speed"]))
    why: dict[int, str] = {}
    if len(missing):
        reasons = why_no_release(distance=columns["distance"][missing], **flight)
        why = dict(zip(missing.tolist(), reasons, strict=True))
    if as_json:
        said = {"target_m": target} if target is not None else {"depth_m": wanted["depth"]}
        said |= {"moving_m_s": moving, "by": by}
        _echo_json(columns, shots, parameters, said, why)
    elif len(distance) == 1:
        release_values = {name: float(column[0]) for name, column in columns.items()}
        path = flight_in_words(shots, 0, times[0])
        point = _centre(wanted["depth"])
        if target is not None:
            point = f"{_components(map(float, target), 'length')} from the ring's centre"
        click.echo(_one(release_values, point, by, path))
    else:
        click.echo("\n".join([_many(columns), *_without_release(columns, why)]))
        early = [row for row, time in enumerate(times) if met_before(shots, row, time)]
        if early:
            places = join_names(
                format_variable("distance", columns["distance"][row]) for row in early
            )
            click.echo(
                f"hoopgen: {len(early):,} of {format_count(len(times), 'flight')} touch something "
                f"before the point aimed at, from {places}; a steeper --entry may clear it",
                err=True,
            )
    if not as_json:
        click.echo(f"\nscene   {describe_scene(engine, parameters)}")
    if file is not None:
        write_csv(file, columns, parameters)
    if picture is not None:
        if len(distance) == 1:
            _draw(shots, picture)
        else:
            hoopgen.plots.save(hoopgen.plots.plot_aim(columns, parameters), picture)


def _aim_in_scene(engine: Engine, picture: Path | None, as_json: bool, **options: Any) -> None:
    """Aim in a scene without a hoop, from a position at a point or a body."""
    from hoopgen.study.questions.aim import aim as aimed
    from hoopgen.study.questions.aimed_release import flight_in_words

    stray = [option for name, option in _AT_HOOP.items() if given(name)]
    if stray:
        raise click.UsageError(
            f"{stray[0]} is of a shot at a hoop; with --scene give --position and --target"
        )
    found = aimed(scene=engine, **options)
    shots = found.simulate()
    if as_json:
        numbers = ("speed", "elevation", "azimuth", "entry_angle", "time")
        columns = {name: np.ravel(getattr(found, name)) for name in numbers}
        columns |= {name: np.ravel(value) for name, value in found.arguments.items()}
        said = {"target_m": found.target.tolist(), "moving_m_s": options["moving"]}
        _echo_json(columns, shots, options["parameters"], said, {})
    else:
        click.echo("\n".join(_in_scene(found, flight_in_words(shots, 0, float(found.time)))))
        click.echo(f"\nscene   {describe_scene(engine, options['parameters'])}")
    if picture is not None:
        _draw(shots, picture)


def _echo_json(
    columns: Columns,
    shots: hoopgen.Shots,
    parameters: Mapping[str, float],
    said: Mapping[str, Any],
    why: Mapping[int, str],
) -> None:
    """Print the releases with what their flights do, and what was asked, as JSON."""
    from hoopgen.study.named_units import in_units, named
    from hoopgen.study.questions.aimed_release import met_before

    releases = []
    for row in range(len(shots)):
        release = {named(name): float(column[row]) for name, column in columns.items()}
        met = met_before(shots, row, release["time_s"])
        flight = {
            "outcome": shots.scene.outcomes(int(shots.outcome[row])).name.lower(),
            "contacts": int(shots.contacts[row]),
            "counts": dict(zip(shots.surfaces, shots.counts[row].tolist(), strict=True)),
            "touched_before": met and met[0],
            "why_no_release": why.get(row),
        }
        releases.append(release | flight)
    scene = describe_scene(shots.scene, parameters)
    record = {**said, "parameters": in_units(parameters, shots.scene), "scene": scene}
    echo_json(for_json({"releases": releases, **record}))


def _draw(shots: hoopgen.Shots, picture: Path) -> None:
    """Draw the one shot."""
    path = shots.trajectory(0)
    drawn = hoopgen.plots.plot_trajectory(path, path.parameters, outcome=path.outcome)
    hoopgen.plots.save(drawn, picture)


def _centre(depth: float) -> str:
    """Say where the ring's plane is met; `depth` is past its centre, m."""
    side = "past" if depth > 0 else "short of"
    where = f"{format_variable('aim', abs(depth))} {side} its centre" if depth else "at its centre"
    return f"the ring's plane {where}"


def _components(vector: Iterable[float], kind: Kind) -> str:
    unit = display_unit(kind)
    return (
        f"({', '.join(f'{round(part / unit.size, 3) + 0.0:.3f}' for part in vector)}) {unit.symbol}"
    )


def _in_scene(found: Aim, path: str) -> list[str]:
    """Describe a release in a scene without a hoop."""
    numbers = ("speed", "elevation", "azimuth", "time", "entry_angle")
    release = {name: float(getattr(found, name)) for name in numbers}
    release |= {name: float(found.spins[name]) for name in ("backspin", "sidespin")}
    state = found.states()
    moving = f"velocity {_components(state[3:6], 'speed')}"
    turning = f", spin {_components(state[6:], 'spin')}" if any(state[6:]) else ""
    first, *others = _flown(release, _components(found.target, "length"), path)
    return [first, f"        that is, {moving}{turning}", *others]


def _flown(release: Mapping[str, float], point: str, path: str) -> list[str]:
    """Describe a release, where it comes down and what it does."""
    spins = [
        f"{name} {format_variable(name, release[name])}"
        for name in ("azimuth", "backspin", "sidespin")
        if release[name]
    ]
    return [
        ", ".join([f"shoot   {format_launch(release)}", *spins]),
        f"flight  comes down through {point}, after {release['time']:.3f} s at "
        f"{format_variable('entry', release['entry_angle'])}",
        f"flown   {path}",
    ]


def _one(release: Mapping[str, float], point: str, by: str, path: str) -> str:
    """Describe one release, where it comes down, what it does and what it forgives."""
    lines = _flown(release, point, path)
    if math.isnan(release["low_speed"]):
        way = {"any": "in", "direct": "in directly", "bank": "in off the board"}[by]
        return "\n".join([*lines, f"result  does not go {way}: hoopgen shot shows why"])
    rows = []
    for name in TOLERANCES:
        value, *ends = (release.get(key, 0.0) for key in (name, f"low_{name}", f"high_{name}"))
        low, high = (format_variable(name, end) for end in ends)
        less, more = (_signed(name, end - value) for end in ends)
        rows.append([VARIABLES[name].label, low, high, f"{less} to {more}"])
    head = ["one of them off", "goes in from", "to", "off by"]
    return "\n".join([*lines, "", table(head, rows, right=(1, 2))])


def _signed(name: str, value: float) -> str:
    text = format_variable(name, value)
    return text if value < 0 else f"+{text}"


def _without_release(columns: Columns, why: Mapping[int, str]) -> list[str]:
    """Say for the rows of a table that have no release why, of many for the first ones."""
    lines = [
        f"no release from {format_variable('distance', columns['distance'][row])}: {reason}"
        for row, reason in islice(why.items(), _MAX_REASONS)
    ]
    if len(why) > len(lines):
        lines.append(f"and {format_count(len(why) - len(lines), 'more distance')}; --json has all")
    return ["", *lines] if lines else []


def _many(columns: Columns) -> str:
    """Return a table of releases as text."""
    kinds = {"distance": "distance", "speed": "speed", "elevation": "elevation"}
    length, speed, angle = (display_unit(kind).symbol for kind in ("length", "speed", "angle"))
    head = [f"dist. ({length})", f"speed ({speed})", f"elev. ({angle})"]
    if any(azimuth and not math.isnan(azimuth) for azimuth in columns["azimuth"].tolist()):
        kinds["azimuth"] = "azimuth"
        head.append(f"azim. ({angle})")
    kinds["entry_angle"] = "entry"
    head.append(f"entry ({angle})")
    own = len(head)
    kinds |= {f"{end}_{name}": name for name in TOLERANCES for end in ("low", "high")}
    rows = [
        [number_cell(kind, columns[name][row]) for name, kind in kinds.items()]
        for row in range(len(columns["distance"]))
    ]
    symbols = {"speed": speed, "angle": angle}
    for name in TOLERANCES:
        head += [f"from ({symbols[VARIABLES[name].kind]})", "to"]
    groups = [(own + 2 * k, own + 1 + 2 * k, name) for k, name in enumerate(TOLERANCES)]
    return table(head, rows, right=range(len(head)), groups=groups)
