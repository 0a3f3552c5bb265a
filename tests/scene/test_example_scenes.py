"""The example scenes: right beside a slow reference and the judge, and what they are for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from benchmarks.own_scenes import FILES, scene_of, states
from hoopgen.codegen import render
from hoopgen.engine.native import Rejection
from hoopgen.scene import Box, Cylinder, End, Parameter, Plane, Scene, Sphere, Surface, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT
from tests.helpers.compiled import load_module
from tests.helpers.effort import trials
from tests.helpers.scenes.leaning import LEANING
from tests.helpers.slow_scene import Slow

EXAMPLES = ROOT / "examples" / "scenes"
LIMIT = 20.0

pytestmark = pytest.mark.xdist_group("own_scenes")


ZOO = Scene(
    "zoo",
    parameters=[
        Parameter("ball", 0.05),
        Parameter("size", 0.3),
        Parameter("e", 0.8, "1"),
        Parameter("dull", 0.5, "1"),
    ],
    ball_radius="ball",
    gravity=9.81,
    restitution="e",
    bodies=[
        Plane("ramp", axis="x", at="-3*size", within=["z - 2*y - size", "-z - 1"]),
        Sphere("cap", radius="size", centre=("size", "-size", 0), within=["size/4 - x - y - z/2"]),
        Cylinder(
            "pipe",
            radius="size",
            centre=(0, 0, -0.5),
            axis="y",
            span=("-size", 0.2),
            within=["-0.6 - z"],
        ),
        Cylinder("well", radius="2*size", centre=(0, 0.3, 0), inside=True, span=(-1.5, -0.7)),
        Torus("wheel", radius="size", wire=0.04, centre=("-size", "size", 0.2), axis="x"),
        Box("block", size=("size", 0.4, 0.2), centre=(0.4, "size", -0.6)),
        Sphere("globe", radius=2, inside=True, restitution="dull"),
    ],
    ends={"far": End(axis="-x", at=-0.9, within=["y**2 + z**2 - size"]), "low": End(at=-1.6)},
)
"""Bodies of every kind with bounds, on other axes than the examples have, and sizes as formulas."""


SIDEWAYS = Scene(
    "sideways",
    parameters=[Parameter("ball", 0.05), Parameter("e", 0.7, "1")],
    ball_radius="ball",
    gravity=5,
    down="y",
    restitution="e",
    bodies=[
        Torus("ring", radius=0.3, wire=0.02, axis="y"),
        Plane("lid", axis="-y", at=-0.5, within=["x"]),
    ],
    ends={"through": End(axis="-y", at=-0.4, within=["x**2 + z**2 - 1"]), "out": End("-y", -1)},
)
"""A scene in which free fall goes along y."""


def numpy_engine(scene: Scene, folder: Path) -> Engine:
    """Return what simulates a scene on NumPy: compiling C would take longer than all else here."""
    derived, name = scene.derive(), f"numpy/{scene.name}.py"
    path = folder / Path(name).name
    text = render.render_scene(derived, page=False, targets=["numpy"])[name]
    path.write_text(text, encoding="utf-8")
    return Engine(
        load_module(path),
        find=lambda: Rejection("is not wanted here", ""),
        sources=dict,
        scene=lambda: derived,
        written=scene,
    )


@dataclass(frozen=True)
class Example:
    """A scene, by its file or itself, and shots for it."""

    given: str | Scene
    shots: Callable[[int, int], NDArray[np.float64]]
    most: int = 12
    """Contacts: more are closer together than the reference sees."""

    @cached_property
    def scene(self) -> Scene:
        if isinstance(self.given, Scene):
            return self.given
        return scene_of(self.given)


EXAMPLE = {
    "netball": Example("netball.toml", FILES["netball.toml"]),
    "bowl": Example("bowl.toml", FILES["bowl.toml"]),
    "golf": Example("golf.toml", FILES["golf.toml"], 6),
    "bumpers": Example("bumpers.py", FILES["bumpers.py"], 10),
    "funnel": Example("funnel.toml", FILES["funnel.toml"], 5),
    "pinball": Example("pinball.toml", FILES["pinball.toml"], 1),
    "zoo": Example(ZOO, lambda n, seed: states(n, seed, (-0.7, -0.7, 0), (0.7, 0.7, 1), 2.5), 8),
    "sideways": Example(
        SIDEWAYS, lambda n, seed: states(n, seed, (-0.5, -1, -0.5), (0.5, -0.3, 0.5), 0.7), 8
    ),
    "leaning": Example(
        LEANING, lambda n, seed: states(n, seed, (-0.7, -0.7, 0), (0.7, 0.7, 1.2), 1.5), 8
    ),
}


@dataclass(frozen=True)
class Flown:
    """Shots of an example, simulated."""

    example: Example
    engine: Engine
    states: NDArray[np.float64]
    shots: hoopgen.Shots

    def sequence(self, shot: int) -> list[int]:
        own = self.shots.events["shot"] == shot
        return list(self.shots.events["surface"][own])


def flown_on(example: Example, folder: Path, count: int, seed: int) -> Flown:
    engine = numpy_engine(example.scene, folder)
    states = example.shots(count, seed)
    options = {"max_contacts": example.most, "time_limit": LIMIT, "record": True}
    return Flown(example, engine, states, engine.simulate(states, backend="numpy", **options))


@pytest.fixture(scope="module", params=EXAMPLE)
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Flown:
    """An example's shots."""
    return flown_on(EXAMPLE[request.param], tmp_path_factory.mktemp(request.param), 200, 5)


@pytest.mark.parametrize("file", [path.name for path in sorted(EXAMPLES.iterdir())])
def test_an_example_has_at_most_forty_lines(file: str) -> None:
    assert file in [example.given for example in EXAMPLE.values()]
    assert len((EXAMPLES / file).read_text(encoding="utf-8").splitlines()) <= 40


@pytest.mark.slow
def test_an_example_is_that_of_the_slow_reference(flown: Flown) -> None:
    """The same bodies in the same order, and the same end, at the same times."""
    shots, outcomes = flown.shots, flown.engine.outcomes
    slow, compared, bodies = Slow(flown.example.scene), 0, set()
    for shot in np.flatnonzero(~shots.uncertain & (shots.outcome != outcomes["INVALID"]))[
        : trials(100, at_least=60)
    ]:
        expected = slow.fly(flown.states[shot], flown.example.most, LIMIT)
        if expected.close:
            continue
        sequence = [body for body, _ in expected.contacts]
        if expected.outcome in flown.example.scene.ends:
            sequence.append(len(flown.engine.surfaces))
        assert flown.sequence(shot) == sequence, shot
        assert outcomes(shots.outcome[shot]).name.lower() == expected.outcome, shot
        # Each contact multiplies what rounding has moved; after a dozen it is still small.
        assert shots.time[shot] == pytest.approx(expected.time, abs=1e-6), shot
        compared += 1
        bodies |= set(sequence)
    assert compared >= 40
    assert bodies >= set(range(len(flown.engine.surfaces)))


@pytest.mark.slow
def test_the_judge_proves_every_shot_that_is_not_flagged(flown: Flown) -> None:
    proof = flown.engine.certify(
        flown.states, max_contacts=flown.example.most, time_limit=LIMIT, processes=1
    )
    assert list(np.flatnonzero(~proof.agrees(flown.shots))) == []
    assert flown.shots.uncertain.mean() < 0.05
    # A proof ends where a ball begins to roll.
    assert (proof.decided | proof.accumulates).mean() > 0.95


@pytest.mark.slow
def test_a_surface_of_ones_own_is_the_body_that_it_describes(tmp_path: Path) -> None:
    """A sphere by its polynomial, half of it out of bounds: the same contacts at the same times."""
    flown = []
    for body in (
        Sphere("stone", radius="size", centre=(0, 0, 0.1), within=["-x"]),
        Surface("stone", condition="x**2 + y**2 + (z - 0.1)**2 - (size + ball)**2", within=["-x"]),
    ):
        scene = replace(ZOO, bodies=[Plane("floor", at=-0.3), body], ends={"low": End(at=-1)})
        engine = numpy_engine(scene, tmp_path)
        shots = states(100, 3, (-0.2, -0.4, 0.5), (0.4, 0.4, 1), 0.4)
        flown.append(engine.simulate(shots, backend="numpy", max_contacts=5, record=True))
    left, right = flown
    assert left.counts[:, 1].sum() > 40
    assert list(left.events["surface"]) == list(right.events["surface"])
    assert left.events["time"] == pytest.approx(right.events["time"], abs=1e-9)
