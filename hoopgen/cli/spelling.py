"""Errors of the library in the spelling of a command: options in place of arguments of Python."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

import click

from hoopgen.hoop.variables import ALTERNATIVE_VARIABLES, ARGUMENTS

_VARIABLES = re.compile(r"(?P<file>.*: )?(?:variables|aim): (?P<said>.*)", re.DOTALL)
"""An error about variables of a release, or about what a flight is aimed at."""

_NAMES = {*ARGUMENTS, *ALTERNATIVE_VARIABLES, "depth", "target", "moving", "position"}
"""Names in such an error that are options of some commands."""

_MISSING = re.compile(r"missing (?P<names>\w+(?:(?:, | and )\w+)*)")

_PYTHON: Sequence[tuple[str, str, str]] = (
    ("", r"\((?:\w+=\w*|\w+\.\w+), (--[\w-]+)\)", r"(\1)"),
    ("", r" \([^()]*\brad\)", ""),
    ("columns", r"(--column \S+), columns=\{[^{}]*\}", r"\1"),
    ("", r"\bthe same call goes on\b", "the same command goes on"),
    ("scatter", r"\bsd, --scatter", "--scatter"),
    ("instrument", r"speed=0\.03, in m/s", "speed=3cm/s"),
    ("vary", r"give \{name: \(low, high\)\}", "give NAME=LOW:HIGH"),
    ("vary", r"got \((\S+), (\S+)\)$", r"got \1:\2"),
    ("over", r"expected \(low, high\)", "expected NAME=LOW:HIGH"),
    ("over", r" where over\['(\w+)'\] has no \(low, high\)", r" where --over \1 has no LOW:HIGH"),
    ("own", r"list it in own \((--own .*?)\)", r"give \1"),
    ("own", r"\bin own\b", "with --own"),
    ("", r"^\w+: (its question is a hoop's, and the scene .* has none); .*", r"--scene: \1"),
)
"""Texts for users of Python, and those in their place where a command has that option."""

_LACKED: Sequence[tuple[str, str]] = (
    ("override", r", or override what the file says \(.*?--override\)"),
    ("own", r" \(--own [^()]*\)"),
)
"""Recommendations that are left out where a command has no such option."""


def spell_options(text: str, options: Mapping[str, str], command: str) -> str:
    """Return an error of the library as a user of the command can act on it.

    Parameters
    ----------
    text
        The error.
    options
        The options of the command as they are written, by the names of their parameters.
    command
        The command, ``hoopgen estimate``.

    Returns
    -------
    str
        The error, which names no argument of Python where the command has an option.
    """
    for option, pattern in _LACKED:
        if option not in options:
            text = re.sub(pattern, "", text)
    for option, pattern, words in _PYTHON:
        if not option or option in options:
            text = re.sub(pattern, words, text)
    text = text.replace("hoopgen.plots needs", "a picture needs")
    text = re.sub(r"^hoopgen\.\w+ needs", f"{command} needs", text)
    match = _VARIABLES.match(text)
    if match is None or options.keys().isdisjoint((*_NAMES, "release")):
        return text
    file, said = match["file"] or "", match["said"]
    if missing := _MISSING.match(said):
        names = re.split(", | and ", missing["names"])
        said = f"{missing[0]}{_wanted(names, options)}{said[missing.end() :]}"
    elif not file and not said.startswith("unknown"):
        listed = "|".join(_NAMES & options.keys())
        said = re.sub(rf"(?<![\w-])({listed})(?![\w-])", lambda one: options[one[0]], said)
    return f"{file}{said}"


def _wanted(names: Sequence[str], options: Mapping[str, str]) -> str:
    """Return the options that give missing variables; empty where the command has none."""
    if set(names) <= set(options):
        wanted = [options[name] for name in names]
    elif "release" in options:
        wanted = [f"{options['release']} {name}=..." for name in names]
    else:
        return ""
    place = " (or --place)" if "distance" in names and "place" in options else ""
    return f"; give {' and '.join(wanted)}{place}"


def options_of(command: click.Command) -> dict[str, str]:
    """Return the options of a command as they are written, by the names of their parameters."""
    found = (one for one in command.params if isinstance(one, click.Option) and one.name)
    return {str(one.name): max(one.opts, key=len) for one in found}
