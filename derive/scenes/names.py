"""Names that a scene gives: its own, and those of parameters, bodies, surfaces and laws.

They reach generated code, files and results as they are, and so are checked here, once. Where they
could meet a name of ours or of a language, generated code puts something before them.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence

from .ends import OTHERS

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


def check(
    scene: str,
    parameters: Sequence[tuple[str, str]],
    bodies: Sequence[str],
    surfaces: Sequence[str],
    ends: Sequence[str],
    laws: Sequence[str],
) -> None:
    """Refuse names that are not public names, or that two things of one kind have.

    Parameters
    ----------
    scene
        The scene's own name.
    parameters
        Name and LaTeX of each.
    bodies, surfaces, ends, laws
        Names; those of the planes of ends are among the surfaces'.

    Raises
    ------
    ValueError
        Naming the scene, the name, and what is allowed.
    """
    _public(scene, "scene", [scene])
    if scene in TAKEN:
        raise ValueError(f"scene {scene!r}: not one of {', '.join(TAKEN)}")
    given = {
        "parameter": [name for name, _ in parameters],
        "body": [*bodies, END],
        "surface": surfaces,
        "end": [*ends, *OTHERS],
    }
    for kind, names in given.items():
        _public(scene, kind, names)
        _once(scene, kind, names)
    for name, latex in parameters:
        if not LATEX.fullmatch(latex):
            raise ValueError(
                f"scene {scene}: parameter {name!r}: its LaTeX {latex!r} "
                "has more than letters, digits and \\ _ ^ ' { }"
            )
    for name in laws:
        if not LAW.fullmatch(name):
            raise ValueError(
                f"scene {scene}: law {name!r}: expected 'impact', or a name that ends in '_impact'"
            )
    _once(scene, "law", laws)


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
