"""Limits on the size of a scene, since a few lines of a file may take hours to derive."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, fields
from typing import Any

from hoopgen.core.validation import check_count
from hoopgen.text.shorten import brief, join_names


@dataclass(frozen=True)
class Limits:
    """The largest scene that is read; within the defaults compiling takes at most minutes.

    Attributes
    ----------
    file_size
        Bytes of a scene file or a study file.
    parameters
        Parameters of a scene.
    bodies, ends
        Bodies and ends of a scene.
    bounds
        Formulas in `within`, of all bodies and ends together.
    profile_points
        Points of a profile.
    sizes
        Numbers that the kernels get for each shot: the parameters, and sizes computed from them.
    formula_length
        Characters of a formula.
    formula_depth
        Operations of a formula within one another.
    formula_degree
        Factors in a product of a formula, all powers multiplied out.
    polynomial_terms
        Terms of a bound or a condition, multiplied out.

    Raises
    ------
    ValueError
        If one is not a whole number from 1.
    """

    file_size: int = 1_000_000
    parameters: int = 200
    bodies: int = 200
    ends: int = 50
    bounds: int = 100
    profile_points: int = 50
    sizes: int = 2_000
    formula_length: int = 300
    formula_depth: int = 30
    formula_degree: int = 8
    polynomial_terms: int = 200

    def __post_init__(self) -> None:
        for each in fields(self):
            check_count(f"limits.{each.name}", getattr(self, each.name))

    def excess(self, name: str, count: int, *, exact: bool = True) -> str:
        """Return why a count exceeds its limit, "" if it does not.

        Parameters
        ----------
        name
            Of the limit.
        count
            How much of it there is.
        exact
            False: there may be more than `count`.
        """
        most = getattr(self, name)
        if count <= most:
            return ""
        got = f"{count:,}" if exact else f"{count:,} or more"
        return (
            f"expected at most {most:,} {_NOUNS[name]}, got {got}; "
            f"raise the limit with limits={{'{name}': ...}}, or --limit {name}=... on the command "
            "line"
        )


_NOUNS = {
    "file_size": "bytes",
    "formula_length": "characters",
    "formula_depth": "operations within one another",
    "formula_degree": "factors in a product, powers multiplied out",
    "polynomial_terms": "terms, multiplied out",
    "sizes": "parameters and sizes computed from them",
    "profile_points": "points of a profile",
    "bounds": "formulas in `within`, of all bodies and ends together",
} | {name: name for name in ("parameters", "bodies", "ends")}

NAMES = tuple(each.name for each in fields(Limits))
"""The limited quantity."""

DEFAULT_LIMITS = Limits()

_CURRENT: ContextVar[Limits] = ContextVar(
    "limits of the scene that is read", default=DEFAULT_LIMITS
)


def current() -> Limits:
    """Return the current limits."""
    return _CURRENT.get()


@contextmanager
def use_limits(limits: Limits) -> Iterator[None]:
    """Use these limits within a context."""
    token = _CURRENT.set(limits)
    try:
        yield
    finally:
        _CURRENT.reset(token)


def check_limits(given: Any) -> Limits:
    """Return limits: the given ones, defaults with changes, or the current ones for None.

    Parameters
    ----------
    given
        `Limits`, a mapping of names to counts, or None.

    Raises
    ------
    TypeError
        If it is something else.
    ValueError
        If a name is unknown, or a count is not a whole number from 1.
    """
    if given is None:
        return current()
    if isinstance(given, Limits):
        return given
    if not isinstance(given, Mapping):
        raise TypeError(f"limits: expected Limits or a mapping, got {brief(given)}")
    strange = [name for name in given if name not in NAMES]
    if strange:
        raise ValueError(f"limits: unknown {join_names(strange)}. There are {join_names(NAMES)}")
    return Limits(**given)
