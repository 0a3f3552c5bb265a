"""Deliberate faults in rolls on cones: each trips a test by name."""

from __future__ import annotations

import pytest
from hoopgen.derive.motion import rolling_series
from hoopgen.derive.rolling import contact_phase
from hoopgen.derive.surfaces import Cone

pytest.importorskip("flint")

from tests.helpers.checked_faults import OfEngine, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.scene import test_cone_rolls

pytestmark = [pytest.mark.xdist_group("cone_roll_mutations"), pytest.mark.slow]

on_cone = OfEngine(
    test_cone_rolls.test_rolls_on_a_cone_are_those_of_a_second_formulation,
    given=((0,),),
    scene=test_cone_rolls.CONES,
)
to_apex = OfEngine(
    test_cone_rolls.test_a_ball_that_rolls_straight_to_the_apex_inside_ends_flagged,
    scene=test_cone_rolls.CONES,
)

FAULTS = (
    Planted(
        "a step on a cone takes the distance from the axis for constant",
        in_text(rolling_series, "_around_axis", "rising * scale", "0 * rising"),
        on_cone,
    ),
    Planted(
        "the normal turns as on a cone that is wider",
        in_text(
            Cone,
            "rolling_surface",
            "self._side * self._per_side",
            "self._side * self._per_side / 2",
        ),
        on_cone,
    ),
    Planted(
        "a step on a cone is as long as its last terms allow, also where they vanish",
        in_text(rolling_series, "step", "sp.Rational(1, 8) / swift", "sp.oo"),
        to_apex,
    ),
    Planted(
        "a roll ends nearer to the apex",
        in_text(
            contact_phase, "apex_kernels", "NEAREST_TO_AXIS * ball", "NEAREST_TO_AXIS / 8 * ball"
        ),
        to_apex,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
