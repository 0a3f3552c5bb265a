"""Deliberate faults in bounds of points of contact: each trips a test by name."""

from __future__ import annotations

import pytest
from hoopgen.derive.events import registry
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.surfaces import Box, Surface

pytest.importorskip("flint")

from tests.helpers.checked_faults import OfEngine, OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import changed, in_text
from tests.scene import test_contact_bounds
from tests.scene.test_contact_bounds import SCENES

pytestmark = [pytest.mark.xdist_group("contact_bound_mutations"), pytest.mark.slow]

is_length = OfFormulas(test_contact_bounds.test_a_bound_of_contacts_is_a_length)
ring = OfEngine(
    test_contact_bounds.check_integrator, given=((SCENES["ring"],),), scene=SCENES["ring"]
)
few_of_ring = OfEngine(test_contact_bounds.check_few_uncertain, scene=SCENES["ring"])
bend = OfFormulas(
    test_contact_bounds.test_the_gap_of_a_ball_on_its_way_out_of_a_box_bends_no_more_than_its_bound
)
starts = OfEngine(
    test_contact_bounds.check_starts, given=((SCENES["crate"],),), scene=SCENES["crate"]
)


def _worst_bend_of_tori(patch: pytest.MonkeyPatch) -> None:
    faulty = changed(
        registry._general, "isinstance(surface, Toroidal) and bool(surface.bounds)", "False"
    )
    searches = [
        (*kinds, faulty if search is registry._general else search)
        for *kinds, search in registry.SEARCHES
    ]
    patch.setattr(registry, "SEARCHES", tuple(searches))


FAULTS = (
    Planted(
        "a bound of contacts has no share of the turn of the normal",
        in_text(
            test_contact_bounds,
            "at_contact",
            "barrier(1 / ball_radius) + barrier(surface.curvature)",
            "1 / ball_radius",
        ),
        is_length,
    ),
    Planted(
        "a bound of contacts has no share of its roundings",
        in_text(test_contact_bounds, "at_contact", "ROUNDINGS * ball_radius", "ball_radius"),
        is_length,
    ),
    Planted(
        "the bounds of a torus are those of the ball's centre",
        in_text(Surface, "nearest_point", "place - barrier(ball_radius * component)", "place"),
        ring,
    ),
    Planted(
        "a box is there at the start where it is not",
        in_text(Box, "inside", "self.bounds", "()"),
        starts,
    ),
    Planted(
        "the way out of a box bends no more than the way in",
        in_text(
            BoxRootFinder,
            "turned_curvature",
            "self._pull_bound(width) + 2 * barrier(sp.Add(*squares))",
            "self.curvature(width)",
        ),
        bend,
    ),
    Planted(
        "the way out of a box bends as much as it can anywhere",
        in_text(
            BoxRootFinder,
            "turned_curvature",
            "self._pull_bound(width) + 2 * barrier(sp.Add(*squares))",
            "ceiling",
        ),
        bend,
    ),
    Planted(
        "the way out of a torus bends as much as it can anywhere",
        _worst_bend_of_tori,
        few_of_ring,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
