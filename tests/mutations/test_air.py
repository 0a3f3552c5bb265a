"""Deliberate faults in the pieces of flights through air: each trips a test by name."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hoopgen.derive import model
from hoopgen.derive.events.air import AirRootFinder
from hoopgen.derive.motion.air import AirFlight

from tests.derive.motion import test_air
from tests.helpers.mutants import Patch, in_property, in_text

pytestmark = [pytest.mark.xdist_group("air_mutations")]

FAULTS: dict[str, tuple[Patch, Callable[[], None]]] = {
    "what a piece leaves out counts half of its integral, and the roundings nothing": (
        in_text(
            AirFlight, "piece", "truncated / (last + 1) + unrounded", "truncated / (last + 1)**3"
        ),
        test_air.test_the_error_of_a_piece_is_within_its_bound_and_the_bound_is_not_useless,
    ),
    "the box of a path has no size where it is held against a plane": (
        in_property(AirRootFinder, "_least_gap", "barrier(reach) * (1 + BUDGET)", "0"),
        test_air.test_a_piece_that_stays_on_one_side_of_the_end_s_plane_is_clear_of_it_and_no_other_is,
    ),
}
