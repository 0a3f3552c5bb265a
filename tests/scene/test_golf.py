"""The golf hole of the examples: putts and chips that roll into the cup, around it and out of it.

On the wall of the cup the horizontal speed stays, and the ball swings up and down: with the turn
rate W about the axis, vz'' = -beta W² vz, beta = kappa/(1 + kappa).
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import Event
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT
from tests.helpers.commands import output
from tests.helpers.effort import exceptions, trials

pytestmark = [pytest.mark.xdist_group("golf"), pytest.mark.slow]  # compiled once

BALL, HOLE, GRAVITY = 0.02135, 0.054, 9.81
WIDTH = HOLE - BALL
BETA = (2 / 5) / (1 + 2 / 5)
ON_GREEN, ON_WIRE, ON_WALL = range(3)

Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def golf() -> Engine:
    return hoopgen.compile(hoopgen.load_scene(ROOT / "examples" / "scenes" / "golf.toml"))


def putts(count: int, seed: int) -> Floats:
    """Return balls that roll towards the hole, most of them to one side of its middle."""
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 1] = random.uniform(-1.5, -0.3, count), random.normal(0, 0.03, count)
    states[:, 2] = BALL + 1e-9
    states[:, 3] = random.uniform(0.1, 1.8, count)
    states[:, 7] = states[:, 3] / BALL
    return states


def chips(count: int, seed: int) -> Floats:
    """Return balls that fall onto the green some decimetres from the hole, with any spin."""
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 1] = random.uniform(-0.8, -0.2, count), random.normal(0, 0.03, count)
    states[:, 2] = random.uniform(0.05, 0.4, count)
    states[:, 3:6] = random.normal((0.75, 0, 0), (0.35, 0.1, 0.5), (count, 3))
    states[:, 6:] = random.normal(0, 10, (count, 3))
    return states


def test_few_putts_and_chips_are_uncertain(golf: Engine) -> None:
    for states, share, rolls in ((putts, 0.05, 0.3), (chips, 0.03, 0.03)):
        shots = golf.simulate(states(trials(600, 200), 1), time_limit=20)
        assert np.mean(shots.outcome == golf.outcomes["HOLED"]) > 0.2
        assert np.mean(shots.rolls > 2) > rolls
        assert np.count_nonzero(shots.uncertain) <= exceptions(share, len(shots))


def on_the_wall(golf: Engine) -> tuple[list[tuple[Any, Any, Any]], hoopgen.Shots]:
    """Return each roll on the wall: what was before it, its begin and its end."""
    shots = golf.simulate(putts(trials(600, 200), 2), time_limit=20, record=True)
    events = shots.events
    begins = np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] == ON_WALL))
    sure = [k for k in begins if not shots.uncertain[events[k]["shot"]]]
    return [(events[k - 1], events[k], events[k + 1]) for k in sure], shots


def test_on_the_wall_a_ball_swings_up_and_down(golf: Engine) -> None:
    rolls, _ = on_the_wall(golf)
    assert len(rolls) > 10
    for _, begin, end in rolls:
        place, velocity, spin = (begin["after"][k : k + 3] for k in (0, 3, 6))
        lasting = end["time"] - begin["time"]
        outward = np.array([place[0], place[1], 0]) / WIDTH
        around = place[0] * velocity[1] - place[1] * velocity[0]
        turn = around / WIDTH**2
        push = -(1 - BETA) * GRAVITY - BETA * BALL * (spin @ outward) * turn
        rate = abs(turn) * np.sqrt(BETA)
        swing, rise = np.sin(rate * lasting) / rate, velocity[2]
        bow = 2 * np.sin(rate * lasting / 2) ** 2 / rate**2
        state = end["after"]
        assert state[2] == pytest.approx(place[2] + rise * swing + push * bow, abs=1e-12)
        assert state[5] == pytest.approx(rise * np.cos(rate * lasting) + push * swing, abs=1e-11)
        assert np.hypot(*state[:2]) == pytest.approx(WIDTH, abs=1e-15)
        after = state[0] * state[4] - state[1] * state[3]
        assert after == pytest.approx(around, rel=1e-11)


def test_the_wall_and_the_wire_hand_balls_over_where_the_wall_begins(golf: Engine) -> None:
    """The wire gives a ball to the wall at the height of its axis, and most of them are holed."""
    rolls, shots = on_the_wall(golf)
    given = [begin for before, begin, _ in rolls if before["kind"] == Event.LEAVE]
    assert given
    for begin in given:
        assert abs(begin["after"][2]) <= 2.0**-50
        assert begin["after"][5] < 0
    assert {end["kind"] for _, _, end in rolls} >= {Event.END}
    assert np.mean(shots.outcome[[b["shot"] for b in given]] == golf.outcomes["HOLED"]) > 0.5


def test_a_ball_that_rises_over_the_wall_rolls_on_the_wire(golf: Engine) -> None:
    """A fast ball in the cup swings up: at its top the wire takes it over, on the same path."""
    state = np.zeros(9)
    state[[0, 2, 4, 5]] = WIDTH - 1e-9, -0.03, 1.5, 1.0
    state[6:] = 0, 1.0 / BALL, -1.5 / BALL
    shots = golf.simulate(state, time_limit=20, record=True)
    rolls = shots.events[shots.events["kind"] == Event.ROLL]
    assert list(rolls["surface"][:2]) == [ON_WALL, ON_WIRE]
    assert abs(rolls[1]["after"][2]) <= 2.0**-50
    assert rolls[1]["after"][5] > 0


def test_a_rounding_of_a_release_changes_no_putt_that_is_certain(golf: Engine) -> None:
    states = putts(trials(400), 3)
    fields = ("outcome", "rolls", "uncertain", "counts", "state", "state_error")
    shots = golf.simulate(states, time_limit=6, fields=fields)
    for component in (0, 1, 3):
        moved = states.copy()
        moved[:, component] = np.nextafter(moved[:, component], np.inf)
        others = golf.simulate(moved, time_limit=6, fields=fields)
        sure = ~shots.uncertain & ~others.uncertain
        assert np.array_equal(shots.outcome[sure], others.outcome[sure])
        assert np.array_equal(shots.rolls[sure], others.rolls[sure])
        alike = sure & (shots.counts == others.counts).all(axis=1)
        assert np.count_nonzero(alike) > 0.9 * len(states)
        for k in range(3):
            off = np.abs(shots.state - others.state)[alike, 3 * k : 3 * k + 3].max(axis=1)
            assert (off <= shots.state_error[alike, k]).all()


def test_the_contacts_of_a_shot_are_those_of_its_table(golf: Engine) -> None:
    """A roll that goes on from the green to its edge is a contact, and no impact."""
    words = ["--position=-30cm,0,5cm", "--velocity", "1.2,0.02,0"]
    text = output("shot", "--scene", ROOT / "examples" / "scenes" / "golf.toml", *words)
    assert "contacts   22 (green 20, edge 0, cup 1; 1 roll went on to another body)" in text
    assert text.count("rolls on ") == 2
    numbers = re.findall(r"^ *(\d+)  \d", text, re.MULTILINE)
    assert list(map(int, numbers)) == list(range(1, 22))
