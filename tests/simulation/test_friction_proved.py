"""Proved bounds in a scene of one's own with friction: the judge finds no larger error.

The ball grips or slips, with restitution that falls with speed, and keeps spin. Contacts at the
switch between grip and slip are uncertain.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from benchmarks.workloads import WORKLOADS
from hoopgen import Outcome
from hoopgen.scene.files import load_scene
from tests.helpers.compiled import needs_compiler
from tests.helpers.effort import trials
from tests.helpers.proved_bounds import bounded_events

pytestmark = needs_compiler

Floats = NDArray[np.float64]

FIELDS = (
    "outcome",
    "contacts",
    "counts",
    "uncertain",
    "time",
    "state",
    "time_error",
    "state_error",
)
OPTIONS: dict[str, Any] = {"record": True, "max_contacts": 40}
FRICTION = [0.2, 0.5, 0.0, np.inf]
TANGENTIAL, FALLING, RESTITUTION, INERTIA, RADIUS = 0.1, 40.0, 0.7, 2 / 3, 0.12128
RING, WIRE = 0.235, 0.01

SCENE = f"""
name = "grips"
ball_radius = {RADIUS}
gravity = 9.81
inertia = "inertia"
restitution = "e0"
restitution_speed = "v0"
tangential = "et"
friction = "mu"

[parameters]
radius = {{ default = {RING} }}
wire = {{ default = {WIRE} }}
distance = {{ default = 0.381 }}
e0 = {{ default = {RESTITUTION}, unit = "1" }}
mu = {{ default = 0.5, unit = "1", infinite = true }}
et = {{ default = {TANGENTIAL}, unit = "1", sign = "any" }}
v0 = {{ default = {FALLING}, unit = "m/s", infinite = true }}
inertia = {{ default = {INERTIA}, unit = "1" }}

[bodies.ring]
kind = "torus"
radius = "radius"
wire = "wire"

[bodies.board]
kind = "plane"
normal = [1, 0, 0]
at = "-distance"
within = ["-0.14 - z", "z - 0.9268", "y - 0.9144", "-0.9144 - y"]

[ends.made]
at = -0.024
within = ["x**2 + y**2 - radius**2"]

[ends.missed]
at = -0.024
"""


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> hoopgen.Engine:
    """Return a scene in which contacts grip or slip."""
    file: Path = tmp_path_factory.mktemp("scenes") / "grips.toml"
    file.write_text(SCENE, encoding="utf-8")
    return hoopgen.compile(load_scene(file))


def states(count: int) -> Floats:
    """Return so many free throws, shots that bounce often and shots that swirl."""
    return np.concatenate([w.make(count) for w in WORKLOADS[1:4]])


def law_of(friction: float) -> dict[str, float]:
    """Return the parameters of a law; without slip, it is the article's."""
    usual = {"mu": friction}
    return usual if np.isfinite(friction) else usual | {"et": 0.0, "v0": np.inf}


@pytest.mark.parametrize("friction", FRICTION)
def test_both_engines_have_the_same_bits_and_their_bounds_are_proved(
    engine: hoopgen.Engine, friction: float
) -> None:
    given = states(trials(2000))
    one, other = (
        engine.simulate(given, law_of(friction), **OPTIONS, fields=FIELDS, backend=backend)
        for backend in ("c", "numpy")
    )
    assert one.proved.all()
    assert other.proved.all()
    for name in FIELDS:
        assert getattr(one, name).tobytes() == getattr(other, name).tobytes(), name
    assert one.events.tobytes() == other.events.tobytes()
    # Without slip some shots swirl to the limit of contacts.
    assert np.mean(one.uncertain & (one.outcome != Outcome.CAPPED)) < 0.05
    assert np.mean(one.contacts > 1) > 0.5


@pytest.mark.parametrize("friction", FRICTION)
def test_the_judge_finds_no_other_shot_and_no_larger_error(
    engine: hoopgen.Engine, friction: float
) -> None:
    pytest.importorskip("flint")
    given = states(trials(300, at_least=50))
    shots = engine.simulate(given, law_of(friction), **OPTIONS, fields=FIELDS)
    proof = engine.certify(given, law_of(friction), **OPTIONS)
    assert proof.agrees(shots).all()
    assert np.count_nonzero(bounded_events(shots, proof)) > 2 * len(given)
    ended = ~shots.uncertain & proof.decided & np.isfinite(proof.time)
    assert np.mean(ended) > 0.8
    late = np.abs(shots.time - proof.time) - proof.time_radius
    assert np.all(late[ended] <= shots.time_error[ended])
    away = (np.abs(shots.state - proof.state) - proof.state_radius).reshape(-1, 3, 3)
    assert np.all(away.max(axis=2)[ended] <= shots.state_error[ended])


# --------------------------------------------------------------------------------- at the switch


def margins(first: NDArray[np.void], spin: Floats, friction: float) -> Floats:
    """Return by how much first contacts grip, m/s, if the balls had another spin.

    Parameters
    ----------
    first
        Their events.
    spin
        The spins, (n, 3).
    friction
        Coulomb's mu.
    """
    place, moving = first["before"][:, :3], first["before"][:, 3:6]
    far = np.hypot(place[:, 0], place[:, 1])
    out = (far - RING) / far / (RADIUS + WIRE)
    ring = np.stack([place[:, 0] * out, place[:, 1] * out, place[:, 2] / (RADIUS + WIRE)], axis=1)
    normal = np.where((first["surface"] == 0)[:, None], ring, [1.0, 0.0, 0.0])
    onto = np.sum(moving * normal, axis=1)
    slip = moving - onto[:, None] * normal - RADIUS * np.cross(spin, normal)
    slide = -friction * (1 + RESTITUTION / (1 - onto / FALLING)) * onto
    grip = INERTIA * (1 + TANGENTIAL) / (1 + INERTIA)
    return np.asarray(slide - grip * np.sqrt(np.sum(slip**2, axis=1)))


def at_the_switch(engine: hoopgen.Engine, friction: float) -> tuple[Floats, Floats]:
    """Return releases whose first contacts are the last that grip, and the first that slip.

    Their spin is found by bisection: it does not act on the flight.
    """
    given = states(trials(1000, at_least=300))
    shots = engine.simulate(given, {"mu": friction}, **OPTIONS, fields=FIELDS)
    hit, rows = np.unique(shots.events["shot"], return_index=True)
    hit, rows = (kept[shots.contacts[hit] > 0] for kept in (hit, rows))
    given, first = given[hit], shots.events[rows]
    turn = np.random.default_rng(1).normal(0, 60, (len(given), 3))
    low, high = np.zeros(len(given)), np.ones(len(given))
    begins, ends = (margins(first, share[:, None] * turn, friction) for share in (low, high))
    rows = np.flatnonzero(begins * ends < 0)
    assert len(rows) > 0.1 * len(given)
    given, first, turn, grips = given[rows], first[rows], turn[rows], begins[rows] > 0
    low, high = low[rows], high[rows]
    for _ in range(70):
        middle = (low + high) / 2
        same = (margins(first, middle[:, None] * turn, friction) > 0) == grips
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = [np.concatenate([given[:, :6], share[:, None] * turn], axis=1) for share in (low, high)]
    gripping, slipping = (np.where(grips[:, None], *pair) for pair in (found, found[::-1]))
    return gripping, slipping


@pytest.mark.parametrize("friction", [0.2, 0.5])
def test_a_contact_at_the_switch_between_grip_and_slip_is_uncertain(
    engine: hoopgen.Engine, friction: float
) -> None:
    """A millionth away from it nearly none is."""
    releases = at_the_switch(engine, friction)
    for given in releases:
        shots = engine.simulate(given, {"mu": friction}, **OPTIONS, fields=FIELDS)
        assert shots.uncertain.all()
        assert np.all(shots.contacts > 0)
    middle = (releases[0] + releases[1]) / 2
    for share in (1 - 1e-6, 1 + 1e-6):
        off = np.concatenate([middle[:, :6], share * middle[:, 6:]], axis=1)
        shots = engine.simulate(off, {"mu": friction}, max_contacts=1, record=True, fields=FIELDS)
        first = ~np.isfinite(shots.state_error).all(axis=1)
        assert np.mean(first) < 0.1


@pytest.mark.slow
@pytest.mark.parametrize("friction", [0.2, 0.5])
def test_the_judge_agrees_close_to_the_switch(engine: hoopgen.Engine, friction: float) -> None:
    """Within 10^-16 to 10^-6 of it shots are as proved, or uncertain."""
    pytest.importorskip("flint")
    gripping, _ = at_the_switch(engine, friction)
    random = np.random.default_rng(2)
    gripping = gripping[: trials(600, at_least=100)]
    off = random.choice([-1, 1], len(gripping)) * 10 ** random.uniform(-16, -6, len(gripping))
    gripping[:, 6:] *= (1 + off)[:, None]
    shots = engine.simulate(gripping, {"mu": friction}, **OPTIONS, fields=FIELDS)
    proof = engine.certify(gripping, {"mu": friction}, **OPTIONS)
    assert proof.agrees(shots).all()
    assert 0.1 < np.mean(shots.uncertain) < 0.9
    assert np.any(bounded_events(shots, proof))
