"""Names of columns that are nearly those of variables: ``azimut_deg``, ``back_spin_hz``."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Mapping
from difflib import get_close_matches

from hoopgen.core.units import Kind, unit_size
from hoopgen.study.measures.measures import MEASURES

_SHORTEST = 4
"""Fewest letters of a name that may be misspelled: shorter ones are too near to other words."""

_ALIKE = 0.85
"""Least similarity by difflib: a letter too many, too few, or two that changed places. A letter in
another's place is not enough in words as short as ours, or weight would be height."""

_BEFORE = ("release_", "launch_", "initial_")
"""Words before a variable that change nothing."""

_MEANT = {"angle": "elevation", "velocity": "speed"}
"""Meaning of others after those words: a release angle is no place around the ring."""

_LIKELY = tuple(
    (variable, tuple(words.split()))
    for variable, several in {
        "speed": "speed, velocity",
        "elevation": "elevation, release angle, launch angle, vertical angle",
        "azimuth": "azimuth, side angle, lateral angle, horizontal angle, direction",
        "backspin": "backspin, spin, spin rate",
        "sidespin": "sidespin, side spin, side spin rate",
        "height": "height",
        "distance": "distance, range",
        "angle": "court angle, floor angle, shot angle, location angle",
        "entry": "entry, entry angle",
    }.items()
    for words in several.split(", ")
)
"""Words of columns that people have for variables; the last of them is the column's last word."""


def near_variable(column: str, kinds: Mapping[str, Kind]) -> str:
    """Return the variable that a column is likely meant for, or nothing.

    The whole name has to be near, but for a unit at its end; what is measured is no variable.

    Parameters
    ----------
    column
        The name of the column.
    kinds
        The kind of each variable, by name.
    """
    plain = _plain(column)
    if any(f"{plain}_".startswith(f"{measure}_") for measure in MEASURES):
        return ""
    squeezed = {name.replace("_", ""): name for name in kinds}
    long = [name for name in squeezed if len(name) > _SHORTEST]
    for stem in _stems(column, set(kinds.values())):
        for before in _BEFORE:
            rest = stem.removeprefix(before)
            if rest != stem and _MEANT.get(rest, rest) in kinds:
                return _MEANT.get(rest, rest)
        letters = stem.replace("_", "")
        if letters in squeezed:
            return squeezed[letters]
        if len(letters) >= _SHORTEST:
            close = get_close_matches(letters, long, n=1, cutoff=_ALIKE)
            if close:
                return squeezed[close[0]]
    return ""


def likely_variable(column: str, kinds: Mapping[str, Kind], absent: Container[str]) -> str:
    """Return the variable that a column with a unit may be meant for, or nothing.

    That is less than `near_variable` asks for: ``side_angle_deg`` may be the azimuth.

    Parameters
    ----------
    column
        The name of the column, with a unit at its end.
    kinds
        The kind of quantity of each variable of the scene.
    absent
        Variables that no column is read as.

    Returns
    -------
    str
        The name of the variable; empty if none is meant.
    """
    if any(f"{_plain(column)}_".startswith(f"{measure}_") for measure in MEASURES):
        return ""
    found: list[tuple[int, str]] = []
    for stem, unit in stems(column):
        words = stem.split("_")
        found += [
            (len(needed), variable)
            for variable, needed in _LIKELY
            if words[-1] == needed[-1]
            and set(needed) <= set(words)
            and variable in kinds
            and unit_size(unit, kinds[variable]) is not None
        ]
    _, likely = max(found, default=(0, ""))
    return likely if likely in absent else ""


def stems(column: str) -> Iterator[tuple[str, str]]:
    """Give a column's name in parts: what stands before, and what may be a unit, "" for none."""
    plain = _plain(column)
    yield plain, ""
    parts = plain.split("_")
    for cut in range(1, len(parts)):
        yield "_".join(parts[:cut]), "/".join(parts[cut:]).replace("/per/", "/")


def _plain(column: str) -> str:
    return re.sub(r"[^\w%°]+", "_", column.strip().lower()).strip("_")


def _stems(column: str, kinds: set[Kind]) -> Iterator[str]:
    """Give a name, and what is left of it without a unit at its end."""
    for stem, unit in stems(column):
        if not unit or any(unit_size(unit, kind) is not None for kind in kinds):
            yield stem
