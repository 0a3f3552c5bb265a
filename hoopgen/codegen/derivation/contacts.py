"""The contacts on the derivation page: each body's law with its constants, and each kind of law."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from hoopgen.derive.contact.ball import THIN_SHELL, Ball
from hoopgen.derive.contact.friction import (
    IMPULSE,
    CoulombFriction,
    contact_velocity,
    energy_change,
    grip_share,
    impulse_equations,
    impulse_response,
    slip_response,
)
from hoopgen.derive.contact.law import Law
from hoopgen.derive.contact.no_slip import (
    AFTER,
    BEFORE,
    NoSlip,
    impact_equations,
    impact_inverse,
    impact_system,
)
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.notation import latex_name

from .explain import Formulas, plainly
from .latex import Names, show
from .scene_notation import SceneNotation

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
        The change of the contact point's velocity by a unit of impulse.
    grip
        The share of the slip that a contact which grips takes.
    impulse
        The impulse of friction, and the restitution in it.
    arm
        The radius, by which the spin moves the contact point.
    turned
        The change of the spin by a unit of friction's impulse.
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
    """The laws of a scene.

    Attributes
    ----------
    inertia
        The moment of inertia over m R_B².
    thin_shell
        True if that is the number of a thin shell.
    friction_share
        The share of a force along the surface that rolling takes as friction.
    """

    inertia: str
    thin_shell: bool
    friction_share: str
    bodies: tuple[BodyText, ...]
    no_slip: NoSlipText | None
    friction: FrictionText | None


def _body(name: str, law: Law, notation: SceneNotation) -> BodyText:
    def shown(size: sp.Expr) -> str:
        return show(size, None, notation)

    if isinstance(law, CoulombFriction):
        sizes = (law.restitution, law.friction, law.tangential, law.falling)
        return BodyText(name, "friction", *map(shown, sizes))
    given = shown(law.restitution_at(sp.oo))
    return BodyText(name, "no slip", given, shown(law.friction_coefficient), "0", shown(sp.oo))


def _no_slip(ball: Ball, notation: SceneNotation) -> NoSlipText:
    """Return the article's impact."""
    matrix, right = impact_system(ball, RESTITUTION)
    inverse = impact_inverse(ball)
    solution = (inverse * right).applyfunc(sp.expand)
    v1, _, _, _, w2, _ = BEFORE
    equations = impact_equations(ball, RESTITUTION)

    def shown(expression: sp.Expr | sp.Matrix) -> str:
        return show(expression, NAMES, notation)

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
        shown(_lost_energy(ball)),
    )


def _lost_energy(ball: Ball) -> sp.Expr:
    """Return the change of the kinetic energy per unit mass by a contact without slip."""
    grip = grip_share(ball, sp.Integer(0)) * SLIP
    change = energy_change(ball, grip, SLIP, SPEED, RESTITUTION)
    return sp.factor(change.subs(SPEED, 0)) + SPEED**2 * sp.factor(change.coeff(SPEED, 2))


def _friction(ball: Ball, notation: SceneNotation) -> FrictionText:
    """Return Coulomb's impact, derived from momentum and angular momentum."""
    law = CoulombFriction("impact", LOW_SPEED, FRICTION, TANGENTIAL, FALLING)
    yields = slip_response(ball)
    v1, _, _, _, w2, _ = BEFORE
    slip = contact_velocity(sp.Matrix(BEFORE), ball)
    plain = CoulombFriction("impact", RESTITUTION, FRICTION, TANGENTIAL)
    lost = energy_change(ball, PUSHED, SLIP, SPEED, RESTITUTION)
    lost = sp.factor(lost.coeff(SPEED, 2)) * SPEED**2 + lost.subs(SPEED, 0)

    def shown(expression: sp.Expr) -> str:
        return show(expression, NAMES, notation)

    def lines(outputs: dict[str, sp.Expr]) -> Formulas:
        return plainly(outputs, {}, notation)

    grip = grip_share(ball, TANGENTIAL) * SLIP
    assert slip[0].coeff(v1) == 1
    return FrictionText(
        tuple(f"{shown(sp.expand(e))} &= 0" for e in impulse_equations(ball)),
        shown(yields[0, 0]),
        shown(yields[2, 2]),
        lines({r"\lambda": grip}),
        lines(
            {
                "e": release(law.restitution_at(SPEED)),
                r"\lambda": plain.friction_impulse(ball, SLIP, SPEED),
            }
        ),
        shown(-slip[0].coeff(w2)),
        shown(-impulse_response(ball)[4, 0]),
        lines({r"\Delta E": lost}),
    )


def contact_text(scene: Scene, notation: SceneNotation) -> ContactText:
    """Return the contacts of a scene for the page.

    Parameters
    ----------
    scene
        The scene, whose bodies have the laws.
    notation
        The letters of its parameters.

    Returns
    -------
    ContactText
        The law of each body, and each law once as mathematics.
    """
    kinds: Iterable[type[Law]] = {type(law) for law in scene.laws}
    return ContactText(
        show(scene.inertia, None, notation),
        scene.inertia == THIN_SHELL,
        show(sp.factor(release(scene.ball.friction_share)), None, notation),
        tuple(_body(body.name, body.law, notation) for body in scene.bodies),
        _no_slip(scene.ball, notation) if NoSlip in kinds else None,
        _friction(scene.ball, notation) if CoulombFriction in kinds else None,
    )
