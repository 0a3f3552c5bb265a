"""The time after which a ball is too far from a surface for good: a search goes no further.

Where no end is in the ball's way the surface that the search knows may go on for ever, but the body
does not.
"""

from __future__ import annotations

import random
from typing import Any

import pytest
import sympy as sp
from hoopgen.derive.events.box_windows import RELATIVE_INFLATION, exit_time
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY
from mpmath import mpf

from tests.derive.test_evaluation import digits, exactly, in_doubles
from tests.helpers.effort import trials

CENTRE = (sp.Rational(1, 3), sp.Integer(0), sp.Rational(-1, 4))
DISTANCE = sp.Rational(3, 5)
GRAVITY = sp.Symbol("g", positive=True)
ANY = sp.symbols("ax ay az", real=True)
ACCELERATIONS = {"down": (0, 0, -GRAVITY), "two axes": (GRAVITY, 0, -GRAVITY / 8), "any": ANY}


def shot(chance: random.Random, kind: str) -> dict[str, Any]:
    """Return a flight, near the centre or far away, slow or fast, with or without gravity."""
    size, fastest = 10 ** chance.uniform(-1, 3), chance.choice((0, 1, 30))
    values: dict[str, Any] = {str(p): chance.uniform(-size, size) for p in POSITION}
    values |= {str(v): chance.uniform(-fastest, fastest) for v in VELOCITY}
    if chance.random() < 0.3:  # past the centre, against what gravity there is
        values |= dict.fromkeys(("x", "y", "vx", "vy"), 0.0) | {"z": -size, "vz": float(fastest)}
    if kind == "any":
        pulls = chance.choice(((0, 0, 0), (0, 0, -9.81), (1e-17, 3, -9), (0, 1e-3, 0)))
        values |= dict(zip(map(str, ANY), pulls, strict=True))
    else:
        values["g"] = chance.uniform(1, 20)
    values["extent"] = sum(abs(values[str(p)]) for p in POSITION)
    values["speed"] = sum(abs(values[str(v)]) for v in VELOCITY)
    return values | {"horizon": mpf("inf")}


@pytest.mark.parametrize("kind", list(ACCELERATIONS))
def test_after_it_the_true_ball_is_further_off_with_all_errors_one_way(kind: str) -> None:
    """The time is computed in doubles. With the errors that are not lost, nothing comes back."""
    chance = random.Random(7)
    acceleration = [sp.sympify(part) for part in ACCELERATIONS[kind]]
    until, excess = exit_time(CENTRE, DISTANCE, acceleration)
    left = shortest = 0
    for _ in range(trials(200, at_least=60)):
        values = shot(chance, kind)
        errors = {"position_error": 0.0, "velocity_error": 0.0}
        given = {name: float(value) for name, value in (values | errors).items()}
        latest = float(in_doubles({"t": until}, given)["t"])
        if latest == float("inf"):  # it rests, or moves nowhere
            assert kind == "any"
            assert values["speed"] == 0
            continue
        with digits(40):
            least, one = (
                exactly(excess, values | {"position_error": 0, "velocity_error": e}) for e in (0, 1)
            )
            share = chance.uniform(0, 1)
            place_error = -least * share
            error = -least * (1 - share) / (one - least) if one > least else mpf(0)
            pulls = [exactly(a, values) for a in acceleration]
            centre = [exactly(c, {}) for c in CENTRE]
            far = exactly(DISTANCE, {})
            for later in (latest, 1.001 * latest, 2 * latest, 30 * latest):
                aside = []
                for p, v, a, c in zip(POSITION, VELOCITY, pulls, centre, strict=True):
                    there = values[str(p)] + later * (values[str(v)] + later * a / 2) - c
                    aside.append(abs(there) - place_error - error * later)
                assert max(aside) > far, (values, later)
            left += 1
            fastest = max(abs(values[str(v)]) for v in VELOCITY)
            size = values["extent"] + 2 * far
            flies = size / fastest if fastest else mpf("inf")
            sizes = [abs(a) for a in pulls if a]
            falls = [(fastest + (fastest**2 + 2 * a * size) ** 0.5) / a for a in sizes]
            # Where gravity is known each axis has its fall, else the first one counts.
            shortest += latest < 8 * (min([flies, *falls]) if kind == "any" else max(falls))
    assert left > 40
    assert shortest > 0.8 * left  # it is no useless bound


def test_errors_near_the_distance_are_said() -> None:
    _, excess = exit_time(CENTRE, DISTANCE, [sp.sympify(a) for a in ACCELERATIONS["down"]])
    values = dict.fromkeys((*map(str, POSITION), *map(str, VELOCITY)), 0.0)
    values |= {"g": 10.0, "extent": 0.0, "speed": 0.0, "horizon": mpf("inf")}
    allowed = float(RELATIVE_INFLATION / 4 * DISTANCE)
    with digits(30):
        for error, said in ((0.99 * allowed, False), (1.01 * allowed, True)):
            found = exactly(excess, values | {"position_error": error, "velocity_error": 0.0})
            assert (found > 0) is said
