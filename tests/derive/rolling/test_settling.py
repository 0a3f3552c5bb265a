"""Rolling and settling agree with contacts, and with the laws of Newton and Euler."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
import sympy as sp
from hoopgen.derive.contact.ball import MAX_INERTIA, MIN_INERTIA, THIN_SHELL, Ball
from hoopgen.derive.contact.friction import grip_share
from hoopgen.derive.contact.no_slip import impact
from hoopgen.derive.ir.event_tree import writes
from hoopgen.derive.model import build
from hoopgen.derive.motion import ring_rolling_series, rolling_series
from hoopgen.derive.rolling.contact_phase import kernels
from hoopgen.derive.rolling.symbols import EventCodes
from hoopgen.derive.scenes import COURT
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import normal, spin, velocity

from hoopgen.scene import Scene, Sphere, gravity

RADIUS = sp.Rational(3, 25)
EACH_BALL = pytest.mark.parametrize(
    "ball",
    [
        pytest.param(Ball(RADIUS, sp.Rational(kappa)), id=kappa)
        for kappa in ("2/3", "2/5", "1/64", "1")
    ],
)
BOWL = Scene(
    "bowl",
    bodies=[Sphere("bowl", radius=1, inside=True)],
    ball_radius=0.05,
    gravity=9.81,
    restitution=0.5,
    rolls=True,
).derive()
NORMAL = sp.Matrix([1, 2, 2]) / 3
STATE = sp.Matrix([-2, sp.Rational(1, 2), -3]), sp.Matrix([30, -70, 11])
FALL = sp.Matrix([0, 0, -sp.Rational(981, 100)])


def valued(expression: sp.Expr, extra: dict[sp.Symbol, sp.Expr] | None = None) -> sp.Expr:
    """Return an expression with nothing held, at the motion above."""
    moving, turning = STATE
    given = dict(zip((*normal, *velocity, *spin), (*NORMAL, *moving, *turning), strict=True))
    return sp.nsimplify(release(sp.sympify(expression)).subs({**given, **(extra or {})}))


def test_rolling_takes_what_a_contact_that_grips_takes() -> None:
    ball = Ball(*sp.symbols("R kappa", positive=True))
    taken = grip_share(ball, sp.Integer(0))
    assert sp.simplify(taken - release(ball.friction_share)) == 0
    assert sp.simplify(release(ball.moving_share + ball.friction_share)) == 1
    shell = Ball(ball.radius, THIN_SHELL)
    assert (shell.moving_share, shell.friction_share) == (sp.Rational(3, 5), sp.Rational(2, 5))


def test_every_scene_allows_the_same_inertia() -> None:
    """Scenes of one's own state it without SymPy."""
    own = (gravity.MIN_INERTIA, gravity.MAX_INERTIA)
    assert own == (float(MIN_INERTIA), float(MAX_INERTIA))


@pytest.mark.sampled(2)
@EACH_BALL
def test_a_ball_begins_to_roll_as_the_article_s_contact_without_restitution_leaves_it(
    ball: Ball,
) -> None:
    made = kernels(COURT.flight, ball, (0,), EventCodes(1, 1), COURT.outcomes, (0,))
    gripped = dict(made["gripped"].outputs)
    rolled = [valued(gripped[f"rolled_{axis}"]) for axis in "xyz"]
    after, turned = impact(NORMAL, *STATE, ball, sp.Integer(0))
    assert rolled == [release(component) for component in after]
    turn_rate = {sp.Symbol("turn_rate", real=True): RADIUS * STATE[1].dot(NORMAL)}
    placed = rolling_series.placed(ball)
    where = (
        dict(zip(velocity, rolled, strict=True)) | {rolling_series.gap: sp.Integer(0)} | turn_rate
    )
    spun = [
        sp.nsimplify(
            release(placed[str(w)]).subs({**dict(zip(normal, NORMAL, strict=True)), **where})
        )
        for w in spin
    ]
    assert spun == [release(component) for component in turned]


@EACH_BALL
def test_the_first_terms_are_newton_s_and_euler_s_with_the_contact_point_at_rest(
    ball: Ball,
) -> None:
    """On a sphere: force N n + F, its moment about the centre, and what stays zero."""
    reach = sp.Rational(1, 4)
    v = sp.Matrix([2, -1, 0])
    s = sp.Rational(7, 10)
    w = (NORMAL.cross(v) + s * NORMAL) / RADIUS
    bending = v / reach
    assert v.dot(NORMAL) == 0
    dv, dw, push = (sp.Matrix(sp.symbols(f"{name}:3")) for name in ("dv", "dw", "push"))
    moment = (-RADIUS * NORMAL).cross(push)
    slipping = dv - RADIUS * (dw.cross(NORMAL) + w.cross(bending))
    equations = [
        *(dv - FALL - push),
        *(ball.inertia * RADIUS**2 * dw - moment),
        # Across the normal the contact point stays at rest, along it the gap stays zero.
        *(slipping - slipping.dot(NORMAL) * NORMAL)[:2],
        dv.dot(NORMAL) + v.dot(bending),
    ]
    solution = sp.solve(equations, [*dv, *dw, *push], dict=True)[0]
    terms = {
        rolling_series.term(name, 0): value
        for name, value in zip(("vx", "vy", "vz"), v, strict=True)
    }
    terms |= {rolling_series.term(f"n{axis}", 0): n for axis, n in zip("xyz", NORMAL, strict=True)}
    terms |= {rolling_series.term("turn_rate", 0): s, rolling_series.per_reach: 1 / reach}
    terms |= dict.fromkeys(rolling_series.bent, sp.Integer(1))
    first = {
        k: release(e).subs(terms)
        for k, e in rolling_series.next_terms(0, tuple(FALL), ball).items()
    }
    assert [first[f"v{axis}_1"] for axis in "xyz"] == [solution[d] for d in dv]
    spin_rate = (dw.dot(NORMAL) + w.dot(bending)).subs(solution)
    assert sp.simplify(first["turn_rate_1"] - RADIUS * spin_rate) == 0
    lifted = first["lift_0"] - ball.friction_share * FALL.dot(NORMAL)
    assert sp.simplify(lifted - sp.Matrix([solution[p] for p in push]).dot(NORMAL)) == 0


@pytest.mark.sampled(3)
@EACH_BALL
def test_on_a_ring_they_are_too_in_its_own_coordinates(ball: Ball) -> None:
    """The proof has rational sines: v' = a + N n + F, and s' from the normal's rotation."""
    wide, reach = sp.Rational(23, 100), sp.Rational(13, 100)
    ring = ring_rolling_series.RingRolling(wide, reach, ball, -FALL[2])
    values = dict(
        zip(
            ring_rolling_series.COORDINATES,
            (
                *(sp.Rational(3, 5), sp.Rational(4, 5), sp.Rational(7, 2), sp.Rational(9, 10)),
                *(sp.Rational(-2, 5), sp.Rational(5, 13), sp.Rational(12, 13)),
            ),
            strict=True,
        )
    )
    c, s, a, along, spun, cos, sin = values.values()
    rho = wide + reach * c
    terms = {rolling_series.term(name, 0): value for name, value in values.items()}
    terms |= {rolling_series.term("near", 0): 1 / rho, rolling_series.per_reach: 1 / reach}
    terms[rolling_series.term("tilted", 0)] = along * s - ball.friction_share * spun * c
    first = {k: release(e).subs(terms) for k, e in ring.next_terms(0).items()}
    named = {sp.Symbol(name, real=True): value for name, value in first.items()}
    wanted = {"vx_1", "vy_1", "vz_1", "force"}
    step = {k: release(e).subs(named | terms) for k, e in ring.step().items() if k in wanted}
    e, over, up = sp.Matrix([cos, sin, 0]), sp.Matrix([-sin, cos, 0]), sp.Matrix([0, 0, 1])
    n, v = c * e + s * up, reach * a * (c * up - s * e) + along * over
    turning = (v - wide * along / rho * over) / reach
    friction = ball.friction_share * (spun * n.cross(turning) - (FALL - FALL.dot(n) * n))
    pressed = -FALL.dot(n) - v.dot(turning)
    assert step["force"] == pressed
    expected = FALL + pressed * n + friction
    assert [step[f"v{axis}_1"] for axis in "xyz"] == [sp.nsimplify(p) for p in expected]
    assert sp.simplify(first["turn_rate_1"] + v.dot(n.cross(turning))) == 0


def test_on_a_ring_what_has_a_rate_of_its_own_changes_as_what_it_is_made_of() -> None:
    """T = P S - beta s C, P = rho Omega, and N with its rate: all by the rates of C, S, A, P, s."""
    wide, reach, g, kappa = sp.symbols("R_H R g kappa", positive=True)
    ball = Ball(RADIUS, kappa)
    beta = release(ball.friction_share)
    ring = ring_rolling_series.RingRolling(wide, reach, ball, g)
    c, s, a, along, spun = (rolling_series.term(name, 0) for name in ring_rolling_series.MOVING)
    rho = wide + reach * c
    known = {rolling_series.term("near", 0): 1 / rho, rolling_series.per_reach: 1 / reach}
    known[rolling_series.term("tilted", 0)] = along * s - beta * spun * c
    first = {k: release(e).subs(known) for k, e in ring.next_terms(0).items()}
    omega = first["omega_0"]
    known[rolling_series.term("omega", 0)] = omega
    known[rolling_series.term("around", 0)] = first["around_0"]
    rates = {
        rolling_series.term(name, 0): first[f"{name}_1"] for name in ring_rolling_series.MOVING
    }

    def rate(expression: sp.Expr) -> sp.Expr:
        return sum(sp.diff(expression, x) * by for x, by in rates.items())

    def same(left: sp.Expr, right: sp.Expr) -> bool:
        """Return whether they are where C² + S² = 1."""
        return sp.rem(sp.numer(sp.together(left - right)), s**2 + c**2 - 1, s) == 0

    assert same(omega * rho, along)
    assert same(rate(along * s - beta * spun * c), first["tilted_1"])
    second = release(ring.next_terms(1)["omega_1"])
    second = second.subs({sp.Symbol(k, real=True): e for k, e in first.items()}).subs(known)
    assert same(rate(omega), second)
    pressed = {k: release(e).subs(known) for k, e in ring.pressed().items()}
    assert same(pressed["force"], g * s - reach * a**2 - along * omega * c)
    assert same(rate(pressed["force"]), pressed["force_rate"])


def test_on_a_ring_the_force_bends_no_more_than_is_said() -> None:
    """N'' is a sum of products, each factor of which has a bound: at no step it is that sum."""
    wide, reach, radius, kappa, g = sp.symbols("R_H R R_B kappa g", positive=True)
    ring = ring_rolling_series.RingRolling(wide, reach, Ball(radius, kappa), g)
    c, s, a, omega = (rolling_series.term(name, 0) for name in ("cosine", "sine", "climb", "omega"))
    rise, turn = sp.symbols("rise turn", real=True)
    rates = {c: -s * a, s: c * a, a: rise, omega: turn}
    force_rate = release(ring.pressed()["force_rate"])
    bend = sum(sp.diff(force_rate, x) * by for x, by in rates.items())
    sizes = (sp.Abs(a), sp.Abs(rise), sp.Abs(omega), sp.Abs(turn))
    bound = release(ring.max_force_bend(sp.Integer(0), *sizes))
    for signs in range(2**6):
        values = {
            x: (-1) ** (signs >> k & 1) * sp.Rational(k + 2, 7)
            for k, x in enumerate((c, s, a, omega, rise, turn))
        }
        values |= {x: sp.Rational(3, 5) for x in bound.free_symbols - set(values)}
        assert abs(bend.subs(values)) <= bound.subs(values)


@pytest.mark.parametrize("scene", [BOWL, pytest.param(COURT, marks=pytest.mark.slow)], ids=str)
def test_nothing_follows_a_neighbouring_motion_where_no_errors_are_asked_for(scene: Any) -> None:
    loop = build(scene).loop
    followed = {name for stage in loop.stages.values() for name in writes(stage)}
    assert "far_x" in followed
    plain = {name for stage in loop.plain().stages.values() for name in writes(stage)}
    assert not [name for name in plain if name.startswith("far_")]


def test_what_ends_with_friction_is_what_the_gap_of_a_flight_lacks() -> None:
    """At N = 0 the third derivative of a flight's gap is -N' - 2 F·n'."""
    reach, radius, g = 0.13, 0.2286, 9.81
    with mpmath.workdps(40):
        a, climb, s = mpmath.mpf(1.9), mpmath.mpf(9), mpmath.mpf(1.1)
        rho = radius + reach * mpmath.cos(a)
        # The speed along the ring at which nothing presses on.
        along = mpmath.sqrt((g * mpmath.sin(a) - reach * climb**2) * rho / mpmath.cos(a))

        def gap(t: Any) -> Any:
            outwards = rho - reach * climb * mpmath.sin(a) * t
            height = reach * mpmath.sin(a) + reach * climb * mpmath.cos(a) * t - g * t**2 / 2
            return mpmath.hypot(mpmath.hypot(outwards, along * t) - radius, height) - reach

        bent, snapped = mpmath.diff(gap, 0, 2), mpmath.diff(gap, 0, 3)
    ball = Ball(sp.Float(0.12), sp.Rational(2, 5))
    of = ring_rolling_series.RingRolling(sp.Float(radius), sp.Float(reach), ball, sp.Float(g))
    first = (mpmath.cos(a), mpmath.sin(a), climb, along, s, 1, 0)
    values = {
        f"{name}_0": sp.Float(v)
        for name, v in zip(ring_rolling_series.COORDINATES, first, strict=True)
    }
    values |= {"near_0": sp.Float(1 / rho), "per_reach": sp.Float(1 / reach)}
    values["tilted_0"] = values["along_0"] * values["sine_0"]
    values["tilted_0"] -= ball.friction_share * values["turn_rate_0"] * values["cosine_0"]

    def found(expression: sp.Expr) -> sp.Expr:
        return release(expression).subs({sp.Symbol(n, real=True): v for n, v in values.items()})

    for k in range(2):
        values |= {name: found(expression) for name, expression in of.next_terms(k).items()}
    assert abs(bent) < 1e-12
    assert abs(found(of.pressed()["force"])) < 1e-12
    brace, force_rate = found(of.step()["friction_force_rate"]), found(of.pressed()["force_rate"])
    assert abs(brace) > 1
    assert snapped == pytest.approx(-float(force_rate + brace), rel=1e-9)
