"""Grazes: shots whose first contact, or none, is decided by a gap of 1e-9 m or less, and what each
way to fly them makes of it (`python -m benchmarks --only grazes`).

Each is built backwards from its gap, as the families are: a state there is flown back to a release,
and kept if nothing else is met on the way. The gap is of either sign: negative, the ball touches.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.families import REACH, RING, TURN, Floats, back, seeded, spins, tiny, tube
from benchmarks.peers import PEERS, Peer
from benchmarks.workloads import States
from hoopgen import PAPER
from hoopgen.core.backend_names import BackendName
from hoopgen.judge import certify

Bools = NDArray[np.bool_]
Places = tuple[Floats, Floats]
"""Places of the ball at its graze, and its velocities, both (n, 3)."""

BANDS = ((1e-13, 1e-9), (1e-16, 1e-13))
"""Ranges of the gap's size (m), spread evenly over the orders of magnitude. In the second it
comes down to the last bits of the releases."""

WINDOW = 5e-4
"""A contact so near to the graze in time is the graze's (s): five of the fixed time steps."""

FRONT = PAPER["ball_radius"] - PAPER["board_distance"]
WIDE = PAPER["bridge_half_width"]


def _wire(random: np.random.Generator, gap: Floats) -> Places:
    """Along the ring's wire, over it, outside or inside; the least distance is the gap. Those for
    which it is the greatest instead, since the path is bent towards the wire, come out as NaN."""
    n = len(gap)
    position, normal, along, across = tube(random, n, 0, np.pi)
    heading = random.uniform(0, TURN, n)
    speed = random.uniform(1, 6, n)
    around, over = speed * np.cos(heading), speed * np.sin(heading)
    out = np.hypot(position[:, 0], position[:, 1])
    rises = (out - RING) / REACH
    away = over**2 / REACH + around**2 * rises / out - PAPER["gravity"] * normal[:, 2]
    position = np.where(away[:, None] > 5, position + gap[:, None] * normal, np.nan)
    return position, around[:, None] * along + over[:, None] * across


def _board(edge: str, random: np.random.Generator, gap: Floats) -> Places:
    """Through the plane of the backboard's front, the gap beyond its edge."""
    n = len(gap)
    side = random.choice([-1.0, 1.0], n)
    half, bottom, top = (PAPER[f"board_{name}"] for name in ("half_width", "bottom", "top"))
    y, z = side * random.uniform(0.5, 0.9, n), random.uniform(0.2, 0.9, n)
    velocity = random.normal(0, 1, (n, 3))
    velocity[:, 0] = -random.uniform(0.5, 6, n)
    if edge == "side":
        y = side * (half + gap)
    elif edge == "top":
        z = top + gap
    else:
        z = bottom - gap
        velocity[:, 2] = random.uniform(0.5, 4, n)  # a fall so deep has ended before
    return np.stack([np.full(n, FRONT), y, z], axis=1), velocity


def _beside_the_bridge(random: np.random.Generator, n: int, y: Floats) -> tuple[Floats, Floats]:
    """Places along the bridge's sides, and which side."""
    side = random.choice([-1.0, 1.0], n)
    x = random.uniform(FRONT + 5e-3, -np.sqrt(RING**2 - WIDE**2) - 5e-3, n)
    return np.stack([x, side * y, np.full(n, REACH)], axis=1), side


def _bridge_side(random: np.random.Generator, gap: Floats) -> Places:
    """Down through the plane of the bridge, the gap beyond its side."""
    n = len(gap)
    position, _ = _beside_the_bridge(random, n, WIDE + gap)
    velocity = random.normal(0, 1, (n, 3))
    velocity[:, 2] = -random.uniform(1, 5, n)
    return position, velocity


def _bridge_top(random: np.random.Generator, gap: Floats) -> Places:
    """Return grazes over the bridge's side, at the flight's highest point: the gap below its
    plane, or above it, and then the ball comes down on it."""
    n = len(gap)
    position, side = _beside_the_bridge(random, n, np.full(n, WIDE - 1e-4))
    position[:, 2] -= gap
    velocity = np.zeros((n, 3))
    velocity[:, 0] = random.normal(0, 0.3, n)
    velocity[:, 1] = -side * random.uniform(1, 3, n)
    return position, velocity


@dataclass(frozen=True)
class Kind:
    """A way to graze: the surface; the parameter that moves it, and whether towards the ball as it
    grows (1) or away (-1)."""

    key: str
    label: str
    surface: int
    parameter: str
    towards: int
    places: Callable[[np.random.Generator, Floats], Places]


KINDS = (
    Kind("wire", "along the ring's wire", 0, "wire_radius", 1, _wire),
    Kind("side", "board, side", 1, "board_half_width", 1, partial(_board, "side")),
    Kind("top", "board, top", 1, "board_top", 1, partial(_board, "top")),
    Kind("bottom", "board, bottom", 1, "board_bottom", -1, partial(_board, "bottom")),
    Kind("bridge", "bridge, side", 2, "bridge_half_width", 1, _bridge_side),
    Kind("apex", "bridge, from below", 2, "wire_radius", -1, _bridge_top),
)


@dataclass(frozen=True)
class Grazes:
    """n shots: releases (n, 9), the gap (m) and when it is met (s)."""

    states: States
    gap: Floats
    time: Floats

    def __len__(self) -> int:
        return len(self.gap)


def _draw(kind: Kind, random: np.random.Generator, n: int) -> Grazes:
    least, most = np.log10([BANDS[-1][0], BANDS[0][1]])
    gap = tiny(random, n, least, most)
    position, velocity = kind.places(random, gap)
    time = random.uniform(0.02, 0.12, n)
    return Grazes(back(position, velocity, spins(random, n), time), gap, time)


def _undisturbed(grazes: Grazes) -> Bools:
    """Return a mask of the balls that meet nothing before the graze, by 400 points of each path."""
    steps = np.linspace(0, 1, 401)[1:, None]
    time = grazes.time - (grazes.time - 1e-4) * steps**2 - 1e-4
    x, y, z, vx, vy, vz = grazes.states[:, :6].T
    x, y, z = x + vx * time, y + vy * time, z + vz * time - PAPER["gravity"] / 2 * time**2
    ring = np.hypot(np.hypot(x, y) - RING, z) > REACH
    bridge = (z > REACH) | (np.abs(y) > WIDE) | (x > 0)
    return np.asarray((ring & bridge & (x > FRONT)).all(axis=0))


def graze(kind: Kind, n: int) -> Grazes:
    """Return n shots of a kind, the same whenever they are asked for."""
    random = seeded(f"graze {kind.key}")

    def kept() -> Iterator[Grazes]:
        found = 0
        while found < n:
            drawn = _draw(kind, random, n)
            free = _undisturbed(drawn)
            found += int(free.sum())
            yield Grazes(drawn.states[free], drawn.gap[free], drawn.time[free])

    parts = list(kept())
    columns = ([getattr(part, name) for part in parts] for name in ("states", "gap", "time"))
    return Grazes(*(np.concatenate(column)[:n] for column in columns))


@dataclass(frozen=True)
class Seen:
    """A contender's verdicts on grazes: whether the ball touches, and whether that is undecided,
    both (n,)."""

    touches: Bools
    uncertain: Bools


Look = Callable[[Kind, Grazes], Seen]


def _touching(kind: Kind, grazes: Grazes, first: NDArray[np.int8], time: Floats) -> Bools:
    return np.asarray((first == kind.surface) & (np.abs(time - grazes.time) < WINDOW))


def judged(kind: Kind, grazes: Grazes, parameters: Mapping[str, Any] = PAPER) -> Seen:
    """Return the proved contacts; those that the judge cannot decide are uncertain."""
    proved = certify(grazes.states, parameters, max_contacts=1)
    time = np.where(proved.decided, proved.time, np.inf)
    return Seen(_touching(kind, grazes, proved.first, time), ~proved.decided)


def _by_hoopgen(backend: BackendName) -> Look:
    def look(kind: Kind, grazes: Grazes) -> Seen:
        shots = hoopgen.simulate(grazes.states, PAPER, max_contacts=1, backend=backend)
        return Seen(_touching(kind, grazes, shots.first, shots.time), shots.uncertain)

    return look


def _by_peer(peer: Peer) -> Look:
    def look(kind: Kind, grazes: Grazes) -> Seen:
        flown = peer.fly(grazes.states, PAPER, 1, record=True)
        touches = _touching(kind, grazes, flown.surfaces[:, 0], flown.time)
        return Seen(touches, np.zeros(len(grazes), np.bool_))

    return look


OURS = {"hoopgen C": _by_hoopgen("c"), "hoopgen NumPy": _by_hoopgen("numpy")}
FIELD: dict[str, Look] = {**OURS, **{peer.label: _by_peer(peer) for peer in PEERS}}
"""The contenders: hoopgen is uncertain where a shot is `uncertain`, the peers never."""


@dataclass(frozen=True)
class Tally:
    """Somebody's grazes of a kind and band, of which the judge has proved `touching` and `passing`
    and could not decide `undecided`. `missed` and `invented` contacts are those that are not
    uncertain; `wrong_uncertain` counts the others."""

    who: str
    kind: str
    band: int
    touching: int
    passing: int
    undecided: int
    missed: int
    invented: int
    uncertain: int
    wrong_uncertain: int


def _tally(who: str, kind: Kind, band: int, within: Bools, right: Seen, seen: Seen) -> Tally:
    known = within & ~right.uncertain
    wrong, sure = known & (seen.touches != right.touches), ~seen.uncertain
    columns = {
        "touching": known & right.touches,
        "passing": known & ~right.touches,
        "undecided": within & right.uncertain,
        "missed": wrong & sure & right.touches,
        "invented": wrong & sure & ~right.touches,
        "uncertain": within & seen.uncertain,
        "wrong_uncertain": wrong & seen.uncertain,
    }
    return Tally(who, kind.key, band, **{name: int(one.sum()) for name, one in columns.items()})


def tallies(n: int, field: Mapping[str, Look] = FIELD) -> list[Tally]:
    """Return the results of all contenders on n grazes of each kind."""
    found = []
    for kind in KINDS:
        grazes = graze(kind, n)
        right = judged(kind, grazes)
        size = np.abs(grazes.gap)
        for who, look in field.items():
            seen = look(kind, grazes)
            for band, (least, most) in enumerate(BANDS):
                within = (size >= least) & (size < most)
                found.append(_tally(who, kind, band, within, right, seen))
    return found
