"""Where bounces have accumulated, and what happens to a ball in contact: decisions and bounds.

A ball that leaves a surface with the speed V off it, and is pressed onto it by N per unit mass,
comes back after 2 V/N with the speed V, and leaves with e V. Infinitely many such bounces take the
finite time 2 V/(N (1 - e)), in which nothing changes by more than V says. Then the ball rolls. A
ball that is taken for rolling from the bounce V on is off by 2 F V²/(N² (1 - e²)) along F in the
limit; here twice that counts, the height of the hop, and what is left of the slip. As soon as all
of it is less than `tolerance`, the ball rolls.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ..contact.law import Law
from ..errors.tangent import clock, directional, dv, dw, dx, late, left_normal, started
from ..flight import rolling
from ..flight.parabola import Parabola
from ..ground.choice import (
    AtMost,
    Choose,
    Either,
    Equal,
    IfLess,
    Less,
    Not,
    Nowhere,
    Truth,
    every,
    hold,
    largest,
    size,
    smallest,
    some,
)
from ..ground.kernel import Kernel, symbols_in
from ..ground.rounding import position_error, velocity_error
from ..ground.symbols import (
    POSITION,
    UNIT_ROUNDOFF,
    VELOCITY,
    normal,
    position,
    spin,
    velocity,
)
from ..search.approach import first_root
from ..search.decisions import clear, doubt, index, last, when, which
from ..surfaces import Surface
from .fields import IN_FLIGHT, NONE

held, mode, nearest, near = sp.symbols("held mode nearest near", real=True)
"""The surface that the ball stays in contact with; how it goes on; the distance to what is next to
it; and how wide a seam is."""
BEGINS, ROLLS, LEAVES = 1, 2, 3
"""What a ball in contact does next; 0: it is in flight."""

stride, strongest, fastest = sp.symbols("stride strongest fastest", nonnegative=True)
missed = sp.Symbol("missed", nonnegative=True)
"""What the series of a step leaves out of the velocity, m/s."""
force, force_rate, force_bend, brace = sp.symbols("force force_rate force_bend brace", real=True)
spare = sp.Symbol("spare", nonnegative=True)
"""How long a ball that leaves a surface certainly meets nothing else."""
gap, nearing, dent, lift, surge, snap = sp.symbols("gap nearing dent lift surge snap", real=True)
turning = sp.Matrix(sp.symbols("turning_x turning_y turning_z", real=True))
"""The rate at which the normal turns, n'."""
rolled = sp.Matrix(sp.symbols("rolled_x rolled_y rolled_z", real=True))
"""The velocity that a contact which grips would leave."""
slip, bounce = sp.symbols("slip bounce", real=True)
press, weight, drag, swerve, facing = sp.symbols("press weight drag swerve facing", real=True)
thrust = sp.Matrix(sp.symbols("thrust_x thrust_y thrust_z", real=True))
"""Forces on a ball that rolls on, per unit mass: the normal force, the free fall along the normal,
the size of friction; its acceleration; the second derivative of a distance then, and its rate along
the normal of what the ball is on, the cosine of the angle between two normals."""
wedge = sp.Symbol("wedge", real=True)
"""How far the ball gets, at most, from what it is pressed onto besides."""
settles, lodges, unsure, ends, rests, edge, goes_on, slides, parts = map(
    Truth,
    ("settles", "lodges", "unsure", "ends", "rests", "edge", "rolling", "slides", "parts"),
)
nearly = Truth("nearly")
"""Whether a bounce is so small that it may be the last before the ball rolls."""
body, reached, outcome, uncertain, assured, time_limit, began, rolls = sp.symbols(
    "body reached outcome uncertain assured time_limit began rolls", real=True
)

FAR = sp.Rational(1, 2**22)
"""How far, by the ball's radius, a neighbouring motion begins that shows what errors grow to."""


def made(name: str, outputs: Mapping[str, sp.Basic], summary: str, equation: str) -> Kernel:
    """Return a kernel whose arguments come in the order of their names."""
    sympified = {key: sp.sympify(value) for key, value in outputs.items()}
    free = sorted(symbols_in(sympified.values()), key=lambda symbol: symbol.name)
    return Kernel(name, tuple(free), tuple(sympified.items()), summary, equation)


class Codes:
    """The numbers of what can happen to a ball in contact, after those of surfaces and time."""

    def __init__(self, surfaces: int, bodies: int) -> None:
        self.time = surfaces
        self.begins, self.leaves, self.hops = surfaces + 1, surfaces + 2, surfaces + 3
        self.endless = surfaces + 4
        self.bodies = bodies

    def row(self, own: sp.Expr, leaves: bool) -> sp.Expr:
        """Return what stands for a body in the log where a contact with it begins or ends."""
        return self.bodies + 1 + 2 * own + int(leaves)


def settling(law: Law, ball_radius: sp.Expr) -> Kernel:
    """Return whether a ball that has bounced stays on the surface from now on.

    Or whether its bounces end with slip left: all that friction can still take is less, or it is
    too little for the ball to roll.
    """
    e = law.restitution_at(sp.Integer(0))
    left = hold(1 - e)
    loss = hold(left * (1 + e))
    speed = hold(sum(map(size, rolled)) + ball_radius * hold(sum(map(size, spin))))
    hop = hold(bounce / press)
    astray = hold(
        4 * drag * hop**2 / loss + hop * bounce / 2 + 4 * rolling.SHARE * hop * slip / left
    )
    allowed = hold(tolerance(ball_radius))
    quick = hold(speed + sp.sqrt(hold(size(weight) * ball_radius)))
    turns = hold(hold(sp.Add(*map(size, turning))) + 4 * UNIT_ROUNDOFF)
    swing = hold(8 * hold(size(weight) + speed * turns) * turns)
    steady = Less(hold(3 * hop * swing), hold(press * left**2))
    little = sp.Rational(1, 2**46) * quick
    slid = AtMost(slip, hold(hold(8 * drag * hop) + little))
    presses = every(Less(0, press), Less(0, left), steady, slid)
    least = hold(near_by(ball_radius))
    rest = hold(16 * hop * speed / left)
    alone = Less(hold(rest + least), nearest)
    wedged = AtMost(wedge, least)
    # With slip left the ball is pressed on by another force than rolling would have.
    firm = hold(smallest(press, -lift))
    skip = hold(bounce / firm)
    bounces_on = every(
        Less(0, firm),
        Less(0, left),
        Less(hold(3 * skip * swing), hold(firm * left**2)),
        Less(hold(hold(16 * skip * speed / left) + least), nearest),
    )
    slides: sp.Basic = Nowhere()
    torn: sp.Basic = Nowhere()
    if law.coefficient != sp.oo:
        share = hold(law.coefficient * (1 + e))
        most, asked = hold(share * press), 2 * drag
        presses = every(presses, AtMost(asked, most))
        # Without a bounce an infinite friction takes nothing, either.
        takes = hold(IfLess(0, bounce, hold(share * bounce), 0) + hold(2 * drag * skip))
        # A contact that grips leaves some roundings of the speed before it; the next takes those.
        stopped = hold(hold(2 * takes / (rolling.SHARE * left)) + sp.Rational(1, 2**36) * quick)
        moved = hold(4 * drag * skip**2 / loss + skip * bounce / 2)
        over = every(bounces_on, AtMost(moved, allowed))
        slides = every(over, Either(Less(stopped, slip), Less(most, asked)))
        off = hold(16 * velocity_error)
        torn = every(
            over,
            Either(
                Less(size(slip - stopped), off),
                Less(size(asked - most), hold(hold(turns + share * turns) * off)),
            ),
        )
    stays = every(presses, AtMost(astray, allowed))
    # Next to something that does not hold it the ball rolls where it is, as soon as it hardly
    # moves until the bounces end; what it would touch first meanwhile is in doubt.
    still = AtMost(rest, least)
    near_zero = AtMost(size(press), hold(4 * turns * velocity_error))
    close = hold(size(astray - allowed) * bounce)
    vague = every(AtMost(close, hold(2 * allowed * velocity_error)), Less(0, bounce))
    return made(
        f"{law.name}_settling",
        {
            "settles": every(stays, Not(wedged), Either(alone, still)),
            "lodges": every(stays, wedged),
            "slides": slides,
            "parts": every(AtMost(bounce, little), AtMost(0, lift)),
            "assured": Choose(Either(every(presses, alone), bounces_on), 1, 0),
            "unsure": some(near_zero, vague, torn, every(stays, still, Not(alone))),
        },
        "Where a ball stays on a surface, slides on it or leaves it: its bounces end before "
        "anything else can happen, and from when on that is certain.",
        "a geometric series of bounces",
    )


def near_by(ball_radius: sp.Expr) -> sp.Expr:
    """Return how far from a ball the other surface may be between which two it is wedged, m."""
    return sp.Rational(1, 2**28) * ball_radius


def _pressed_on(acceleration: Sequence[sp.Expr], ball_radius: sp.Expr) -> Kernel:
    """Return the forces on a ball that rolls on from the surface it has touched."""
    turn_rate = ball_radius * hold(spin.dot(normal))
    down = sp.Matrix(list(acceleration))
    pressing = hold(down.dot(normal))
    n = hold(hold(-pressing) - hold(rolled.dot(turning)))
    along = down - pressing * normal
    twisted = normal.cross(turning)
    friction = [
        hold(rolling.SHARE * (turn_rate * m - a)) for a, m in zip(along, twisted, strict=True)
    ]
    pushed = [hold(a + n * c + f) for a, c, f in zip(down, normal, friction, strict=True)]
    return made(
        "pressed_on",
        {
            "press": n,
            "weight": pressing,
            "drag": hold(sp.sqrt(hold(sum(c**2 for c in friction)))),
            **dict(zip(map(str, thrust), pushed, strict=True)),
        },
        "Normal force, its part of the free fall, friction and acceleration of a ball that rolls.",
        "N = -a·n - v·n', F = beta (-a_t + s n × n')",
    )


def tolerance(ball_radius: sp.Expr) -> sp.Expr:
    """Return what a ball may be off by that is taken for rolling, m; its errors grow by as much.

    It does not depend on the errors that the ball carries, so that the path is the same where none
    are bounded. With half a picometre 250 of 2,000 settled shots are flagged; with four times as
    much an eighth more are, with a quarter less than a tenth fewer, for 6 to 9% of their time.
    """
    return sp.Rational(1, 2**38) * ball_radius


def small_hop(strength: sp.Expr, ball_radius: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return two numbers; the first is less where half a hop's height is less than `tolerance`.

    They are the square of the speed at which a ball leaves a surface, and twice the tolerance times
    what can press the ball onto it, per unit mass.
    """
    off = hold(velocity.dot(normal))
    quick = hold(velocity.dot(velocity)) / ball_radius
    return hold(off**2), hold(2 * tolerance(ball_radius) * hold(strength + quick))


def kernels(
    flight: Parabola,
    ball_radius: sp.Expr,
    faces: Sequence[int],
    codes: Codes,
    outcomes: Mapping[str, int],
) -> dict[str, Kernel]:
    """Return what all surfaces share."""
    strength = hold(flight.strength)
    acceleration = flight.acceleration
    series = [
        made(
            f"roll_{k}",
            rolling.following(k, acceleration),
            f"The terms of order {k + 1} of a ball that rolls, from those before.",
            "Newton, Euler and rolling without slip",
        )
        for k in range(rolling.ORDER)
    ]
    others = (
        made(
            "anew",
            {str(n): 0 for n in left_normal},
            "A ball that has come from elsewhere.",
            "Table 1",
        ),
        made("started", started(flight), "Where a flight began.", "Eq. 3"),
        made("roll_start", rolling.start(ball_radius), "The constant terms.", "rolling"),
        made("roll_moved", rolling.moved(), "Where a rolling ball is at time t.", "its series"),
        made(
            "roll_placed",
            rolling.placed(ball_radius),
            "A ball put onto a surface, rolling.",
            "v = R_B (w × n)",
        ),
        made(
            "roll_pace",
            rolling.pace(acceleration, strength),
            "A step of the series, bounds of the motion in it, and the normal force.",
            "the last terms of the series",
        ),
        _turned(ball_radius),
        _pressed_on(acceleration, ball_radius),
        *_starting(strength, ball_radius),
        *_stepping(strength, ball_radius, codes),
        *_parting(strength),
        *_neighbour(ball_radius),
        *_events(faces, codes, outcomes),
    )
    return {kernel.name: kernel for kernel in (*series, *others)}


def _turned(ball_radius: sp.Expr) -> Kernel:
    return made(
        "roll_turn_rate",
        {"turn_rate": ball_radius * hold(spin.dot(normal))},
        "The spin about the normal, times the ball's radius.",
        "s = R_B (w·n)",
    )


def _starting(strength: sp.Expr, ball_radius: sp.Expr) -> tuple[Kernel, ...]:
    off = hold(velocity.dot(normal))
    # A ball settles when half a hop's height is tolerated, under whatever presses it. Errors ask
    # from much earlier on whether its bounces end there.
    closely = Less(*small_hop(strength, ball_radius))
    hardly = Less(hold(off**2), sp.Rational(1, 2**23) * ball_radius)
    across = hold_each(velocity - off * normal)
    sliding = hold_each(sp.Matrix(across) - ball_radius * spin.cross(normal))
    kept = [hold(v - rolling.SHARE * u) for v, u in zip(across, sliding, strict=True)]
    grown = tolerance(ball_radius)
    rate = hold(sum(map(size, velocity)) / ball_radius)
    errors: dict[str, sp.Expr] = {}
    for names, unit in (
        (dx, grown),
        (dv, hold(grown * 4 * (1 + rate))),
        (dw, hold(grown * 4 * (1 + rate)) / ball_radius),
    ):
        errors |= {str(d): d + IfLess(d, 0, -unit, unit) for d in names}
    return (
        made(
            "slowed",
            {
                "slow": some(closely, every(hardly, Less(0, position_error))),
                "assured": 0,
            },
            "Where a ball hardly leaves the surface that it has touched, and is looked at.",
            "a hop of less than a micrometre",
        ),
        made("unslowed", {"slow": Nowhere()}, "A ball that has touched nothing.", "Table 1"),
        made(
            "nearly",
            {"nearly": closely},
            "Where its bounces are so small that this may be the last.",
            "half a hop's height",
        ),
        made(
            "gripped",
            dict(zip(map(str, rolled), kept, strict=True))
            | {"slip": hold(sp.sqrt(hold(sum(u**2 for u in sliding)))), "bounce": largest(0, off)},
            "The velocity of a ball whose contact point stops; its slip, and how fast it leaves.",
            "the momenta that a contact keeps",
        ),
        made(
            "alone",
            {"nearest": sp.oo, "wedge": sp.oo},
            "Nothing next to the ball.",
            "Table 1",
        ),
        made("neared_body", _beside_contact(), "A body next to a ball that rolls on.", "Table 1"),
        made(
            "neared",
            {"nearest": smallest(nearest, size(gap))},
            "The distance to what is next to the ball.",
            "Table 1",
        ),
        made("begun_errors", errors, "What a jump to the end of the bounces adds.", "its bound"),
    )


def _beside_contact() -> dict[str, sp.Basic]:
    """Return what a body means that is next to a ball which rolls on: it may hold the ball, too.

    Onto what it is pressed the ball falls back: the top of its hop is how far it gets. What it
    rolls away from does not hold it, nor what it touches with the same normal, as where the ring's
    top goes over into the bridge's: it rolls from one to the other. Where it is neither, as in the
    corner between bridge and board, it is as if hardly pressed.
    """
    pull = hold(largest(size(swerve), sp.Rational(1, 2**20) * press))
    top = hold(size(gap) + nearing**2 / (2 * pull))
    held_too = every(
        Less(swerve, sp.Rational(1, 2**40) * press), Less(facing, 1 - sp.Rational(1, 2**20))
    )
    return {
        "nearest": smallest(nearest, size(gap)),
        "wedge": smallest(wedge, Choose(held_too, top, sp.oo)),
    }


def hold_each(vector: sp.Matrix) -> list[sp.Expr]:
    """Return the components, each held."""
    return [hold(component) for component in vector]


def _stepping(strength: sp.Expr, ball_radius: sp.Expr, codes: Codes) -> tuple[Kernel, ...]:
    per = rolling.per_reach
    pull = hold(strength + fastest**2 * size(per))
    small = hold(sp.Rational(1, 2**44) * pull)
    off = hold(small + 8 * size(per) * hold(pull * position_error + fastest * velocity_error))
    bends = hold(force_bend + sp.Rational(1, 2**40) * pull)
    spent = some(Less(force, -small), every(AtMost(force, small), Less(force_rate, 0)))
    # A flight from there opens the gap as -(N' + 2 F·n') t³/6 - N t²/2. Where that is pressed on
    # again, the ball is held on until -N opens it.
    surging = hold(-force_rate - brace)
    quickness = hold(size(per) * hold(fastest**2 * size(per) + strength))
    held_by = hold(IfLess(surging, 0, surging**2 / hold(strength * quickness), 0))
    holds = every(spent, Less(small, hold(force + held_by)))
    leaves = every(spent, Not(holds))
    still = sp.Rational(1, 2**44)
    pulled = sum(size(rolling.term(v, 1)) for v in rolling.SERIES[:3])
    stopped = every(
        AtMost(hold(sum(map(size, velocity))), still * hold(sp.sqrt(hold(strength * ball_radius)))),
        AtMost(hold(pulled), still * strength),
    )
    room = hold(
        2 * position_error + sp.Rational(1, 2**47) * hold(sum(map(size, position)) + ball_radius)
    )
    landing = hold(sp.Rational(1, 2**47) * hold(sum(map(size, position)) + ball_radius))
    reach = hold(strongest + dent * fastest**2)
    meets = every(AtMost(gap, landing), Less(nearing, 0))
    crosses = every(meets, AtMost(-landing, gap))
    at = every(
        AtMost(gap, room), AtMost(-room, gap), Not(Less(hold(8 * reach * room), hold(nearing**2)))
    )
    first = Equal(which, NONE)

    def found(condition: sp.Basic, where: sp.Expr) -> sp.Expr:
        return Choose(every(condition, first), where, which)

    def stopping(condition: sp.Basic, root: sp.Expr) -> sp.Expr:
        return Choose(condition, 0, smallest(stride, root))

    above = hold(largest(gap, 0))
    # One that it touches and does not near, as where a ball rolls from one surface onto another,
    # may be as near as that for a moment.
    clear = hold(Choose(AtMost(gap, landing), tolerance(ball_radius), gap))
    to_gate = Choose(Less(0, gap), first_root(above, nearing, reach), sp.oo)
    delay = hold(2 * room / hold(size(nearing)))
    return (
        made(
            "leaving_force",
            {
                "stride": stopping(
                    some(leaves, stopped),
                    first_root(
                        hold(Choose(holds, hold(force + held_by), largest(force, 0))),
                        force_rate,
                        bends,
                    ),
                ),
                "which": found(leaves, sp.Integer(codes.leaves)),
                "rests": every(stopped, Not(leaves)),
                "doubt": Choose(
                    some(
                        holds,
                        every(
                            AtMost(size(force), off),
                            Not(Less(hold(8 * bends * off), force_rate**2)),
                        ),
                    ),
                    0,
                    doubt,
                ),
            },
            "Where the normal force is spent, or nothing moves; else how long it certainly lasts.",
            "N = 0",
        ),
        made(
            "beside_body",
            {
                "stride": stopping(meets, first_root(clear, nearing, reach)),
                "which": found(meets, index),
                "doubt": Choose(some(at, every(meets, Not(first))), 0, doubt),
                "late": Choose(every(meets, first), delay, late),
            },
            "Where a rolling ball meets another surface; else how long it certainly does not.",
            "a parabola below the distance",
        ),
        made(
            "beside_gate",
            {
                "stride": stopping(crosses, to_gate),
                "which": found(crosses, index),
                "doubt": Choose(some(at, every(crosses, Not(first))), 0, doubt),
                "late": Choose(every(crosses, first), delay, late),
            },
            "The same of a plane that ends a shot, which counts from above.",
            "a parabola below the distance",
        ),
        made(
            "beside_seam",
            {
                "stride": smallest(
                    stride,
                    first_root(
                        Choose(AtMost(size(gap), near), 0, size(gap)),
                        Choose(
                            AtMost(size(gap), near),
                            size(nearing) + sp.Rational(1, 2**20) * fastest,
                            Choose(Less(0, gap), nearing, -nearing),
                        ),
                        hold(strongest),
                    ),
                )
            },
            "How long a rolling ball certainly stays on a part of its surface.",
            "a parabola below the distance",
        ),
        made(
            "beside_time",
            {
                "stride": largest(0, smallest(stride, hold(time_limit - clock))),
                "which": found(Not(Less(clock, time_limit)), sp.Integer(codes.time)),
            },
            "The time limit.",
            "Table 1",
        ),
        made(
            "rolled_on",
            {
                "clock": clock + stride,
                "rolling": every(Equal(which, NONE), Not(rests)),
            },
            "The time after a step, and whether there is a next one.",
            "Table 1",
        ),
    )


def _parting(strength: sp.Expr) -> tuple[Kernel, ...]:
    """A ball that leaves tangentially: for a while the gap certainly opens.

    Its third derivative is at least surge - |snap| t - C t²/2, with a generous C; a ball that is
    thrown off has a second derivative to begin with.
    """
    per = hold(size(rolling.per_reach))
    shortest = sp.Rational(1, 2**7)
    speed = hold(sum(map(size, velocity)) + strength * shortest)
    # Of a body that it touches and moves away from, too, it is free for a while.
    dipping = hold(strength + dent * speed**2)
    away_from = Choose(Less(0, gap), nearing, -nearing)
    unmet = hold(smallest(spare, first_root(hold(largest(gap, 0)), nearing, dipping)))
    rate = hold(speed * per + sp.sqrt(hold(strength * per)) + 1)
    bends = hold(64 * rate**3 * hold(strength + speed**2 * per))
    bent = hold(size(snap) + bends * sp.Rational(1, 2**30))
    opening = smallest(hold(surge / (2 * bent)), hold(sp.sqrt(hold(surge / (2 * bends)))))
    push = hold(largest(0, lift))
    tearing = smallest(
        hold(push / hold(4 * size(surge) + bends * sp.Rational(1, 2**30))),
        hold(sp.sqrt(hold(push / (2 * bent)))),
        hold(sp.sqrt(hold(push / (bends * shortest)))),
    )
    away = hold(Choose(Less(0, surge), opening, tearing))
    hop = hold(smallest(shortest, away, hold(spare / 4)))
    off = hold(
        16 * per * hold(hold(strength + speed**2 * per) * position_error + speed * velocity_error)
        + sp.Rational(1, 2**44) * strength
    )
    opens = some(Less(hold(off * rate), surge), Less(off, lift))
    return (
        made("unmet", {"spare": sp.oo}, "Nothing next to the ball.", "Table 1"),
        made("spared", {"spare": unmet}, "What it meets first.", "a parabola below the distance"),
        made(
            "spared_seam",
            {
                "spare": Choose(
                    AtMost(size(gap), near),
                    spare,
                    hold(smallest(spare, first_root(size(gap), away_from, strength))),
                )
            },
            "How long it stays off one part of the surface: there the distance bends anew.",
            "a parabola below the distance",
        ),
        made(
            "parted",
            {
                "when": largest(0, hop),
                "doubt": Choose(opens, doubt, 0),
            },
            "How long a ball that leaves a surface certainly does not meet it, nor anything else.",
            "Taylor's theorem of the gap",
        ),
    )


def _neighbour(ball_radius: sp.Expr) -> tuple[Kernel, ...]:
    def greatest(errors: Sequence[sp.Symbol]) -> sp.Expr:
        return hold(largest(*map(size, errors)))

    eighth = sp.Rational(1, 8)
    worst = hold(
        greatest(dx)
        + eighth * hold(greatest(dv) + ball_radius * greatest(dw))
        + UNIT_ROUNDOFF * ball_radius
    )
    scale = FAR * ball_radius / worst
    apart = sp.Symbol("apart", positive=True)
    states = (*position, *velocity, *spin)
    errors = (*dx, *dv, *dw)
    far = {f"far_{s}": s + apart * d for s, d in zip(states, errors, strict=True)}
    far |= {f"far_{s}": sp.Integer(0) for s in (*normal, gap)}
    place = hold(4 * UNIT_ROUNDOFF * hold(sum(map(size, position)) + ball_radius))
    pace = hold(
        4
        * UNIT_ROUNDOFF
        * hold(sum(map(size, velocity)) + ball_radius * hold(sum(map(size, spin))))
    )
    compared = {}
    off = hold(pace + missed)
    rounds = (hold(place + missed * stride),) * 3 + (off,) * 3 + (off / ball_radius,) * 3
    for s, d, unit in zip(states, errors, rounds, strict=True):
        change = hold(hold(sp.Symbol(f"far_{s}", real=True) - s) / apart)
        compared[str(d)] = change + IfLess(change, 0, -unit, unit)
    carried = {}
    speeds = dict(zip(dx, zip(dv, velocity, position, strict=True), strict=True))
    for d, (drift, v, p) in speeds.items():
        moved = hold(d + drift * when)
        unit = UNIT_ROUNDOFF * hold(size(p) + 2 * size(v) * when)
        carried[str(d)] = moved + IfLess(moved, 0, -unit, unit)
    return (
        made("apart", {"apart": scale}, "How often an error makes a neighbouring motion.", "FAR"),
        made("neighbour", far, "A neighbouring motion, along the errors.", "Table 1"),
        made(
            "compared",
            compared,
            "The errors after a step, with what it rounds and leaves out.",
            "differences",
        ),
        made("carry_hop", carried, "Errors after a while of flight.", "derivative of Eq. 3"),
    )


def _events(faces: Sequence[int], codes: Codes, outcomes: Mapping[str, int]) -> tuple[Kernel, ...]:
    lodged, capped = outcomes["lodged"], outcomes["capped"]
    own: sp.Expr = sp.Integer(NONE)
    for face, of in enumerate(faces):
        own = Choose(Equal(held, face), of, own)
    begins, leaves, hops = (Equal(which, code) for code in (codes.begins, codes.leaves, codes.hops))
    beyond, for_ever = Less(codes.time, which), Equal(which, codes.endless)
    bounded = every(Less(position_error, sp.oo), Less(velocity_error, sp.oo))
    stuck = every(goes_on, AtMost(clock - began, sp.Rational(1, 2**24)))
    following = Choose(Either(begins, goes_on), ROLLS, Choose(leaves, LEAVES, 0))
    stays = some(begins, leaves, goes_on)
    return (
        made(
            "kept",
            {
                "kept": Less(0, mode),
                "when": Choose(Less(0, mode), 0, when),
                "rests": Nowhere(),
                "rolling": Nowhere(),
                "began": 0,
            },
            "Where a ball is in contact: no flight to search.",
            "Table 1",
        ),
        made(
            "opens_in_flight",
            {"open": every(Not(Less(0, clear)), Not(Truth("kept")))},
            "Where a surface is not certainly missed by a ball in flight.",
            "Table 1",
        ),
        made(
            "reachable_in_flight",
            {"reachable": every(Truth("reachable"), Not(Truth("kept")))},
            "Where a ball in flight may reach a surface.",
            "Table 1",
        ),
        made(
            "resumed",
            {
                "which": NONE,
                "late": 0,
                "began": clock,
                "doubt": Choose(bounded, sp.oo, 0),
                "begins": Equal(mode, BEGINS),
                "rolling": Equal(mode, ROLLS),
                "leaves": Equal(mode, LEAVES),
                **{str(s): 0 for s in (*normal, gap, *rolling.bent, lift, surge, snap)},
                str(rolling.per_reach): 0,
            },
            "No event yet, of a ball in contact.",
            "Table 1",
        ),
        made(
            "doubted_in_contact",
            {
                "uncertain": Choose(
                    every(
                        Either(every(Not(Less(when + late, doubt)), Less(doubt, sp.oo)), edge),
                        Not(every(Less(0, assured), Equal(which, last))),
                    ),
                    1,
                    uncertain,
                )
            },
            "1 where a decision lies within its error; that a ball bounces on is none.",
            "Table 1",
        ),
        made("holding", {"here": Equal(held, index)}, "Whether it stays on this.", "Table 1"),
        made("beside", {"beside": Not(Equal(held, index))}, "Whether it does not.", "Table 1"),
        made("unhopped", {"hopped": Nowhere()}, "A ball in flight.", "Table 1"),
        made(
            "beginning_contact",
            {"which": codes.begins, "circled": 0},
            "The contact begins.",
            "Table 1",
        ),
        made("hopping", {"which": codes.hops}, "The ball is off.", "Table 1"),
        made(
            "kept_on",
            {
                "body": Choose(
                    begins,
                    codes.row(own, False),
                    Choose(
                        leaves,
                        codes.row(own, True),
                        Choose(hops, NONE, Choose(for_ever, codes.bodies, body)),
                    ),
                ),
                "reached": Choose(
                    stuck,
                    capped,
                    Choose(
                        for_ever,
                        outcomes["endless"],
                        Choose(rests, lodged, Choose(Either(beyond, goes_on), IN_FLIGHT, reached)),
                    ),
                ),
                "doubt": Choose(stuck, 0, doubt),
                "ends": every(ends, Not(beyond)),
                "hopped": hops,
                "last": Choose(hops, NONE, last),
                "mode": following,
                "held": Choose(stays, held, NONE),
                "rolls": Choose(begins, rolls + 1, rolls),
            },
            "What comes of a ball in contact.",
            "Table 1",
        ),
        made(
            "settled",
            {
                "mode": Choose(nearly, Choose(settles, BEGINS, Choose(parts, LEAVES, 0)), 0),
                "held": Choose(every(nearly, Either(settles, parts)), index, NONE),
                "outcome": Choose(
                    every(nearly, Either(lodges, slides), Less(outcome, 0)),
                    Choose(lodges, lodged, capped),
                    outcome,
                ),
                "slip_left": Choose(every(nearly, slides), 1, 0),
                "uncertain": Choose(Either(lodges, unsure), 1, uncertain),
            },
            "Whether the ball stays on a surface, slides, leaves, or is wedged between two.",
            "Table 1",
        ),
    )


def keeps_ball(surface: Surface, flight: Parabola) -> bool:
    """Return whether a ball can stay in contact with the surface: else it bounces on."""
    tube = surface.tube
    return tube is not None and (tube.ring == 0 or flight.upright)


def of_surface(surface: Surface, flight: Parabola) -> dict[str, Kernel]:
    """Return what a surface needs where balls stay in contact: beside it, and on it if they can."""
    along = dict(zip(POSITION, VELOCITY, strict=True))
    flown = along | dict(zip(VELOCITY, flight.acceleration, strict=True))
    name = surface.name
    found = {
        "beside": made(
            f"{name}_beside",
            {
                "gap": hold(surface.distance),
                "nearing": directional(surface.distance, along),
                "dent": surface.dent,
            },
            "The distance, its rate, and how fast it bends down at most, by the squared speed.",
            "Table 2",
        )
    }
    turns = dict(zip(POSITION, rolled, strict=True))
    pushed = dict(zip(rolled, thrust, strict=True))
    facing_on = dict(zip(POSITION, normal, strict=True))
    rate = directional(_held(surface.distance), turns)
    found["closing"] = made(
        f"{name}_closing",
        {
            "gap": hold(surface.distance),
            "nearing": rate,
            "swerve": directional(rate, turns | pushed),
            "facing": directional(_held(surface.distance), facing_on),
        },
        "The distance, its rate and its second derivative, of a ball that rolls on something else.",
        "derivatives of Table 2's distance",
    )
    tube = surface.tube
    if tube is None or not keeps_ball(surface, flight):
        return found  # of a ring the motion is known where gravity is down its axis
    derivatives = [_held(surface.distance)]
    for _ in range(4):
        derivatives.append(directional(derivatives[-1], flown))
    named = zip(turning, surface.normal, strict=True)
    sizes = dict(zip(map(str, rolling.bent), tube.bent, strict=True))
    found |= {
        "off": made(f"{name}_off", {"gap": surface.distance}, "The distance.", "Table 2"),
        "tube": made(
            f"{name}_tube",
            sizes | {"per_reach": tube.per_reach},
            "What a ball that stays on it rolls on.",
            "Table 2",
        ),
        "turning": made(
            f"{name}_turning",
            {str(rate): hold(directional(component, turns)) for rate, component in named},
            "The rate at which the normal turns.",
            "derivative of Table 2's normal",
        ),
        "parting": made(
            f"{name}_parting",
            dict(zip(("lift", "surge", "snap"), derivatives[2:], strict=True)),
            "The second to the fourth derivative of the distance along a flight.",
            "derivatives of Table 2's distance",
        ),
    }
    seams = {
        f"seam{k}": made(
            f"{name}_seam{k}",
            {"gap": hold(place - value), "nearing": along[place], "near": width},
            "How far the ball is from a seam of the surface, and how fast.",
            "Table 2",
        )
        for k, (place, value, width) in enumerate(tube.seams)
    }
    return found | seams


def _held(expression: sp.Expr) -> sp.Expr:
    """Return the expression with all its sums and powers held, which its derivatives then share."""
    if expression.is_Atom:
        return expression
    inner = expression.func(*map(_held, expression.args))
    return hold(inner) if inner.is_Add or inner.is_Pow else inner
