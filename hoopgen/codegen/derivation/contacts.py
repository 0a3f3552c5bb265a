"""What the page says of contacts: each body's law with its constants, and each kind of law."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from hoopgen.derive.contact.law import Law
from hoopgen.derive.contact.rolling import (
    AFTER,
    BEFORE,
    INERTIA_FACTOR,
    Rolling,
    impact_equations,
    impact_inverse,
    impact_system,
)
from hoopgen.derive.contact.slipping import (
    IMPULSE,
    Slipping,
    contact_velocity,
    gripping,
    impulse_equations,
    lost_energy,
    response,
    yielding,
)
from hoopgen.derive.ground.choice import release
from hoopgen.derive.scenes.scene import Scene

from .explain import Formulas, plainly
from .latex import Names, show
from .letters import Letters
from .notation import latex_name

RESTITUTION, LOW_SPEED, FRICTION, TANGENTIAL, FALLING = sp.symbols(
    "e low_speed_restitution friction tangential falling", nonnegative=True
)
"""The constants of a law in general; each body has its own."""

SLIP, SPEED, PUSHED = sp.symbols("slip normal_speed friction_impulse", nonnegative=True)
"""Sizes of the slip, of the velocity against the normal, and of friction's impulse."""

NAMES: Names = {
    **{p: f"p_{k}" for k, p in enumerate(IMPULSE, start=1)},
    **{symbol: latex_name(symbol.name) + "^-" for symbol in BEFORE},
}


@dataclass(frozen=True)
class BodyText:
    """A body's law, and its constants in LaTeX."""

    name: str
    law: str
    restitution: str
    friction: str
    tangential: str
    falling: str


@dataclass(frozen=True)
class NoSlipText:
    """The article's impact: the contact point stops."""

    equations: tuple[str, ...]
    matrix: str
    unknowns: str
    right: str
    inverse: str
    solution: str
    last_row: str
    kept: str
    rolled: str
    lost: str


@dataclass(frozen=True)
class FrictionText:
    """Coulomb's impact: the contact point grips, or slips.

    Attributes
    ----------
    equations
        Impulse and motion, each an expression that is zero.
    yields_along, yields_off
        What a unit of impulse changes of the contact point's velocity.
    impulse
        The impulse of friction, and the restitution in it.
    grip
        The share of the slip that a contact takes which grips.
    arm
        The radius, by which the spin moves the contact point.
    turned
        What a unit of friction's impulse turns.
    lost
        The change of the kinetic energy.
    """

    equations: tuple[str, ...]
    yields_along: str
    yields_off: str
    grip: Formulas
    impulse: Formulas
    arm: str
    turned: str
    lost: Formulas


@dataclass(frozen=True)
class ContactText:
    """The laws of a scene."""

    inertia: str
    bodies: tuple[BodyText, ...]
    no_slip: NoSlipText | None
    friction: FrictionText | None


def _body(name: str, law: Law, letters: Letters) -> BodyText:
    def shown(size: sp.Expr) -> str:
        return show(size, None, letters)

    if isinstance(law, Slipping):
        sizes = (law.restitution, law.friction, law.tangential, law.falling)
        return BodyText(name, "friction", *map(shown, sizes))
    given = shown(law.restitution_at(sp.oo))
    return BodyText(name, "no slip", given, shown(law.coefficient), "0", shown(sp.oo))


def _no_slip(ball_radius: sp.Expr, letters: Letters) -> NoSlipText:
    """Return the article's impact."""
    matrix, right = impact_system(ball_radius, RESTITUTION)
    inverse = impact_inverse(ball_radius)
    solution = (inverse * right).applyfunc(sp.expand)
    v1, _, _, _, w2, _ = BEFORE
    equations = impact_equations(ball_radius, RESTITUTION)

    def shown(expression: sp.Expr | sp.Matrix) -> str:
        return show(expression, NAMES, letters)

    return NoSlipText(
        tuple(f"{shown(equation)} &= 0" for equation in equations),
        shown(matrix),
        shown(sp.Matrix(AFTER)),
        shown(right),
        shown(inverse),
        shown(solution),
        shown(matrix[5, 5]),
        shown(solution[0].coeff(v1)),
        shown(solution[0].coeff(w2)),
        shown(_lost_energy(ball_radius)),
    )


def _lost_energy(ball_radius: sp.Expr) -> sp.Expr:
    """Return the kinetic energy per unit mass that a contact without slip changes."""
    grip = gripping(ball_radius, sp.Integer(0)) * SLIP
    change = lost_energy(ball_radius, grip, SLIP, SPEED, RESTITUTION)
    return sp.factor(change.subs(SPEED, 0)) + SPEED**2 * sp.factor(change.coeff(SPEED, 2))


def _friction(ball_radius: sp.Expr, letters: Letters) -> FrictionText:
    """Return Coulomb's impact, found from momentum and angular momentum."""
    law = Slipping("impact", LOW_SPEED, FRICTION, TANGENTIAL, FALLING)
    yields = yielding(ball_radius)
    v1, _, _, _, w2, _ = BEFORE
    slip = contact_velocity(sp.Matrix(BEFORE), ball_radius)
    plain = Slipping("impact", RESTITUTION, FRICTION, TANGENTIAL)
    lost = lost_energy(ball_radius, PUSHED, SLIP, SPEED, RESTITUTION)
    lost = sp.factor(lost.coeff(SPEED, 2)) * SPEED**2 + lost.subs(SPEED, 0)

    def shown(expression: sp.Expr) -> str:
        return show(expression, NAMES, letters)

    def lines(outputs: dict[str, sp.Expr]) -> Formulas:
        return plainly(outputs, {}, letters)

    grip = gripping(ball_radius, TANGENTIAL) * SLIP
    assert slip[0].coeff(v1) == 1
    return FrictionText(
        tuple(f"{shown(sp.expand(e))} &= 0" for e in impulse_equations(ball_radius)),
        shown(yields[0, 0]),
        shown(yields[2, 2]),
        lines({r"\lambda": grip}),
        lines(
            {
                "e": release(law.restitution_at(SPEED)),
                r"\lambda": plain.friction_impulse(ball_radius, SLIP, SPEED),
            }
        ),
        shown(-slip[0].coeff(w2)),
        shown(-response(ball_radius)[4, 0]),
        lines({r"\Delta E": lost}),
    )


def contact_text(scene: Scene, letters: Letters) -> ContactText:
    """Return what the page says of the contacts of a scene."""
    kinds: Iterable[type[Law]] = {type(law) for law in scene.laws}
    return ContactText(
        show(INERTIA_FACTOR),
        tuple(_body(body.name, body.law, letters) for body in scene.bodies),
        _no_slip(scene.ball_radius, letters) if Rolling in kinds else None,
        _friction(scene.ball_radius, letters) if Slipping in kinds else None,
    )
