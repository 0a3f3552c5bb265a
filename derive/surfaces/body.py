"""A body: one or more faces with one contact law and one column of results."""

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
        The name of its column in results.
    faces
        Its surfaces; one of them may have the body's own name.
    law
        The contact law of all its faces.
    """

    name: str
    faces: tuple[Surface, ...]
    law: Law


def body(face: Surface, law: Law) -> Body:
    """Return a body with one surface and that surface's name.

    Parameters
    ----------
    face
        The only surface of the body.
    law
        The contact law.
    """
    return Body(face.name, (face,), law)
