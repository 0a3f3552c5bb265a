"""Proofs of single shots, from what is proved of a batch at once."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .ball_array import Bools, Floats
from .batch_flight import Flown, fly_batch
from .formulas import formulas
from .proof import Proof
from .proof_task import ProofTask

BITS = 106
"""The bits of a double-double number."""

MIN_BATCH = 128
"""Fewer shots are proved one by one; that takes less time."""

KNOWN = 2.0**-55
"""An error of the final time, place, velocity or spin, as a share of its size, above which a shot
is proved anew with more bits."""


@dataclass(frozen=True)
class BatchTask(ProofTask):
    """The proof of a batch of shots at once."""

    def __call__(self, chunk: tuple[Floats, Floats]) -> list[Proof | None]:
        """Return the proofs of shots, from states and parameters; None where there is none."""
        states, parameters = chunk
        own = formulas(self.scene)
        flown = fly_batch(own, states, parameters, self.max_contacts, self.time_limit)
        return _proofs(flown, (flown.outcome >= 0) & _well_known(flown))


def _well_known(flown: Flown) -> Bools:
    """Return a mask of the shots whose final time and state are known better than by a double."""
    sizes = np.abs(flown.numbers)
    for k in (1, 4, 7):
        sizes[k : k + 3] = sizes[k : k + 3].max(axis=0)
    # Without spin, its errors are too small to matter.
    known = (flown.errors <= np.maximum(KNOWN * sizes, 2.0**-100)) & np.isfinite(flown.away)
    return np.asarray(known.all(axis=0))


def _proofs(flown: Flown, proved: Bools) -> list[Proof | None]:
    shots, bodies, times, radii = (
        np.concatenate([part[k] for part in flown.events] or [np.zeros(0)]) for k in range(4)
    )
    order = np.argsort(shots, kind="stable")
    ends = np.searchsorted(shots[order], np.arange(len(proved) + 1)).tolist()
    surfaces, times, radii = (own[order].tolist() for own in (bodies, times, radii))
    numbers, away = flown.numbers.T.tolist(), flown.away.T.tolist()
    found: list[Proof | None] = [None] * len(proved)
    outcomes, spans = flown.outcome.tolist(), list(pairwise(ends))
    for k in np.flatnonzero(proved).tolist():
        own = slice(*spans[k])
        time, *state = numbers[k]
        radius, *state_radii = away[k]
        found[k] = Proof(
            outcomes[k],
            BITS,
            "",
            surfaces[own],
            times[own],
            radii[own],
            time,
            radius,
            state,
            state_radii,
            (),
        )
    return found
