"""Bounds in the event log held against the judge."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hoopgen import Shots
from hoopgen.judge.certificate import Certificate


def bounded_events(shots: Shots, proof: Certificate) -> NDArray[np.bool_]:
    """Return the events of shots without a flag that the judge has, once their bounds hold.

    Parameters
    ----------
    shots
        The shots, with the bounds of their events.
    proof
        The judge's account of them.

    Returns
    -------
    ndarray
        bool, one row an event.
    """
    log, errors = shots.events, proof.event_errors(shots)
    known = ~shots.uncertain[log["shot"]] & np.isfinite(errors["time_error"])
    assert np.all(errors["time_error"][known] <= log["time_error"][known])
    assert np.all(errors["after_error"][known] <= log["state_error"][known])
    return known
