"""The names in a scene: its own, and those of parameters, bodies, surfaces and laws.

They reach generated code, files and results unchanged, and so are checked here, once. Where they
could meet one of our names or of a language's, generated code adds a prefix.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence

from .ends import OTHER_OUTCOMES

PUBLIC = re.compile(r"[a-z][a-z0-9_]*", re.ASCII)
"""Pattern of a public name."""

LAW = re.compile(r"(?:[a-z][a-z0-9_]*_)?impact", re.ASCII)
"""Pattern of a law's name, which is that of a kernel."""

LATEX = re.compile(r"[A-Za-z0-9_^'{}\\ ]*", re.ASCII)
"""Pattern of a parameter's LaTeX: it cannot end a formula."""

END = "end"
"""Name of an end where bodies are named."""

RESERVED_NAMES = (
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
)
"""Names that no scene can have: the prefix of parameters, and headers that its own include."""


def check(
    scene: str,
    parameters: Sequence[tuple[str, str]],
    bodies: Sequence[str],
    surfaces: Sequence[str],
    ends: Sequence[str],
    laws: Sequence[str],
) -> None:
    """Check that names are public names, and that no two things of one kind share a name.

    Parameters
    ----------
    scene
        The scene's own name.
    parameters
        Name and LaTeX of each parameter.
    bodies, surfaces, ends, laws
        Names; those of the planes of ends are among the surfaces'.

    Raises
    ------
    ValueError
        Naming the scene, the name, and what is allowed.
    """
    _public(scene, "scene", [scene])
    if scene in RESERVED_NAMES:
        raise ValueError(f"scene {scene!r}: not one of {', '.join(RESERVED_NAMES)}")
    given = {
        "parameter": [name for name, _ in parameters],
        "body": [*bodies, END],
        "surface": surfaces,
        "end": [*ends, *OTHER_OUTCOMES],
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

    Parameters
    ----------
    scene
        The name of the scene, for the message.
    names
        The names of all its kernels.

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
