"""Errors at every contact, held against the bounds that the event log has for them."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from hoopgen.judge import Certificate

KINDS = ("time", "position", "velocity", "spin")


@dataclass
class ContactErrors:
    """The errors of times of contacts and of states after them, of shots that are not flagged.

    Attributes
    ----------
    contacts
        The number of contacts whose errors were proved.
    open
        The number of the other contacts of these shots.
    shares
        The largest error over its bound, of time and of a component of position, velocity and spin.
    """

    contacts: int = 0
    open: int = 0
    shares: list[float] = field(default_factory=lambda: [0.0] * len(KINDS))

    def add(
        self,
        flown: hoopgen.Shots,
        proved: Certificate,
        among: NDArray[np.bool_] | bool = True,
    ) -> NDArray[Any]:
        """Add the contacts of shots.

        Parameters
        ----------
        flown
            Shots with "uncertain", "time_error" and "state_error", and with their event log.
        proved
            The proofs of the same shots, with their events.
        among
            Those that count, (n,).

        Returns
        -------
        ndarray
            The largest share of each shot, (n,).
        """
        largest, log = np.zeros(len(flown)), flown.events
        counted = ~flown.uncertain & among
        sure = (log["kind"] == hoopgen.Event.IMPACT) & counted[log["shot"]]
        log, errors = log[sure], proved.event_errors(flown)[sure]
        off = np.column_stack([errors["time_error"], errors["after_error"]])
        bounds = np.column_stack([log["time_error"], log["state_error"]])
        known = np.isfinite(off).all(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            shares = np.where(off > 0, off / bounds, 0.0)[known]
        self.contacts += int(known.sum())
        self.open += int((~known).sum())
        self.shares = np.maximum(self.shares, shares.max(axis=0, initial=0.0)).tolist()
        np.maximum.at(largest, log["shot"][known], shares.max(axis=1, initial=0.0))
        return largest
