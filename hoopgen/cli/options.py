"""Options that commands share and that are no settings of questions."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from typing import Any

import click

from hoopgen.core.units import System, use_units
from hoopgen.hoop.presets import PRESETS
from hoopgen.hoop.variables import VARIABLES
from hoopgen.study.questions.settings import Parsing, TableSettings

from .path_types import FILE, PICTURE
from .place_option import place_option
from .question_options import setting_options, together
from .scene_option import NEEDED, engine_of, parameters_of, scene_option
from .shot_files import reading_of, simulation_options, with_its_scene
from .types import ASSIGNMENT, DEVIATION, SETTING, once, quantity

Decorator = Callable[[Any], Any]

UNITS_IN_WORDS = """\b
Units are written in words, with or without a blank between, feet as well as ft:
  length  m cm mm ft in, 6ft8in too     speed  m/s cm/s ft/s km/h mph
  angle   deg rad                       spin   Hz rev/s rpm rad/s deg/s
A bare length or speed is SI, m or m/s; an angle or a spin other than 0 needs its unit.

"""
"""Text for the end of a command's help."""


VARIABLE_HELP: Mapping[str, str] = {
    "speed": "Speed at release.",
    "elevation": "Angle of release above the horizontal.",
    "azimuth": "Direction; 0 at the centre of the ring, positive to the shooter's left.",
    "backspin": "Spin about the horizontal axis across the flight.",
    "sidespin": "Spin about the vertical axis.",
    "height": "Height of the ball's centre above the floor; the ring is at 10 ft = 3.048 m.",
    "distance": "Distance on the floor plan to the centre of the ring.",
    "angle": "Place around the ring: 0 straight in front of the board, positive towards +y.",
    "aim": "Distance past the ring's centre at which the ball comes down; replaces the speed.",
    "entry": "Angle at which the ball comes down to the ring; replaces the elevation and, "
    "without --aim, the speed.",
    "x": "Place on the floor, away from the board; with --y it replaces distance and angle.",
    "y": "Place on the floor, along the board.",
}
"""Variables of a release that are options."""


def variable_option(name: str, **changes: Any) -> Decorator:
    """Return the option of a variable, one of `VARIABLE_HELP`; `changes` as of `click.option`."""
    kind = VARIABLES[name].kind
    attributes = {"type": quantity(kind, name), "help": VARIABLE_HELP[name], **changes}
    return click.option(f"--{name}", **attributes)


def argument_options(*, required: bool) -> Decorator:
    """Return the options of all arguments of `hoopgen.release`; those needed may be required."""
    others = ("azimuth", "backspin", "sidespin", "angle")
    return together(
        *(variable_option(name, required=required) for name in NEEDED),
        *(variable_option(name, default=0.0) for name in others),
        place_option,
    )


preset_options = together(
    click.option(
        "--preset",
        type=click.Choice(list(PRESETS), case_sensitive=False),
        default="paper",
        show_default=True,
        help="Set of values of all parameters; a file of results has its own. For --scene "
        "court it has also friction, and most of its restitutions and frictions are assumed.",
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


def scene_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--preset`` and ``--set``; give `parameters`, the two merged, to the command."""

    @functools.wraps(command)
    def collected(*arguments: Any, **options: Any) -> Any:
        parameters = parameters_of(engine_of(), options.pop("preset"), options.pop("settings"))
        return command(*arguments, parameters=parameters, **options)

    decorated: Callable[..., Any] = preset_options(collected)
    return decorated


override_option = click.option(
    "--override",
    is_flag=True,
    help="Simulate the shots of a file of results with the options where the two contradict each "
    "other.",
)

reading_options = setting_options(TableSettings, Parsing)
"""Options of how a table is read; `hoopgen.cli.shot_files.reading_of` takes them."""

release_option = click.option(
    "--release",
    type=ASSIGNMENT,
    multiple=True,
    callback=once,
    help="A variable that all rows of the table share, in place of a column, height=7ft; may be "
    "repeated.",
)
"""``--release`` of a command that reads a table."""

_TABLE = together(
    click.argument("file", type=FILE, is_eager=True, callback=with_its_scene),
    scene_option,
    release_option,
    place_option,
    preset_options,
    override_option,
)


def table_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add FILE, a table of releases, and what goes with it.

    The command has `reading_options`, too. It is given the `scene`, and `parameters` and
    `max_contacts`, None for what FILE says.
    """

    @functools.wraps(command)
    def collected(*arguments: Any, preset: str, settings: Any, **options: Any) -> Any:
        engine = engine_of()
        origin, assumption = simulation_options(engine, options["file"], reading_of(dict(options)))
        result = command(*arguments, scene=engine, **(options | origin))
        if assumption:
            click.echo(assumption, err=True)
        return result

    decorated: Callable[..., Any] = _TABLE(collected)
    return decorated


def instrument_option(when: str = "") -> Decorator:
    """Return ``--instrument``, the standard errors of a measurement; `when` ends a clause."""
    return click.option(
        "--instrument",
        type=DEVIATION,
        multiple=True,
        callback=once,
        help=f"Standard error of the measurement of a variable, speed=2cm/s{when}; by default "
        "columns sd_speed_m_s ... of the table, as hoopgen fit writes them. May be repeated.",
    )


json_option = click.option(
    "--json", "as_json", is_flag=True, help="Write everything as JSON; SI units, numbers in full."
)


def _use_units(ctx: click.Context, _: click.Parameter, system: System) -> None:
    ctx.with_resource(use_units(system))


def units_option_of(system: System) -> Decorator:
    """Return ``--units`` with a default; it holds for as long as the command runs."""
    return click.option(
        "--units",
        type=click.Choice(["si", "us"], case_sensitive=False),
        default=system,
        show_default=True,
        expose_value=False,
        callback=_use_units,
        help="Units of text and pictures, not of files: metres, m/s, kg; or feet, inches, mph, "
        "ounces.",
    )


units_option = units_option_of("si")
"""``--units``, SI by default."""


def picture_option(what: str) -> Decorator:
    """Return ``--picture``, which draws the shot, the map or what else a command finds."""
    return click.option("--picture", type=PICTURE, help=f"Draw the {what}: .png, .svg or .pdf.")
