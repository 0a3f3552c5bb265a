"""Margins of the condition of a turned box, and the bound on how the gap bends beside it."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import sympy as sp
from hoopgen.derive.events.oblique_box import ObliqueBoxRootFinder
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.surfaces import ObliqueBox
from numpy.typing import NDArray

from tests.helpers.derived import evaluation

Floats = NDArray[np.float64]

BALL, HALF = sp.Rational(1, 16), sp.Rational(1, 2)
FALL = (sp.Integer(1), sp.Integer(-2), sp.Integer(-9))
TURN = tuple(sp.Rational(n, 8) for n in (7, 2, -3, 1))
BOX = ObliqueBox("turned", (-HALF,) * 3, (HALF,) * 3, BALL, (sp.Integer(0),) * 3, TURN)
FINDER = ObliqueBoxRootFinder(Parabola(FALL, departs=True), BOX)
ROTATION = np.array([[float(entry) for entry in row] for row in BOX.rotation])
SCALE = float(sum(q**2 for q in TURN))


def in_doubles(output: sp.Expr) -> Callable[[dict[str, Any]], Floats]:
    """Return the function from values by name to a formula, as kernels evaluate it."""
    order = sorted(output.free_symbols, key=str)
    run = evaluation(kernel("sample", {"found": output}, order, "A sample.", "Eq. 2"), tuple(order))
    return lambda values: np.asarray(run(*(values[str(symbol)] for symbol in order))[0])


def beside(count: int, chance: np.random.Generator) -> Floats:
    """Return places along the axes of the box, (n, 3), that touch it, at a face or an edge."""
    places = chance.uniform(-1, 1, (count, 3)) * float(HALF)
    kept = chance.integers(1, 8, count)
    for k in range(3):
        beyond = (kept >> k) % 2 == 1
        places[beyond, k] = np.sign(places[beyond, k]) * float(HALF)
    out = places / float(HALF)
    out[np.abs(out) < 1] = 0.0
    out *= np.abs(chance.normal(0, 1, (count, 3)))
    return np.asarray(places + float(BALL) * out / np.linalg.norm(out, axis=1)[:, None])


def flights(places: Floats, chance: np.random.Generator) -> dict[str, Any]:
    """Return the values of searches that begin at places along the axes of the box."""
    there, moving = places @ ROTATION.T / SCALE, chance.normal(0, 1, places.shape)
    found: dict[str, Any] = dict(zip("xyz", there.T, strict=True))
    found |= {f"v{axis}": v for axis, v in zip("xyz", moving.T, strict=True)}
    found |= {"extent": np.abs(there).sum(axis=1), "speed": np.abs(moving).sum(axis=1)}
    zero = np.zeros(len(places))
    found |= dict.fromkeys(("t", "leaving", "position_error", "velocity_error"), zero)
    return found | {"horizon": zero + 1e-9}


def exact(place: list[Fraction]) -> Fraction:
    """Return the condition at a place, exactly."""
    rotation = [[Fraction(entry) for entry in row] for row in ROTATION.tolist()]
    scale, half = Fraction(SCALE), Fraction(1, 2)
    own = [sum((rotation[j][k] * place[j] for j in range(3)), Fraction(0)) for k in range(3)]
    beyond = [max(abs(x) - scale * half, Fraction(0)) for x in own]
    return sum((e**2 for e in beyond), Fraction(0)) - (scale / 16) ** 2


def test_the_margin_of_a_turned_box_contains_errors_of_places_and_roundings() -> None:
    """Far from the box with a share of the gap itself, near it without."""
    chance, count = np.random.default_rng(1), 600
    places = beside(count, chance)
    far = chance.uniform(0, 1, count) < 0.5
    places[far] += chance.normal(0, 0.4, (far.sum(), 3))
    values = flights(places, chance)
    values["position_error"] = 10.0 ** chance.uniform(-12, -6, count)
    gap = in_doubles(FINDER.gap)(values)
    values["margin"] = margin = in_doubles(FINDER.margins["margin"])(values)
    held = sp.Symbol("held", real=True)
    low = in_doubles(FINDER._low_gap(held))(values | {"held": gap})
    wide = values["position_error"][:, None] * chance.choice([-1.0, 1.0], places.shape)
    there = np.stack([values[axis] for axis in "xyz"], axis=1)
    moved = [
        exact([Fraction(x) + Fraction(d) for x, d in zip(*rows, strict=True)])
        for rows in zip(there.tolist(), wide.tolist(), strict=True)
    ]
    outside = np.array([f > 0 for f in moved])
    below = np.array([Fraction(one) <= f for one, f in zip(low.tolist(), moved, strict=True)])
    assert below[outside].all()
    away = np.array([float(abs(Fraction(g) - f)) for g, f in zip(gap.tolist(), moved, strict=True)])
    assert (away[~far] <= margin[~far]).all()
    # It is no more than some ten times the largest error there.
    assert (away[~far] / margin[~far]).max() > 0.05
    # Without the share it would not hold far away.
    assert (away[far] > margin[far]).any()


def test_the_gap_of_a_ball_beside_a_turned_box_bends_no_more_than_its_bound() -> None:
    """Often it opens more and more, which a bound by the acceleration alone does not say."""
    chance, count, width = np.random.default_rng(2), 3000, sp.Symbol("width", positive=True)
    start = beside(count, chance) * chance.uniform(0.9, 1.1, (count, 1))
    values = flights(start, chance)
    values |= {"width": 10 ** chance.uniform(-4, -0.5, count), "horizon": np.full(count, 2.0)}
    values["ceiling"] = in_doubles(FINDER.ceiling)(values)
    bound = in_doubles(FINDER.curvature(width))(values)
    general = in_doubles(FINDER._pull_bound(width))(values)
    bend, met = in_doubles(FINDER.bend), 0
    for share in np.linspace(0, 1, 17):
        time = share * values["width"]
        there = np.stack(
            [
                values[axis] + time * values[f"v{axis}"] + float(a) / 2 * time**2
                for axis, a in zip("xyz", FALL, strict=True)
            ],
            axis=1,
        )
        own = np.abs(there @ ROTATION) / SCALE
        near = (own <= float(HALF + BALL)).all(axis=1)
        met += near.sum()
        assert (-bend(values | {"t": time}) <= bound)[near].all()
    assert met > 5 * count
    assert (bound <= general * (1 + 1e-9)).all()
    assert (bound < general / 2).mean() > 0.2
