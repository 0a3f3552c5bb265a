"""``--scene``: a scene of one's own in place of the hoop, and how its shots are released."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from hoopgen.brief import brief, listed
from hoopgen.cli.types import FILE, Parsed
from hoopgen.units import Kind, parse_quantity

if TYPE_CHECKING:
    from hoopgen.engines import Engine

__all__ = [
    "Setting",
    "engine_of",
    "max_contacts_of",
    "own_options",
    "released",
    "scene_option",
    "state_of",
]

_KEY = "hoopgen.scene"
_STATE = ("position", "velocity", "spin")


def _read(ctx: click.Context, _: click.Parameter, file: Path | None) -> Path | None:
    from hoopgen.scene import load_scene

    if file is not None:
        ctx.meta[_KEY] = load_scene(file)
    return file


scene_option = click.option(
    "--scene",
    "scene_file",
    type=FILE,
    is_eager=True,
    callback=_read,
    help="A scene of one's own, .toml, in place of the hoop; --set then changes its parameters.",
)


def _vector(kind: Kind, unit: str) -> Parsed[tuple[float, float, float]]:
    def read(text: str) -> tuple[float, float, float]:
        parts = text.split(",")
        if len(parts) != 3:
            raise ValueError(f"expected three with commas between, got {brief(text)}")
        first, second, third = (parse_quantity(part, kind) for part in parts)
        return first, second, third

    return Parsed(read, f"X,Y,Z [{unit}]")


def own_options(command: Any) -> Any:
    """Add ``--scene``, and the state in which a shot of that scene is released."""
    options = (
        scene_option,
        click.option(
            "--position",
            type=_vector("length", "m|ft"),
            help="With --scene: of the ball's centre at release.",
        ),
        click.option("--velocity", type=_vector("speed", "m/s|mph"), help="With --scene."),
        click.option(
            "--spin", type=_vector("spin", "Hz|rev/s"), help="With --scene; none by default."
        ),
    )
    for option in reversed(options):
        command = option(command)
    return command


class Setting(Parsed[tuple[str, float]]):
    """A parameter of the preset, or with ``--scene`` of that scene, where numbers are SI."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Read the text."""
        written = None if ctx is None else ctx.meta.get(_KEY)
        if written is None or not isinstance(value, str):
            return super().convert(value, param, ctx)
        name, _, number = (part.strip() for part in value.partition("="))
        if name not in written.defaults:
            there = listed(written.defaults) if written.defaults else "none"
            self.fail(f"unknown {brief(name)}. The scene's parameters are {there}", param, ctx)
        try:
            return name, float(number)
        except ValueError:
            self.fail(f"{name}: expected a number in SI units, got {brief(number)}", param, ctx)


def engine_of() -> Engine | None:
    """Return the scene that this command names, compiled; None: the hoop.

    Raises
    ------
    click.UsageError
        If a preset is named, too.
    """
    context = click.get_current_context()
    written = context.meta.get(_KEY)
    if written is None:
        stray = [name for name in _STATE if context.params.get(name) is not None]
        if stray:
            raise click.UsageError(f"--{stray[0]} is of a shot in a --scene; give that, too")
        return None
    if _given("preset"):
        raise click.UsageError("--preset is the hoop's; with --scene, leave it out")
    import hoopgen

    engine: Engine = hoopgen.compile(written)
    return engine


def released(needed: Sequence[str], options: Mapping[str, Any]) -> list[float]:
    """Return the state in which a shot of the scene is released.

    Parameters
    ----------
    needed
        Options of a hoop's release, which are not its.
    options
        Of the command.

    Raises
    ------
    click.UsageError
        If position or velocity is missing, or a hoop's release is given.
    """
    stray = [name for name in needed if _given(name)]
    if stray:
        raise click.UsageError(
            f"--{stray[0]} is of a shot at a hoop; with --scene give --position and --velocity"
        )
    missing = [f"--{name}" for name in _STATE[:2] if options[name] is None]
    if missing:
        raise click.UsageError(f"with --scene, give {' and '.join(missing)}")
    spin = options["spin"] or (0.0, 0.0, 0.0)
    return [*options["position"], *options["velocity"], *spin]


def state_of(release: Mapping[str, float | None], needed: Sequence[str]) -> list[float]:
    """Return the state in which a shot at the hoop is released.

    Parameters
    ----------
    release
        Arguments of `hoopgen.release`, None where they are not given.
    needed
        Those that have no default.

    Raises
    ------
    click.UsageError
        If an argument that has no default is missing.
    """
    import hoopgen

    context = click.get_current_context()
    for option in context.command.params:
        if option.name in needed and release[option.name] is None:
            raise click.MissingParameter(ctx=context, param=option)
    given = {name: value for name, value in release.items() if value is not None}
    state: list[float] = hoopgen.release(**given).reshape(9).tolist()
    return state


def max_contacts_of(asked: int) -> int | None:
    """Return the contacts asked for, None where nobody has: each scene has its own."""
    return asked if _given("max_contacts") else None


def _given(option: str) -> bool:
    source = click.get_current_context().get_parameter_source(option)
    return source not in (None, ParameterSource.DEFAULT, ParameterSource.DEFAULT_MAP)
