"""The part of a question to the judge that is the same for all shots of a batch."""

from __future__ import annotations

from dataclasses import dataclass

from hoopgen.derive.scenes.scene import Scene


@dataclass(frozen=True)
class ProofTask:
    """A task that proves shots.

    Attributes
    ----------
    scene
        Of derive/.
    max_contacts
        The number of contacts at which a shot is capped.
    time_limit
        The time limit, s; infinite: none.
    """

    scene: Scene
    max_contacts: int
    time_limit: float
