"""Names that a scene gives: its own, and those of parameters, bodies, surfaces and laws.

They reach generated code, files and results as they are, and so are checked here, once. Where they
could meet a name of ours or of a language, generated code puts something before them.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

from .ends import OTHERS

if TYPE_CHECKING:
    from .scene import Scene

PUBLIC = re.compile(r"[a-z][a-z0-9_]*", re.ASCII)
"""What every public name matches as a whole."""

LAW = re.compile(r"(?:[a-z][a-z0-9_]*_)?impact", re.ASCII)
"""What the name of a law does: it is that of a kernel."""

LATEX = re.compile(r"[A-Za-z0-9_^'{}\\ ]*", re.ASCII)
"""What the LaTeX of a parameter matches as a whole: what ends no formula."""

END = "end"
"""What an end is called where bodies have their names."""

TAKEN = ("p", "float", "math", "stddef", "stdint", "string")
"""Names that no scene has: that before its parameters, and headers beside its own."""


def check(scene: Scene) -> None:
    """Refuse names that are not public names, or that two things of one kind have.

    Raises
    ------
    ValueError
        Naming the scene, the name, and what is allowed.
    """
    given = {
        "parameter": [parameter.symbol.name for parameter in scene.parameters],
        "body": [*(body.name for body in scene.bodies), END],
        "surface": [surface.name for surface in (*scene.surfaces, *scene.gates)],
        "end": [*(end.name for end in scene.ends), *OTHERS],
    }
    _public(scene.name, "scene", [scene.name])
    if scene.name in TAKEN:
        raise ValueError(f"scene {scene.name!r}: not one of {', '.join(TAKEN)}")
    for kind, names in given.items():
        _public(scene.name, kind, names)
        _once(scene.name, kind, names)
    for gate in scene.gates:
        whole = [k for k, part in zip(gate.outcomes, gate.parts, strict=True) if not part]
        if whole and whole[0] != gate.outcomes[-1]:
            after = next(k for k in gate.outcomes if k > whole[0])
            raise ValueError(
                f"scene {scene.name}: end {scene.ends[after].name!r}: comes after "
                f"{scene.ends[whole[0]].name!r}, which has no bounds and takes the whole plane"
            )
    for parameter in scene.parameters:
        if not LATEX.fullmatch(parameter.latex):
            raise ValueError(
                f"scene {scene.name}: parameter {parameter.name!r}: its LaTeX {parameter.latex!r} "
                "has more than letters, digits and \\ _ ^ ' { }"
            )
    laws = [law.name for law in scene.laws]
    for name in laws:
        if not LAW.fullmatch(name):
            raise ValueError(
                f"scene {scene.name}: law {name!r}: expected 'impact', or a name that ends in "
                "'_impact'"
            )
    _once(scene.name, "law", laws)


def check_kernels(scene: str, names: Iterable[str]) -> None:
    """Refuse surfaces and laws whose kernels would have the name of another kernel.

    Raises
    ------
    ValueError
        Naming the scene and the kernel.
    """
    _once(scene, "kernel", names)


def _public(scene: str, kind: str, names: Iterable[str]) -> None:
    for name in names:
        if not PUBLIC.fullmatch(name):
            raise ValueError(
                f"scene {scene!r}: {kind} {name!r}: expected a small letter, then small letters, "
                "digits and _"
            )


def _once(scene: str, kind: str, names: Iterable[str]) -> None:
    for name, count in Counter(names).items():
        if count > 1:
            raise ValueError(f"scene {scene}: {kind} {name!r}: {count} have this name")
