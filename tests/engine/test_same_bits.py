"""A million shots: every engine, width, number of threads and order of rows gives the same bits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from benchmarks.families import FAMILIES, Family
from hoopgen.simulation.hoop import HOOP
from tests.helpers.effort import trials
from tests.helpers.engines import engines_here

FIELDS, BOUNDS = HOOP.layout.fields, HOOP.layout.bounds
MILLION = trials(10**6, at_least=10**5)
HARD = [family for family in FAMILIES if not family.workload]
SOURCES = [
    *((family, MILLION) for family in FAMILIES if family.workload),
    *((family, -(-MILLION // len(HARD))) for family in HARD),
]


def assert_same(
    got: hoopgen.Shots, wanted: Mapping[str, NDArray[Any]], order: Any = slice(None)
) -> None:
    for name, array in wanted.items():
        # Of the bytes: NaN, and the sign of zero, included.
        assert getattr(got, name).tobytes() == array[order].tobytes(), name


@pytest.mark.parametrize(
    ("family", "shots"), [pytest.param(*source, id=source[0].key) for source in SOURCES]
)
@pytest.mark.sampled(1)
def test_engines_widths_threads_and_order_do_not_change_a_bit(family: Family, shots: int) -> None:
    states, parameters = family.make(shots)
    engines = engines_here()
    numpy = engines.pop("numpy")(states, parameters, fields=FIELDS + BOUNDS)
    wanted = {name: getattr(numpy, name) for name in FIELDS + BOUNDS}
    # Nobody asks what is uncertain: less is computed, and the path is the same.
    path = {name: wanted[name] for name in FIELDS if name != "uncertain"}
    for simulate in engines.values():
        assert_same(simulate(states, parameters, fields=FIELDS + BOUNDS), wanted)
        assert_same(simulate(states, parameters, fields=tuple(path)), path)
    for backend, threads in (("auto", 1), ("auto", 3), ("numpy", 2)):
        given = {"backend": backend, "threads": threads, "fields": tuple(path)}
        assert_same(hoopgen.simulate(states, parameters, **given), path)

    # And a recorded path is that path.
    few = slice(shots // 50)
    some = {n: v if np.ndim(v) == 0 else np.asarray(v)[few] for n, v in parameters.items()}
    recorded = hoopgen.simulate(states[few], some, fields=tuple(path), record=True)
    assert_same(recorded, path, few)

    order = np.random.Generator(np.random.Philox(7)).permutation(shots)
    turned = {n: v if np.ndim(v) == 0 else np.asarray(v)[order] for n, v in parameters.items()}
    assert_same(hoopgen.simulate(states[order], turned, fields=FIELDS), path, order)


@pytest.mark.slow
def test_shots_that_the_time_limit_ends_together_are_recorded() -> None:
    """In a scene of one body and no end, a kernel says the same of all that meet nothing."""
    pytest.importorskip("sympy")
    scene = hoopgen.Scene(
        "alone",
        bodies=[hoopgen.scene.Torus("ring", radius=0.3, wire=0.02)],
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.5,
    )
    states = np.zeros((3, 9))
    states[:, 0] = 5.0
    for backend in ("numpy", "auto"):
        for limit, name in ((2.0, "ENDLESS"), (np.inf, "SHORT")):
            options = {"scene": scene, "backend": backend, "time_limit": limit}
            shots = hoopgen.simulate(states, **options, record=True)
            assert shots.outcome.tolist() == [shots.scene.outcomes[name]] * 3
            assert not shots.counts.any()
            assert shots.events["time"].tolist() == [2.0] * (3 if name == "ENDLESS" else 0)
            assert_same(hoopgen.simulate(states, **options), {"outcome": shots.outcome})
