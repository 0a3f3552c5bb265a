"""Deliberate faults in what scenes of one's own have: each trips a test by name.

Bounces that accumulate and rolls over a shelf, the search for a box, windows, boxes about many
bodies, roots on flat and large bodies, the branch of friction.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.contact import friction
from hoopgen.derive.events import bounding_boxes, box_windows, oblique_box, search
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.events.inclined_plane import InclinedPlaneSearch
from hoopgen.derive.events.polynomial import PolynomialRootFinder
from hoopgen.derive.events.root_finder import RootFinder
from hoopgen.derive.events.root_search import RootSearch
from hoopgen.derive.ir.event_tree import Call
from hoopgen.derive.loop import event_loop
from hoopgen.derive.rolling import contact_phase, events, friction_limit, jump, settling
from hoopgen.derive.rolling import stages as contact_stages
from hoopgen.derive.scenes.scene import Scene as DerivedScene
from hoopgen.derive.surfaces import Box, ObliqueBox, ObliqueTorus, box
from numpy.typing import NDArray

pytest.importorskip("flint")

from hoopgen.judge import Certificate, certify
from hoopgen.scene import Box as BoxPiece
from hoopgen.scene import End, Scene, Sphere
from hoopgen.simulation.engine import Engine
from tests.derive.events import test_own_surfaces
from tests.helpers.checked_faults import OfEngine, OfFormulas, Planted, cases, passing, tripping
from tests.helpers.mutants import in_text, in_tree
from tests.scene import (
    test_air,
    test_behind_cones,
    test_friction_switch,
    test_leaning_table,
    test_oblique_bodies,
    test_pipes,
    test_root_errors,
    test_roots,
    test_shelf,
)
from tests.scene.test_friction_switch import ESTIMATED
from tests.scene.test_shelf import SHELF

pytestmark = [pytest.mark.xdist_group("own_mutations")]


# ------------------------------------------------------------------------------------- the checks

CRATE = Scene(
    "crate",
    bodies=[
        BoxPiece("crate", size=(0.4, 0.3, 0.2), centre=(0, 0, 0)),
        BoxPiece("board", size=(0.02, 0.6, 0.5), centre=(0.4, 0.1, 0.2)),
    ],
    ball_radius=0.1,
    gravity=9.81,
    restitution=0.7,
    ends={"down": End(at=-1)},
)
"""Two boxes."""

TURNED_CRATE = Scene(
    "turned_crate",
    bodies=[
        BoxPiece("crate", size=(0.4, 0.3, 0.2), orientation={"axis": (1, 2, 3), "angle": "70deg"})
    ],
    ball_radius=0.1,
    gravity=9.81,
    restitution=0.7,
    ends={"down": End(at=-1)},
)
"""A turned box."""

POSTS = Scene(
    "posts_in_rows",
    bodies=[
        Sphere(f"post_{k}", radius=0.03, centre=(0.2 * (k % 6), 0.2 * (k // 6), 0.02 * (k % 5)))
        for k in range(24)
    ],
    ball_radius=0.04,
    gravity=9.81,
    restitution=0.8,
    ends={"down": End(at=-0.5)},
)
"""So many spheres that they are in groups."""


def against_a_crate(rows: int = 250) -> NDArray[np.float64]:
    """Return shots about two boxes, from all sides, some slow and some grazing."""
    rng = np.random.default_rng(8)
    states = np.zeros((rows, 9))
    normal = rng.normal(size=(rows, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    states[:, :3] = normal * rng.uniform(0.4, 0.8, (rows, 1))
    goal = rng.uniform([-0.3, -0.25, -0.2], [0.45, 0.3, 0.4], (rows, 3))
    time = rng.uniform(0.1, 0.5, (rows, 1))
    states[:, 3:6] = (goal - states[:, :3]) / time
    states[:, 5] += 9.81 * time[:, 0] / 2
    states[:, 6:] = rng.normal(0, 10, (rows, 3))
    return states


def among_posts(rows: int = 250) -> NDArray[np.float64]:
    """Return shots that cross the rows of posts; many pass over them first."""
    rng = np.random.default_rng(9)
    states = np.zeros((rows, 9))
    states[:, :3] = rng.uniform([-0.3, -0.3, 0.15], [1.3, 0.9, 0.5], (rows, 3))
    states[:, 3:6] = rng.normal(0, [1.0, 1.0, 1.5], (rows, 3))
    # Half of them come from below, and turn among the posts.
    states[::2, 2] = rng.uniform(-0.4, -0.15, rows // 2)
    states[::2, 5] = rng.uniform(1.5, 3.5, rows // 2)
    return states


BATCHES = {
    "crate": (CRATE, against_a_crate),
    "turned_crate": (TURNED_CRATE, against_a_crate),
    "posts_in_rows": (POSTS, among_posts),
}


@cache
def proved(name: str) -> tuple[NDArray[np.float64], Certificate]:
    """Return shots in a scene, and what is proved of them."""
    scene, make = BATCHES[name]
    states = make()
    return states, certify(states, scene=scene, max_contacts=5, processes=1)


def the_judge_agrees(engine: Engine) -> None:
    """Assert that most shots have no flag, and that those are as proved, within claimed errors."""
    states, proof = proved(engine.name)
    wanted = ("outcome", "contacts", "time", "state", "uncertain", "time_error", "state_error")
    shots = engine.simulate(states, max_contacts=5, record=True, fields=wanted)
    assert proof.agrees(shots).all()
    known = proof.decided & ~shots.uncertain & np.isfinite(proof.time)
    assert known.sum() > 0.7 * np.isfinite(proof.time).sum()
    away = np.abs(shots.state - proof.state).reshape(-1, 3, 3).max(axis=2)
    assert np.all((away <= shots.state_error + 1e-15)[known])


on_shelf: dict[str, OfEngine] = {
    test.__name__.removeprefix("test_"): OfEngine(test, given, scene=SHELF)
    for test, given in (
        (test_shelf.test_a_ball_rolls_against_the_wall, ((),)),
        (test_shelf.test_a_ball_rolls_across_an_end_plane, ((),)),
        (test_shelf.test_beyond_an_end_plane_a_roll_goes_on, ((),)),
        (
            test_shelf.test_behind_an_end_plane_a_ball_leaves_the_edge_once,
            (((0.1, 0.4, 0.0, 1.0), False),),
        ),
        (test_shelf.test_a_roll_ends_at_the_time_limit, ((),)),
        (test_shelf.test_a_ball_rests_where_it_is_put, ((),)),
        (test_shelf.test_a_ball_rolls_over_the_edge_and_leaves_it, ((0.1,), (0.6,))),
        (test_shelf.test_a_fast_ball_is_thrown_off_at_the_edge, ((1.0,),)),
        (test_shelf.test_when_friction_no_longer_suffices, ((0.3, 0.3),)),
        (test_shelf.test_bounces_end_when_their_sum_says, ((0.5,),)),
        (test_shelf.test_what_the_bounces_leave_out_is_less_than_the_tolerance, ((0.3,),)),
        (test_shelf.test_a_ball_that_slips_through_its_bounces_slides, ((),)),
        (test_shelf.test_a_slip_that_bounces_can_stop_ends_in_a_roll, ((),)),
        (test_shelf.test_in_the_corner_a_ball_is_wedged, ((),)),
        (test_shelf.test_errors_grow_with_the_way_that_a_ball_rolls, ((),)),
    )
}
boxes = OfFormulas(
    test_own_surfaces.test_gap_and_rate_are_within_their_margins_and_the_bend_within_its_bounds,
    ((test_own_surfaces.KINDS["box"],),),
)
boxes_left = OfFormulas(
    test_own_surfaces.test_the_gap_since_a_start_on_the_surface_is_within_its_margin,
    ((test_own_surfaces.KINDS["box"],),),
)
turned_crate = OfEngine(the_judge_agrees, scene=TURNED_CRATE)
windows_hold = OfFormulas(
    test_own_surfaces.test_windows_hold_every_time_within_the_box,
    (((0, 0, -1), False), ((-1, 0, -2), False), ((1, 0, 0), True)),
)
crate = OfEngine(the_judge_agrees, scene=CRATE)
posts = OfEngine(the_judge_agrees, scene=POSTS)
turned_tori = OfEngine(
    test_oblique_bodies.test_turned_tori_are_met_where_an_independent_integrator_meets_them,
    scene=test_oblique_bodies.RINGS,
)
pipe = {
    test.__name__.removeprefix("test_"): OfEngine(test, scene=test_pipes.PIPE)
    for test in (
        test_pipes.test_a_ball_meets_the_wall_of_a_pipe_along_gravity,
        test_pipes.test_a_ball_that_hardly_moves_across_a_pipe_is_flagged,
    )
}
behind_cone = OfEngine(
    test_behind_cones.test_a_ball_that_comes_out_of_the_mirror_image_does_not_miss_the_cone,
    scene=test_behind_cones.FLAT_CONE,
)
switch = OfEngine(
    test_friction_switch.test_the_switch_between_grip_and_slip_is_undecided_within_its_error,
    cases(test_friction_switch.test_the_switch_between_grip_and_slip_is_undecided_within_its_error),
    scene=ESTIMATED,
)


# ------------------------------------------------------------------------------------- the faults


def without(kernel: str) -> Any:
    """Take an evaluation of a kernel out of the event loop."""
    return in_tree(lambda n: () if isinstance(n, Call) and n.kernel.name == kernel else (n,))


FAULTS = (
    # Bounces that accumulate.
    Planted(
        "the tolerance of a settled ball is a micrometre",
        in_text(settling, "tolerance", "sp.Rational(1, 2**38)", "sp.Rational(1, 2**15)"),
        on_shelf["bounces_end_when_their_sum_says"],
    ),
    Planted(
        "no ball slides",
        in_text(
            settling,
            "settling",
            "slides = all_of(over, Or(Less(stopped, slip), Less(available, required)))",
            "slides = false",
        ),
        on_shelf["a_ball_that_slips_through_its_bounces_slides"],
    ),
    Planted(
        "the bounces that are left stop no slip",
        in_text(settling, "settling", "2 * takes / (ball.friction_share * left)", "0 * takes"),
        on_shelf["a_slip_that_bounces_can_stop_ends_in_a_roll"],
    ),
    Planted(
        "a ball is wedged a tenth of a millimetre off",
        in_text(settling, "wedge_width", "sp.Rational(1, 2**28)", "sp.Rational(1, 2**9)"),
        on_shelf["in_the_corner_a_ball_is_wedged"],
    ),
    Planted(
        "no ball is wedged",
        in_text(settling, "settling", "AtMost(second_contact_gap, narrow)", "false"),
        on_shelf["in_the_corner_a_ball_is_wedged"],
    ),
    Planted(
        "what the jump to the end of the bounces is off by is no error",
        in_text(
            jump,
            "_errors_of_tolerance",
            "grown = tolerance(ball_radius)",
            "grown = tolerance(ball_radius) / 2**60",
        ),
        on_shelf["errors_grow_with_the_way_that_a_ball_rolls"],
    ),
    Planted(
        "no bounce is the last",
        in_text(
            settling,
            "_bounce_kernels",
            "small = Less(*small_hop(gravity, ball.radius))",
            "small = Less(small_hop(gravity, ball.radius)[0], 0)",
        ),
        on_shelf["a_ball_rests_where_it_is_put"],
    ),
    Planted(
        "a contact that begins is not counted as one",
        in_text(
            contact_phase,
            "_results",
            "Choose(Or(begins, goes_on), ROLLS,",
            "Choose(goes_on, ROLLS,",
        ),
        on_shelf["a_ball_rolls_across_an_end_plane"],
    ),
    Planted(
        "the log has departures for contacts that begin",
        in_text(contact_phase, "_results", "codes.log_row(own, False)", "codes.log_row(own, True)"),
        on_shelf["a_ball_rests_where_it_is_put"],
    ),
    # Rolls and their events.
    Planted(
        "a ball rolls over an end plane",
        without("beside_end_plane"),
        on_shelf["a_ball_rolls_across_an_end_plane"],
    ),
    Planted(
        "an end plane behind the ball is crossed",
        in_text(events, "_other_surfaces", "all_of(meets, AtMost(-landing, gap))", "meets"),
        on_shelf["beyond_an_end_plane_a_roll_goes_on"],
    ),
    Planted(
        "a departing ball crosses the end plane behind it",
        in_text(
            contact_phase,
            "departure_kernels",
            "Choose(Less(0, gap), unmet, free_time)",
            "unmet",
        ),
        on_shelf["behind_an_end_plane_a_ball_leaves_the_edge_once"],
    ),
    Planted(
        "a ball rolls into the wall",
        without("beside_body"),
        on_shelf["a_ball_rolls_against_the_wall"],
    ),
    Planted(
        "a roll lasts longer than its time",
        in_text(
            contact_phase,
            "step_events",
            "barrier(time_limit - clock)",
            "barrier(2 * time_limit - clock)",
        ),
        on_shelf["a_roll_ends_at_the_time_limit"],
    ),
    Planted(
        "a ball at rest rolls on",
        in_text(
            events, "_leaving_force", '"rests": all_of(stopped, Not(leaves))', '"rests": Less(1, 0)'
        ),
        on_shelf["a_ball_rests_where_it_is_put"],
    ),
    Planted(
        "a slow ball is at rest",
        in_text(
            events, "_leaving_force", "still = sp.Rational(1, 2**44)", "still = sp.Rational(1, 2)"
        ),
        on_shelf["a_roll_ends_at_the_time_limit"],
    ),
    Planted(
        "the shelf's top goes on behind its seam",
        without("beside_seam"),
        on_shelf["a_ball_rolls_over_the_edge_and_leaves_it"],
    ),
    Planted(
        "at a seam the velocity does not decide",
        in_text(box, "past_faces", "_onto(above, rate, near)", "_onto(above, -rate, near)"),
        on_shelf["a_ball_rolls_over_the_edge_and_leaves_it"],
    ),
    Planted(
        "the shelf's edge is as round as twice the ball",
        in_text(Box, "rolling_surface", "1 / self.radius, seams", "1 / (2 * self.radius), seams"),
        on_shelf["a_ball_rolls_over_the_edge_and_leaves_it"],
    ),
    Planted(
        "a ball leaves at half of its normal force",
        in_text(
            events,
            "_leaving_force",
            "spent = any_of(Less(force, -small)",
            "spent = any_of(Less(force, gravity / 2)",
        ),
        on_shelf["a_ball_rolls_over_the_edge_and_leaves_it"],
    ),
    Planted(
        "a ball does not leave where its force ends",
        in_text(
            events,
            "_leaving_force",
            "leaves = all_of(spent, Not(holds))",
            "leaves = all_of(spent, holds)",
        ),
        on_shelf["a_fast_ball_is_thrown_off_at_the_edge"],
    ),
    Planted(
        "as bounces end a ball is beside the surface that it is on",
        in_text(contact_stages, "nearest_others", 'yield If("beside", other)', "yield from other"),
        on_shelf["a_ball_rolls_across_an_end_plane"],
    ),
    Planted(
        "a rolling ball's place is not moved",
        in_text(contact_stages, "_moved", '{"t": "stride"}', '{"t": 0.0}'),
        on_shelf["a_ball_rolls_across_an_end_plane"],
    ),
    Planted(
        "errors do not grow while a ball rolls",
        without("compared"),
        on_shelf["errors_grow_with_the_way_that_a_ball_rolls"],
    ),
    Planted(
        "friction holds with its coefficient unsquared",
        in_text(
            friction_limit,
            "friction_excess",
            "barrier(law.friction_coefficient**2)",
            "law.friction_coefficient",
        ),
        on_shelf["when_friction_no_longer_suffices"],
    ),
    Planted(
        "the limit of friction is passed at the end of the step",
        in_text(
            friction_limit,
            "kernels",
            "Less(last_grip_deficit, sp.oo), Less(",
            "Less(sp.oo, last_grip_deficit), Less(",
        ),
        on_shelf["when_friction_no_longer_suffices"],
    ),
    Planted(
        "the excess of friction is not remembered",
        without("remember_grip_deficit"),
        on_shelf["when_friction_no_longer_suffices"],
    ),
    # The search for a box.
    Planted(
        "a box has no margin",
        in_text(
            BoxRootFinder,
            "margins",
            '"margin": ROUNDING_SLACK *',
            '"margin": sp.Rational(1, 2**12) *',
        ),
        boxes,
    ),
    Planted(
        "a degree that is not certain is as good as none",
        in_text(
            PolynomialRootFinder,
            "windows",
            "IfLess(0, higher, beyond, last)",
            "IfLess(0, higher, sp.oo, self._last_root())",
        ),
        pipe["a_ball_meets_the_wall_of_a_pipe_along_gravity"],
    ),
    Planted(
        "a ball whose gap rises within its margin is outside, but at first",
        in_text(
            RootFinder,
            "advance",
            "barrier(gap - self.allowed), low_gap))",
            "IfAtMost(t, 0, barrier(gap - self.allowed), low_gap), low_gap))",
        ),
        behind_cone,
    ),
    Planted(
        "the last root is certain though the degree is not",
        in_text(
            PolynomialRootFinder,
            "lost",
            "return IfLess(horizon, sp.oo, 0, higher)",
            "return sp.Integer(0)",
        ),
        pipe["a_ball_that_hardly_moves_across_a_pipe_is_flagged"],
    ),
    Planted(
        "the rate of a box has no margin",
        in_text(
            BoxRootFinder,
            "margins",
            '"rate_margin": ROUNDING_SLACK *',
            '"rate_margin": sp.Rational(1, 2**12) *',
        ),
        boxes,
    ),
    Planted(
        "a box that was left has no margin",
        in_text(
            BoxRootFinder,
            "margins",
            '"leaving_margin": ROUNDING_SLACK *',
            '"leaving_margin": sp.Rational(1, 2**12) *',
        ),
        boxes_left,
    ),
    Planted(
        "the change of a box's gap has its terms of the start",
        in_text(BoxRootFinder, "leaving_gap", "barrier(e + start)", "barrier(2 * start)"),
        boxes_left,
    ),
    Planted(
        "the rate of a box is half of it",
        in_text(BoxRootFinder, "rate", "return 2 * barrier", "return barrier"),
        boxes,
    ),
    Planted(
        "the second derivative of a box is that of its coordinates beyond a face alone",
        in_text(
            BoxRootFinder,
            "ceiling",
            "2 * barrier(3 * self._fastest**2",
            "barrier(self._fastest**2 / 8",
        ),
        boxes,
    ),
    Planted(
        "a box is touched from its centre",
        in_text(Box, "normal", "e / self._length", "-e / self._length"),
        crate,
    ),
    Planted(
        "a box has no lower faces",
        in_text(Box, "excess", "barrier(maximum(barrier(low - place), 0))", "sp.Integer(0)"),
        crate,
    ),
    Planted(
        "a box is turned the other way",
        in_text(ObliqueBox, "turned", "transposed(self.rotation)", "self.rotation"),
        turned_crate,
    ),
    Planted(
        "the normal of a turned box is not turned back",
        in_text(ObliqueBox, "normal", "times(self.rotation, directions)", "directions"),
        turned_crate,
    ),
    Planted(
        "only the first half of a flight is held against a turned box",
        lambda patch: patch.setattr(oblique_box, "may_reach_in_halves", bounding_boxes.may_reach),
        turned_crate,
    ),
    Planted(
        "windows end at the apex",
        in_text(
            box_windows,
            "_falling",
            "[(first, passed), (again, last)]",
            "[(first, passed), (last, last)]",
        ),
        windows_hold,
    ),
    Planted(
        "a ball that moves backwards has the windows of one that moves forwards",
        in_text(box_windows, "_straight", "IfLess(velocity, 0, -place, place)", "place"),
        windows_hold,
    ),
    # Boxes about many bodies.
    Planted(
        "a flight has no apex",
        in_text(bounding_boxes, "flight_box", "if a != 0:", "if a == 7:"),
        posts,
    ),
    Planted(
        "a flight is as large as its way on one side",
        in_text(
            bounding_boxes,
            "flight_box",
            "barrier(high - low) / 2 + slack",
            "barrier(high - low) / 4 + slack",
        ),
        posts,
    ),
    Planted(
        "a body's box is half as large",
        in_text(bounding_boxes, "_sides", "(1 + RELATIVE_SLACK) * half", "half / 2"),
        posts,
    ),
    Planted(
        "the flight's size does not count before a single body",
        in_text(bounding_boxes, "_apart", "wide + reaches[k]", "wide"),
        posts,
    ),
    Planted(
        "whether a ball has sunk is not asked at the time limit",
        in_text(event_loop, "_sinks_at_limit", "if not inputs:", "if True:"),
        OfEngine(test_air.check_sunken_balls, scene=test_air.SUNKEN),
    ),
    # Roots on flat and on large bodies.
    Planted(
        "a root on a plane is refined by Newton's method",
        in_text(PolynomialRootFinder, "refine", "if self._boxed:", "if True:"),
        OfEngine(test_roots.check_states, scene=test_roots.DRAWN),
    ),
    Planted(
        "a flight that begins on two surfaces knows one of them",
        in_text(InclinedPlaneSearch, "remembered", "self.flight.departs", "False"),
        OfEngine(test_leaning_table.check_landings, scene=test_leaning_table.TABLE),
    ),
    Planted(
        "the roundings of a root are those of its flight",
        in_text(search, "root_rounding", "root_delay * absolute(rate)", "0 * rate"),
        OfEngine(test_roots.check_states, scene=test_roots.LARGE),
    ),
    Planted(
        "a wide torus is as exact as its offset",
        in_text(PolynomialRootFinder, "root_delay", "total_degree() <= 2", "total_degree() <= 4"),
        OfEngine(test_root_errors.check_states, scene=test_root_errors.THIN),
    ),
    Planted(
        "a root far away is as exact as its position",
        in_text(
            PolynomialRootFinder,
            "root_delay",
            "rounding(self.surface.shape, sizes).error",
            "UNIT_ROUNDOFF",
        ),
        OfEngine(test_root_errors.check_states, scene=test_root_errors.FAR),
    ),
    Planted(
        "a return to a surface has no rounding of its own",
        in_text(PolynomialRootFinder, "root_delay", "0 if simple else", "0 if True else"),
        OfEngine(test_root_errors.check_returns, scene=test_root_errors.THIN),
    ),
    Planted(
        "a root in air has no rounding of its own",
        in_text(RootSearch, "_root_rounding", "late is None", "not self.flight.exact"),
        OfEngine(test_root_errors.check_states, scene=test_root_errors.FAR_IN_AIR),
    ),
    Planted(
        "a return in air has no rounding of its own",
        in_text(PolynomialRootFinder, "root_delay", "0 if simple else", "0 if True else"),
        OfEngine(test_root_errors.check_returns, scene=test_root_errors.THIN_IN_AIR),
    ),
    Planted(
        "errors are carried in single precision on flat surfaces",
        in_text(DerivedScene, "single_errors", " and not flat", ""),
        OfEngine(test_root_errors.check_upright, scene=test_root_errors.UPRIGHT),
    ),
    # Bodies in any direction.
    Planted(
        "the normal of a torus has no part along its axis",
        in_text(ObliqueTorus, "normal", "c * outward + u * up", "c * outward"),
        turned_tori,
    ),
    # The branch of friction.
    Planted(
        "whether a contact slips is never undecided",
        in_text(event_loop, "_law", 'if "undecided" in surface.law', 'if "none" in surface.law'),
        switch,
    ),
    Planted(
        "the undecided range of slip and grip is a thousandth",
        in_text(
            friction.CoulombFriction,
            "undecided",
            "4 * DECISION_FACTOR",
            "DECISION_FACTOR * sp.Rational(1, 2**12)",
        ),
        switch,
    ),
    Planted(
        "whether a contact slips is always undecided",
        in_text(
            friction.CoulombFriction,
            "undecided",
            "Not(Less(barrier(met.grip",
            "Not(Less(2**40 * barrier(met.grip",
        ),
        switch,
    ),
    Planted(
        "a contact slips from half of the slip on that friction can stop",
        in_text(
            friction.CoulombFriction,
            "_share",
            "stops = barrier(met.grip**2)",
            "stops = 4 * barrier(met.grip**2)",
        ),
        switch,
    ),
)


@pytest.fixture(autouse=True)
def proofs(request: pytest.FixtureRequest) -> None:
    """Make all proofs that an engine is held against before any fault is there."""
    given = request.node.callspec.params
    check = given["check"] if "check" in given else given["fault"].check
    if isinstance(check, OfEngine):
        for name in BATCHES:
            proved(name)


test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
