"""The proof that a ball rolls on a ring for ever: which swings it counts, and with what room."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import court

pytest.importorskip("flint")

from tests.derive.rolling.test_contact_phase import Rolling

SWIRL = (140.0, -0.4, 1.0, -0.2)
"""A ball that swings about a steady angle, and turns every few tenths of a second."""


def followed(room: Any, force: float = 0.0) -> tuple[list[float], float]:
    """Return when the angle around the wire turns, and when the proof is complete, by steps.

    Parameters
    ----------
    room
        The distance from other bodies as a function of how often the ball has turned.
    force
        What the normal force is less than it is.
    """
    ball, turns, proved = Rolling(*SWIRL), list[float](), math.inf
    ball.values |= {"circled": 0.0, "which": -1.0, "undecided_time": math.inf}
    ball.values |= {"position_error": 1e-13, "velocity_error": 1e-13}
    ball.expand()
    ball.values["climb"] = ball["climb_0"]
    while ball.clock < 3.0:
        ball.expand()
        before = ball["climb_0"]
        ball.values["azimuth_clearance"] = room(len(turns))
        ball.values["force"] -= force
        ball.step(math.inf)
        ball.call("ring_swung")
        if ball.values["endless"] and math.isinf(proved):
            proved = ball.clock
        if before * ball["climb"] < 0:
            turns.append(ball.clock)
    return turns, proved


@pytest.mark.slow
def test_the_proof_takes_a_whole_swing_that_is_safe() -> None:
    """Between turning points the ball has room and is pressed on."""
    turns, proved = followed(lambda _: 0.01)
    assert len(turns) > 3
    assert proved == turns[1]
    # Where it comes near something in the second swing, the proof begins anew behind that.
    turns, proved = followed(lambda swing: 0.0 if swing == 1 else 0.01)
    assert proved == turns[3]
    assert math.isinf(followed(lambda _: 0.01, force=50.0)[1])


def test_the_bound_at_any_azimuth_holds_for_half_a_step() -> None:
    """The distance from a convex body lies above its tangent."""
    random = np.random.default_rng(3)
    for _ in range(100):
        gap, nearing, half = random.uniform([0.01, -2.0, -0.02], [0.3, 2.0, 0.02])
        given = {"gap": gap, "nearing": nearing, "half_step": half, "azimuth_clearance": 1.0}
        named = court.ARGUMENTS["clearance_at_any_azimuth"]
        (found,) = np.ravel(court.clearance_at_any_azimuth(*(given[name] for name in named)))
        assert found == pytest.approx(min(1.0, gap, gap + nearing * half), rel=1e-15)
