"""The event loop asks for the seams of boxes that balls roll on or towards: its nodes, in order."""

from __future__ import annotations

from itertools import pairwise

from hoopgen.derive import model
from hoopgen.derive.ir.event_tree import Call, walk

from hoopgen.scene import Box, Disc, Plane, Scene

SIZE = (0.5, 0.3, 0.2)
CUT = ("x - 0.1",)

SCENE = Scene(
    "boxes_with_seams",
    bodies=[
        Box("slab", size=SIZE, within=CUT),
        Box("crate", size=SIZE, centre=(0, 2, 0), orientation=(0.9, 0.1, 0.3, 0.2), within=CUT),
        Disc("table", radius=0.4, centre=(0, 4, 0)),
        Plane("floor", at=-1),
    ],
    ball_radius=0.05,
    gravity=9.81,
    restitution=0.3,
    rolls=True,
)
BOXES = ("slab", "crate")


def evaluations(stage: str) -> list[str]:
    """Return the kernels that a stage of the scene's loop evaluates, in order."""
    nodes = walk(model.build(SCENE.derive()).loop.stages[stage])
    return [node.kernel.name for node in nodes if isinstance(node, Call)]


def test_each_bound_of_a_box_beside_a_ball_is_decided_with_the_seam_that_is_nearest() -> None:
    """In contact and in flight; the bound of a disc has no seams."""
    names, decided = evaluations("detect"), []
    for place, (bound, decision) in enumerate(pairwise(names)):
        body, _, part = bound.partition("_")
        if part.startswith("rim") and decision.startswith("outside_bound"):
            decided.append((body, decision))
            first = place - names[place::-1].index("unbounded")
            assert (f"{body}_crease" in names[first:place]) == (body in BOXES), (body, decision)
    contact, flight = ("outside_bound_of_box", "outside_bound_of_box_in_flight")
    assert {(box, decision) for box in BOXES for decision in (contact, flight)} | {
        ("table", "outside_bound"),
        ("table", "outside_bound_in_flight"),
    } == set(decided)


def test_each_seam_of_the_box_under_a_ball_is_decided() -> None:
    """As a ball rolls, as it leaves, and as its bounces end."""
    seams = {f"{box}_seam{k}" for box in BOXES for k in range(6)}
    found = {pair for stage in ("detect", "resolve") for pair in pairwise(evaluations(stage))}
    for decision in ("beside_seam", "seam_free_time", "near_seam"):
        assert {one for one, follower in found if follower == decision} == seams, decision
    assert {follower for one, follower in found if one == "near_seam"} == {"seam_undecided"}
