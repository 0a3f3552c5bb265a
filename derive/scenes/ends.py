"""How a shot can end: at planes with names, and otherwise."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..surfaces import Gate, Plane

OTHERS = {
    "capped": "Had max_contacts contacts before it ended.",
    "short": "Can never reach an end.",
    "invalid": "Not finite, not allowed, a size out of range, or a start inside a surface.",
    "lodged": "At rest, or wedged between bodies.",
    "endless": "Still moving at the time limit.",
}
"""The outcomes of shots that reach no end, after the scene's ends, and what each says."""


@dataclass(frozen=True)
class End:
    """What ends a shot: a plane crossed against its normal, within its bounds.

    Attributes
    ----------
    name
        Of the outcome.
    plane
        Of ends on one plane (equal in direction and offset) the first is reached whose bounds hold.
    meaning
        What the outcome says, in one line; "": that the end was reached.
    passed
        Whether it is one only for a ball that has fallen through the scene's `passage`.
    """

    name: str
    plane: Plane
    meaning: str = ""
    passed: bool = False


def outcomes(ends: Sequence[End]) -> dict[str, int]:
    """Return the number of each outcome: the ends in order, then the others."""
    return {name: k for k, name in enumerate((*(end.name for end in ends), *OTHERS))}


def meanings(ends: Sequence[End]) -> dict[str, str]:
    """Return what each outcome says, in one line, in order."""
    own = {end.name: end.meaning or f"Reached the end {end.name}." for end in ends}
    return own | OTHERS


def gates(ends: Sequence[End]) -> tuple[Gate, ...]:
    """Return the planes of the ends, each once; it has the name of its first end's."""
    planes: dict[tuple[object, ...], list[int]] = {}
    for k, end in enumerate(ends):
        planes.setdefault((end.plane.direction, end.plane.offset), []).append(k)
    return tuple(
        Gate(
            ends[own[0]].plane.name,
            ends[own[0]].plane.direction,
            ends[own[0]].plane.offset,
            ends[own[0]].plane.reach,
            parts=tuple(ends[k].plane.bounds for k in own),
            outcomes=tuple(own),
            passed=tuple(ends[k].passed for k in own),
        )
        for own in planes.values()
    )


def check_reached(scene: str, ends: Sequence[End]) -> None:
    """Refuse an end that is never reached, for one before it takes the whole plane.

    Raises
    ------
    ValueError
        Naming the scene and both ends.
    """
    for gate in gates(ends):
        parts = zip(gate.outcomes, gate.parts, gate.passed, strict=True)
        whole = [k for k, part, passed in parts if not part and not passed]
        if whole and whole[0] != gate.outcomes[-1]:
            after = next(k for k in gate.outcomes if k > whole[0])
            raise ValueError(
                f"scene {scene}: end {ends[after].name!r}: comes after "
                f"{ends[whole[0]].name!r}, which has no bounds and takes the whole plane"
            )


def check_passed(scene: str, ends: Sequence[End], passage: bool) -> None:
    """Refuse an end for balls that have passed what the scene does not have, or without bounds.

    Raises
    ------
    ValueError
        Naming the scene and the end.
    """
    for end in ends:
        if end.passed and not (passage and end.plane.bounds):
            missing = "bounds" if passage else "a passage of the scene"
            raise ValueError(f"scene {scene}: end {end.name!r}: passed needs {missing}")
