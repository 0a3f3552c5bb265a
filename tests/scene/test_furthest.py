"""The distance of a ball that touches a body from the point about which the body is searched.

A search goes on until the ball is further off than that for good.
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.symbolic.symbols import POSITION

from hoopgen.scene import Cone, Cylinder, Parameter, Revolution, Scene
from hoopgen.scene.pieces import Body
from tests.derive.test_evaluation import in_doubles
from tests.helpers.effort import occurrences, trials

PLACE = (0.2, -0.1, 0.3)
LEANING = ("lean", -0.3, 0.8)
PROFILE = [(0.0, -0.3), (0.35, -0.1), (0.3, 0.2), (0.3, 0.4)]
BODIES: dict[str, Body] = {
    "cone": Cone("it", apex=PLACE, axis=("lean", -0.3, -0.8), slope=2.0, span=(0.05, 0.4)),
    "funnel": Cone("it", apex=PLACE, axis=LEANING, slope=0.8, span=(0.1, 0.5), inside=True),
    "tube": Cylinder("it", radius=0.3, centre=PLACE, axis=LEANING, span=(-0.4, 0.2)),
    "pipe": Cylinder("it", radius=0.3, centre=PLACE, axis="z", span=(0.0, 0.5)),
    "bowl": Revolution("it", profile=PROFILE, centre=PLACE, axis=LEANING),
}


@pytest.mark.parametrize("body", list(BODIES))
def test_no_contact_is_further_off_than_is_known(body: str) -> None:
    """Nor much nearer, all of them. The pipe has a box, the others have a distance."""
    lean = Parameter("lean", 0.45, "1", sign="any")
    scene = Scene(
        "any",
        parameters=[lean],
        bodies=[BODIES[body]],
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.7,
    )
    inputs = dict(zip((i.name for i in scene.inputs), scene.values(), strict=True))
    chance = np.random.default_rng(3)
    checked = 0
    for surface in scene.derive().surfaces:
        known = getattr(surface, "furthest", None)
        halves = surface.half_sizes if known is None else (known,)
        if None in halves or (known is None and body == "bowl"):  # rounded edges have boxes
            continue
        formulas = {"gap": surface.distance}
        for name, made in (
            ("normal", surface.normal),
            ("bound", surface.bounds),
            ("centre", surface.reference_point),
            ("half", halves),
        ):
            formulas |= {f"{name}{k}": sp.sympify(part) for k, part in enumerate(made)}
        places = np.array(PLACE) + chance.uniform(-1, 1, (trials(20_000, at_least=5_000), 3))
        for _ in range(2):  # onto the surface, and what is there
            here = dict(zip(map(str, POSITION), places.T, strict=True)) | inputs
            values = in_doubles(formulas, here)
            normal = np.stack(
                [np.broadcast_to(values[f"normal{k}"], len(places)) for k in range(3)], axis=1
            )
            normal /= np.linalg.norm(normal, axis=1, keepdims=True)
            places = places - values["gap"][:, None] * normal
        met = np.abs(values["gap"]) < 1e-9
        for k in range(len(surface.bounds)):
            met &= values[f"bound{k}"] <= 0.0
        apart = [np.abs(p - values[f"centre{k}"]) for k, p in enumerate(places.T)]
        if known is not None:
            apart = [np.sqrt(sum(part**2 for part in apart))]
        share = np.max([part / values[f"half{k}"] for k, part in enumerate(apart)], axis=0)[met]
        assert len(share) >= occurrences(50)
        assert (share <= 1.0 + 1e-12).all()
        assert share.max() > 0.4
        checked += 1
    assert checked == {"bowl": 6}.get(body, 1)
