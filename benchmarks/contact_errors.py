"""Errors at every contact, held against the bounds that the decisions of the next flight use."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from hoopgen import HOOP
from hoopgen.engine import numpy_backend
from hoopgen.judge import Certificate

KINDS = ("position", "velocity", "spin")


@dataclass
class ContactErrors:
    """The errors of states after contacts, of shots that are not flagged.

    Attributes
    ----------
    contacts
        The number of contacts whose errors were proved.
    open
        The number of the other contacts of these shots.
    shares
        The largest error of a component over its bound, of position, velocity and spin.
    """

    contacts: int = 0
    open: int = 0
    shares: list[float] = field(default_factory=lambda: [0.0] * len(KINDS))

    def add(self, flown: hoopgen.Shots, proved: Certificate, max_contacts: int) -> NDArray[Any]:
        """Add the contacts of shots.

        Parameters
        ----------
        flown
            Shots of `HOOP`, with their event log and "uncertain".
        proved
            The proofs of the same shots, with their events.
        max_contacts
            The cap of both.

        Returns
        -------
        ndarray
            The largest share of each shot, (n,).
        """
        largest = np.zeros(len(flown))
        tightened = _once(flown, np.arange(len(flown)), max_contacts, False)["uncertain"]
        log = flown.events
        impacts = log["kind"] == hoopgen.Event.IMPACT
        log = log[impacts & ~flown.uncertain[log["shot"]]]
        errors = proved.event_errors(flown)[impacts & ~flown.uncertain[flown.events["shot"]]]
        first = np.searchsorted(log["shot"], log["shot"])
        number = np.arange(len(log)) - first + 1
        for count in range(1, min(int(number.max(initial=0)), max_contacts) + 1):
            rows = np.flatnonzero(number == count)
            bounds = _bounds_after(flown, count, log[rows], tightened)
            off = errors["after_error"][rows]
            known = np.isfinite(off).all(axis=1)
            with np.errstate(divide="ignore", invalid="ignore"):
                shares = np.where(off > 0, off / bounds, 0.0)[known]
            self.contacts += int(known.sum())
            self.open += int((~known).sum())
            self.shares = np.maximum(self.shares, shares.max(axis=0, initial=0.0)).tolist()
            np.maximum.at(largest, log["shot"][rows][known], shares.max(axis=1, initial=0.0))
        return largest


def _bounds_after(
    flown: hoopgen.Shots, count: int, rows: NDArray[np.void], tightened: NDArray[np.bool_]
) -> NDArray[np.float64]:
    """Return the bounds on errors of the state after so many contacts, (rows, 3).

    A shot that is capped there ends with the state and the errors with which the next flight
    begins. The decisions of a shot that is certain with tighter bounds alone rest on these.
    """
    shots = rows["shot"]
    parameters = {
        name: np.broadcast_to(value, len(flown))[shots] for name, value in flown.parameters.items()
    }
    fields = ("outcome", "state", "state_error")
    capped = hoopgen.simulate(flown.releases[shots], parameters, max_contacts=count, fields=fields)
    if not (capped.state == rows["after"]).all():
        raise AssertionError("a shot that is capped at a contact has not the state after it")
    bounds: NDArray[np.float64] = capped.state_error.copy()
    own = np.flatnonzero(tightened[shots])
    tighter = _once(flown, shots[own], count, True)
    if not np.array_equal(tighter["state"], rows["after"][own]):
        raise AssertionError("a shot with tighter bounds has not the state after a contact")
    bounds[own] = tighter["state_error"]
    return bounds


def _once(
    flown: hoopgen.Shots, shots: NDArray[np.int64], most: int, tightening: bool
) -> dict[str, NDArray[Any]]:
    """Return results of some of the shots, simulated once, with tighter bounds or without."""
    kernels = HOOP.kernels
    parameters = [
        np.broadcast_to(flown.parameters[name], len(flown))[shots] for name in kernels.PARAMETERS
    ]
    out = HOOP.layout.allocate(len(shots), ("state", "state_error", "uncertain"))
    numpy_backend.run(
        kernels, flown.releases[shots], parameters, None, most, out, tightening=tightening
    )
    return out.arrays
