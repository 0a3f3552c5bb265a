"""Deliberate faults in the bounds of points of contact on which balls roll: each trips a test."""

from __future__ import annotations

import pytest
from hoopgen.derive.rolling import bounds, stages, surface_nodes
from hoopgen.derive.surfaces import ObliqueBox
from hoopgen.derive.surfaces.box import Box
from hoopgen.derive.surfaces.cone import Cone

pytest.importorskip("flint")

from tests.derive.rolling import test_seams
from tests.helpers.checked_faults import OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.scene import test_bounds_in_contact

pytestmark = pytest.mark.xdist_group("bounded_roll_mutations")


def of_formulas(test: object, *given: tuple[str, int]) -> OfFormulas:
    """Return the check that calls a test of kernels, which are derived anew."""
    return OfFormulas(test, given=given)  # type: ignore[arg-type]


bends = of_formulas(
    test_bounds_in_contact.test_the_distance_within_a_bound_bends_no_more_than_its_bound_says,
    ("funnel", 1),
)
sign = of_formulas(
    test_bounds_in_contact.test_the_distance_within_a_bound_has_its_sign_and_is_no_more_than_the_way,
    ("funnel", 2),
    ("spike", 1),
    ("crate", 0),
)
beside_box = of_formulas(
    test_bounds_in_contact.test_a_ball_beside_a_box_is_outside_a_bound_for_as_long_as_is_claimed,
    ("slab", 0),
)
beside_turned_box = of_formulas(
    test_bounds_in_contact.test_a_ball_beside_a_box_is_outside_a_bound_for_as_long_as_is_claimed,
    ("crate", 0),
)
seams_beside = OfFormulas(
    test_seams.test_each_bound_of_a_box_beside_a_ball_is_decided_with_the_seam_that_is_nearest
)
seams_below = OfFormulas(test_seams.test_each_seam_of_the_box_under_a_ball_is_decided)

FAULTS = (
    Planted(
        "a bound of the point of contact is one of the ball's centre",
        in_text(bounds, "_at_contact", "zip(POSITION, path.place", "zip(POSITION, POSITION"),
        sign,
    ),
    Planted(
        "the point of contact moves as the ball's centre does",
        in_text(
            bounds,
            "_at_contact",
            "directional(place, along) for place in path.place",
            "v for v in VELOCITY",
        ),
        bends,
    ),
    Planted(
        "the point of contact on a cone is on the other side of it",
        in_text(Cone, "nearest_point", "place - barrier", "place + barrier"),
        sign,
    ),
    Planted(
        "the point of contact moves no faster than the ball's centre",
        in_text(bounds, "_at_contact", "barrier(path.stretch)", "sp.Integer(1)"),
        sign,
    ),
    Planted(
        "beside a box a bound changes as before past a seam",
        in_text(bounds, "outside", "barrier(crease / speed)", "sp.oo"),
        beside_box,
    ),
    Planted(
        "the nearest point of a box moves in all directions",
        in_text(Box, "_rates", "barrier(1 - bent) * v", "v"),
        beside_box,
    ),
    Planted(
        "the nearest point of a turned box moves along the axes of the scene",
        in_text(ObliqueBox, "_rates", "in times(self._unit_axes, own)", "in own"),
        beside_turned_box,
    ),
    Planted(
        "a bound of a box beside a ball is decided without its seams",
        in_text(stages, "outside", "if creased", "if False"),
        seams_beside,
    ),
    Planted(
        "a bound of a box beside a ball is decided as that of any other surface",
        in_text(stages, "outside", 'one.replace("outside_bound", "outside_bound_of_box")', "one"),
        seams_beside,
    ),
    Planted(
        "only the first seam of the box under a ball is decided",
        in_text(
            surface_nodes,
            "seams_of",
            "if part.startswith",
            "if part[-1] == '0' and part.startswith",
        ),
        seams_below,
    ),
    Planted(
        "no seam of the box under a ball is near as its bounces end",
        in_text(surface_nodes, "_own_borders", 'if "near_seam" in common', "if False"),
        seams_below,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
