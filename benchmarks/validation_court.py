"""Shots of the hoop that change on the whole hoop with the article's law, with the causes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.report import table
from benchmarks.workloads import SEED, States, free_throw, swirl
from hoopgen import COURT, HOOP, PAPER, PAPER_COURT, Event, Outcome
from hoopgen.text.numbers import format_percent

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

SHOTS = 50_000

RING, BOARD, BRIDGE = range(3)

REASONS = {
    "edge": "touches an edge or a corner of the board",
    "board": "touches the board's back, top, side or underside",
    "front": "touches the bridge's edge above the ring, or its end below",
    "bridge": "touches the bridge's sides or underside, or an edge of them",
    "round": "lands beside the wire, where only the bridge of `HOOP` extends",
    "rose": "has the same contacts, but had come up through the ring",
    "starts": "starts in a body that only `COURT` has",
    "rolls": "rolls in `COURT` and bounces on in `HOOP`",
    "ends": "ends in `COURT` and is capped in `HOOP`",
    "uncertain": "is uncertain in one of the scenes",
}
"""Why a shot changes: the first of these that happens to it."""


def _scattered(mean: tuple[float, ...], apart: tuple[float, ...]) -> Callable[[int], States]:
    """Return a function that draws shots with normal errors about a release."""

    def make(n: int) -> States:
        random = np.random.Generator(np.random.Philox(SEED))
        return np.array(mean) + np.array(apart) * random.normal(size=(n, 9))

    return make


KINDS: Mapping[str, Callable[[int], States]] = {
    "free throws": free_throw,
    "bank shots, 45°": _scattered(
        (2.1, 2.1, -0.85, -3.2, -2.4, 5.6, 3, 4, 0), (0, 0, 0, 0.1, 0.1, 0.1, 3, 3, 3)
    ),
    "swirls": swirl,
    "tips from beside": _scattered(
        (0.2, 0.7, 0.1, -0.7, -1.2, 2.0, 0, 0, 0), (0.2, 0.2, 0.2, 0.4, 0.4, 0.5, 9, 9, 9)
    ),
    "from below the ring": _scattered(
        (-0.1, 0, -0.6, 0, 0, 4, 0, 0, 0), (0.3, 0.3, 0.15, 0.5, 0.5, 0.7, 9, 9, 9)
    ),
}
"""Shots about a player's, and such as no player throws."""


@dataclass(frozen=True)
class Changes:
    """The changes of shots of a kind: their number, their causes, and their sources."""

    shots: int
    changed: int
    reasons: Mapping[str, int]
    hoop: int
    court: int


def changes(states: States) -> Changes:
    """Fly shots in both scenes and look where they differ in the bodies touched or in the end."""
    hoop = hoopgen.simulate(states, PAPER, record=True)
    court = hoopgen.simulate(states, PAPER_COURT, scene=COURT, record=True)
    differs = (hoop.outcome != court.outcome) | ~_same_bodies(hoop, court)
    found = _first_reasons(hoop, court)
    reasons = {
        name: int(np.count_nonzero(differs & (found == place)))
        for place, name in enumerate(REASONS)
    }
    made = (int(np.count_nonzero(shots.outcome == Outcome.MADE)) for shots in (hoop, court))
    return Changes(len(states), int(np.count_nonzero(differs)), reasons, *made)


def _same_bodies(one: hoopgen.Shots, other: hoopgen.Shots) -> Flags:
    """Return a mask of the shots that touch the same surfaces in the same order in both."""
    counts = [np.bincount(s.events["shot"], minlength=len(s)) for s in (one, other)]
    same = counts[0] == counts[1]
    left, right = (s.events[same[s.events["shot"]]] for s in (one, other))
    same[left["shot"][left["surface"] != right["surface"]]] = False
    return np.asarray(same, np.bool_)


def _first_reasons(hoop: hoopgen.Shots, court: hoopgen.Shots) -> NDArray[np.int64]:
    """Return the place in `REASONS` of each shot's reason; none: their number."""
    places = {name: k for k, name in enumerate(REASONS)}
    reason = np.full(len(hoop), len(REASONS))
    # The last reasons first: others take their place.
    reason[hoop.uncertain | court.uncertain] = places["uncertain"]
    given_up = (hoop.outcome == Outcome.CAPPED) & (court.outcome != Outcome.CAPPED)
    reason[given_up] = places["ends"]
    invalid = (court.outcome == Outcome.INVALID) & (hoop.outcome != Outcome.INVALID)
    reason[invalid] = places["starts"]
    reason[(hoop.outcome == Outcome.MADE) & (court.outcome == Outcome.MISSED)] = places["rose"]
    when = np.full(len(hoop), np.inf)
    p = PAPER_COURT
    there = hoop.events["before"]
    beside = (hoop.events["surface"] == BRIDGE) & (there[:, 0] > -p["ring_radius"])
    rows = [(hoop.events, beside, np.full(len(beside), places["round"]))]
    rows.append((court.events, *_parts(court.events, places)))
    rolls = court.events["kind"] == Event.ROLL
    rows.append((court.events, rolls, np.full(len(rolls), places["rolls"])))
    for events, own, why in rows:
        for row in np.flatnonzero(own):
            shot = events["shot"][row]
            if events["time"][row] < when[shot]:
                when[shot], reason[shot] = events["time"][row], why[row]
    return reason


def _parts(events: NDArray[np.void], places: Mapping[str, int]) -> tuple[Flags, NDArray[np.int64]]:
    """Return which contacts are with what the hoop has not, and with what of it."""
    p = PAPER_COURT
    front, x = -p["board_distance"], events["before"][:, 0]
    y, z = np.abs(events["before"][:, 1]), events["before"][:, 2]
    board, bridge = events["surface"] == BOARD, events["surface"] == BRIDGE
    level = (z >= p["board_bottom"]) & (z <= p["board_top"])
    plain_front = board & (x > front) & level & (y <= p["board_half_width"])
    deep = x < front - p["board_thickness"]
    beyond = [(x > front) | deep, ~level, y > p["board_half_width"]]
    edge = board & (np.sum(beyond, axis=0) > 1)
    above = z > p["wire_radius"]
    width = y <= p["bridge_half_width"]
    plain_top = bridge & above & width & (x <= -p["ring_radius"])
    ahead = bridge & (x > -p["ring_radius"]) & width & (z > p["wire_radius"] - p["bridge_depth"])
    why = np.select(
        [edge, board, ahead, bridge],
        [places[name] for name in ("edge", "board", "front", "bridge")],
        default=len(REASONS),
    )
    return (board & ~plain_front) | (bridge & ~plain_top), why


def section(shots: int = SHOTS) -> list[str]:
    """Return the section of the page."""
    found = {kind: changes(make(shots)) for kind, make in KINDS.items()}
    rows = [
        ["change", *(_of(one.changed, one) for one in found.values())],
        *(
            [said, *(_of(one.reasons[name], one) for one in found.values())]
            for name, said in REASONS.items()
            if any(one.reasons[name] for one in found.values())
        ),
        ["made, `HOOP`", *(format_percent(one.hoop / one.shots) for one in found.values())],
        ["made, `COURT`", *(format_percent(one.court / one.shots) for one in found.values())],
    ]
    return [
        "## The whole hoop: `HOOP` beside `COURT`",
        "",
        "`COURT` contains parts that the article leaves out: the board's edges, top, sides and "
        "back, and the bridge's sides and underside. A ball that comes up through the ring is "
        "not made, whatever it does afterwards. The preset `PAPER_COURT` has the article's "
        f"contact law. Both scenes use their default `max_contacts`, {HOOP.max_contacts} and "
        f"{COURT.max_contacts:,}. The table counts, among {shots:,} shots of each kind, those "
        "that touch other bodies or end otherwise in `COURT`. The reason is the first thing "
        "that happens in `COURT` and not in `HOOP`. The last two kinds are not a player's "
        "shots: balls tipped from beside the ring, and balls thrown up from below it.",
        "",
        *table(["", *found], rows),
    ]


def _of(count: int, one: Changes) -> str:
    return f"{count:,} ({format_percent(count / one.shots, 2)})" if count else "0"
