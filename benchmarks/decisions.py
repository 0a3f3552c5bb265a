"""Counts of shots held against the judge's proofs: how they are taken, and as rows of a table."""

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from hoopgen.judge import Certificate
from hoopgen.results.shots import Shots
from hoopgen.text.numbers import format_percent

HEAD = (
    *("shots", "number", "contacts", "not flagged, wrong", "not flagged, undecidable"),
    *("flagged", "flagged, wrong", "undecidable", "most bits"),
)
"""The head of a table of decisions."""


@dataclass
class Decisions:
    """The counts of some shots.

    `wrong`: neither flagged nor as proved. `unseen`: not flagged, though undecidable. `flagged`:
    of the shots whose flags count, `changed` of them proved to be otherwise.
    """

    label: str
    shots: int = 0
    contacts: int = 0
    invalid: int = 0
    capped: int = 0
    wrong: int = 0
    unseen: int = 0
    flagged: int = 0
    changed: int = 0
    undecidable: int = 0
    settled_bits: int = 0

    def add(
        self,
        flown: Shots,
        proved: Certificate,
        same: NDArray[np.bool_],
        counted: NDArray[np.bool_] | bool = True,
    ) -> None:
        """Add shots.

        Parameters
        ----------
        flown, proved
            The shots and their proofs.
        same
            Which are as proved, flagged or not, (n,).
        counted
            Those whose flags count, (n,).
        """
        flagged, decided, outcomes = flown.uncertain, proved.decided, flown.scene.outcomes
        self.shots += len(flown)
        self.contacts += int(flown.contacts.sum())
        self.invalid += int((flown.outcome == outcomes["INVALID"]).sum())
        self.capped += int((flown.outcome == outcomes["CAPPED"]).sum())
        self.wrong += int((~flagged & ~same & decided).sum())
        self.unseen += int((~flagged & ~same & ~decided).sum())
        self.flagged += int((flagged & counted).sum())
        self.changed += int((flagged & counted & ~same & decided).sum())
        self.undecidable += int((~decided).sum())
        self.settled_bits = max(self.settled_bits, int(proved.bits[decided].max(initial=0)))

    def cells(self, whole: int, mark: str = "") -> list[str]:
        """Return the cells under `HEAD`.

        Parameters
        ----------
        whole
            The number of shots whose flags count.
        mark
            What stands around the numbers that must be 0.
        """
        return [
            self.label,
            f"{self.shots:,}",
            f"{self.contacts:,}",
            f"{mark}{self.wrong}{mark}",
            f"{mark}{self.unseen}{mark}",
            *(format_percent(n / whole, 2) if whole else "–" for n in (self.flagged, self.changed)),
            str(self.undecidable),
            str(self.settled_bits),
        ]


def together(label: str, parts: Sequence[Decisions]) -> Decisions:
    """Return the counts of all shots."""
    found = Decisions(label)
    for name in (field.name for field in fields(Decisions)[1:]):
        combine = max if name == "settled_bits" else sum
        setattr(found, name, combine(getattr(part, name) for part in parts))
    return found
