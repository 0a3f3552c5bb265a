"""Options of commands, made of the settings of questions."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING
from typing import Any

import click
from click.shell_completion import CompletionItem

from hoopgen.study.questions import values
from hoopgen.study.questions.settings import Setting, settings
from hoopgen.study.questions.values import Value

from .path_types import FOLDER, OUT
from .scene_option import given
from .types import ASSIGNMENT, AXIS, BOUNDS, COLUMN, MEMORY, SCENE, Choice, Parsed, once, quantity

Decorator = Callable[[Any], Any]

_NAMED: Mapping[Value, Any] = {
    values.AXES: AXIS,
    values.BOUNDS: BOUNDS,
    values.CHANGE: ASSIGNMENT,
    values.PLACES: AXIS,
}
"""Types of options that are repeated, each time for another name."""

_TYPES: Mapping[Value, Any] = {values.FOLDER: FOLDER, values.MEMORY: MEMORY, values.OUTPUT: OUT}

_WITH_DEFAULT = (values.Choice, values.Quantity, values.Share, values.Text, values.Whole)
"""Kinds of values whose defaults an option shows; of others the command has one."""


class _Success(Choice):
    """The shots that count; with ``--scene`` an end of that scene, known when it is compiled."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the kind of shots, or the end of the scene."""
        scene = None if ctx is None else ctx.meta.get(SCENE)
        own = scene is not None and not getattr(scene, "has_hoop", False)
        return value if own else super().convert(value, param, ctx)


class SettingOption(click.Option):
    """The option of a setting; a long help lists it under the heading."""

    def __init__(self, *arguments: Any, heading: str, **attributes: Any) -> None:
        super().__init__(*arguments, **attributes)
        self.heading = heading


def together(*options: Decorator) -> Decorator:
    """Return one decorator of options, in the order of the help."""

    def decorated(command: Any) -> Any:
        for option in reversed(options):
            command = option(command)
        return command

    return decorated


def question_options(
    question: Any, *others: Any, optional: Iterable[str] = (), **changes: Any
) -> Decorator:
    """Return the options of a question and of what computes it.

    Parameters
    ----------
    question
        The specification, such as `hoopgen.study.questions.specification.MapQuestion`.
    others
        Questions that the command answers, too, whose settings are optional.
    optional
        Settings of the question that the command does not need.
    changes
        Attributes of `click.option` by the name of the setting.
    """
    beside = [name for other in others for name, *_ in settings(other)]
    return setting_options(
        *(question, *others, *question.shared), optional=(*optional, *beside), **changes
    )


def setting_options(
    *specifications: Any, only: str = "", optional: Iterable[str] = (), **changes: Any
) -> Decorator:
    """Return the options of settings, of each name the first; or `only` one.

    Parameters
    ----------
    *specifications
        Specifications of questions, classes whose fields are settings.
    only
        The name of the only setting that is wanted; empty for all.
    optional
        Names of settings without a default that may be left out.
    **changes
        Defaults in place of those of the specification, by the name of the setting.

    Returns
    -------
    decorator
        It gives a command these options, in the order of the fields.
    """
    options: dict[str, Decorator] = {}
    for specification in specifications:
        for name, _, setting, default in settings(specification):
            if setting.option is not None and name not in options and only in ("", name):
                attributes = _attributes(name, setting, default)
                if default is MISSING and name not in optional:
                    attributes["required"] = True
                attributes |= changes.get(name, {})
                flag = f"--{setting.option or name}".replace("_", "-")
                options[name] = click.option(flag, name, **attributes)
    return together(*options.values())


def _attributes(name: str, setting: Setting, default: Any) -> dict[str, Any]:
    """Return the attributes of an option."""
    value = setting.value
    limits = ""
    if isinstance(value, values.Quantity) and value.high < math.inf:
        limits = f"{value.limits.capitalize()}."
    text = " ".join(filter(None, (setting.help, limits, setting.command)))
    attributes: dict[str, Any] = {"cls": SettingOption, "heading": setting.heading, "help": text}
    if isinstance(value, values.Flag):
        return attributes | {"is_flag": True}
    named = COLUMN if isinstance(value, values.Each) else _NAMED.get(value)
    if named is not None or isinstance(value, values.Listed):
        attributes |= {"multiple": True, "help": f"{text} May be repeated."}
    if named is not None:
        return attributes | {"type": named, "callback": once}
    if isinstance(value, values.Listed):
        value = value.of
    elif isinstance(value, _WITH_DEFAULT) and default is not MISSING:
        attributes |= {"default": default, "show_default": default not in (None, "")}
        if isinstance(value, values.Quantity) and default:
            attributes["default"] = f"{default!r}{value.unit}"  # as one may type it
    if isinstance(value, values.Names):
        attributes["shell_complete"] = _completion(value)
    if isinstance(value, values.Text | values.Names):
        return attributes | {"metavar": value.metavar}
    return attributes | {"type": _type(name, value)}


def _type(name: str, value: Value) -> Any:
    if isinstance(value, values.Choice):
        kind = _Success if isinstance(value, values.Success) else click.Choice
        return kind(list(value.allowed), case_sensitive=False)
    if isinstance(value, values.Quantity):
        return quantity(value.kind, name, value.low, value.high)
    return _TYPES.get(value) or Parsed(value.parse, value.metavar)


def _completion(value: values.Names) -> Callable[..., list[CompletionItem]]:
    """Return the function that completes a name for a shell."""

    def complete(_: click.Context, __: click.Parameter, incomplete: str) -> list[CompletionItem]:
        known = value.labels().items()
        return [CompletionItem(name, help=it) for name, it in known if name.startswith(incomplete)]

    return complete


def check_caught(measures: Iterable[str]) -> None:
    """Refuse a catching height where nothing is caught."""
    measured = any(name.startswith("rebound") for name in measures)
    if given("catching_height") and not measured:
        raise click.UsageError("--catching-height is of rebounds, --measure rebound_distance ...")
