"""Deliberate faults in what lets a ball roll over edges of planes: each trips a test by name."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hoopgen.derive.events import plane, predicates
from hoopgen.derive.ir.event_tree import Call
from hoopgen.derive.rolling import bounds, edges

pytest.importorskip("flint")

from tests.helpers.checked_faults import (
    Check,
    OfEngine,
    OfFormulas,
    Planted,
    checks_of,
    noticed,
    passes,
)
from tests.helpers.mutants import in_decisions, in_text, in_tree
from tests.scene import test_edges, test_tiles

pytestmark = [pytest.mark.xdist_group("edge_mutations"), pytest.mark.slow]

on_ramp = OfEngine(
    test_edges.test_a_ball_leaves_the_edge_where_the_closed_form_says, scene=test_edges.RAMP
)
few_uncertain = OfEngine(test_edges.test_few_shots_off_an_edge_are_uncertain, scene=test_edges.RAMP)
on_green = OfEngine(
    test_edges.test_a_slow_ball_pivots_about_an_edge_that_is_a_body, scene=test_edges.GREEN
)
on_table = OfEngine(
    test_edges.test_a_ball_passes_a_plate_outside_its_bounds, scene=test_edges.TABLE
)
errors_grow = OfEngine(
    test_edges.test_errors_grow_by_the_time_that_an_edge_is_uncertain_by, scene=test_edges.TABLE
)
on_tiles = OfEngine(
    test_tiles.test_balls_that_roll_off_a_table_onto_tiles_are_rarely_uncertain,
    scene=test_tiles.TILES,
)
at_apexes = OfEngine(
    test_tiles.test_apexes_beside_an_edge_are_those_proved_or_flagged, scene=test_tiles.GAP
)
on_return = OfFormulas(
    test_tiles.test_the_delay_of_a_return_holds_for_every_velocity_within_its_error
)


def without(kernel: str) -> Any:
    """Take an evaluation of a kernel out of the event loop."""
    return in_tree(lambda n: () if isinstance(n, Call) and n.kernel.name == kernel else (n,))


FAULTS = (
    Planted(
        "an edge is a nanometre further out",
        in_text(
            edges,
            "_reaches",
            "arrives = all_of(AtMost(bound_distance, landing)",
            "arrives = all_of(AtMost(bound_distance + sp.Rational(1, 2**30), landing)",
        ),
        on_ramp,
    ),
    Planted(
        "a bound has twice its distance",
        in_text(
            bounds,
            "_as_distance",
            "str(bound_rate): -barrier(rate) * per",
            "str(bound_rate): -2 * barrier(rate) * per",
        ),
        on_ramp,
    ),
    Planted(
        "the time of an edge has no error",
        without("edge_errors"),
        errors_grow,
    ),
    Planted(
        "nothing takes a ball over",
        without("succeeds"),
        on_green,
    ),
    Planted(
        "a body that continues the surface is met before the edge",
        in_text(bounds, "_meets", "defers = all_of(continues", "defers = all_of(false, continues"),
        on_green,
    ),
    Planted(
        "a body beside the ball has no bounds",
        without("outside_bound"),
        on_table,
    ),
    Planted(
        "a ball off an edge is searched at once",
        without("bounded_neighbour_free_time"),
        on_table,
    ),
    Planted(
        "a ball off an edge counts as one that leaves by itself",
        in_text(
            edges,
            "_reaches",
            '"which": Choose(first, codes.over_edge, which)',
            '"which": Choose(first, codes.leaves, which)',
        ),
        few_uncertain,
    ),
    Planted(
        "an apex is undecided beyond the bounds, too",
        in_text(plane.PlaneSearch, "nodes", "if self.returns:", "if False:"),
        on_tiles,
    ),
    Planted(
        "a contact is at the apex itself",
        in_decisions(predicates, "_graze_delay = 3 * sp.sqrt(", "_graze_delay = 0 * sp.sqrt("),
        at_apexes,
    ),
    Planted(
        "a return has the margin of any other arrival",
        in_text(plane.PlaneSearch, "formulas", "if self.returns:", "if False:"),
        on_tiles,
    ),
    Planted(
        "the margin of a return is a sixty-fourth",
        in_text(plane, "returning_margin", "off.error * horizon", "off.error * horizon / 64"),
        on_return,
    ),
)

CHECKS = checks_of(FAULTS)


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: f"{check.name}")
def test_without_a_fault_every_check_passes(check: Check, tmp_path: Path) -> None:
    passes(check, tmp_path)


@pytest.mark.parametrize(
    "fault", [pytest.param(fault, id=f"{fault.name} ({fault.check.name})") for fault in FAULTS]
)
@pytest.mark.sampled(1)
def test_a_fault_trips_its_check(fault: Planted, tmp_path: Path) -> None:
    noticed(fault, tmp_path)
