"""A command: options in groups, one error for all that is missing, inputs never overwritten."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import click

from hoopgen.core.files import same_file
from hoopgen.study.questions.settings import ASKED, COMPUTED, MEASURED, RELEASE, RESULTS

from .messages import error_text
from .spelling import options_of, spell_options

Needs = Callable[[Mapping[str, Any]], Sequence[str]]
"""Function from the options as they are typed, by name, to what is missing beside the required
options, such as ``--speed (or --aim)``."""

ARGUMENTS = "hoopgen.arguments"
"""Key of the context's ``meta``: the words that the command was given."""

_READ, _WRITTEN, _DEFERRED = "hoopgen.read", "hoopgen.written", "hoopgen.deferred"

MAX_UNGROUPED = 12
"""Options that a help shows in one list."""

GROUPS: Mapping[str, tuple[str, ...]] = {
    ASKED: ("versus", "sample"),
    RELEASE: (
        *("speed", "elevation", "azimuth", "backspin", "sidespin", "height", "distance", "angle"),
        *("place", "aim", "entry", "x", "y", "position", "velocity", "spin", "release"),
    ),
    MEASURED: ("scatter", "correlation", "from", "group", "fitted", "instrument", "override"),
    "The scene": ("scene", "limit", "preset", "set"),
    COMPUTED: ("max-bits", "prove"),
    RESULTS: ("out", "csv", "picture", "view", "label", "title", "units", "json", "help"),
}
"""Options that are no settings, by the heading under which a long help lists them."""

_OTHERS = "Options"

_TABLE = "The table"
"""Heading of the options of measured releases where a command has no scatter."""

_HEADING = {name: heading for heading, names in GROUPS.items() for name in names}


class Command(click.Command):
    """A command of hoopgen; `needs` says what it requires besides required options."""

    def __init__(self, *arguments: Any, needs: Needs | None = None, **attributes: Any) -> None:
        super().__init__(*arguments, **attributes)
        self.needs = needs

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse the arguments; one error lists all that is missing.

        What the options had begun, such as other units, is ended if one of them is refused: click
        itself ends it only after a command that was run.

        Arguments as for `click.Command.parse_args`.
        """
        words = list(args)
        ctx.meta[ARGUMENTS] = words
        try:
            return self._parsed(ctx, words)
        except BaseException:
            ctx.close()
            raise

    def _parsed(self, ctx: click.Context, words: Sequence[str]) -> list[str]:
        try:
            rest = super().parse_args(ctx, list(words))
        except click.MissingParameter as error:
            raise self._missing(ctx, words) or error from None
        if not ctx.resilient_parsing and (missing := self._missing(ctx, words)):
            raise missing
        for call in ctx.meta.pop(_DEFERRED, ()):
            with ctx:
                call(ctx)
        return rest

    def _missing(self, ctx: click.Context, words: Sequence[str]) -> click.UsageError | None:
        """Return the error that lists what is missing; None if nothing is."""
        typed, _, _ = self.make_parser(ctx).parse_args(list(words))
        given = {name: it for name, it in typed.items() if it is not None and it is not _UNSET}
        if "place" in given:
            given["distance"] = given["place"]
        missing = [_name(p) for p in self.get_params(ctx) if p.required and p.name not in given]
        missing += [one for one in (self.needs(given) if self.needs else ()) if one not in missing]
        if not missing:
            return None
        *others, last = missing
        listed = f"{', '.join(others)} and {last}" if others else last
        return click.UsageError(f"missing {listed}", ctx)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command, unless it would write over a file that it reads."""
        reads: Sequence[tuple[click.Parameter, Path]] = ctx.meta.get(_READ, ())
        writes: Sequence[tuple[click.Parameter, Path]] = ctx.meta.get(_WRITTEN, ())
        for index, (param, path) in enumerate(writes):
            users = [*((one, file, "reads") for one, file in reads)]
            users += [(one, file, "writes") for one, file in writes[:index]]
            for other, file, verb in users:
                if other is not param and same_file(path, file):
                    text = f"{path}: {_name(other)} {verb} it, too; give another file"
                    raise click.BadParameter(text, ctx, param)
        try:
            return super().invoke(ctx)
        except (click.Abort, click.exceptions.Exit, RecursionError):
            raise
        except (ImportError, OSError, RuntimeError, ValueError) as error:
            if isinstance(error, OSError) and error.filename is not None:
                raise  # it begins with a file, which may be called like an argument
            said = error_text(error)
            text = self.in_options(said, ctx.command_path)
            if text == said:
                raise
            raise click.ClickException(text) from error

    def in_options(self, text: str, path: str = "hoopgen") -> str:
        """Return an error of the library with the option in place of the argument that it names.

        Parameters
        ----------
        text
            The error.
        path
            The command, as ``hoopgen estimate``.
        """
        text = spell_options(text, options_of(self), path)
        match = _ARGUMENT.match(text)
        if match is None:
            return text
        argument, key, rest = match["argument"], match["key"], text[match.end() :]
        options = {name: one for one in self.params for name in _library_arguments(one)}
        option = options.get(argument)
        if key and option is None:
            key, option = "", options.get(key)
        if option is not None:
            return f"{' '.join(filter(None, (_name(option), key)))}: {rest}"
        return rest if argument in _WITHOUT_OPTION else text

    def _title(self, heading: str) -> str:
        """Return a heading as it is of this command: not each has a scatter."""
        names = {one.name for one in self.params}
        return heading if heading != MEASURED or "scatter" in names else _TABLE

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options, many of them in groups with headings.

        Arguments as for `click.Command.format_options`.
        """
        records: dict[str, list[tuple[str, str]]] = {heading: [] for heading in (*GROUPS, _OTHERS)}
        for param in self.get_params(ctx):
            record = param.get_help_record(ctx)
            if record is not None and isinstance(param, click.Option):
                name = max(param.opts, key=len).removeprefix("--")
                heading = getattr(param, "heading", None) or _HEADING.get(name, _OTHERS)
                records[heading].append(record)
        if sum(map(len, records.values())) <= MAX_UNGROUPED:
            super().format_options(ctx, formatter)
            return
        for heading, rows in records.items():
            if rows:
                with formatter.section(self._title(heading)):
                    formatter.write_dl(rows)


def command(name: str | None = None, **attributes: Any) -> Callable[[Callable[..., Any]], Command]:
    """Return the decorator `click.command` for a `Command`; ``needs`` is one of its attributes."""
    return click.command(name, cls=Command, **attributes)


def defer(
    ctx: click.Context, call: Callable[[click.Context], None], *, first: bool = False
) -> None:
    """Call a function when all options of a command are read, and none is missing.

    Parameters
    ----------
    ctx
        The context of the command.
    call
        A function of that context, such as one that checks options against each other.
    first
        Whether it is called before those that are there already.
    """
    calls = ctx.meta.setdefault(_DEFERRED, [])
    calls.insert(0 if first else len(calls), call)


def note_input(ctx: click.Context | None, param: click.Parameter | None, path: Path) -> None:
    """Note in the context that an option or argument names a file that is read.

    Parameters
    ----------
    ctx, param
        The command's context and the option or argument; nothing is noted if one is None.
    path
        The file, which no option of the command may write over.
    """
    if ctx is not None and param is not None:
        ctx.meta.setdefault(_READ, []).append((param, path))


def note_output(ctx: click.Context | None, param: click.Parameter | None, path: Path) -> None:
    """Note in the context that an option names a file that is written.

    Parameters
    ----------
    ctx, param
        The command's context and the option; nothing is noted if one is None.
    path
        The file, which is none of those that the command reads.
    """
    if ctx is not None and param is not None:
        ctx.meta.setdefault(_WRITTEN, []).append((param, path))


_ARGUMENT = re.compile(r"(?P<argument>[a-z_]+)(?:\[['\"](?P<key>\w+)['\"]\])?: ")
"""Beginning of an error of the library that is of an argument, or of one value in it."""

_ALIASES = {
    "scatter": ("sd",),
    "settings": ("parameters",),
    "file": ("columns",),
    "instrument": ("errors",),
}
"""Arguments of the library that an option becomes, by the name of its parameter."""

_WITHOUT_OPTION = ("variables", "release", "model", "aim", "stop")
"""Arguments of the library that are no single option, so that the error leaves them out."""


def _library_arguments(param: click.Parameter) -> tuple[str, ...]:
    """Return the arguments of the library that a parameter becomes."""
    if not isinstance(param, click.Option):
        return ()
    name = param.name or ""
    return (name, _name(param).removeprefix("--").replace("-", "_"), *_ALIASES.get(name, ()))


_UNSET = getattr(click.core, "UNSET", None)
"""Value that newer releases of click have for an argument that is not given."""


def _name(param: click.Parameter) -> str:
    """Return an option or an argument as a user writes it."""
    if isinstance(param, click.Argument):
        return param.human_readable_name.upper()
    return max(param.opts, key=len)
