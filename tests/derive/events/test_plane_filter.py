"""Flights that are told, by their ends alone, not to come to a plate: none of them does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events import search_for
from hoopgen.derive.events.plane_filter import apart
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.derive.surfaces import Plane
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

from benchmarks.workloads import WORKLOADS
from hoopgen import PAPER
from hoopgen.codegen import render
from hoopgen.engine import numpy_backend
from hoopgen.engine.result_arrays import Layout
from tests.codegen.test_kernels import evaluate_numpy
from tests.helpers.compiled import load_module
from tests.helpers.effort import occurrences, trials
from tests.helpers.kernel_arguments import of_flight

Floats = NDArray[np.float64]
GRAVITY = PAPER["gravity"]
REACH = PAPER["ball_radius"] + PAPER["wire_radius"]


def told(
    states: Floats, until: Floats | float, off: float = 0.0, late: float = 0.0
) -> NDArray[np.bool_]:
    """Return where flights from such states may come to board or bridge."""
    taken = of_flight(states, PAPER, until, off) | {
        "pad": np.array([1e-6]),
        "earliest_delay": np.array([late]),
    }
    (found,) = evaluate_numpy("reachable", taken, len(states))
    return np.asarray(found, bool)


def comes(states: Floats, until: float) -> NDArray[np.bool_]:
    """Return where they do, by going along: on which side of a plate's plane, within its bounds."""
    x, y, z, vx, vy, vz = states.T[:6]
    found = np.zeros(len(states), bool)
    board = PAPER["ball_radius"] - PAPER["board_distance"]
    for time in np.linspace(0, until, 400):
        px, py, pz = x + vx * time, y + vy * time, z + (vz - GRAVITY / 2 * time) * time
        wide, high = abs(py) <= PAPER["board_half_width"], pz <= PAPER["board_top"]
        found |= (px <= board) & wide & high & (pz >= PAPER["board_bottom"])
        narrow = (abs(py) <= PAPER["bridge_half_width"]) & (px <= 0)
        behind = (px >= -PAPER["board_distance"]) & (px**2 + py**2 >= PAPER["ring_radius"] ** 2)
        found |= narrow & behind & (abs(pz - REACH) < 0.05)
    return found


@pytest.fixture(scope="module")
def flights() -> Floats:
    """Flights of half a second from around the hoop, in all directions."""
    drawn = np.random.default_rng(20_081)
    places = drawn.uniform((-0.5, -1.2, -0.3), (1.0, 1.2, 1.2), (trials(40_000), 3))
    return np.hstack([places, drawn.normal(0, 1.5, places.shape), np.zeros(places.shape)])


def test_no_flight_that_is_told_to_stay_away_comes_to_a_plate(flights: Floats) -> None:
    away, there = ~told(flights, 0.5), comes(flights, 0.5)
    assert not np.any(away & there)
    assert min(away.sum(), there.sum()) > occurrences(3000)


def test_swishes_are_told_to_stay_away() -> None:
    swishes = WORKLOADS[0].make(1000)
    vz, fall = swishes[:, 5], swishes[:, 2] + PAPER["end_depth"]
    until = (vz + np.sqrt(vz**2 + 2 * GRAVITY * fall)) / GRAVITY
    assert not told(swishes, until).any()


@pytest.mark.parametrize("shot", [[0.5, 0, 0.3, -1.0, 0, 0], [0.5, 0.3, 0.3, -1.0, 0, 0]])
def test_a_flight_may_come_to_a_plate_as_far_as_it_is_known(shot: list[float]) -> None:
    states = np.array([[*shot, 0, 0, 0]], float)
    board = PAPER["ball_radius"] - PAPER["board_distance"]
    circle = np.sqrt(PAPER["ring_radius"] ** 2 - PAPER["bridge_half_width"] ** 2)
    short = 0.5 + min(circle, -board)
    assert not told(states, short - 1e-6)
    assert told(states, short + 1e-6)
    assert told(states, short - 1e-6, off=1e-5)
    assert told(states, short - 1e-6, late=2e-6)
    assert told(states, np.inf)
    assert told(np.full((1, 9), np.nan), 1.0)


def test_only_coordinates_that_nothing_accelerates_tell_anything() -> None:
    _, board, bridge = HOOP.surfaces
    assert [len(search_for(face, HOOP.flight).apart) for face in HOOP.surfaces] == [0, 1, 1]
    g = HOOP.gravity
    zero = sp.Integer(0)
    for plate, told_by in ((board, 0), (bridge, 1)):
        assert isinstance(plate, Plane)
        assert len(apart(plate, Parabola((-g, zero, zero)))) == told_by
    assert isinstance(board, Plane)
    assert len(apart(board, Parabola((zero, -g, zero)))) == 1


@pytest.mark.parametrize("first", ["floor", "door"])
@pytest.mark.sampled(1)
def test_an_end_that_stands_upright_is_always_looked_at(first: str, tmp_path: Path) -> None:
    """A ball that flies away from the plates through a door, above a floor that it would reach."""
    zero = sp.Integer(0)
    z = POSITION[2]
    ends = {
        "floor": End("floor", Plane("ground", (0, 0, 1), sp.Integer(-2), zero)),
        "door": End("door", Plane("wall", (-1, 0, 0), sp.Integer(-1), zero, (z - 3,))),
    }
    order = (first, *(name for name in ends if name != first))
    scene = replace(HOOP, name="doors", ends=tuple(ends[name] for name in order))
    source = tmp_path / "doors.py"
    text = render.render_scene(scene, page=False, targets=["numpy"])["numpy/doors.py"]
    source.write_text(text, encoding="utf-8")
    module, layout = load_module(source), Layout(load_module(source))
    states = np.array([[0.5, 0, 0, 3, 0, 5, 0, 0, 0]], float)
    given = [float(p.default) for p in scene.parameters]
    out = layout.allocate(1, layout.fields)
    numpy_backend.run(module, states, given, None, 5, out)
    assert out.time is not None
    assert out.outcome is not None
    assert list(scene.outcomes)[out.outcome[0]] == "door"
    assert out.time[0] == pytest.approx(0.5 / 3, rel=1e-15)
