"""Proof in balls that a ball has fallen through the ring (`derive/scenes/passage.py`)."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_poly

from hoopgen.derive.scenes.passage import FALLEN, NEITHER, RISEN

from .roots import sign
from .taylor_model import Number

Sizes = Sequence[arb]
"""Radius and depth of the passage, and gravity."""

MAX_DIVISIONS = 40
"""Divisions of a piece after which a passing is undecided."""

SPLIT_POINT = 0.48828125
"""Share of a part at which it is divided; passings of simple shots are elsewhere."""

Passing = tuple[bool | None, Number]
"""A passage of the plane: True if upwards, None if undecided, and its time."""


def at_start(sizes: Sizes, state: Sequence[Number], leaving: int) -> int | None:
    """Return the state of passage at the start, None if undecided; `leaving` as for `fly`.

    Parameters
    ----------
    sizes
        Radius and depth of the passage, and gravity.
    state
        The state, nine balls or models.
    leaving
        The body that the ball leaves, or -1.
    """
    radius, depth, _ = sizes
    height = state[2]
    if leaving < 0 or height >= 0 or height < -depth:
        return NEITHER
    within = _within(state[0], state[1], radius)
    if within is None:
        return None
    return FALLEN if within else NEITHER


def after(
    through: int, sizes: Sizes, start: Sequence[Number], end: Sequence[Number], time: Number
) -> int | None:
    """Return the state of passage after a flight from that before it, None if undecided.

    Nothing is asked of a ball that surely is outside the disc where it may pass its plane.

    Parameters
    ----------
    through
        The state of passage before the flight.
    sizes
        Radius and depth of the passage, and gravity.
    start, end
        The states at the flight's start and end, nine balls or models each.
    time
        The duration of the flight, s.
    """
    radius, _, gravity = sizes
    for place in (start, end):
        if _above(place[2]) is None and _within(place[0], place[1], radius) is not False:
            return None
    for upwards, when in _passings(gravity, start, end, time):
        within = _within(start[0] + start[3] * when, start[1] + start[4] * when, radius)
        if within is False:
            continue
        if within is None or upwards is None:
            return None
        through = _next_passage(through, upwards)
    return through


def after_piece(through: int, sizes: Sizes, path: Sequence[arb_poly], time: arb) -> int | None:
    """Return the state of passage after a piece of a flight, None if undecided.

    The piece is divided until in each part the ball is on one side of the plane, is outside the
    disc, or certainly moves one way within the disc.

    Parameters
    ----------
    through
        The state of passage before the piece.
    sizes
        Radius and depth of the passage, and gravity.
    path
        The polynomials of the position: at every time position and velocity are those of one of
        them.
    time
        How long the ball flies on it, s.
    """
    radius, _, _ = sizes
    heights = [path[2], path[2].derivative()]
    parts = [(arb(0), time, 0)]
    while parts:
        low, high, depth = parts.pop()
        during = low.union(high)
        if _above(heights[0](during)) is not None:
            continue
        within = _within(path[0](during), path[1](during), radius)
        if within is False:
            continue
        before, behind = (_above(heights[0](end)) for end in (low, high))
        one_way = sign(heights[1](during)) not in (None, 0)
        if within and one_way and before is not None and behind is not None:
            if before != behind:
                through = _next_passage(through, behind)
            continue
        if depth >= MAX_DIVISIONS:
            return None
        middle = low + (high - low) * SPLIT_POINT
        parts += [(middle, high, depth + 1), (low, middle, depth + 1)]
    return through


def _next_passage(through: int, upwards: bool) -> int:
    """Return the state of passage after a passing, from that before it."""
    if upwards:
        return NEITHER if through == FALLEN else RISEN
    return FALLEN if through == NEITHER else through


def _passings(
    gravity: arb, start: Sequence[Number], end: Sequence[Number], time: Number
) -> list[Passing]:
    """Return the passings of a flight, in order.

    On the plane itself is above it. What may be on either side is taken to be: a passing there is
    outside the disc.
    """
    before, behind = _above(start[2]) is not False, _above(end[2]) is not False
    up = start[5]
    squared = up * up + 2 * gravity * start[2]
    if before and behind:
        return []
    if not before and not behind:
        apex = up / gravity
        if apex < 0 or apex > time or squared < 0:
            return []
        if not (apex > 0 and apex < time and squared > 0):
            reach = (abs(squared).upper().sqrt() / gravity).upper()
            return [(None, apex + arb(0, reach))]
    root = squared.sqrt()
    rising: Passing = (True, (up - root) / gravity)
    falling: Passing = (False, (up + root) / gravity)
    return [rising] * (not before) + [falling] * (not behind)


def _above(height: Number) -> bool | None:
    side = sign(height)
    return None if side is None else side >= 0


def _within(x: Number, y: Number, radius: arb) -> bool | None:
    side = sign(radius * radius - x * x - y * y)
    return None if side is None else side > 0
