"""Balls that roll on the ring, held against a second formulation: `python -m benchmarks.rolling`.

Exit status 1 if a shot that is not flagged ends its contact otherwise, or is further off than the
engine claims.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from flint import arb
from hoopgen.generated.numpy.court import Event
from numpy.typing import NDArray

import hoopgen
from benchmarks.bounced import bounced
from benchmarks.ring_roll import BOARD, BRIDGE, END, LEAVES, RING, TIME, Floats, Roll, fall
from benchmarks.workloads import free_throw
from hoopgen import COURT, PAPER_COURT

NBA = PAPER_COURT | {name: value for name, value in hoopgen.NBA.items() if name in PAPER_COURT}


def elastic(restitution: float) -> Mapping[str, float]:
    """Return the sizes of the NBA's hoop, with perfect grip and one restitution."""
    return NBA | {f"{body}_restitution": restitution for body in COURT.surfaces}


@dataclass
class Found:
    """The results of a comparison of shots.

    `lodged` are those that end between two bodies, or at rest, which are always flagged. Of the
    other flagged ones `bouncing` are flagged before they begin to roll, and `rolling` from then on
    until their first contact has ended. `before`
    has what shots were off by at the last bounce, and what they claimed there: of position,
    velocity, spin and time. `ends` counts how contacts end; `errors` are the largest differences of
    time, position, velocity and spin (s, m, m/s, rad/s) where a shot is not flagged, and `ratios`
    their largest shares of what the engine claims; `wrong` are the shots that end otherwise, or are
    further off, with what is wrong.
    """

    shots: int = 0
    flagged: int = 0
    flagged_wrong: int = 0
    lodged: int = 0
    bouncing: int = 0
    rolling: int = 0
    before: list[tuple[Floats, Floats]] = field(default_factory=list)
    ends: dict[str, int] = field(default_factory=dict)
    errors: Floats = field(default_factory=lambda: np.zeros(4))
    ratios: Floats = field(default_factory=lambda: np.zeros(4))
    leaving: float = 0.0
    wrong: list[tuple[str, list[str]]] = field(default_factory=list)

    def bounced(self) -> tuple[float, float, float]:
        """Return the median error of the position when a ball begins to roll, m, and its shares.

        Of what the shot claims then: the median, and the largest, of time and motion too.
        """
        off, known = (np.array(part) for part in zip(*self.before, strict=True))
        shares = np.divide(off, known, out=np.zeros_like(off), where=off > 0)
        return float(np.median(off[:, 0])), float(np.median(shares[:, 0])), float(shares.max())


NAMES = {LEAVES: "leaves", END: "end plane", BOARD: "board", BRIDGE: "bridge", TIME: "time limit"}


def compare(
    states: Floats, scene: Mapping[str, float], time_limit: float, most: int, found: Found
) -> None:
    """Roll the shots that settle on the ring a second time, until `most` are compared in all."""
    shots = hoopgen.simulate(
        states,
        scene,
        scene=COURT,
        time_limit=time_limit,
        record=True,
        fields=tuple(COURT.layout.results),
    )
    log = shots.events
    for row in np.flatnonzero((log["kind"] == Event.ROLL) & (log["surface"] == RING)):
        shot = int(log["shot"][row])
        first = np.searchsorted(log["shot"], shot)
        if np.any(log["kind"][first:row] == Event.ROLL) or found.shots == most:
            continue
        found.shots += 1
        rest = log[row : np.searchsorted(log["shot"], shot, side="right")]
        what, errors, claimed, late = _again(shots, shot, rest, states[shot], scene, time_limit)
        flagged = bool(shots.uncertain[shot])
        found.flagged += flagged
        lodged = shots.outcome[shot] == COURT.outcomes["LODGED"]
        found.lodged += lodged
        off, known, early = _bounced(states[shot], log[first:row], scene)
        found.bouncing += early and not lodged
        if flagged and not early and not lodged:
            found.rolling += _flagged_by(float(rest[1]["time"]), states[shot], scene, time_limit)
        found.before.append((off, known))
        bad = [what] if what else []
        if np.any(off > known):
            bad.append("further off than claimed when it begins to roll")
        if not flagged and not bad:
            ratios = np.divide(errors, claimed, out=np.zeros(4), where=errors > 0)
            found.errors = np.maximum(found.errors, errors)
            found.ratios = np.maximum(found.ratios, ratios)
            found.leaving = max(found.leaving, late)
            bad = ["further off than claimed"] if np.any(ratios > 1) else []
        if flagged:
            found.flagged_wrong += bool(bad)
        elif bad:
            found.wrong.append((bad[0], [float(part).hex() for part in states[shot]]))
        name = NAMES[_ended(rest, shots.outcome[shot])]
        found.ends[name] = found.ends.get(name, 0) + 1


def _flagged_by(
    over: float, release: Floats, scene: Mapping[str, float], time_limit: float
) -> bool:
    """Return whether a shot is flagged by the time its contact has ended."""
    limit = min(over + 1e-6, time_limit)
    shots = hoopgen.simulate(release, scene, scene=COURT, time_limit=limit, fields=("uncertain",))
    return bool(shots.uncertain[0])


def _bounced(
    release: Floats, impacts: Any, scene: Mapping[str, float]
) -> tuple[Floats, Floats, bool]:
    """Return the engine's error after the last bounce, and the bound that it claims there.

    Of position, velocity, spin and time; and whether it is flagged by then.
    """
    off, late = bounced(release, impacts, scene, scene["ring_restitution"])
    there = hoopgen.simulate(
        release,
        scene,
        scene=COURT,
        time_limit=60.0,
        max_contacts=len(impacts),
        fields=("time_error", "state_error", "uncertain"),
    )
    known = np.array([*there.state_error[0], there.time_error[0]])
    return np.array([*off, late]), known, bool(there.uncertain[0])


def _ended(rest: NDArray[Any], outcome: int) -> int:
    """Return the event with which contact ends in the engine's log."""
    after = rest[1]
    if after["kind"] == Event.LEAVE:
        return LEAVES
    if after["kind"] == Event.END and outcome == COURT.outcomes["ENDLESS"]:
        return TIME
    return int(after["surface"])


def _again(
    shots: hoopgen.Shots,
    shot: int,
    rest: NDArray[Any],
    release: Floats,
    scene: Mapping[str, float],
    time_limit: float,
) -> tuple[str, Floats, Floats, float]:
    """Roll one shot; return what differs, its errors, the claimed ones, and that of the leaving."""
    expected = _ended(rest, shots.outcome[shot])
    begun, over = rest[0], float(rest[1]["time"])
    roll = Roll(begun["after"], scene, float(begun["time"]))
    # One that rolls for ever ends where that is certain.
    limit = over if expected == TIME else min(over + 1e-3, time_limit)
    what, when = roll.until(limit)
    if what != expected:
        return f"{NAMES[what]}, not {NAMES[expected]}", np.zeros(4), np.zeros(4), 0.0
    late = abs(float(when - arb(over)))
    state = roll.state()
    ended = rest[1]
    if expected == LEAVES and len(rest) == 3:
        flown, state = fall(state, scene)
        when, ended = when + flown, rest[2]
    elif expected in (LEAVES, BOARD, BRIDGE):
        return "", *_before(over, begun, release, scene), late
    inside = float(state[0] ** 2 + state[1] ** 2) < scene["ring_radius"] ** 2
    if expected != TIME and inside != bool(shots.made[shot]):
        return "made or missed", np.zeros(4), np.zeros(4), 0.0
    errors = _errors(state, when, ended["after"], float(ended["time"]))
    claimed = np.array([shots.time_error[shot], *shots.state_error[shot]])
    return "", errors, claimed, late


def _before(
    over: float, begun: Any, release: Floats, scene: Mapping[str, float]
) -> tuple[Floats, Floats]:
    """Compare a moment before the contact ends, where more follows than a flight to the end."""
    limit = over - min(1e-9, (over - float(begun["time"])) / 2)
    stopped = hoopgen.simulate(
        release, scene, scene=COURT, time_limit=limit, fields=tuple(COURT.layout.results)
    )
    roll = Roll(begun["after"], scene, float(begun["time"]))
    _, when = roll.until(limit)
    errors = _errors(roll.state(), when, stopped.state[0], float(stopped.time[0]))
    return errors, np.array([stopped.time_error[0], *stopped.state_error[0]])


def _errors(state: list[arb], when: arb, there: Floats, time: float) -> Floats:
    off = [abs(float(own - arb(float(other)))) for own, other in zip(state, there, strict=True)]
    return np.array([abs(float(when - arb(time))), *(max(off[k : k + 3]) for k in (0, 3, 6))])


@dataclass(frozen=True)
class Bounce:
    """A bounce of a sequence that settles, and rolling from it.

    Its speed V off the ring, m/s; how far the ball that rolls from it is from the limit of the
    sequence, by V², s²/m; and the same by 2 F V²/(N² (1 - e²)), which it tends to.
    """

    speed: float
    by_square: float
    by_limit: float


def bounces(states: Floats, restitution: float) -> Iterator[Bounce]:
    """Roll from every bounce of the sequences that settle on the ring."""
    scene = elastic(restitution)
    shots = hoopgen.simulate(states, scene, scene=COURT, time_limit=3.0, record=True)
    log = shots.events
    for row in np.flatnonzero((log["kind"] == Event.ROLL) & (log["surface"] == RING)):
        limit, time = log["after"][row], float(log["time"][row])
        place = row - 1
        while place > 0 and _same_sequence(log[place], log[row]):
            one = _bounce(log[place], limit, time, scene, restitution)
            place -= 1
            if one is not None:
                yield one


def _same_sequence(impact: Any, roll: Any) -> bool:
    return bool(
        impact["shot"] == roll["shot"]
        and impact["kind"] == Event.IMPACT
        and impact["surface"] == RING
    )


def _bounce(
    impact: Any, limit: Floats, time: float, scene: Mapping[str, float], restitution: float
) -> Bounce | None:
    after = impact["after"]
    rho = np.hypot(after[0], after[1])
    normal = np.array([*(after[:2] * (1 - scene["ring_radius"] / rho)), after[2]])
    normal /= np.linalg.norm(normal)
    speed = float(after[3:6] @ normal)
    if not 1e-4 < speed < 0.1:
        return None
    roll = Roll(after, scene, float(impact["time"]))
    what, _ = roll.until(time)
    if what != TIME:
        return None
    off = np.array([float(own - arb(float(x))) for own, x in zip(roll.state(), limit, strict=True)])
    force, friction = _forces(limit, scene)
    by_square = float(np.linalg.norm(off[:3])) / speed**2
    return Bounce(speed, by_square, by_square * force**2 * (1 - restitution**2) / (2 * friction))


def _forces(state: Floats, scene: Mapping[str, float]) -> tuple[float, float]:
    """Return normal force and friction of a ball that rolls on the ring, per unit mass."""
    place, v, w = state.reshape(3, 3)
    rho = np.hypot(place[0], place[1])
    e = np.array([place[0] / rho, place[1] / rho, 0.0])
    over = np.array([-e[1], e[0], 0.0])
    n = place - scene["ring_radius"] * e
    n /= np.linalg.norm(n)
    reach = scene["ball_radius"] + scene["wire_radius"]
    turning = (v - scene["ring_radius"] * (v @ over / rho) * over) / reach
    up = np.array([0.0, 0.0, scene["gravity"]])
    pushed = up + scene["ball_radius"] * np.cross(w, turning)
    friction = 2 / 5 * (pushed - pushed @ n * n)
    return float(up @ n - v @ turning), float(np.linalg.norm(friction))


KINDS = ((0.7, 1 << 19), (0.5, 1 << 16), (0.3, 1 << 16))
"""Restitutions, and how many free throws there are of each at most."""
CHUNK = 1 << 13


def settled(shots: int) -> Found:
    """Compare so many free throws that settle, a third of each restitution if there are as many."""
    found = Found()
    for k, (restitution, throws) in enumerate(KINDS):
        most = -(-shots * (k + 1) // len(KINDS))
        states = free_throw(throws)
        for low in range(0, throws, CHUNK):
            if found.shots < most:
                compare(states[low : low + CHUNK], elastic(restitution), 6.0, most, found)
    return found


def main() -> None:
    """Compare, and say what was found."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.rolling",
        description="Rolling on the ring, held against a second formulation with 110 bits.",
    )
    parser.add_argument("--shots", type=int, default=2_000, help="that settle, default 2,000")
    found = settled(parser.parse_args().shots)
    for name, value in vars(found).items():
        print(f"{name}: {found.bounced() if name == 'before' else value}")
    sys.exit(bool(found.wrong))


if __name__ == "__main__":
    main()
