"""Bounds on how fast the distance from a surface bends downwards along a straight line."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.surfaces import (
    Box,
    Cone,
    Cylinder,
    ObliqueCylinder,
    ObliqueTorus,
    RevolvedArc,
    Ring,
    Sphere,
    Surface,
)
from hoopgen.derive.surfaces.torus import Torus
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import POSITION

from tests.helpers.effort import trials

WIDE, THIN, BALL = sp.Rational(1, 2), sp.Rational(1, 10), sp.Rational(1, 20)
CENTRE = (sp.Rational(1, 10), sp.Rational(-1, 5), sp.Rational(1, 20))
AXIS = (sp.Rational(3, 13), sp.Rational(-4, 13), sp.Rational(12, 13))
UP = (0, 0, 1)


def surfaces() -> list[Surface]:
    """Return surfaces of every kind that bends, convex and hollow ones."""
    found: list[Surface] = [
        Ring("ring", WIDE, THIN),
        Torus("torus", CENTRE, (1, 0, 0), WIDE, THIN),
        Torus("thick_torus", CENTRE, UP, THIN, WIDE),
        ObliqueTorus("oblique_torus", CENTRE, AXIS, WIDE, THIN),
        Sphere("sphere", CENTRE, WIDE),
        Sphere("hollow_sphere", CENTRE, WIDE, inward=True, reach=BALL),
        Cylinder("cylinder", CENTRE, UP, WIDE),
        Cylinder("pipe", CENTRE, UP, WIDE, inward=True, reach=BALL),
        ObliqueCylinder("oblique_pipe", CENTRE, AXIS, WIDE, inward=True, reach=BALL),
        Cone("spike", CENTRE, AXIS, WIDE),
        Cone("funnel", CENTRE, AXIS, WIDE, inward=True, reach=BALL),
        Box("box", CENTRE, (WIDE, WIDE, THIN), BALL),
    ]
    for inward, offset in ((False, WIDE), (True, WIDE), (False, -THIN), (True, -THIN)):
        name = f"arc_{'hollow' if inward else 'round'}_{'near' if offset > 0 else 'beyond'}"
        sign = 1 if offset > 0 else -1
        found.append(RevolvedArc(name, CENTRE, AXIS, offset, sign, WIDE * 2 / 3, inward=inward))
    return found


SURFACES = surfaces()


def first_zero(gap: float, rate: float, bend: float) -> float:
    """Return when gap + rate t - bend t²/2 is zero."""
    return 2 * gap / (np.sqrt(rate**2 + 2 * bend * gap) - rate)


@pytest.mark.sampled(6)
@pytest.mark.parametrize("surface", SURFACES, ids=lambda s: s.name)
def test_a_ball_meets_no_surface_sooner_than_its_bound_says(surface: Surface) -> None:
    """Along a straight line with the speed 1; the lines go past axes and centres, too."""
    known = [{"IfLess": lambda a, b, then, other: np.where(a < b, then, other)}, "numpy"]
    distance = sp.lambdify(POSITION, release(surface.own_distance), known)
    bound = sp.lambdify(POSITION, release(surface.max_concavity), known)
    chance = np.random.default_rng(21)
    met, step = 0, 1e-7
    for _ in range(trials(1000, 400)):
        place = np.array(CENTRE, float) + chance.normal(0, 0.4, 3)
        way = chance.normal(0, 1, 3)
        way /= np.linalg.norm(way)
        gap = float(distance(*place))
        if gap <= 1e-3:
            continue
        rate = float(distance(*(place + step * way)) - distance(*(place - step * way))) / 2 / step
        until = first_zero(gap, rate - 1e-6, float(bound(*place)) + 1e-6)
        if not until < 10:
            continue
        met += 1
        path = place + np.linspace(0, until, 400)[:, None] * way
        assert np.min(distance(*path.T)) > -1e-6, (place, way)
    assert met > 5
