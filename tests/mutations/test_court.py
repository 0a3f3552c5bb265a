"""Deliberate faults in what `COURT` has beside the article's hoop; each trips a test by name.

Rolling on the ring and over edges, the events of a rolling ball, departure, endless rolling, plates
and their bounding boxes, friction, the passage through the ring, single precision's pads.
"""

from __future__ import annotations

from functools import partial
from itertools import product
from types import ModuleType

import pytest
from hoopgen.derive.contact import friction
from hoopgen.derive.contact.ball import Ball
from hoopgen.derive.events import bounding_boxes, box
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.events.ring.single import MAX_STEPS, SinglePrecisionRing
from hoopgen.derive.motion import rolling_series
from hoopgen.derive.motion.ring_rolling_series import RingRolling
from hoopgen.derive.rolling import contact_phase, endless, events, neighbour, settling
from hoopgen.derive.scenes import passage, validity
from hoopgen.derive.surfaces import Box

pytest.importorskip("flint")

from tests.derive.contact import test_friction
from tests.derive.events import test_bounding_boxes, test_near_plates, test_separation
from tests.derive.rolling import test_contact_phase, test_endless, test_settling, test_steps
from tests.derive.scenes import test_passage, test_passage_edge, test_start_outside
from tests.helpers.checked_faults import (
    OfFormulas,
    OfKernels,
    Planted,
    WithKernels,
    cases,
    passing,
    tripping,
)
from tests.helpers.mutants import in_text
from tests.helpers.past_ring import complaints

pytestmark = [pytest.mark.xdist_group("court_mutations")]

ROLLING = test_contact_phase.__name__, "court"
STEPS = test_steps.__name__, "court"


# ------------------------------------------------------------------------------------- the checks


def no_search_in_single_precision_passes_a_root(kernels: ModuleType) -> None:
    """Hold the ring's search in single precision against the flights themselves."""
    assert complaints(kernels, MAX_STEPS) == []


leaves = OfKernels(
    test_contact_phase.test_a_ball_leaves_the_ring_when_and_where_it_should,
    test_contact_phase.LEAVES,
)
from_rest = OfKernels(
    test_contact_phase.test_from_rest_it_leaves_at_six_elevenths_of_the_height, ((100.0,),)
)
energy = OfKernels(
    test_contact_phase.test_energy_stays_over_a_second_of_rolling,
    tuple((start,) for start in test_contact_phase.SWIRLS[1:]),
)
routh = OfKernels(
    test_contact_phase.test_routh_s_equations_are_linear_in_the_angle,
    ((test_contact_phase.SWIRLS[2],),),
)
bounds = OfKernels(
    test_steps.test_speed_acceleration_and_force_stay_within_a_step_s_bounds,
    tuple((k,) for k in range(7)),
    named=(ROLLING, STEPS),
)
over_an_edge = OfKernels(
    test_steps.test_energy_and_the_distance_from_the_edge_stay,
    tuple((start,) for start in test_steps.EDGES),
    named=(ROLLING, STEPS),
)
force_on_an_edge = OfKernels(
    test_steps.test_the_normal_force_is_what_the_edge_presses_with,
    tuple((start,) for start in test_steps.EDGES),
    named=(ROLLING, STEPS),
)
force_ends = OfKernels(
    test_steps.test_no_step_passes_the_end_of_the_normal_force, ((3,),), named=(ROLLING, STEPS)
)
to_the_bridge = OfKernels(
    test_steps.test_no_step_goes_into_another_body,
    tuple((start,) for start in test_steps.TO_THE_BRIDGE),
    named=(ROLLING, STEPS),
)
curved = OfKernels(
    test_steps.test_no_bound_below_the_distance_is_passed_where_a_surface_curves_towards_the_ball
)
departs = OfKernels(
    test_steps.test_a_ball_that_departs_is_off_the_ring_for_as_long_as_is_said,
    test_steps.DEPARTURES,
    named=(ROLLING, STEPS),
)
departs_alone = OfKernels(
    test_steps.test_a_ball_that_departs_meets_no_other_body_meanwhile, named=(ROLLING, STEPS)
)
errors = OfKernels(
    test_steps.test_errors_after_a_step_are_those_of_a_motion_that_begins_with_them,
    ((2,), (5,)),
    named=(ROLLING, STEPS),
)
last_bounce = OfKernels(
    test_contact_phase.test_without_errors_a_bounce_is_looked_at_when_it_may_be_the_last
)
for_ever = OfKernels(
    test_contact_phase.test_rolling_for_ever_takes_two_turning_points_room_and_being_pressed_on
)
turning_points = OfKernels(
    test_endless.test_the_proof_takes_a_whole_swing_that_is_safe,
    named=(ROLLING, (test_endless.__name__, "court")),
)
every_azimuth = OfKernels(
    test_contact_phase.test_no_place_at_any_azimuth_is_nearer_than_the_bound_says
)
half_a_step = OfKernels(
    test_endless.test_the_bound_at_any_azimuth_holds_for_half_a_step,
    named=(ROLLING, (test_endless.__name__, "court")),
)
begins = OfFormulas(
    test_settling.test_a_ball_begins_to_roll_as_the_article_s_contact_without_restitution_leaves_it,
    cases(
        test_settling.test_a_ball_begins_to_roll_as_the_article_s_contact_without_restitution_leaves_it
    ),
)
newton = OfFormulas(
    test_settling.test_the_first_terms_are_newton_s_and_euler_s_with_the_contact_point_at_rest,
    cases(
        test_settling.test_the_first_terms_are_newton_s_and_euler_s_with_the_contact_point_at_rest
    ),
)
newton_on_a_ring = OfFormulas(
    test_settling.test_on_a_ring_they_are_too_in_its_own_coordinates,
    cases(test_settling.test_on_a_ring_they_are_too_in_its_own_coordinates),
)
rates_on_a_ring = OfFormulas(
    test_settling.test_on_a_ring_what_has_a_rate_of_its_own_changes_as_what_it_is_made_of
)
force_bends = OfFormulas(test_settling.test_on_a_ring_the_force_bends_no_more_than_is_said)
held_by_friction = OfFormulas(
    test_settling.test_what_ends_with_friction_is_what_the_gap_of_a_flight_lacks
)
near_plates = OfKernels(
    test_near_plates.test_a_plate_that_a_flight_grazes_is_near,
    (("backboard", 0.0), ("bridge", 0.0), ("backboard", 1e-3), ("bridge", 1e-3)),
)
PLATES_AND_ERRORS = tuple(product(test_separation.PLATES, test_separation.ERRORS))
comes_back = OfKernels(
    test_separation.test_a_ball_that_comes_back_to_the_plate_it_left_approaches_it,
    PLATES_AND_ERRORS,
)
slow_return = OfKernels(
    test_separation.test_a_ball_whose_velocity_is_within_its_error_may_come_back
)
within_error = OfKernels(test_separation.test_a_ball_within_its_error_of_a_plate_may_touch_it)
may_come_back = OfKernels(test_separation.test_where_an_arrival_may_be_late_a_ball_may_come_back)
late_arrival = OfKernels(test_bounding_boxes.test_where_an_arrival_may_be_late_every_plate_is_near)
impact_followed = OfFormulas(
    test_friction.test_the_impact_followed_over_its_impulse_ends_where_the_law_says
)
check_values = OfFormulas(
    test_friction.test_numbers_found_in_high_precision_elsewhere,
    cases(test_friction.test_numbers_found_in_high_precision_elsewhere),
)
article = OfFormulas(
    test_friction.test_it_is_the_articles_law_where_every_contact_grips_and_nothing_falls
)
restitution_falls = OfFormulas(
    test_friction.test_the_normal_velocity_is_restored_by_a_restitution_that_falls_with_it
)
branch_derivative = OfFormulas(
    test_friction.test_errors_are_carried_by_the_derivative_of_the_branch_that_is_taken
)
passings = OfKernels(
    test_passage.test_the_kernel_finds_what_more_digits_find_or_is_undecided,
    named=((test_passage.__name__, "kernels"),),
)
passings_with_errors = OfKernels(
    test_passage.test_what_errors_of_a_state_turn_is_undecided,
    ((1e-9,), (1e-6,)),
    named=((test_passage.__name__, "kernels"),),
)
passings_at_the_edge = OfKernels(
    test_passage_edge.test_a_passing_near_the_edge_is_undecided_if_errors_turn_it,
    ((1e-12,), (1e-8,), (1e-5,)),
    named=((test_passage.__name__, "kernels"),),
)
starts_at_the_ring = OfKernels(
    test_start_outside.test_a_start_at_the_ring_is_undecided_or_what_more_digits_say,
)
single = WithKernels(no_search_in_single_precision_passes_a_root)


# ------------------------------------------------------------------------------------- the faults

in_ring = partial(in_text, RingRolling)
in_series = partial(in_text, rolling_series)

FAULTS = (
    Planted(
        "the place of the start has no rounding",
        in_text(validity, "_slack", "16 * UNIT_ROUNDOFF", "0 * UNIT_ROUNDOFF"),
        starts_at_the_ring,
    ),
    # Rolling on the ring: Routh's equations as a series.
    Planted(
        "the whole weight turns the ball around the wire",
        in_ring(
            "next_terms", "self.ball.moving_share * self.gravity * cosine", "self.gravity * cosine"
        ),
        newton_on_a_ring,
    ),
    Planted(
        "friction along the ring speeds the ball up",
        in_ring(
            "next_terms",
            "- self.ball.friction_share * product(climb, s)",
            "+ self.ball.friction_share * product(climb, s)",
        ),
        routh,
    ),
    Planted(
        "the spin about the normal turns the other way",
        in_ring("next_terms", '"turn_rate": self.ring_radius', '"turn_rate": -self.ring_radius'),
        routh,
    ),
    Planted(
        "terms are divided by an order too much",
        in_ring("next_terms", "sp.Rational(1, k + 1)", "sp.Rational(1, k + 2)"),
        leaves,
    ),
    Planted(
        "the friction's moment forgets that the ring is round",
        in_ring("next_terms", "wide * product(around, cosine)", "wide * around[-1]"),
        rates_on_a_ring,
    ),
    Planted(
        "the azimuth turns the other way",
        in_ring("_turned", "t * barrier(horner(turns, t))", "-t * barrier(horner(turns, t))"),
        leaves,
    ),
    Planted(
        "the centrifugal force around the wire is left out",
        in_ring("pressed", "- self.reach * climb**2", ""),
        from_rest,
    ),
    Planted(
        "the centrifugal force along the ring is left out",
        in_ring("pressed", "- barrier(along * omega) * cosine", ""),
        leaves,
    ),
    Planted(
        "the rate of the normal force has the share of friction once",
        in_ring("_weights", "(3 - 2 * self.ball.friction_share)", "(3 - self.ball.friction_share)"),
        rates_on_a_ring,
    ),
    Planted(
        "the normal force bends half as much along the ring",
        in_ring("max_force_bend", "6 * self.ring_radius", "3 * self.ring_radius"),
        force_bends,
    ),
    Planted(
        "the ball's velocity on the ring has no part up",
        in_ring("moved", "over * cosine),", "over * sine),"),
        energy,
    ),
    Planted(
        "the acceleration back to the ring's axis is left out",
        in_ring("_quickened", "- back * cosine - along * omega", "- back * cosine"),
        newton_on_a_ring,
    ),
    Planted(
        "steps on the ring are eight times as long",
        in_ring(
            "step",
            "_twelfth_root(LAST_TERM_TOLERANCE * scale / last)",
            "8 * _twelfth_root(LAST_TERM_TOLERANCE * scale / last)",
        ),
        energy,
    ),
    Planted(
        "the acceleration along the ring has no bound",
        in_ring("step", "swaying + barrier(quickens + fastest * omega)", "swaying"),
        bounds,
    ),
    Planted(
        "the largest speed on the ring is that along it",
        in_ring("step", "barrier(self.reach * climb + along)", "along"),
        bounds,
    ),
    # Rolling on all else.
    Planted(
        "a rolling ball falls freely along the surface",
        in_series("next_terms", "ball.moving_share * a if order == 0", "a if order == 0"),
        newton,
    ),
    Planted(
        "the spin about the normal pushes the other way",
        in_series(
            "next_terms",
            "+ ball.friction_share * product(s, m_i)",
            "- ball.friction_share * product(s, m_i)",
        ),
        newton,
    ),
    Planted(
        "the spin about the normal stays",
        in_series("next_terms", "-barrier(spun) * scale", "0 * barrier(spun) * scale"),
        over_an_edge,
    ),
    Planted(
        "normals of higher order turn too slowly",
        in_series("next_terms", "[*(k * n_i[k] for k", "[*(n_i[k] for k"),
        over_an_edge,
    ),
    Planted(
        "the normal force has no share of friction",
        in_series("force", "- ball.friction_share * fall", "- 0 * fall"),
        force_on_an_edge,
    ),
    Planted(
        "the acceleration on an edge is bounded without its first term",
        in_series(
            "step", "for k in range(ORDER)))\n    forces", "for k in range(1, ORDER)))\n    forces"
        ),
        bounds,
    ),
    Planted(
        "the normal force on an edge bends half as much",
        in_series("step", "sum(k * (k - 1) * absolute", "sum(absolute"),
        bounds,
    ),
    Planted(
        "a rolling ball is not put back onto its surface",
        in_series("placed", "p - gap * n for", "p + gap * n for"),
        over_an_edge,
    ),
    Planted(
        "every ball begins to roll as a shell does",
        in_text(Ball, "friction_share", "self.inertia *", "THIN_SHELL *"),
        begins,
    ),
    Planted(
        "a rolling ball spins the other way",
        in_series(
            "placed",
            "normal.cross(sp.Matrix(tangential)) + turn_rate",
            "-normal.cross(sp.Matrix(tangential)) + turn_rate",
        ),
        begins,
    ),
    Planted(
        "steps on an edge are sixteen times as long",
        in_series("step", "barrier(minimum(most, root))", "barrier(minimum(most, 16 * root))"),
        over_an_edge,
    ),
    # Events of a rolling ball.
    Planted(
        "the normal force is a straight line",
        in_text(
            events,
            "_leaving_force",
            "                    bends,\n",
            "                    0 * bends,\n",
        ),
        force_ends,
    ),
    Planted(
        "a normal force that is small is spent",
        in_text(
            events,
            "_leaving_force",
            "barrier(sp.Rational(1, 2**44) * pull)",
            "barrier(sp.Rational(1, 2**6) * pull)",
        ),
        force_ends,
    ),
    Planted(
        "friction does not hold a ball where its normal force ends",
        in_ring(
            "step",
            "2 * share * strength",
            "-2 * share * strength",
        ),
        held_by_friction,
    ),
    Planted(
        "a rolling ball moves to another body at a constant speed",
        in_text(
            events,
            "_other_surfaces",
            "barrier(strongest + gap_curvature * fastest**2)",
            "barrier(gap_curvature * fastest**2 / 2**20)",
        ),
        curved,
    ),
    Planted(
        "a surface that the ball rolls towards is flat",
        in_text(
            events,
            "_other_surfaces",
            "barrier(strongest + gap_curvature * fastest**2)",
            "barrier(strongest)",
        ),
        curved,
    ),
    Planted(
        "a body is met a micrometre before",
        in_text(
            events,
            "_other_surfaces",
            "landing = barrier(sp.Rational(1, 2**47)",
            "landing = barrier(sp.Rational(1, 2**20)",
        ),
        to_the_bridge,
    ),
    Planted(
        "the error of a place in contact hides a meeting",
        in_text(
            events,
            "_other_surfaces",
            "        + sp.Rational(1, 2**47)",
            "        + sp.Rational(1, 2**4)",
        ),
        to_the_bridge,
    ),
    # Departure.
    Planted(
        "a departure is free for the longest time",
        in_text(
            contact_phase,
            "departure_kernels",
            "barrier(minimum(longest, away, barrier(free_time / 4)))",
            "longest",
        ),
        departs_alone,
    ),
    Planted(
        "free fall does not bring a departing ball to another body",
        in_text(
            contact_phase,
            "departure_kernels",
            "barrier(strength + gap_curvature * speed**2)",
            "barrier(gap_curvature * speed**2)",
        ),
        departs_alone,
    ),
    Planted(
        "a departing ball meets what it moves away from at once",
        in_text(
            contact_phase,
            "departure_kernels",
            "first_root(barrier(maximum(gap, 0)), nearing, dipping)",
            "first_root(barrier(maximum(gap, 0)), -nearing, dipping)",
        ),
        departs_alone,
    ),
    Planted(
        "the third derivative of the gap has the opposite sign",
        in_text(contact_phase, "departure_kernels", "opening = minimum(", "opening = -minimum("),
        departs,
    ),
    # Errors in contact.
    Planted(
        "errors are scaled by another number than the neighbouring motion is",
        in_text(neighbour, "_compared", ") / scale)", ") / (2 * scale))"),
        errors,
    ),
    Planted(
        "truncation errors are forgotten",
        in_text(
            neighbour,
            "_compared",
            "off = barrier(velocity_rounding + missed)",
            "off = velocity_rounding",
        ),
        errors,
    ),
    Planted(
        "the neighbouring motion begins on the other side",
        in_text(contact_phase, "neighbour_kernels", "s + scale * d for", "s - scale * d for"),
        errors,
    ),
    # The last bounce.
    Planted(
        "bounces are looked at only where they may be the last",
        in_text(
            settling,
            "_bounce_kernels",
            "any_of(small, all_of(slow, Less(0, position_error)))",
            "small",
        ),
        last_bounce,
    ),
    Planted(
        "a bounce may be the last from a nanometre on",
        in_text(
            settling, "small_hop", "2 * tolerance(ball_radius)", "2**16 * tolerance(ball_radius)"
        ),
        last_bounce,
    ),
    Planted(
        "a ball that begins to roll keeps its slip",
        in_text(settling, "_bounce_kernels", "barrier(v - ball.friction_share * u)", "barrier(v)"),
        begins,
    ),
    # Endless rolling.
    Planted(
        "a ball that turns nowhere rolls for ever",
        in_text(
            endless,
            "_periodic",
            "turned = all_of(Less(barrier(before * climb), 0), steep)",
            "turned = Less(-1, barrier(before * climb))",
        ),
        for_ever,
    ),
    Planted(
        "one turning point proves endless rolling",
        in_text(
            endless, "_periodic", "all_of(safe, turned, Less(0, circled))", "all_of(safe, turned)"
        ),
        turning_points,
    ),
    Planted(
        "a swing that was unsafe counts",
        in_text(
            endless,
            "_periodic",
            "Choose(safe, Choose(turned, 1, circled), 0)",
            "Choose(turned, 1, circled)",
        ),
        turning_points,
    ),
    Planted(
        "endless rolling needs no room",
        in_text(endless, "_periodic", "sp.Rational(1, 2**12) * reach,\n", "-reach,\n"),
        for_ever,
    ),
    Planted(
        "endless rolling need not be pressed on",
        in_text(
            endless,
            "_periodic",
            "all_of(free, pressed, Equal(which, NONE))",
            "all_of(free, Equal(which, NONE))",
        ),
        turning_points,
    ),
    Planted(
        "the board is as far away as its nearer edge in front",
        in_text(
            Box, "azimuth_free_distance", "maximum(0, low, -high)", "maximum(0, low, high, -low)"
        ),
        every_azimuth,
    ),
    Planted(
        "at any azimuth the ball comes no nearer within a step",
        in_text(
            endless,
            "kernels",
            "barrier(nearing * half_step)",
            "barrier(absolute(nearing) * half_step)",
        ),
        half_a_step,
    ),
    # Bounding boxes of plates.
    Planted(
        "half a flight is a straight line",
        in_text(bounding_boxes, "half_flight_boxes", "barrier(a * half**2 / 16)", "sp.Integer(0)"),
        near_plates,
    ),
    Planted(
        "a flight's errors do not widen its boxes",
        in_text(bounding_boxes, "path_slack", "position_error + velocity_error * horizon + ", ""),
        near_plates,
    ),
    Planted(
        "a plate's edges are not round about the ball",
        in_text(
            box,
            "may_reach_box",
            "barrier(box.radius**2), square",
            "barrier(box.radius**2) / 2, square",
        ),
        near_plates,
    ),
    Planted(
        "the second half of a flight begins with its first velocity",
        in_text(bounding_boxes, "half_flight_boxes", "barrier(swift + a * half)", "swift"),
        near_plates,
    ),
    Planted(
        "only the first half of a flight counts",
        in_text(box, "may_reach_box", "any_of(*near)", "near[0]"),
        near_plates,
    ),
    Planted(
        "a flight is near the planes of a plate only where it starts",
        in_text(box, "may_reach_plate", "maximum(place, there)", "place"),
        near_plates,
    ),
    # Flights that move away from a box.
    Planted(
        "free fall turns a ball back half as much",
        in_text(box, "may_approach", "horizon / 2", "horizon / 4"),
        comes_back,
    ),
    Planted(
        "the end of a flight does not count, but its middle",
        in_text(box, "may_approach", "opening + turned)", "opening + turned / 2)"),
        comes_back,
    ),
    Planted(
        "errors do not turn a ball back",
        in_text(box, "may_approach", " - 4 * error", ""),
        slow_return,
    ),
    Planted(
        "a ball within its error of a box is outside of it",
        in_text(box, "may_approach", "box.radius**2 + 4 * barrier(off * length)", "box.radius**2"),
        within_error,
    ),
    Planted(
        "what moves away once has always done so",
        in_text(box, "may_approach", "any_of(AtMost(1, leaving), outside)", "AtMost(0, leaving)"),
        within_error,
    ),
    Planted(
        "a ball comes back no later than its earliest arrival",
        in_text(
            box, "may_approach", "AtMost(earliest_delay, pad)", "AtMost(earliest_delay, pad + 1)"
        ),
        may_come_back,
    ),
    Planted(
        "an arrival that may be late is not awaited",
        in_text(bounding_boxes, "path_slack", "IfLess(pad, earliest_delay, sp.oo, shift)", "shift"),
        late_arrival,
    ),
    # Friction.
    Planted(
        "grip and slip are swapped",
        in_text(
            friction.CoulombFriction,
            "_share",
            "IfAtMost(stops, barrier(met.slide**2), met.grip,",
            "IfLess(barrier(met.slide**2), stops, met.grip,",
        ),
        impact_followed,
    ),
    Planted(
        "friction acts in approach alone",
        in_text(
            friction.CoulombFriction, "_before", "(1 + restitution) * approach))", "approach))"
        ),
        check_values,
    ),
    Planted(
        "the contact point moves with the spin about the normal",
        in_text(
            friction.CoulombFriction,
            "_before",
            "tangential - ball.radius *",
            "tangential + ball.radius *",
        ),
        article,
    ),
    Planted(
        "friction turns the ball the wrong way",
        in_text(
            friction.CoulombFriction,
            "after",
            "barrier(-impulse_response",
            "barrier(impulse_response",
        ),
        impact_followed,
    ),
    Planted(
        "restitution grows with the speed",
        in_text(
            friction.CoulombFriction,
            "restitution_at",
            "barrier(1 + speed / self.falling)",
            "barrier(1 - speed / self.falling)",
        ),
        restitution_falls,
    ),
    Planted(
        "errors follow the branch that is not taken",
        in_text(
            test_friction,
            "directional",
            "derive(e.args[2]), derive(e.args[3])",
            "derive(e.args[3]), derive(e.args[2])",
        ),
        branch_derivative,
    ),
    # The passage through the ring.
    Planted(
        "a ball that rose through the ring and falls again has fallen in",
        in_text(passage, "next_state", "Choose(Equal(before, FALLEN), NEITHER, RISEN)", "NEITHER"),
        passings,
    ),
    Planted(
        "an arch above the ring is not seen",
        in_text(
            passage,
            "_disc_passings",
            "any_of(arch, And(Less(z, 0), AtMost(0, height)))",
            "And(Less(z, 0), AtMost(0, height))",
        ),
        passings,
    ),
    Planted(
        "the passing of the disc is sure at its edge",
        in_text(passage, "_astray", "any_of(undecided, sides)", "undecided"),
        passings_at_the_edge,
    ),
    Planted(
        "the apex in the disc's plane is sure",
        in_text(passage, "_astray", "any_of(starts, stops, turns)", "any_of(starts, stops)"),
        passings_with_errors,
    ),
    Planted(
        "errors do not move the time of a passing",
        in_text(passage, "_astray", "barrier(8 * off * per_g)", "barrier(8 * off * per_g) / 2**40"),
        passings_at_the_edge,
    ),
    # Pads in single precision.
    Planted(
        "the windows of height have no pad",
        in_text(
            RingRootFinder,
            "_slab_intervals",
            'barrier(16 * self.unit * barrier(sp.Abs(vz) + outer), "p_Z")',
            "-barrier(2**10 * self.unit * barrier(sp.Abs(vz) + outer))",
        ),
        single,
    ),
    Planted(
        "the windows of distance have a pad of the other sign",
        in_text(
            RingRootFinder,
            "_annulus_intervals",
            'barrier(16 * self.unit * barrier(absolute(q) + absolute(moment) + outer), "p_A")',
            "-barrier(2**10 * self.unit * barrier(absolute(q) + absolute(moment) + outer))",
        ),
        single,
    ),
    Planted(
        "a vertical flight is never in the annulus",
        in_text(
            RingRootFinder,
            "_annulus_intervals",
            "IfLess(hardly, speed_squared, last, sp.oo)",
            "IfLess(hardly, speed_squared, last, -sp.oo)",
        ),
        single,
    ),
    Planted(
        "the last window ends before the horizon",
        in_text(
            SinglePrecisionRing,
            "opened",
            "horizon * (1 + sp.Rational(1, 2**22))",
            "horizon * sp.Rational(1, 2)",
        ),
        single,
    ),
    Planted(
        "a place in the window is known to a rounding",
        in_text(
            SinglePrecisionRing,
            "grain",
            "sp.Rational(1, 2**20) * barrier(outermost + dropped)",
            "sp.Rational(1, 2**30) * barrier(outermost + dropped)",
        ),
        single,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
