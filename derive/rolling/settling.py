"""Zeno accumulation: the bounce from which on the ball rolls.

A ball that leaves a surface with the normal speed V, and is pressed onto it by N per unit mass,
comes back after 2 V/N with the speed V, and leaves with e V. Infinitely many such bounces take the
finite time 2 V/(N (1 - e)), in which the state changes by O(V). Then the ball rolls.

Rolling that is assumed at the bounce V instead of in the limit is off by 2 F V²/(N² (1 - e²)) along
the friction F. The decision counts twice that, the height of the hop, and the path of the slip that
is left. As soon as their sum is less than `tolerance`, the ball rolls.
"""

from __future__ import annotations

import sympy as sp

from ..contact.ball import Ball
from ..contact.law import Law
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion.flight import Flight
from ..motion.rolling_series import per_reach, per_width
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    IfLess,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    any_of,
    barrier,
    barrier_all,
    false,
    maximum,
    minimum,
)
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import UNIT_ROUNDOFF, normal, spin, velocity
from .bounds import place_rounding
from .start import Start
from .symbols import (
    bounce,
    gap,
    lift,
    nearest,
    nearing,
    normal_cosine,
    outside_distance,
    press,
    rolled,
    rolling_acceleration,
    rolling_friction,
    rolling_gap_acceleration,
    second_contact_gap,
    slip,
    turning,
    uncertain,
    weight,
)

_ZERO = sp.Integer(0)


def tolerance(ball_radius: sp.Expr) -> sp.Expr:
    """Return the position error that rolling may start with, m; the error bounds grow by as much.

    It does not depend on the carried errors, so that the path is the same without error bounds.
    The factor is a compromise: of 2,000 settled shots 250 are flagged with half a picometre; four
    times the tolerance flags an eighth more, a quarter of it a tenth fewer at 6 to 9% more time.
    """
    return sp.Rational(1, 2**38) * ball_radius


def small_hop(gravity: sp.Expr, ball_radius: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return two numbers, the first of which is less if half a hop is lower than `tolerance`.

    They are the squared speed off the surface, and twice the tolerance times a bound on the force
    per unit mass that can press the ball onto the surface.

    Parameters
    ----------
    gravity
        The size of the free ball's acceleration, m/s².
    ball_radius
        The radius of the ball, m.
    """
    off = barrier(velocity.dot(normal))
    quick = barrier(velocity.dot(velocity)) / ball_radius
    return barrier(off**2), barrier(2 * tolerance(ball_radius) * barrier(gravity + quick))


def wedge_width(ball_radius: sp.Expr) -> sp.Expr:
    """Return the largest distance to a second surface at which the ball counts as wedged, m."""
    return sp.Rational(1, 2**28) * ball_radius


def settling(law: Law, ball: Ball, flight: Flight, revolved: bool = False) -> Kernel:
    """Return the kernel that decides how the bounces on a surface end.

    A force besides gravity turns with the surface, and changes by its slope times the acceleration.

    The ball settles if the bounces end before anything else can happen; it lodges if it is then
    wedged; it slides if slip is left that friction cannot stop; it parts if no force presses it
    onto the surface, or if it starts where that force vanishes.

    Parameters
    ----------
    law
        The contact law of the surface.
    ball
        The radius and the inertia of the ball.
    flight
        The motion between contacts.
    revolved
        True if a ball may roll on a cone or a torus. The curvature changes by the speed over the
        distance from the axis, also along a line on which the normal does not turn.
    """
    e = law.restitution_at(sp.Integer(0))
    left = barrier(1 - e)
    loss = barrier(left * (1 + e))
    speed = barrier(sum(map(absolute, rolled)) + ball.radius * barrier(sum(map(absolute, spin))))
    hop = barrier(bounce / press)
    offset = barrier(
        4 * rolling_friction * hop**2 / loss
        + hop * bounce / 2
        + 4 * ball.friction_share * hop * slip / left
    )
    allowed = barrier(tolerance(ball.radius))
    quick = barrier(speed + sp.sqrt(barrier(absolute(weight) * ball.radius)))
    turns = barrier(barrier(sp.Add(*map(absolute, turning))) + 4 * UNIT_ROUNDOFF)
    if revolved:
        turns = barrier(turns + 2 * speed * per_width)
    disturbance, slope = flight.disturbance(speed)
    disturbed = disturbance * turns + slope * barrier(flight.gravity + disturbance)
    force_change = barrier(8 * barrier(absolute(weight) + speed * turns) * turns + 8 * disturbed)
    constant_force = Less(barrier(3 * hop * force_change), barrier(press * left**2))
    rounding = sp.Rational(1, 2**46) * quick
    gripped = AtMost(slip, barrier(barrier(8 * rolling_friction * hop) + rounding))
    presses = all_of(Less(0, press), Less(0, left), constant_force, gripped)
    narrow = barrier(wedge_width(ball.radius))
    way = barrier(16 * hop * speed / left)
    isolated = Less(barrier(way + narrow), nearest)
    wedged = AtMost(second_contact_gap, narrow)
    # A ball that slips is pressed on by another force than a rolling one.
    firm = barrier(minimum(press, -lift))
    skip = barrier(bounce / firm)
    bounces_on = all_of(
        Less(0, firm),
        Less(0, left),
        Less(barrier(3 * skip * force_change), barrier(firm * left**2)),
        Less(barrier(barrier(16 * skip * speed / left) + narrow), nearest),
    )
    slides: sp.Basic = false
    undecided_slip: sp.Basic = false
    if law.friction_coefficient != sp.oo:
        share = barrier(law.friction_coefficient * (1 + e))
        available, required = barrier(share * press), 2 * rolling_friction
        presses = all_of(presses, AtMost(required, available))
        # Without a bounce even an infinite friction takes nothing.
        takes = barrier(
            IfLess(0, bounce, barrier(share * bounce), 0) + barrier(2 * rolling_friction * skip)
        )
        # A contact that grips leaves roundings of the speed before it; the next contact takes them.
        stopped = barrier(
            barrier(2 * takes / (ball.friction_share * left)) + sp.Rational(1, 2**36) * quick
        )
        moved = barrier(4 * rolling_friction * skip**2 / loss + skip * bounce / 2)
        over = all_of(bounces_on, AtMost(moved, allowed))
        slides = all_of(over, Or(Less(stopped, slip), Less(available, required)))
        # The slip is v - R w × n. The errors of R w and of the normal times the speed count as much
        # as that of v, and each counts more than twice.
        slip_error = barrier(8 * velocity_error)
        undecided_slip = all_of(
            over,
            Or(
                Less(absolute(slip - stopped), slip_error),
                Less(
                    absolute(required - available),
                    barrier(barrier(turns + share * turns) * slip_error),
                ),
            ),
        )
    stays = all_of(presses, AtMost(offset, allowed))
    # Beside a surface that does not hold it, a ball that hardly moves until the bounces end rolls
    # from where it is. Which surface it would touch first meanwhile is undecided.
    still = AtMost(way, narrow)
    undecided_press = _undecided_force(flight.gravity + disturbance, speed + slip, slope)
    near_limit = barrier(absolute(offset - allowed) * bounce)
    start = Start(flight.strength, ball.radius)
    # Without restitution the speed off the surface is a rounding, and no error before changes it.
    undecided_bounce = all_of(
        AtMost(near_limit, barrier(2 * allowed * velocity_error)),
        Less(0, barrier(e * bounce)),
        Not(start.along),
    )
    return loop_kernel(
        f"{law.name}_settling",
        {
            "settles": all_of(stays, Not(wedged), Or(isolated, still), Not(start.departs)),
            "lodges": all_of(stays, wedged, Not(start.departs)),
            "slides": all_of(slides, Not(start.departs)),
            "unpressed": Or(
                all_of(AtMost(bounce, rounding), AtMost(0, lift), Not(start.enters)), start.departs
            ),
            "assured": Choose(Or(all_of(presses, isolated), bounces_on), 1, 0),
            "undecided": Or(
                all_of(
                    any_of(
                        undecided_press,
                        undecided_bounce,
                        undecided_slip,
                        all_of(stays, still, Not(isolated)),
                    ),
                    Not(start.departs),
                ),
                start.may_depart,
            ),
        },
        "Whether the bounces end in rolling, sliding, a wedge or departure, and whether that is "
        "certain.",
        "a geometric series of bounces",
    )


def _undecided_force(strength: sp.Expr, speed: sp.Expr, slope: sp.Expr) -> sp.Basic:
    """Return whether the errors may change the sign of what presses the ball onto the surface.

    That is the normal force if the ball rolls, and minus the second derivative of the gap if it
    flies. Without air both are a·n + v·K v, with the curvature K of the surface. An error of the
    place turns n by K times its length, and changes K, relatively, by as much. The last term is the
    rounding of the force.

    Parameters
    ----------
    strength
        A bound on the force per unit mass, m/s².
    speed
        A bound on the speed of the ball, before and after it stops to slip, m/s.
    slope
        A bound on the derivative of the force by the velocity, 1/s.
    """
    bend = barrier(absolute(per_reach))
    pull = barrier(strength + barrier(speed) ** 2 * bend)
    error = barrier(
        barrier(8 * bend * barrier(pull * position_error + speed * velocity_error))
        + 4 * slope * velocity_error
        + sp.Rational(1, 2**48) * pull
    )
    return Or(AtMost(absolute(press), error), AtMost(absolute(lift), error))


def settling_kernels(
    flight: Flight, gravity: sp.Expr, ball: Ball, oblique: bool = False, revolved: bool = False
) -> tuple[Kernel, ...]:
    """Return the kernels that prepare the decision of `settling`, the same for all surfaces.

    Parameters
    ----------
    flight, ball
        As for `settling`.
    gravity
        The size of the free ball's acceleration, m/s².
    oblique
        True if a ball may roll on a tube that lies along no axis. Bounces on a turned box, whose
        condition has more roundings, then are known earlier to end there, unless a seam is near.
    revolved
        True if a ball may roll on a cone or a torus, whose conditions have more roundings, too.
    """
    seams = decision(
        "near_seam",
        {"nearest": minimum(nearest, absolute(gap))},
        "Distance to a seam of the surface that the ball is on.",
    )
    # On which side of a seam the ball is decides how the surface bends under it.
    rounding = place_rounding(ball.radius)
    on_seam = AtMost(absolute(gap), barrier(4 * position_error + rounding))
    asked = all_of(Boolean("nearly"), on_seam)
    return (
        *((seams,) if oblique else ()),
        decision(
            "seam_undecided",
            {"uncertain": Choose(asked, 1, uncertain)},
            "1 if a ball that may stay on a surface is on a seam of it, within the errors.",
        ),
        loop_kernel(
            "roll_turn_rate",
            {"turn_rate": ball.radius * barrier(spin.dot(normal))},
            "Spin about the normal, times the ball's radius.",
            "s = R_B (w·n)",
        ),
        _pressed_on(flight, ball),
        *_bounce_kernels(gravity, ball, oblique or revolved),
    )


def _pressed_on(flight: Flight, ball: Ball) -> Kernel:
    """Return the forces on a ball that rolls on from the surface it has touched."""
    acceleration = flight.acceleration
    turn_rate = ball.radius * barrier(spin.dot(normal))
    down = sp.Matrix(list(acceleration))
    pressing = barrier(down.dot(normal))
    n = barrier(barrier(-pressing) - barrier(rolled.dot(turning)))
    along = down - pressing * normal
    twisted = normal.cross(turning)
    friction = [
        barrier(ball.friction_share * (turn_rate * m - a))
        for a, m in zip(along, twisted, strict=True)
    ]
    pushed = [barrier(a + n * c + f) for a, c, f in zip(down, normal, friction, strict=True)]
    return loop_kernel(
        "pressed_on",
        {
            "press": n + flight.surface_force.at(pressing, barrier(rolled.dot(rolled))),
            "weight": pressing,
            "rolling_friction": barrier(sp.sqrt(barrier(sum(c**2 for c in friction)))),
            **dict(zip(map(str, rolling_acceleration), pushed, strict=True)),
        },
        "Normal force, its part from free fall, friction and acceleration of a rolling ball.",
        "N = -a·n - v·n', F = beta (-a_t + s n × n')",
    )


def _bounce_kernels(gravity: sp.Expr, ball: Ball, rounded: bool) -> tuple[Kernel, ...]:
    off = barrier(velocity.dot(normal))
    # The ball settles if half a hop is lower than the tolerance, whatever presses it on. Error
    # propagation needs to know much earlier whether its bounces end on this surface.
    small = Less(*small_hop(gravity, ball.radius))
    early = sp.Rational(1, 2**14 if rounded else 2**23)
    slow = Less(barrier(off**2), early * ball.radius)
    tangential = barrier_all(velocity - off * normal)
    sliding = barrier_all(tangential - ball.radius * spin.cross(normal))
    gripped = [
        barrier(v - ball.friction_share * u) for v, u in zip(tangential, sliding, strict=True)
    ]
    return (
        decision(
            "leaves_slowly",
            {"slow": any_of(small, all_of(slow, Less(0, position_error))), "assured": 0},
            "Whether a ball leaves so slowly that its bounces may end here.",
        ),
        loop_kernel(
            "nearly",
            {"nearly": small},
            "Whether this bounce is so small that it may be the last.",
            "half a hop's height",
        ),
        loop_kernel(
            "gripped",
            dict(zip(map(str, rolled), gripped, strict=True))
            | {
                "slip": barrier(sp.sqrt(barrier(sum(u**2 for u in sliding)))),
                "bounce": maximum(0, off),
            },
            "Velocity after the contact point stops; its slip, and the speed off the surface.",
            "the momenta that a contact conserves",
        ),
        decision(
            "isolated",
            {"nearest": sp.oo, "second_contact_gap": sp.oo},
            "Start values: no surface beside the ball.",
        ),
        decision(
            "near_body",
            _beside_contact(),
            "Distance to a body beside a rolling ball, and whether it holds the ball, too.",
        ),
        decision(
            "near_bounded_body",
            _beside_contact(outside_distance, wedge_width(ball.radius)),
            "Distance to a body with bounds beside a rolling ball, and whether it holds it, too.",
        ),
        decision(
            "near_end_plane",
            {"nearest": minimum(nearest, absolute(gap))},
            "Distance to an end plane beside the ball.",
        ),
    )


def _beside_contact(outside: sp.Expr | None = None, width: sp.Expr = _ZERO) -> dict[str, sp.Basic]:
    """Return the distance to a body beside a rolling ball, and how far the ball gets from it.

    Parameters
    ----------
    outside
        The distance of the ball from the bounds of the body; None if it has none.
    width
        The largest such distance at which the body may still hold the ball.

    The body holds the ball, too, if the ball is pressed onto it: then the top of the hop bounds the
    distance. It does not if the ball rolls away from it, or touches it with the same normal, as
    where the ring's top meets the bridge's: the ball rolls from one to the other. Without either,
    as in the corner between bridge and board, the ball counts as hardly pressed.
    """
    pull = barrier(maximum(absolute(rolling_gap_acceleration), sp.Rational(1, 2**20) * press))
    top = barrier(absolute(gap) + nearing**2 / (2 * pull))
    holds = all_of(
        Less(rolling_gap_acceleration, sp.Rational(1, 2**40) * press),
        Less(normal_cosine, 1 - sp.Rational(1, 2**20)),
        *(() if outside is None else (AtMost(outside, width),)),
    )
    away = absolute(gap) if outside is None else barrier(maximum(absolute(gap), outside))
    return {
        "nearest": minimum(nearest, away),
        "second_contact_gap": minimum(second_contact_gap, Choose(holds, top, sp.oo)),
    }
