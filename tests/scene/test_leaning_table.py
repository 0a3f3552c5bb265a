"""A ball that rolls on a table that leans, between impacts on walls and a post."""

from __future__ import annotations

import numpy as np
import pytest
from hoopgen.derive.events import search_for
from numpy.typing import NDArray

from hoopgen.results.shots import Shots
from hoopgen.scene import Cylinder, End, Parameter, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials
from tests.scene.test_example_scenes import numpy_engine

Floats = NDArray[np.float64]

SLOPE, RADIUS, LIMIT = 0.125, 0.015625, 1.5
UP = ("-slope*sine", "-slope*cosine", 1)
ACROSS, ALONG = ("cosine", "-sine", 0), ("-sine", "-cosine", 0)

TABLE = Scene(
    "leaning_table",
    parameters=[
        Parameter("slope", SLOPE, "1"),
        Parameter("cosine", 1.0, "1", sign="any"),
        Parameter("sine", 0.0, "1", sign="any"),
    ],
    ball_radius=RADIUS,
    gravity=9.81,
    inertia="2/5",
    restitution=0.8,
    friction=0.1,
    rolls=True,
    bodies=[
        Plane("table", normal=UP, point=(0, 0, 0), restitution=0, friction=float("inf")),
        Plane("left", normal=ACROSS, point=("-0.25*cosine", "0.25*sine", 0)),
        Plane("top", normal=ALONG, point=("0.75*sine", "0.75*cosine", 0)),
        Cylinder("post", radius=0.03, centre=("0.5*sine", "0.5*cosine", 0), axis=UP),
    ],
    ends={"below": End(at=-3)},
)
"""The table turns about the z axis with the parameters; y points up the table at the start."""


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """The engine of the table."""
    return numpy_engine(TABLE, tmp_path_factory.mktemp("leaning_table"))


def rolling(count: int, turn: float) -> Floats:
    """Return balls that roll up the table, or across it, with the table turned by an angle."""
    rng = np.random.default_rng(17)
    normal = np.array([0.0, -SLOPE, 1.0]) / np.hypot(1, SLOPE)
    place = np.zeros((count, 3))
    place[:, :2] = rng.uniform((-0.2, 0.1), (0.1, 0.4), (count, 2))
    place[:, 2] = SLOPE * place[:, 1]
    place += RADIUS * normal
    velocity = np.zeros((count, 3))
    velocity[:, :2] = rng.uniform((-0.8, 0.6), (0.5, 1.6), (count, 2))
    velocity[:, 2] = SLOPE * velocity[:, 1]
    spin = np.cross(normal, velocity) / RADIUS
    return np.hstack([turned(vector, turn) for vector in (place, velocity, spin)])


def turned(vectors: Floats, turn: float) -> Floats:
    """Return vectors, turned from the y axis towards the x axis."""
    x, y, z = vectors.T
    cosine, sine = np.cos(turn), np.sin(turn)
    return np.stack([cosine * x + sine * y, cosine * y - sine * x, z], 1)


def simulated(engine: Engine, count: int, turn: float) -> Shots:
    """Return the shots on the turned table."""
    own = {"cosine": float(np.cos(turn)), "sine": float(np.sin(turn))}
    names = ("outcome", "contacts", "counts", "uncertain", "time", "state")
    return engine.simulate(
        rolling(count, turn),
        own,
        leaving="table",
        time_limit=LIMIT,
        record=True,
        fields=(*names, "time_error", "state_error"),
        backend="numpy",
    )


def check_turned(engine: Engine) -> None:
    """Assert that a turned table gives the turned results, within what both shots claim."""
    count = trials(600, at_least=200)
    plain = simulated(engine, count, 0.0)
    for turn in (0.7, -2.4):
        other = simulated(engine, count, turn)
        sure = ~plain.uncertain & ~other.uncertain
        assert sure.mean() > 0.7
        assert (plain.counts[sure] == other.counts[sure]).all()
        assert (plain.outcome[sure] == other.outcome[sure]).all()
        for k in range(3):
            own = slice(3 * k, 3 * k + 3)
            away = np.abs(turned(plain.state[:, own], turn) - other.state[:, own]).max(1)
            # A turn mixes two components, and rounds them and the scene's directions.
            claimed = 1.5 * (plain.state_error[:, k] + other.state_error[:, k])
            rounded = 64 * np.finfo(float).eps * (1 + np.abs(plain.state[:, own]).max(1))
            assert (away <= claimed + rounded)[sure].all(), k


@pytest.mark.slow
def test_a_turned_table_gives_the_turned_results(engine: Engine) -> None:
    """The same contacts and outcomes, and final states within the claimed errors."""
    check_turned(engine)


def check_landings(engine: Engine) -> None:
    """Assert that errors stay small, though the ball hops and lands at each of its impacts.

    With landings that are only known as well as the ball's place the bound is six times as large.
    """
    shots = simulated(engine, trials(600, at_least=200), 0.0)
    assert np.mean(shots.contacts >= 4) > 0.3
    assert (shots.counts > 0).any(0).all()
    assert shots.uncertain.mean() < 0.01
    assert np.median(shots.state_error[shots.contacts >= 4, 0]) < 4e-10


@pytest.mark.slow
def test_a_ball_that_hops_off_the_table_lands_where_it_is_known(engine: Engine) -> None:
    """The time of its landing is known as well as its speed, not as its place."""
    check_landings(engine)


def test_the_table_s_flights_remember_the_plane() -> None:
    """Planes with a normal of their own are remembered where balls roll, and only there."""
    rolls = TABLE.derive()
    assert [search_for(s, rolls.flight).remembered for s in rolls.surfaces] == [True] * 3 + [False]
