"""Bounds of points of contact beside and under a rolling ball: how fast their distances change."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.ir.kernel import Kernel, loop_kernel
from hoopgen.derive.rolling import bounds
from hoopgen.derive.rolling.symbols import fastest, strongest
from numpy.typing import NDArray

from hoopgen.scene import Box, Cone, Scene
from tests.helpers.bounded_rolls import bound
from tests.helpers.derived import evaluation
from tests.helpers.effort import trials
from tests.scene import test_cone_rolls
from tests.scene.test_oblique_rolls import BALL, GRAVITY
from tests.scene.test_turned_boxes import rotation

Floats = NDArray[np.float64]

CUTS = ("x/2 - y + z/3 - 0.02", "x**2 + 2*y**2 - z*x - 0.04", "-z - 0.05")
FUNNEL = {"apex": (0.1, 0.0, -0.1), "axis": (0.3, -0.2, 1.0), "slope": 1.2}
SIZE, TURN = np.array([0.5, 0.3, 0.2]), np.array([0.9, 0.1, 0.3, 0.2])
BODIES: dict[str, Any] = {
    "funnel": Cone("funnel", inside=True, within=CUTS, **FUNNEL),
    "spike": Cone("spike", within=CUTS, **FUNNEL),
    "crate": Box("crate", size=tuple(SIZE), orientation=tuple(TURN), within=CUTS),
    "slab": Box("slab", size=tuple(SIZE), within=CUTS),
}


def results(kernel: Kernel, known: dict[str, Any]) -> dict[str, Any]:
    """Return the results of a kernel."""
    found = evaluation(kernel, kernel.arguments)(*(known[str(s)] for s in kernel.arguments))
    return dict(zip(kernel.output_names, found, strict=True))


def kernels_of(name: str) -> tuple[dict[str, Kernel], dict[str, float]]:
    """Return the kernels of a body's bounds and of its point of contact, and its sizes."""
    laws: dict[str, Any] = {"gravity": GRAVITY, "restitution": 0.3}
    derived = Scene(name, bodies=[BODIES[name]], ball_radius=BALL, **laws).derive()
    face = derived.bodies[0].faces[0]
    kernels = bounds.bound_kernels(face, derived.ball_radius)
    assert face.contact_path is not None
    # Those of a span stand before those of the point of contact.
    parts = [part for part in kernels if part.startswith("rim")][-len(CUTS) :]
    found = {f"rim{k}": kernels[part] for k, part in enumerate(parts)}
    point = {f"q{k}": place for k, place in enumerate(face.contact_path.place)}
    found |= {"point": loop_kernel("point", point, "The point of contact.", "Table 2")}
    found |= {part: kernels[part] for part in kernels if part == "crease"}
    return found, {str(p.symbol): p.default for p in derived.parameters}


def moving(count: int, seed: int) -> tuple[Floats, Floats, Floats]:
    """Return places of balls about the bodies, their velocities and accelerations."""
    chance = np.random.default_rng(seed)
    places = chance.uniform(-0.5, 0.5, (count, 3))
    velocities = chance.normal(0, 1, (count, 3)) * 10 ** chance.uniform(-2, 1, (count, 1))
    return places, velocities, chance.normal(0, 5, (count, 3))


def at(places: Floats, velocities: Floats) -> dict[str, Any]:
    """Return the components of places and velocities by name."""
    known = dict(zip("xyz", places.T, strict=True))
    return known | dict(zip(("vx", "vy", "vz"), velocities.T, strict=True))


Distance = Callable[[Floats, Floats], dict[str, Any]]


def distance_of(name: str, part: int) -> Distance:
    """Return the function to the distance within a bound, its rate and its factor of v²."""
    kernels, sizes = kernels_of(name)
    return lambda places, velocities: results(kernels[f"rim{part}"], sizes | at(places, velocities))


def sides(name: str, part: int, places: Floats) -> Floats:
    """Return the values of a bound at the points of contact, by geometry that shares no code."""
    if name in ("funnel", "spike"):
        body = test_cone_rolls.cone(FUNNEL | {"span": (0.0, 1.0)})
    else:
        axes = rotation(TURN[None])[0] if name == "crate" else np.eye(3)
        points = np.clip(places @ axes, -SIZE / 2, SIZE / 2) @ axes.T
        return np.array([bound(CUTS[part])(q) for q in points])
    return np.array([bound(CUTS[part])(body.nearest(place)[0]) for place in places])


@pytest.mark.sampled(3)
@pytest.mark.parametrize("part", range(len(CUTS)))
@pytest.mark.parametrize("name", ["funnel", "spike"])
def test_the_distance_within_a_bound_bends_no_more_than_its_bound_says(
    name: str, part: int
) -> None:
    """Along a parabola by at most 2 a + C v², while the ball moves by at most 1/C."""
    kernels, sizes = kernels_of(name)
    places, velocities, pulls = moving(trials(4000, 1500), part)

    def value(places: Floats) -> Floats:
        found = results(kernels["point"], sizes | at(places, velocities))
        return np.asarray(eval(CUTS[part], {}, dict(zip("xyz", found.values(), strict=True))))

    now = results(kernels[f"rim{part}"], sizes | at(places, velocities))
    # While the ball moves, the bound counts divided by what it was divided by at the start.
    size = -value(places) / now["bound_distance"]
    swift, pull = (np.linalg.norm(own, axis=1) for own in (velocities, pulls))
    lasting = np.minimum(1 / (now["bound_curvature"] * (swift + pull)), 0.5)
    fastest = swift + pull * lasting
    bends = 2 * pull + now["bound_curvature"] * fastest**2
    for share in (0.1, 0.4, 0.7, 1.0):
        time = (share * lasting)[:, None]
        later = -value(places + velocities * time + pulls * time**2 / 2) / size
        time = time[:, 0]
        off = np.abs(later - now["bound_distance"] - now["bound_rate"] * time)
        assert np.all(off <= bends * time**2 / 2 + 1e-13)
    assert np.max(off / (bends * time**2 / 2)) > 0.02


@pytest.mark.sampled(1)
@pytest.mark.parametrize("part", range(len(CUTS)))
@pytest.mark.parametrize("name", BODIES)
def test_the_distance_within_a_bound_has_its_sign_and_is_no_more_than_the_way(
    name: str, part: int
) -> None:
    """At a contact; beside a box anywhere, as its nearest point is that of any place."""
    distance = distance_of(name, part)
    places, velocities, _ = moving(trials(2000, at_least=2000), 10 + part)
    touching = np.ones(len(places), bool)
    if name in ("funnel", "spike"):
        places = on_cone(places, 1 if name == "spike" else -1)
        touching = np.linalg.norm(places - FUNNEL["apex"], axis=1) > 0.1
    now = distance(places, velocities)
    found = sides(name, part, places)
    clear = touching & (np.abs(found) > 1e-9)
    assert np.all((found < 0)[clear] == (now["bound_distance"] > 0)[clear])
    assert np.count_nonzero(clear) > len(places) / 4
    assert np.all(np.abs(now["bound_rate"]) <= np.linalg.norm(velocities, axis=1) * (1 + 1e-12))


def on_cone(places: Floats, side: int) -> Floats:
    """Return the places moved across the nearest generator to where balls touch the cone."""
    unit = np.array(FUNNEL["axis"]) / np.linalg.norm(FUNNEL["axis"])
    half = np.arctan(FUNNEL["slope"])
    ways = places - FUNNEL["apex"]
    across = ways - np.outer(ways @ unit, unit)
    out = across / np.linalg.norm(across, axis=1)[:, None]
    line = np.sin(half) * out + np.cos(half) * unit
    normal = side * (np.cos(half) * out - np.sin(half) * unit)
    far = np.abs(np.sum(ways * line, axis=1))[:, None]
    return np.asarray(FUNNEL["apex"] + far * line + BALL * normal)


@pytest.mark.sampled(1)
@pytest.mark.parametrize("part", range(len(CUTS)))
@pytest.mark.parametrize("name", ["crate", "slab"])
def test_a_ball_beside_a_box_is_outside_a_bound_for_as_long_as_is_claimed(
    name: str, part: int
) -> None:
    """Also across the seams, where the point of contact begins to move at once."""
    kernels, sizes = kernels_of(name)
    places, velocities, pulls = moving(trials(6000, 2500), 20 + part)
    pulls *= 0.1
    longest = 0.3
    known: dict[str, Any] = sizes | at(places, velocities)
    pull = np.linalg.norm(pulls, axis=1)
    known |= {"strongest": pull, "fastest": np.linalg.norm(velocities, axis=1) + pull * longest}
    known |= {"outside_time": 0.0, "outside_distance": -np.inf, "on_bound": False}
    known |= {"position_error": 0.0}
    known |= results(kernels["crease"], known) | results(kernels[f"rim{part}"], known)
    ball_radius = sp.Symbol("ball_radius", positive=True)
    kernel = bounds.outside(
        ball_radius, "outside", strongest, fastest, "Time outside.", creased=True
    )
    found = results(kernel, known | {"ball_radius": BALL})["outside_time"]
    beyond = sides(name, part, places) > 1e-9
    assert np.all(found[beyond] > 0)
    for share in (0.2, 0.5, 0.8, 1.0):
        time = (share * np.minimum(found, longest))[:, None]
        there = places + velocities * time + pulls * time**2 / 2
        assert np.all(sides(name, part, there)[beyond] > -1e-13)
    assert np.median(found[beyond] * np.linalg.norm(velocities, axis=1)[beyond]) > 0.01
