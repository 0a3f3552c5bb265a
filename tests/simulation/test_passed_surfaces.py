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

[bodies.ring]
kind = "torus"
radius = 0.235
wire = 0.01
{passed}

[ends.missed]
at = -1
"""

MORE = {
    "": "",
    "rolls": "friction = 0.5\nrolls = true",
    "leans": 'friction = 0.5\nrolls = true\ndown = ["lean", 0, -1]',
    "air": "air = true",
}
"""Further entries of a scene: none, balls that roll, gravity in any direction, air."""
END = '\n[ends.passed]\naxis = "-{axis}"\nat = "place"'
BODY = "\n[bodies.passed]\n"
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
    """Return the distance of a plane with that normal, less some room."""
    return centres @ np.array(normal) - room


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
    "sphere": curved("sphere", [0, 1, 2]),
    "cylinder": curved("cylinder", [0, 2]),
}
OFTEN = {
    *(("end across x", "rolls"), ("end across z", "rolls"), ("wall", "rolls")),
    *(("wall", "leans"), ("ceiling", "rolls"), ("overhang", ""), ("sphere", "")),
}


def ring_and(surface: str, more: str) -> Scene:
    """Return a ring beside a surface that a ball may be behind."""
    name = f"{surface.replace(' ', '_')}_{more}".rstrip("_")
    text = TEXT.format(name=name, more=MORE[more], passed=SURFACES[surface].text)
    with TemporaryDirectory() as folder:
        file = Path(folder) / "passed.toml"
        file.write_text(text, encoding="utf-8")
        return load_scene(file)


def passed_by(engine: Engine) -> Passed:
    """Return the surface of a scene that a ball may be behind."""
    (found,) = (s for name, s in SURFACES.items() if engine.name.startswith(name.replace(" ", "_")))
    return found


@pytest.fixture(
    params=[
        pytest.param(
            (surface, more),
            id=f"{surface} {more}".strip(),
            marks=[] if (surface, more) in OFTEN else [pytest.mark.slow],
        )
        for surface in SURFACES
        for more in MORE
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
    log = engine.simulate(states, {"place": surface.away}, **OPTIONS).events
    _, first = np.unique(log["shot"], return_index=True)
    met = log["kind"][first] == Event.IMPACT
    assert np.mean(met) > 0.5
    states, places = states[met], surface.at(log["after"][first[met], :3])
    wrong, uncertain = 0, np.zeros(len(states), bool)
    for moved in (places, np.nextafter(places, np.inf), np.nextafter(places, -np.inf)):
        shots = engine.simulate(states, {"place": moved}, **OPTIONS)
        proof = engine.certify(states, {"place": moved}, processes=1, **OPTIONS)
        assert np.all(proof.agrees(shots))
        uncertain |= shots.uncertain
        wrong += np.count_nonzero(
            (shots.outcome != proof.outcome) | (shots.contacts != proof.contacts)
        )
    assert wrong > 0
    assert np.mean(uncertain) > 0.1
    for moved in (places + 1e-6, places - 1e-6):
        shots = engine.simulate(states, {"place": moved}, **OPTIONS)
        proof = engine.certify(states, {"place": moved}, processes=1, **OPTIONS)
        assert np.all(proof.agrees(shots))
        assert np.mean(shots.uncertain) < 0.05
