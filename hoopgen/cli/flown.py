"""How the shots of a file are flown: what the options say, what the file says, what is assumed."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.own import given, parameters_of
from hoopgen.engines import Engine
from hoopgen.printable import printable

if TYPE_CHECKING:
    from hoopgen.study.reading import Reading
    from hoopgen.study.tables import Source

__all__ = ["READING", "flown", "reading_of", "say_lines"]

READING = ("format", "delimiter", "own", "columns", "where", "implausible", "memory")
"""Names of the options that say how a table is read; those of `hoopgen.study.reading.Reading`."""


def flown(engine: Engine, file: Path, reading: Reading) -> tuple[dict[str, Any], str]:
    """Return `parameters` and `max_contacts` as the options of this command ask; None: the file's.

    ``--set`` changes the scene of ``--preset``, or else that of the file. Where nobody names one,
    a line says which is assumed, for stderr when the work is done; else it is empty.

    Raises
    ------
    click.UsageError
        If the options would change nothing, since columns say the scene.
    ValueError, OSError
        If the file cannot be read.
    """
    from hoopgen.study.origin import OtherScene, names_scene, origin_of
    from hoopgen.told import say_of

    context = click.get_current_context()
    settings = dict(context.params["settings"])
    preset = context.params["preset"] if given("preset") else None
    base = parameters_of(engine, preset, {}) if preset else None
    source = reading.source(file)
    _refuse_columns(engine, source, reading, preset, settings)
    try:
        said = origin_of(source, engine)
    except OtherScene:
        if not context.params["override"]:
            raise
        said = None
    if base is None:
        base = said.parameters if said else engine.parameters
    parameters = {**base, **settings} if preset or settings else None
    assumed = ""
    if engine.is_hoop and not preset and not (said or names_scene(source, reading.own)):
        scene = say_of(engine, parameters or engine.parameters)
        said_of = f"{file.name} names no scene: {scene} is assumed; --preset names another"
        assumed = f"hoopgen: {printable(said_of)}"
    has_contacts = "max_contacts" in context.params
    contacts = context.params["max_contacts"] if has_contacts and given("max_contacts") else None
    return {"parameters": parameters, "max_contacts": contacts}, assumed


def _refuse_columns(
    engine: Engine,
    source: Source,
    reading: Reading,
    preset: str | None,
    settings: dict[str, float],
) -> None:
    """Refuse what columns of the table say in its place."""
    from hoopgen.study.columns import variable_of

    names = engine.table.defaults
    spelled = {column: name for name, column in reading.columns.items()}
    columns = {name: spelled.get(name, name) for name in source.schema().names}
    said = {
        variable: name
        for name, one in columns.items()
        if name not in reading.own and (variable := variable_of(one, engine)[0]) in names
    }
    if preset and len(said) == len(names):
        raise click.UsageError(
            f"--preset {preset}: columns of {source.path} say all of the scene; leave it out, or "
            "list the columns with --own"
        )
    for name in settings:
        if name in said:
            raise click.UsageError(
                f"--set {name}: the column {said[name]} of {source.path} says it; leave it out, "
                f"or add --own {said[name]}"
            )


def reading_of(options: dict[str, Any]) -> Reading:
    """Return how a table is read, from the options of `reading_options`, which are taken out."""
    from hoopgen.study.reading import Reading

    return Reading.of(**{name: options.pop(name) for name in READING})


def say_lines(text: str, *, err: bool = False) -> None:
    """Write lines, some of which may be in the words of a file."""
    for line in text.splitlines():
        click.echo(printable(line), err=err)
