"""Rolling and settling agree with contacts, and with the laws of Newton and Euler."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
import sympy as sp
from hoopgen.derive.contact.rolling import INERTIA_FACTOR, impact
from hoopgen.derive.contact.slipping import gripping
from hoopgen.derive.flight import circling, rolling
from hoopgen.derive.follow.settling import Codes, kernels
from hoopgen.derive.ground.choice import release
from hoopgen.derive.ground.symbols import normal, spin, velocity
from hoopgen.derive.ground.tree import writes
from hoopgen.derive.model import build
from hoopgen.derive.scenes import COURT

RADIUS = sp.Rational(3, 25)
NORMAL = sp.Matrix([1, 2, 2]) / 3
STATE = sp.Matrix([-2, sp.Rational(1, 2), -3]), sp.Matrix([30, -70, 11])
FALL = sp.Matrix([0, 0, -sp.Rational(981, 100)])


def valued(expression: sp.Expr, extra: dict[sp.Symbol, sp.Expr] | None = None) -> sp.Expr:
    """Return an expression with nothing held, at the motion above."""
    moving, turning = STATE
    given = dict(zip((*normal, *velocity, *spin), (*NORMAL, *moving, *turning), strict=True))
    return sp.nsimplify(release(sp.sympify(expression)).subs({**given, **(extra or {})}))


def test_rolling_takes_what_a_contact_that_grips_takes() -> None:
    assert gripping(sp.Symbol("R", positive=True), sp.Integer(0)) == rolling.SHARE


def test_a_ball_begins_to_roll_as_the_article_s_contact_without_restitution_leaves_it() -> None:
    made = kernels(COURT.flight, RADIUS, (0,), Codes(1, 1), COURT.outcomes)
    gripped = dict(made["gripped"].outputs)
    rolled = [valued(gripped[f"rolled_{axis}"]) for axis in "xyz"]
    after, turned = impact(NORMAL, *STATE, RADIUS, sp.Integer(0))
    assert rolled == [release(component) for component in after]
    turn_rate = {sp.Symbol("turn_rate", real=True): RADIUS * STATE[1].dot(NORMAL)}
    placed = rolling.placed(RADIUS)
    where = dict(zip(velocity, rolled, strict=True)) | {rolling.gap: sp.Integer(0)} | turn_rate
    spun = [
        sp.nsimplify(
            release(placed[str(w)]).subs({**dict(zip(normal, NORMAL, strict=True)), **where})
        )
        for w in spin
    ]
    assert spun == [release(component) for component in turned]


def test_the_first_terms_are_newton_s_and_euler_s_with_the_contact_point_at_rest() -> None:
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
        *(INERTIA_FACTOR * RADIUS**2 * dw - moment),
        # Across the normal the contact point stays at rest, along it the gap stays zero.
        *(slipping - slipping.dot(NORMAL) * NORMAL)[:2],
        dv.dot(NORMAL) + v.dot(bending),
    ]
    solution = sp.solve(equations, [*dv, *dw, *push], dict=True)[0]
    terms = {
        rolling.term(name, 0): value for name, value in zip(("vx", "vy", "vz"), v, strict=True)
    }
    terms |= {rolling.term(f"n{axis}", 0): n for axis, n in zip("xyz", NORMAL, strict=True)}
    terms |= {rolling.term("turn_rate", 0): s, rolling.per_reach: 1 / reach}
    terms |= dict.fromkeys(rolling.bent, sp.Integer(1))
    first = {k: release(e).subs(terms) for k, e in rolling.following(0, tuple(FALL)).items()}
    assert [first[f"v{axis}_1"] for axis in "xyz"] == [solution[d] for d in dv]
    spin_rate = (dw.dot(NORMAL) + w.dot(bending)).subs(solution)
    assert sp.simplify(first["turn_rate_1"] - RADIUS * spin_rate) == 0
    lifted = first["lift_0"] - rolling.SHARE * FALL.dot(NORMAL)
    assert sp.simplify(lifted - sp.Matrix([solution[p] for p in push]).dot(NORMAL)) == 0


def test_on_a_ring_they_are_too_in_its_own_coordinates() -> None:
    """With rational sines: v' = a + N n + F, and s' from the way that the normal turns."""
    wide, reach = sp.Rational(23, 100), sp.Rational(13, 100)
    ring = circling.Circling(wide, reach, RADIUS, -FALL[2])
    values = dict(
        zip(
            circling.COORDINATES,
            (
                *(sp.Rational(3, 5), sp.Rational(4, 5), sp.Rational(7, 2), sp.Rational(9, 10)),
                *(sp.Rational(-2, 5), sp.Rational(5, 13), sp.Rational(12, 13)),
            ),
            strict=True,
        )
    )
    c, s, a, along, spun, cos, sin = values.values()
    rho = wide + reach * c
    terms = {rolling.term(name, 0): value for name, value in values.items()}
    terms[rolling.term("near", 0)] = 1 / rho
    first = {k: release(e).subs(terms) for k, e in ring.following(0).items()}
    named = {sp.Symbol(name, real=True): value for name, value in first.items()}
    pace = {k: release(e).subs(named | terms) for k, e in ring.pace().items() if k.endswith("_1")}
    e, over, up = sp.Matrix([cos, sin, 0]), sp.Matrix([-sin, cos, 0]), sp.Matrix([0, 0, 1])
    n, v = c * e + s * up, reach * a * (c * up - s * e) + along * over
    turning = (v - wide * along / rho * over) / reach
    friction = rolling.SHARE * (spun * n.cross(turning) - (FALL - FALL.dot(n) * n))
    pressed = -FALL.dot(n) - v.dot(turning)
    assert first["force_0"] == pressed
    expected = FALL + pressed * n + friction
    assert [pace[f"v{axis}_1"] for axis in "xyz"] == [sp.nsimplify(p) for p in expected]
    assert sp.simplify(first["turn_rate_1"] + v.dot(n.cross(turning))) == 0


def test_nothing_follows_a_neighbouring_motion_where_no_errors_are_asked_for() -> None:
    loop = build(COURT).loop
    followed = {name for stage in loop.stages.values() for name in writes(stage)}
    assert "far_x" in followed
    plain = {name for stage in loop.plain().stages.values() for name in writes(stage)}
    assert not [name for name in plain if name.startswith("far_")]


def test_what_ends_with_friction_is_what_the_gap_of_a_flight_lacks() -> None:
    """Where N = 0, the third derivative of a flight's gap is -N' - 2 F·n'."""
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
    of = circling.Circling(*map(sp.Float, (radius, reach, 0.12, g)))
    first = (mpmath.cos(a), mpmath.sin(a), climb, along, s, 1, 0)
    values = {f"{name}_0": sp.Float(v) for name, v in zip(circling.COORDINATES, first, strict=True)}
    values["near_0"] = sp.Float(1 / rho)

    def found(expression: sp.Expr) -> sp.Expr:
        return release(expression).subs({sp.Symbol(n, real=True): v for n, v in values.items()})

    for k in range(2):
        values |= {name: found(expression) for name, expression in of.following(k).items()}
    assert abs(bent) < 1e-12
    assert abs(values["force_0"]) < 1e-12
    brace = found(of.pace()["brace"])
    assert abs(brace) > 1
    assert snapped == pytest.approx(-float(values["force_1"] + brace), rel=1e-9)
