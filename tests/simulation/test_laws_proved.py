"""Proved bounds where each body has a restitution of its own: those of the body that is met."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import hoopgen
from benchmarks.workloads import WORKLOADS
from hoopgen.scene.files import load_scene
from tests.helpers.proved_bounds import bounded_events

FIELDS = ("outcome", "contacts", "counts", "uncertain", "time_error", "state_error")
RING, BOARD = 0.55, 0.8

SCENE = """
name = "{name}"
ball_radius = 0.12128
gravity = 9.81

[parameters]
radius = {{ default = 0.235 }}
wire = {{ default = 0.01 }}
distance = {{ default = 0.381 }}
rim = {{ default = 0.55, unit = "1" }}
glass = {{ default = 0.8, unit = "1" }}

[bodies.ring]
kind = "torus"
radius = "radius"
wire = "wire"
restitution = "rim"

[bodies.board]
kind = "plane"
normal = [1, 0, 0]
at = "-distance"
within = ["-0.14 - z", "z - 0.9268", "y - 0.9144", "-0.9144 - y"]
restitution = "{board}"

[ends.made]
at = -0.024
within = ["x**2 + y**2 - radius**2"]

[ends.missed]
at = -0.024
"""


@pytest.fixture(scope="module")
def engines(tmp_path_factory: pytest.TempPathFactory) -> dict[str, hoopgen.Engine]:
    """Return a scene with two laws, and the same with one."""
    folder: Path = tmp_path_factory.mktemp("scenes")
    found = {}
    for name, board in (("two", "glass"), ("one", "rim")):
        file = folder / f"{name}.toml"
        file.write_text(SCENE.format(name=name, board=board), encoding="utf-8")
        found[name] = hoopgen.compile(load_scene(file))
    return found


def states(count: int) -> np.ndarray:
    usual = np.concatenate([w.make(count) for w in WORKLOADS[1:3]])
    fast = usual * np.repeat([1.0, 1.06, 1.0], 3)  # more of them meet the board alone
    return np.concatenate([usual, fast])


def test_bounds_are_those_of_the_law_of_the_body(engines: dict[str, hoopgen.Engine]) -> None:
    options = {"fields": FIELDS, "record": True, "max_contacts": 40}
    two = engines["two"].simulate(states(3000), **options)
    assert two.proved.all()
    for body, restitution in ((0, RING), (1, BOARD)):
        one = engines["one"].simulate(states(3000), {"rim": restitution}, **options)
        alone = two.counts[:, 1 - body] == 0
        assert np.count_nonzero(alone & (two.contacts > 0)) > 300
        for name in FIELDS:
            assert np.array_equal(getattr(two, name)[alone], getattr(one, name)[alone]), name
        pair = [s.events[alone[s.events["shot"]]] for s in (two, one)]
        assert pair[0].tobytes() == pair[1].tobytes()
    numpy = engines["two"].simulate(states(3000), **options, backend="numpy")
    assert numpy.events.tobytes() == two.events.tobytes()
    for name in FIELDS:
        assert getattr(numpy, name).tobytes() == getattr(two, name).tobytes(), name


def test_the_judge_finds_no_larger_error(engines: dict[str, hoopgen.Engine]) -> None:
    pytest.importorskip("flint")
    given, options = states(150), {"record": True, "max_contacts": 40}
    shots = engines["two"].simulate(given, **options, fields=FIELDS)
    proof = engines["two"].certify(given, **options)
    assert proof.agrees(shots).all()
    assert np.count_nonzero(bounded_events(shots, proof)) > 300
