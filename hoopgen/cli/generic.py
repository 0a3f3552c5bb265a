"""Kinds of types of options; older releases of click do not know theirs as generic."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Generic, TypeVar

import click

from hoopgen.cli.command import note_output

__all__ = ["Checked", "Choice", "Parsed", "Type", "Value"]

Value = TypeVar("Value")

if TYPE_CHECKING:

    class Type(click.ParamType[Value]):
        """The type of an option whose text becomes a value of one kind."""

    Choice = click.Choice[str]

else:

    class Type(click.ParamType, Generic[Value]):
        """The type of an option whose text becomes a value of one kind."""

    Choice = click.Choice


class Parsed(Type[Value]):
    """The type of a value that a function reads from text; its ValueError is the option's.

    Parameters
    ----------
    read
        The function.
    metavar
        What the help shows.
    """

    def __init__(self, read: Callable[[str], Value], metavar: str) -> None:
        self.read = read
        self.name = metavar

    def convert(
        self, value: str | Value, param: click.Parameter | None, ctx: click.Context | None
    ) -> Value:
        """Read the text; a default that is none already stands."""
        if not isinstance(value, str):
            return value
        try:
            return self.read(value)
        except ValueError as error:
            self.fail(str(error), param, ctx)

    def get_metavar(self, param: click.Parameter, ctx: click.Context | None = None) -> str:
        """Show it as it is; click would put it in capitals."""
        return self.name


class Checked(Type[Path]):
    """A path that is looked at before any work for it.

    Parameters
    ----------
    check
        Says with a ValueError or OSError what is wrong with it.
    path
        The type of the path alone.
    """

    def __init__(self, check: Callable[[Path], Path], path: click.Path) -> None:
        self.check, self.path = check, path
        self.name = path.name

    def convert(
        self, value: str | Path, param: click.Parameter | None, ctx: click.Context | None
    ) -> Path:
        """Return the path, if it can be written."""
        try:
            path = self.check(Path(str(self.path.convert(value, param, ctx))))
        except OSError as error:
            self.fail(f"{error.filename}: {error.strerror}", param, ctx)
        except ValueError as error:
            self.fail(str(error), param, ctx)
        note_output(ctx, param, path)
        return path
