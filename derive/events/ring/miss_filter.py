"""Tests that a ball certainly misses the ring: by one evaluation, and without roots."""

from __future__ import annotations

import sympy as sp

from ...symbolic.conditionals import IfLess, Less, all_of, barrier, barrier_all
from ...symbolic.rounding import extent, position_error, speed, velocity_error
from ...symbolic.symbols import POSITION, VELOCITY
from ..event_polynomials import horizon
from .polar import PolarRootFinder


def clear(search: PolarRootFinder) -> sp.Expr:
    """Return a quantity that is positive if the ball certainly misses the ring.

    A ball that rises above the ring and comes down again misses it until the horizon if

    - it is beyond the annulus and approaching while it rises through the ring's level;
    - when it sinks back into that level, at t1, the parabola below F has no root; there F'' >= m as
      long as rho >= I, the annulus's inner radius;
    - and it is then inside the hole at the horizon, which it has not left since entering it, rho²
      being convex in time; or it never enters the hole.

    Everything is multiplied by the positive rho² I³. The slack of 2^-30 (R_H + R)² exceeds every
    rounding and carried error unless the flight is 2^16 times as large. It is generous: below the
    level where the parabola begins, gravity lifts F above it by more than this up to any horizon of
    a scene. With next to no gravity the kernel needs the slack.

    **Lemma (clear).** Let 3/2 R <= R_H <= 2^4 R, the flight until the horizon be no larger than
    2^16 R, and |v|² <= 2^16 g R. If this is positive, the true ball is not in contact with the ring
    at any time until the horizon.

    *Proof.* P = p + v T < 2^-34 A bounds the errors of the true place, and 4 u X <= 2^-35 R the
    roundings of one; `lost_by` has that the hole is wider than 2^-12 R_H. A contact of the true
    ball is one of the computed flight with |z| and |rho - R_H| at most R + 2^-33 A, while R̂ and A
    are R + 2^-14 R and R_H + R̂.

    - *Until it rises through z = R̂*, at t: rho(t)² is computed to 16 u X² <= 2^-17 R², and exceeds
      A². The rate of rho² is negative to 2^-33 R V, and rho² is convex: before, it was less by at
      most 2^-33 R V t <= 2^-17 R². A² - 2^-16 R² is more than (R_H + R + 2^-15 R)².
    - *Between the levels* z > R̂ - 2^-34 R, as z at both times is R̂ to 8 u X.
    - *Below*: from the time t1 on, at which z <= R̂ + 2^-34 R, F is above its parabola, with
      F'' >= m + 6 g (R̂ - z) where rho >= I, and R̂ - z >= g s²/2 - 2^-34 R after s. So gravity lifts
      F by g² s⁴/4. The roundings of m are mostly those of L, 2 u X V: where m > 0 less than
      2^-31 |v|² <= 2^-15 g R. They lower F by at most 2^-16 g R s², and by no more than 2^-32 R²
      with that lift. The roundings of F at t1, and what P changes it by, are less than
      4.91 R̂ (P + 4 u X) + 12 u R̂ A < 2^-32 A². Those of the discriminant are as of a share 2^-46 of
      F at t1: less than 2^-41 A² where F < 2^4 A²; else less than the lift until the ball is at the
      annulus, after sqrt(F)/(2 V) at least. Together these are less than the slack. So where the
      computed parabola has no root, F of the true ball is positive.
    - *In the hole* rho² < I² - slack + 2^-33 A² at the horizon: rho < I there, and since the ball
      came into the hole, for rho² is convex. Or L²/V² > I² + slack - 2^-35 A², the least of rho²,
      so that rho > I at all times. ∎
    """
    g, radius = search.gravity, search.ring.ring_radius
    innermost, outermost = search.radii()
    x, y, z = POSITION
    vx, vy, vz = VELOCITY
    rho_squared, q, speed_squared, moment = search.polar()
    to_top = barrier(vz**2 + 2 * g * barrier(z - search.reach))
    per_g = barrier(1 / g)
    inner = sp.sqrt(to_top)
    rises, sinks = barrier(barrier(vz - inner) * per_g), barrier(barrier(vz + inner) * per_g)
    away = barrier(q + speed_squared * rises)
    then = barrier(rho_squared + rises * barrier(q + away))

    there, moving = (barrier_all(vector) for vector in search.flight.at(sinks))
    now_squared = barrier(there[0] ** 2 + there[1] ** 2)
    rho = sp.sqrt(now_squared)
    slack = sp.Rational(1, 2**30) * outermost**2
    depth = barrier(rho - radius)
    gap = barrier(depth**2 + there[2] ** 2 - search.ring.reach**2 - slack)
    sideways = barrier(there[0] * vx + there[1] * vy)
    slope_rho = 2 * barrier(depth * sideways + rho * there[2] * moving[2])
    least = barrier(search.constants["energy2"] - 6 * g * search.reach)
    bend = barrier(least * innermost**3 - search.constants["moment2"])
    discriminant = barrier(slope_rho**2 * innermost**3 - 2 * bend * gap * now_squared)
    last_x, last_y = barrier(x + vx * horizon), barrier(y + vy * horizon)
    in_hole = barrier(last_x**2 + last_y**2 - innermost**2 + slack)
    off_hole = barrier(speed_squared * barrier(innermost**2 + slack) - moment**2)
    furthest = barrier(extent + horizon * barrier(speed + g * horizon))
    carried = barrier(position_error + velocity_error * horizon)

    verdict = IfLess(in_hole, 0, 1, IfLess(off_hole, 0, 1, 0))
    verdict = IfLess(discriminant, 0, verdict, 0)
    verdict = IfLess(0, gap, IfLess(0, bend, verdict, 0), 0)
    verdict = IfLess(horizon, barrier(sinks - sp.Rational(1, 2**30) * horizon), 1, verdict)
    nearing = IfLess(away, 0, IfLess(outermost**2, then, verdict, 0), 0)
    verdict = IfLess(rises, 0, verdict, nearing)
    verdict = IfLess(0, to_top, verdict, 0)
    verdict = IfLess(furthest, 2**16 * outermost, verdict, 0)
    verdict = IfLess(carried, sp.Rational(1, 2**34) * outermost, verdict, 0)
    return IfLess(0, search.lost_by(horizon), 0, verdict)


def drops_through(search: PolarRootFinder) -> sp.Basic:
    """Return a condition that the ball rises and then drops through the hole, without roots.

    Four times stand for the flight: that of its apex b, those of the last eighth a and the last
    32nd m of the descent, and the horizon T. With the inflated R, and s a slack, the ball misses

    - until b, if it approaches the axis at b, and rho(b) > R_H + R + s: rho² is convex in time, and
      falls until then;
    - from b to a, if z(a) > R + s: it sinks from the apex on;
    - from a to m, if rho - z < R_H - sqrt(2) R - s at both times: so it is between them, since rho
      and -z are convex. The tangent plane of the ball's reach with the normal (-1, 1)/sqrt(2), in
      rho and z, then separates the ball from the wire;
    - from m to T, if rho < R_H - R - s at both times, by the convexity of rho.

    The first of these conditions contradicts the last if b is after T. A ball that does not rise is
    refused, as b would be before the flight. Else it only matters to the roundings where b, a and m
    lie: the ball is never lower between b and a than at one of them, z being concave.

    All of this is in single precision. A flight of less than 2^7 times the annulus's outer radius
    rounds a coordinate by eight times 2^-24 of its size at most, which is 2^-14 of that radius, and
    carries less. That holds at b, too, since V b <= 2 rho(0) if the ball still approaches the axis
    there. The slack is 2^-11 of the radius: more than the roundings of rho and z together.

    **Lemma (drop through the hole).** If this holds, the true ball is not in contact with the ring
    at any time until the horizon.

    *Proof.* The items above are about flights without roundings. With v = 2^-24 a coordinate has,
    state, time and gravity rounded, at most 8 v X <= 2^-14 A, and the errors of the true state at
    most 2^-16 A. Both move rho by less than sqrt(2) times their sum, and rho - z by less than 2.5
    times it: 3.2 2^-14 A, less than the slack of 2^-11 A; the squares are compared to 4 v of
    themselves. The horizon is a number of single precision, off by v T: the ball flies v X then,
    2^-17 A. ∎
    """
    g, radius = search.gravity, search.ring.ring_radius
    reach = search.reach
    _, outermost = search.radii()
    x, y, z = POSITION
    vx, vy, vz = VELOCITY
    slack = sp.Rational(1, 2**11) * outermost
    apex = barrier(vz * barrier(1 / g))
    eighth = barrier(barrier(horizon - apex) / 8)
    begin = barrier(horizon - eighth)
    middle = barrier(horizon - barrier(eighth / 4))

    def sideways(time: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        return barrier(x + vx * time), barrier(y + vy * time)

    def height(time: sp.Expr) -> sp.Expr:
        return barrier(z + barrier(vz - g / 2 * time) * time)

    there_x, there_y = sideways(apex)
    squares = [
        barrier(there[0] ** 2 + there[1] ** 2) for there in map(sideways, (begin, middle, horizon))
    ]
    beyond = barrier(outermost + slack)
    inside = barrier(radius - reach - slack)
    below = barrier(radius - sp.Rational(46341, 2**15) * reach - slack)
    first, second = (barrier(height(time) + below) for time in (begin, middle))
    hole = barrier(inside**2)
    furthest = barrier(extent + horizon * barrier(speed + g * horizon))
    carried = barrier(position_error + velocity_error * horizon)
    return all_of(
        Less(0, vz),
        Less(barrier(beyond**2), barrier(there_x**2 + there_y**2)),
        Less(barrier(there_x * vx + there_y * vy), 0),
        Less(barrier(reach + slack), height(begin)),
        Less(squares[0], barrier(first**2)),
        Less(squares[1], barrier(second**2)),
        Less(0, second),
        Less(squares[1], hole),
        Less(squares[2], hole),
        Less(0, inside),
        Less(furthest, 2**7 * outermost),
        Less(carried, sp.Rational(1, 2**16) * outermost),
    )
