"""A body: what a ball touches as one, with one law of contact and one column of results."""

from __future__ import annotations

from dataclasses import dataclass

from ..contact.law import Law
from .surface import Surface


@dataclass(frozen=True)
class Body:
    """A body of one or more faces.

    Attributes
    ----------
    name
        Its column in results.
    faces
        Its surfaces; one of them may have the body's own name.
    law
        What a contact with any of them does to the ball.
    """

    name: str
    faces: tuple[Surface, ...]
    law: Law


def body(face: Surface, law: Law) -> Body:
    """Return a body that is one surface, and has its name."""
    return Body(face.name, (face,), law)
