"""Conserved quantities and a shot's dependence on its past, on the benchmarks' workloads.

Energy and angular momentum at single contacts, the mirror image and the end of a continued shot
are in test_simulate.py, for shots of all kinds.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from benchmarks.workloads import WORKLOADS, Workload
from hoopgen import PAPER, Outcome
from tests.helpers.effort import occurrences, trials
from tests.helpers.engines import Simulate

EPS = float(np.finfo(np.float64).eps)
RING, BACKBOARD, BRIDGE, END = range(4)
SHOTS = trials(400, at_least=40)
RADIUS = PAPER["ball_radius"]
REACH = RADIUS + PAPER["wire_radius"]

each_workload = pytest.mark.parametrize("workload", WORKLOADS, ids=lambda workload: workload.label)


def energy(states: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return kinetic, rotational (a thin shell's) and potential energy per mass, J/kg.

    Heights count from a metre below the ring: none is negative.
    """
    spin = RADIUS * states[:, 6:]
    moving = np.sum(states[:, 3:6] ** 2, axis=1) / 2 + np.sum(spin**2, axis=1) / 3
    return moving + PAPER["gravity"] * (states[:, 2] + 1)


def contacts_of(shots: hoopgen.Shots) -> NDArray[Any]:
    return shots.events[shots.events["surface"] != END]


def normals(log: NDArray[Any]) -> NDArray[np.float64]:
    """Return Table 2's normals, those of the ring made as long as 1."""
    x, y, z = log["after"][:, :3].T
    outward = 1 - PAPER["ring_radius"] / np.hypot(x, y)
    ring = np.stack([x * outward, y * outward, z], axis=1)
    ring /= np.linalg.norm(ring, axis=1)[:, None]
    fixed = np.array([[0, 0, 0], [1, 0, 0], [0, 0, 1]], dtype=float)
    surface = log["surface"]
    return np.where((surface == RING)[:, None], ring, fixed[surface])


@pytest.mark.sampled(40)
@each_workload
@pytest.mark.parametrize("restitution", [0.0, 0.4, 0.7, 1.0])
def test_no_shot_ends_with_more_energy_than_it_began_with(
    simulate: Simulate, workload: Workload, restitution: float
) -> None:
    states = workload.make(SHOTS)
    shots = simulate(states, PAPER | {"restitution": restitution})
    start = energy(states)
    # About sixteen roundings a flight and a contact, of squares: twice that.
    assert np.all(energy(shots.state) <= start * (1 + 64 * EPS * (1 + shots.contacts)))


@pytest.mark.sampled(40)
@each_workload
@pytest.mark.parametrize("restitution", [0.0, 0.7, 1.0])
def test_a_contact_takes_what_rolling_and_restitution_take(
    simulate: Simulate, workload: Workload, restitution: float
) -> None:
    """The loss with restitution 1 is that of rolling alone: s²/5, s the speed of slip.

    The impulse that stops the slip works against the mass and the inertia of a thin shell,
    1 / (1/m + R²/I) = 2 m/5. Restitution takes (1 - e²)/2 of the squared normal speed.
    """
    shots = simulate(workload.make(SHOTS), PAPER | {"restitution": restitution}, record=True)
    log = contacts_of(shots)
    normal = normals(log)
    velocity, spin = log["before"][:, 3:6], log["before"][:, 6:]
    approach = np.sum(velocity * normal, axis=1)
    slip = velocity - approach[:, None] * normal - RADIUS * np.cross(spin, normal)
    taken = np.sum(slip**2, axis=1) / 5 + (1 - restitution**2) / 2 * approach**2
    there = log["before"].copy()
    there[:, :3] = log["after"][:, :3]  # a plane takes the ball onto itself
    before, after = energy(there), energy(log["after"])
    # As in test_simulate.py: roundings, and how far the place is off the ring, to second order.
    x, y, z = log["after"][:, :3].T
    away = np.abs(np.hypot(np.hypot(x, y) - PAPER["ring_radius"], z) - REACH)
    off = np.where(log["surface"] == RING, away / REACH, 0.0)
    assert np.all(np.abs(before - after - taken) <= before * (64 * EPS + 8 * off))


@pytest.mark.sampled(26)
@each_workload
def test_from_any_contact_on_the_rest_is_the_rest_bit_for_bit(
    simulate: Simulate, workload: Workload
) -> None:
    """Surfaces and states of every later event; times but for the clock's roundings."""
    whole = simulate(workload.make(SHOTS), max_contacts=40, record=True)
    log = whole.events
    first = np.searchsorted(log["shot"], log["shot"])
    number = np.arange(len(log)) - first + 1
    rows = np.flatnonzero((log["surface"] != END) & (number < 40))
    if workload.label == "swish":
        assert not len(rows)
        return
    starts = log[rows]
    rest = simulate(starts["after"], max_contacts=40, leaving=starts["surface"], record=True)
    assert not np.any(rest.outcome == Outcome.INVALID)
    ends = np.searchsorted(log["shot"], log["shot"], "right")
    compared = 0
    for start, row in enumerate(rows):
        wanted = log[row + 1 : ends[row]]
        got = rest.events[rest.events["shot"] == start] if start < 300 else None
        if got is None:
            break
        got = got[: len(wanted)]  # a capped shot goes on when it is continued
        assert got["surface"].tobytes() == wanted["surface"].tobytes()
        assert got["before"].tobytes() == wanted["before"].tobytes()
        assert got["after"].tobytes() == wanted["after"].tobytes()
        # Either clock is a sum of flights, rounded to half an eps of itself each time.
        late = np.abs(got["time"] + log["time"][row] - wanted["time"])
        assert np.all(late <= 41 * EPS * wanted["time"])
        compared += len(wanted)
    assert compared > occurrences(100)
    over = whole.outcome[starts["shot"]] != Outcome.CAPPED
    np.testing.assert_array_equal(rest.outcome[over], whole.outcome[starts["shot"]][over])
    np.testing.assert_array_equal(rest.state[over], whole.state[starts["shot"]][over])
    np.testing.assert_array_equal(
        rest.contacts[over], (whole.contacts[starts["shot"]] - number[rows])[over]
    )


@pytest.mark.sampled(19)
@pytest.mark.parametrize("restitution", [0.0, 0.5, 0.7])
@pytest.mark.parametrize("most", [40, 400])
def test_infinitely_many_hops_take_a_finite_time_and_are_capped(
    simulate: Simulate, restitution: float, most: int
) -> None:
    """On the bridge the hops of a fall from h take sqrt(2 h/g) (1 + e)/(1 - e) in all."""
    random = np.random.default_rng(9)
    states = np.zeros((50, 9))
    states[:, 0] = random.uniform(-0.2590, -0.24, 50)
    states[:, 2] = random.uniform(0.2, 0.6, 50)
    shots = simulate(states, PAPER | {"restitution": restitution}, max_contacts=most)
    assert np.all(shots.outcome == Outcome.CAPPED)
    assert np.all(shots.counts[:, BRIDGE] == most)
    fall = np.sqrt(2 * (states[:, 2] - REACH) / PAPER["gravity"])
    limit = fall * (1 + restitution) / (1 - restitution)
    assert np.all(shots.time <= limit * (1 + 4 * most * EPS))
    # What is missing after n contacts is its share e^n.
    assert np.all(shots.time >= limit * (1 - 3 * restitution**most - 4 * most * EPS))


@pytest.mark.slow
def test_a_swirl_s_last_hops_take_no_time_at_all(simulate: Simulate) -> None:
    """A capped swirl stays where it is: more contacts do not move it by a micrometre."""
    swirl = next(w for w in WORKLOADS if w.label == "swirl")
    states = swirl.make(SHOTS)
    states[:, 8] = 2.0  # as the article's case 6b with its spin
    some = simulate(states, max_contacts=60)
    more = simulate(states, max_contacts=600)
    capped = (some.outcome == Outcome.CAPPED) & (more.outcome == Outcome.CAPPED)
    assert capped.any()
    assert np.all(more.time[capped] - some.time[capped] < 1e-6)
    assert np.all(np.abs(more.state - some.state)[capped, :3] < 1e-6)
