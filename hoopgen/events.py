"""Rows of the event log in words, and which of them count as contacts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy.hoop import Event as Event

__all__ = ["Event", "event_words", "impacts", "numbered", "rolls"]


def event_words(event: Any, surfaces: Sequence[str]) -> str:
    """Say what a row is: "ring", "rolls on ring", "leaves ring" or "end"."""
    surface = int(event["surface"])
    name = surfaces[surface] if surface < len(surfaces) else "end"
    before = {Event.ROLL: "rolls on ", Event.LEAVE: "leaves "}
    return f"{before.get(Event(int(event['kind'])), '')}{name}"


def impacts(events: NDArray[Any]) -> NDArray[Any]:
    """Return the rows that count as contacts."""
    return np.asarray(events[events["kind"] == Event.IMPACT])


def numbered(events: NDArray[Any]) -> Iterable[tuple[int | None, Any]]:
    """Return each row with its number among the contacts, None where it is none."""
    number = 0
    for event in events:
        struck = bool(event["kind"] == Event.IMPACT)
        number += struck
        yield (number if struck else None), event


def rolls(events: NDArray[Any]) -> list[tuple[int, float, float]]:
    """Return a shot's contacts that last: the row with which each begins, from when to when, s."""
    begun = [row for row, kind in enumerate(events["kind"][:-1]) if kind == Event.ROLL]
    return [(row, float(events["time"][row]), float(events["time"][row + 1])) for row in begun]
