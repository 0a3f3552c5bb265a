"""Deliberate faults in rolls on tori in the coordinates of the scene: each trips a test by name."""

from __future__ import annotations

import pytest
from hoopgen.derive.events.polynomial import PolynomialRootFinder
from hoopgen.derive.motion import rolling_series
from hoopgen.derive.rolling import contact_phase
from hoopgen.derive.surfaces import oblique_torus

pytest.importorskip("flint")

from tests.helpers.checked_faults import OfEngine, OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.scene import test_torus_rolls

pytestmark = [pytest.mark.xdist_group("torus_roll_mutations"), pytest.mark.slow]

on_torus = OfEngine(
    test_torus_rolls.test_rolls_on_a_torus_are_those_of_a_second_formulation,
    given=((1,),),
    scene=test_torus_rolls.TORI,
)
after_roll = OfEngine(
    test_torus_rolls.test_a_ball_that_has_left_a_torus_does_not_come_through_it,
    given=((3,),),
    scene=test_torus_rolls.TORI,
)
into_hole = OfEngine(
    test_torus_rolls.test_a_ball_rolls_into_a_hole_that_is_not_at_the_origin_as_into_one_that_is,
    scene=test_torus_rolls.HOLE,
)
turning = OfFormulas(
    test_torus_rolls.test_the_normal_of_a_torus_turns_no_faster_than_its_bound_says
)

FAULTS = (
    Planted(
        "the direction away from the axis stays within a step",
        in_text(rolling_series, "_around_axis", "new * scale for", "0 * new for"),
        on_torus,
    ),
    Planted(
        "the normal of a torus turns as if the circle in its middle were wider by a 64th",
        in_text(
            oblique_torus,
            "toroidal",
            "-ring_radius * per_tube",
            "-65 * ring_radius * per_tube / 64",
        ),
        on_torus,
    ),
    Planted(
        "a search after a roll takes the curvature of the whole flight",
        in_text(PolynomialRootFinder, "narrowed", "if not (self.flight.departs", "if not (False"),
        after_roll,
    ),
    Planted(
        "a ball on a torus comes over no bound of another body",
        in_text(
            contact_phase,
            "_contact_decisions",
            '"comes_over": all_of(Not(Equal(held, index)), one_of(held, tori))',
            '"comes_over": false',
        ),
        into_hole,
    ),
    Planted(
        "a torus is no more curved about its axis than around its wire",
        in_text(oblique_torus, "toroidal", "per_tube + per_width", "per_tube"),
        turning,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
