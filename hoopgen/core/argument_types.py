"""Checks that arguments are of the type that they should be."""

from __future__ import annotations

import numpy as np

from hoopgen.text.shorten import brief

__all__ = ["check_flag", "check_mapping"]


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
        raise TypeError(f"{name}: expected a mapping of names to values, got {brief(value)}")


def check_flag(name: str, value: object) -> bool:
    """Return a truth value; text such as "no", which is true for Python, is refused.

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
    if not isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: expected True or False, got {brief(value)}")
    return bool(value)
