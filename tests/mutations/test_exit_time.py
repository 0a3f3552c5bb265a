"""Deliberate faults in where a search without bounds ends, or does not begin: each trips a test."""

from __future__ import annotations

import pytest
import sympy as sp
from hoopgen.derive.events import box_windows, polynomial
from hoopgen.derive.surfaces import Cylinder

from hoopgen.scene.derivation import _Builder
from hoopgen.scene.revolution_faces import _Faces
from tests.derive.events import test_clear_distance, test_exit_time
from tests.helpers.checked_faults import OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.scene import test_furthest

pytestmark = pytest.mark.xdist_group("exit_time_mutations")

exit_time = OfFormulas(
    test_exit_time.test_after_it_the_true_ball_is_further_off_with_all_errors_one_way,
    (("down",), ("any",)),
)

clear = OfFormulas(
    test_clear_distance.test_no_flight_that_is_passed_over_is_as_long_as_the_distance
)


def contacts(body: str) -> OfFormulas:
    """Return the test of how far the contacts with a body are from its reference point."""
    return OfFormulas(test_furthest.test_no_contact_is_further_off_than_is_known, ((body,),))


FAULTS = (
    Planted(
        "a falling ball has left for good in a quarter of the time",
        in_text(
            box_windows,
            "_latest",
            "time_to_leave(barrier(far + half), per_g)",
            "time_to_leave(barrier(far + half), per_g) / 4",
        ),
        exit_time,
    ),
    Planted(
        "a ball without gravity has left for good when it has flown half of the distance",
        in_text(box_windows, "_latest", "2 * far / absolute(v)", "far / absolute(v) / 2"),
        exit_time,
    ),
    Planted(
        "errors may be as large as the distance at which a ball is too far off",
        in_text(
            test_exit_time,
            "exit_time",
            "RELATIVE_INFLATION / 4 * distance",
            "64 * distance",
        ),
        exit_time,
    ),
    Planted(
        "contacts with a cone are as near to its apex as if it were a quarter as long",
        in_text(_Builder, "_cone", "+ to_apex) * per_height", "+ to_apex) * per_height / 4"),
        contacts("cone"),
    ),
    Planted(
        "contacts with a cylinder are as far off as its centre is from that point of the axis",
        in_text(_Builder, "_oblique_cylinder", "radius + maximum(*ends) + ", ""),
        contacts("tube"),
    ),
    Planted(
        "contacts with a piece of a profile are a quarter as far off",
        in_text(_Faces, "_furthest", "maximum(*far) + self._ball", "maximum(*far) / 4"),
        contacts("bowl"),
    ),
    Planted(
        "a cylinder is half as long",
        in_text(Cylinder, "half_sizes", "self._span[0]) / 2", "self._span[0]) / 4"),
        contacts("pipe"),
    ),
    Planted(
        "the distance of a surface that a flight does not reach has no roundings",
        lambda patch: patch.setattr(polynomial, "_CLEAR_SLACK", 0),
        clear,
    ),
    Planted(
        "a flight reaches a surface that is a millionth of all lengths further off",
        lambda patch: patch.setattr(polynomial, "_CLEAR_SLACK", sp.Rational(1, 2**20)),
        clear,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
