"""Shots of the whole hoop held against the judge: those whose flags and bounds are proved."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from benchmarks.contact_errors import KINDS, ContactErrors
from benchmarks.families import FAMILIES, Family
from benchmarks.report import number, table
from benchmarks.workloads import Workload
from hoopgen import COURT, NBA_COURT, PAPER_COURT
from hoopgen.text.numbers import format_percent

MAX_CONTACTS = 14
"""The judge proves bounces one by one, and many shots bounce until they roll."""

PARAMETERS = PAPER_COURT | {
    **dict.fromkeys(("ring_friction", "backboard_friction", "bridge_friction"), 0.5),
    "tangential_restitution": 0.15,
    "restitution_speed": 40.0,
}
"""The article's sizes, for which the families are made, with friction."""

LEFT_OUT = ("axis", "e0", "e001", "e099", "e1", "hoops")
"""Families that touch nothing, or whose parameters are those of another scene."""

CHOSEN = tuple(family for family in FAMILIES if family.key not in LEFT_OUT)


PRESETS = {"PAPER_COURT": PAPER_COURT, "NBA_COURT": NBA_COURT}
"""The parameters of `court_shares`, by name."""


@dataclass
class CourtTally:
    """The results of one family's shots.

    `wrong`: neither flagged nor estimated, and not as proved. `contact_errors`: the largest shares
    of the bounds after each contact, over the shots that are neither.
    """

    label: str
    shots: int = 0
    contacts: int = 0
    estimated: int = 0
    flagged: int = 0
    wrong: int = 0
    contact_errors: ContactErrors = field(default_factory=ContactErrors)
    seconds: float = 0.0

    @property
    def holds(self) -> bool:
        """True if no promise is broken."""
        return self.wrong == 0 and max(self.contact_errors.shares) <= 1


def court_tally(family: Family, shots: int) -> CourtTally:
    """Fly and judge a family's releases in `COURT`.

    Parameters
    ----------
    family
        The family.
    shots
        The number of shots.
    """
    started = time.perf_counter()
    states, _ = family.make(shots)
    options: dict[str, Any] = {"max_contacts": MAX_CONTACTS, "record": True}
    flown = COURT.simulate(states, PARAMETERS, **options, fields=tuple(COURT.layout.results))
    proof = COURT.certify(states, PARAMETERS, **options)
    result = CourtTally(family.label, len(flown), int(flown.contacts.sum()))
    result.estimated = int(flown.estimated.sum())
    result.flagged = int((flown.uncertain & ~flown.estimated).sum())
    result.wrong = int(np.sum(~flown.estimated & ~proof.agrees(flown)))
    result.contact_errors.add(flown, proof, ~flown.estimated)
    result.seconds = time.perf_counter() - started
    return result


@dataclass
class CourtShares:
    """Counts of a workload's shots that never roll, are proved, and are uncertain with a preset."""

    label: str
    preset: str
    shots: int
    never_rolled: int
    proved: int
    uncertain: int


def court_shares(workload: Workload, preset: str, shots: int) -> CourtShares:
    """Simulate a workload in `COURT` to its ends; the judge has no part in it.

    Parameters
    ----------
    workload
        The workload.
    preset
        The name of the parameters.
    shots
        The number of shots.
    """
    fields = ("outcome", "contacts", "rolls", "uncertain", "estimated")
    flown = COURT.simulate(workload.make(shots), PRESETS[preset], fields=fields)
    flags = (flown.rolls == 0, flown.proved, flown.uncertain)
    counts = (int(np.count_nonzero(flag)) for flag in flags)
    return CourtShares(workload.label, preset, len(flown), *counts)


def _table_of_shares(shares: Sequence[CourtShares]) -> list[str]:
    rows = []
    for one in shares:
        parts = (format_percent(n / one.shots, 2) for n in (one.never_rolled, one.proved))
        row = [one.label, f"`{one.preset}`", f"{one.shots:,}", *parts, f"{one.uncertain:,}"]
        rows.append(row)
    return table(["shots", "parameters", "number", "never roll", "proved", "uncertain"], rows)


def court_section(tallies: Sequence[CourtTally], shares: Sequence[CourtShares]) -> list[str]:
    """Return the section of the page.

    Parameters
    ----------
    tallies
        The results.
    shares
        The shares of the workloads.
    """
    head = ["shots", "number", "contacts", "estimated", "not estimated: flagged", "wrong", *KINDS]
    rows = []
    for t in tallies:
        parts = [number(share) if share else "0" for share in t.contact_errors.shares]
        counts = (format_percent(n / t.shots, 2) for n in (t.estimated, t.flagged))
        rows.append([t.label, f"{t.shots:,}", f"{t.contacts:,}", *counts, str(t.wrong), *parts])
    return [
        "## The whole hoop",
        "",
        "The same for `COURT`, with the article's sizes and a friction of 0.5: contacts grip or "
        "slip, and board and bridge are plates. "
        f"Shots have up to {MAX_CONTACTS} contacts. *Estimated* are shots whose bounds are not "
        "proved to the end. The other columns are of the rest: *wrong* are those that are neither "
        "flagged nor as the judge proves them to be, and the last four columns are the largest "
        "shares of the bounds after a contact.",
        "",
        *table(head, rows),
        "",
        "The next table has shots of the workloads with up to 1,000 contacts, which are not "
        "judged.",
        "",
        *_table_of_shares(shares),
    ]
