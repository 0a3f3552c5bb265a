"""The inertia of the ball of `AIR`: impacts, the limit without air, presets, and its range."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("sympy")  # which derives the scene

from hoopgen.derive.contact.ball import THIN_SHELL as SHELL
from hoopgen.derive.scenes.air import AIR as SCENE
from hoopgen.derive.scenes.hoop import HOOP

import hoopgen
from hoopgen import AIR, COURT, PAPER, PAPER_AIR, PAPER_COURT, Event, Outcome
from hoopgen.core.backend_names import BackendName
from hoopgen.core.parameters import AIR_DEFAULTS, THIN_SHELL
from tests.helpers.effort import trials

# One worker: the scene is compiled once.
pytestmark = pytest.mark.xdist_group("air")

Floats = NDArray[np.float64]

SOLID = 2 / 5
KAPPAS = (THIN_SHELL, SOLID, 1.0, 1 / 64)
CLAIMS = ("outcome", "contacts", "time", "state", "uncertain", "time_error", "state_error")
NO_AIR = {"air_density": 0.0, "drag_coefficient": 0.0, "lift_coefficient": 0.0}


def throws(count: int, seed: int) -> Floats:
    """Return free throws with spin about every axis, at ring, board and bridge."""
    random = np.random.default_rng(seed)
    states: Floats = hoopgen.release(
        random.normal(7.5, 0.3, count),
        random.normal(0.9, 0.06, count),
        azimuth=random.normal(0.0, 0.03, count),
        backspin=random.normal(15.0, 20.0, count),
        sidespin=random.normal(0.0, 20.0, count),
        height=2.1,
        distance=4.191,
    )
    states[:, 6] += random.normal(0.0, 20.0, count)
    return states


def is_on_a_face_of_both(events: Any, of: Any) -> NDArray[np.bool_]:
    """Return which contacts of `COURT` are on ring, front of the board, or top of the bridge.

    The article's bridge ends at the wire's centre circle, that of `COURT` at a straight edge. In
    between, `COURT` has the ring alone; one millimetre is more than a ball flies from one to it.
    """
    x, y, z = events["before"][:, :3].T
    board, bridge = (events["surface"] == body for body in (1, 2))
    front = x > -of["board_distance"]
    front &= (np.abs(y) < of["board_half_width"]) & (of["board_bottom"] < z) & (z < of["board_top"])
    top = (np.abs(y) < of["bridge_half_width"]) & (z > of["wire_radius"])
    top &= (-of["board_distance"] < x) & (x < -of["ring_radius"])
    beside = (np.abs(y) < of["bridge_half_width"]) & (x < 0)
    ring = (events["surface"] == 0) & ~(beside & (np.hypot(x, y) > of["ring_radius"] - 1e-3))
    return ring | (board & front) | (bridge & top) | ended(events)


def ended(events: Any) -> Any:
    return events["kind"] == Event.END


def sequences(shots: Any) -> list[Any]:
    """Return the kinds of the events of each shot, and their bodies where there is one."""
    log = shots.events
    body = np.where(ended(log), -1, log["surface"])
    cuts = np.searchsorted(log["shot"], np.arange(len(shots.outcome) + 1))
    pairs = list(zip(log["kind"].tolist(), body.tolist(), strict=True))
    return [pairs[first:last] for first, last in pairwise(cuts)]


def test_without_air_balls_obey_the_article_s_law_with_their_own_inertia() -> None:
    """`COURT` has Coulomb's law, whose limit of infinite friction is derived in another way.

    Shots are compared that meet only what both hoops have. With the inertia of a thin shell nearly
    all that touch something are other shots.
    """
    count = trials(8_000, at_least=2_000)
    states, random = throws(count, 1), np.random.default_rng(2)
    kappa = random.uniform(0.1, 1.0, count)
    kappa[::4], kappa[1::8] = SOLID, 1 / 64
    court = hoopgen.simulate(
        states, {"inertia": kappa}, scene=COURT, max_contacts=12, record=True, fields=CLAIMS
    )
    shared = np.ones(count, bool)
    log = court.events
    shared[log["shot"][~is_on_a_face_of_both(log, PAPER_COURT)]] = False
    shared[log["shot"][np.isin(log["kind"], (Event.ROLL, Event.LEAVE))]] = False
    given: Any = {**NO_AIR, "inertia": kappa}
    own = AIR.simulate(states, given, max_contacts=12, record=True, fields=CLAIMS)
    sure = shared & ~own.uncertain & ~court.uncertain
    assert sure.mean() > 0.8
    assert (sure & (own.contacts > 1)).mean() > 0.2
    mine, others = sequences(own), sequences(court)
    assert all(mine[row] == others[row] for row in np.flatnonzero(sure))
    late = np.abs(own.time - court.time)[sure]
    assert (late <= (own.time_error + court.time_error)[sure]).all()
    off = np.abs(own.state - court.state)[sure].reshape(-1, 3, 3).max(axis=2)
    assert (off <= (own.state_error + court.state_error)[sure]).all()
    shell = AIR.simulate(states, NO_AIR, max_contacts=12, fields=CLAIMS)
    apart = np.abs(shell.state - court.state).reshape(-1, 3, 3).max(axis=2)
    wrong = (apart > shell.state_error + court.state_error).any(axis=1)
    assert wrong[sure & (own.contacts > 0)].mean() > 0.9


def test_an_impact_in_air_keeps_the_angular_momentum_about_the_contact_point() -> None:
    """The impact leaves the ball rolling and keeps the spin about the normal."""
    count = trials(400)
    kappa = np.repeat(KAPPAS, count)
    states = throws(len(kappa), 3)
    log = AIR.simulate(states, {"inertia": kappa}, record=True, max_contacts=4).events
    log = log[log["kind"] == Event.IMPACT]
    assert len(log) > count
    place, before, after = log["before"][:, :3], log["before"][:, 3:], log["after"][:, 3:]
    out = place / np.hypot(*place[:, :2].T)[:, None] * (1.0, 1.0, 0.0)
    n = place - PAPER_AIR["ring_radius"] * out
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    for body, normal in ((1, (1.0, 0.0, 0.0)), (2, (0.0, 0.0, 1.0))):
        n[log["surface"] == body] = normal
    assert set(log["surface"]) == {0, 1, 2}
    own, radius = kappa[log["shot"]][:, None], PAPER_AIR["ball_radius"]
    moved, turned = (after - before)[:, :3], (after - before)[:, 3:]
    size = np.abs(before[:, :3]).sum(axis=1) + radius * np.abs(before[:, 3:]).sum(axis=1)
    kept = own * radius**2 * turned + radius * np.cross(n, moved)
    # The normal is that of the rounded place, at a distance of 0.13 m: some ten roundings.
    assert (np.abs(kept).max(axis=1) < 1e-14 * radius * size).all()
    assert (np.abs(np.sum(turned * n, axis=1)) * radius < 1e-14 * size).all()
    speed = np.sum(after[:, :3] * n, axis=1, keepdims=True)
    slip = after[:, :3] - speed * n - radius * np.cross(after[:, 3:], n)
    # A core of 1/64 spins by 64 times what its contact gives it.
    assert (np.linalg.norm(slip, axis=1) < 1e-14 / own[:, 0] * size).all()
    as_shell = THIN_SHELL * radius**2 * turned + radius * np.cross(n, moved)
    assert (np.abs(as_shell).max(axis=1) > 1e-6 * radius * size)[own[:, 0] != THIN_SHELL].all()


def test_the_inertia_of_the_next_shot_changes_no_bits_and_engines_agree() -> None:
    count = trials(30)
    states, kappa = np.tile(throws(count, 4), (len(KAPPAS), 1)), np.repeat(KAPPAS, count)
    together, by_numpy = (
        AIR.simulate(states, {"inertia": kappa}, fields=CLAIMS, backend=backend)
        for backend in ("c", "numpy")
    )
    for name in CLAIMS:
        assert getattr(by_numpy, name).tobytes() == getattr(together, name).tobytes()
    for one in KAPPAS:
        own = kappa == one
        alone = AIR.simulate(states[own], {"inertia": one}, fields=CLAIMS)
        for name in CLAIMS:
            assert getattr(alone, name).tobytes() == getattr(together, name)[own].tobytes()


def test_a_thin_shell_is_the_default_and_mappings_without_an_inertia_remain_valid() -> None:
    assert float(SHELL) == THIN_SHELL == PAPER_COURT["inertia"]
    states = throws(trials(200), 5)
    before = {**PAPER, **AIR_DEFAULTS}  # all parameters that the scene had without it
    plain, said, short = (
        AIR.simulate(states, given, fields=CLAIMS) for given in (None, {"inertia": 2 / 3}, before)
    )
    for name in CLAIMS:
        assert getattr(plain, name).tobytes() == getattr(said, name).tobytes()
        assert getattr(plain, name).tobytes() == getattr(short, name).tobytes()


def test_the_inertia_stands_between_the_parameters_of_the_hoop_and_those_of_the_air() -> None:
    names = [*(p.name for p in HOOP.parameters), "inertia", *AIR_DEFAULTS]
    assert [p.name for p in SCENE.parameters] == names
    for preset in (PAPER_AIR, hoopgen.NBA_AIR, hoopgen.FIBA_AIR, AIR.parameters):
        assert list(preset) == names
        assert preset["inertia"] == THIN_SHELL
    assert dict(PAPER_AIR) == dict(AIR.parameters)
    assert "inertia" not in PAPER


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_an_inertia_that_no_ball_has_makes_its_own_row_invalid(backend: BackendName) -> None:
    wrong = np.array([SOLID, 0.0, -SOLID, -1.0, 2.0, math.nan, math.inf, 1 / 65, 1 / 64, 1.0])
    invalid = [False, *[True] * 7, False, False]
    states = np.tile(throws(1, 6), (len(wrong), 1))
    shots = AIR.simulate(states, {"inertia": wrong}, backend=backend)
    assert (shots.outcome == Outcome.INVALID).tolist() == invalid
    assert np.isnan(shots.state).all(axis=1).tolist() == invalid
    for value in wrong[1:8]:
        with pytest.raises(
            ValueError, match=r"parameters\['inertia'\]: expected 0.015625 to 1, go"
        ):
            AIR.simulate(states, {"inertia": float(value)}, backend=backend)


def test_the_reason_why_a_ball_s_inertia_is_invalid_is_told() -> None:
    wrong = np.array([SOLID, 0.0, 2.0, math.nan])
    states = np.tile(throws(1, 6), (len(wrong), 1))
    told = hoopgen.why_invalid(states, {"inertia": wrong}, scene=AIR)
    limits = "inertia has to be from 0.015625 to 1"
    assert told == [
        "",
        f"parameter not allowed: inertia 0; {limits}",
        f"parameter not allowed: inertia 2; {limits}",
        "not finite: inertia",
    ]
