"""Deliberate faults in what the lemmas of the decisions of a flight rest on, each trips a test."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from hoopgen.derive.events import event_polynomials, plane, plane_start
from hoopgen.derive.events import predicates as searching
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.events.ring.polar import PolarRootFinder
from hoopgen.derive.events.ring.single import SinglePrecisionRing
from hoopgen.derive.ir.event_tree import Call
from hoopgen.derive.loop import event_loop
from hoopgen.derive.scenes import COURT, HOOP

pytest.importorskip("flint")

from tests.derive.events import test_first_event
from tests.derive.events import test_plane_decisions as planes
from tests.derive.events import test_ring_window_errors as ring
from tests.helpers.checked_faults import OfEngine, OfFormulas, OfKernels, Planted, passing, tripping
from tests.helpers.mutants import in_decisions, in_text, in_tree
from tests.scene import test_shelf
from tests.simulation import test_passed_surfaces as passed

pytestmark = [pytest.mark.xdist_group("lemma_mutations")]

arrival = OfFormulas(
    planes.test_a_decided_arrival_is_one_of_the_true_ball_and_within_a_third_of_its_delay,
    ((1,), (2,), (3,)),
)
start = OfFormulas(
    planes.test_a_start_at_a_plane_is_undecided_within_its_errors_and_not_far_beyond,
    ((1,), (2,), (3,)),
)
slowly = OfFormulas(
    planes.test_a_ball_that_an_error_of_its_velocity_brings_to_the_board_is_undecided
)
place = OfFormulas(planes.test_a_length_at_an_arrival_is_off_by_no_more_than_its_bound)
sooner = OfFormulas(planes.test_what_may_be_sooner_is_undecided_from_then_on)
overdue = OfFormulas(
    planes.test_an_event_that_may_be_after_the_horizon_is_undecided_whatever_misses
)
windows = OfFormulas(
    ring.test_the_windows_of_a_computed_flight_hold_the_true_one_near_the_ring, (("double",),)
)
windows_in_single = OfKernels(
    ring.test_the_windows_of_a_computed_flight_hold_the_true_one_near_the_ring, (("single",),)
)
upwards = OfFormulas(ring.test_margins_are_no_smaller_than_their_formulas)
upwards_in_single = OfKernels(ring.test_margins_are_no_smaller_than_their_formulas)
height = OfEngine(
    test_first_event.test_a_ball_that_leaves_the_board_at_the_height_of_the_end_plane_is_uncertain,
    scene=HOOP,
)
height_of_court = replace(height, scene=COURT)


def start_inputs(node: Any) -> set[Any]:
    """Return what an evaluation of a kernel takes in place of its arguments."""
    return set(node.inputs.values()) if isinstance(node, Call) else set()


def behind(surface: str, more: str) -> OfEngine:
    """Return the check of a surface that a ball may be behind, in a scene of its own."""
    test = (
        passed.test_a_ball_that_leaves_the_ring_at_such_a_surface_to_within_a_rounding_is_uncertain
    )
    return OfEngine(test, scene=passed.ring_and(surface, more))


def falls_at(surface: str, more: str) -> OfEngine:
    """Return the check of a plate at which balls fall, in a scene of its own."""
    test = passed.test_a_ball_that_falls_from_a_body_at_a_plate_to_within_a_rounding_is_uncertain
    return OfEngine(test, scene=passed.falling_at(surface, more))


def without(kernel: str) -> Any:
    """Take an evaluation of a kernel out of the event loop."""
    return in_tree(lambda n: () if isinstance(n, Call) and n.kernel.name == kernel else (n,))


FAULTS = (
    Planted("no apex and no start is undecided", without("apex_undecided"), height),
    Planted(
        "where balls roll, a ball that falls at an end from the start on is before it",
        in_text(plane, "_largest", "IfLess(b, 0, c, height)", "height"),
        height_of_court,
    ),
    *(
        Planted(
            f"where balls roll, the side of an end across {axis} is sure",
            in_text(
                plane,
                "asks_side",
                "isinstance(plane, EndPlane) or pulls is False",
                "(isinstance(plane, EndPlane) and pulls)",
            ),
            behind(f"end across {axis}", "rolls"),
        )
        for axis in "xy"
    ),
    Planted(
        "where balls roll, the side of a wall is sure",
        in_text(plane, "asks_side", " or pulls is False", ""),
        behind("wall", "rolls"),
    ),
    *(
        Planted(
            f"nothing is undecided at the start at the {surface}, {more or 'where none rolls'}",
            in_tree(lambda n: () if "side_gap" in start_inputs(n) else (n,)),
            behind(surface, more),
        )
        for surface, more in (
            ("end across z", "rolls"),
            ("ceiling", "rolls"),
            ("overhang", ""),
            ("wall", "leans"),
        )
    ),
    *(
        Planted(
            f"a search that may begin behind the {surface} is sure of it",
            in_decisions(searching, "AtMost(gap_at_start, margin)", "false"),
            behind(surface, ""),
        )
        for surface in ("sphere", "cylinder")
    ),
    Planted(
        "an end along gravity is searched before any arrival is known",
        in_text(
            event_loop,
            "_detect",
            "sorted(end_planes, key=lambda end: end.search.level)",
            "end_planes",
        ),
        OfEngine(
            test_shelf.test_bounces_end_when_their_sum_says, ((0.2,),), scene=test_shelf.SHELF
        ),
    ),
    Planted(
        "a ball that falls at a plate on which balls roll is before it",
        in_text(plane, "_largest", "IfLess(0, leaving, 0, 1)", "0"),
        falls_at("floor", "rolls"),
    ),
    Planted(
        "a ball that falls at an inclined plate is before it",
        in_text(plane, "plane_arrival", "IfLess(a, 0, first, apex)", "apex"),
        falls_at("incline", ""),
    ),
    Planted(
        "roundings decide whether gravity pulls to a plate",
        in_text(
            plane,
            "start_side",
            "-2 * vague_pull(plane, flight) if isinstance(plane, InclinedPlane) else 0",
            "0",
        ),
        falls_at("hanging", "aslant"),
    ),
    Planted(
        "a ball that falls from the start on has no apex",
        in_text(plane, "_largest", "IfLess(b, 0, c, height)", "height"),
        start,
    ),
    Planted(
        "a ball that falls from the start on is within its margin as long as before",
        in_text(plane, "_largest", "IfLess(b, 0, 0, apex), ", "apex, "),
        start,
    ),
    Planted(
        "the side of the board at the start is sure",
        in_decisions(searching, "AtMost(absolute(height), barrier(2 * margin))", "Less(1, 0)"),
        start,
    ),
    Planted(
        "the side of the board at the start counts for a ball that moves off it",
        in_decisions(
            searching, "Less(rate, barrier(2 * velocity_error))", "Less(rate, barrier(2 + margin))"
        ),
        start,
    ),
    Planted(
        "a ball that leaves the board is at it",
        in_text(plane, "plane_arrival", "IfLess(b, 0, 0, sp.oo)", "sp.Integer(0)"),
        start,
    ),
    Planted(
        "a ball that leaves the board into it has left it",
        in_text(plane, "plane_arrival", "IfLess(b, 0, 0, sp.oo)", "sp.oo"),
        start,
    ),
    Planted(
        "an error of the velocity brings no ball to the board",
        in_decisions(searching, "Less(rate, barrier(2 * velocity_error))", "Less(rate, 0)"),
        slowly,
    ),
    Planted(
        "a ball that is slower than the error of its velocity comes when it is computed to",
        in_decisions(
            searching, "Choose(Less(height, 0), 0, sp.oo))), when", "sp.Integer(0))), when"
        ),
        slowly,
    ),
    Planted(
        "a ball behind the board may come to it from there",
        in_decisions(searching, "Choose(Less(height, 0), 0, sp.oo)", "sp.oo"),
        slowly,
    ),
    Planted(
        "errors of the velocity may be of any size beside those of the place",
        in_text(plane_start, "plane_start", "barrier(unsure**2)", "barrier(0 * unsure**2)"),
        arrival,
    ),
    Planted(
        "a plane's margin has an eighth of the errors",
        in_text(
            plane, "plane_margin", "return 2 * ROUNDING", "return ROUNDING_SLACK / 8 * ROUNDING"
        ),
        arrival,
    ),
    Planted(
        "a delay is a sixth of what it is",
        in_text(event_polynomials, "crossing", "6 * margin / slope", "margin / slope / 2"),
        arrival,
    ),
    Planted(
        "a length at an arrival has no delay",
        in_text(event_polynomials, "displacement", "delay * moving.magnitude + ", ""),
        place,
    ),
    Planted(
        "a tie is no sooner than computed",
        in_decisions(
            searching, "_sooner_time - minimum(_delays, barrier(_sooner_time / 2))", "_sooner_time"
        ),
        sooner,
    ),
    Planted(
        "a contact near an edge is no sooner than computed",
        in_decisions(searching, "earlier(undecided, time / 2)", "earlier(undecided, time)"),
        sooner,
    ),
    Planted(
        "an apex is no sooner than computed",
        in_decisions(
            searching,
            '{"undecided_time": Choose(_grazes, 0, undecided_time)},',
            '{"undecided_time": earlier(_grazes, apex)},',
        ),
        sooner,
    ),
    Planted(
        "a root that is not certain is no sooner than computed",
        in_decisions(searching, "Choose(certain, time - delay, since)", "time"),
        sooner,
    ),
    Planted(
        "an open root is no sooner than where it was refined to",
        in_decisions(searching, "minimum(t, time)", "time"),
        sooner,
    ),
    Planted(
        "an event after the horizon is sure where a test misses the ring",
        in_decisions(searching, "overdue(sp.Rational(1, 2))", "overdue(sp.Rational(1, 8))"),
        overdue,
    ),
    Planted(
        "windows are those of the ring itself",
        in_text(PolarRootFinder, "reach", " * INFLATION_FACTOR", ""),
        windows,
    ),
    Planted(
        "windows are those of the ring itself in single precision",
        in_text(PolarRootFinder, "reach", " * INFLATION_FACTOR", ""),
        windows_in_single,
    ),
    Planted(
        "the margin of the gap is not rounded upwards",
        in_text(
            RingRootFinder, "margins", '"margin": ROUNDING_SLACK * barrier', '"margin": barrier'
        ),
        upwards,
    ),
    Planted(
        "the margin of the gap in single precision is not rounded upwards",
        in_text(SinglePrecisionRing, "grain", "place = ROUNDING_SLACK * ", "place = "),
        upwards_in_single,
    ),
)

test_a_fault_trips_its_check = tripping(FAULTS)
test_without_a_fault_the_checks_pass = passing(FAULTS)
