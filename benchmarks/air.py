"""Flights in air: the speed, errors and missed contacts of hoopgen, heyoka.py and SciPy
(`python -m benchmarks --only air`).

The throws are the free throws of the other benchmarks, all faster by the share that takes the mean
one through the ring's centre again. Grazes are found by bisection between throws that meet the
ring first and throws that do not.
"""

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.contenders import RESULTS, Contender
from benchmarks.errors import MAX_CONTACTS, Errors, by_certain, by_hoopgen, compare, judge
from benchmarks.families import seeded
from benchmarks.peers import EVERYBODY, Peer, taking_part
from benchmarks.timing import Rates, Spread, rounds
from benchmarks.workloads import States, Workload, free_throw
from hoopgen import PAPER, PAPER_AIR
from hoopgen.judge import certify
from hoopgen.simulation.without_bounds import SHOTS_WORTH_A_LOOP

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

FASTER = 1.0263
"""Speed in air over that without: the mean throw falls through the ring's centre in both."""

RING = 0
WINDOW = 5e-4
"""A contact so near to a graze in time (s) is the graze's."""
DISTANCES = (1e-11, 1e-6)
"""Shares of the speed by which grazes differ from the border between touching and passing."""
SHALLOW = 1e-2
"""A border is a graze's if the ball comes to the ring at less than this share of its speed."""

METHODS = {
    "heyoka_events": "Taylor series, heyoka.py: batch of 8, four terminal events",
    "solve_ivp_events": "solve_ivp, SciPy: DOP853, rtol and atol 1e-12, steps up to 1e-2 s",
}
"""Peers that fly in air, by their keys, and what they do."""


@dataclass(frozen=True)
class Size:
    """The extent of a run."""

    rounds: int = 9
    budget: float = 0.5
    """Seconds a turn of those who fly a part."""
    batch: int = 1 << 14
    compared: int = 1000
    """Throws whose answers are compared with hoopgen's certain ones."""
    proved: int = 60
    """Throws, the first of these, whose answers are proved."""
    grazes: int = 150
    """Borders; each has a throw that touches and one that passes."""


QUICK = Size(rounds=3, budget=0.1, batch=1 << 11, compared=48, proved=6, grazes=10)


def throws(n: int) -> States:
    """Return n free throws for air, shape (n, 9)."""
    states = free_throw(n)
    states[:, 3:6] *= FASTER
    return states


def _airless(states: States, **arguments: Any) -> object:
    slower = states.copy()
    slower[:, 3:6] /= FASTER
    return hoopgen.simulate(slower, PAPER, **arguments)


def contenders(peers: Sequence[Peer], batch: int) -> tuple[Contender, ...]:
    """Return who flies: hoopgen, first with all its results, its airless engine, and peers."""
    one: dict[str, Any] = {"backend": "c", "threads": 1, "max_contacts": MAX_CONTACTS}
    hoopgen.AIR.library_without_bounds(SHOTS_WORTH_A_LOOP)  # which is made before anything is timed
    fly = partial(hoopgen.simulate, parameters=PAPER_AIR, scene=hoopgen.AIR)
    return (
        Contender(
            "hoopgen", "hoopgen C, 1 thread, all fields", "hoopgen", partial(fly, **one), batch
        ),
        Contender(
            "hoopgen_three",
            "hoopgen C, 1 thread, three fields",
            "hoopgen",
            partial(fly, **one, fields=RESULTS),
            batch,
        ),
        Contender(
            "airless",
            "hoopgen C, 1 thread, all fields, without air",
            "hoopgen",
            partial(_airless, **one),
            batch,
        ),
        *(
            Contender(peer.key, METHODS[peer.key], "peer", partial(peer.fly, parameters=PAPER_AIR))
            for peer in peers
        ),
    )


@dataclass(frozen=True)
class Grazes:
    """Pairs of throws beside a border: those that touch and those that pass, (n, 9), and when the
    former do (s)."""

    touching: States
    passing: States
    time: Floats


def _meets_ring(states: States) -> Bools:
    shots = hoopgen.AIR.simulate(states, PAPER_AIR, max_contacts=1, fields=("first",))
    return np.asarray(shots.first == RING)


def _at(states: States, factor: Floats) -> States:
    moved = states.copy()
    moved[:, 3:6] *= factor[:, None]
    return moved


def _is_graze(states: States) -> Bools:
    """Return a mask of the throws that come to the ring almost along it."""
    shots = hoopgen.AIR.simulate(states, PAPER_AIR, max_contacts=1, record=True)
    rows = shots.events[shots.events["surface"] == RING]
    x, y, z, vx, vy, vz = rows["before"][:, :6].T
    out = np.hypot(x, y)
    across = (out - PAPER["ring_radius"]) / out
    normal = np.stack([x * across, y * across, z])
    speeds = np.abs((normal * np.stack([vx, vy, vz])).sum(axis=0)) / np.linalg.norm(normal, axis=0)
    shallow = np.zeros(len(states), np.bool_)
    shallow[rows["shot"]] = speeds < SHALLOW * np.sqrt(vx**2 + vy**2 + vz**2)
    return shallow


def grazes(n: int) -> Grazes:
    """Return n pairs of throws, at most, the same whenever they are asked for."""
    random = seeded("graze in air")
    draws = throws(8 * n)
    factors = np.linspace(0.93, 1.07, 29)
    met = np.stack([_meets_ring(_at(draws, np.full(len(draws), one))) for one in factors])
    steps, rows = np.nonzero(met[1:] != met[:-1])
    states = draws[rows]
    touching = np.where(met[steps + 1, rows], factors[steps + 1], factors[steps])
    passing = np.where(met[steps + 1, rows], factors[steps], factors[steps + 1])
    for _ in range(60):
        middle = (touching + passing) / 2
        inside = _meets_ring(_at(states, middle))
        touching, passing = np.where(inside, middle, touching), np.where(inside, passing, middle)
    way = np.sign(np.where(met[steps + 1, rows], 1.0, -1.0))
    least, most = np.log10(DISTANCES)
    far = 10 ** random.uniform(least, most, (2, len(way)))
    near, beyond = (
        _at(states, touching * (1 + way * far[0])),
        _at(states, passing * (1 - way * far[1])),
    )
    good = _is_graze(near)
    kept = random.permutation(np.flatnonzero(good))[:n]
    time = hoopgen.AIR.simulate(near[kept], PAPER_AIR, max_contacts=1, fields=("time",)).time
    return Grazes(near[kept], beyond[kept], time)


@dataclass(frozen=True)
class Tally:
    """A contender's grazes: contacts missed and invented without a flag, and uncertain shots."""

    touching: int
    passing: int
    missed: int
    invented: int
    uncertain: int


Look = Callable[[States], tuple[NDArray[np.int8], Floats, Bools]]
"""Function of states to the first surface, the time of its contact, and what is undecided."""


def _by_hoopgen(states: States) -> tuple[NDArray[np.int8], Floats, Bools]:
    shots = hoopgen.AIR.simulate(states, PAPER_AIR, max_contacts=1)
    return shots.first, shots.time, shots.uncertain


def _by_peer(peer: Peer, states: States) -> tuple[NDArray[np.int8], Floats, Bools]:
    flown = peer.fly(states, PAPER_AIR, 1, record=True)
    return flown.surfaces[:, 0], flown.time, np.zeros(len(states), np.bool_)


def tally(found: Grazes, look: Look, known: Bools) -> Tally:
    """Return the tally of somebody's grazes, of those whose truth is `known`, (2, n)."""
    seen = [look(states) for states in (found.touching, found.passing)]
    touches = np.stack([(f == RING) & (np.abs(t - found.time) < WINDOW) for f, t, _ in seen])
    uncertain = np.stack([one[2] for one in seen])
    sure = known & ~uncertain
    return Tally(
        int(known[0].sum()),
        int(known[1].sum()),
        int((sure[0] & ~touches[0]).sum()),
        int((sure[1] & touches[1]).sum()),
        int((known & uncertain).sum()),
    )


def proved(found: Grazes) -> Bools:
    """Return which of the grazes are proved to touch, or to pass, as they should, (2, n)."""
    known = []
    for states, should in ((found.touching, True), (found.passing, False)):
        proof = certify(states, PAPER_AIR, scene=hoopgen.AIR, max_contacts=1)
        time = np.where(proof.decided, proof.time, np.inf)
        touches = (proof.first == RING) & (np.abs(time - found.time) < WINDOW)
        known.append(proof.decided & (touches == should))
    return np.stack(known)


@dataclass(frozen=True)
class Results:
    """Everything measured, by the contenders' keys."""

    contacts: tuple[float, float]
    """Contacts of a throw, in air and without."""
    rates: dict[str, Rates]
    proved: dict[str, Errors]
    """Errors on throws whose answers are proved."""
    compared: dict[str, Errors]
    """Errors of peers on more throws, where hoopgen is certain."""
    grazes: dict[str, Tally]
    absent: tuple[str, ...]

    def times(self, key: str) -> Spread:
        """Return the time of a shot over that of hoopgen, compared round by round."""
        return self.rates["hoopgen"].over(self.rates[key])


def run(quick: bool) -> Results:
    """Measure everything."""
    size = QUICK if quick else Size()
    peers, absent = taking_part([peer for peer in EVERYBODY if peer.key in METHODS])
    for line in absent:
        print(line, flush=True)
    print("speed", flush=True)
    field = contenders(peers, size.batch)
    states = throws(size.batch)
    workload = Workload("air", "free throws in air", throws, size.batch)
    rates = rounds(field, workload, size.batch, size.rounds, size.budget)
    contacts = (
        float(hoopgen.AIR.simulate(states, PAPER_AIR, max_contacts=MAX_CONTACTS).contacts.mean()),
        float(hoopgen.simulate(free_throw(size.batch), PAPER).contacts.mean()),
    )
    print("errors", flush=True)
    states = throws(size.compared)
    right, certain = (
        judge(states[: size.proved], PAPER_AIR, hoopgen.AIR),
        by_certain(states, PAPER_AIR, hoopgen.AIR),
    )
    own = by_hoopgen(states[: size.proved], PAPER_AIR, hoopgen.AIR)
    correct, compared = {"hoopgen": compare(own, right)}, {}
    for peer in peers:
        flown = peer.fly(states, PAPER_AIR, record=True)
        compared[peer.key] = compare(flown, certain)
        correct[peer.key] = compare(peer.fly(states[: size.proved], PAPER_AIR, record=True), right)
    print("grazes", flush=True)
    found = grazes(size.grazes)
    known = proved(found)
    tallies = {"hoopgen": tally(found, _by_hoopgen, known)}
    tallies |= {peer.key: tally(found, partial(_by_peer, peer), known) for peer in peers}
    return Results(contacts, rates, correct, compared, tallies, absent)


def as_json(results: Results) -> str:
    """Every number."""
    return json.dumps(asdict(results), indent=1) + "\n"
