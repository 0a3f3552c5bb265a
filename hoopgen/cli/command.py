"""A command: options in groups, all that is missing said at once, no file that is read written."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import click

from hoopgen.outputs import same_file

__all__ = ["ARGUMENTS", "Command", "Needs", "command", "note_input", "note_output"]

Needs = Callable[[Mapping[str, Any]], Sequence[str]]
"""What a command needs besides required options: from the options as they are typed, by name, to
what is missing, such as ``--speed (or --aim)``."""

ARGUMENTS = "hoopgen.arguments"
"""In the context's ``meta``: the words that the command was given."""

_READ, _WRITTEN = "hoopgen.read", "hoopgen.written"

MAX_UNGROUPED = 12
"""Options that a help shows in one list."""

GROUPS: Mapping[str, tuple[str, ...]] = {
    "What is asked": (
        *("over", "places", "versus", "solve", "by", "arc", "depth", "shots", "precision"),
        *("paths", "sample", "measure", "catching-height", "confidence"),
    ),
    "The release": (
        *("speed", "elevation", "azimuth", "backspin", "sidespin", "height", "distance", "angle"),
        *("aim", "entry", "x", "y", "position", "velocity", "spin", "release"),
    ),
    "Its scatter, or measured releases": (
        *("scatter", "correlation", "from", "group", "override", "format", "delimiter", "column"),
        *("own", "where", "keep-implausible", "memory"),
    ),
    "The scene": ("scene", "limit", "preset", "set"),
    "The computation": (
        *("seed", "max-contacts", "max-bits", "backend", "threads", "folder", "scheduler"),
    ),
    "The results": (
        *(
            "out",
            "events",
            "csv",
            "picture",
            "view",
            "prefix",
            "reason",
            "label",
            "title",
            "units",
            "json",
        ),
        "help",
    ),
}
"""Options by the heading under which a long help lists them."""

_OTHERS = "Options"

_HEADING = {name: heading for heading, names in GROUPS.items() for name in names}


class Command(click.Command):
    """A command of hoopgen.

    Parameters
    ----------
    needs
        What it needs besides required options.
    """

    def __init__(self, *arguments: Any, needs: Needs | None = None, **attributes: Any) -> None:
        super().__init__(*arguments, **attributes)
        self.needs = needs

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse the arguments; one error lists all that is missing.

        Raises
        ------
        click.UsageError
            If something is missing.
        """
        words = list(args)
        ctx.meta[ARGUMENTS] = words
        try:
            rest = super().parse_args(ctx, args)
        except click.MissingParameter as error:
            raise self._missing(ctx, words) or error from None
        if not ctx.resilient_parsing and (found := self._missing(ctx, words)):
            raise found
        return rest

    def _missing(self, ctx: click.Context, words: Sequence[str]) -> click.UsageError | None:
        """Return the error that lists what is missing; None if nothing is."""
        typed, _, _ = self.make_parser(ctx).parse_args(list(words))
        given = {name: value for name, value in typed.items() if _is_given(value)}
        required = (one for one in self.get_params(ctx) if one.required and one.name not in given)
        missing = [_name(one) for one in required]
        missing += [one for one in (self.needs(given) if self.needs else ()) if one not in missing]
        if not missing:
            return None
        *others, last = missing
        listed = f"{', '.join(others)} and {last}" if others else last
        return click.UsageError(f"missing {listed}", ctx)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command, unless it would write over a file that it reads.

        Raises
        ------
        click.BadParameter
            If a file to be written is one that is read, or that another option writes.
        click.ClickException
            For an error of the library, with the option in place of the argument.
        """
        before = list(ctx.meta.get(_READ, ()))
        for param, path in ctx.meta.get(_WRITTEN, ()):
            for other, there in before:
                if other is not param and same_file(path, there):
                    what = "reads it" if (other, there) in ctx.meta.get(_READ, ()) else "writes it"
                    said = f"{path}: {_name(other)} {what}, too; give another file"
                    raise click.BadParameter(said, ctx, param)
            before.append((param, path))
        try:
            return super().invoke(ctx)
        except ValueError as error:
            said = self.in_options(str(error))
            if said == str(error):
                raise
            raise click.ClickException(said) from error

    def in_options(self, text: str) -> str:
        """Return an error of the library with the option in place of the argument that it names."""
        found = _ARGUMENT.match(text)
        if found is None:
            return text
        argument, key, rest = found["argument"], found["key"], text[found.end() :]
        options = {name: one for one in self.params for name in _called(one)}
        option = options.get(argument)
        if key and option is None:
            key, option = "", options.get(key)
        if option is not None:
            return f"{' '.join(filter(None, (_name(option), key)))}: {rest}"
        return rest if argument in _WITHOUT_OPTION else text

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options, many of them in groups with headings."""
        records: dict[str, list[tuple[str, str]]] = {heading: [] for heading in (*GROUPS, _OTHERS)}
        for param in self.get_params(ctx):
            record = param.get_help_record(ctx)
            if record is not None and isinstance(param, click.Option):
                name = max(param.opts, key=len).removeprefix("--")
                records[_HEADING.get(name, _OTHERS)].append(record)
        if sum(map(len, records.values())) <= MAX_UNGROUPED:
            super().format_options(ctx, formatter)
            return
        for heading, rows in records.items():
            if rows:
                with formatter.section(heading):
                    formatter.write_dl(rows)


def command(name: str | None = None, **attributes: Any) -> Callable[[Callable[..., Any]], Command]:
    """Return what `click.command` does, for a `Command`; ``needs`` is one of its attributes."""
    return click.command(name, cls=Command, **attributes)


def note_input(ctx: click.Context | None, param: click.Parameter | None, path: Path) -> None:
    """Note that an option or argument names a file that is read."""
    _note(_READ, ctx, param, path)


def note_output(ctx: click.Context | None, param: click.Parameter | None, path: Path) -> None:
    """Note that an option names a file that is written."""
    _note(_WRITTEN, ctx, param, path)


def _note(where: str, ctx: click.Context | None, param: click.Parameter | None, path: Path) -> None:
    if ctx is not None and param is not None:
        ctx.meta.setdefault(where, []).append((param, path))


_ARGUMENT = re.compile(r"(?P<argument>[a-z_]+)(?:\[['\"](?P<key>\w+)['\"]\])?: ")
"""How an error of the library begins that is of an argument, or of one value in it."""

_ALIASES = {"scatter": ("sd",), "settings": ("parameters",), "file": ("columns",)}
"""Options by the name of their parameter, and arguments of the library that they become."""

_WITHOUT_OPTION = ("variables", "release", "model", "aim")
"""Arguments of the library that are made of many options, each of which the error names itself."""


def _called(param: click.Parameter) -> tuple[str, ...]:
    """Return the arguments of the library that a parameter becomes."""
    if not isinstance(param, click.Option):
        return ()
    name = param.name or ""
    return (name, _name(param).removeprefix("--").replace("-", "_"), *_ALIASES.get(name, ()))


_UNSET = getattr(click.core, "UNSET", None)
"""What newer releases of click have for an argument that is not given."""


def _is_given(value: object) -> bool:
    return value is not None and value is not _UNSET


def _name(param: click.Parameter) -> str:
    """Return an option or an argument as a user writes it."""
    if isinstance(param, click.Argument):
        return param.human_readable_name.upper()
    return max(param.opts, key=len)
