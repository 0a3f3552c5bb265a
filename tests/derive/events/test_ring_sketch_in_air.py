"""Promises of the ring's search along sketches in air: the whole series has what it proves."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from hoopgen.derive.events import search_for
from hoopgen.derive.events.ring.air_sketch import MAX_STEPS, AirRingSketch
from hoopgen.derive.events.root_search import RootSearch
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.kernels.arguments import argument_order
from hoopgen.derive.motion.air_series import ORDER
from hoopgen.derive.scenes.air import AIR
from numpy.typing import NDArray

from hoopgen.codegen.program import Program, lower
from tests.derive.events.test_ring_in_air import REACH, RING, SHARE, near_wire
from tests.derive.motion.test_air import Values, begin, run
from tests.helpers.effort import trials

Floats = NDArray[np.float64]

NEAREST = (RING - REACH) / 2


@cache
def programs() -> dict[str, Program]:
    """Return the begin and the step of the search, and what it knows at a time."""
    found = search_for(AIR.surfaces[0], AIR.flight)
    assert isinstance(found, RootSearch)
    sketch = found.sketch
    assert isinstance(sketch, AirRingSketch)
    known = {
        "gap": sketch.gap,
        "rate": sketch.rate,
        "margin": sketch.allowed,
        "rate_margin": sketch.rate_allowed,
    }
    order = (*found.constants, *argument_order(AIR))
    return {
        name: lower(kernel(name, outputs, order, name, name, single=True), AIR.symbols)
        for name, outputs in (
            ("begin", sketch.begin()),
            ("step", sketch.step()),
            ("known", known),
        )
    }


def on_series(known: Values, times: Floats) -> tuple[Floats, Floats, Floats]:
    """Return F, F' and rho on the whole series at times, each (n,)."""
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
    rho = np.hypot(x, y)
    rate = 2 * ((rho - RING) * (x * vx + y * vy) / rho + z * vz)
    return (rho - RING) ** 2 + z**2 - REACH**2, rate, rho


def begun(state: Floats, leaving: float = 0.0) -> tuple[Values, Values]:
    """Return a piece, and the search along its sketch up to its end."""
    known = begin(state)
    given = known | {"horizon": known["piece"], "leaving": leaving}
    search = run(programs()["begin"], given)
    return known, known | search | {"leaving": leaving}


def moved(state: Floats, random: np.random.Generator, known: Values) -> Floats:
    """Return a state that differs by what a search allows for."""
    found = state.copy()
    found[:3] += SHARE * known["extent"] * random.choice([-1.0, 1.0], 3)
    found[3:6] += SHARE * known["piece_speed"] * random.choice([-1.0, 1.0], 3)
    return found


def swift(random: np.random.Generator) -> Floats:
    """Return a state near the wire of a ball at any speed up to that of a throw over the court."""
    state = near_wire(random)
    state[3:6] *= 10 ** random.uniform(0.0, 1.2)
    return state


@pytest.mark.slow
def test_gap_and_rate_of_a_sketch_are_within_their_margins_which_are_not_useless() -> None:
    random = np.random.default_rng(11)
    gaps, rates, sketched = [], [], 0
    for _ in range(trials(300, at_least=150)):
        state = swift(random)
        known, search = begun(state)
        sketched += int(search["sketching"])
        if not search["sketching"]:
            continue
        time = float(np.float32(known["piece"] * random.uniform(0.0, 1.0)))
        found = run(programs()["known"], search | {"t": time})
        other = begin(moved(state, random, known))
        for one in (known, other):
            gap, rate, rho = (float(v[0]) for v in on_series(one, np.array([time])))
            gaps.append(abs(found["gap"] - gap) / found["margin"])
            if rho > NEAREST:
                rates.append(abs(found["rate"] - rate) / found["rate_margin"])
    assert sketched > 50
    assert max(gaps) < 1.0
    assert max(rates) < 1.0
    assert max(gaps) > 2.0**-12
    assert max(rates) > 2.0**-16


@dataclass(frozen=True)
class Proof:
    """The proof of a search: no contact up to a time, and what follows."""

    time: float
    missed: bool
    lands: bool


def searched(search: Values) -> Proof:
    """Return what the search along a sketch proves."""
    for _ in range(MAX_STEPS + 1):
        if not search["sketching"]:
            break
        search = search | run(programs()["step"], search)
    return Proof(search["t"], bool(search["misses"]), bool(search["landed"]))


def check(states: list[Floats], leaving: float, random: np.random.Generator) -> dict[str, int]:
    """Return how many flights miss the ring and land on it; check what searches prove of them.

    The same must be true of others that differ by what a search allows for.
    """
    counts = {"missed": 0, "lands": 0}
    for state in states:
        known, search = begun(state, leaving)
        proof = searched(search)
        counts["missed"] += int(proof.missed)
        counts["lands"] += int(proof.lands)
        for one in (known, begin(moved(state, random, known))):
            last = known["piece"] if proof.missed else proof.time
            # The other flight does not begin on the ring that it leaves.
            first = 1e-3 if leaving else 0.0
            spare = 1e-5 if proof.lands else 0.0
            times = np.linspace(first, last - spare, 3000)
            if last - spare > first:
                assert (on_series(one, times)[0] > 0.0).all()
            if proof.lands:
                around = np.array([proof.time - 1e-5, proof.time + 1e-5])
                before, after = on_series(one, around)[0]
                assert before > 0.0 > after
    return counts


def outside(random: np.random.Generator) -> Floats:
    """Return a state outside of the ring, near it, of a ball that mostly comes nearer."""
    angle, around = random.uniform(0, 2 * np.pi, 2)
    off = REACH * random.uniform(1.02, 4.0)
    out = RING + off * np.cos(angle)
    place = np.array([out * np.cos(around), out * np.sin(around), off * np.sin(angle)])
    target = random.uniform(0, 2 * np.pi)
    aim = np.array([RING * np.cos(target), RING * np.sin(target), 0.0])
    aim += random.normal(size=3) * 0.7 * REACH
    velocity = (aim - place) * random.uniform(4.0, 15.0)
    return np.array([*place, *velocity, *(20.0 * random.normal(size=3))])


def bounced(random: np.random.Generator) -> Floats:
    """Return a state on the ring of a ball that leaves it."""
    angle = random.uniform(-0.5, np.pi + 0.5)
    normal = np.array([np.cos(angle), 0.0, np.sin(angle)])
    place = np.array([RING, 0.0, 0.0]) + REACH * normal
    along = random.normal(size=3) * 1.5
    velocity = along - (along @ normal) * normal + normal * random.uniform(0.05, 3.0)
    return np.array([*place, *velocity, *(20.0 * random.normal(size=3))])


@pytest.mark.slow
def test_a_sketch_proves_only_misses_and_contacts_that_the_series_has() -> None:
    random = np.random.default_rng(12)
    states = [outside(random) for _ in range(trials(300, at_least=150))]
    found = check(states, 0.0, random)
    assert found["missed"] > len(states) // 8
    assert found["lands"] > len(states) // 8


@pytest.mark.slow
def test_a_sketch_proves_of_balls_that_leave_the_ring_only_what_is_true() -> None:
    random = np.random.default_rng(13)
    states = [bounced(random) for _ in range(trials(200, at_least=100))]
    found = check(states, 1.0, random)
    assert found["missed"] > len(states) // 4


def test_a_sketch_serves_no_piece_of_which_it_leaves_out_too_much() -> None:
    random = np.random.default_rng(14)
    unserved = 0
    for _ in range(trials(60, at_least=30)):
        state = near_wire(random)
        state[3:6] *= 20.0
        known, search = begun(state)
        assert not search["sketching"] or known["piece_rest"] <= 2.0**-18 * known["piece_speed"]
        unserved += int(not search["sketching"])
    assert unserved > 0
