"""``--scene``: a scene of one's own in place of the hoop, and how its shots are released."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from hoopgen.brief import brief
from hoopgen.cli.types import FILE, SCENE, Parsed
from hoopgen.scenes import BUILT_IN
from hoopgen.units import Kind, parse_quantity

if TYPE_CHECKING:
    from hoopgen.engines import Engine

__all__ = [
    "engine_of",
    "given",
    "max_contacts_of",
    "no_scene_option",
    "own_options",
    "parameters_of",
    "released",
    "scene_option",
    "state_given",
    "state_of",
]

_STATE = ("position", "velocity", "spin")
_COMPONENTS = (("x", "y", "z"), ("vx", "vy", "vz"), ("wx", "wy", "wz"))


class _Scene(click.ParamType[str]):
    """A scene by its name, or a scene file."""

    name = "|".join((*BUILT_IN, "FILE.toml"))

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the text, once it names a scene that there is."""
        from hoopgen.scenes import is_built_in

        try:
            return value if is_built_in(value) else str(FILE.convert(value, param, ctx))
        except ValueError as error:
            self.fail(str(error), param, ctx)

    def get_metavar(self, param: click.Parameter, ctx: click.Context | None = None) -> str:
        """Show it as it is."""
        return self.name


def _read(ctx: click.Context, _: click.Parameter, text: str | None) -> str | None:
    from hoopgen.engines import HOOP
    from hoopgen.scenes import scene_from

    if text is not None and (found := scene_from(text)) is not HOOP:
        ctx.meta[SCENE] = found
    return text


scene_option = click.option(
    "--scene",
    "scene_name",
    type=_Scene(),
    is_eager=True,
    expose_value=False,
    callback=_read,
    help="A scene by name, or one of one's own, .toml; --set then changes its parameters.",
)


def _refuse(ctx: click.Context, _: click.Parameter, text: str | None) -> None:
    if text not in (None, "hoop"):
        raise click.UsageError(
            f"hoopgen {ctx.info_name}: its question is a hoop's, the article's; leave --scene out, "
            "or ask estimate, map, optimum, batch, view, shot or certify, which take any scene"
        )


no_scene_option = click.option(
    "--scene", metavar="hoop", is_eager=True, expose_value=False, hidden=True, callback=_refuse
)
"""``--scene`` of a command whose question is a hoop's: it says so."""


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


def engine_of() -> Engine:
    """Return the scene that this command names, compiled; the hoop where it names none.

    Raises
    ------
    click.UsageError
        If the state of a shot is given where shots are thrown at a hoop.
    """
    from hoopgen import scenes

    context = click.get_current_context()
    engine = scenes.engine_of(context.meta.get(SCENE))
    stray = [name for name in _STATE if context.params.get(name) is not None]
    if engine.has_hoop and stray:
        raise click.UsageError(f"--{stray[0]} is of a shot in a --scene; give that, too")
    return engine


def parameters_of(engine: Engine, preset: str, settings: Mapping[str, float]) -> Mapping[str, Any]:
    """Return the parameters of a scene: those of a preset, or its usual ones, and what is set.

    Raises
    ------
    click.UsageError
        If the scene has no such preset.
    """
    from hoopgen.scenes import presets_of

    presets = presets_of(engine)
    if preset in presets:
        return presets[preset] | dict(settings)
    if given("preset"):
        raise click.UsageError(
            f"--preset is a hoop's, and the scene {engine.name} has none; leave it out"
        )
    return engine.parameters | dict(settings)


def state_given(needed: Sequence[str], options: Mapping[str, Any]) -> dict[str, float]:
    """Return the components of a state that are given, by name.

    Parameters
    ----------
    needed
        Options of a hoop's release, which are not its.
    options
        Of the command.

    Raises
    ------
    click.UsageError
        If a hoop's release is given.
    """
    stray = [name for name in needed if given(name)]
    if stray:
        raise click.UsageError(
            f"--{stray[0]} is of a shot at a hoop; with --scene give --position and --velocity"
        )
    return {
        component: value
        for name, names in zip(_STATE, _COMPONENTS, strict=True)
        if options[name] is not None
        for component, value in zip(names, options[name], strict=True)
    }


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
    state = state_given(needed, options)
    missing = [f"--{name}" for name in _STATE[:2] if options[name] is None]
    if missing:
        raise click.UsageError(f"with --scene, give {' and '.join(missing)}")
    return [state.get(name, 0.0) for names in _COMPONENTS for name in names]


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
    return asked if given("max_contacts") else None


def given(option: str) -> bool:
    """Return whether an option of this command was given."""
    source = click.get_current_context().get_parameter_source(option)
    return source not in (None, ParameterSource.DEFAULT, ParameterSource.DEFAULT_MAP)
