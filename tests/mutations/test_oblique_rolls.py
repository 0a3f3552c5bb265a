"""Deliberate faults in rolls on turned and round bodies with edges: each trips a test by name."""

from __future__ import annotations

from pathlib import Path

import pytest
from hoopgen.derive.motion import rolling_series
from hoopgen.derive.rolling import bounds, contact_phase, surface_kernels
from hoopgen.derive.surfaces import Cone, ObliqueBox, ObliqueCylinder
from hoopgen.derive.surfaces.two_sided import Round

pytest.importorskip("flint")

from tests.helpers.checked_faults import (
    Check,
    OfEngine,
    OfFormulas,
    Planted,
    checks_of,
    noticed,
    passes,
)
from tests.helpers.mutants import in_text
from tests.scene import test_cone_rolls, test_oblique_rolls

pytestmark = [pytest.mark.xdist_group("oblique_roll_mutations"), pytest.mark.slow]

on_box = OfEngine(
    test_oblique_rolls.test_rolls_on_a_turned_box_are_those_of_a_second_formulation,
    scene=test_oblique_rolls.CRATE,
)
on_round = OfEngine(
    test_oblique_rolls.test_rolls_up_to_edges_are_those_of_a_second_formulation,
    scene=test_oblique_rolls.ROUND,
)
on_cone = OfEngine(
    test_cone_rolls.test_rolls_on_a_cone_are_those_of_a_second_formulation,
    ((0,), (1,)),
    scene=test_cone_rolls.CONES,
)
into_apex = OfEngine(
    test_cone_rolls.test_a_ball_that_rolls_into_an_apex_ends_flagged_and_one_aside_turns_back,
    scene=test_cone_rolls.POINTED,
)
behind = OfFormulas(
    test_oblique_rolls.test_a_ball_behind_a_round_body_meets_it_no_sooner_than_its_bound_says
)

FAULTS = (
    Planted(
        "a ball stays as far from the axis of a cone",
        in_text(rolling_series, "_around_axis", "cone_slope * rising", "0 * rising"),
        on_cone,
    ),
    Planted(
        "the azimuth turns as if the distance from the axis were constant",
        in_text(rolling_series, "_around_axis", "per_cosine * along - known", "per_cosine * along"),
        on_cone,
    ),
    Planted(
        "a ball inside a cone is turned as one outside",
        in_text(Cone, "rolling_surface", "self._side * barrier(sp.sqrt", "barrier(sp.sqrt"),
        on_cone,
    ),
    Planted(
        "a ball rolls into the apex of a cone",
        in_text(
            contact_phase,
            "apex_kernels",
            "barrier(barrier(NEAREST_TO_AXIS * ball_radius) * per_width)",
            "barrier(0 * per_width)",
        ),
        into_apex,
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

CHECKS = checks_of(FAULTS)


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: f"{check.name}")
def test_without_a_fault_every_check_passes(check: Check, tmp_path: Path) -> None:
    passes(check, tmp_path)


@pytest.mark.parametrize(
    "fault", [pytest.param(fault, id=f"{fault.name} ({fault.check.name})") for fault in FAULTS]
)
@pytest.mark.sampled(1)
def test_a_fault_trips_its_check(fault: Planted, tmp_path: Path) -> None:
    noticed(fault, tmp_path)
