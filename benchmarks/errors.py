"""How far each contender is from the right answer: outcome, sequence of contacts, time."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.peers import PEERS, Flown, Peer
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


def judge(states: States) -> tuple[Flown, NDArray[np.bool_]]:
    """The right answers, and which of the shots have one: hoopgen's, where it is certain."""
    shots = hoopgen.simulate(states, parameters=PAPER, max_contacts=MAX_CONTACTS, record=True)
    events = shots.events[np.isin(shots.events["surface"], range(len(hoopgen.SURFACES)))]
    first = np.searchsorted(events["shot"], events["shot"])
    surfaces = np.full((len(states), MAX_CONTACTS), -1, np.int8)
    surfaces[events["shot"], np.arange(len(events)) - first] = events["surface"]
    return Flown(shots.outcome, shots.contacts, shots.time, surfaces), ~shots.uncertain


def compare(flown: Flown, right: Flown, known: NDArray[np.bool_]) -> Errors:
    """Errors over the shots whose right answer is known."""
    outcome = (flown.outcome != right.outcome)[known]
    sequence = outcome | (flown.surfaces != right.surfaces).any(axis=1)[known]
    late = np.abs(flown.time - right.time)[known][~sequence]
    median, high = np.quantile(late, [0.5, 0.95]).tolist() if len(late) else (np.nan, np.nan)
    return Errors(int(known.sum()), float(outcome.mean()), float(sequence.mean()), median, high)


def errors(
    shots: int, rates: Mapping[str, Mapping[str, float]], budget: float
) -> dict[str, dict[str, Errors]]:
    """Errors of each peer on each workload's first `shots` shots, or as many of them as it flies in
    `budget` seconds; `rates` are its shots a second, by workload and peer."""

    def one(peer: Peer, states: States, right: Flown, known: NDArray[np.bool_], n: int) -> Errors:
        flown = peer.fly(states[:n], PAPER, MAX_CONTACTS, record=True)
        cut = Flown(right.outcome[:n], right.contacts[:n], right.time[:n], right.surfaces[:n])
        return compare(flown, cut, known[:n])

    result: dict[str, dict[str, Errors]] = {}
    for workload in WORKLOADS:
        states = workload.make(shots)
        right, known = judge(states)
        result[workload.key] = {
            peer.key: one(
                peer,
                states,
                right,
                known,
                max(8, min(shots, int(budget * rates[workload.key][peer.key]))),
            )
            for peer in PEERS
        }
    return result
