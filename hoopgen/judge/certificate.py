"""Certificates: proved sequences of contacts, and enclosures of times and states."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.event_log import Event
from hoopgen.generated.numpy import hoop
from hoopgen.text.numbers import format_count

from .event_errors import event_errors
from .proof import UNDECIDED, Proof

if TYPE_CHECKING:
    from hoopgen.results.shots import Shots


class Certificate:
    """Proofs of a batch: arrays by shot, and each shot's own by index.

    Every result of a simulation that the judge knows is here under its name.

    Attributes
    ----------
    proofs
        `Proof` by shot.
    decided
        bool (n,), every decision was proved.
    bits
        int32 (n,), the precision that this took; undecided: the last one tried.
    outcome
        uint8 (n,), an `Outcome`, or `UNDECIDED`.
    contacts, counts, first
        As in `Shots`; of an undecided shot, as far as it is proved.
    until
        float64 (n,), s since the release: the time of the last event that is proved, 0 if none is.
    accumulates
        bool (n,), the proof ends because bounces accumulate: from there the ball rolls, which the
        judge does not follow. Such a shot is undecided; `Proof.question` says on what it rolls.
    rolls, airless_rolls, slip_left, grip_lost
        As in `Shots`: no ball rolls or ends with slip left of whose shot the outcome is proved.
    time, time_radius
        float64 (n,), s: the doubles nearest to the proved times, and how far the truth can be from
        those. NaN where undecided or invalid.
    state, state_radius
        float64 (n, 9), likewise.
    uncertain, estimated, time_error, state_error
        As in `Shots`, of what is proved: bool (n,) each, float64 (n,) and (n, 3).
    """

    rolls: NDArray[np.int32]
    airless_rolls: NDArray[np.bool_]
    slip_left: NDArray[np.bool_]
    grip_lost: NDArray[np.float64]

    def __init__(
        self,
        proofs: Sequence[Proof],
        bodies: int,
        releases: NDArray[np.float64],
        inputs: NDArray[np.float64],
        scene: str,
    ) -> None:
        self.proofs = tuple(proofs)
        self._releases, self._inputs, self._scene = releases, inputs, scene
        shots = len(proofs)
        outcome = np.array([p.outcome for p in proofs], np.uint8)
        self.outcome: NDArray[np.uint8] = outcome
        self.decided: NDArray[np.bool_] = outcome != UNDECIDED
        self.bits: NDArray[np.int32] = np.array([p.bits for p in proofs], np.int32)
        counts = np.zeros((shots, bodies + 1), np.int32)
        for row, proof in zip(counts, proofs, strict=True):
            row[:] = np.bincount(proof.surfaces, minlength=len(row)) if proof.surfaces else 0
        self.counts: NDArray[np.int32] = np.ascontiguousarray(counts[:, :-1])
        self.contacts: NDArray[np.int32] = self.counts.sum(axis=1, dtype=np.int32)
        first = [p.surfaces[0] if p.surfaces else -1 for p in proofs]
        self.first = np.array([-1 if k == bodies else k for k in first], np.int8)
        self.until: NDArray[np.float64] = np.array([p.until for p in proofs], float)
        self.accumulates: NDArray[np.bool_] = np.array([p.accumulates for p in proofs], np.bool_)
        # What the judge has proved to an end has bounced all the way.
        for result in (*hoop.RESULTS, *hoop.ABSENT_RESULTS):
            if result.proved is not None:
                setattr(self, result.name, np.full(shots, result.proved, result.dtype))
        self.time: NDArray[np.float64] = np.array([p.time for p in proofs], float)
        self.time_radius: NDArray[np.float64] = np.array([p.time_radius for p in proofs], float)
        states = [p.state for p in proofs], [p.state_radii for p in proofs]
        self.state, self.state_radius = (np.array(s, float).reshape(shots, 9) for s in states)

    @check_arguments
    def agrees(self, shots: Shots) -> NDArray[np.bool_]:
        """Return a mask of the shots that are as proved, or are marked as uncertain.

        A shot that rolls, or whose bounces have ended with slip left, is compared as far as both
        go: until it rolls, and until the proof ends (`until`). No outcome is proved of it.

        Parameters
        ----------
        shots
            Of the same releases; with their event log, ``record=True``.

        Returns
        -------
        ndarray
            bool (n,): the same surfaces in the same order, and the same outcome; or uncertain. Of
            an undecided proof, that the shot is uncertain; of one that ends because bounces
            accumulate, that the shot's impacts are those proved, as far as both go.

        Raises
        ------
        ValueError
            If they are not as many.
        AttributeError
            If they have no event log, or were simulated without "outcome" or "uncertain". In scenes
            with rolls also if a capped shot was simulated without "slip_left", and differs.
        """
        self._check_as_many(shots)
        ends = np.searchsorted(shots.events["shot"], np.arange(1, len(self)))
        found = np.split(shots.events, ends) if len(self) else []
        proved = [proof.surfaces for proof in self.proofs]
        same = [list(one["surface"]) == own for one, own in zip(found, proved, strict=True)]
        right = self.decided & (shots.outcome == self.outcome) & np.array(same, np.bool_)
        capped = int(shots.scene.outcomes["CAPPED"])
        may_slip = shots.scene.rolls & (shots.outcome == capped) & ~(right | shots.uncertain)
        for shot, (one, own) in enumerate(zip(found, proved, strict=True)):
            begun = np.flatnonzero(one["kind"] == Event.ROLL)
            if not len(begun) and may_slip[shot] and shots.slip_left[shot]:
                begun = np.array([len(one)])
            given_up = not self.decided[shot] or self.outcome[shot] == capped
            if self.accumulates[shot] or (len(begun) and given_up):
                until = min(int(begun[0]) if len(begun) else len(one), len(own))
                right[shot] = list(one["surface"][:until]) == own[:until]
        return np.asarray(right | shots.uncertain)

    @check_arguments
    def event_errors(self, shots: Shots) -> NDArray[np.void]:
        """Return proved bounds on the errors of each recorded event of simulated shots.

        This is a theorem for each row whose bounds are numbers: the exact shot from the given
        doubles has met the same surfaces in the same order up to this event, and its time and its
        states at this event differ from the recorded ones by no more than the bounds. Nothing is
        estimated, and the flag `uncertain` plays no part.

        Parameters
        ----------
        shots
            Of the same releases and parameters; with their event log, ``record=True``.

        Returns
        -------
        ndarray
            Structured, a row for each row of ``shots.events``, in its order: "shot", "surface",
            "time_error" (s), and "before_error" and "after_error", the largest error of any
            component of position (m), velocity (m/s) and spin (rad/s), (3,) each. They are NaN in
            rows of which nothing is proved: from the first event on that is not as proved, after
            the proof ends, and from a roll on.

        Raises
        ------
        ValueError
            If they are not as many, are of another scene, of other releases or of other parameters,
            or if the proofs are without ``record=True``.
        AttributeError
            If the shots have no event log.
        """
        self._check_as_many(shots)
        if shots.scene.name != self._scene:
            raise ValueError(
                f"shots: expected shots in the scene {self._scene}, which was proved; got some in "
                f"{shots.scene.name}"
            )
        inputs = shots.scene.table.inputs(shots.parameters)
        columns = [np.broadcast_to(one, len(self)) for one in inputs]
        _check_same("releases", self._releases, shots.releases)
        _check_same("parameters", self._inputs, np.stack(columns, axis=-1))
        return event_errors(self.proofs, shots.events)

    def _check_as_many(self, shots: Shots) -> None:
        if len(shots) != len(self):
            raise ValueError(
                f"shots: expected {len(self)}, as many as were proved; got {len(shots)}"
            )

    @property
    def uncertain(self) -> NDArray[np.bool_]:
        """A mask of the shots with a decision that is not proved."""
        return ~self.decided

    @property
    def time_error(self) -> NDArray[np.float64]:
        """The radii of the times, s."""
        return self.time_radius

    @property
    def state_error(self) -> NDArray[np.float64]:
        """The largest radius of each of position, velocity and spin."""
        largest: NDArray[np.float64] = self.state_radius.reshape(-1, 3, 3).max(axis=2)
        return largest

    def __len__(self) -> int:
        return len(self.proofs)

    def __getitem__(self, shot: int) -> Proof:
        return self.proofs[shot]

    def __repr__(self) -> str:
        rolling = int(self.accumulates.sum())
        until_rolling = f", {rolling:,} until they roll" if rolling else ""
        decided = f"{int(self.decided.sum()):,} decided"
        return f"Certificate({format_count(len(self), 'shot')}, {decided}{until_rolling})"


def _check_same(what: str, proved: NDArray[np.float64], given: NDArray[np.float64]) -> None:
    """Refuse shots of which something is not as it was proved; NaN is the same as NaN."""
    other = ~((given == proved) | (np.isnan(given) & np.isnan(proved))).all(axis=1)
    if other.any():
        row = int(np.flatnonzero(other)[0])
        raise ValueError(f"shots: expected the {what} that were proved; those of shot {row} differ")
