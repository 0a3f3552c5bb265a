"""Margins of the condition of an arc that is turned about an axis, and the roundings of its roots.

The circle is almost that of a sphere: there the condition is a small difference of large squares.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache

import numpy as np
import sympy as sp
from hoopgen.derive.events.arc import SHARE, ArcRootFinder
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.scenes.scene import Scene as Derived
from hoopgen.derive.surfaces import RevolvedArc
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.error_terms import curving
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

from hoopgen.scene import Revolution
from tests.helpers.derived import evaluation
from tests.scene.test_arcs import curved, scene

Floats = NDArray[np.float64]

CENTRE, RADIUS, BALL = 0.0035, 0.3, 0.06


@cache
def derived() -> Derived:
    """Return a scene of a bowl, of which the arc's centre is a hundredth of its radius off axis."""
    return scene(
        "almost_round", Revolution("bowl", profile=curved((CENTRE, 0), RADIUS, -80, 0))
    ).derive()


def finder() -> ArcRootFinder:
    """Return the root finder of the hollow side."""
    made = derived()
    (surface,) = (s for s in made.surfaces if isinstance(s, RevolvedArc) and s.inward)
    return ArcRootFinder(made.flight, surface, two_sided=True)


def in_doubles(output: sp.Expr) -> Callable[[dict[str, Floats]], Floats]:
    """Return the function from values by name to a formula, as kernels evaluate it."""
    order = sorted(output.free_symbols, key=str)
    run = evaluation(kernel("sample", {"found": output}, order, "A sample.", "Eq. 2"), tuple(order))
    return lambda values: np.asarray(run(*(values[str(symbol)] for symbol in order))[0])


def values_at(places: Floats, chance: np.random.Generator) -> dict[str, Floats]:
    """Return the values of a search that begins at places, of which the errors are small."""
    count = len(places)
    found = {p.name: np.full(count, p.default) for p in derived().parameters}
    found |= dict(zip("xyz", places.T, strict=True))
    moving = chance.normal(0, 3, (3, count))
    found |= {f"v{axis}": v for axis, v in zip("xyz", moving, strict=True)}
    found |= {"extent": np.abs(places).sum(axis=1), "speed": np.abs(moving).sum(axis=0)}
    found |= {"t": np.zeros(count), "horizon": np.full(count, 1e-9)}
    found |= {"position_error": 10.0 ** chance.uniform(-15, -9, count)}
    return found | {"velocity_error": found["position_error"], "curving": np.zeros(count)}


def exact(places: list[list[Fraction]]) -> list[Fraction]:
    """Return the condition at places, exactly."""
    numbers = {p.symbol: sp.Rational(p.default) for p in derived().parameters}
    shape = sp.Poly(release(finder().surface.condition).xreplace(numbers), *POSITION)
    terms = [(powers, Fraction(int(c.p), int(c.q))) for powers, c in shape.terms()]
    return [
        sum((c * x**i * y**j * z**k for (i, j, k), c in terms), Fraction(0)) for x, y, z in places
    ]


def touching(count: int, chance: np.random.Generator) -> Floats:
    """Return places where the ball touches the hollow side, up to a few roundings."""
    angle, turn = chance.uniform(-1.4, 0, count), chance.uniform(0, 2 * np.pi, count)
    rho = CENTRE + (RADIUS - BALL) * np.cos(angle)
    height = (RADIUS - BALL) * np.sin(angle)
    return np.stack([rho * np.cos(turn), rho * np.sin(turn), height], -1)


def test_the_margin_of_an_arc_contains_errors_of_places_and_roundings() -> None:
    """Besides a share of the gap itself, which is a fourth of what the search allows for."""
    chance, count = np.random.default_rng(1), 400
    places = touching(count, chance)
    far = chance.uniform(0, 1, count) < 0.5
    places[far] += chance.normal(0, 0.05, (far.sum(), 3))
    values = values_at(places, chance)
    gap, margin = in_doubles(finder().gap)(values), in_doubles(finder().margins["margin"])(values)
    wide = values["position_error"][:, None] * chance.choice([-1.0, 1.0], places.shape)
    moved = [
        [Fraction(x) + Fraction(d) for x, d in zip(*rows, strict=True)]
        for rows in zip(places.tolist(), wide.tolist(), strict=True)
    ]
    away = np.array(
        [float(abs(Fraction(g) - f)) for g, f in zip(gap.tolist(), exact(moved), strict=True)]
    )
    assert (away <= margin + float(SHARE) / 4 * np.abs(gap)).all()
    # Near the surface it is no more than some hundred times the largest error.
    near = ~far
    assert (away[near] / margin[near]).max() > 1e-3
    assert (away[near] <= margin[near]).all()


def test_the_roundings_of_a_root_are_within_their_bound() -> None:
    """The error of the condition at a contact, over its rate."""
    chance, count = np.random.default_rng(2), 400
    places = touching(count, chance)
    values = values_at(places, chance)
    delay = finder().root_delay
    assert delay is not None
    bound = in_doubles(delay.xreplace({curving: sp.oo}))(values)
    gap, rate = in_doubles(finder().gap)(values), in_doubles(finder().rate)(values)
    whole = [[Fraction(x) for x in row] for row in places.tolist()]
    off = [float(abs(Fraction(g) - f)) for g, f in zip(gap.tolist(), exact(whole), strict=True)]
    ratio = np.array(off) / np.abs(rate) / bound
    assert 0.02 < ratio.max() <= 1
