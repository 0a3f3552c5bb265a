"""The ends of a shot: planes with names, and other outcomes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..surfaces import EndPlane, Plane

OTHER_OUTCOMES = {
    "capped": "Had max_contacts contacts before it ended.",
    "short": "Can never reach an end.",
    "invalid": "Not finite, not allowed, a size out of range, or a start inside a surface.",
    "lodged": "At rest, or wedged between bodies.",
    "endless": "Still moving at the time limit.",
}
"""The outcomes of shots that reach no end, with their meanings; they follow the scene's ends."""


@dataclass(frozen=True)
class End:
    """A plane that ends a shot if the ball crosses it against its normal, within its bounds.

    Attributes
    ----------
    name
        The name of the outcome.
    plane
        The plane; of ends on one plane (equal in direction and offset) the first is reached whose
        bounds hold.
    meaning
        The meaning of the outcome, in one line; "": that the end was reached.
    passed
        True if only a ball that has fallen through the scene's `passage` can reach it.
    """

    name: str
    plane: Plane
    meaning: str = ""
    passed: bool = False


def outcomes(ends: Sequence[End]) -> dict[str, int]:
    """Return the number of each outcome: the ends in order, then the others."""
    return {name: k for k, name in enumerate((*(end.name for end in ends), *OTHER_OUTCOMES))}


def meanings(ends: Sequence[End]) -> dict[str, str]:
    """Return the meaning of each outcome, in one line, in order."""
    own = {end.name: end.meaning or f"Reached the end {end.name}." for end in ends}
    return own | OTHER_OUTCOMES


def end_planes(ends: Sequence[End]) -> tuple[EndPlane, ...]:
    """Return the planes of the ends, each once, with the name of its first end's plane."""
    planes: dict[tuple[object, ...], list[int]] = {}
    for k, end in enumerate(ends):
        planes.setdefault((end.plane.direction, end.plane.offset), []).append(k)
    return tuple(
        EndPlane(
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
    """Check that no end is behind another one that takes the whole plane.

    Parameters
    ----------
    scene
        The name of the scene, for the message.
    ends
        Its ends, in order: the first whose part of a plane the ball crosses counts.

    Raises
    ------
    ValueError
        Naming the scene and both ends.
    """
    for end_plane in end_planes(ends):
        parts = zip(end_plane.outcomes, end_plane.parts, end_plane.passed, strict=True)
        whole = [k for k, part, passed in parts if not part and not passed]
        if whole and whole[0] != end_plane.outcomes[-1]:
            after = next(k for k in end_plane.outcomes if k > whole[0])
            raise ValueError(
                f"scene {scene}: end {ends[after].name!r}: comes after "
                f"{ends[whole[0]].name!r}, which has no bounds and takes the whole plane"
            )


def check_passed(scene: str, ends: Sequence[End], passage: bool) -> None:
    """Check that ends for balls that have passed the ring have bounds, and the scene a passage.

    Parameters
    ----------
    scene
        The name of the scene, for the message.
    ends
        Its ends, in order.
    passage
        True if the scene has a ring that a ball can fall through.

    Raises
    ------
    ValueError
        Naming the scene and the end.
    """
    for end in ends:
        if end.passed and not (passage and end.plane.bounds):
            missing = "bounds" if passage else "a passage of the scene"
            raise ValueError(f"scene {scene}: end {end.name!r}: passed needs {missing}")
