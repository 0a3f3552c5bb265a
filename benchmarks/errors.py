"""Errors of each contender in outcome, sequence of contacts and time."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.peers import PEERS, Flown
from benchmarks.workloads import WORKLOADS, States
from hoopgen import PAPER

MAX_CONTACTS = 40


@dataclass(frozen=True)
class Errors:
    """Over some shots: the shares with another outcome, and with another outcome or sequence of
    surfaces, than the judge's; and of those with the same, the error in time (s)."""

    shots: int
    wrong_outcome: float
    wrong_sequence: float
    time_median: float
    time_95: float


def by_hoopgen(
    states: States, parameters: Mapping[str, float] = PAPER, scene: Any = hoopgen.HOOP
) -> Flown:
    """Return hoopgen as a contender, with its surfaces in sequence."""
    shots = hoopgen.simulate(
        states, parameters, scene=scene, max_contacts=MAX_CONTACTS, record=True
    )
    events = shots.events[np.isin(shots.events["surface"], range(len(hoopgen.SURFACES)))]
    first = np.searchsorted(events["shot"], events["shot"])
    surfaces = np.full((len(states), MAX_CONTACTS), -1, np.int8)
    surfaces[events["shot"], np.arange(len(events)) - first] = events["surface"]
    return Flown(shots.outcome, shots.contacts, shots.time, surfaces)


@dataclass(frozen=True)
class Verdict:
    """The right answers, which of the shots have one, and who says so."""

    right: Flown
    known: NDArray[np.bool_]
    judge: str

    def cut(self, n: int) -> "Verdict":
        """Return the verdict on the first n shots."""
        right = self.right
        first = Flown(right.outcome[:n], right.contacts[:n], right.time[:n], right.surfaces[:n])
        return Verdict(first, self.known[:n], self.judge)


def by_certain(states: States, parameters: Mapping[str, float], scene: Any) -> Verdict:
    """Return hoopgen's answers, of which those that are not uncertain count."""
    shots = hoopgen.simulate(states, parameters, scene=scene, max_contacts=MAX_CONTACTS)
    own = by_hoopgen(states, parameters, scene)
    return Verdict(own, ~shots.uncertain, "hoopgen where it is certain")


def judge(
    states: States, parameters: Mapping[str, float] = PAPER, scene: Any = hoopgen.HOOP
) -> Verdict:
    """Ball arithmetic if it is installed, else hoopgen where it is certain."""
    try:
        from hoopgen.judge import certify
    except ImportError:
        return by_certain(states, parameters, scene)
    proved = certify(states, parameters, scene=scene, max_contacts=MAX_CONTACTS)
    surfaces = np.full((len(states), MAX_CONTACTS), -1, np.int8)
    for row, proof in zip(surfaces, proved.proofs, strict=True):
        touched = [surface for surface in proof.surfaces if surface < len(hoopgen.SURFACES)]
        row[: len(touched)] = touched
    right = Flown(proved.outcome, proved.contacts, proved.time, surfaces)
    return Verdict(right, proved.decided, "proofs in ball arithmetic")


def compare(flown: Flown, verdict: Verdict) -> Errors:
    """Errors over the shots whose right answer is known."""
    right, known = verdict.right, verdict.known
    outcome = (flown.outcome != right.outcome)[known]
    sequence = outcome | (flown.surfaces != right.surfaces).any(axis=1)[known]
    late = np.abs(flown.time - right.time)[known][~sequence]
    median, high = np.quantile(late, [0.5, 0.95]).tolist() if len(late) else (np.nan, np.nan)
    return Errors(int(known.sum()), float(outcome.mean()), float(sequence.mean()), median, high)


def errors(
    shots: int, rates: Mapping[str, Mapping[str, float]], budget: float
) -> tuple[str, dict[str, dict[str, Errors]]]:
    """The judge, and the errors of hoopgen and each peer by workload: on its first `shots` shots,
    or as many of them as a peer flies in `budget` seconds; `rates` are its shots a second."""
    result: dict[str, dict[str, Errors]] = {}
    for workload in WORKLOADS:
        states = workload.make(shots)
        verdict = judge(states)
        result[workload.key] = {"hoopgen": compare(by_hoopgen(states), verdict)}
        for peer in PEERS:
            n = max(8, min(shots, int(budget * rates[workload.key][peer.key])))
            flown = peer.fly(states[:n], PAPER, MAX_CONTACTS, record=True)
            result[workload.key][peer.key] = compare(flown, verdict.cut(n))
    return verdict.judge, result
