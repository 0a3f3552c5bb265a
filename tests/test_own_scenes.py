"""The example scenes: right beside a slow reference and the judge, and what they are for."""

from __future__ import annotations

import runpy
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from compiled import ROOT, load_module
from hoopgen.derive.scenes.scene import Scene as Derived
from numpy.typing import NDArray
from slow_scene import Slow

from hoopgen.codegen import render
from hoopgen.engine import numpy_backend
from hoopgen.engine.raw import Raw, allocate, allocate_events
from hoopgen.judge.batch import prove
from hoopgen.scene import Scene, load_scene

EXAMPLES = ROOT / "examples" / "scenes"
LIMIT = 20.0

pytestmark = pytest.mark.xdist_group("own_scenes")


def states(
    count: int, seed: int, low: tuple[float, ...], high: tuple[float, ...], speed: float
) -> NDArray[np.float64]:
    """Return balls within a box, with velocities of that size and spins."""
    rng = np.random.default_rng(seed)
    place = rng.uniform(low, high, (count, 3))
    return np.hstack([place, rng.normal(0, speed, (count, 3)), rng.normal(0, 10, (count, 3))])


def thrown(count: int, seed: int) -> NDArray[np.float64]:
    """Return netballs from a few metres away, at the ring, its rim and its post."""
    rng = np.random.default_rng(seed)
    made = np.zeros((count, 9))
    made[:, :3] = rng.uniform([1.5, -2, -1.5], [4, 2, -0.5], (count, 3))
    goal = rng.normal([-0.1, 0, 0], [0.25, 0.15, 0.1], (count, 3))
    low = rng.random(count) < 0.3
    goal[low] = rng.normal([-0.39, 0, -0.3], [0.03, 0.1, 0.2], (count, 3))[low]
    time = rng.uniform(0.9, 1.3, (count, 1)) - 0.5 * low[:, None]
    made[:, 3:6] = (goal - made[:, :3]) / time
    made[:, 5] += 9.81 / 2 * time[:, 0]
    made[:, 6:] = rng.normal(0, 10, (count, 3))
    return made


def putted(count: int, seed: int) -> NDArray[np.float64]:
    """Return golf balls that come down near the hole."""
    made = states(count, seed, (-0.08, -0.08, 0.03), (0.06, 0.08, 0.4), 0.1)
    made[:, 3] += np.random.default_rng(seed).uniform(0, 0.8, count)
    return made


@dataclass(frozen=True)
class Example:
    """A scene, and shots for it."""

    file: str
    shots: Any
    most: int = 12
    """Contacts: more are closer together than the reference sees."""

    @cached_property
    def scene(self) -> Scene:
        path = EXAMPLES / self.file
        if path.suffix == ".toml":
            return load_scene(path)
        made: Scene = runpy.run_path(str(path))["SCENE"]
        return made

    @cached_property
    def derived(self) -> Derived:
        return self.scene.derive()

    def engine(self, folder: Path) -> ModuleType:
        """Return its NumPy kernels."""
        name = f"numpy/{self.scene.name}.py"
        path = folder / Path(name).name
        path.write_text(render.render_scene(self.derived, page=False)[name], encoding="utf-8")
        return load_module(path)


EXAMPLE = {
    "netball": Example("netball.toml", thrown),
    "bowl": Example(
        "bowl.toml", lambda n, seed: states(n, seed, (-0.5, -0.5, -0.5), (0.5, 0.5, 0.5), 1.5)
    ),
    "golf": Example("golf.toml", putted, 6),
    "bumpers": Example(
        "bumpers.py", lambda n, seed: states(n, seed, (-0.3, -0.3, 0.8), (0.3, 0.3, 1.2), 0.7), 10
    ),
}


def simulated(
    example: Example,
    kernels: ModuleType,
    shots: NDArray[np.float64],
    parameters: Mapping[str, Any] | None = None,
) -> Raw:
    """Simulate on NumPy."""
    count = len(shots)
    arrays = allocate(
        count,
        len(example.derived.bodies),
        ("outcome", "uncertain", "contacts", "time", "state", "time_error", "counts"),
    )
    out = arrays.joined(allocate_events(count, example.most))
    numpy_backend.run(
        kernels,
        shots,
        example.scene.values(parameters),
        None,
        example.most,
        out,
        time_limit=LIMIT,
    )
    return out


@dataclass(frozen=True)
class Flown:
    """Shots of an example, simulated."""

    example: Example
    shots: NDArray[np.float64]
    out: Raw

    def sequence(self, shot: int) -> list[int]:
        assert self.out.events is not None
        assert self.out.event_counts is not None
        return list(self.out.events["surface"][shot, : self.out.event_counts[shot]])

    @property
    def uncertain(self) -> NDArray[np.bool_]:
        assert self.out.uncertain is not None
        return self.out.uncertain

    @property
    def outcome(self) -> NDArray[np.uint8]:
        assert self.out.outcome is not None
        return self.out.outcome


@pytest.fixture(scope="module", params=EXAMPLE)
def flown(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Flown:
    """An example's shots."""
    example = EXAMPLE[request.param]
    kernels = example.engine(tmp_path_factory.mktemp(request.param))
    shots = example.shots(200, 5)
    return Flown(example, shots, simulated(example, kernels, shots))


def test_an_example_has_at_most_forty_lines(flown: Flown) -> None:
    text = (EXAMPLES / flown.example.file).read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 40


def test_an_example_is_that_of_the_slow_reference(flown: Flown) -> None:
    """The same bodies in the same order, and the same end, at the same times."""
    names = list(flown.example.derived.outcomes)
    slow, compared, bodies = Slow(flown.example.scene), 0, set()
    for shot in np.flatnonzero(~flown.uncertain & (flown.outcome != names.index("invalid")))[:100]:
        expected = slow.fly(flown.shots[shot], flown.example.most, LIMIT)
        if expected.close:
            continue
        ended = expected.outcome if expected.outcome in names else "endless"
        sequence = [body for body, _ in expected.contacts]
        if ended in flown.example.scene.ends:
            sequence.append(len(flown.example.derived.bodies))
        assert flown.sequence(shot) == sequence, shot
        assert names[flown.outcome[shot]] == ended, shot
        assert flown.out.time is not None
        # Each contact multiplies what rounding has moved; after twelve it is still small.
        assert flown.out.time[shot] == pytest.approx(expected.time, abs=1e-6), shot
        compared += 1
        bodies |= set(sequence)
    assert compared >= 40
    assert bodies >= set(range(len(flown.example.derived.bodies)))


def test_the_judge_proves_every_shot_that_is_not_flagged(flown: Flown) -> None:
    derived, values = flown.example.derived, flown.example.scene.values()
    certificate = prove(
        derived, flown.shots, values, None, flown.example.most, processes=1, time_limit=LIMIT
    )
    wrong = [
        shot
        for shot, proof in enumerate(certificate.proofs)
        if not flown.uncertain[shot]
        and (proof.outcome != flown.outcome[shot] or list(proof.surfaces) != flown.sequence(shot))
    ]
    assert wrong == []
    assert flown.uncertain.mean() < 0.05
