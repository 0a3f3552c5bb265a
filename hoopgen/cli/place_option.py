"""``--place``: a named place of the court in place of a distance and an angle."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click
from click.core import ParameterSource
from click.shell_completion import CompletionItem

from hoopgen.hoop.court_places import PLACES, find_place
from hoopgen.simulation.lookup import BUILT_IN
from hoopgen.text.shorten import join_names

from .command import defer
from .scene_option import engine_of, given, parameters_of
from .types import Type

PLACE = "hoopgen.place"
"""Key of the context's ``meta``: the name of the place that was given."""

_OTHERS = ("distance", "angle", "x", "y")


class PlaceName(Type[str]):
    """The name of a place, which a shell completes."""

    name = "NAME"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return the name, once it is one of a place.

        Arguments as for `click.ParamType.convert`.
        """
        try:
            find_place(value)
        except ValueError as error:
            self.fail(str(error).removeprefix("place: "), param, ctx)
        return str(value)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """Complete the name.

        Arguments as for `click.ParamType.shell_complete`.
        """
        return [CompletionItem(name) for name in PLACES if name.startswith(incomplete.lower())]


def _take(ctx: click.Context, _: click.Parameter, name: str | None) -> None:
    if name is not None:
        ctx.meta[PLACE] = name
        defer(ctx, _expand)


def _expand(ctx: click.Context) -> None:
    """Give the command the distance and the angle of the place."""
    release = ctx.params.get("release")  # what all rows of a table share
    both = [n for n in _OTHERS if given(n) or (isinstance(release, dict) and n in release)]
    if both:
        before = "--" if release is None else "--release "
        spelled = join_names(f"{before}{name}" for name in both)
        raise click.UsageError(f"--place says where; leave out {spelled}")
    scene = engine_of()
    if not scene.has_hoop:
        raise click.UsageError(
            f"--place: places are those about a hoop, of --scene {' or '.join(BUILT_IN)}"
        )
    parameters = parameters_of(scene, ctx.params["preset"], ctx.params["settings"])
    found = find_place(ctx.meta[PLACE], parameters).variables
    if isinstance(release, dict):
        ctx.params["release"] = {**release, **found}
        return
    units = {"distance": "m", "angle": "rad"}
    for param in ctx.command.params:
        if param.name in found:
            text = f"{found[param.name]!r}{units[param.name]}"
            ctx.params[param.name] = param.type_cast_value(ctx, text)
            ctx.set_parameter_source(param.name, ParameterSource.COMMANDLINE)


_NAMED = (
    f"{', '.join(PLACES)}, on the NBA's court or, with --preset fiba, on FIBA's. Put left or "
    "right, as the shooter sees it, before a place with a side."
)


def player_place_option(what: str) -> Callable[[Any], Any]:
    """Return ``--place`` of a command about a player, which is given the name."""
    return click.option("--place", type=PlaceName(), help=f"{what}: {_NAMED}")


place_option = click.option(
    "--place",
    type=PlaceName(),
    expose_value=False,
    callback=_take,
    help=f"Named place, which replaces distance and angle: {_NAMED}",
)
"""``--place``; the command has ``--preset`` and ``--set`` too."""
