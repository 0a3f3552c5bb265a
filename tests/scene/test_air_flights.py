"""Flights through air beside independent integrators; little air, and shots that are absurd."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

for _library in ("flint", "scipy", "sympy"):
    pytest.importorskip(_library)

import flint  # noqa: E402
from hoopgen.derive.scenes.air import AIR as SCENE  # noqa: E402

import hoopgen  # noqa: E402
from benchmarks import air  # noqa: E402
from benchmarks.peers import PEERS  # noqa: E402
from hoopgen import PAPER_AIR, Outcome  # noqa: E402
from hoopgen.simulation.lookup import BUILT_IN  # noqa: E402
from tests.helpers.effort import exceptions, trials  # noqa: E402
from tests.helpers.precise_air import PreciseAir  # noqa: E402

# One worker: the scene is compiled once.
pytestmark = pytest.mark.xdist_group("air")

Floats = NDArray[np.float64]

DURATION = 0.7  # s, before any contact
CLAIMS = ("outcome", "contacts", "state", "time", "uncertain", "time_error", "state_error")


def throws(count: int, seed: int) -> Floats:
    """Return throws from the free-throw line, high and fast enough to be in the air for long."""
    random = np.random.default_rng(seed)
    states: Floats = hoopgen.release(
        random.normal(7.5, 0.3, count),
        random.normal(0.9, 0.06, count),
        azimuth=random.normal(0.0, 0.05, count),
        backspin=random.normal(15.0, 20.0, count),
        sidespin=random.normal(0.0, 20.0, count),
        height=2.1,
        distance=5.5,
    )
    states[:, 6] += random.normal(0.0, 20.0, count)
    return states


def share_of_claims(states: Floats, truth: Floats) -> float:
    """Return the largest error of positions and velocities at `DURATION` over what is claimed."""
    shots = hoopgen.AIR.simulate(states, PAPER_AIR, time_limit=DURATION, fields=CLAIMS)
    flying = shots.outcome == Outcome.ENDLESS  # two of a thousand are down before
    assert (~flying).sum() < exceptions(0.01, len(states))
    assert not shots.contacts.any()
    assert not shots.uncertain.any()
    off = np.abs(shots.state - truth)[flying, :6].reshape(-1, 2, 3).max(axis=2)
    return float((off / shots.state_error[flying, :2]).max())


@pytest.mark.parametrize("count", [20, pytest.param(1_000, marks=pytest.mark.slow)])
def test_flights_are_those_of_35_digits_within_their_bounds(count: int) -> None:
    states = throws(trials(count, at_least=5), 1)
    precise = PreciseAir(SCENE)
    inputs = [flint.arb(float(value)) for value in hoopgen.AIR.table.inputs(dict(PAPER_AIR))]
    truth = states.copy()
    with flint.ctx.workdps(precise.digits):
        for row, state in enumerate(states):
            now = [flint.arb(one) for one in state.tolist()]
            truth[row, :6] = [float(x) for x in precise.fly(flint.arb(DURATION), now, inputs)[:6]]
    assert share_of_claims(states, truth) < 1.0


def test_flights_are_those_of_heyoka_within_their_bounds() -> None:
    hy: Any = pytest.importorskip("heyoka")
    x = hy.make_vars("x", "y", "z", "vx", "vy", "vz")
    drag, lift, smooth, weight, *spin = (hy.par[k] for k in range(7))
    v, (wx, wy, wz) = x[3:], spin
    slowing = drag * hy.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + smooth)
    magnus = (wy * v[2] - wz * v[1], wz * v[0] - wx * v[2], wx * v[1] - wy * v[0])
    forces = [lift * m - slowing * u for m, u in zip(magnus, v, strict=True)]
    forces[2] = forces[2] - weight
    rates = [*zip(x[:3], v, strict=True), *zip(v, forces, strict=True)]
    of, radius = PAPER_AIR, PAPER_AIR["ball_radius"]
    half = of["air_density"] * np.pi * radius**2 / (2.0 * of["ball_mass"])
    volume = 4.0 / 3.0 * np.pi * radius**3
    constants = [
        half * of["drag_coefficient"],
        half * radius * of["lift_coefficient"],
        of["drag_smoothing_speed"] ** 2,
        of["gravity"] * (1.0 - of["air_density"] * volume / of["ball_mass"]),
    ]
    ball = hy.taylor_adaptive(rates, [0.0] * 6, tol=1e-16)
    states = throws(trials(1_000, at_least=100), 2)
    truth = states.copy()
    for row, state in enumerate(states):
        ball.time, ball.state[:] = 0.0, state[:6]
        ball.pars[:] = [*constants, *state[6:]]
        ball.propagate_until(DURATION)
        truth[row, :6] = ball.state
    assert share_of_claims(states, truth) < 1.0


@pytest.mark.slow
def test_whole_shots_are_those_of_heyoka_within_their_bounds() -> None:
    pytest.importorskip("heyoka")
    peer = next(one for one in PEERS if one.key == "heyoka_events")
    states = air.throws(trials(400, at_least=100))
    shots = hoopgen.AIR.simulate(states, PAPER_AIR, max_contacts=20, fields=CLAIMS)
    other = peer.fly(states, PAPER_AIR)
    sure = ~shots.uncertain & np.isin(shots.outcome, (Outcome.MADE, Outcome.MISSED))
    assert (shots.contacts[sure] > 0).sum() >= 0.4 * len(states)
    assert (other.outcome == shots.outcome)[sure].all()
    assert (other.contacts == shots.contacts)[sure].all()
    assert (np.abs(other.time - shots.time) <= shots.time_error)[sure].all()


def test_of_little_air_flights_differ_in_proportion_to_it() -> None:
    """To first order by the density: a tenth of the air moves a ball a tenth as far."""
    states, times = throws(50, 3), np.full(50, DURATION)
    own = dict(PAPER_AIR)
    vacuum = hoopgen.HOOP.fly(times, states, dict(hoopgen.PAPER))
    parts = np.array([1e-2, 1e-3, 1e-4])
    moved = [
        hoopgen.AIR.fly(times, states, own | {"air_density": part * own["air_density"]}) - vacuum
        for part in parts
    ]
    slopes = [
        np.linalg.norm(one[:, :3], axis=1) / part for one, part in zip(moved, parts, strict=True)
    ]
    assert slopes[-1].min() > 0.1  # m, of the whole air
    for slope, part in zip(slopes[:-1], parts[:-1], strict=True):
        # The second order is less than the square of the velocity's share, some ten percent, at 1.
        assert np.abs(slope / slopes[-1] - 1.0).max() < 0.5 * part
        assert np.abs(slope / slopes[-1] - 1.0).max() > 1e-3 * part


def test_the_magnus_force_does_no_work() -> None:
    states, own = throws(50, 4), dict(PAPER_AIR) | {"drag_coefficient": 0.0}
    end = hoopgen.AIR.fly(np.full(50, DURATION), states, own)
    volume = 4.0 / 3.0 * np.pi * own["ball_radius"] ** 3
    weight = own["gravity"] * (1.0 - own["air_density"] * volume / own["ball_mass"])
    energy = [weight * s[:, 2] + 0.5 * (s[:, 3:6] ** 2).sum(axis=1) for s in (states, end)]
    np.testing.assert_allclose(energy[1], energy[0], rtol=1e-14, atol=0)
    parabola = hoopgen.HOOP.fly(np.full(50, DURATION), states, dict(hoopgen.PAPER))
    assert np.abs(end - parabola)[:, :3].max() > 0.1  # m: it has turned the flights


@pytest.mark.parametrize(
    "name",
    [
        "air",
        pytest.param("court-air", marks=[pytest.mark.slow, pytest.mark.xdist_group("court_air")]),
    ],
)
def test_absurd_shots_end_as_uncertain_or_invalid_and_soon(name: str) -> None:
    """Steps become as short as they may, so that nothing is proved; the time limit ends them.

    The first one spins 18,000 rad/s, and its flight is still proved.
    """
    scene = BUILT_IN[name]()
    state = hoopgen.release(7.4, 0.9, backspin=18.0, height=2.1, distance=4.191)
    faster = [1.0, 1.0, 1.0, 1.0, 1.0, 1e4, 1e6, 1e12, 1e300]
    turning = [1e3, 1e4, 1e6, 1e15, 1e300, 1.0, 1.0, 1.0, 1.0]
    states = np.tile(state, (len(faster), 1))
    states[:, 3:6] *= np.array(faster)[:, None]
    states[:, 6:] *= np.array(turning)[:, None]
    shots = hoopgen.simulate(states, scene=scene, time_limit=0.2)
    invalid = shots.outcome == scene.outcomes["INVALID"]
    assert (shots.uncertain | invalid)[1:].all()
    assert not invalid[[0, 1, 2, 5, 6]].any()
    assert (shots.time[~invalid] <= 0.2).all()


@pytest.mark.parametrize(
    "wrong",
    [
        {"air_density": -1.0},
        {"ball_mass": 0.0},
        {"ball_mass": 1e-3},  # lighter than the air it displaces
        {"drag_coefficient": np.nan},
        {"drag_coefficient": -0.1},
        {"lift_coefficient": np.inf},
        {"drag_smoothing_speed": 0.0},
    ],
    ids=str,
)
def test_air_that_cannot_be_is_an_invalid_row_or_one_clear_error(wrong: dict[str, float]) -> None:
    (name,) = wrong
    release = {"speed": 7.4, "elevation": 0.9, "height": 2.1, "distance": 4.191}
    state = hoopgen.release(**release)
    scene = hoopgen.AIR
    assert hoopgen.simulate(state, wrong, scene=scene).outcome[0] == Outcome.INVALID
    (why,) = hoopgen.why_invalid(state, wrong, scene=scene)
    assert name in why
    with pytest.raises(ValueError, match=rf"^parameters: no shot can be simulated .*{name}"):
        hoopgen.estimate(hoopgen.Scatter(release, {"speed": 0.1}), wrong, scene=scene, shots=9)
