"""A start whose body is looked up in a list of its own: the loop goes on with what it loaded."""

from __future__ import annotations

import numpy as np
import pytest

import hoopgen
from hoopgen.codegen.c import CBackend, Options
from hoopgen.codegen.registry import BACKENDS
from hoopgen.scene import Cone, End, Scene
from tests.helpers.compiled import needs_compiler

CONES = Scene(
    "cones_with_a_list",
    bodies=[
        Cone("left", apex=(-0.3, 0, 0), axis=(0.1, 0, -1), half_angle="30deg"),
        Cone("right", apex=(0.3, 0, 0), axis=(0, 0.1, -1), half_angle="40deg"),
    ],
    ball_radius=0.05,
    gravity=9.81,
    restitution=0.7,
    ends={"down": End(at=-1)},
)
"""Each cone has two surfaces, its side and its apex."""


@needs_compiler
@pytest.mark.slow
def test_a_costly_look_up_of_the_body_below_a_start_compiles(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(BACKENDS, "c", CBackend(options=Options(min_outlined_cost=40)))
    engine = hoopgen.compile(CONES)
    assert engine.backend == "c"
    rng = np.random.default_rng(1)
    states = np.zeros((200, 9))
    states[:, :3] = rng.uniform((-0.5, -0.3, -0.2), (0.5, 0.3, 0.3), (200, 3))
    states[:, 3:6] = rng.normal(0, 1, (200, 3))
    leaving = rng.integers(-1, 2, 200)
    one, other = (
        engine.simulate(states, leaving=leaving, max_contacts=5, backend=backend)
        for backend in ("c", "numpy")
    )
    for name in ("outcome", "contacts", "time", "state", "uncertain"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
