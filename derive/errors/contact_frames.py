"""Bounds on the errors of a shot, proved contact after contact, in the frames of the contacts.

**Frames.** At a contact with the normal n, let e be a horizontal unit vector along the surface and
s = e × n: on the ring s points across the wire and e along it, on a plane both are constant. Let
1/R be the curvature along s and 1/ρ that along e about the axis: a ball that is displaced on the
surface by q = (q_s, q_e) has a frame that is turned by Ω q = (q_s/R) e + (q_e/ρ) z. Planes have no
curvature. So an error of place, velocity and spin after a contact without slip has the coordinates

    dx = q_n n + q_s s + q_e e,     dv = (Ω q) × v + y_n n + y_s s + y_e e,
    dw = (Ω q) × w + n × (y_s s + y_e e)/R_B + y_w n + y_z,

y_z ⟂ n. These are linear and bijective. The part of dv and dw with Ω q is what a rotation of the
whole motion about the ring makes, which no contact with the ring lets grow.

**Lemma (growth of errors).** Let the errors at the departure be within B_n, ..., B_w and B_z in
these coordinates, and P, E and W bound the norms of dx, dv and dw. Until the next contact, the
flight takes the time t, and computed v, w, n there have V = |n·v|. Then the errors after it are
within |T| B + B', where T is the matrix of the derivative of flight, contact and impact in the
coordinates of both frames, with absolute values of its elements, and B' is the sum of

- the roundings of the flight, r of the place and u (|v| + g t) of the velocity, of the root, which
  is off the surface by at most A_F (`root_offset` of the surface), of the normal and the impact;
- what the derivative leaves out (`second_order`);
- 2^-17 of the sizes of all products in T, for the roundings of T in single precision.

*Proof.* The flight is linear in the state. At the computed time of the contact the exact ball is
therefore off the computed one by the linear image of the errors at the start, and by the roundings
r and u (|v| + g t). The exact flight from the computed start reaches the surface, or on a return
the level of its start, within A_F/V of that time (`tests/derive/errors/test_ring_roots.py`,
`test_plane_roots.py`, and `root_offset`). So the exact ball has there a distance from the surface
of at most A_n, the first row of the flight's matrix times B, with A_F and the curvature's share
K A² of both ends of the flight, where A bounds the norm of its error. The computed place is off
that flight by r. On a return both balls count from the level of the computed start, which is q_n
off: an offset q_n at the start shifts the whole flight, and changes the distance by
(n·n_0 - 1) q_n.

With the ball at the nearest point of the surface, which has the same normal, as the first ball of
the lemma in `second_order`, and A_n in place of A in the delay, the exact ball meets the surface
once within S = 1.1 A_n/V, and all that its derivative leaves out is at most d²c, d²n, d²v and d²w;
d²t counts the curvature of both ends. Of the acceleration only n·g changes the speed towards the
surface, and V/12 in place of V/11 leaves room for single precision.
The law is the same in every frame. A change of the normal by the error q is the rotation Ω q, so
in the turned frame the impact multiplies y by its constant matrix: -e along n, and along the
surface the shares that stay and that friction gives. That is T. The computed impact differs from
the exact one by 14 u (|v| + R_B |w|), sums of components (`test_kernel_roundings.py`), and by what
the normal is off that it is given: its roundings, and off the surface its length.

The computed place is off the surface by A_F and r, on a return to the level of its start by q_n
besides; that is B'_n (`root_level`). On a plane it is put there. What of dw is not in the
coordinates, y_z, is made by each contact anew, of roundings and the second order: without slip
w = n × v/R_B along the surface. ∎

If the lemma's conditions do not hold, or the normals are 2^-22 longer or shorter than 1, the
bounds are infinite, and a shot with bounds that are not finite after a contact is uncertain at
once. At an end they are infinite alone: no decision follows.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from ..contact.ball import Ball
from ..motion.parabola import Parabola
from ..symbolic.conditionals import (
    IfAtMost,
    Less,
    Not,
    absolute,
    all_of,
    barrier,
    maximum,
)
from ..symbolic.error_terms import clock, clock_error, left_normal
from ..symbolic.rounding import ROUNDING_SLACK
from ..symbolic.symbols import (
    UNIT_ROUNDOFF,
    normal,
    position,
    spin,
    t,
    velocity,
)
from . import second_order as remainder

BOUNDS = sp.symbols("place_n place_s place_e pace_n pace_s pace_e turn_n turn_z", nonnegative=True)
"""B_n, B_s and B_e of the place, the bounds of y_n, y_s and y_e, B_w and B_z."""

EACH = (*BOUNDS, BOUNDS[-1])
"""The bound of each coordinate; both components of y_z have the same."""

SIZE = 6
"""Number of the coordinates that every contact makes of those before it: q_s, q_e, y_n to y_w."""

NORMS = sp.symbols("position_bound velocity_bound spin_bound", nonnegative=True)
"""P, E and W: bounds on the norms of the errors of place, velocity and spin."""

TANGENT = sp.symbols("tangent_x tangent_y", real=True)
"""e at the contact; it is horizontal."""
BENDS = sp.symbols("bend_s bend_e", nonnegative=True)
"""1/R and 1/ρ at the contact."""
LEFT_TANGENT = sp.symbols("left_ex left_ey", real=True)
LEFT_BENDS = sp.symbols("left_bend_s left_bend_e", nonnegative=True)
"""The same where the flight began, beside its normal."""
sharpest_bend, root_offset, root_level, normal_rounding = sp.symbols(
    "sharpest_bend root_offset root_level normal_rounding", nonnegative=True
)
"""K, A_F, how far the exact flight from the computed start is off the surface at most, and a bound
on the norm of the rounding of the normal."""
normal_velocity = sp.Symbol("normal_velocity", real=True)
"""n·v before the impact, in double precision, since a sum of larger terms may nearly cancel."""
back = sp.Symbol("back", nonnegative=True)
"""1: the flight began on the same surface; 0: it did not."""

CARRIED = (*BOUNDS, *NORMS, *left_normal, *LEFT_TANGENT, *LEFT_BENDS)
"""The numbers that are carried from contact to contact."""

ARGUMENTS = (
    *(*BOUNDS, *NORMS, *TANGENT, *BENDS, *LEFT_TANGENT, *LEFT_BENDS),
    *(sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back),
)
"""Arguments of the kernels of this module besides those of `propagation`, in calling order."""

MOST_LENGTHS = 2**22
"""One over how much longer normals off the surface are than 1, at both ends of a flight: so little
that the roundings of T contain it."""

LAW_ROUNDINGS = 14
"""The roundings of an impact, of the sum of the sizes of velocity and of the radius times spin."""

T_ROUNDING = sp.Rational(1, 2**17)
"""Roundings of T in single precision, of the sizes of all products in it: 2^7 units of 2^-24. The
longest chain of roundings that leads to an element of the rows of q has 54, with those of its
factors, and a sum over three bounds is at most sqrt(3) times the norm of these. In the rows of y
those of q are passed on with q, as its own errors; besides they have 45 at most, and their sizes
count twice."""

DIAGONAL = sp.Rational(27, 64)
"""At least sqrt(2) - 1: what the diagonal of a square has more than its side."""

FLOOR = sp.Rational(1, 2**100)
"""A length, and a velocity, that single precision still represents."""

Vector = tuple[sp.Expr, sp.Expr, sp.Expr]
"""Components along n, s and e."""


@dataclass(frozen=True)
class Frame:
    """The frame of a contact.

    Attributes
    ----------
    axes
        n, s and e, rows of their components.
    bends
        1/R and 1/ρ.
    """

    axes: sp.Matrix
    bends: tuple[sp.Expr, sp.Expr]

    @classmethod
    def of(cls, n: sp.Matrix, tangent: Sequence[sp.Expr], bends: Sequence[sp.Expr]) -> Frame:
        """Return the frame with a normal and a horizontal tangent e: s is e × n.

        Parameters
        ----------
        n
            The normal.
        tangent
            e_x and e_y.
        bends
            1/R and 1/ρ.
        """
        ex, ey = tangent
        nx, ny, nz = n
        across = [barrier(ey * nz), barrier(-ex * nz), barrier(ex * ny - ey * nx)]
        return cls(sp.Matrix([[nx, ny, nz], across, [ex, ey, 0]]), (bends[0], bends[1]))

    def of_vector(self, vector: Sequence[sp.Expr]) -> Vector:
        """Return the components of a vector.

        Parameters
        ----------
        vector
            Its components along the axes of the scene, (3,).
        """
        n, s, e = (barrier(sp.Matrix(vector).dot(self.axes.row(k))) for k in range(3))
        return n, s, e

    def of_motion(self) -> tuple[Vector, Vector]:
        """Return the components of velocity and spin before the impact."""
        _, s, e = self.of_vector(velocity)
        return (normal_velocity, s, e), self.of_vector(spin)

    def turned(self, vector: Vector) -> tuple[Vector, Vector]:
        """Return the changes of a vector that turns with the frame, by q_s and by q_e.

        Parameters
        ----------
        vector
            Its components in the frame.
        """
        n, s, e = vector
        per_s, per_e = self.bends
        up_n, up_s = self.axes[0, 2], self.axes[1, 2]
        zero = sp.Integer(0)
        return (
            (barrier(-s * per_s), barrier(n * per_s), zero),
            (
                barrier(up_s * e * per_e),
                barrier(-up_n * e * per_e),
                barrier(barrier(up_n * s - up_s * n) * per_e),
            ),
        )


def held(quantity: sp.Expr) -> sp.Expr:
    """Return a quantity, held unless it is a number: what is zero takes no operation.

    Parameters
    ----------
    quantity
        The quantity.
    """
    return quantity if quantity.is_Number else barrier(quantity)


def _vector(components: Iterable[sp.Expr]) -> Vector:
    n, s, e = components
    return n, s, e


def _times(factor: sp.Expr, vector: Vector) -> Vector:
    return _vector(held(factor * one) for one in vector)


def _cross(a: Sequence[sp.Expr], b: Sequence[sp.Expr]) -> Vector:
    """Return a × b along n, s and e, which are right-handed."""
    return _vector(held(a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2]) for k in range(3))


def weighted_sum(factors: Sequence[sp.Expr], bounds: Sequence[sp.Expr]) -> sp.Expr:
    """Return the sum of bounds, each times the absolute value of a factor.

    Parameters
    ----------
    factors
        The factors, of any sign.
    bounds
        A bound for each of them.
    """
    pairs = zip(factors, bounds, strict=True)
    return barrier(sp.Add(*(absolute(factor) * b for factor, b in pairs if factor != 0)))


def _norm(vector: Sequence[sp.Expr]) -> sp.Expr:
    """Return a bound on the Euclidean norm of a vector with components of at least zero.

    Where one component is the largest, the norm is convex in the others and the bound linear; it
    holds at the corners, where each is zero or as large.
    """
    return barrier((1 - DIAGONAL) * maximum(*vector) + DIAGONAL * barrier(sum(vector)))


def norms_after(
    frame: Frame,
    ball: Ball,
    bounds: Sequence[sp.Expr],
    after: tuple[Vector, Vector],
    sizes: tuple[sp.Expr, sp.Expr],
) -> dict[str, sp.Expr]:
    """Return P, E and W from the bounds in the coordinates.

    Parameters
    ----------
    frame
        The frame of the contact.
    ball
        The ball.
    bounds
        As `BOUNDS`.
    after
        The components of velocity and spin after the contact, computed in single precision.
    sizes
        Bounds on the sizes of velocity and spin after the contact.
    """
    q_n, q_s, q_e, y_n, y_s, y_e, y_w, y_z = bounds
    turned = barrier(T_ROUNDING * barrier(q_s * frame.bends[0] + q_e * frame.bends[1]))
    own = (y_n, y_s, y_e), (y_w, y_e / ball.radius + y_z, y_s / ball.radius + y_z)
    moved, spun = (
        [
            barrier(absolute(along) * q_s + absolute(around) * q_e + one + size * turned)
            for along, around, one in zip(*frame.turned(vector), part, strict=True)
        ]
        for vector, part, size in zip(after, own, sizes, strict=True)
    )
    values = (_norm((q_n, q_s, q_e)), _norm(moved), _norm(spun))
    return {s.name: ROUNDING_SLACK * value for s, value in zip(NORMS, values, strict=True)}


def means(flight: Parabola) -> list[sp.Expr]:
    """Return the mean velocities of a flight of time t, from those at its end.

    Parameters
    ----------
    flight
        The motion between contacts.
    """
    return [
        barrier(v - a * t / 2) if a != 0 else v
        for v, a in zip(velocity, flight.acceleration, strict=True)
    ]


def flight_roundings(flight: Parabola) -> tuple[list[sp.Expr], sp.Expr]:
    """Return the roundings of the coordinates in a flight of time t, and of all velocities.

    Arguments are the state at the end. They are those of the flight's lemma in
    `tests/derive/errors/test_kernel_roundings.py`.

    Parameters
    ----------
    flight
        The motion between contacts.
    """
    places = [
        barrier(
            UNIT_ROUNDOFF * barrier(absolute(place) + 2 * absolute(mean) * t + sp.Abs(a) * t**2 / 2)
            + FLOOR
        )
        for place, mean, a in zip(position, means(flight), flight.acceleration, strict=True)
    ]
    speeds = barrier(
        UNIT_ROUNDOFF * barrier(sum(map(absolute, velocity)) + flight.strength * t) + FLOOR
    )
    return places, speeds


@dataclass(frozen=True)
class Growth:
    """The growth of errors over a flight and a contact, to first order.

    Attributes
    ----------
    here
        The frame of the contact.
    columns
        T by columns, q_n, ..., y_w and y_z along s and along e, each (6,), or with friction (8,).
    gap
        The distance from the surface at the computed time that errors at the start cause.
    after
        The components of velocity and spin after the contact.
    """

    here: Frame
    columns: Sequence[Sequence[sp.Expr]]
    gap: sp.Expr
    after: tuple[Vector, Vector]

    def times(self, bounds: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Return |T| times bounds.

        Parameters
        ----------
        bounds
            A bound for each column.
        """
        return [weighted_sum(row, bounds) for row in zip(*self.columns, strict=True)]

    def errors_after(self, ball: Ball, found: Sequence[sp.Expr], rest: Rest) -> dict[str, sp.Expr]:
        """Return the outputs of a kernel that carries bounds, infinite where no lemma holds.

        Parameters
        ----------
        ball
            The ball.
        found
            The bounds of the coordinates that a contact makes of those before it, (6,).
        rest
            The terms beside |T| B.
        """
        rolled = self.times(EACH)[SIZE:]
        unrolled = maximum(*rolled) + rest.unrolled if rolled else rest.unrolled
        arrival = rest.arrival
        bounds = [
            barrier(ROUNDING_SLACK * barrier(one)) for one in (arrival.level, *found, unrolled)
        ]
        sizes = rest.speed_after, rest.spin_after
        norms = norms_after(self.here, ball, bounds, self.after, sizes)
        delay = IfAtMost(rest.excess, 0, ROUNDING_SLACK * arrival.late, sp.oo)
        proved = {s.name: bound for s, bound in zip(BOUNDS, bounds, strict=True)} | norms
        return {
            **{name: IfAtMost(rest.excess, 0, bound, sp.oo) for name, bound in proved.items()},
            **{f"left_n{axis}": n for axis, n in zip("xyz", normal, strict=True)},
            **{s.name: value for s, value in zip(LEFT_TANGENT, TANGENT, strict=True)},
            **{s.name: value for s, value in zip(LEFT_BENDS, BENDS, strict=True)},
            "delay": delay + 4 * UNIT_ROUNDOFF * barrier(clock + t),
        }


def growth(flight: Parabola, impact: Impact) -> Growth:
    """Return the growth of errors over a flight and a contact.

    Parameters
    ----------
    flight, impact
        As for `contact_errors`.
    """
    left = Frame.of(left_normal, LEFT_TANGENT, LEFT_BENDS)
    here = Frame.of(normal, TANGENT, BENDS)
    law = impact.law
    moving, turning = here.of_motion()
    fall = here.of_vector(flight.acceleration)
    began = [held(v - t * a) for v, a in zip(moving, fall, strict=True)]
    # n, s and e of the departure, and the vertical, in the frame of the contact.
    out, across, along = (
        _vector(barrier(here.axes.row(i).dot(left.axes.row(j))) for i in range(3)) for j in range(3)
    )
    up = _vector(here.axes[i, 2] for i in range(3))
    about_e, about_z = _times(left.bends[0], along), _times(left.bends[1], up)
    per_radius = barrier(1 / impact.ball.radius)
    still: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(0))
    # Place, velocity and spin of each coordinate's unit at the departure.
    columns: list[tuple[Vector, Vector, Vector]] = [
        (out, still, still),
        (across, _cross(about_e, began), _cross(about_e, turning)),
        (along, _cross(about_z, began), _cross(about_z, turning)),
        (still, out, still),
        (still, across, _times(per_radius, along)),
        (still, along, _times(-per_radius, across)),
        (still, still, out),
        (still, still, across),
        (still, still, along),
    ]
    per_approach = barrier(1 / normal_velocity)
    falls = law(fall, still)
    aside, around = (
        law(*turned) for turned in zip(here.turned(moving), here.turned(turning), strict=True)
    )
    gaps: list[sp.Expr] = []
    found: list[tuple[sp.Expr, ...]] = []
    for index, (place, pace, turn) in enumerate(columns):
        n, s, e = (held(p + t * v) for p, v in zip(place, pace, strict=True))
        if index == 0:  # on a return the level is that of the start
            n = barrier(n - back)
        delay = held(-n * per_approach)
        q_s, q_e = held(s + moving[1] * delay), held(e + moving[2] * delay)
        gaps.append(n)
        rows = zip(law(pace, turn), falls, aside, around, strict=True)
        found.append((q_s, q_e, *(held(y + delay * f - q_s * a - q_e * b) for y, f, a, b in rows)))
    return Growth(here, found, weighted_sum(gaps, EACH), impact.after(moving, turning))


def contact_errors(flight: Parabola, impact: Impact) -> dict[str, sp.Expr]:
    """Return the bounds after a contact from those at the departure before it, with the lemma.

    Arguments of the formulas are the state before the impact, its normal and frame, the time t of
    the flight, and the bounds and the frame of the departure.

    Parameters
    ----------
    flight
        The motion between contacts.
    impact
        The impact, with the law's effect on errors.
    """
    grows = growth(flight, impact)
    rest = impact.rest(Arrival(flight, impact.ball, grows.here, grows.gap))
    pairs = zip(grows.times(EACH)[:SIZE], rest.extras, strict=True)
    return grows.errors_after(impact.ball, [value + extra for value, extra in pairs], rest)


class Arrival:
    """Bounds at a contact before its impact: roundings, the second order, and T's own roundings.

    Parameters
    ----------
    flight
        The motion between contacts.
    ball
        The ball.
    here
        The frame of the contact.
    gap
        The distance from the surface at the computed time that errors at the start cause.

    Attributes
    ----------
    here
        The frame of the contact.
    moving, turning
        The components of velocity and spin.
    size, spinning, nearing
        Sums of the sizes of velocity and of spin, and V.
    late, change, turn, drift, belated, place, tilt
        S, a, N, E S + g S²/2, d²t, d²c and d²n of the lemma in `second_order`.
    beyond
        What is added to the bounds of q_s and q_e besides `own`.
    turned
        The angle that `beyond` makes.
    summed, spun
        Bounds on the parts of errors of velocity and spin that turn at the start, and W with them.
    own, paces, turns
        Roundings of flight and root: of q_s and q_e, and what they make of y and of the spin, n, s
        and e.
    level, longer
        B_n, and by how much the normal is longer or shorter than 1 off the surface.
    pull
        g d²t.
    excess
        At most zero if the lemma in `second_order` holds.
    """

    def __init__(self, flight: Parabola, ball: Ball, here: Frame, gap: sp.Expr) -> None:
        self.here = here
        places, speeds = flight_roundings(flight)
        self.moving, self.turning = moving, turning = here.of_motion()
        self.size = size = barrier(sum(map(absolute, velocity)))
        self.spinning = spinning = barrier(sum(map(absolute, spin)))
        self.nearing = nearing = barrier(absolute(normal_velocity))
        p, e, w = NORMS
        # As in `second_order`: bounds on errors before the contact, and what they can make.
        off = barrier(p + e * t + barrier(sum(places)) + maximum(root_offset, root_level))
        sped = barrier(e + speeds)
        bent = barrier(remainder.BEND * barrier(sharpest_bend * off) * off)
        # In the turned motion at the start products may cancel.
        left_turn = barrier(LEFT_BENDS[0] * BOUNDS[1] + LEFT_BENDS[1] * BOUNDS[2])
        self.summed = summed = barrier(barrier(size + flight.strength * t) * left_turn)
        self.spun = barrier(w + spinning * left_turn)
        blur = barrier(T_ROUNDING * barrier(off + summed * t))
        apart = barrier(gap + root_offset + bent + blur)
        self.late = late = barrier(remainder.STRETCH * apart / nearing)
        self.change = change = barrier(sped + flight.strength * late)
        way = barrier(off + barrier(size + change) * late)
        self.turn = turn = barrier(remainder.BEND * sharpest_bend * way)
        self.drift = drift = barrier(sped * late + flight.strength * late**2 / 2)
        self.belated = belated = barrier(barrier(drift + barrier(turn * way)) / nearing)
        self.place = place = barrier(size * belated + drift)
        self.tilt = barrier(remainder.BEND * sharpest_bend * place + 2 * turn**2)
        falling = absolute(here.of_vector(flight.acceleration)[0])
        slowed = barrier(sped + falling * late + turn * barrier(size + change))
        self.beyond = barrier(place + T_ROUNDING * way + blur)
        self.turned = barrier(barrier(here.bends[0] + here.bends[1]) * self.beyond)
        # Roundings: of flight and root, of the normal, of its length off the surface.
        normals, *along = (
            barrier(sum(absolute(c) * r for c, r in zip(here.axes.row(k), places, strict=True)))
            for k in range(3)
        )
        delay = barrier(barrier(root_offset + blur) / nearing)
        self.own = own = [
            barrier(r + absolute(v) * delay) for r, v in zip(along, moving[1:], strict=True)
        ]
        paces, self.turns = (
            [
                barrier(absolute(s) * own[0] + absolute(e) * own[1])
                for s, e in zip(*them, strict=True)
            ]
            for them in (here.turned(moving), here.turned(turning))
        )
        self.paces = [barrier(pace + speeds + flight.strength * delay) for pace in paces]
        self.level = barrier(normals + root_level + place)
        self.longer = longer = barrier(here.bends[0] * self.level)
        self.pull = flight.strength * belated
        self.excess = maximum(
            barrier(12 * slowed - nearing),
            barrier(100 * barrier(sharpest_bend * way) - 1),
            barrier(MOST_LENGTHS * barrier(longer + LEFT_BENDS[0] * BOUNDS[0]) - 1),
        )


@dataclass(frozen=True)
class Rest:
    """Terms beside |T| B at a contact.

    Attributes
    ----------
    arrival
        The bounds before the impact.
    speed_after, spin_after
        Bounds on the sizes of velocity and spin after the contact.
    extras
        What is added to the bounds of q_s, q_e, y_n, y_s, y_e and y_w.
    unrolled
        What is added to the bounds of both components of y_z.
    excess
        At most zero if all lemmas hold.
    """

    arrival: Arrival
    speed_after: sp.Expr
    spin_after: sp.Expr
    extras: Sequence[sp.Expr]
    unrolled: sp.Expr
    excess: sp.Expr


class Impact(ABC):
    """The errors after a contact that its law makes of those before it.

    Attributes
    ----------
    ball
        The ball.
    """

    ball: Ball

    @abstractmethod
    def law(self, pace: Vector, turn: Vector) -> list[sp.Expr]:
        """Return the derivative of the law along a change: y_n, y_s, y_e and y_w after it.

        With friction they are followed by y_z along s and e.

        Parameters
        ----------
        pace, turn
            The change of velocity and spin before the impact.
        """

    @abstractmethod
    def after(self, moving: Vector, turning: Vector) -> tuple[Vector, Vector]:
        """Return velocity and spin after the impact.

        Parameters
        ----------
        moving, turning
            Those before it.
        """

    @abstractmethod
    def rest(self, arrival: Arrival) -> Rest:
        """Return the terms beside |T| B.

        Parameters
        ----------
        arrival
            The bounds before the impact.
        """


@dataclass(frozen=True)
class NoSlipImpact(Impact):
    """The impact without slip.

    Attributes
    ----------
    ball
        The ball.
    restitution
        e.
    """

    ball: Ball
    restitution: sp.Expr

    def law(self, pace: Vector, turn: Vector) -> list[sp.Expr]:
        """Return -e v_n, what stays of the velocity with what friction gives, and w_n."""
        stays, gives = self.ball.moving_share, barrier(self.ball.friction_share * self.ball.radius)
        return [
            held(-self.restitution * pace[0]),
            held(stays * pace[1] + gives * turn[2]),
            held(stays * pace[2] - gives * turn[1]),
            turn[0],
        ]

    def after(self, moving: Vector, turning: Vector) -> tuple[Vector, Vector]:
        """Return the law of the motion, which is linear, and the spin with which the ball rolls."""
        leaving = _vector(self.law(moving, turning)[:3])
        per_radius = barrier(1 / self.ball.radius)
        rolling = (turning[0], barrier(-leaving[2] * per_radius), barrier(leaving[1] * per_radius))
        return leaving, rolling

    def rest(self, arrival: Arrival) -> Rest:
        """Return the terms of the lemma in `second_order`, and those of 14 roundings."""
        ball, restitution, here = self.ball, self.restitution, arrival
        stays, per_radius = ball.moving_share, barrier(1 / ball.radius)
        both, rubbed = barrier(stays + restitution), barrier(ball.friction_share * ball.radius)
        size, spinning, nearing = here.size, here.spinning, here.nearing
        change, turn, tilt, turned = here.change, here.turn, here.tilt, here.turned
        own, paces, turns, longer = here.own, here.paces, here.turns, here.longer
        w = NORMS[2]
        speed_after = barrier(size + ball.radius * spinning)
        spin_after = barrier(size * per_radius + spinning)
        # The second order, and the roundings of T.
        products = barrier(
            2 * barrier(change + here.summed)
            + barrier(4 * size + ball.radius * spinning) * turn
            + ball.radius * here.spun
        )
        curved = barrier(
            speed_after * turned
            + here.pull
            + barrier(2 * both * size + rubbed * spinning) * tilt
            + barrier(2 * both * change + rubbed * w) * turn
            + both * barrier(size + change) * turn**2
            + T_ROUNDING * products
        )
        curved_spin = barrier(
            spin_after * turned
            + barrier(stays * size * per_radius + 2 * spinning) * tilt
            + barrier(stays * per_radius * change + 2 * w) * turn
            + barrier(spinning + w) * turn**2
            + barrier(here.pull + T_ROUNDING * products) * per_radius
            + T_ROUNDING * barrier(spinning * turn + here.spun)
        )
        # Roundings: of the normal, of its length off the surface, of the law.
        law = barrier(LAW_ROUNDINGS * UNIT_ROUNDOFF * speed_after + FLOOR)
        rubbing = barrier(rubbed * spinning * barrier(normal_rounding + longer))
        across = barrier(law + both * nearing * normal_rounding + rubbing + curved)
        extras = (
            own[0] + here.beyond,
            own[1] + here.beyond,
            restitution * paces[0]
            + both * barrier(barrier(size + nearing) * normal_rounding + 2 * nearing * longer)
            + barrier(law + rubbing + curved),
            stays * paces[1] + rubbed * turns[2] + across,
            stays * paces[2] + rubbed * turns[1] + across,
            turns[0]
            + stays * barrier(size * per_radius * normal_rounding)
            + 2 * barrier(spinning * barrier(normal_rounding + longer))
            + law * per_radius
            + curved_spin,
        )
        rolled = barrier(
            stays * barrier(sum(map(absolute, here.moving[1:]))) * per_radius + spinning
        )
        unrolled = (
            barrier(maximum(*paces) * per_radius + maximum(*turns))
            + 2 * barrier(rolled * barrier(normal_rounding + longer))
            + barrier(law + across) * per_radius
            + curved_spin
        )
        return Rest(arrival, speed_after, spin_after, extras, unrolled, arrival.excess)


def _late(flight: Parabola, off: sp.Expr, sped: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return S on a plane for a ball that is off by so much, and what has to be at most zero."""
    nearing = barrier(absolute(normal_velocity))
    late = barrier(remainder.STRETCH * off / nearing)
    return late, barrier(12 * barrier(sped + flight.strength * late) - nearing)


def errors_at_end(flight: Parabola) -> dict[str, sp.Expr]:
    """Return P, E and W where a flight of time t crosses the end plane, and the delay.

    Both balls are there at their own times. Arguments of the formulas are as in `contact_errors`.

    Parameters
    ----------
    flight
        The motion between contacts.
    """
    p, e, w = NORMS
    places, speeds = flight_roundings(flight)
    off = barrier(p + e * t + barrier(sum(places)) + root_offset)
    sped = barrier(e + speeds)
    late, holds = _late(flight, off, sped)
    change = barrier(sped + flight.strength * late)
    size = barrier(sum(map(absolute, velocity)))
    values = (off + barrier(size + change) * late, change, w)
    found = {
        s.name: IfAtMost(holds, 0, ROUNDING_SLACK * barrier(value), sp.oo)
        for s, value in zip(NORMS, values, strict=True)
    }
    delay = IfAtMost(holds, 0, ROUNDING_SLACK * late, sp.oo)
    return found | {"delay": delay + 4 * UNIT_ROUNDOFF * barrier(clock + t)}


def errors_at_time(flight: Parabola) -> dict[str, sp.Expr]:
    """Return P, E and W at the end of a flight of time t that a time limit ends.

    The flight is too short or too long by the errors of the contacts' times; the time of its end
    is exact.

    Parameters
    ----------
    flight
        The motion between contacts.
    """
    p, e, w = NORMS
    places, speeds = flight_roundings(flight)
    shift = barrier(clock_error + 4 * UNIT_ROUNDOFF * barrier(clock + t))
    change = barrier(e + speeds + flight.strength * shift)
    size = barrier(sum(map(absolute, velocity)))
    values = (
        p + e * t + barrier(sum(places)) + barrier(size + change) * shift,
        change,
        w,
    )
    found = {
        s.name: ROUNDING_SLACK * barrier(value) for s, value in zip(NORMS, values, strict=True)
    }
    return found | {"clock_error": sp.Integer(0)}


def unbounded() -> dict[str, sp.Basic]:
    """Return whether a bound is not finite, which no later decision may notice."""
    finite = all_of(*(Less(bound, sp.oo) for bound in (*NORMS, clock_error)))
    return {"unbounded": Not(finite)}


def error_bounds() -> dict[str, sp.Expr]:
    """Return the bounds on the errors of a state and its time: the norms that are carried."""
    names = ("position_error", "velocity_error", "spin_error", "time_error")
    return dict(zip(names, (*NORMS, clock_error), strict=True))
