"""Deliberate faults in the pieces of flights through air: each trips a test by name."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import pytest
from hoopgen.derive import model
from hoopgen.derive.events import air_near
from hoopgen.derive.events.ring.air import AirRingRootFinder
from hoopgen.derive.events.ring.air_sketch import AirRingSketch
from hoopgen.derive.kernels import scene
from hoopgen.derive.motion import air_piece
from hoopgen.derive.motion.air import AirFlight

from tests.derive.events import test_near_in_air, test_ring_in_air, test_ring_sketch_in_air
from tests.derive.motion import test_air
from tests.helpers.mutants import Patch, in_text

pytestmark = [pytest.mark.xdist_group("air_mutations")]


def _of_bound() -> None:
    with pytest.MonkeyPatch.context() as patch:
        test_air.test_the_bound_holds_where_far_more_is_left_out_than_roundings(patch)


_of_rate = test_air.test_a_plane_s_gap_opens_no_slower_than_its_bound_which_is_not_useless
_of_roundings = (
    test_air.test_roundings_of_single_precision_are_within_their_bounds_which_are_not_useless
)

_at_edge = (
    test_near_in_air.test_a_ball_at_the_edge_of_a_body_is_near_within_all_errors_and_not_far_beyond
)
_of_sums = test_air.test_sums_of_a_piece_s_sizes_are_bounded_and_the_bounds_are_near_to_them

FAULTS: dict[str, tuple[Patch, Callable[[], None]]] = {
    "the velocity that a piece leaves out is integrated twice too often": (
        in_text(air_piece, "_integrals", "c / (k + 1) for", "c / (k + 1) ** 3 for"),
        _of_bound,
    ),
    "the norm of the velocity is less than the speed through the air": (
        in_text(
            scene, "piece", "SINGLE_SERIES.airspeeds[0], *(", "SINGLE_SERIES.airspeeds[0] / 8, *("
        ),
        test_air.test_velocity_and_acceleration_are_within_their_bounds_all_along_a_piece,
    ),
    "terms of the mean velocity are divided by the next higher order": (
        in_text(AirFlight, "mean_velocity", "sp.Rational(k, k + 1)", "sp.Rational(k, k + 2)"),
        test_air.test_the_error_of_a_piece_is_within_its_bound_and_the_bound_is_not_useless,
    ),
    "the box of a path has no size where it is held against a plane": (
        in_text(air_near, "_reach", "abs(c) * half", "0 * half"),
        test_air.test_a_piece_that_stays_on_one_side_of_the_end_s_plane_is_clear_of_it_and_no_other_is,
    ),
    "a ball that moves away from a plane does not turn round": (
        in_text(air_near, "least_rate", "now + barrier(horizon * minimum(0, change))", "now"),
        partial(_of_rate, 1.2),
    ),
    "the force on a ball that moves away from a plane does not change": (
        in_text(air_near, "least_rate", "bent + TUBE", "TUBE"),
        partial(_of_rate, 60.0),
    ),
    "single precision rounds what the speed's equation leaves as double precision does": (
        in_text(air_piece, "late_roundings", "SINGLE_ROUNDOFF * (", "SINGLE_ROUNDOFF**2 * ("),
        partial(_of_roundings, 1.2),
    ),
    "single precision rounds the drag and the Magnus force as double precision does": (
        in_text(air_piece, "late_roundings", "SINGLE_ROUNDOFF * b", "SINGLE_ROUNDOFF**2 * b"),
        partial(_of_roundings, 1.2),
    ),
    "coefficients that do not fit into single precision are zero": (
        in_text(scene, "piece", "Less(tail_lost, 1)", "Less(0, 1)"),
        test_air.test_nothing_is_proved_of_coefficients_that_do_not_fit_into_single_precision,
    ),
    "single precision and errors do not move a ball beside a body": (
        in_text(air_near, "_box", "SHARE * piece_extent", "sp.Integer(0)"),
        partial(_at_edge, "the bridge's front"),
    ),
    "single precision does not move a body that is far larger than its distance": (
        in_text(air_near, "near_box", "SHARE * sizes", "0 * sizes"),
        partial(_at_edge, "the top of a large sphere"),
    ),
    "single precision does not move a plane whose place is a difference": (
        in_text(air_near, "_reach", "SHARE * rounding", "0 * rounding"),
        partial(_at_edge, "a plane whose place is a small difference"),
    ),
    "the path of a piece is its chord": (
        in_text(AirFlight, "enclosure", "absolute(turn) / 2", "0"),
        test_air.test_the_path_is_within_its_box_which_is_hardly_larger,
    ),
    "products of the latest order in single precision count for nothing": (
        in_text(air_piece, "half_of_products", "first // 2 + 1, latest", "first // 2 + 2, latest"),
        _of_sums,
    ),
    "a size of high order counts as one of the third": (
        in_text(air_piece, "counted", "(ORDER - 3) * sums[4]", "sums[4]"),
        _of_sums,
    ),
    "a size of high order counts twice as one of the fifth": (
        in_text(air_piece, "counted_twice", "rest * sums", "0 * sums"),
        _of_sums,
    ),
    "a ball near the ring keeps its moment about the axis": (
        in_text(AirRingRootFinder, "moment", "+ turning", ""),
        test_ring_in_air.test_moment_and_distance_from_the_axis_are_within_their_bounds,
    ),
    "a ball near the ring comes no nearer to the axis": (
        in_text(AirRingRootFinder, "least_distance", "- barrier(inward * width)", ""),
        test_ring_in_air.test_moment_and_distance_from_the_axis_are_within_their_bounds,
    ),
    "a ball near the ring keeps its speed": (
        in_text(AirRingRootFinder, "_quickened", "barrier(piece_acceleration * width)", "0"),
        test_ring_in_air.test_the_curvature_bounds_how_much_the_gap_of_a_ball_bends_down_that_slows_down,
    ),
    "a ball near the ring is pulled by nothing": (
        in_text(AirRingRootFinder, "_pulled", "* piece_acceleration)", "* 0)"),
        test_ring_in_air.test_the_curvature_bounds_how_much_the_gap_bends_down_and_is_near_to_that,
    ),
    "the ring's gap bends up no more than at the start of a window": (
        in_text(AirRingRootFinder, "_largest", "+ self._quickened(width)", ""),
        test_ring_in_air.test_the_largest_bend_of_a_window_is_bounded_and_the_bound_is_not_the_ceiling,
    ),
    "the ring's bend counts on half of the way to Newton's root": (
        in_text(
            AirRingRootFinder, "steepest", "barrier(width * fall)", "barrier(2 * width * fall)"
        ),
        test_ring_in_air.test_on_a_window_shorter_than_twice_newton_s_step_the_ceiling_counts,
    ),
    "a sketch's gap is as exact as its last digit": (
        in_text(AirRingSketch, "allowed", "2**14", "2**24"),
        test_ring_sketch_in_air.test_gap_and_rate_of_a_sketch_are_within_their_margins_which_are_not_useless,
    ),
    "the rate of a sketch's gap is as exact as its last digit": (
        in_text(AirRingSketch, "rate_allowed", "2**13", "2**26"),
        test_ring_sketch_in_air.test_gap_and_rate_of_a_sketch_are_within_their_margins_which_are_not_useless,
    ),
    "a sketch may leave out much of the velocity": (
        in_text(AirRingSketch, "begin", "2**18", "2**6"),
        test_ring_sketch_in_air.test_a_sketch_serves_no_piece_of_which_it_leaves_out_too_much,
    ),
    "along a sketch every gap that closes has a root": (
        in_text(AirRingSketch, "headroom", "2 * barrier(low_gap", "0 * barrier(low_gap"),
        test_ring_sketch_in_air.test_a_sketch_proves_only_misses_and_contacts_that_the_series_has,
    ),
    "a ball on the ring that leaves it has no gap that bends down": (
        in_text(AirRingRootFinder, "curvature", "barrier(turned) + ", "0 * barrier(turned) + "),
        test_ring_sketch_in_air.test_a_sketch_proves_of_balls_that_leave_the_ring_only_what_is_true,
    ),
}
"""Faults by name, each with the test that must notice it."""


@pytest.fixture(autouse=True)
def _derived_anew() -> Iterator[None]:
    """Derive the kernels with the fault, and after it without."""
    cached = (
        *(test_air.programs, test_air.program_of, test_air.least_rate),
        *(test_ring_sketch_in_air.programs, test_near_in_air.programs),
    )
    for one in cached:
        one.cache_clear()
    yield
    for one in cached:
        one.cache_clear()


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_trips_its_check(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    fault, check = FAULTS[name]
    monkeypatch.setattr(
        model, "check", lambda _: None
    )  # what it refuses is to be noticed elsewhere
    fault(monkeypatch)
    with pytest.raises(AssertionError):
        check()
