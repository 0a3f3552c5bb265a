"""Promises of the ring's search in air: its bounds of F'' hold along a piece, and are of use."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events import root_finder_for
from hoopgen.derive.events.ring.air import STEEP
from hoopgen.derive.motion.air_series import ORDER
from hoopgen.derive.scenes.air import AIR
from numpy.typing import NDArray

from tests.derive.motion.test_air import DEFAULTS, Values, begin
from tests.derive.test_evaluation import in_doubles
from tests.helpers.effort import trials

Floats = NDArray[np.float64]

WIDTH = sp.Symbol("width", nonnegative=True)
RING = DEFAULTS["ring_radius"]
REACH = DEFAULTS["ball_radius"] + DEFAULTS["wire_radius"]
SHARE = 2.0**-25
"""The largest errors that a search allows for, relative to place and velocity."""


def along(known: Values, times: Floats) -> dict[str, Floats]:
    """Return F'', L and rho on the series at times, each (n,)."""
    rows = np.array(
        [
            [known[axis if k == 0 else f"{axis}_{k}"] for k in range(ORDER + 1)]
            for axis in ("vx", "vy", "vz")
        ]
    )
    degrees = np.arange(ORDER + 1)
    powers = times[:, None] ** degrees
    vx, vy, vz = rows @ powers.T
    start = np.array([[known[axis]] for axis in "xyz"])
    x, y, z = start + times * ((rows / (degrees + 1)) @ powers.T)
    ax, ay, az = (rows * degrees)[:, 1:] @ powers[:, :-1].T
    rho = np.hypot(x, y)
    outward = (x * vx + y * vy) / rho
    turned = (vx**2 + vy**2 - outward**2 + x * ax + y * ay) / rho
    bend = 2 * (outward**2 + (rho - RING) * turned + vz**2 + z * az)
    return {"bend": bend, "moment": x * vy - y * vx, "distance": rho}


@dataclass(frozen=True)
class Window:
    """A window of a search: a piece, the time and the width, and what the search says there."""

    known: Values
    other: Values
    """The piece of a flight whose state differs by what a search allows for."""
    time: float
    width: float
    found: Values

    def both(self, name: str) -> Floats:
        """Return a quantity of `along` at times of the window, of both flights, (2, n)."""
        times = np.linspace(self.time, self.time + self.width, 33)
        return np.stack([along(one, times)[name] for one in (self.known, self.other)])


def near_wire(random: np.random.Generator) -> Floats:
    """Return a state near the wire."""
    angle, around = random.uniform(0, 2 * np.pi, 2)
    off = REACH * random.uniform(1.0, 2.5)
    out = RING + off * np.cos(angle)
    place = [out * np.cos(around), out * np.sin(around), off * np.sin(angle)]
    motion = random.normal(size=6) * np.repeat([random.uniform(0.2, 4.0), 20.0], 3)
    return np.array([*place, *motion])


def rising(random: np.random.Generator) -> Floats:
    """Return a state above the wire of a ball that rises and slows down."""
    out, speed = RING + random.uniform(0.0, 0.01), random.uniform(1.0, 4.0)
    return np.array([out, 0.0, REACH * random.uniform(1.0, 1.2), 0.0, 0.0, speed, 0.0, 0.0, 0.0])


def turning(random: np.random.Generator) -> Floats:
    """Return a state near the axis of a ball whose moment grows, by a spin about the vertical."""
    out, angle = random.uniform(0.07, 0.15), random.uniform(0, 2 * np.pi)
    speed, spin = random.uniform(1.0, 4.0), random.choice([-1.0, 1.0]) * random.uniform(3e3, 2e4)
    motion = [speed * np.cos(angle), speed * np.sin(angle), 0.0, 0.0, 0.0, spin]
    return np.array([out, 0.0, 0.0, *motion])


Place = Callable[[np.random.Generator], Floats]


def windows(seed: int, count: int, place: Place = near_wire) -> list[Window]:
    """Return windows of flights near the ring, in which a bound is known."""
    finder = root_finder_for(AIR.surfaces[0], AIR.flight)
    outputs = {
        "curvature": finder.curvature(WIDTH),
        "moment": finder.moment(WIDTH),
        "distance": finder.least_distance(WIDTH),
        "steepest": finder.steepest(
            WIDTH, finder.curvature(WIDTH), sp.Symbol("fall"), sp.Symbol("reach")
        ),
    }
    random = np.random.default_rng(seed)
    made: list[Window] = []
    while len(made) < count:
        state = place(random)
        known = begin(state)
        moved = state.copy()
        moved[:3] += SHARE * known["extent"] * random.choice([-1.0, 1.0], 3)
        moved[3:6] += SHARE * known["piece_speed"] * random.choice([-1.0, 1.0], 3)
        time = known["piece"] * random.uniform(0.0, 0.9)
        width = (known["piece"] - time) * random.uniform(0.0, 1.0) ** 2
        values = known | {"t": time, "end": known["piece"], "margin": 1e-7, "ceiling": 1e9}
        values |= {"width": width, "fall": 1.0, "reach": 0.5 * width}
        found = {name: float(v) for name, v in in_doubles(outputs, values).items()}
        if found["curvature"] < STEEP:
            made.append(Window(known, begin(moved), time, width, found))
    return made


@pytest.mark.slow
def test_the_curvature_bounds_how_much_the_gap_bends_down_and_is_near_to_that() -> None:
    spare = []
    for one in windows(3, trials(300, at_least=100)):
        bends = one.both("bend")
        assert (-bends <= one.found["curvature"]).all()
        spare.append((one.found["curvature"] + bends.min()) / (np.abs(bends).max() + 1.0))
    assert np.median(spare) < 0.8


@pytest.mark.slow
def test_the_curvature_bounds_how_much_the_gap_of_a_ball_bends_down_that_slows_down() -> None:
    for one in windows(5, trials(300, at_least=150), rising):
        assert (-one.both("bend") <= one.found["curvature"]).all()


@pytest.mark.slow
def test_moment_and_distance_from_the_axis_are_within_their_bounds() -> None:
    for place in (near_wire, turning):
        for one in windows(6, trials(300, at_least=150), place):
            assert (np.abs(one.both("moment")) <= one.found["moment"]).all()
            assert (one.both("distance") >= one.found["distance"]).all()


@pytest.mark.slow
def test_the_largest_bend_of_a_window_is_bounded_and_the_bound_is_not_the_ceiling() -> None:
    for one in windows(4, trials(300, at_least=200)):
        bends = one.both("bend")
        steepest = one.found["steepest"]
        assert steepest >= np.abs(bends).max()
        # On a window of less than six margins the ceiling counts.
        assert steepest < 1e9 or one.width < 6.1e-7


@pytest.mark.slow
def test_on_a_window_shorter_than_twice_newton_s_step_the_ceiling_counts() -> None:
    finder = root_finder_for(AIR.surfaces[0], AIR.flight)
    known = begin(np.array([0.3, 0.0, 0.3, 0.1, 0.2, -3.0, 0.0, 10.0, 0.0]))
    values = known | {"t": 0.0, "end": known["piece"], "margin": 1e-3, "ceiling": 1e9}
    values |= {"width": 0.02, "fall": 1.0}
    steepest = {"c": finder.steepest(WIDTH, sp.Integer(0), sp.Symbol("fall"), sp.Symbol("reach"))}
    assert in_doubles(steepest, values | {"reach": 0.0169})["c"] < 1e3
    assert in_doubles(steepest, values | {"reach": 0.0171})["c"] == 1e9
