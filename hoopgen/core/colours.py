"""Colours of the hoop and of other scenes' bodies, in pictures and on pages."""

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
# colour vision; found by a search, and measured by tests/core/test_colours.py.
BODY_COLOURS = (
    "#00795C",
    "#D55E00",
    "#1B4E87",
    "#672C22",
    "#6E6783",
    "#665918",
    "#B46879",
    "#564A61",
)
"""Colours of the bodies of other scenes, in order and again from the first. White text is legible
on each of them."""

_HOOP_BODIES = ("ring", "backboard")
"""Colours of the hoop's parts."""


# The same hues, each kind of shot at a lightness of its own: made ones dark, missed ones light. No
# two are nearer than 10 (CIEDE2000) to readers of any colour vision; so it is with the colours of
# lines in `hoopgen.plots.style`. Found by a search, and measured by tests/core/test_colours.py.
MADE: Mapping[str, str] = MappingProxyType(
    {
        "swish": "#115789",
        "rim": "#AC5008",
        "bank": "#239373",
        "bank_rim": "#622757",
        "rim_board": "#D08E20",
    }
)
"""Colours of made shots, by kind."""

MISSED: Mapping[str, str] = MappingProxyType(
    {
        "rim": "#F6CEBC",
        "bank": "#7BC886",
        "bank_rim": "#C5A1D7",
        "rim_board": "#FFEE7C",
        "airball": "#C9E2FF",
    }
)
"""Colours of missed shots, by kind; an airball is pale blue as a swish is: both touch nothing."""


def body_colours(names: Iterable[str]) -> dict[str, str]:
    """Return a colour for each body; a family such as wall_1 and wall_2 shares one."""
    own = list(names)
    families = list(dict.fromkeys(map(_family, own)))
    others = [family for family in families if family not in _HOOP_BODIES]
    taken = {COLOURS[family] for family in families if family in _HOOP_BODIES}
    free = [colour for colour in BODY_COLOURS if colour not in taken]
    found = {family: free[k % len(free)] for k, family in enumerate(others)}
    found |= {family: COLOURS[family] for family in families if family in _HOOP_BODIES}
    return {name: found[_family(name)] for name in own}


_FACE_COLOURS = {"backboard": "#7A8794"}
"""Colours of bodies that are drawn in another colour than their marks and badges: glass is pale."""


def face_colours(names: Iterable[str]) -> dict[str, str]:
    """Return the colour of each body's faces; its marks are in `body_colours`."""
    return {
        name: _FACE_COLOURS.get(_family(name), colour)
        for name, colour in body_colours(names).items()
    }


def _family(name: str) -> str:
    stem, _, last = name.rpartition("_")
    return stem if stem and (last.isdigit() or len(last) == 1) else name


# The first two are the colours of made and missed on pages. As in `hoopgen.plots.style`, any two of
# these, `OTHER_OUTCOME_COLOURS` and paper are at least 10 apart (CIEDE2000) with any colour vision.
# Every colour of a path has a contrast with paper of at least 3 (WCAG 2.2, 1.4.11).
_END_COLOURS = ("#0072B2", "#C27C00", "#47044E", "#49A56A", "#7B1D03", "#CC026A")

OTHER_OUTCOME_COLOURS: Mapping[str, str] = MappingProxyType(
    {
        "capped": "#000000",
        "short": "#6E727A",
        "invalid": "#C1C1C1",
        "lodged": "#595959",
        "endless": "#363636",
    }
)
"""Colours of shots without an end, by outcome, in any scene; an invalid shot has no path."""


def outcome_colours(outcomes: Iterable[str], ends: int) -> dict[str, str]:
    """Return a colour for each outcome of a scene, whose first outcomes are its ends.

    Parameters
    ----------
    outcomes
        Names of the outcomes, the ends first.
    ends
        The number of ends.
    """
    names = list(outcomes)
    found = {name: _END_COLOURS[k % len(_END_COLOURS)] for k, name in enumerate(names[:ends])}
    return found | {name: OTHER_OUTCOME_COLOURS[name.lower()] for name in names[ends:]}
