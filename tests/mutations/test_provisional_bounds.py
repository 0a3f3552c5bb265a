"""Deliberate faults in the bounds of shots that have not rolled, each with the test that finds it.

A larger limit on the proved bounds is no fault, and neither is one on the speed of bounces: more
shots are flagged then, and the theorem holds.
"""

from __future__ import annotations

from typing import Any

import pytest
from hoopgen.derive.errors import provisional
from hoopgen.derive.kernels import scene as scene_kernels
from hoopgen.derive.loop import event_loop
from hoopgen.derive.scenes import COURT

pytest.importorskip("flint")

from tests.helpers.checked_faults import OfEngine, Planted, passing, tripping
from tests.helpers.mutants import Patch, in_decisions, in_text
from tests.simulation import test_court_proved as proof

pytestmark = [pytest.mark.xdist_group("provisional_mutations")]


def check(test: Any, *given: tuple[Any, ...]) -> OfEngine:
    """Return a test with an engine of a derivation."""
    return OfEngine(test, given or ((),), scene=COURT)


contacts = check(proof.check_proved, ("nba",))
rolls, starts = check(proof.check_rolls), check(proof.check_start)
at_limit = check(proof.check_time_limit, (0.9,), (1.2,))


def decided(old: str, new: str) -> Patch:
    """Replace text of a decision."""
    return in_decisions(provisional, old, new)


FAULTS = (
    Planted(
        "bounds at an end are those of the contact before it",
        decided(
            '"proves_end": all_of(Boolean("ends"), AtMost(estimated, 0))',
            '"proves_end": Less(estimated, 0)',
        ),
        contacts,
    ),
    Planted(
        "delays do not add up",
        decided("clock_bound + delay", "clock_bound + delay / 2**20"),
        contacts,
    ),
    Planted(
        "bounds of any size are used",
        in_text(provisional, "estimated_after_contact", "Not(known), ", ""),
        rolls,
    ),
    Planted(
        "hardly any bound is small enough",
        in_text(provisional, "estimated_after_contact", "AtMost(place, ", "AtMost(2**17 * place, "),
        rolls,
    ),
    Planted(
        "a ball that starts on a body is not estimated",
        decided("{estimated.name: 1}", "{estimated.name: estimated}"),
        starts,
    ),
    Planted(
        "decisions and reports use the other bounds",
        in_text(provisional, "error_bounds", "estimated, value, bound", "estimated, bound, value"),
        contacts,
    ),
    Planted(
        "times of contacts are exact at a time limit",
        in_text(provisional, "bounds_at_time", "{clock_error: clock_bound}", "{clock_error: 0}"),
        at_limit,
    ),
    Planted(
        "a contact keeps the bounds of the one before",
        in_text(event_loop, "_law_bounds", 'if "bound" in law:', "if False:"),
        contacts,
    ),
    Planted(
        "a flight to an end has no roundings",
        in_text(
            scene_kernels,
            "_proved_bounces",
            "contact_frames.errors_at_end(flight)",
            "{name: e / 64 for name, e in contact_frames.errors_at_end(flight).items()}",
        ),
        contacts,
    ),
)

test_a_fault_is_found = tripping(FAULTS)
test_without_a_fault_the_checks_pass = passing(FAULTS)
