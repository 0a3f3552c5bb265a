"""Names of a scene and of its parameters, bodies and ends: which are refused when it is made.

Words of C, Python and JavaScript are names like any other: generated code puts something before
them, and formulas are not read by Python. Refused is what derivation, results or questions use.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping

from hoopgen.brief import brief
from hoopgen.units import column_name
from hoopgen.variables import STATE

from .formulas import POSITION
from .inputs import wrong

__all__ = ["MAX_NAME_LENGTH", "PUBLIC", "RESERVED", "check_apart", "check_name", "check_names"]

PUBLIC = re.compile(r"[a-z][a-z0-9_]*", re.ASCII)
"""What names match: derive/ demands the same of them, but would import SymPy to say so."""

MAX_NAME_LENGTH = 100
"""Letters of a name: files are called like the scene, and file systems allow 255 in all."""

_RESULTS = (
    *("outcome", "contacts", "counts", "first", "time", "state", "rolls", "slip_left", "uncertain"),
    *("time_error", "state_error", "grip_lost", "shot", "surface", "component", "part", "unit"),
)
"""Names of results and of their dimensions, beside which a table has the parameters."""

RESERVED: Mapping[str, Mapping[str, str]] = {
    "": dict.fromkeys(("p", "float", "math", "stddef", "stdint", "string"), "names a C header"),
    "parameter": {
        **dict.fromkeys(_RESULTS, "names a result"),
        **dict.fromkeys(STATE, "names a component of a shot's state"),
        **dict.fromkeys(POSITION, "is a coordinate in formulas"),
        "sqrt": "is a function in formulas",
    },
    "body": {
        "end": "names the end of a shot in lists of contacts",
        "none": "says in results that nothing was touched",
        "release": "names the release in lists of contacts",
        **dict.fromkeys(("own", "error"), "begins the name of a formula of the event loop"),
    },
    "end": {
        **dict.fromkeys(
            ("capped", "short", "invalid", "lodged", "endless"),
            "is the outcome of shots that reach no end",
        ),
        "any": "says in questions that every end counts",
    },
}
"""By what is named, "" for the scene: names that are taken, and by what."""


def check_name(scene: object, kind: str, given: object) -> None:
    """Refuse a name that is none, is too long, or is taken.

    Parameters
    ----------
    scene
        Name of the scene, for the message.
    kind
        What is named: "parameter", "body" or "end"; "" for the scene itself.
    given
        The name.

    Raises
    ------
    SceneError
        Naming what is named, and what is expected.
    """
    owner = f"{kind} {brief(given)}" if kind else ""
    if not isinstance(given, str) or not PUBLIC.fullmatch(given):
        said = "expected a small letter, then small letters, digits and _"
        raise wrong(str(scene), owner, "name", said)
    if len(given) > MAX_NAME_LENGTH:
        said = f"expected at most {MAX_NAME_LENGTH} letters, got {len(given)}"
        raise wrong(str(scene), owner, "name", said)
    taken = RESERVED[kind]
    if given in taken:
        said = f"{given} {taken[given]}; expected another name"
        raise wrong(str(scene), f"{kind} {given}" if kind else "", "name", said)


def check_names(scene: str, kind: str, names: Iterable[str]) -> None:
    """Refuse names as `check_name` does, and a name that two things of one kind have.

    Raises
    ------
    SceneError
        Naming what is named, and what is expected.
    """
    for own, count in Counter(list(names)).items():
        check_name(scene, kind, own)
        if count > 1:
            raise wrong(scene, f"{kind} {own}", "name", f"{count} have this name")


def check_apart(
    scene: str, parameters: Mapping[str, str], bodies: Iterable[str], ends: Iterable[str]
) -> None:
    """Refuse two names of which one begins or ends like what is made of the other.

    Parameters
    ----------
    parameters
        Names, and the unit of each.
    bodies, ends
        Names.

    Raises
    ------
    SceneError
        Naming both.
    """
    there = set(bodies)
    made: list[tuple[str, str, str]] = []
    for body in there:
        made += [
            ("body", f"{body}_carry", f"formulas of the body {body}"),
            ("body", f"carry_{body}", f"formulas of the body {body}"),
            ("parameter", f"{body}_contacts", f"the column of contacts with the body {body}"),
        ]
    made += [("body", f"{end}_end", f"the plane of the end {end}") for end in ends]
    for name, unit in parameters.items():
        column = column_name(name, unit)
        if column != name:
            made.append(("parameter", column, f"the column of {name} in {unit}"))
    for kind, name, what in made:
        if name in (there if kind == "body" else parameters):
            said = f"{name} is what {what} would be called; expected another name"
            raise wrong(scene, f"{kind} {name}", "name", said)
