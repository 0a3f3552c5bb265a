"""``--scene``: a scene of one's own in place of the hoop, and how its shots are released."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource
from click.shell_completion import CompletionItem

from hoopgen.core.units import Kind, parse_quantity
from hoopgen.hoop.variables import ALTERNATIVE_VARIABLES, ARGUMENTS
from hoopgen.simulation.lookup import BUILT_IN, SUFFIX
from hoopgen.text.shorten import brief

from .path_types import FILE
from .types import COUNT, SCENE, Parsed, once

if TYPE_CHECKING:
    from hoopgen.engine.compiled_scene import CompiledScene
    from hoopgen.simulation.engine import Engine

NEEDED = ("speed", "elevation", "height", "distance")
"""Arguments of `hoopgen.release` that have no default."""

VARIABLE_NAMES = (*ARGUMENTS, *ALTERNATIVE_VARIABLES)
"""Options of a release at a hoop."""

_STATE = ("position", "velocity", "spin")
_COMPONENTS = (("x", "y", "z"), ("vx", "vy", "vz"), ("wx", "wy", "wz"))


class SceneName(Parsed[str]):
    """A scene by its name, or a scene file."""

    def __init__(self) -> None:
        super().__init__(str, "|".join((*BUILT_IN, "FILE.toml")))

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the text, once it names a scene that there is.

        Arguments as for `click.ParamType.convert`.
        """
        from hoopgen.simulation.lookup import is_built_in

        try:
            return value if is_built_in(value) else str(FILE.convert(value, param, ctx))
        except ValueError as error:
            self.fail(str(error), param, ctx)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """Complete the names of scenes, and scene files with the folders on the way to them.

        Arguments as for `click.ParamType.shell_complete`.
        """
        found = [CompletionItem(name) for name in BUILT_IN if name.startswith(incomplete)]
        folder, _, begun = incomplete.rpartition("/")
        there = Path(folder or ("/" if incomplete.startswith("/") else ".")).expanduser()
        try:
            entries = sorted(there.iterdir())
        except OSError:
            return found
        before = incomplete.removesuffix(begun)
        for entry in entries:
            hidden = entry.name.startswith(".") and not begun.startswith(".")
            if not entry.name.startswith(begun) or hidden:
                continue
            if entry.is_dir():
                found.append(CompletionItem(f"{before}{entry.name}/"))
            elif entry.suffix.lower() == SUFFIX:
                found.append(CompletionItem(f"{before}{entry.name}"))
        return found


def _read(ctx: click.Context, _: click.Parameter, text: str | None) -> str | None:
    from hoopgen.simulation.hoop import HOOP
    from hoopgen.simulation.lookup import scene_from

    if text is not None and (found := scene_from(text)) is not HOOP:
        ctx.meta[SCENE] = found
    return text


def _limit(text: str) -> tuple[str, int]:
    from hoopgen.scene.limits import NAMES

    name, separator, count = (part.strip() for part in text.partition("="))
    if not separator:
        raise ValueError(f"{brief(text)} is not name=count")
    if name not in NAMES:
        raise ValueError(f"{brief(name)} is none of {', '.join(NAMES)}")
    return name, COUNT.read(count)


def _raise(ctx: click.Context, param: click.Parameter, given: Any) -> None:
    from hoopgen.scene.limits import Limits, use_limits

    if given:
        ctx.with_resource(use_limits(Limits(**once(ctx, param, given))))


limit_option = click.option(
    "--limit",
    type=Parsed(_limit, "NAME=COUNT"),
    multiple=True,
    is_eager=True,
    expose_value=False,
    callback=_raise,
    help="Raise a limit on the size of a scene file, parameters=500 or bounds=1000; may be "
    "repeated.",
)
"""``--limit``: a file that is larger than a usual one is read when its reader says so."""


class _SceneOption(click.Option):
    """``--scene``, read within the limits that ``--limit`` raises, wherever that stands."""

    def handle_parse_result(
        self, ctx: click.Context, opts: Mapping[str, Any], args: list[str]
    ) -> tuple[Any, list[str]]:
        """Read the option after ``--limit``."""
        for param in ctx.command.params:
            if param.name == "limit":
                param.handle_parse_result(ctx, opts, args)
        return super().handle_parse_result(ctx, opts, args)


_scene_option = click.option(
    "--scene",
    "scene_name",
    cls=_SceneOption,
    type=SceneName(),
    is_eager=True,
    expose_value=False,
    callback=_read,
    help="Scene by name, or scene file, .toml; --set then changes its parameters.",
)


def scene_option(command: Any) -> Any:
    """Add ``--scene``, and ``--limit`` with it."""
    return _scene_option(limit_option(command))


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


position_option = click.option(
    "--position",
    type=_vector("length", "m|ft"),
    help="Position of the ball's centre at release, with --scene.",
)
"""``--position`` of a release in a scene of one's own."""

_STATE_OPTIONS = (
    position_option,
    click.option(
        "--velocity", type=_vector("speed", "m/s|mph"), help="Velocity at release, with --scene."
    ),
    click.option(
        "--spin",
        type=_vector("spin", "Hz|rev/s"),
        help="Spin at release, with --scene; none by default.",
    ),
)


def own_options(command: Any) -> Any:
    """Add ``--scene``, and the state in which a shot of that scene is released."""
    for option in reversed((scene_option, *_STATE_OPTIONS)):
        command = option(command)
    return command


def own_needs(typed: Mapping[str, Any], varied: Collection[str] = ()) -> list[str]:
    """Return the missing components of the state at the release in a scene of your own.

    Parameters
    ----------
    typed
        The options as they are typed, by name.
    varied
        Components of the state that are varied.
    """
    if set(typed) & set(VARIABLE_NAMES):
        return []  # of a shot at a hoop, which is said first
    needed = zip(_STATE[:2], _COMPONENTS, strict=False)
    return [f"--{n}" for n, parts in needed if n not in typed and not set(parts) <= set(varied)]


def state_is_given(typed: Mapping[str, Any]) -> bool:
    """Return whether options give the state of a shot in a scene of one's own."""
    return not set(typed).isdisjoint(_STATE)


def shot_needs(typed: Mapping[str, Any]) -> list[str]:
    """Return the missing options of the release of one shot without a file."""
    if "file" in typed:
        return []
    if typed.get("scene_name", "hoop") not in BUILT_IN:
        return own_needs(typed)
    if state_is_given(typed):
        return []  # of a shot in a scene of one's own, which is said first
    return [f"--{name}" for name in NEEDED if name not in typed]


def engine_of() -> Engine:
    """Return the scene that this command names, compiled; the hoop where it names none."""
    from hoopgen.simulation import lookup

    context = click.get_current_context()
    engine = lookup.engine_of(context.meta.get(SCENE))
    stray = [name for name in _STATE if context.params.get(name) is not None]
    if engine.has_hoop and stray:
        raise click.UsageError(f"--{stray[0]} is of a shot in a --scene; give that, too")
    return engine


def parameters_of(
    engine: CompiledScene, preset: str, settings: Mapping[str, float]
) -> Mapping[str, Any]:
    """Return the parameters of a scene: those of a preset, or its usual ones, and what is set.

    Parameters
    ----------
    engine
        The scene.
    preset
        The name of one of the scene's presets; a scene without presets has its own values.
    settings
        Values of ``--set`` by name, SI.

    Returns
    -------
    Mapping
        Every parameter by name, SI.

    Raises
    ------
    click.UsageError
        If a preset is given that the scene does not have.
    """
    presets = engine.presets
    if preset in presets:
        return presets[preset] | dict(settings)
    if given("preset"):
        wanted = f"expected {', '.join(presets)}" if presets else "it has none; leave it out"
        raise click.UsageError(f"--preset {preset} is not one of the scene {engine.name}: {wanted}")
    return engine.parameters | dict(settings)


def state_given(needed: Sequence[str], options: Mapping[str, Any]) -> dict[str, float]:
    """Return the components of a state that are given, by name.

    Parameters
    ----------
    needed
        Options of a hoop's release, which are not its.
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


def release_state(engine: Engine, options: Mapping[str, Any]) -> list[float]:
    """Return the state in which the one shot of a command is released.

    Parameters
    ----------
    options
        Arguments of `hoopgen.release`, and those of `own_options`; None for what is not given.
    """
    import hoopgen

    release = {name: value for name, value in options.items() if name not in _STATE}
    if engine.has_hoop:
        arguments = {name: value for name, value in release.items() if value is not None}
        state: list[float] = hoopgen.release(**arguments).reshape(9).tolist()
        return state
    components = state_given(tuple(release), options)
    return [components.get(name, 0.0) for names in _COMPONENTS for name in names]


def given(option: str) -> bool:
    """Return whether an option of this command was given."""
    source = click.get_current_context().get_parameter_source(option)
    return source not in (None, ParameterSource.DEFAULT, ParameterSource.DEFAULT_MAP)
