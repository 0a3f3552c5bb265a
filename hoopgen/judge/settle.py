"""`settle`: proofs decide the shots that the engine could not decide in doubles."""

from __future__ import annotations

from itertools import compress
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.event_log import Event
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles
from hoopgen.engine.compiled_scene import CompiledScene

from .batch import certify
from .certificate import Certificate
from .event_errors import event_errors

SETTLING_BITS = 1024
"""A shot that this does not decide is a true tie, touch or edge, or soon becomes one."""


def settle(
    fields: dict[str, NDArray[Any]],
    states: NDArray[np.float64],
    parameters: ParameterValues,
    max_contacts: int | None = None,
    *,
    scene: CompiledScene,
    leaving: ArrayLike | None = None,
    time_limit: float | None = None,
) -> NDArray[np.int64]:
    """Replace the results of uncertain shots by proved ones; undecidable shots stay.

    Parameters
    ----------
    fields
        Results by name, as in `Shots`; "uncertain" is among them. Arrays by shot are written in
        place; "events", if there, is replaced by a new log.
    states, parameters, max_contacts, scene, leaving, time_limit
        Of the simulation that the results are from.

    Returns
    -------
    ndarray
        The shots that were settled, which are uncertain no longer.
    """
    rows = np.flatnonzero(fields["uncertain"])
    if not len(rows):
        return rows
    own = {name: _rows(as_doubles(name, value), rows) for name, value in parameters.items()}
    certificate = certify(
        states[rows],
        own,
        scene=scene,
        max_contacts=max_contacts,
        max_bits=SETTLING_BITS,
        record="events" in fields,
        leaving=None if leaving is None else _rows(leaving, rows),
        time_limit=time_limit,
    )
    proved = certificate.decided
    settled = rows[proved]
    for name in scene.layout.results.keys() & fields.keys():
        result = scene.layout.results[name]
        if result.is_judged or result.proved is not None:
            fields[name][settled] = getattr(certificate, name)[proved]
    if "events" in fields:
        fields["events"] = _log(fields["events"], rows, certificate, proved, len(scene.surfaces))
    return settled


def _rows(value: ArrayLike, rows: NDArray[np.int64]) -> NDArray[Any]:
    array = np.asarray(value)
    return array[rows] if array.ndim else array


def _log(
    events: NDArray[np.void],
    rows: NDArray[np.int64],
    certificate: Certificate,
    proved: NDArray[np.bool_],
    bodies: int,
) -> NDArray[np.void]:
    """Return the event log with the proved events of settled shots in place of theirs."""
    proofs = list(compress(certificate.proofs, proved))
    found = [(shot, event) for shot, proof in enumerate(proofs) for event in proof.events]
    fresh = np.zeros(len(found), events.dtype)
    for row, (shot, event) in zip(fresh, found, strict=True):
        row["shot"], row["surface"], row["time"] = shot, event.surface, float(event.time)
        row["before"], row["after"] = ([*map(float, s)] for s in (event.before, event.after))
        row["kind"] = Event.END if event.surface == bodies else Event.IMPACT
    bounds = {"time_error": "time_error", "state_error": "after_error"}
    if named := bounds.keys() & {*(events.dtype.names or ())}:
        errors = event_errors(proofs, fresh)
        for name in named:
            fresh[name] = errors[bounds[name]]
    fresh["shot"] = rows[proved][fresh["shot"]]
    kept = events[~np.isin(events["shot"], rows[proved])]
    merged = np.concatenate([kept, fresh])
    return merged[np.argsort(merged["shot"], kind="stable")]
