"""Names of columns that are nearly those of variables: ``azimut_deg``, ``back_spin_hz``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from difflib import get_close_matches

from hoopgen.units import Kind, unit_size

from .measures import MEASURES

__all__ = ["near_variable"]

_SHORTEST = 4
"""Letters of a name that may be misspelled: shorter ones are too near to other words."""

_ALIKE = 0.85
"""Of difflib: a letter too many, too few, or two that changed places. A letter in another's place
is not enough in words as short as ours, or weight would be height."""

_BEFORE = ("release_", "launch_", "initial_")
"""Words before a variable that change nothing."""

_MEANT = {"angle": "elevation", "velocity": "speed"}
"""What those words make of others: a release angle is no place around the ring."""


def near_variable(column: str, kinds: Mapping[str, Kind]) -> str:
    """Return the variable that a column is likely meant for, or nothing.

    The whole name has to be near, but for a unit at its end; what is measured is no variable.

    Parameters
    ----------
    column
        Its name, which says no variable.
    kinds
        Variables, and what they measure.
    """
    plain = re.sub(r"[^\w%°]+", "_", column.strip().lower()).strip("_")
    if any(f"{plain}_".startswith(f"{measure}_") for measure in MEASURES):
        return ""
    squeezed = {name.replace("_", ""): name for name in kinds}
    for stem in _stems(plain, set(kinds.values())):
        for before in _BEFORE:
            rest = stem.removeprefix(before)
            if rest != stem and _MEANT.get(rest, rest) in kinds:
                return _MEANT.get(rest, rest)
        letters = stem.replace("_", "")
        if letters in squeezed:
            return squeezed[letters]
        if len(letters) >= _SHORTEST:
            long = [name for name in squeezed if len(name) > _SHORTEST]
            close = get_close_matches(letters, long, n=1, cutoff=_ALIKE)
            if close:
                return squeezed[close[0]]
    return ""


def _stems(plain: str, kinds: set[Kind]) -> Iterator[str]:
    """Give a name, and what is left of it without a unit at its end."""
    yield plain
    parts = plain.split("_")
    for cut in range(1, len(parts)):
        unit = "/".join(parts[cut:]).replace("/per/", "/")
        if any(unit_size(unit, kind) is not None for kind in kinds):
            yield "_".join(parts[:cut])
