"""Simulation of the shots of a file: by the options, the file, and what is assumed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.study.questions.settings import Parsing, TableSettings, settings
from hoopgen.text.escape import printable

from .command import ARGUMENTS, defer
from .scene_option import given, parameters_of
from .types import SCENE

if TYPE_CHECKING:
    from hoopgen.study.tables.reading import ReadingOptions
    from hoopgen.study.tables.source import Source

READING = tuple(name for one in (TableSettings, Parsing) for name, *_ in settings(one))
"""Options of how a table is read: names of fields of `study.tables.reading.ReadingOptions`."""


def with_its_scene(ctx: click.Context, _: click.Parameter, file: Path | None) -> Path | None:
    """Let the command simulate in the scene that a file of results says, unless one is named.

    The option or argument is eager: the scene is known before others are read, which name its
    parameters. What is wrong with the file is said when all are read.

    Parameters
    ----------
    ctx
        The context of the command.
    file
        The table of shots; None where the command has none.
    """
    if file is not None:
        typed = ctx.command.make_parser(ctx).parse_args(list(ctx.meta[ARGUMENTS]))[0]
        if "scene_name" not in typed:
            reading = {
                str(option.name): option.type_cast_value(ctx, typed[option.name])
                for option in ctx.command.params
                if option.name in _HOW_SCHEMA_IS_READ and option.name in typed
            }
            with suppress(OSError, ValueError, click.UsageError):
                _use_scene_of(ctx, file, reading)
        defer(ctx, _use_its_scene, first=True)
    return file


_HOW_SCHEMA_IS_READ = ("format", "delimiter")
"""Options without which the columns and the scene of some tables cannot be read."""


def _use_its_scene(ctx: click.Context) -> None:
    from hoopgen.scene.errors import SceneError

    if given("scene_name"):
        return
    try:
        _use_scene_of(ctx, ctx.params["file"], dict(ctx.params))
    except SceneError:
        raise
    except (OSError, ValueError):
        pass  # the command reads the file, and says what is wrong


def _use_scene_of(ctx: click.Context, file: Path, options: dict[str, Any]) -> None:
    from hoopgen.study.tables.provenance import scene_in

    ctx.meta[SCENE] = scene_in(reading_of(options).source(file))


def simulation_options(
    engine: CompiledScene, file: Path, reading: ReadingOptions
) -> tuple[dict[str, Any], str]:
    """Return `parameters` and `max_contacts` as the options of this command ask; None: the file's.

    ``--set`` changes the scene of ``--preset``, or else that of the file. Where nobody names one,
    a line says which is assumed, for stderr when the work is done; else it is empty.

    Parameters
    ----------
    engine
        The scene of the command.
    file
        The table of shots, for messages.
    reading
        The format and the columns that the options ask for.

    Returns
    -------
    tuple
        The two keywords of the library's functions, and the line.

    Raises
    ------
    click.UsageError
        If an option says what a column of the table says.
    OtherScene
        If the file is of another scene.
    """
    from hoopgen.report.provenance import describe_scene
    from hoopgen.study.tables.provenance import OtherScene, names_hoop, origin_of

    context = click.get_current_context()
    settings = dict(context.params["settings"])
    preset = context.params["preset"] if given("preset") else None
    base = parameters_of(engine, preset, {}) if preset else None
    source = reading.source(file)
    _refuse_columns(engine, source, reading, preset, settings)
    says = f"{file.name} names no scene"
    try:
        origin = origin_of(source, engine)
    except OtherScene:
        if not context.params["override"]:
            raise
        origin, says = None, f"{file.name} is of another scene, which --override replaces"
    if base is None:
        base = origin.parameters if origin else engine.parameters
    parameters = {**base, **settings} if preset or settings else None
    assumption = ""
    if engine.is_hoop and not preset and not (origin or names_hoop(source, reading.own)):
        scene = describe_scene(engine, parameters or engine.parameters)
        text = f"{says}: {scene} is assumed; --preset names another"
        assumption = f"hoopgen: {printable(text)}"
    contacts = context.params.get("max_contacts")
    return {"parameters": parameters, "max_contacts": contacts}, assumption


def _refuse_columns(
    engine: CompiledScene,
    source: Source,
    reading: ReadingOptions,
    preset: str | None,
    settings: dict[str, float],
) -> None:
    """Refuse options that name what columns of the table say."""
    from hoopgen.study.tables.columns import variable_of

    names = engine.table.defaults
    spelled = {column: name for name, column in reading.columns.items()}
    columns = {name: spelled.get(name, name) for name in source.schema().names}
    columns_by_variable = {
        variable: name
        for name, one in columns.items()
        if name not in reading.own and (variable := variable_of(one, engine)[0]) in names
    }
    if preset and len(columns_by_variable) == len(names):
        raise click.UsageError(
            f"--preset {preset}: columns of {source.path} say all of the scene; leave it out, or "
            "list the columns with --own"
        )
    for name in settings:
        if column := columns_by_variable.get(name):
            raise click.UsageError(
                f"--set {name}: the column {column} of {source.path} says it; leave it out, "
                f"or add --own {column}"
            )


def option_of(name: str) -> str:
    """Return an option of this command as it is written, by the name of its parameter."""
    options = click.get_current_context().command.params
    return next(option.opts[0] for option in options if option.name == name)


@contextmanager
def names_table(option: str, file: Path | None) -> Iterator[None]:
    """Let an error about a table name the option and the file.

    Parameters
    ----------
    option
        The option by which a scatter is fitted to the table.
    file
        The table.
    """
    try:
        yield
    except ValueError as error:
        argument, colon, rest = str(error).partition(": ")
        if argument != "table" or not colon:
            raise
        raise ValueError(f"{option}: {file}: {rest}") from None


def reading_of(options: dict[str, Any]) -> ReadingOptions:
    """Return the reading of a table, from those of `reading_options`, which are removed."""
    from hoopgen.study.tables.reading import ReadingOptions

    given = {name: options.pop(name) for name in READING if name in options}
    return ReadingOptions.from_options(**given)
