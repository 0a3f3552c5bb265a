"""The colours of the hoop, and of other scenes' bodies, in pictures and on pages."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

# Okabe and Ito's palette: told apart by readers with any colour vision, and in grey.
COLOURS: Mapping[str, str] = MappingProxyType(
    {
        "path": "#0072B2",
        "ball": "#E69F00",
        "ball-edge": "#8F5F00",
        "plain-ball": "#9AA3AB",
        "plain-ball-edge": "#454D54",
        "ring": "#D55E00",
        "backboard": "#333333",
        "bridge": "#00795C",
        "end": "#8C4A76",
        "release": "#0072B2",
        "faint": "#8A8A8A",
        "paper": "#FFFFFF",
    }
)

# No two of these, and none and the backboard or paper, are nearer than 10 (CIEDE2000) with any
# colour vision; found by a search, and measured by tests/test_colours.py.
BODIES = (
    "#00795C",
    "#D55E00",
    "#1B4E87",
    "#672C22",
    "#6E6783",
    "#665918",
    "#B46879",
    "#564A61",
)
"""Of other scenes, in their bodies' order, and again from the first; white is legible on them."""

_KNOWN = ("ring", "backboard")
"""What is drawn as the hoop's."""


def colours(names: Iterable[str]) -> dict[str, str]:
    """Return a colour for each body; those of one family, such as wall_1 and wall_2, share it."""
    own = list(names)
    families = list(dict.fromkeys(map(_family, own)))
    others = [family for family in families if family not in _KNOWN]
    taken = {COLOURS[family] for family in families if family in _KNOWN}
    free = [colour for colour in BODIES if colour not in taken]
    found = {family: free[k % len(free)] for k, family in enumerate(others)}
    found |= {family: COLOURS[family] for family in families if family in _KNOWN}
    return {name: found[_family(name)] for name in own}


_FACES = {"backboard": "#7A8794"}
"""Of what is drawn in another colour than its marks and badges have: glass is pale."""


def faces(names: Iterable[str]) -> dict[str, str]:
    """Return the colour in which each body itself is drawn; all else of it is in `colours`."""
    return {name: _FACES.get(_family(name), colour) for name, colour in colours(names).items()}


def _family(name: str) -> str:
    stem, _, last = name.rpartition("_")
    return stem if stem and (last.isdigit() or len(last) == 1) else name


# The first two are those of made and missed on pages. As in `hoopgen.plots.style`, no two of these
# and `NEITHER`, and none and paper, are nearer than 10 (CIEDE2000) with any colour vision; all that
# a path may be drawn in have a contrast with paper of 3 at least (WCAG 2.2, 1.4.11).
_ENDS = ("#0072B2", "#C27C00", "#47044E", "#49A56A", "#7B1D03", "#CC026A")

NEITHER: Mapping[str, str] = MappingProxyType(
    {
        "capped": "#000000",
        "short": "#6E727A",
        "invalid": "#C1C1C1",
        "lodged": "#595959",
        "endless": "#363636",
    }
)
"""Of a shot that has no end, by outcome, in any scene; an invalid one has no path."""


def ended(outcomes: Iterable[str], ends: int) -> dict[str, str]:
    """Return a colour for each outcome of a scene, of which so many, the first, are its ends."""
    names = list(outcomes)
    found = {name: _ENDS[k % len(_ENDS)] for k, name in enumerate(names[:ends])}
    return found | {name: NEITHER[name.lower()] for name in names[ends:]}
