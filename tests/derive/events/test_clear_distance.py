"""A surface without a box along the axes is passed over if a flight certainly cannot reach it."""

from __future__ import annotations

import mpmath
import numpy as np
import sympy as sp
from hoopgen.derive.events.polynomial import PolynomialRootFinder
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.surfaces import ObliqueCylinder
from numpy.typing import NDArray

from tests.derive.events.test_turned_box_search import in_doubles
from tests.helpers.effort import trials

AXIS = tuple(sp.Rational(n, 16) for n in (14, 6, 5))
CENTRE = tuple(map(sp.Integer, (300, -200, 100)))
FALL, RADIUS = (sp.Integer(1), sp.Integer(-2), sp.Integer(-9)), sp.Rational(1, 4)
FINDER = PolynomialRootFinder(Parabola(FALL), ObliqueCylinder("pipe", CENTRE, AXIS, RADIUS))


def near_axis(count: int, chance: np.random.Generator) -> NDArray[np.float64]:
    """Return places up to a kilometre along the axis, some centimetres outside the cylinder."""
    unit = np.array(AXIS, float) / np.linalg.norm(np.array(AXIS, float))
    out = np.cross(unit, chance.normal(0, 1, (count, 3)))
    out /= np.linalg.norm(out, axis=1)[:, None]
    far = float(RADIUS) + 10 ** chance.uniform(-3, -1, (count, 1))
    along = chance.uniform(-1000, 1000, (count, 1)) * unit
    return np.asarray(np.array(CENTRE, float) + along + out * far)


def exact_distance(place: NDArray[np.float64]) -> mpmath.mpf:
    """Return the distance from the cylinder, to 50 digits."""
    d = [mpmath.mpf(p) - int(c) for p, c in zip(place.tolist(), CENTRE, strict=True)]
    u = [mpmath.mpf(int(a.p)) / int(a.q) for a in AXIS]
    cross = [d[i - 2] * u[i - 1] - d[i - 1] * u[i - 2] for i in range(3)]
    length = mpmath.sqrt(sum(a**2 for a in u))
    return mpmath.sqrt(sum(c**2 for c in cross)) / length - mpmath.mpf(1) / 4


def test_no_flight_that_is_passed_over_is_as_long_as_the_distance() -> None:
    """Ways that are longer or shorter than the exact distance by roundings, and by a micrometre."""
    count = trials(1000, at_least=200)
    chance = np.random.default_rng(3)
    places = near_axis(count, chance)
    speed, pull = chance.uniform(1, 5, count), float(sum(map(abs, FALL)))
    off = chance.choice([-1, 1], count) * 10 ** chance.uniform(-16, -12, count)
    off[::2] = -1e-5
    with mpmath.workdps(50):
        distances = [exact_distance(place) for place in places]
        way = np.array([float(d) for d in distances]) + off
        horizon = 2 * way / (speed + np.sqrt(speed**2 + 2 * pull * way))
        values = dict(zip("xyz", places.T, strict=True)) | {"speed": speed, "horizon": horizon}
        values |= {"extent": np.abs(places).sum(axis=1)}
        zero = np.zeros(count)
        values |= dict.fromkeys(("position_error", "velocity_error", "earliest_delay"), zero)
        assert FINDER.clear is not None
        clear = in_doubles(FINDER.clear)(values) > 0
        flown = [
            mpmath.mpf(t) * (mpmath.mpf(v) + mpmath.mpf(pull) * mpmath.mpf(t) / 2)
            for t, v in zip(horizon.tolist(), speed.tolist(), strict=True)
        ]
        beyond = np.array([way < d for way, d in zip(flown, distances, strict=True)])
    assert beyond[clear].all()
    assert clear[::2].all()
