"""Deliberate faults in the lemma "growth of errors": each trips a test with errors at their limits.

Not seen are faults in terms that are small beside others with the same cause: the second order of
velocity and spin, beside that of place and normal and the slack of 2^-10; the curvature's share of
the distance from the surface; the roundings of T, 2^-17 of the sizes, beside the same slack, and
those of its products, beside these; the roundings of velocities in a flight, beside those of an
impact; the second condition, on the curvature, beside the first; and the condition at an end.
"""

from __future__ import annotations

from typing import Any

import pytest
from hoopgen.derive.errors import contact_frames as frames
from hoopgen.derive.errors import surface_frames
from hoopgen.derive.errors import tighter_bounds as tighter
from hoopgen.derive.loop import predicates as following
from hoopgen.derive.scenes import HOOP

pytest.importorskip("flint")

from tests.derive.errors import test_contact_frames as lemma
from tests.helpers.checked_faults import OfEngine, OfKernels, Planted, passing, tripping
from tests.helpers.mutants import Patch, in_decisions, in_text

pytestmark = [pytest.mark.xdist_group("frame_mutations")]


def check(test: Any, *given: tuple[Any, ...]) -> OfKernels:
    """Return a test of the lemma with the kernels of a derivation."""
    return OfKernels(test, given or ((),), ((lemma.__name__, "kernels"),), scene=HOOP)


of_roundings, of_one, of_many, of_large = (
    check(lemma.test_errors_at_their_limits_stay_within_the_bounds, (bounds,))
    for bounds in ("none", "one", "many", "one large")
)
of_many_roundings = check(
    lemma.test_no_errors_of_many_flights_exceed_the_bounds, *(("none", seed) for seed in range(4))
)
level = check(lemma.test_the_level_of_a_start_may_be_far_off_the_surface)
unproved = check(
    lemma.test_where_the_lemma_does_not_hold_bounds_are_infinite_and_what_follows_is_undecided
)
at_end, at_time = (
    check(lemma.test_errors_at_the_end_are_within_the_bounds, (end, "none"), (end, "one"))
    for end in (lemma.at_end, lemma.at_time)
)


def in_arrival(old: str, new: str) -> Patch:
    """Replace text of the bounds before an impact."""
    return in_text(frames.Arrival, "__init__", old, new)


def in_rest(old: str, new: str) -> Patch:
    """Replace text of the terms beside |T| B."""
    return in_text(frames.NoSlipImpact, "rest", old, new)


def in_matrix(old: str, new: str) -> Patch:
    """Replace text of T."""
    return in_text(frames, "growth", old, new)


def without_column(column: str) -> Patch:
    """Replace a column of T by zeros."""
    return in_matrix(f"        {column},\n", "        (still, still, still),\n")


CONDITION = "barrier(12 * slowed - nearing)"
LENGTHS = "barrier(MOST_LENGTHS * barrier(longer + LEFT_BENDS[0] * BOUNDS[0]) - 1)"

through_one, through_many, through_none = (
    check(lemma.test_errors_since_an_earlier_contact_stay_within_the_tighter_bounds, (bounds,))
    for bounds in ("one", "many", "none")
)
since_release = check(
    lemma.test_errors_since_the_release_are_within_the_tighter_bounds, *((k,) for k in (1, 2, 3))
)


def in_product(old: str, new: str) -> Patch:
    """Replace text of the bounds through a product of matrices."""
    return in_text(tighter, "tighter_errors", old, new)


FAULTS = (
    Planted(
        "the exact ball is on the surface at the computed time",
        in_arrival("gap + root_offset + bent", "gap + bent"),
        of_roundings,
    ),
    Planted(
        "the root has no delay",
        in_arrival("barrier(root_offset + blur) / nearing", "blur / nearing"),
        of_roundings,
    ),
    Planted(
        "a return counts from the surface",
        in_text(surface_frames, "_of_ring", "kept = barrier(BOUNDS[0] + again)", "kept = again"),
        of_one,
    ),
    Planted(
        "a place is off the surface by no rounding of the flight",
        in_arrival("normals + root_level + place", "root_level + place"),
        of_roundings,
    ),
    Planted(
        "a place is off the surface by no second order",
        in_arrival("normals + root_level + place", "normals + root_level"),
        of_one,
    ),
    Planted(
        "normals are unit vectors at the contact",
        in_arrival(
            "self.longer = longer = barrier(here.bends[0] * self.level)",
            "self.longer = longer = sp.Integer(0)",
        ),
        of_one,
    ),
    Planted(
        "normals are unit vectors wherever a flight begins and ends",
        in_arrival(LENGTHS, "sp.Integer(-1)"),
        level,
    ),
    Planted(
        "the normal has no rounding",
        in_text(
            surface_frames, "_of_ring", "UNIT_ROUNDOFF * barrier(2 * wide + 7)", "sp.Integer(0)"
        ),
        of_roundings,
    ),
    Planted(
        "a rounding of the normal does not turn a rolling spin",
        in_rest("+ stays * barrier(size * per_radius * normal_rounding)", ""),
        of_many_roundings,
    ),
    Planted(
        "an impact has seven roundings",
        lambda patch: patch.setattr(frames, "LAW_ROUNDINGS", 7),
        of_roundings,
    ),
    Planted(
        "velocities do not turn across the wire",
        in_text(
            frames.Frame,
            "turned",
            "(barrier(-s * per_s), barrier(n * per_s), zero)",
            "(zero, zero, zero)",
        ),
        of_one,
    ),
    Planted(
        "velocities do not turn about the axis",
        in_text(frames.Frame, "turned", "barrier(barrier(up_n * s - up_s * n) * per_e)", "zero"),
        of_one,
    ),
    Planted(
        "the velocity at the departure does not turn across the wire",
        in_matrix("_cross(about_e, began)", "still"),
        of_one,
    ),
    Planted(
        "the velocity at the departure does not turn about the axis",
        in_matrix("_cross(about_z, began)", "still"),
        of_one,
    ),
    Planted(
        "the spin at the departure does not turn",
        in_matrix("_cross(about_e, turning)", "still"),
        of_one,
    ),
    Planted(
        "the velocity at the departure is that at the contact",
        in_matrix("held(v - t * a)", "held(v - 0 * a)"),
        of_one,
    ),
    Planted(
        "a ball does not fall during its delay",
        in_matrix("delay * f", "0 * f"),
        of_one,
    ),
    Planted(
        "a ball does not move along the surface during its delay",
        in_matrix("held(s + moving[1] * delay)", "held(s)"),
        of_one,
    ),
    Planted(
        "an offset from the surface does not count",
        without_column("(out, still, still)"),
        of_many,
    ),
    Planted("y_w does not count", without_column("(still, still, out)"), of_one),
    Planted("y_z across e does not count", without_column("(still, still, across)"), of_one),
    Planted("y_z along e does not count", without_column("(still, still, along)"), of_one),
    Planted(
        "y_s has no spin",
        in_matrix(
            "(still, across, _times(per_radius, along))",
            "(still, across, still)",
        ),
        of_one,
    ),
    Planted(
        "Newton's method leaves no residue",
        in_text(
            surface_frames,
            "_with_newton_residue",
            "maximum(sp.Rational(9, 8) * rounded, residue)",
            "sp.Rational(9, 8) * rounded",
        ),
        of_roundings,
    ),
    Planted(
        "the ring's condition has no roundings",
        in_text(
            surface_frames,
            "_with_newton_residue",
            "rounded + maximum(sp.Rational(9, 8) * rounded, residue)",
            "residue",
        ),
        of_roundings,
    ),
    Planted(
        "a root on a plane has no roundings of its time",
        in_text(
            surface_frames,
            "_of_plane",
            "absolute(position[axis]) + 4 * along",
            "absolute(position[axis]) + 0 * along",
        ),
        of_roundings,
    ),
    Planted(
        "a flight's products have no roundings",
        in_text(frames, "flight_roundings", "2 * absolute(mean) * t", "0 * t"),
        of_roundings,
    ),
    Planted(
        "a flight has no roundings along the surface",
        in_arrival("barrier(r + absolute(v) * delay)", "barrier(absolute(v) * delay)"),
        of_roundings,
    ),
    Planted(
        "a velocity has no roundings in a flight",
        in_text(
            frames,
            "flight_roundings",
            "UNIT_ROUNDOFF * barrier(sum(map(absolute, velocity)) + flight.strength * t)",
            "0 * t",
        ),
        at_time,
    ),
    Planted(
        "the derivative leaves nothing out",
        in_arrival(
            "self.place = place = barrier(size * belated + drift)",
            "self.place = place = sp.Integer(0)",
        ),
        of_large,
    ),
    Planted(
        "a shot whose bounds are infinite goes on as if they were not",
        in_decisions(following, 'Choose(Boolean("unbounded"), 1, uncertain)', "uncertain"),
        OfEngine(lemma.check_infinite_bounds, scene=HOOP),
    ),
    Planted("a slow contact is proved", in_arrival(CONDITION, "sp.Integer(-1)"), unproved),
    Planted(
        "the sum of an event's time is not rounded",
        in_text(
            frames.Growth, "errors_after", "delay + 4 * UNIT_ROUNDOFF * barrier(clock + t)", "delay"
        ),
        of_roundings,
    ),
    Planted(
        "errors of earlier contacts' times do not count",
        in_text(following, "_of_errors", "clock_error + delay", "delay"),
        of_roundings,
    ),
    Planted(
        "a frame that is turned leaves velocities alone",
        in_text(
            frames, "norms_after", "absolute(along) * q_s + absolute(around) * q_e + one", "one"
        ),
        of_one,
    ),
    Planted(
        "a vector is as long as its largest component",
        lambda patch: patch.setattr(frames, "DIAGONAL", 0),
        of_many,
    ),
    Planted(
        "a ball is at an end when it is computed to be",
        in_text(
            frames, "errors_at_end", "off + barrier(size + change) * late, change", "off, change"
        ),
        at_end,
    ),
    Planted(
        "a root on the end plane is exact",
        in_text(
            frames, "errors_at_end", "barrier(sum(places)) + root_offset)", "barrier(sum(places)))"
        ),
        at_end,
    ),
    Planted(
        "at the time limit no contact was late",
        in_text(frames, "errors_at_time", "clock_error + 4", "0 * clock_error + 4"),
        at_time,
    ),
    Planted(
        "what has come since an earlier contact does not last",
        in_product("barrier(c + PRODUCT_ROUNDING * b)", "barrier(PRODUCT_ROUNDING * b)"),
        through_one,
    ),
    Planted(
        "an offset from the surface does not come to the errors since",
        in_product("(BOUNDS[0], *rounded", "(0, *rounded"),
        through_many,
    ),
    Planted(
        "y_z does not come to the errors since",
        in_product("*rounded, BOUNDS[-1], BOUNDS[-1])", "*rounded, 0, 0)"),
        through_many,
    ),
    Planted(
        "a contact adds half of its errors",
        in_product("barrier(value + extra)", "barrier(value + extra / 2)"),
        through_none,
    ),
    Planted(
        "the product is taken in the other order",
        in_product("made[k][i] * before[k][j]", "made[j][k] * before[i][k]"),
        through_one,
    ),
    Planted(
        "errors at an earlier contact do not count",
        in_product("[m + c for m, c in zip(main, recent, strict=True)]", "list(recent)"),
        through_one,
    ),
    Planted(
        "errors since an earlier contact count half",
        in_product("[m + c for", "[m + c / 2 for"),
        through_one,
    ),
    Planted(
        "where all begins anew there were no errors",
        in_product("IfLess(0, continued, o, bound)", "o"),
        since_release,
    ),
    Planted(
        "where all begins anew the product goes on",
        in_product(
            "IfLess(0, continued, PRODUCT[SIZE * k + j], sp.Integer(k == j))",
            "PRODUCT[SIZE * k + j]",
        ),
        since_release,
    ),
)

test_a_fault_trips_its_check = tripping(FAULTS)
test_without_a_fault_the_checks_pass = passing(FAULTS)
