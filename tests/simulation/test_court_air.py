"""The hoop of a gym in air: without air it is COURT, and proofs agree with it."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import COURT, NBA_COURT_AIR, PAPER_COURT, PAPER_COURT_AIR, Event
from hoopgen.engine.verification import even_numbers
from hoopgen.scene import End, Plane, Scene
from hoopgen.simulation.court import _KINDS as KINDS
from tests.helpers.effort import trials

# One worker: the scene is compiled once, which takes minutes.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("court_air")]

Floats = NDArray[np.float64]

WANTED = ("outcome", "contacts", "first", "rolls", "slip_left", "time", "state", "uncertain")
CLAIMED = (*WANTED, "time_error", "state_error")
SOFT = {f"{body}_restitution": 0.3 for body in COURT.surfaces}


def free_throws(count: int, seed: int) -> Floats:
    random = np.random.default_rng(seed)
    states: Floats = hoopgen.release(
        speed=random.normal(7.3, 0.25, count),
        elevation=np.radians(random.normal(52.0, 3.0, count)),
        azimuth=np.radians(random.normal(0.0, 1.5, count)),
        backspin=random.normal(18.0, 5.0, count),
        height=2.1,
        distance=4.191,
    )
    return states


def thrown(count: int, seed: int = 1) -> Floats:
    """Free throws, and shots from below, from behind the board, and onto its edges."""
    apart = even_numbers(max(1, count // 10), 9)
    near = [np.asarray(centre) + np.asarray(width) * apart for centre, width in KINDS]
    return np.concatenate([free_throws(count // 2, seed), *near])


def heavy(state: Floats, parameters: Any, buoyancy: float) -> Floats:
    """Return the energy per mass of states (n, 9), with a share of the weight carried."""
    spun = parameters["inertia"] * parameters["ball_radius"] ** 2 * (state[:, 6:] ** 2).sum(1)
    moving = (state[:, 3:6] ** 2).sum(1)
    return (moving + spun) / 2 + parameters["gravity"] * (1 - buoyancy) * state[:, 2]


def carried(parameters: Any) -> float:
    volume = 4 / 3 * np.pi * parameters["ball_radius"] ** 3
    return float(parameters["air_density"] * volume / parameters["ball_mass"])


@pytest.mark.parametrize("more", [{}, SOFT], ids=["article", "soft"])
def test_without_air_it_is_the_hoop_of_a_gym(more: dict[str, float]) -> None:
    states = thrown(trials(20_000, at_least=2_000))
    plain = COURT.simulate(states, PAPER_COURT | more, fields=CLAIMED)
    own = hoopgen.COURT_AIR.simulate(
        states, PAPER_COURT_AIR | more | {"air_density": 0.0}, fields=CLAIMED
    )
    sure = ~plain.uncertain & ~own.uncertain
    assert sure.mean() > 0.97
    for name in ("outcome", "contacts", "first", "rolls", "slip_left"):
        assert (getattr(plain, name) == getattr(own, name))[sure].all(), name
    # A short shot is known to be one at another time.
    ended = sure & np.isin(plain.outcome, (0, 1, 2, 5))
    assert (plain.rolls[ended] > 0).sum() > 5
    off = np.abs(plain.state - own.state)[ended].reshape(-1, 3, 3).max(axis=2)
    assert (off <= (plain.state_error + own.state_error)[ended]).all()
    late = np.abs(plain.time - own.time)[ended]
    assert (late <= (plain.time_error + own.time_error)[ended]).all()


@pytest.mark.parametrize("parameters", [PAPER_COURT_AIR | SOFT, NBA_COURT_AIR])
def test_numpy_and_c_give_the_same_bits(parameters: Any) -> None:
    states = thrown(trials(4_000, at_least=400), seed=2)
    every = tuple(hoopgen.COURT_AIR.layout.results)
    by_c = hoopgen.COURT_AIR.simulate(states, parameters, fields=every)
    by_numpy = hoopgen.COURT_AIR.simulate(states, parameters, fields=every, backend="numpy")
    for name in every:
        assert np.array_equal(getattr(by_c, name), getattr(by_numpy, name), equal_nan=True), name


def test_proofs_agree_as_far_as_they_go() -> None:
    states = np.concatenate([thrown(trials(24, at_least=10), seed=3)])
    for parameters in (PAPER_COURT_AIR | SOFT, NBA_COURT_AIR):
        flown = hoopgen.COURT_AIR.simulate(
            states, parameters, max_contacts=24, record=True, fields=CLAIMED
        )
        proof = hoopgen.certify(
            states, parameters, scene=hoopgen.COURT_AIR, max_contacts=24, max_bits=1024, processes=1
        )
        assert (proof.decided | proof.accumulates).mean() > 0.95
        assert proof.agrees(flown).all()


def test_a_shot_says_that_it_rolled_without_air() -> None:
    shots = hoopgen.COURT_AIR.simulate(
        free_throws(trials(2_000, at_least=500), 4), PAPER_COURT_AIR | SOFT
    )
    assert shots.airless_rolls.any()
    assert (shots.airless_rolls == (shots.rolls > 0)).all()
    assert "airless_rolls" not in COURT.layout.results
    assert "airless_rolls" not in hoopgen.HOOP.layout.results


def test_energy_never_grows() -> None:
    """In flights less buoyancy, at impacts, and in rolls, which no air slows."""
    parameters = PAPER_COURT_AIR | SOFT
    states = free_throws(trials(400, at_least=100), 5)
    shots = hoopgen.COURT_AIR.simulate(states, parameters, record=True)
    share, rolled = carried(parameters), 0
    for row in range(len(shots)):
        path = shots.trajectory(row)
        before, after = path.events["before"], path.events["after"]
        starts = np.concatenate([path.release[None], after[:-1]])
        rolling = np.zeros(len(before), np.bool_)
        rolling[[begin + 1 for begin, _, _ in path.rolls]] = True
        lost = heavy(starts, parameters, share) - heavy(before, parameters, share)
        assert (lost[~rolling] > -1e-11).all()
        same = heavy(starts, parameters, 0.0) - heavy(before, parameters, 0.0)
        assert (abs(same[rolling]) < 1e-9).all()
        assert (heavy(before, parameters, 0.0) - heavy(after, parameters, 0.0) > -1e-10).all()
        rolled += int(rolling.sum())
    assert rolled > 5


def test_a_ball_leaves_where_air_takes_it_away() -> None:
    """A flight after a roll does not come back to the ring for a while."""
    shots = hoopgen.COURT_AIR.simulate(
        free_throws(trials(2_000, at_least=500), 6), PAPER_COURT_AIR | SOFT, record=True
    )
    events = shots.events
    left = np.flatnonzero(events["kind"] == Event.LEAVE)
    left = left[~shots.uncertain[events["shot"][left]]]
    assert len(left) > 20
    pause = events["time"][left + 1] - events["time"][left]
    assert (pause > 1e-4).all()


def floor(air: bool = True) -> hoopgen.Scene:
    return Scene(
        "floor_in_air" if air else "floor",
        ball_radius=0.12,
        gravity=9.81,
        restitution=0.5,
        bodies=[Plane("floor")],
        ends={"away": End(at=-1.0)},
        air=air,
        rolls=True,
    )


@cache
def compiled() -> Any:
    return hoopgen.compile(floor())


def test_a_scene_of_ones_own_rolls_in_air() -> None:
    """A ball that falls straight comes to rest when the bounces of an integrator have ended."""
    from scipy.integrate import solve_ivp

    shots = compiled().simulate([0, 0, 1.12, 0, 0, 0, 0, 0, 0])
    assert shots.outcome[0] == compiled().outcomes["LODGED"]
    assert shots.airless_rolls[0]
    half = 1.2 * np.pi * 0.12**2 / (2 * 0.624)
    weight = 9.81 * (1 - 1.2 * 4 / 3 * np.pi * 0.12**3 / 0.624)

    def motion(_: float, y: Floats) -> list[float]:
        return [y[1], -weight - half * 0.5 * np.hypot(y[1], 0.05) * y[1]]

    def lands(_: float, y: Floats) -> float:
        return float(y[0])

    lands.terminal, lands.direction = True, -1.0  # type: ignore[attr-defined]
    time, state = 0.0, [1.0, 0.0]
    for _ in range(18):
        way = solve_ivp(motion, (0, 2), state, "DOP853", rtol=1e-12, atol=1e-15, events=lands)
        time += way.t_events[0][0]
        state = [0.0, -0.5 * way.y_events[0][0][1]]
    time += 2 * state[1] / (weight * 0.5)
    assert abs(shots.time[0] - time) < 2e-5
