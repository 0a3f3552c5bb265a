"""The windows of a box: the times at which a ball is in it; outside of them it touches nothing.

The box is inflated by 2^-14 of its smallest half size. The errors of the state and the roundings
here together stay below a quarter of that; otherwise the search is lost.

**Lemma (windows of a box).** Let `lost` be at most zero, and gravity be along an axis and of a
known sign. If the true ball is in the box, |x_k - c_k| <= h_k along each axis, at a time t up to
the horizon, then t is in a window as computed, and on neither edge of it but 0 and the horizon.

*Proof.* Let w be 2^-14 of the smallest half size, d = |x| + |c| + the largest half size, and
η = 2^-48 (d + |v|²/g). By `time_to_leave` t is no later than the time T in `lost`, until which a
coordinate of the true ball is off the one of the computed state, without roundings, by at most
p + v T <= w/4 - η. So the latter is within h + w/4 - η at t. It remains to show that at each edge
of a window, as computed, it is further from the centre than h + w/2 - η, on the way out or in; then
no window ends before t or begins after it. Exactly, it is at h + w there. Let P = |x_k - c_k| + h +
w < 1.001 d.

- *Places.* The difference, c, a mean of two corners, and h + w are off by 5 u d in all if corners
  are inputs; by 2 u d more if one is the sum of the other and the width. Corners that are other
  formulas have roundings of their own, which may be as large as w/2.
- *Without acceleration* a time has two roundings more, in which the ball flies 2 u P.
- *Along gravity*, at the time (v ± s)/g, the ball is (v² - s²)/(2 g) above its start: s² = D that
  is off by δ moves it by δ/(2 g). D is off by 2 u v² + 6 u g P, and its root by u, as of 2 u D:
  together a displacement of u (2 v²/g + 5 P). The sum, 1/g and the product make the time off by 3 u
  of itself, in which the ball, with the speed s, flies 3 u s (|v| + s)/g <= u (6 v²/g + 9 P).

These are less than 8 u v²/g + 22 u d < η. If D < 0 as computed at the bottom, the ball never comes
above it by more than η; and if D <= 0 at the top, one window reaches over the apex, where the ball
is above the top by less than η. Windows are cut off at zero and at the horizon, which are exact. ∎

By the same displacements the ball is within h + w + η along each axis throughout a window. Scenes
in which gravity may be zero have no proved bounds, so that the lemma says nothing of
`_perhaps_falling`.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..motion.flight import divisor, has_sign
from ..symbolic.conditionals import (
    AtMost,
    Choose,
    IfAtMost,
    IfLess,
    Less,
    Or,
    absolute,
    all_of,
    barrier,
    false,
    maximum,
    minimum,
)
from ..symbolic.rounding import extent, position_error, speed, velocity_error
from ..symbolic.symbols import VELOCITY, t
from .event_polynomials import Window, end, horizon, intersection

RELATIVE_INFLATION = sp.Rational(1, 2**14)
"""Inflation of the box, relative to its smallest half size."""

after = sp.Symbol("after", real=True)
"""Time up to which a search has come."""

Axis = tuple[sp.Expr, sp.Expr, sp.Expr]
"""A coordinate relative to the box's centre, its velocity and its acceleration."""


def opening(count: int) -> list[tuple[sp.Symbol, sp.Symbol]]:
    """Return the symbols of so many windows: begin and end of each."""
    lows, highs = (sp.symbols(f"{name}:{count}", real=True) for name in ("low", "high"))
    return list(zip(lows, highs, strict=True))


def enter(
    found: Sequence[Window],
    since: sp.Expr = after,
    without: sp.Expr = t,
    stop: sp.Expr = end,
) -> dict[str, sp.Basic]:
    """Return the first window that ends later than a time, cut off at that time.

    Parameters
    ----------
    found
        The windows, in order.
    since
        The time.
    without, stop
        Begin and end to return if there is no such window.
    """
    start, opened = without, false
    for low, high in reversed(found):
        begins = barrier(maximum(since, low))
        opens = Less(begins, high)
        start, stop = Choose(opens, begins, start), Choose(opens, high, stop)
        opened = Or(opened, opens)
    return {"t": start, "end": stop, "searching": opened}


def windows(axes: Sequence[Axis], halves: Sequence[sp.Expr | None]) -> list[Window]:
    """Return the times at which all coordinates are in the box; a half size None is infinite.

    Windows are in order of time, so far as they are not empty: if the first interval of one axis
    meets the second one of another, their other two intervals do not meet. Two intervals of an axis
    are not joined, since bounds on F'' hold only within the box.

    Parameters
    ----------
    axes
        For each coordinate its place relative to the box's centre, velocity and acceleration.
    halves
        Half the size of the box along each coordinate; None is infinite.

    Returns
    -------
    list of Window
        Begin and end of each window, s; two for each falling coordinate.
    """
    known = [(axis, half) for axis, half in zip(axes, halves, strict=True) if half is not None]
    wider = RELATIVE_INFLATION * minimum(*(half for _, half in known))
    found: list[Window] = [(sp.Integer(0), sp.oo)]
    for axis, half in known:
        if axis[2] == 0:
            spans = [_straight(axis, barrier(half + wider))]
        else:
            fall = _falling if has_sign(axis[2]) else _perhaps_falling
            spans = fall(axis, barrier(half + wider))
        found = [intersection(window, span) for span in spans for window in found]
    return found


def lost(
    centre: Sequence[sp.Expr], halves: Sequence[sp.Expr | None], acceleration: Sequence[sp.Expr]
) -> sp.Expr:
    """Return a quantity that is positive if errors come near to the inflation of the box.

    Without an event errors grow for ever, but they count only while the true ball may be in the
    box, until `time_to_leave` at the latest.

    Parameters
    ----------
    centre
        The centre of the box, (3,), m.
    halves
        Half the size of the box along each coordinate; None is infinite.
    acceleration
        That of the free ball, (3,), m/s²; components may be 0.

    Returns
    -------
    Expr
        A length; if it is positive the windows are unreliable.
    """
    known = [half for half in halves if half is not None]
    half, widest = minimum(*known), maximum(*known)
    far = barrier(extent + sp.Add(*map(sp.Abs, centre)) + widest)
    latest = _latest(far, half, halves, acceleration)
    flown = _flown(latest, halves, acceleration)
    moved = barrier(position_error + velocity_error * latest)
    rounded = barrier(far + flown) * sp.Rational(1, 2**48)
    return barrier(moved + rounded) - RELATIVE_INFLATION / 4 * half


def exit_time(
    centre: Sequence[sp.Expr], distance: sp.Expr, acceleration: Sequence[sp.Expr]
) -> tuple[sp.Expr, sp.Expr]:
    """Return a time after which the ball, and the true one, is further off than a distance.

    By then both have left the cube about the centre for good.

    Parameters
    ----------
    centre
        The point from which the distance counts, (3,), m.
    distance
        The distance, m.
    acceleration
        That of the free ball, (3,), m/s²; components may be 0.

    Returns
    -------
    tuple of Expr
        The time, s, or the horizon if that is first; and by how much the errors until then exceed
        those that the time allows for, m.
    """
    far = barrier(extent + sp.Add(*map(sp.Abs, centre)) + distance)
    latest = _latest(far, distance, [distance] * 3, acceleration)
    moved = barrier(position_error + velocity_error * latest)
    return latest, moved - RELATIVE_INFLATION / 4 * distance


def _latest(
    far: sp.Expr,
    half: sp.Expr,
    halves: Sequence[sp.Expr | None],
    acceleration: Sequence[sp.Expr],
) -> sp.Expr:
    """Return the time until which the true ball may be in a box, or the horizon if that is first.

    If the acceleration may be zero, let d be `far`. Along an axis without acceleration the ball,
    and the true one, has left the box after T = 2 d / |v|: with errors e_p and e_v T of at most w,
    |p + v t| is from then on at least 2 d - |p| - 2 w, and grows. The first axis counts along which
    it has left.
    """
    falls = [(a, h) for a, h in zip(acceleration, halves, strict=True) if a != 0]
    if _always_falls(falls):
        per_g = _per_least(falls)
        if any(h is None for _, h in falls):
            return horizon
        return barrier(minimum(horizon, time_to_leave(barrier(far + half), per_g)))
    latest: sp.Expr = horizon
    for v, a, own in zip(VELOCITY, acceleration, halves, strict=True):
        if own is None:
            continue
        leaving = IfLess(0, absolute(v), 2 * far / absolute(v), sp.oo)
        if a != 0:
            g = barrier(absolute(a))
            falling = barrier(time_to_leave(barrier(far + half), barrier(1 / divisor(g))))
            leaving = IfLess(0, g, falling, leaving)
        latest = barrier(minimum(latest, leaving))
    return latest


def _flown(
    latest: sp.Expr, halves: Sequence[sp.Expr | None], acceleration: Sequence[sp.Expr]
) -> sp.Expr:
    """Return a length of whose size the roundings of the windows are.

    The roots of `_crossings` are off by a few roundings of themselves. On the way to -2 q / w that
    is as much of q, and so is what cancels in D = v² + 2 g q, since then v² <= 4 g |q|. At w / g it
    is as much of v²/g, or of (v + g T) T, with the T of the first axis along which the ball has
    left the box: no later root counts. So a component of gravity that is a rounding error, whose
    own roots come after aeons, loses nothing.
    """
    falls = [(a, h) for a, h in zip(acceleration, halves, strict=True) if a != 0]
    if _always_falls(falls):
        return speed**2 * _per_least(falls)
    flown: sp.Expr = sp.Integer(0)
    for a, own in falls:
        if own is None:
            continue
        g = barrier(absolute(a))
        longest = barrier(barrier(speed + g * latest) * latest)
        high = barrier(minimum(barrier(speed**2 * barrier(1 / divisor(g))), longest))
        flown = barrier(maximum(flown, IfLess(0, g, high, 0)))
    return flown


def _always_falls(falls: Sequence[tuple[sp.Expr, sp.Expr | None]]) -> bool:
    """Return whether the acceleration is known to be one, along all axes along which it may be."""
    return bool(falls) and all(has_sign(a) for a, _ in falls)


def _per_least(falls: Sequence[tuple[sp.Expr, sp.Expr | None]]) -> sp.Expr:
    """Return 1/g of the axis along which the acceleration is least."""
    return barrier(1 / minimum(*(sp.Abs(a) for a, _ in falls)))


def time_to_leave(far: sp.Expr, per_g: sp.Expr) -> sp.Expr:
    """Return T = 2 v / g + sqrt(2 d / g), after which the ball, and the true one, has left the box.

    Along an axis with gravity let p be the computed position relative to the centre, |p| + h less
    than d by at least the smallest half size. Within the box

        f(t) = (p + h + e_p) + (v + e_v) t - g t²/2 >= 0

    for one sign of p, with errors of position and velocity that are not lost, e_p + e_v T <= w with
    w a tiny part of that half size. Then f(T) <= d - half + w - v sqrt(2 d / g) - d < 0, and f
    falls from T on: f'(T) = e_v - v - g sqrt(2 d / g), where e_v <= w / T < sqrt(2 d g).

    Parameters
    ----------
    far
        d, a distance within which the ball is and the box ends, m.
    per_g
        1/g, of the acceleration along the axis.

    Returns
    -------
    Expr
        T, s.
    """
    return 2 * speed * per_g + sp.sqrt(2 * far * per_g)


def clear(found: Sequence[Window], lost: sp.Expr) -> sp.Expr:
    """Return a quantity that is positive if no window opens before the horizon.

    It is not positive if the windows are unreliable.

    Parameters
    ----------
    found
        The windows, in order.
    lost
        The result of `lost`.
    """
    verdict: sp.Expr = sp.Integer(1)
    for low, high in found:
        verdict = IfLess(barrier(maximum(0, low)), barrier(minimum(horizon, high)), 0, verdict)
    return IfAtMost(lost, 0, verdict, 0)


def _straight(axis: Axis, half: sp.Expr) -> Window:
    """Return the times of |c + v t| <= h; 0/0, a ball on the edge for ever, limits nothing."""
    place, velocity, _ = axis
    size = sp.Abs(velocity)
    there = barrier(IfLess(velocity, 0, -place, place))
    return (barrier(-half - there) / size, barrier(half - there) / size)


def _falling(axis: Axis, half: sp.Expr) -> list[Window]:
    """Return the two intervals of |c + v t + a t²/2| <= h, before and after the apex.

    With g = |a| the roots of c = h are (v ± sqrt(D)) / g with D = v² + 2 g (c - h).
    """
    place, velocity, acceleration = axis
    against = 1 if acceleration.is_negative else -1
    g = -against * acceleration
    place, up = against * place, against * velocity
    to_bottom = barrier(up**2 + 2 * g * barrier(place + half))
    to_top = barrier(up**2 + 2 * g * barrier(place - half))
    outer, inner = sp.sqrt(to_bottom), sp.sqrt(maximum(to_top, 0))
    per_g = barrier(1 / g)
    first = IfAtMost(0, to_bottom, barrier(up - outer) * per_g, sp.oo)
    last = barrier(IfAtMost(0, to_bottom, barrier(up + outer) * per_g, -sp.oo))
    passed = IfLess(0, to_top, barrier(up - inner) * per_g, last)
    again = IfLess(0, to_top, barrier(up + inner) * per_g, sp.oo)
    return [(first, passed), (again, last)]


def _perhaps_falling(axis: Axis, half: sp.Expr) -> list[Window]:
    """Return the two intervals of |c + v t + a t²/2| <= h for an acceleration that may be zero.

    Turned so that the acceleration g = |a| points down, the ball is above the bottom between the
    roots of p + h + v t - g t²/2, and above the top between those of p - h + v t - g t²/2.
    """
    place, velocity, acceleration = axis
    g = barrier(absolute(acceleration))
    above = barrier(IfLess(0, acceleration, -place, place))
    up = barrier(IfLess(0, acceleration, -velocity, velocity))
    to_bottom, to_top = barrier(above + half), barrier(above - half)
    bottom, top = (barrier(up**2 + 2 * barrier(g * q)) for q in (to_bottom, to_top))
    first, last = _crossings(to_bottom, up, g, barrier(maximum(bottom, 0)))
    passed, again = _crossings(to_top, up, g, barrier(maximum(top, 0)))
    still = AtMost(barrier(absolute(up) + g), 0)
    below = Or(Less(bottom, 0), all_of(still, Less(to_bottom, 0)))
    first, last = Choose(below, sp.oo, first), barrier(Choose(below, -sp.oo, last))
    crosses = Or(Less(0, to_top), Less(0, top))
    return [(first, Choose(crosses, passed, last)), (Choose(crosses, again, sp.oo), last)]


def _crossings(q: sp.Expr, up: sp.Expr, g: sp.Expr, discriminant: sp.Expr) -> Window:
    """Return both roots of q + v t - g t²/2, of which no difference cancels.

    With w = |v| + sqrt(v² + 2 g q) they are w / g and -2 q / w for v >= 0, and -w / g and 2 q / w
    for v < 0. Without acceleration the first of them is infinite, and both are without any motion.
    """
    wide = barrier(absolute(up) + sp.sqrt(discriminant))
    far = barrier(IfLess(0, g, wide / divisor(g), sp.oo))
    near = barrier(IfLess(0, wide, barrier(2 * q) / wide, 0))
    motionless = barrier(IfLess(0, wide, 0, IfLess(0, absolute(q), 1, IfLess(0, g, 0, 1))))
    low = barrier(IfAtMost(0, up, -near, -far))
    high = barrier(IfAtMost(0, up, far, near))
    return (
        barrier(IfLess(0, motionless, -sp.oo, low)),
        barrier(IfLess(0, motionless, sp.oo, high)),
    )
