"""Surfaces that a ball may be behind: on which side of one a flight begins may be undecided."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import Event
from hoopgen.scene import Scene, load_scene
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials
from tests.helpers.proved_bounds import bounded_events

pytest.importorskip("flint")

Floats = NDArray[np.float64]

BALL_RADIUS = 0.12

TEXT = """
name = "{name}"
ball_radius = 0.12
gravity = 9.81
restitution = 0.7
{more}

[parameters]
place = {{ default = 1.0, sign = "any" }}
lean = {{ default = 0.1, sign = "any" }}

{touched}
{passed}

[ends.missed]
at = -1
"""

RING = """
[bodies.ring]
kind = "torus"
radius = 0.235
wire = 0.01
"""
ROOF = """
[bodies.roof]
kind = "sphere"
radius = 0.2
centre = [0, 0, 1]
"""
MORE = {
    "": "",
    "rolls": "friction = 0.5\nrolls = true",
    "leans": 'friction = 0.5\nrolls = true\ndown = ["lean", 0, -1]',
    "air": "air = true",
    "aslant": "friction = 0.5\nrolls = true\ndown = [0.37, 0, -1]",
}
"""Further entries of a scene: none, balls that roll, gravity in any direction, air; gravity along
the plane `hanging`, up to roundings."""
END = '\n[ends.passed]\naxis = "-{axis}"\nat = "place"'
BODY = "\n[bodies.passed]\n"
BOUNDED = (
    *("outcome", "contacts", "counts", "time", "state"),
    *("uncertain", "estimated", "time_error", "state_error"),
)
OPTIONS = {"record": True, "max_contacts": 5}


@dataclass(frozen=True)
class Passed:
    """A surface that a ball may be behind: it ends shots, or it is a body that has bounds.

    Attributes
    ----------
    text
        Its part of the scene's file; `place` moves it.
    at
        The place at which a ball at a position, (n, 3), touches it.
    away
        A place at which no ball touches it.
    """

    text: str
    at: Callable[[Floats], Floats]
    away: float


def along(normal: tuple[float, float, float], room: float, centres: Floats) -> Floats:
    """Return the distance of a plane with a normal in that direction, less some room."""
    return centres @ (np.array(normal) / np.linalg.norm(normal)) - room


def around(axes: list[int], centres: Floats) -> Floats:
    """Return the radius of a surface about the point (0, 0, 2) across some axes."""
    return np.linalg.norm((centres - [0.0, 0.0, 2.0])[:, axes], axis=1) - BALL_RADIUS


def end(axis: str) -> Passed:
    """Return an end that balls pass towards larger coordinates."""
    normal = tuple(-float(axis == letter) for letter in "xyz")
    return Passed(END.format(axis=axis), partial(along, normal, 0.0), -50.0)


def plane(normal: tuple[float, float, float], bounds: str) -> Passed:
    """Return a plane within bounds."""
    text = f'{BODY}kind = "plane"\nnormal = {list(normal)}\nat = "place"\nwithin = {bounds}'
    return Passed(text, partial(along, normal, BALL_RADIUS), -50.0)


def curved(kind: str, axes: list[int]) -> Passed:
    """Return the lower part of a sphere or a cylinder high above the ring."""
    text = f'{BODY}kind = "{kind}"\ncentre = [0, 0, 2]\nradius = "place"\nwithin = ["z - 0.3"]'
    text += '\naxis = "y"' if kind == "cylinder" else ""
    return Passed(text, partial(around, axes), 3.0)


NARROW = '["x - 0.3", "-0.3 - x"]'
LOW = '["z - 0.15"]'
SURFACES = {
    "end across x": end("x"),
    "end across y": end("y"),
    "end across z": end("z"),
    "wall": plane((1.0, 0.0, 0.0), LOW),
    "ceiling": plane((0.0, 0.0, -1.0), NARROW),
    "overhang": plane((0.6, 0.0, -0.8), NARROW),
    "slope": plane((0.6, 0.0, 0.8), LOW),
    "floor": plane((0.0, 0.0, 1.0), '["x - 5"]'),
    "incline": plane((0.6, 0.0, 0.8), '["x - 5"]'),
    "hanging": plane((1.0, 0.0, 0.37), '["x - 5"]'),
    "sphere": curved("sphere", [0, 1, 2]),
    "cylinder": curved("cylinder", [0, 2]),
}
USUAL = [name for name in SURFACES if name not in ("floor", "incline", "hanging")]
OFTEN = {
    *(("end across x", "rolls"), ("end across z", "rolls"), ("wall", "rolls")),
    *(("wall", "leans"), ("ceiling", "rolls"), ("overhang", ""), ("sphere", "")),
}


def ring_and(surface: str, more: str) -> Scene:
    """Return a ring beside a surface that a ball may be behind."""
    name = f"{surface.replace(' ', '_')}_{more}".rstrip("_")
    return scene_of(name, more, surface, RING)


def scene_of(name: str, more: str, surface: str, touched: str) -> Scene:
    """Return a scene with a body that is touched at a surface."""
    passed = SURFACES[surface].text
    text = TEXT.format(name=name, more=MORE[more], touched=touched, passed=passed)
    with TemporaryDirectory() as folder:
        file = Path(folder) / "passed.toml"
        file.write_text(text, encoding="utf-8")
        return load_scene(file)


def passed_by(engine: Engine) -> Passed:
    """Return the surface of a scene that a ball may be behind."""
    (found,) = (s for name, s in SURFACES.items() if engine.name.startswith(name.replace(" ", "_")))
    return found


def check_at_touches(
    engine: Engine, surface: Passed, states: Floats, least: float
) -> NDArray[np.bool_]:
    """Return the shots that are uncertain with the surface where they touch a body first.

    No shot may be wrong without a flag there and one unit beside it, and some are wrong. A
    micrometre beside it none may be wrong, and hardly one is flagged.

    Parameters
    ----------
    engine
        The scene.
    surface
        The surface that the balls may be behind.
    states
        The releases, (n, 9).
    least
        The least share of them that touch the body.

    Returns
    -------
    ndarray
        bool, one of each shot that touches the body.
    """
    log = engine.simulate(states, {"place": surface.away}, **OPTIONS).events
    _, first = np.unique(log["shot"], return_index=True)
    met = log["kind"][first] == Event.IMPACT
    assert np.mean(met) > least
    states, places = states[met], surface.at(log["after"][first[met], :3])
    wrong, uncertain = 0, np.zeros(len(states), bool)
    ulps = (places, np.nextafter(places, np.inf), np.nextafter(places, -np.inf))
    for moved in (*ulps, places + 1e-6, places - 1e-6):
        shots = engine.simulate(states, {"place": moved}, **OPTIONS)
        proof = engine.certify(states, {"place": moved}, processes=1, **OPTIONS)
        assert np.all(proof.agrees(shots))
        if any(moved is one for one in ulps):
            uncertain |= shots.uncertain
            differ = (shots.outcome != proof.outcome) | (shots.contacts != proof.contacts)
            wrong += np.count_nonzero(differ)
        else:
            assert np.mean(shots.uncertain) < 0.05
    assert wrong > 0
    return uncertain


@pytest.fixture(
    params=[
        pytest.param(
            (surface, more),
            id=f"{surface} {more}".strip(),
            marks=[] if (surface, more) in OFTEN else [pytest.mark.slow],
        )
        for surface in USUAL
        for more in ("", "rolls", "leans", "air")
    ]
)
def engine(request: pytest.FixtureRequest) -> Engine:
    """Return the engine of a scene with such a surface."""
    return hoopgen.compile(ring_and(*request.param))


def test_a_ball_that_leaves_the_ring_at_such_a_surface_to_within_a_rounding_is_uncertain(
    engine: Engine,
) -> None:
    """Nothing says whether it is before the surface, or behind it and does not meet it."""
    surface = passed_by(engine)
    count = trials(40, at_least=16) if not engine.in_air else trials(16, at_least=8)
    rng = np.random.default_rng(2)
    azimuth, off = rng.uniform(0, 6, count), rng.normal(0.235, 0.03, count)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 1] = off * np.cos(azimuth), off * np.sin(azimuth)
    states[:, 2] = rng.uniform(0.5, 0.8, count)
    states[:, 3:6] = rng.normal(0, 0.1, (count, 3))
    uncertain = check_at_touches(engine, surface, states, 0.5)
    assert np.mean(uncertain) > 0.1


def rising(count: int) -> Floats:
    """Return balls that rise from far below to a sphere, and fall from it."""
    rng = np.random.default_rng(3)
    states = np.zeros((count, 9))
    states[:, :2] = rng.uniform(-0.15, 0.15, (count, 2))
    states[:, 2] = rng.uniform(-0.5, 0.0, count)
    states[:, 3:5] = rng.normal(0, 0.2, (count, 2))
    states[:, 5] = rng.uniform(5.5, 6.5, count)
    return states


def thrown(count: int) -> Floats:
    """Return balls that come to the ring from all sides."""
    rng = np.random.default_rng(11)
    azimuth, off = rng.uniform(0, 6, count), rng.normal(0.235, 0.05, count)
    states = np.zeros((count, 9))
    states[:, 2] = rng.uniform(0.3, 0.8, count)
    states[:, 3:5] = rng.normal(0, 1.5, (count, 2))
    flown = states[:, 3:5] * np.sqrt(2 * (states[:, [2]] - 0.1) / 9.81)
    states[:, :2] = off[:, None] * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1) - flown
    return states


FALLING = [
    ("floor", ""),
    ("floor", "rolls"),
    ("incline", ""),
    ("incline", "rolls"),
    ("hanging", "aslant"),
]
"""Plates that gravity pulls to, or may to within a rounding, and further entries of the scene."""


def falling_at(surface: str, more: str) -> Scene:
    """Return a scene with a body from which balls fall at a plate that they came to from behind."""
    touched = RING if surface == "hanging" else ROOF
    return scene_of(f"falling_{surface}_{more}".rstrip("_"), more, surface, touched)


@pytest.fixture(params=[pytest.param(each, id=" ".join(each).strip()) for each in FALLING])
def falling(request: pytest.FixtureRequest) -> Engine:
    """Return the engine of a scene with such a plate."""
    return hoopgen.compile(falling_at(*request.param))


def test_a_ball_that_falls_from_a_body_at_a_plate_to_within_a_rounding_is_uncertain(
    falling: Engine,
) -> None:
    """Nothing says whether it meets the plate, or is still behind it, where it came from."""
    engine = falling
    passed = SURFACES[engine.name.split("_")[1]]
    throw = thrown if "hanging" in engine.name else rising
    states = throw(trials(120, at_least=100))
    check_at_touches(engine, passed, states, 0.4)


def test_bounds_are_proved_where_a_wall_ends_shots_and_balls_roll() -> None:
    engine = hoopgen.compile(ring_and("end across x", "rolls"))
    states = thrown(trials(200, at_least=80))
    place = {"place": -np.random.default_rng(5).uniform(-0.3, 0.3, len(states))}
    shots = engine.simulate(states, place, **OPTIONS, fields=BOUNDED)
    proof = engine.certify(states, place, processes=1, **OPTIONS)
    assert np.mean(shots.proved) > 0.9
    assert np.mean(shots.uncertain) < 0.05
    assert np.all(proof.agrees(shots))
    assert np.count_nonzero(bounded_events(shots, proof)) > len(states)
    assert np.all(np.bincount(shots.outcome, minlength=2)[:2] > len(states) / 10)
