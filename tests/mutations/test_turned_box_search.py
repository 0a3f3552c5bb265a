"""Deliberate faults in the search for turned boxes and in oblique gravity: each trips a test."""

from __future__ import annotations

import pytest
from hoopgen.derive.events import oblique_box, plane_start, root_finder
from hoopgen.derive.motion.flight import Flight

from tests.derive.events import test_inclined_planes, test_turned_box_search
from tests.derive.motion import test_flight
from tests.helpers.checked_faults import OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import in_text

pytestmark = pytest.mark.slow

size = OfFormulas(test_flight.test_the_size_of_gravity_is_that_of_its_vector)
margin = OfFormulas(
    test_turned_box_search.test_the_margin_of_a_turned_box_contains_errors_of_places_and_roundings
)
bend = OfFormulas(
    test_turned_box_search.test_the_gap_of_a_ball_beside_a_turned_box_bends_no_more_than_its_bound
)
along_gravity = OfFormulas(
    test_inclined_planes.test_a_plane_along_gravity_is_met_no_sooner_than_is_said
)
late = OfFormulas(
    test_inclined_planes.test_an_arrival_that_is_said_is_late_by_a_small_share_of_its_time
)

FAULTS = (
    Planted(
        "the size of gravity is that of its largest component",
        in_text(Flight, "gravity", "if self.along_axis", "if True"),
        size,
    ),
    Planted(
        "no coordinate of a ball beside a turned box is wrong",
        in_text(oblique_box._Turned, "_gap_rounding", "least)), now[e].error", "least)), 0"),
        margin,
    ),
    Planted(
        "the gap from a turned box has no share that may be wrong",
        in_text(root_finder.RootFinder, "_low_gap", "gap * (1 - self.error_share)", "gap"),
        margin,
    ),
    Planted(
        "gravity slows no ball beside a turned box",
        in_text(
            oblique_box.ObliqueBoxRootFinder, "curvature", "3 * minimum", "sp.Integer(0) * minimum"
        ),
        bend,
    ),
    Planted(
        "a ball beside a turned box stays beyond the same faces",
        in_text(
            oblique_box.ObliqueBoxRootFinder,
            "curvature",
            "IfLess(drift, absolute(e), barrier(maximum(general, local)), general)",
            "barrier(maximum(general, local))",
        ),
        bend,
    ),
    Planted(
        "roundings of gravity along a plane cause arrivals",
        lambda patch: patch.setattr(plane_start, "_VAGUE", 0),
        along_gravity,
    ),
    Planted(
        "an arrival that gravity along a plane causes is said beyond a quarter of the roundings",
        lambda patch: patch.setattr(plane_start, "_VAGUE", 2**6),
        late,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
