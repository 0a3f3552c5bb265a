"""What commands share: options with units, ``--set``, and examples in the help."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

import click

from hoopgen.units import UNITS, Kind, parse_quantity

__all__ = ["Quantity", "Setting", "backend_option", "examples", "preset_options", "scene"]

Command = TypeVar("Command", bound=Callable[..., Any] | click.Command)

if TYPE_CHECKING:
    _Number = click.ParamType[float]
    _Pair = click.ParamType[tuple[str, float]]
else:
    _Number = _Pair = click.ParamType  # older releases of click do not know it as generic


def examples(*lines: str) -> str:
    """Lay out example lines for the end of a command's help."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)


class Quantity(_Number):
    """A number with a unit, given to the command in SI.

    Parameters
    ----------
    kind
        What is measured; see `hoopgen.units.UNITS`.
    bare
        The unit of a bare number; the SI unit by default.
    """

    def __init__(self, kind: Kind, bare: str | None = None) -> None:
        self.kind: Kind = kind
        self.bare = bare
        self.name = kind

    def convert(
        self, value: str | float, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """Read the text; a default that is a number already stands."""
        if not isinstance(value, str):
            return value
        try:
            return parse_quantity(value, self.kind, bare=self.bare)
        except ValueError as error:
            self.fail(str(error), param, ctx)

    def get_metavar(self, param: click.Parameter, ctx: click.Context | None = None) -> str:
        """Show the unit of a bare number."""
        unit = self.bare or next(iter(UNITS[self.kind]))
        return f"{self.kind.upper()} [{unit}]"


class Setting(_Pair):
    """A parameter of the scene and its value, ``restitution=0.75``."""

    name = "name=value"

    def convert(
        self,
        value: str | tuple[str, float],
        param: click.Parameter | None,
        ctx: click.Context | None,
    ) -> tuple[str, float]:
        """Read the text."""
        if not isinstance(value, str):
            return value
        name, separator, text = (part.strip() for part in value.partition("="))
        if not separator:
            self.fail(f"{value!r} is not name=value", param, ctx)
        import hoopgen

        if name not in hoopgen.PAPER:
            self.fail(f"{name!r} is none of {', '.join(hoopgen.PAPER)}", param, ctx)
        try:
            return name, parse_quantity(text, _kind(name))
        except ValueError as error:
            self.fail(f"{name}: {error}", param, ctx)


def _kind(parameter: str) -> Kind:
    kinds: dict[str, Kind] = {"restitution": "number", "gravity": "acceleration"}
    return kinds.get(parameter, "length")


def preset_options(command: Command) -> Command:
    """Add ``--preset`` and ``--set``."""
    preset = click.option(
        "--preset",
        type=click.Choice(["paper", "nba", "fiba"], case_sensitive=False),
        default="paper",
        show_default=True,
        help="Ball, ring, board and restitution.",
    )
    setting = click.option(
        "--set",
        "settings",
        type=Setting(),
        multiple=True,
        help="Change one parameter of the preset; may be repeated.",
    )
    return preset(setting(command))


def backend_option(command: Command) -> Command:
    """Add ``--backend``."""
    return click.option(
        "--backend",
        type=click.Choice(["auto", "c", "numpy"]),
        default="auto",
        show_default=True,
        help="What computes; all give the same bits.",
    )(command)


def scene(preset: str, settings: tuple[tuple[str, float], ...]) -> Mapping[str, float]:
    """Merge a preset with what is set."""
    import hoopgen

    presets = {"paper": hoopgen.PAPER, "nba": hoopgen.NBA, "fiba": hoopgen.FIBA}
    return presets[preset] | dict(settings)
