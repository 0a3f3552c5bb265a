"""Checks of the names of a scene and of its parameters, bodies and ends.

Words of C, Python and JavaScript are names like any other: generated code puts something before
them, and formulas are not read by Python. Refused is what derivation, results or questions use.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping

from hoopgen.core.jacobian import BY_VARIABLE, END_ARRAYS, EVENT_ARRAYS, OF_EVENT
from hoopgen.core.units import column_name
from hoopgen.core.variables import STATE
from hoopgen.generated.numpy import hoop
from hoopgen.text.shorten import brief

from .errors import wrong
from .formulas import POSITION
from .pieces import Body, Cone, Revolution

PUBLIC = re.compile(r"[a-z][a-z0-9_]*", re.ASCII)
"""Pattern of public names; derive/ demands the same, but importing it would import SymPy."""

MAX_NAME_LENGTH = 100
"""Longest name, in letters: files are called like the scene, and file systems allow 255 in all."""

_FACE = re.compile(r"(?P<body>.+)_(outside|inside|above|below|edge|tip)_[0-9]+", re.ASCII)
"""Pattern of the names of faces of surfaces of revolution."""

_EVERY_RESULT = (*hoop.RESULTS, *hoop.ABSENT_RESULTS)

_RESULTS = (
    *(result.name for result in _EVERY_RESULT),
    "shot",
    *(name for one in _EVERY_RESULT for name in (one.dimension, one.unit_coordinate) if name),
)
"""Names of results and of their dimensions, beside which a table has the parameters."""

RESERVED: Mapping[str, Mapping[str, str]] = {
    "": dict.fromkeys(
        (
            "p",
            "environment",
            "exact",
            "fenv",
            "float",
            "lanes",
            "math",
            "stdatomic",
            "stddef",
            "stdint",
            "string",
            "xmmintrin",
        ),
        "names a C header",
    ),
    "parameter": {
        **dict.fromkeys(
            (*END_ARRAYS, *EVENT_ARRAYS, *BY_VARIABLE, *OF_EVENT),
            "is in datasets with derivatives",
        ),
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
"""Reserved names and their owners, by the kind of thing that is named; "" stands for the scene."""


def check_name(scene: object, kind: str, given: object) -> None:
    """Raise an error if a name is malformed, too long or taken.

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
    """Raise an error as `check_name` does, or if two things of one kind share a name.

    Parameters
    ----------
    scene
        The scene's name.
    kind
        The kind of thing that has the names.
    names
        The names.

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
    """Raise an error if names could collide with names that are derived from others.

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
            ("body", f"vary_{body}", f"formulas of the body {body}"),
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


def check_faces(scene: str, bodies: Iterable[Body]) -> None:
    """Raise an error if a body is named like a face of another one.

    These are the apex of a cone and the faces of a surface of revolution.

    Parameters
    ----------
    scene
        The scene's name.
    bodies
        Its bodies.

    Raises
    ------
    SceneError
        Naming both.
    """
    given = list(bodies)
    apexes = {f"{body.name}_apex": body.name for body in given if isinstance(body, Cone)}
    revolved = {body.name for body in given if isinstance(body, Revolution)}
    for body in given:
        if body.name in apexes:
            said = f"{body.name} is what the apex of the cone {apexes[body.name]} is called"
            raise wrong(scene, f"body {body.name}", "name", f"{said}; expected another name")
        found = _FACE.fullmatch(body.name)
        if found and found["body"] in revolved:
            said = f"{body.name} is what a face of the revolution {found['body']} is called"
            raise wrong(scene, f"body {body.name}", "name", f"{said}; expected another name")
