"""Deliberate faults in rolls on turned and round bodies with edges: each trips a test by name."""

from __future__ import annotations

import pytest
from hoopgen.derive.rolling import bounds, surface_kernels
from hoopgen.derive.surfaces import ObliqueBox, ObliqueCylinder, ObliqueTorus
from hoopgen.derive.surfaces.torus import Torus
from hoopgen.derive.surfaces.two_sided import Round

pytest.importorskip("flint")

from tests.derive.surfaces import test_concavity
from tests.helpers.checked_faults import OfEngine, OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.scene import test_oblique_rolls

pytestmark = [pytest.mark.xdist_group("oblique_roll_mutations"), pytest.mark.slow]

on_box = OfEngine(
    test_oblique_rolls.test_rolls_on_a_turned_box_are_those_of_a_second_formulation,
    scene=test_oblique_rolls.CRATE,
)
on_round = OfEngine(
    test_oblique_rolls.test_rolls_up_to_edges_are_those_of_a_second_formulation,
    scene=test_oblique_rolls.ROUND,
)
beside_torus, beside_oblique_torus = (
    OfFormulas(
        test_concavity.test_a_ball_meets_no_surface_sooner_than_its_bound_says,
        ((next(s for s in test_concavity.SURFACES if s.name == name),),),
    )
    for name in ("torus", "oblique_torus")
)
behind = OfFormulas(
    test_oblique_rolls.test_a_ball_behind_a_round_body_meets_it_no_sooner_than_its_bound_says
)

FAULTS = (
    Planted(
        "a torus bends down nowhere",
        in_text(Torus, "max_concavity", "1 / self._rho", "sp.Integer(0)"),
        beside_torus,
    ),
    Planted(
        "a torus in any direction bends down nowhere",
        in_text(ObliqueTorus, "max_concavity", "1 / self._rho", "sp.Integer(0)"),
        beside_oblique_torus,
    ),
    Planted(
        "the edges of a turned box bend the path along the axes of the scene",
        in_text(ObliqueBox, "rolling_surface", "for one in axes", "for one in transposed(axes)"),
        on_box,
    ),
    Planted(
        "an edge of a turned box throws a ball off as the face before it does",
        in_text(surface_kernels, "_under", "surface.distance_ahead", "surface.distance"),
        on_box,
    ),
    Planted(
        "a slanted cylinder is curved along its axis, too",
        in_text(ObliqueCylinder, "rolling_surface", " - barrier(a * b)", ""),
        on_round,
    ),
    Planted(
        "round bodies have no edges",
        in_text(bounds, "limits", "Flat | TwoSided", "Flat"),
        on_round,
    ),
    Planted(
        "behind a round body its distance bends as that of a plane",
        in_text(Round, "max_convexity", "2 / self._rho", "sp.Integer(0)"),
        behind,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
