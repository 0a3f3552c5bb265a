"""When a ball is within a box: outside those windows there is no contact with what is in it.

The box is taken wider than what it holds by 2^-14 of its smallest half size. All that is not exact,
the errors of the state and the roundings here, stays below a quarter of that: else the search is
lost.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..ground.choice import (
    Choose,
    Either,
    IfAtMost,
    IfLess,
    Less,
    Nowhere,
    hold,
    largest,
    smallest,
)
from ..ground.rounding import extent, position_error, speed, velocity_error
from ..ground.symbols import t
from .events import Window, end, horizon

WIDER = sp.Rational(1, 2**14)
"""By how much, of the smallest half size."""

after = sp.Symbol("after", real=True)
"""A time up to which a search has come."""

Axis = tuple[sp.Expr, sp.Expr, sp.Expr]
"""Of a coordinate: where it is from the box's centre, its velocity and its acceleration."""


def opening(count: int) -> list[tuple[sp.Symbol, sp.Symbol]]:
    """Return the symbols of so many windows: when each opens and when it ends."""
    lows, highs = (sp.symbols(f"{name}:{count}", real=True) for name in ("low", "high"))
    return list(zip(lows, highs, strict=True))


def enter(
    found: Sequence[Window],
    since: sp.Expr = after,
    without: sp.Expr = t,
    stop: sp.Expr = end,
) -> dict[str, sp.Basic]:
    """Return the first window that ends later than a time, from then on.

    Parameters
    ----------
    found
        The windows, in order.
    since
        The time.
    without, stop
        The time where there is no such window, and its end.
    """
    start, opened = without, Nowhere()
    for low, high in reversed(found):
        begins = hold(largest(since, low))
        opens = Less(begins, high)
        start, stop = Choose(opens, begins, start), Choose(opens, high, stop)
        opened = Either(opened, opens)
    return {"t": start, "end": stop, "searching": opened}


def windows(axes: Sequence[Axis], halves: Sequence[sp.Expr | None]) -> list[Window]:
    """Return when all coordinates can be within the box; a half size that is None is endless."""
    known = [(axis, half) for axis, half in zip(axes, halves, strict=True) if half is not None]
    wider = WIDER * smallest(*(half for _, half in known))
    found: list[Window] = [(sp.Integer(0), sp.oo)]
    falling = False
    for axis, half in known:
        if axis[2] == 0:
            spans = [_straight(axis, hold(half + wider))]
        else:
            spans = _falling(axis, hold(half + wider))
            if falling:  # the windows of one such axis are enough: of the others, their hull
                spans = [(spans[0][0], spans[1][1])]
            falling = True
        found = [_meet(window, span) for span in spans for window in found]
    return found


def lost(
    centre: Sequence[sp.Expr], halves: Sequence[sp.Expr | None], acceleration: Sequence[sp.Expr]
) -> sp.Expr:
    """Positive where what is not exact comes near to what the box is wider by.

    Errors grow for ever where nothing ends the flight, but count only while the true ball may be in
    the box, until `left` at the latest.
    """
    known = [half for half in halves if half is not None]
    half, widest = smallest(*known), largest(*known)
    far = hold(extent + sp.Add(*map(sp.Abs, centre)) + widest)
    falls = [(a, h) for a, h in zip(acceleration, halves, strict=True) if a != 0]
    per_g = hold(1 / smallest(*(sp.Abs(a) for a, _ in falls)))
    latest: sp.Expr = horizon
    if all(h is not None for _, h in falls):
        latest = hold(smallest(horizon, left(hold(far + half), per_g)))
    moved = hold(position_error + velocity_error * latest)
    rounded = hold(far + speed**2 * per_g) * sp.Rational(1, 2**48)
    return hold(moved + rounded) - WIDER / 4 * half


def left(far: sp.Expr, per_g: sp.Expr) -> sp.Expr:
    """Return T = 2 v / g + sqrt(2 d / g): the ball has left the box for good, the true one too.

    Along an axis that the ball falls along let p be the computed place from the centre, |p| + h
    less than d by the smallest half size or more. Within the box

        f(t) = (p + h + e_p) + (v + e_v) t - g t²/2 >= 0

    for one sign of p, with errors of place and velocity that are not lost, e_p + e_v T <= w with w
    a tiny part of that half size. Then f(T) <= d - half + w - v sqrt(2 d / g) - d < 0, and f falls
    from T on: f'(T) = e_v - v - g sqrt(2 d / g), where e_v <= w / T < sqrt(2 d g).
    """
    return 2 * speed * per_g + sp.sqrt(2 * far * per_g)


def clear(found: Sequence[Window], lost: sp.Expr) -> sp.Expr:
    """Positive if none of the windows opens before the horizon, and they can be relied on."""
    verdict: sp.Expr = sp.Integer(1)
    for low, high in found:
        verdict = IfLess(hold(largest(0, low)), hold(smallest(horizon, high)), 0, verdict)
    return IfAtMost(lost, 0, verdict, 0)


def _straight(axis: Axis, half: sp.Expr) -> Window:
    """Return when |c + v t| <= h: as if it moved up; 0/0, on the edge for ever, limits nothing."""
    place, velocity, _ = axis
    size = sp.Abs(velocity)
    there = hold(IfLess(velocity, 0, -place, place))
    return (hold(-half - there) / size, hold(half - there) / size)


def _falling(axis: Axis, half: sp.Expr) -> list[Window]:
    """Return when |c + v t + a t²/2| <= h, rising and sinking as seen against the acceleration.

    With g = |a| the roots of c = h are (v ± sqrt(D)) / g with D = v² + 2 g (c - h).
    """
    place, velocity, acceleration = axis
    against = 1 if acceleration.is_negative else -1
    g = -against * acceleration
    place, up = against * place, against * velocity
    to_bottom = hold(up**2 + 2 * g * hold(place + half))
    to_top = hold(up**2 + 2 * g * hold(place - half))
    outer, inner = sp.sqrt(to_bottom), sp.sqrt(largest(to_top, 0))
    per_g = hold(1 / g)
    first = IfAtMost(0, to_bottom, hold(up - outer) * per_g, sp.oo)
    last = hold(IfAtMost(0, to_bottom, hold(up + outer) * per_g, -sp.oo))
    passed = IfLess(0, to_top, hold(up - inner) * per_g, last)
    again = IfLess(0, to_top, hold(up + inner) * per_g, sp.oo)
    return [(first, passed), (again, last)]


def _meet(left: Window, right: Window) -> Window:
    return largest(left[0], right[0]), smallest(left[1], right[1])
