"""Deliberate faults in margins and guards: each trips a test that names it.

A margin keeps an error from turning a decision, and without it results are wrong so rarely that
shots do not show it. The tests call the kernels with numbers at the limit.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import pytest
from hoopgen.derive.errors import propagation
from hoopgen.derive.events import bounding_boxes, plane_filter
from hoopgen.derive.events import predicates as searching
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.events.ring.single import SinglePrecisionRing
from hoopgen.derive.rolling import contact_phase, events, settling
from hoopgen.derive.surfaces import Box
from hoopgen.derive.surfaces.oblique_box import ObliqueBox

pytest.importorskip("flint")

from tests.derive.events import test_error_budget, test_near_plates, test_own_surfaces
from tests.derive.events import test_margins_of_filters as filters
from tests.derive.rolling import test_margins_in_contact as contact
from tests.derive.surfaces import test_boxes
from tests.helpers.checked_faults import OfFormulas, OfKernels, Planted, passing, tripping
from tests.helpers.mutants import in_decisions, in_text

pytestmark = [pytest.mark.xdist_group("margin_mutations")]

EACH_BOX = ((False,), (True,))
EACH_KERNEL = (("beside_body",), ("beside_end_plane",))
EACH_ERROR = (("position_error",), ("velocity_error",))

steady = OfKernels(
    contact.test_bounces_end_for_certain_only_if_the_force_is_steady_until_they_do,
)
clearance = OfKernels(
    contact.test_bounces_end_for_certain_only_if_no_body_is_near_until_they_do,
)
beside = OfKernels(
    contact.test_beside_a_body_that_is_nearer_than_the_bounces_go_a_ball_is_undecided,
)
pressing = OfKernels(
    contact.test_a_force_is_undecided_within_the_errors_of_the_state,
    (("press",), ("lift",)),
)
last_bounce = OfKernels(
    contact.test_the_last_bounce_is_undecided_within_the_error_of_the_velocity,
)
inelastic = OfKernels(
    contact.test_without_restitution_no_error_of_the_velocity_leaves_the_last_bounce_undecided,
)
slip = OfKernels(
    contact.test_slip_that_the_bounces_may_stop_is_undecided_within_the_error_of_the_velocity,
)
friction = OfKernels(
    contact.test_whether_friction_suffices_is_undecided_within_the_error_of_the_velocity,
)
parting = OfKernels(
    contact.test_a_ball_that_starts_where_its_force_vanishes_leaves_if_the_gap_opens,
    ((1e-12, 0.5), (1e-12, 1e18)),
)
entering = OfKernels(
    contact.test_a_ball_that_starts_with_a_velocity_into_the_surface_hits_it,
)
without_bounds = OfKernels(
    contact.test_bounces_that_end_with_errors_without_bounds_are_undecided,
    (("position_error",), ("velocity_error",)),
)
assured_without_bounds = OfKernels(
    contact.test_errors_without_bounds_are_undecided_also_where_bounces_end_for_certain,
    (("position_error",), ("velocity_error",)),
)
on_seam = OfKernels(contact.test_a_ball_that_may_stay_on_a_surface_is_undecided_on_its_seam)
near_departure = OfKernels(
    contact.test_whether_the_force_at_the_start_is_one_of_roundings_is_undecided_near_the_limit,
)
along = OfKernels(
    contact.test_a_ball_that_starts_along_a_surface_has_no_last_bounce_to_decide,
)
along_at_start = OfKernels(
    contact.test_a_velocity_off_the_surface_of_roundings_is_taken_away_at_the_start,
    ((1,), (-1,)),
)
force = OfKernels(
    contact.test_a_force_near_zero_is_undecided_within_the_errors_of_the_state, EACH_ERROR
)
grazing = OfKernels(contact.test_a_surface_that_a_rolling_ball_may_graze_is_undecided, EACH_KERNEL)
delay = OfKernels(contact.test_the_delay_of_a_meeting_holds_the_error_of_the_place, EACH_KERNEL)
at_once = OfKernels(contact.test_two_events_of_a_rolling_ball_at_once_are_undecided, EACH_KERNEL)

plate_filter = OfFormulas(
    filters.test_a_ball_that_errors_bring_to_a_plate_is_not_apart_from_it,
    (((1e-3, 0.0),), ((0.0, 2e-3),)),
)
slow_beside_a_box = OfFormulas(
    filters.test_the_gap_of_a_slow_ball_beside_a_box_bends_as_free_fall_bends_it
)
turned_normal = OfKernels(
    filters.test_errors_after_an_impact_hold_a_share_of_what_the_normal_s_turn_makes
)
near_plates = OfKernels(
    test_near_plates.test_a_plate_that_a_flight_grazes_is_near,
    (("backboard", 0.0), ("bridge", 0.0), ("backboard", 1e-3), ("bridge", 1e-3)),
)
windows = OfFormulas(
    test_own_surfaces.test_errors_are_small_whenever_the_true_ball_is_in_the_box,
    (((0, 0, -1), False), ((1, 0, 0), True)),
)

in_settling = partial(in_text, settling, "settling")
in_force = partial(in_text, settling, "_undecided_force")
in_start = partial(in_text, settling, "Start")
in_surfaces = partial(in_text, events, "_other_surfaces")

turned_within = OfFormulas(
    test_boxes.test_within_a_distance_the_normal_of_a_box_turns_no_more_than_its_bound, EACH_BOX
)
turned_by_error = OfFormulas(
    test_boxes.test_an_error_of_the_place_turns_the_normal_of_a_box_no_more_than_is_carried,
    EACH_BOX,
)
turned_by_flight = OfFormulas(
    test_boxes.test_a_flight_back_to_a_box_turns_the_normal_no_more_than_its_bound, EACH_BOX
)
face_normal = OfFormulas(
    test_boxes.test_on_a_face_the_normal_of_a_box_is_an_axis_whatever_the_rounding_of_the_place
)

in_double = partial(in_text, RingRootFinder)
budget = OfFormulas(
    test_error_budget.test_errors_within_the_budget_change_no_gap_by_more_than_its_margin,
    (("double",), ("single",)),
)
budget_in_single = replace(budget, given=(("single",),))
horizon = OfFormulas(
    test_error_budget.test_an_arrival_that_may_be_later_than_the_horizon_is_undecided
)

FAULTS = (
    # What a search allows for.
    Planted(
        "an error of the velocity moves no ball within the budget of a search",
        in_double("_moved_by_errors", "position_error + velocity_error * time", "position_error"),
        budget,
    ),
    Planted(
        "an error of the velocity is none of the rate of the gap",
        in_double("_exceeding", "self.reach * sped + ", ""),
        budget,
    ),
    Planted(
        "an error of the place counts half in the rate of the gap",
        in_double("_exceeding", "maximum(1, self.reach / innermost)", "sp.Rational(1, 2)"),
        budget,
    ),
    Planted(
        "a search allows for twice the place",
        in_double("excess", "- share * (", "- 2 * share * ("),
        budget,
    ),
    Planted(
        "a search in single precision allows for twice the place",
        in_text(SinglePrecisionRing, "excess", "- allowed - SPARE", "- 2 * allowed - SPARE"),
        budget_in_single,
    ),
    Planted(
        "an error of the velocity is none of the mean rate of the gap",
        in_text(
            SinglePrecisionRing,
            "excess",
            "maximum(barrier(self._moved",
            "minimum(barrier(self._moved",
        ),
        budget_in_single,
    ),
    Planted(
        "an arrival is no later than the horizon",
        in_decisions(
            searching, "out_of_budget(sp.Rational(1, 2))", "out_of_budget(sp.Rational(1, 8))"
        ),
        horizon,
    ),
    # How the bounces end.
    Planted(
        "a force that presses is steady however long the bounces last",
        in_settling(
            "constant_force = Less(barrier(3 * hop * force_change), barrier(press * left**2))",
            "constant_force = Less(0, 1)",
        ),
        steady,
    ),
    Planted(
        "the force on a ball that slips is steady however long the bounces last",
        in_settling(
            "        Less(barrier(3 * skip * force_change), barrier(firm * left**2)),\n", ""
        ),
        steady,
    ),
    Planted(
        "no body is near while the bounces last",
        in_settling("isolated = Less(barrier(way + narrow), nearest)", "isolated = Less(0, 1)"),
        clearance,
    ),
    Planted(
        "no body is near while a ball that slips bounces",
        in_settling(
            "        Less(barrier(barrier(16 * skip * speed / left) + narrow), nearest),\n", ""
        ),
        clearance,
    ),
    Planted(
        "which surface a ball touches first at the end of its bounces is sure",
        in_settling("                        all_of(stays, still, Not(isolated)),\n", ""),
        beside,
    ),
    Planted(
        "a force that hardly presses is sure",
        in_settling("                        undecided_press,\n", ""),
        pressing,
    ),
    Planted(
        "the last bounce is sure",
        in_settling("                        undecided_bounce,\n", ""),
        last_bounce,
    ),
    Planted(
        "a rounding of the speed off a surface is a bounce, also without restitution",
        in_settling("Less(0, barrier(e * bounce))", "Less(0, bounce)"),
        inelastic,
    ),
    Planted(
        "the slip that is left is sure",
        in_settling("Less(absolute(slip - stopped), slip_error)", "false"),
        slip,
    ),
    Planted(
        "whether friction suffices is sure",
        in_settling("barrier(barrier(turns + share * turns) * slip_error)", "0"),
        friction,
    ),
    Planted(
        "a ball that starts where its contact ends is pressed on by a rounding",
        in_start("AtMost(force, force_limit)", "AtMost(0, lift)"),
        parting,
    ),
    Planted(
        "a ball leaves the body that it starts on though the gap does not open",
        in_start("all_of(self.along, Less(0, gap_jerk))", "self.along"),
        parting,
    ),
    Planted(
        "a ball parts where its force vanishes also at the end of bounces",
        in_start("Equal(mode, STARTS), AtMost(bounce, speed_limit)", "AtMost(bounce, speed_limit)"),
        parting,
    ),
    Planted(
        "a ball that starts where its contact ends settles",
        in_settling("Or(isolated, still), Not(start.departs))", "Or(isolated, still))"),
        parting,
    ),
    Planted(
        "a ball that starts where its contact ends slides",
        in_settling("all_of(slides, Not(start.departs))", "slides"),
        parting,
    ),
    Planted(
        "a ball that starts where its contact ends is undecided about the force on it",
        in_settling(
            "                    Not(start.departs),\n                ),", "                ),"
        ),
        parting,
    ),
    Planted(
        "whether a ball is pressed on has no error of the place",
        in_force("pull * position_error + speed", "speed"),
        pressing,
    ),
    Planted(
        "whether a ball is pressed on has no error of the velocity",
        in_force("+ speed * velocity_error", ""),
        pressing,
    ),
    Planted(
        "whether a ball is pressed on has no rounding",
        in_force("sp.Rational(1, 2**48) * pull", "0"),
        pressing,
    ),
    Planted(
        "whether a ball that slips is pressed on is sure",
        in_force("AtMost(absolute(lift), error)", "false"),
        pressing,
    ),
    # At the start.
    Planted(
        "a ball that starts with a velocity into its body leaves it",
        in_settling("AtMost(0, lift), Not(start.enters))", "AtMost(0, lift))"),
        entering,
    ),
    Planted(
        "a ball that starts with a velocity into its body is along it",
        in_start(", AtMost(inward, speed_limit)", ""),
        entering,
    ),
    Planted(
        "errors without bounds do not matter where bounces end",
        in_text(
            contact_phase,
            "_contact_decisions",
            "Equal(which, last), _BOUNDED",
            "Equal(which, last)",
        ),
        assured_without_bounds,
    ),
    Planted(
        "bounces end for certain with errors that have no bounds",
        in_text(contact_phase, "_results", "all_of(nearly, Not(_BOUNDED))", "false"),
        without_bounds,
    ),
    Planted(
        "a ball on a seam knows on which side of it it is",
        in_text(contact_phase, "settling_kernels", "Choose(asked, 1, uncertain)", "uncertain"),
        on_seam,
    ),
    Planted(
        "a ball has no error beside a seam",
        in_text(contact_phase, "settling_kernels", "4 * position_error + rounding", "rounding"),
        on_seam,
    ),
    Planted(
        "a ball has no rounding beside a seam",
        in_text(
            contact_phase, "settling_kernels", "4 * position_error + rounding", "4 * position_error"
        ),
        on_seam,
    ),
    Planted(
        "a ball enters its body also after a contact",
        in_start(
            "all_of(Equal(mode, STARTS), Less(speed_limit / 2, inward))",
            "Less(speed_limit / 2, inward)",
        ),
        entering,
    ),
    Planted(
        "a force at the start near the limit of roundings is sure",
        in_settling("                start.may_depart,\n", "                false,\n"),
        near_departure,
    ),
    Planted(
        "the last bounce of a ball that starts along its body is undecided",
        in_settling("        Not(start.along),\n", ""),
        along,
    ),
    Planted(
        "the velocity off the body at the start is kept",
        in_text(contact_phase, "start_kernels", "str(v): v - rounding_off * n", "str(v): v"),
        along_at_start,
    ),
    Planted(
        "a velocity along the body at the start has no error",
        in_text(contact_phase, "start_kernels", "IfLess(d, 0, -slack, slack)", "0"),
        along_at_start,
    ),
    Planted(
        "whether the velocity off the body at the start is a rounding is sure",
        in_text(contact_phase, "start_kernels", "Choose(near_limit, 1, uncertain)", "uncertain"),
        along_at_start,
    ),
    # Rolling.
    Planted(
        "a force near zero has no error of the place",
        in_text(events, "_leaving_force", "barrier(pull * position_error + ", "barrier("),
        force,
    ),
    Planted(
        "a force near zero has no error of the velocity",
        in_text(
            events,
            "_leaving_force",
            "pull * position_error + fastest * velocity_error)",
            "pull * position_error)",
        ),
        force,
    ),
    Planted(
        "a force that passes zero quickly is undecided",
        in_text(
            events,
            "_leaving_force",
            "Not(Less(barrier(8 * bends * force_error), force_rate**2))",
            "Less(0, 1)",
        ),
        force,
    ),
    Planted(
        "a body that a rolling ball grazes is sure",
        in_surfaces(
            "any_of(grazes, all_of(arrives, Not(_NO_EVENT)))", "all_of(arrives, Not(_NO_EVENT))"
        ),
        grazing,
    ),
    Planted(
        "every body that a rolling ball comes to is grazed",
        in_surfaces(
            "        Not(Less(barrier(8 * bends * near_enough), barrier(nearing**2))),\n", ""
        ),
        grazing,
    ),
    Planted(
        "a rolling ball meets a body without delay",
        in_surfaces("barrier(2 * near_enough / barrier(absolute(nearing)))", "sp.Integer(0)"),
        delay,
    ),
    Planted(
        "of two events of a rolling ball the first one looked at is sure",
        in_surfaces("any_of(grazes, all_of(arrives, Not(_NO_EVENT)))", "grazes"),
        at_once,
    ),
    # Filters, windows, and bounds of curvature.
    Planted(
        "a plate is as far as the computed ball has it",
        in_text(plane_filter, "_apart", "yield Less(slack, (low", "yield Less(0, (low"),
        plate_filter,
    ),
    Planted(
        "the circle that a plate leaves out is as wide as for a ball without errors",
        in_text(plane_filter, "_inside", "barrier(radius - 2 * slack)", "barrier(radius)"),
        plate_filter,
    ),
    Planted(
        "the velocity's error does not widen a flight's boxes",
        in_text(bounding_boxes, "path_slack", " + velocity_error * horizon", ""),
        near_plates,
    ),
    Planted(
        "the boxes of a flight's halves have the size of their chords",
        in_text(bounding_boxes, "half_flight_boxes", " + absolute(bulge)", ""),
        near_plates,
    ),
    Planted(
        "errors may be as large as the inflation of the windows",
        in_text(
            test_own_surfaces, "lost", "RELATIVE_INFLATION / 4 * half", "RELATIVE_INFLATION * half"
        ),
        windows,
    ),
    Planted(
        "the velocity's error counts for a sixteenth of the time in the windows",
        in_text(
            test_own_surfaces, "lost", "velocity_error * latest", "velocity_error * latest / 16"
        ),
        windows,
    ),
    Planted(
        "free fall bends the gap of a box by a quarter",
        in_text(
            BoxRootFinder,
            "_pull_bound",
            "most.append(absolute(a) * minimum",
            "most.append(absolute(a) / 4 * minimum",
        ),
        slow_beside_a_box,
    ),
    Planted(
        "an error of the normal changes no velocity in the worst case",
        in_text(
            propagation,
            "before_impact",
            "ball_radius * greatest(dw) + speed * turn",
            "ball_radius * greatest(dw)",
        ),
        turned_normal,
    ),
    # The turn of a box's normal.
    Planted(
        "an error does not turn the normal of a box at an edge",
        in_text(Box, "curvature", "1 / self.radius", "0 / self.radius"),
        turned_by_error,
    ),
    Planted(
        "an error beside the edge of a face does not reach over it",
        in_text(propagation, "normal_error", "DECISION_FACTOR * shift", "0 * shift"),
        turned_by_error,
    ),
    Planted(
        "a ball is on the face of a box wherever its flight began",
        in_text(propagation, "curving_along", "flight.path_lengths()", "[0, 0, 0]"),
        turned_by_flight,
    ),
    Planted(
        "a ball whose place is off is on the face of a box where it seems to be",
        in_text(propagation, "curving_along", "way + off", "way"),
        turned_by_flight,
    ),
    Planted(
        "a turned box's face goes as far as its largest projection",
        in_text(ObliqueBox, "_shares", "absolute(entry)", "entry"),
        turned_within,
    ),
    Planted(
        "the normal of a face is as long as the ball's distance from it",
        in_text(Box, "_length", "barrier(maximum(away, self.scaled_radius / 2))", "self.radius"),
        face_normal,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
