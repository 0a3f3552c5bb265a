"""Floors of several planes, over whose edges balls hop and roll: what their edges leave undecided.

Every hop of a ball that begins to roll on a tile has its apex near the planes of all others.
"""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp, mpf
from numpy.typing import NDArray

pytest.importorskip("flint")

from hoopgen.scene import Disc, End, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import DerivedKernels, engine_of
from tests.helpers.effort import exceptions, trials

pytestmark = pytest.mark.xdist_group("tiles")  # the scenes are derived once

BALL = 0.05
ROWS = {"a": ["x + 0.2"], "b": ["-x - 0.2", "x - 0.2"], "c": ["0.2 - x"]}
HEIGHT = 0.3

TILES = Scene(
    "floor_of_tiles",
    bodies=[
        Disc("table", radius=0.2, centre=(0, 0, HEIGHT + 0.4)),
        *(
            Plane(
                f"tile_{row}{column}", at=HEIGHT, within=[*over, *(b.replace("x", "y") for b in to)]
            )
            for row, over in ROWS.items()
            for column, to in ROWS.items()
        ),
    ],
    ball_radius=BALL,
    gravity=9.81,
    restitution=0.5,
    rolls=True,
    ends={"under": End(at=-1), "far": End(axis="-x", at=-2), "near": End(axis="x", at=-2)},
)
"""A round table over a floor of nine tiles."""

GAP = Scene(
    "floor_with_gap",
    bodies=[
        Plane("left", at=HEIGHT, within=["x + 0.2"]),
        Plane("right", at=HEIGHT, within=["0.2 - x"]),
    ],
    ball_radius=BALL,
    gravity=9.81,
    restitution=0.5,
    rolls=True,
    ends={"under": End(at=-1)},
)
"""Two halves of a floor, and a gap between them."""


@pytest.fixture(scope="module")
def tiles(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return engine_of(TILES, tmp_path_factory.mktemp("tiles"))


@pytest.fixture(scope="module")
def gap(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return engine_of(GAP, tmp_path_factory.mktemp("gap"))


def off_the_table(count: int, seed: int) -> NDArray[np.float64]:
    """Return balls that fall onto the table, and roll off it."""
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, :2] = random.uniform(-0.13, 0.13, (count, 2))
    states[:, 2] = HEIGHT + 0.4 + BALL + random.uniform(0.01, 0.2, count)
    states[:, 3:5] = random.normal(0, 0.4, (count, 2))
    states[:, 6:] = random.normal(0, 5, (count, 3))
    return states


def under_a_gap(count: int, seed: int) -> NDArray[np.float64]:
    """Return balls that rise through the gap to the floor's plane, half of them near an edge.

    Where gaps of some roundings decide, a contact is some nanoseconds from the apex, and the balls
    near an edge are nanometres from it there.
    """
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    rise = random.uniform(0.2, 0.4, count)
    over = random.integers(-1, 2, count) * 2.0**-54
    side = random.choice([-1, 1], count)
    speed = random.uniform(0.3, 0.9, count)
    near = random.random(count) < 0.5
    aside = np.where(near, random.normal(0, 2e-9, count), -(10 ** random.uniform(-6, -2, count)))
    states[:, 0] = side * (0.2 + aside - speed * rise)
    states[:, 2] = HEIGHT + BALL - 9.81 * rise**2 / 2 + over
    states[:, 3], states[:, 5] = side * speed, 9.81 * rise
    return states


def hops(count: int, seed: int) -> NDArray[np.float64]:
    """Return balls that hop over the floor, from hops of a decimetre to those of a picometre."""
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, :2] = random.choice([-0.2, 0.2], (count, 2)) + random.normal(0, 0.02, (count, 2))
    states[:, 2] = HEIGHT + BALL + 10 ** random.uniform(-12, -1, count)
    states[:, 3:5] = random.normal(0, 0.5, (count, 2))
    states[:, 6:] = random.normal(0, 5, (count, 3))
    return states


@pytest.mark.slow
def test_balls_that_roll_off_a_table_onto_tiles_are_rarely_uncertain(tiles: Engine) -> None:
    """The roll on the table adds errors that exceed the last hops on the floor."""
    shots = tiles.simulate(off_the_table(trials(300, 60), 1), time_limit=3)
    again = shots.rolls > 1
    assert np.count_nonzero(again) > len(shots) / 4
    assert np.count_nonzero(shots.uncertain) <= exceptions(0.01, len(shots))


@pytest.mark.slow
def test_hops_beside_edges_of_tiles_are_rarely_uncertain(tiles: Engine) -> None:
    shots = tiles.simulate(hops(trials(2000, 400), 2), max_contacts=4)
    assert np.count_nonzero(shots.uncertain) <= exceptions(0.001, len(shots))


@pytest.mark.slow
def test_hops_beside_edges_of_tiles_are_those_proved_or_flagged(tiles: Engine) -> None:
    """10,000 shots at full effort."""
    states = hops(trials(10_000), 2)
    shots = tiles.simulate(states, max_contacts=4, record=True)
    proofs = tiles.certify(states, max_contacts=4)
    assert proofs.agrees(shots).all()
    assert np.mean(proofs.decided) > 0.75


@pytest.mark.slow
def test_apexes_beside_an_edge_are_those_proved_or_flagged(gap: Engine) -> None:
    """10,000 shots at full effort: a contact is possible nanometres from the apex."""
    states = under_a_gap(trials(10_000, 1000), 3)
    shots = gap.simulate(states, max_contacts=2, record=True)
    proofs = gap.certify(states, max_contacts=2)
    assert proofs.agrees(shots).all()
    assert np.mean(proofs.decided) > 0.6
    assert 0.4 < np.mean(shots.uncertain) < 0.6


def test_the_delay_of_a_return_holds_for_every_velocity_within_its_error() -> None:
    """The true ball began on the plane, too, with another velocity off it: it returns at 2 V/g."""
    kernels = DerivedKernels.from_scene(GAP.derive())
    random = np.random.default_rng(4)
    parameters = {p.name: float(v) for p, v in zip(GAP.inputs, GAP.values(), strict=True)}

    def call(kernel: str, **given: float) -> dict[str, float]:
        known = given | {kernels.VARIABLES[name]: value for name, value in parameters.items()}
        found = getattr(kernels, kernel)(*(known[name] for name in kernels.ARGUMENTS[kernel]))
        return dict(zip(kernels.OUTPUTS[kernel], found, strict=True))

    for _ in range(trials(300)):
        off = 10 ** random.uniform(-7, 0.5)
        error = off * 10 ** random.uniform(-12, -4)
        state = {"x": 0.5, "y": 0.1, "z": HEIGHT + BALL, "vx": 0.7, "vy": 0.3, "vz": off}
        arrival = call("right_arrival", leaving=1.0, **state)
        errors = {
            "position_error": 1e-9,
            "velocity_error": error,
            "extent": 0.6,
            "speed": 0.8 + off,
        }
        margin = call("right_margin", leaving=1.0, horizon=arrival["time"], **errors)
        known = {"rate": arrival["rate"], "rate_margin": 0.0, "ceiling": abs(arrival["bend"])}
        crossing = call("crossing", **known, **margin)
        assert crossing["clearance"] > 0
        with mp.workdps(40):
            for sign in (-1, 1):
                time = 2 * (mpf(off) + sign * mpf(error)) / mpf(parameters["gravity"])
                assert abs(mpf(float(arrival["time"])) - time) <= crossing["delay"]
