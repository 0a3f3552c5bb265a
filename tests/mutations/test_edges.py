"""Deliberate faults in what lets a ball roll over edges: each trips a test by name."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hoopgen.derive.events import plane, predicates
from hoopgen.derive.ir.event_tree import Call
from hoopgen.derive.rolling import (
    bounds,
    contact_phase,
    edges,
    events,
    jump,
    meeting,
    settling,
    stages,
)
from hoopgen.derive.scenes import validity

pytest.importorskip("flint")

from hoopgen import Event
from hoopgen.judge import earliest, flight
from tests.derive.rolling import test_jump, test_successor
from tests.helpers.checked_faults import OfEngine, OfFormulas, Planted, cases, passing, tripping
from tests.helpers.mutants import in_decisions, in_text, in_tree
from tests.scene import (
    test_edges,
    test_going_on,
    test_green,
    test_into_plate,
    test_starts_on_bodies,
    test_tiles,
)

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
    test_tiles.test_hops_beside_edges_of_tiles_are_rarely_uncertain, scene=test_tiles.TILES
)
at_apexes = OfEngine(
    test_tiles.test_apexes_beside_an_edge_are_those_proved_or_flagged, scene=test_tiles.GAP
)
over_wire = OfEngine(
    test_green.test_a_ball_that_the_wire_does_not_press_on_flies_over_it, scene=test_edges.GREEN
)
comes_up = OfEngine(
    test_green.test_a_ball_that_comes_up_again_goes_back_where_it_came_from,
    scene=test_edges.GREEN,
)
straight = OfEngine(
    test_green.test_straight_putts_leave_the_wire_as_those_a_micrometre_aside,
    scene=test_edges.GREEN,
)
into_plate = OfEngine(
    test_into_plate.test_a_ball_on_a_plate_that_is_thrown_into_it_meets_it_at_once,
    scene=test_into_plate.WEDGE,
)
starts = {
    test.__name__.removeprefix("test_"): OfEngine(test, given, scene=scene)
    for test, scene, given in (
        (
            test_starts_on_bodies.test_a_ball_that_starts_on_a_body_rolls_at_once,
            test_starts_on_bodies.TABLE,
            ((),),
        ),
        (
            test_starts_on_bodies.test_a_ball_that_starts_from_a_wall_is_certain,
            test_starts_on_bodies.TABLE,
            ((),),
        ),
        (
            test_starts_on_bodies.test_a_small_hop_from_a_body_lasts_as_long_wherever_it_starts,
            test_starts_on_bodies.FUNNEL,
            ((-1e-13,), (1e-13,)),
        ),
        (
            test_starts_on_bodies.test_a_ball_leaves_the_surface_of_a_body_that_it_touches,
            test_starts_on_bodies.FUNNEL,
            (("outside",), ("inside",), ("edge",)),
        ),
        (
            test_starts_on_bodies.test_a_ball_rolls_at_once_whatever_the_last_digits_of_its_place,
            test_starts_on_bodies.CURVED,
            (("pipe", 2.0),),
        ),
    )
}
from_behind = OfEngine(
    test_starts_on_bodies.test_a_ball_that_touches_a_table_from_behind_is_uncertain,
    given=(("numpy",),),
    scene=test_starts_on_bodies.TABLE,
)
off_body = OfEngine(
    test_starts_on_bodies.check_balls_off_a_body,
    given=((test_starts_on_bodies.drops(60),),),
    scene=test_starts_on_bodies.FUNNEL,
)
behind_shell = OfEngine(
    test_starts_on_bodies.check_balls_behind_a_shell, scene=test_starts_on_bodies.SHELL
)
after_impact = OfFormulas(test_going_on.check_the_judge_of_records, ((Event.IMPACT,),))
after_leave = OfFormulas(test_going_on.check_the_judge_of_records, ((Event.LEAVE,),))
over_seam = OfFormulas(test_going_on.test_the_judge_has_a_ball_leave_a_face_over_its_seam)
unpressed = OfEngine(
    test_going_on.test_a_contact_without_restitution_where_nothing_presses_the_ball_on_is_undecided,
    given=((0.6,), (math.inf,)),
    scene=test_going_on.SHAPES,
)
tiny_hops = OfEngine(
    test_going_on.test_the_time_of_a_tiny_hop_from_a_start_is_within_its_error,
    given=(("ring", (4.52, 0, 0.16), (0.6, 0, 0.8)),),
    scene=test_going_on.SHAPES,
)
on_edge = OfFormulas(
    test_jump.test_at_an_edge_the_velocity_is_off_by_the_change_of_the_force_times_the_delay,
)
on_entry = OfFormulas(test_jump.test_a_ball_comes_over_a_bound_as_late_as_its_errors_say)
on_jump = OfFormulas(
    test_jump.test_what_the_jump_leaves_out_is_within_the_errors_that_it_adds,
)
on_level_jump = OfFormulas(
    test_jump.test_on_a_level_plane_a_jump_without_slip_adds_roundings_alone,
)
on_return = OfFormulas(
    test_tiles.test_the_delay_of_a_return_holds_for_every_velocity_within_its_error
)

at_bound = OfFormulas(
    test_successor.test_a_ball_that_is_outside_a_bound_by_roundings_is_taken_over_nearly,
    cases(test_successor.test_a_ball_that_is_outside_a_bound_by_roundings_is_taken_over_nearly),
)


def without(kernel: str) -> Any:
    """Take an evaluation of a kernel out of the event loop."""
    return in_tree(lambda n: () if isinstance(n, Call) and n.kernel.name == kernel else (n,))


FAULTS = (
    Planted(
        "a ball that touches a plate and moves into it may be behind it",
        in_text(contact_phase, "departure_kernels", "Choose(met_at_once, 0, met)", "met"),
        into_plate,
    ),
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
        in_text(meeting, "_meets", "defers = all_of(continues", "defers = all_of(false, continues"),
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
        in_text(plane.PlaneSearch, "nodes", "if self.returns and not asked:", "if False:"),
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
        in_text(plane, "returning_margin", "* horizon)", "* horizon / 64)"),
        on_return,
    ),
    Planted(
        "a ball does not lag behind while it slips in its last bounces",
        in_text(jump, "_errors_of_bounces", "4 * rolling_friction * hop**2", "0 * hop**2"),
        on_jump,
    ),
    Planted(
        "a slip that is left makes no lag",
        in_text(
            jump,
            "_errors_of_bounces",
            "4 * barrier(ball.friction_share * slip) * hop",
            "0 * slip * hop",
        ),
        on_jump,
    ),
    Planted(
        "a ball that lags rolls on at the same velocity",
        in_text(jump, "_errors_of_bounces", "4 * turns * lag", "0 * turns * lag"),
        on_jump,
    ),
    Planted(
        "the height of the last bounces changes no velocity",
        in_text(
            jump, "_errors_of_bounces", "barrier(2 * pulls + 4 * turns**2)", "barrier(0 * turns)"
        ),
        on_jump,
    ),
    Planted(
        "the height of the last bounces is no error",
        in_text(jump, "_errors_of_bounces", "place + height * absolute(n)", "place"),
        on_level_jump,
    ),
    Planted(
        "the jump is off by the tolerance, whatever the last bounce",
        in_text(contact_phase, "jump_kernels", "if bounded", "if False"),
        on_level_jump,
    ),
    Planted(
        "a surface that takes a ball over presses it on as the one before",
        in_text(edges, "_edge_errors", "Choose(flies, fall, b)", "Choose(flies, fall, a)"),
        on_edge,
    ),
    Planted(
        "a ball that comes over a bound is there in time",
        in_text(meeting, "entering", "-bound_shift / bound_rate", "0 * bound_rate"),
        on_entry,
    ),
    Planted(
        "a ball that is late at an edge has the velocity of one that is not",
        in_text(edges, "_edge_errors", "error + rate * edge_shift", "error"),
        on_edge,
    ),
    Planted(
        "a ball that is late at an edge is so in the direction of the errors alone",
        in_text(edges, "_edge_errors", "edge_delay / 16", "0 * edge_delay"),
        on_edge,
    ),
    Planted(
        "a ball that moves along a bound comes in over it for certain",
        in_text(meeting, "entering", "AtMost(size, near_enough), Not(steep)", "false, Not(steep)"),
        on_entry,
    ),
    Planted(
        "a surface that does not press a ball on keeps it",
        in_text(
            edges, "_edge_errors", "Or(Less(successor, 0), AtMost(press, 0))", "Less(successor, 0)"
        ),
        on_edge,
    ),
    Planted(
        "a ball on a ring comes in over no bound",
        without("entering_bound"),
        comes_up,
    ),
    Planted(
        "a ball holds on to a wire that does not press it on",
        in_text(events, "_leaving_force", "if edges:", "if False:"),
        over_wire,
    ),
    Planted(
        "a ball that a wire throws off is free for as long as its third derivative alone says",
        in_text(
            contact_phase,
            "departure_kernels",
            "maximum(opening, thrown_off) if edges or oblique else opening",
            "opening",
        ),
        straight,
    ),
    Planted(
        "a ball that starts on a body is in flight",
        without("started_on_surface"),
        starts["a_ball_that_starts_on_a_body_rolls_at_once"],
    ),
    Planted(
        "a start on a body is a contact with it",
        in_text(
            contact_phase,
            "start_kernels",
            'all_of(Boolean("touches"), Not(starts))',
            'Boolean("touches")',
        ),
        starts["a_ball_that_starts_on_a_body_rolls_at_once"],
    ),
    Planted(
        "a ball that starts off a body is not put onto it",
        without("placed_at_start"),
        starts["a_ball_rolls_at_once_whatever_the_last_digits_of_its_place"],
    ),
    Planted(
        "a ball is put onto a body as if its normal were a unit vector off it",
        in_text(contact_phase, "start_kernels", "barrier(gap * per)", "gap"),
        starts["a_ball_rolls_at_once_whatever_the_last_digits_of_its_place"],
    ),
    Planted(
        "a ball that starts with a speed off a body is undecided about its weight on it",
        in_text(contact_phase, "_results", "Or(nearly, Not(starts))", "Or(nearly, Not(false))"),
        starts["a_ball_that_starts_from_a_wall_is_certain"],
    ),
    Planted(
        "a body has as many surfaces as those before it",
        in_text(validity, "left_surface", "surface, last + offset", "surface, last"),
        starts["a_small_hop_from_a_body_lasts_as_long_wherever_it_starts"],
    ),
    Planted(
        "a ball leaves the first surface of a body, whichever it touches",
        in_text(validity, "_nearest", "IfLess(away, least, face, nearest)", "nearest"),
        starts["a_ball_leaves_the_surface_of_a_body_that_it_touches"],
    ),
    Planted(
        "a ball may be inside other surfaces of the body that it leaves",
        in_text(validity, "left_surface", "sp.Rational(len(own), 2)", "sp.Rational(1, 2)"),
        starts["a_ball_leaves_the_surface_of_a_body_that_it_touches"],
    ),
    Planted(
        "a ball may be put through the table that it starts behind",
        in_text(validity, "_with_surface", "IfAtMost(distance, far, undecided, 1)", "undecided"),
        from_behind,
    ),
    Planted(
        "a ball may be off the surface that it leaves, where none puts it on",
        in_text(validity, "_with_surface", "if not is_put_on:", "if False:"),
        off_body,
    ),
    Planted(
        "a ball is on a body where the largest of distance, thickness and bounds is zero",
        in_text(validity, "_with_surface", "IfAtMost(distance, slack,", "IfAtMost(0, slack,"),
        behind_shell,
    ),
    Planted(
        "a ball is on a body also beyond its bounds",
        in_text(
            validity, "_with_surface", "IfAtMost(overlap, rounding, undecided, 1)", "undecided"
        ),
        behind_shell,
    ),
    Planted(
        "a ball is on all surfaces of the body that it leaves",
        in_text(validity, "_with_surface", "if several:  #", "if False:  #"),
        off_body,
    ),
    Planted(
        "bounces end with the errors before the contact",
        in_text(stages, "settled", ', Call(common["error_bounds"])]', "]"),
        unpressed,
    ),
    Planted(
        "whether a ball without a bounce is pressed on is sure",
        in_text(settling, "settling", "                        undecided_press,\n", ""),
        unpressed,
    ),
    Planted(
        "the judge takes roundings of a velocity along a body for one into it",
        in_text(flight, "put_on", "if not _is_small(outward,", "if True or not _is_small(outward,"),
        after_impact,
    ),
    Planted(
        "the judge takes roundings of a force that has vanished for one onto the body",
        in_text(flight, "put_on", "DEPARTS if opens > 0 else 2", "2"),
        after_leave,
    ),
    Planted(
        "the judge has a ball that leaves a part of a box touch it again",
        in_text(
            earliest,
            "arrival_at",
            "if stays_in(surface.region,",
            "if True or stays_in(surface.region,",
        ),
        over_seam,
    ),
    Planted(
        "a return that is not certain is as late as where its search stands",
        in_decisions(predicates, "Or(certain, all_of(Less(0, leaving), Less(rate, 0)))", "certain"),
        tiny_hops,
    ),
    Planted(
        "a surface takes no ball over nearly",
        in_text(edges, "_successor", "any_of(unclear, nearly,", "any_of(unclear,"),
        at_bound,
    ),
    Planted(
        "a ball is nearly within a bound however far outside it is",
        in_text(edges, "_successor", "AtMost(outside_distance, near_enough), ", ""),
        at_bound,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
