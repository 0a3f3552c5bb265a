"""A scene whose formulas are not what they are taken for is refused, with the reason."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import pytest
import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.model import build
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.check import check
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import (
    Cylinder,
    ImplicitSurface,
    Plane,
    Sphere,
    Surface,
    Torus,
    as_length,
    body,
)
from hoopgen.derive.symbolic.symbols import POSITION

from tests.helpers.scenes.caps import CAPS
from tests.helpers.scenes.chamber import CHAMBER
from tests.helpers.scenes.crate import CRATE
from tests.helpers.scenes.posts import POSTS
from tests.helpers.scenes.rings import RINGS
from tests.helpers.scenes.table import TABLE

x, y, z = POSITION
ZERO = sp.Integer(0)
CENTRE = (ZERO, ZERO, ZERO)
BALL = {p.name: p.symbol for p in TABLE.parameters}["marble"]


def having(face: Surface) -> Scene:
    """Return a scene with that one surface."""
    return replace(TABLE, bodies=(body(face, TABLE.bodies[0].law),))


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "scene", [HOOP, CAPS, TABLE, CHAMBER, POSTS, RINGS, CRATE], ids=lambda s: str(s.name)
)
def test_scenes_that_are_right_pass(scene: Scene) -> None:
    check(scene)


class Leaning(Sphere):
    """A sphere whose normal is not that of its distance."""

    @property
    def normal(self) -> sp.Matrix:
        return super().normal + sp.Matrix([sp.Rational(1, 100), 0, 0])


class Long(Sphere):
    """A sphere whose normal is not of length one."""

    @property
    def normal(self) -> sp.Matrix:
        return 2 * super().normal


class Away(Sphere):
    """A sphere whose distance is to another one."""

    @property
    def distance(self) -> sp.Expr:
        return super().distance + sp.Rational(1, 1000)


class Turned(Sphere):
    """A sphere whose condition is positive inside."""

    @property
    def condition(self) -> sp.Expr:
        return -super().condition


@dataclass(frozen=True)
class Rough(Sphere):
    """A sphere within a bound that is neither a polynomial nor a length."""

    bound: sp.Expr = ZERO

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        return (as_length(self.bound),)


UNKNOWN = sp.Symbol("size", positive=True)
ROUND = x**2 + y**2 + z**2
WRONG = {
    "normal": (Leaning("odd", CENTRE, BALL), r"normal at .* expected the gradient of its distance"),
    "long": (Long("odd", CENTRE, BALL), "normal at .* a unit vector"),
    "distance": (Away("odd", CENTRE, BALL), r"its distance is 0\.001 at .* expected zero"),
    "sign": (Turned("odd", CENTRE, BALL), "condition falls where its distance rises"),
    "gradient": (ImplicitSurface("odd", (ROUND - 1) ** 2), "gradient of its condition is zero"),
    "symbol": (Sphere("odd", CENTRE, UNKNOWN), "unknown symbol size; expected of acceleration"),
    "bound's symbol": (
        Sphere("odd", CENTRE, BALL, limits=(x - UNKNOWN,)),
        "bound 0: unknown symbol size",
    ),
    "root": (ImplicitSurface("odd", sp.sqrt(x**2 + y**2) - z), "expected a condition polynomial"),
    "degree": (ImplicitSurface("odd", x**6 + z**2 - 1), "degree 1 to 4 .* got one of 6"),
    "degree of a product": (
        ImplicitSurface("odd", (sp.sqrt(BALL) * x**3 + 1) ** 2 + z),
        "degree 1 to 4 .* got one of 6",
    ),
    "constant": (ImplicitSurface("odd", sp.Integer(3)), "degree 1 to 4 .* got one of"),
    "float": (ImplicitSurface("odd", ROUND - sp.Float(0.3)), "not exact; expected whole numbers"),
    "bound": (
        Rough("odd", CENTRE, BALL, bound=7 * sp.sqrt(x**2 + y**2) - z),
        "bound 0: expected a polynomial .*, or a length; it is no polynomial and changes by 7",
    ),
}


@pytest.mark.parametrize(("face", "reason"), WRONG.values(), ids=list(WRONG))
def test_a_wrong_surface_is_refused_with_the_reason(face: Surface, reason: str) -> None:
    with pytest.raises(ValueError, match=f"^scene table: surface odd: .*{reason}"):
        build(having(face))


@pytest.mark.parametrize(
    ("bound", "reason"),
    [
        (7 * sp.sqrt(x**2 + y**2) - z, "bound 0: expected a polynomial .* changes by 7"),
        (x - UNKNOWN, "bound 0: unknown symbol size"),
        (x - sp.Float(0.3), ".* is not exact"),
    ],
    ids=["steep", "symbol", "float"],
)
def test_an_ends_wrong_bound_is_refused_with_the_reason(bound: sp.Expr, reason: str) -> None:
    ground = Plane("ground", (0, 0, 1), sp.Integer(-9), ZERO, (bound,))
    with pytest.raises(ValueError, match=f"^scene table: end low: {reason}"):
        build(replace(TABLE, ends=(End("low", ground),)))


def test_an_ends_bound_of_any_degree_is_a_length() -> None:
    """A large circle's square: at its edge it changes by no more than the way to it."""
    circle = x**2 + y**2 - 400
    ground = Plane("ground", (0, 0, 1), sp.Integer(-9), ZERO, (circle,))
    (gate,) = replace(TABLE, ends=(End("low", ground),)).end_planes
    (side,) = gate.sides
    off = sp.Rational(1, 10**9)
    for way in (-1, 1):
        found = side.xreplace({x: 12 + way * off * 3 / 5, y: 16 + way * off * 4 / 5}).doit()
        assert off / 3 < way * found <= off


def test_a_law_of_an_unknown_restitution_is_refused() -> None:
    law = NoSlip("impact", UNKNOWN)
    scene = replace(TABLE, bodies=(replace(TABLE.bodies[0], law=law),))
    with pytest.raises(ValueError, match="scene table: law impact: unknown symbol size"):
        build(scene)


def test_two_bodies_of_one_name_are_refused() -> None:
    twice = (TABLE.bodies[0], TABLE.bodies[0])
    with pytest.raises(ValueError, match="scene table: body 'top': 2 have this name"):
        replace(TABLE, bodies=twice)


@pytest.mark.parametrize("kind", [Cylinder, partial(Torus, reach=BALL)])
@pytest.mark.parametrize("direction", [(1, 1, 0), (0, 0, 2), (sp.sqrt(2) / 2, sp.sqrt(2) / 2, 0)])
def test_an_axis_is_a_unit_vector_of_fractions(
    kind: Callable[..., Surface], direction: tuple[sp.Expr, ...]
) -> None:
    with pytest.raises(ValueError, match="surface odd: direction: expected three rational"):
        kind("odd", CENTRE, direction, BALL)


# -- Bounds as lengths


@pytest.mark.parametrize(
    "bound",
    [x - BALL, sp.Rational(3, 5) * x + sp.Rational(4, 5) * z, sp.sqrt(x**2 + y**2) - BALL],
    ids=["coordinate", "unit vector", "distance"],
)
def test_a_bound_that_is_a_length_stays_as_it_is(bound: sp.Expr) -> None:
    assert as_length(bound) == bound


@pytest.mark.parametrize(
    "bound",
    [x**2 + y**2 - 400, 30 * x - z, BALL * x - 1, x * y * z - 2, x**4 - 3 * y**2 + z - 1],
    ids=["far", "steep", "of parameters", "cubic", "quartic"],
)
def test_any_other_polynomial_is_made_one(bound: sp.Expr) -> None:
    """The polynomial has the bound's sign, and near zero at most the distance to the bound."""
    made = as_length(bound)
    step = sp.Rational(1, 10**6)
    for place in ((3, 1, -2), (-20, sp.Rational(1, 3), 5), (0, 20, 1), (1, 2, sp.Rational(99, 98))):
        values = dict(zip(POSITION, map(sp.Rational, place), strict=True)) | {BALL: sp.Rational(2)}
        here = bound.xreplace(values)
        assert sp.sign(made.xreplace(values).doit()) == sp.sign(here)
        # Shifted to be zero here, it changes no faster than a length.
        zero = as_length(sp.expand(bound - here)) if here else made
        slopes = [
            (zero.xreplace(values | {c: values[c] + step}) - zero.xreplace(values)) / step
            for c in POSITION
        ]
        assert sum(float(s) ** 2 for s in slopes) <= 1 + 1e-4
