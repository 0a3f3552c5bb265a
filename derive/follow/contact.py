"""What the event loop needs to know of a surface."""

from __future__ import annotations

from dataclasses import dataclass

from ..search.search import Parts, Search


@dataclass(frozen=True)
class Contact:
    """What the loop needs to know of a surface.

    Attributes
    ----------
    index, body
        Its own index, and that of the body it belongs to.
    parts, search, law
        Its kernels by part, how arrivals on it are found, and the kernels of its contact law.
    """

    index: int
    body: int
    parts: Parts
    search: Search
    law: Parts
