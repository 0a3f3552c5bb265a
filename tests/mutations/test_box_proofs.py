"""Deliberate faults in what the lemmas about boxes rest on: each trips a test that names it.

Terms that are more generous than needed, and roundings beside larger ones, are held against the
counts of their lemmas alone. No test notices a certain root with half of the slope's square that
the lemma asks for, or without the margin of the slope: those are of `root_finder.py`, and a root of
a box follows from less. Nor what Newton's method leaves in `root_offset`, as roundings are more.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import pytest
from hoopgen.derive.errors import surface_frames
from hoopgen.derive.events import box_windows
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.events.root_finder import RootFinder
from hoopgen.derive.scenes import premises

pytest.importorskip("flint")

from tests.derive.errors import test_box_frames as frames
from tests.derive.events import test_box_margins as margins
from tests.derive.events import test_box_windows as windows
from tests.derive.events import test_own_surfaces
from tests.derive.scenes import test_premises_of_boxes as rising
from tests.helpers.checked_faults import OfFormulas, OfKernels, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.helpers.scenes.block import BLOCK

pytestmark = [pytest.mark.xdist_group("box_proof_mutations")]


@dataclass(frozen=True)
class OfBlock(OfKernels):
    """A test of contacts with the block, which calls the kernels of its scene."""

    def run(self, derived: Any) -> None:
        """Run the test with these kernels."""
        with pytest.MonkeyPatch.context() as there:
            there.setattr(frames, "block", lambda: derived)
            self._call()


NEARBY, FAR = ((1.5,),), ((12.0,),)
held = OfFormulas(
    windows.test_the_windows_of_a_computed_flight_hold_the_true_one_in_the_box, NEARBY
)
held_from_afar = OfFormulas(
    windows.test_the_windows_of_a_computed_flight_hold_the_true_one_in_the_box, FAR
)
left = OfFormulas(
    test_own_surfaces.test_errors_are_small_whenever_the_true_ball_is_in_the_box,
    (((0, 0, -1), False),),
)
edges = OfFormulas(
    windows.test_at_the_edges_of_windows_the_ball_is_where_they_are_but_for_the_counted_roundings,
    ((0,), (2,)),
)
gap = OfFormulas(margins.test_errors_of_gap_and_rate_are_within_their_margins, ((False,),))
leaving = OfFormulas(margins.test_errors_of_gap_and_rate_are_within_their_margins, ((True,),))
roundings = OfFormulas(margins.test_roundings_alone_reach_a_part_of_the_margins)
bend = OfFormulas(margins.test_the_gap_bends_down_no_more_than_its_bound_across_seams)
certain = OfFormulas(
    margins.test_a_certain_root_is_one_and_the_gap_bends_no_more_than_the_ceiling_until_it
)
ends = OfFormulas(margins.test_where_newtons_method_ends_the_gap_is_within_its_margin)
counts = OfFormulas(
    margins.test_bounds_are_no_smaller_than_the_counts_of_their_lemmas, ((False,), (True,))
)
comes_up = OfFormulas(rising.test_a_ball_that_comes_up_to_the_end_has_met_no_box_before)

of_block = partial(OfBlock, scene=BLOCK)
tangents = of_block(frames.test_tangents_and_bends_are_those_of_face_edge_and_corner)
seams = of_block(frames.test_no_seam_is_within_the_share_of_the_curvature_that_errors_may_make)
over_a_seam = of_block(frames.test_errors_that_may_reach_over_a_seam_have_no_finite_bounds)
normals = of_block(frames.test_the_rounding_of_the_normal_is_within_its_bound)
roots = of_block(
    frames.test_at_a_computed_root_the_exact_flight_is_as_far_off_the_block_as_its_bound,
    ((0.0,), (1.0,)),
)
root_counts = of_block(frames.test_bounds_at_a_root_are_no_smaller_than_the_counts_of_their_lemma)
growth = of_block(
    frames.test_errors_at_their_limits_stay_within_the_bounds, (("one",), ("many",), ("one large",))
)

in_windows = partial(in_text, windows, "windows")
in_lost = partial(in_text, windows, "lost")
in_box = partial(in_text, BoxRootFinder)
in_frames = partial(in_text, surface_frames, "_of_box")
in_newton = partial(in_text, surface_frames, "_with_newton_residue")
in_rising = partial(in_text, premises, "_rises")

FAULTS = (
    # Windows.
    Planted(
        "windows are those of the box itself",
        in_windows("wider = RELATIVE_INFLATION * ", "wider = 0 * "),
        held,
    ),
    Planted(
        "errors may be twice as large as the inflation",
        in_lost("RELATIVE_INFLATION / 4 * half", "RELATIVE_INFLATION * 2 * half"),
        held,
    ),
    Planted(
        "an error of the velocity loses no window",
        in_lost("position_error + velocity_error * latest", "position_error"),
        held,
    ),
    Planted(
        "roundings lose no window",
        in_lost("barrier(far + flown) * sp.Rational(1, 2**48)", "sp.Integer(0)"),
        held_from_afar,
    ),
    Planted(
        "roundings of places lose no window",
        in_lost("barrier(far + flown)", "barrier(flown)"),
        held_from_afar,
    ),
    Planted(
        "a ball has left a box as soon as it would at rest",
        in_text(box_windows, "time_to_leave", "2 * speed * per_g + ", ""),
        left,
    ),
    Planted(
        "a ball is above the top all the time after its rise",
        in_text(box_windows, "_falling", "barrier(up + inner) * per_g, sp.oo", "sp.oo, sp.oo"),
        held,
    ),
    Planted(
        "a ball does not turn within a box",
        in_text(box_windows, "_falling", "barrier(up - inner) * per_g, last", "0, 0"),
        held,
    ),
    Planted(
        "a ball comes out of a box at its middle",
        in_text(box_windows, "_straight", "barrier(half - there) / size", "-there / size"),
        held,
    ),
    Planted(
        "the bottom is not inflated",
        in_text(
            box_windows, "_falling", "barrier(place + half)", "barrier(place + half * 8191/8192)"
        ),
        edges,
    ),
    # The gap's second derivative.
    Planted(
        "the gap bends as it does at the beginning of a window",
        in_box("_pull_bound", "barrier(absolute(v) + absolute(a) * width / 2) * width", "0 * v"),
        bend,
    ),
    Planted(
        "a velocity brings no ball beyond a face",
        in_box("_pull_bound", "barrier(absolute(v) + absolute(a)", "barrier(absolute(a)"),
        bend,
    ),
    Planted(
        "a ball in a window is no further beyond a face than at a contact",
        in_box("_reach", "2 * RELATIVE_INFLATION", "0 * RELATIVE_INFLATION"),
        bend,
    ),
    Planted(
        "the ceiling has no free fall",
        in_box("ceiling", " + sp.Add(*falls)", ""),
        certain,
    ),
    Planted(
        "the ceiling has no velocity",
        in_box("ceiling", "3 * self._fastest**2 + ", ""),
        certain,
    ),
    # Margins and certain roots.
    Planted(
        "the gap has no error of a place",
        in_box("_roundings", "Rounded(self._reach, barrier(off))", "Rounded(self._reach)"),
        gap,
    ),
    Planted(
        "the gap has two fifths of its error",
        in_box(
            "margins", "ROUNDING_SLACK * (gap.error + ", "ROUNDING_SLACK * (gap.error * 2 / 5 + "
        ),
        gap,
    ),
    Planted(
        "a ball at a contact is a third of its radius beyond a face",
        in_box("_roundings", "Rounded(self._reach,", "Rounded(self._reach / 3,"),
        gap,
    ),
    Planted(
        "the rate of the gap has no error of the velocity",
        in_box(
            "_roundings",
            "dict.fromkeys(VELOCITY, moved)",
            "dict.fromkeys(VELOCITY, Rounded(moved.magnitude))",
        ),
        gap,
    ),
    Planted(
        "the mean rate has no error of the velocity",
        in_box(
            "_roundings",
            "now | dict.fromkeys(VELOCITY, mean)",
            "now | dict.fromkeys(VELOCITY, Rounded(mean.magnitude))",
        ),
        leaving,
    ),
    Planted(
        "the mean rate has an eighth of its error",
        in_box("margins", "2 * change.error", "change.error / 8"),
        leaving,
    ),
    Planted(
        "margins are a hundredth of what they are",
        in_box("margins", "ROUNDING_SLACK * ", "sp.Rational(1, 100) * "),
        roundings,
    ),
    Planted(
        "a root follows a sixty-fourth of the gap",
        in_text(RootFinder, "headroom", "low_gap + self.allowed", "low_gap / 64"),
        certain,
    ),
    Planted(
        "a gap that does not fall falls to a root",
        in_text(RootFinder, "advance", "IfLess(0, least_fall, enough, least_fall)", "enough"),
        certain,
    ),
    Planted(
        "Newton's method ends at any gap",
        in_box("ceiling", "3 * self._fastest**2", "self._fastest**2 / 64"),
        ends,
    ),
    Planted(
        "the ceiling has the velocity once",
        in_box("ceiling", "3 * self._fastest**2", "self._fastest**2"),
        counts,
    ),
    Planted(
        "the ceiling is that of the windows alone",
        in_box("ceiling", "CEILING_BOX_FACTOR * ", ""),
        counts,
    ),
    Planted(
        "the bound on how the gap bends has no roundings",
        in_box("_pull_bound", "sp.Rational(1, 2**40) * ceiling", "0 * ceiling"),
        counts,
    ),
    Planted(
        "free fall brings no ball beyond a face",
        in_box("_pull_bound", " + absolute(a) * width / 2", ""),
        counts,
    ),
    Planted(
        "neighbouring times have the same gap",
        in_box("margins", " + time_rounding(rate) * horizon", ""),
        counts,
    ),
    Planted(
        "neighbouring times have the same mean rate",
        in_box("margins", "2 * change.error + time_rounding(rate)", "2 * change.error"),
        counts,
    ),
    Planted(
        "the error of e counts once in the mean rate",
        in_box("margins", "2 * change.error", "change.error"),
        counts,
    ),
    Planted(
        "a margin is not rounded upwards",
        in_box("margins", "ROUNDING_SLACK * (gap.error", "(gap.error"),
        counts,
    ),
    # Frames of contacts.
    Planted(
        "an edge is straight",
        in_frames("Choose(all_of(bent_z, tilted), per_radius, 0)", "Choose(tilted, 0, per_radius)"),
        tangents,
    ),
    Planted(
        "a corner is round about the vertical by the ball's radius",
        in_frames("around = barrier(per_radius * per_horizontal)", "around = per_radius"),
        tangents,
    ),
    Planted(
        "an edge that is level is round about the vertical",
        in_frames("all_of(bent_x, bent_y)", "bent_x"),
        tangents,
    ),
    Planted(
        "the tangent of a wall is across it",
        in_frames(
            "Choose(tilted, -ny * per_horizontal, 0)", "Choose(tilted, nx * per_horizontal, 0)"
        ),
        tangents,
    ),
    Planted(
        "a corner is no sharper than an edge",
        in_frames("maximum(per_radius, bends[1], ", "maximum(per_radius, "),
        tangents,
    ),
    Planted(
        "a seam is no curvature",
        in_frames(", barrier(1 / barrier(SEAM_SHARE * apart))", ""),
        seams,
    ),
    Planted(
        "errors may reach over a seam",
        in_frames(", barrier(1 / barrier(SEAM_SHARE * apart))", ""),
        over_a_seam,
    ),
    Planted(
        "single precision tells every side of a seam",
        in_frames("apart = barrier(nearest - blurred)", "apart = nearest"),
        seams,
    ),
    Planted(
        "a root has no roundings of the place",
        in_frames("once = barrier(rounded + ", "once = barrier("),
        roots,
    ),
    Planted(
        "a root has no roundings",
        in_frames("once = barrier(rounded + 8 * UNIT_ROUNDOFF * radius)", "once = sp.Integer(0)"),
        roots,
    ),
    Planted(
        "a root has no roundings of squares",
        in_frames("once = barrier(rounded + 8 * UNIT_ROUNDOFF * radius)", "once = rounded"),
        root_counts,
    ),
    Planted(
        "Newton's method leaves no roundings",
        in_newton("maximum(sp.Rational(9, 8) * rounded, residue)", "residue"),
        root_counts,
    ),
    Planted(
        "the time of a root has no rounding",
        in_newton("barrier(absolute(normal_velocity) * t)", "0 * t"),
        root_counts,
    ),
    Planted(
        "a return has no roundings of places",
        in_frames("barrier(barrier(sum(own)) * path * per_radius + ", "barrier("),
        root_counts,
    ),
    Planted(
        "a return has no roundings of products",
        in_frames(" + 12 * UNIT_ROUNDOFF * path", ""),
        root_counts,
    ),
    Planted(
        "a return is found with F/t alone",
        in_text(
            surface_frames, "_of_either_form", "maximum(again, barrier(once + level)), ", "again, "
        ),
        roots,
    ),
    Planted(
        "the rounding of e turns no normal",
        in_frames("2 * barrier(sum(beside)) * per_radius + ", ""),
        root_counts,
    ),
    Planted(
        "a return comes to the surface",
        in_text(surface_frames, "_of_either_form", "barrier(level + again)", "again"),
        growth,
    ),
    Planted(
        "the normal has no roundings",
        in_frames("barrier(2 * barrier(sum(beside)) * per_radius + 8 * UNIT_ROUNDOFF)", "FLOOR"),
        normals,
    ),
    Planted("errors turn no corner", in_frames("*bends,", "0, 0,"), growth),
    # Premises.
    Planted(
        "a box is no thicker by the ball",
        in_rising("barrier(high + surface.radius + room)", "high"),
        comes_up,
    ),
    Planted(
        "a box is above the end if its top is",
        in_rising("surface.low[2] - surface.radius", "surface.high[2]"),
        comes_up,
    ),
    Planted(
        "a ball is on one side of a box if it ends there",
        in_rising("barrier(minimum(*ends))))", "ends[1]))"),
        comes_up,
    ),
)

test_a_fault_trips_its_check = tripping(FAULTS)
test_without_a_fault_the_checks_pass = passing(FAULTS)
