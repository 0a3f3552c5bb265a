"""What commands share: options, each defined once, and examples in the help."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import click

from hoopgen.cli.examples import examples
from hoopgen.cli.flown import flown, reading_of
from hoopgen.cli.generic import Choice
from hoopgen.cli.own import NEEDED, engine_of, parameters_of, scene_option
from hoopgen.cli.types import (
    ASSIGNMENT,
    COLUMN,
    COUNT,
    FILE,
    FOLDER,
    MEMORY,
    PICTURE,
    SCENE,
    SETTING,
    once,
    variable_type,
    whole,
)
from hoopgen.hoop.presets import PRESETS
from hoopgen.inputs import MAX_CONTACTS
from hoopgen.units import System, showing

__all__ = [
    "UNITS_IN_WORDS",
    "VARIABLE_HELP",
    "WAYS",
    "argument_options",
    "backend_option",
    "by_option",
    "confidence_option",
    "examples",
    "folder_option",
    "json_option",
    "max_contacts_option",
    "override_option",
    "picture_option",
    "preset_options",
    "reading_options",
    "scene_options",
    "scheduler_option",
    "seed_option",
    "table_options",
    "threads_option",
    "together",
    "units_option",
    "variable_option",
]

Decorator = Callable[[Any], Any]

UNITS_IN_WORDS = """\b
Units are written in words, with or without a blank between, feet as well as ft:
  length  m cm mm ft in, 6ft8in too     speed  m/s cm/s ft/s km/h mph
  angle   deg rad                       spin   Hz rev/s rpm rad/s deg/s
A bare length or speed is SI, m or m/s; an angle or a spin other than 0 needs its unit.

"""
"""For the end of a command's help."""


def together(*options: Decorator) -> Decorator:
    """Make one decorator of options, in the order of the help."""

    def decorated(command: Any) -> Any:
        for option in reversed(options):
            command = option(command)
        return command

    return decorated


# --------------------------------------------------------------------------------------- a release

VARIABLE_HELP: Mapping[str, str] = MappingProxyType(
    {
        "speed": "Speed at release.",
        "elevation": "Angle of release above the horizontal.",
        "azimuth": "Direction; 0 at the centre of the ring, positive to the shooter's left.",
        "backspin": "About the horizontal axis across the flight.",
        "sidespin": "About the vertical axis.",
        "height": "Of the ball's centre above the floor; the ring is at 10 ft = 3.048 m.",
        "distance": "On the floor plan, to the centre of the ring.",
        "angle": "Where on the floor: 0 straight in front of the board, around the ring to +y.",
        "aim": "In place of the speed: come down so far past the centre of the ring.",
        "entry": "In place of the elevation (and, without --aim, the speed): angle of coming down.",
        "x": "With --y, in place of distance and angle: place on the floor, away from the board.",
        "y": "Place on the floor, along the board.",
    }
)
"""Variables of a release that are options."""


def variable_option(name: str, **changes: Any) -> Decorator:
    """Return the option of a variable, one of `VARIABLE_HELP`; `changes` as of `click.option`."""
    attributes = {"type": variable_type(name), "help": VARIABLE_HELP[name], **changes}
    return click.option(f"--{name}", **attributes)


def argument_options(*, required: bool) -> Decorator:
    """Return the options of all arguments of `hoopgen.release`; those needed may be required."""
    return together(
        *(variable_option(name, required=required) for name in NEEDED),
        *(
            variable_option(name, default=0.0)
            for name in ("azimuth", "backspin", "sidespin", "angle")
        ),
    )


# --------------------------------------------------------------------------------------- the scene

preset_options = together(
    click.option(
        "--preset",
        type=click.Choice(list(PRESETS), case_sensitive=False),
        default="paper",
        show_default=True,
        help="Ball, ring, board and restitution; a file of results names its own. Of --scene court "
        "restitution and friction too, of which most are guesses.",
    ),
    click.option(
        "--set",
        "settings",
        type=SETTING,
        multiple=True,
        callback=once,
        help="Change one parameter of the preset; may be repeated.",
    ),
)
"""``--preset`` and ``--set``."""


def scene_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--preset`` and ``--set``; give `parameters`, the two merged, to the command."""

    @functools.wraps(command)
    def collected(*arguments: Any, **options: Any) -> Any:
        parameters = parameters_of(engine_of(), options.pop("preset"), options.pop("settings"))
        return command(*arguments, parameters=parameters, **options)

    decorated: Callable[..., Any] = preset_options(collected)
    return decorated


# ---------------------------------------------------------------------------------------- the work

max_contacts_option = click.option(
    "--max-contacts",
    type=whole(most=2**31 - 1),
    default=MAX_CONTACTS,
    show_default=True,
    help="Contacts after which a shot is given up as capped.",
)

backend_option = click.option(
    "--backend",
    type=click.Choice(["auto", "c", "numpy"]),
    default="auto",
    show_default=True,
    help="What computes; all give the same bits.",
)

threads_option = click.option("--threads", type=COUNT, help="As many as there are, by default.")

scheduler_option = click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Of a Dask scheduler whose workers compute, tcp://host:8786.",
)

folder_option = click.option(
    "--folder", type=FOLDER, help="Keep finished chunks there; the same command goes on from them."
)

seed_option = click.option(
    "--seed",
    type=whole(0, 2**64 - 1, "NUMBER"),
    default=0,
    show_default=True,
    help="Of the random numbers.",
)

confidence_option = click.option(
    "--confidence",
    type=click.FloatRange(0, 1, min_open=True, max_open=True),
    default=0.95,
    show_default=True,
    help="Of the intervals.",
)

WAYS = ("any", "direct", "bank")
"""In which a shot may go in."""


class _By(Choice):
    """A way in; with ``--scene`` an end of that scene, which is known when it is compiled."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the way or the end."""
        scene = None if ctx is None else ctx.meta.get(SCENE)
        own = scene is not None and not getattr(scene, "has_hoop", False)
        return value if own else super().convert(value, param, ctx)


by_option = click.option(
    "--by",
    type=_By(WAYS),
    default="any",
    show_default=True,
    help="What counts: any made shot, not off the board, or off the board; with --scene an end.",
)

# -------------------------------------------------------------------------------------- in and out

override_option = click.option(
    "--override",
    is_flag=True,
    help="Fly the shots of a file of results as the options say, though the file says otherwise.",
)

reading_options = together(
    click.option(
        "--format",
        type=click.Choice(["csv", "parquet", "arrow", "xlsx"]),
        help="Of the table; by default as the file's suffix says.",
    ),
    click.option(
        "--delimiter",
        metavar="CHARACTER",
        help="Between the cells of CSV, ; or tab; by default as its first line says.",
    ),
    click.option(
        "--column",
        "columns",
        type=COLUMN,
        multiple=True,
        callback=once,
        help="Read a column as a variable, speed=release_speed_mph; may be repeated. The unit is "
        "at the end of either name: azimuth_deg='Side angle'.",
    ),
    click.option(
        "--own",
        metavar="COLUMN",
        multiple=True,
        help="A column that is not to be read, though it is named like a variable.",
    ),
    click.option(
        "--where",
        metavar="CONDITION",
        multiple=True,
        help="Leave out rows that do not meet it: 'speed_mph >= 15', 'player == Ann'. If repeated, "
        "all must hold.",
    ),
    click.option(
        "--keep-implausible",
        "implausible",
        is_flag=True,
        help="Simulate rows with implausible numbers, too, such as an elevation of 500 degrees.",
    ),
    click.option(
        "--memory",
        type=MEMORY,
        help="That rows read at once may take, 4GB; 1 GB by default.",
    ),
)
"""How a table is read; `hoopgen.cli.flown.reading_of` takes them."""

_TABLE = together(
    click.argument("file", type=FILE),
    scene_option,
    click.option(
        "--release",
        type=ASSIGNMENT,
        multiple=True,
        callback=once,
        help="A variable that all rows share, in place of a column; may be repeated.",
    ),
    preset_options,
    override_option,
    max_contacts_option,
    reading_options,
)


def table_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add FILE, a table of releases, and what goes with it.

    The command is given the `scene`, and `parameters` and `max_contacts`, None for what FILE says.
    """

    @functools.wraps(command)
    def collected(*arguments: Any, preset: str, settings: Any, **options: Any) -> Any:
        engine = engine_of()
        asked, assumed = flown(engine, options["file"], reading_of(dict(options)))
        result = command(*arguments, scene=engine, **(options | asked))
        if assumed:
            click.echo(assumed, err=True)
        return result

    decorated: Callable[..., Any] = _TABLE(collected)
    return decorated


json_option = click.option(
    "--json", "as_json", is_flag=True, help="Write everything as JSON; SI units, numbers in full."
)


def _show(ctx: click.Context, _: click.Parameter, system: System) -> None:
    ctx.with_resource(showing(system))


units_option = click.option(
    "--units",
    type=click.Choice(["si", "us"], case_sensitive=False),
    default="si",
    show_default=True,
    expose_value=False,
    callback=_show,
    help="Of text and pictures: metres and m/s, or feet, inches and mph. Files keep theirs.",
)
"""``--units``; it holds for as long as the command runs."""


def picture_option(what: str) -> Decorator:
    """Return ``--picture``, which draws the shot, the map or what else a command finds."""
    return click.option("--picture", type=PICTURE, help=f"Draw the {what}: .png, .svg or .pdf.")
