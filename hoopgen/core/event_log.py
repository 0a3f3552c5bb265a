"""Rows of the event log: descriptions, contacts and rolls."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy.hoop import Event as Event
from hoopgen.text.numbers import format_count

__all__ = ["Event", "describe_event", "describe_passages", "impacts", "number_contacts", "rolls"]


def describe_event(event: np.void, surfaces: Sequence[str]) -> str:
    """Describe a row: "ring", "rolls on ring", "leaves ring" or "end".

    Parameters
    ----------
    event
        A row of the event log.
    surfaces
        Names of the bodies by their number.
    """
    surface = int(event["surface"])
    name = surfaces[surface] if surface < len(surfaces) else "end"
    before = {Event.ROLL: "rolls on ", Event.LEAVE: "leaves "}
    return f"{before.get(Event(int(event['kind'])), '')}{name}"


def describe_passages(contacts: int, impacts: int) -> str:
    """Describe the contacts of a shot that are no impacts; nothing if there are none.

    Parameters
    ----------
    contacts
        All of its contacts. Each roll that goes on from one body to another is one.
    impacts
        Those at which the ball hits a body.
    """
    passages = contacts - impacts
    return f"; {format_count(passages, 'roll')} went on to another body" if passages else ""


def impacts(events: NDArray[np.void]) -> NDArray[np.void]:
    """Return the rows that count as contacts."""
    return np.asarray(events[events["kind"] == Event.IMPACT])


def number_contacts(events: NDArray[np.void]) -> Iterable[tuple[int | None, np.void]]:
    """Return each row with its number among the contacts, None if it is none."""
    number = 0
    for event in events:
        struck = bool(event["kind"] == Event.IMPACT)
        number += struck
        yield (number if struck else None), event


def rolls(events: NDArray[np.void]) -> list[tuple[int, float, float]]:
    """Return a shot's rolls: the row with which each begins, its start and its end, s."""
    begun = [row for row, kind in enumerate(events["kind"][:-1]) if kind == Event.ROLL]
    return [(row, float(events["time"][row]), float(events["time"][row + 1])) for row in begun]
