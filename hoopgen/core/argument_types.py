"""Checks that arguments are of the type that they should be."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from enum import IntEnum
from functools import wraps
from os import PathLike
from typing import Any, ParamSpec, TypeGuard, TypeVar

import numpy as np

from hoopgen.text.shorten import brief, join_alternatives

Taken = ParamSpec("Taken")
Returned = TypeVar("Returned")


def check_mapping(name: str, value: object) -> None:
    """Raise an error if what should give values by name is no mapping, nor a table of columns.

    Parameters
    ----------
    name
        The argument, for the error message.
    value
        The caller's value.

    Raises
    ------
    TypeError
        The message begins with `name`.
    """
    if not hasattr(value, "items"):
        text = name == "parameters" and isinstance(value, str)
        hint = "; presets are mappings, such as hoopgen.NBA" if text else ""
        raise TypeError(f"{name}: expected a mapping of names to values, got {brief(value)}{hint}")


def check_flag(name: str, value: object) -> bool:
    """Return a truth value; text such as "no", which is true for Python, is refused.

    Parameters
    ----------
    name, value
        As for `check_mapping`.

    Raises
    ------
    TypeError
        The message begins with `name`.
    """
    if not isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: expected True or False, got {brief(value)}")
    return bool(value)


def _is_list(value: object) -> TypeGuard[Iterable[object]]:
    return isinstance(value, Iterable) and not isinstance(value, str | bytes)


def is_names(value: object) -> bool:
    """Return whether a value is a list of names, or a mapping of them; one text is none."""
    if isinstance(value, Iterator):  # which can be read once
        return True
    return _is_list(value) and all(isinstance(each, str) for each in value)


_Rule = tuple[str, Callable[[object], bool]]


def _is_width(value: object) -> bool:
    return type(value) is not bool and isinstance(value, int | float) and 2.0 <= value <= 100.0


_TEXT: _Rule = ("text", lambda value: isinstance(value, str))
_FLIGHT: _Rule = (
    "a trajectory of the shots of simulate",
    lambda value: hasattr(value, "events") and hasattr(value, "duration"),
)
_FUNCTION: _Rule = ("a function", callable)
_RULES: dict[str, _Rule] = {
    "None": ("None", lambda value: value is None),
    "bool": ("True or False", lambda value: isinstance(value, bool | np.bool_)),
    "PathLike": ("the path of a file", lambda value: isinstance(value, PathLike)),
    "Path": ("the path of a file", lambda value: isinstance(value, PathLike)),
    "Callable": _FUNCTION,
    "Progress": _FUNCTION,
    "IntEnum": ("an outcome of the scene", lambda value: isinstance(value, IntEnum)),
    "Inches": ("a number of inches from 2 to 100", _is_width),
    "Mapping": ("a mapping of names to values", lambda value: hasattr(value, "items")),
    "Iterable": ("a list", _is_list),
    "Iterable[str]": ("names in a list or a mapping", is_names),
    "Shots": (
        "the Shots of simulate",
        lambda value: hasattr(value, "scene") and hasattr(value, "releases"),
    ),
    **dict.fromkeys(("FlightPath", "Trajectory"), _FLIGHT),
    **dict.fromkeys(("str", "Arc", "BackendName", "By", "System"), _TEXT),
}
"""By the name of a type its description and the test of a value. Names of choices are only tested
to be text, since the functions list them."""

_RECORDS = {
    "Assessment": "what assess returns",
    "CalibratedScene": "what calibrate returns",
    "Coaching": "what coach returns",
    "Counterfactual": "what counterfactual returns",
    "BoxProof": "what certify_box returns",
    "Dataset": "an xarray Dataset",
    "Figure": "a Figure of matplotlib",
}
"""The source of objects by the name of their class: the classes themselves need the extras."""


def _rule(annotation: str) -> _Rule | None:
    """Return the rule of an annotation; None if it names types that functions check themselves."""
    plain = annotation.replace("Sequence", "Iterable").replace("xr.", "").replace("os.", "")
    plain = re.sub(r"\[(?!str\])(?:[^\[\]]|\[[^\[\]]*\])*\]", "", plain)
    names = plain.replace("PathLike[str]", "PathLike").split(" | ")
    path = not {"PathLike", "Path"}.isdisjoint(names)
    found: list[_Rule] = []
    for name in names:
        if name in _RULES:
            said, test = _RULES[name]
            found.append(("" if path and name == "str" else said, test))
        elif name in _RECORDS:
            found.append((_RECORDS[name], _is_named(name)))
        else:
            return None
    said = join_alternatives(said for said, _ in found if said)
    return said, lambda value: any(test(value) for _, test in found)


def _is_named(record: str) -> Callable[[object], bool]:
    return lambda value: any(each.__name__ == record for each in type(value).__mro__)


def check_arguments(function: Callable[Taken, Returned]) -> Callable[Taken, Returned]:
    """Make a function check its arguments that should be flags, text, paths, functions or lists.

    Their annotations say what each may be; numbers and arrays the function checks itself.

    Parameters
    ----------
    function
        A function of a module with ``from __future__ import annotations``, so that its annotations
        are text and nothing is imported for them.

    Returns
    -------
    Callable
        The same function; it raises a TypeError that begins with the argument's name.
    """
    annotations = function.__annotations__.items()
    rules = {name: rule for name, given in annotations if (rule := _rule(given)) is not None}
    rules.pop("return", None)
    code = function.__code__
    order = code.co_varnames[: code.co_argcount]

    @wraps(function)
    def checked(*args: Taken.args, **kwargs: Taken.kwargs) -> Returned:
        given: dict[str, Any] = {**dict(zip(order, args, strict=False)), **kwargs}
        for name, (expected, test) in rules.items():
            if name in given and not test(given[name]):
                raise TypeError(f"{name}: expected {expected}, got {brief(given[name])}")
        return function(*args, **kwargs)

    return checked
