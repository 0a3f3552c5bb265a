"""Boxes: their normal on a face, and how far it turns along a flight or within an error."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.errors import propagation
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.surfaces import Box
from hoopgen.derive.surfaces.oblique_box import ObliqueBox
from hoopgen.derive.symbolic.conditionals import Barrier, IfLess
from hoopgen.derive.symbolic.error_terms import dv, dx
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY
from numpy.typing import NDArray

from tests.helpers.effort import trials

Floats = NDArray[np.float64]

RADIUS, HALVES, CENTRE = 0.05, (0.4, 0.3, 0.1), (0.2, -0.1, 0.3)
TURN = (0.8, 0.3, -0.4, 0.6)
"""A quaternion that is no unit: the coordinates along the turned box's axes are as much longer."""
GRAVITY = 9.81
REACH = sp.symbols("reach_x reach_y reach_z", nonnegative=True)
FLIGHT = Parabola((sp.Integer(0), sp.Integer(0), -sp.Float(GRAVITY)))


def made(turned: bool) -> Box:
    """Return a box of numbers along the axes, or turned."""
    radius = sp.Float(RADIUS)
    if turned:
        high, low = (tuple(sp.Float(sign * half) for half in HALVES) for sign in (1, -1))
        centre = tuple(map(sp.Float, CENTRE))
        turn = tuple(map(sp.Float, TURN))
        return ObliqueBox("box", low, high, radius, centre, turn)
    low, high = (
        tuple(sp.Float(at + sign * half) for at, half in zip(CENTRE, HALVES, strict=True))
        for sign in (-1, 1)
    )
    return Box("box", low, high, radius)


def evaluated(expression: sp.Basic, **given: Floats) -> Floats:
    """Return the values of a formula in doubles."""
    rows = len(next(iter(given.values())))

    @cache
    def value(e: sp.Basic) -> Any:
        if e.is_Symbol:
            return given[str(e)]
        if e.is_Number:
            return float(e)
        parts = [value(part) for part in e.args]
        if isinstance(e, sp.Mul) and any(part.is_Pow and part.exp == -1 for part in e.args):
            over, under = sp.fraction(e)  # printed as a division
            return value(over) / value(under)
        if isinstance(e, IfLess):
            return np.where(parts[0] < parts[1], parts[2], parts[3])
        return {
            sp.Add: sum,
            sp.Mul: math.prod,
            sp.Pow: lambda two: two[0] ** two[1],
            sp.Abs: lambda one: np.abs(one[0]),
            Barrier: lambda one: one[0],
        }[type(e)](parts)

    return np.broadcast_to(np.asarray(value(sp.sympify(expression)), float), (rows,))


def by_axis(symbols: Any, values: Floats) -> dict[str, Floats]:
    return {str(symbol): column for symbol, column in zip(symbols, values.T, strict=True)}


def rotation() -> Floats:
    """Return the rotation of the turned box."""
    w, *axis = np.array(TURN) / np.linalg.norm(TURN)
    i, j, k = axis
    cross = np.array([[0, -k, j], [k, 0, -i], [-j, i, 0]])
    found: Floats = np.eye(3) + 2 * w * cross + 2 * cross @ cross
    return found


def touching(outside: Floats, turned: bool) -> tuple[Floats, Floats]:
    """Return the places at which a ball touches the box, nearest to some points, and normals.

    They are NaN for points in the box.
    """
    axes = rotation() if turned else np.eye(3)
    there = (outside - CENTRE) @ axes
    nearest = np.clip(there, -np.array(HALVES), HALVES)
    away = there - nearest
    distance = np.linalg.norm(away, axis=1, keepdims=True)
    normals = away / np.where(distance > 0, distance, np.nan)
    return (nearest + RADIUS * normals) @ axes.T + CENTRE, normals @ axes.T


def neighbours(turned: bool) -> tuple[Floats, ...]:
    """Return pairs of places at which a ball touches the box, and the normals there.

    They are near each other or far apart, on faces, edges and corners, many of them at a seam; but
    not on opposite faces, from one of which to the other no ball gets within the way between them.
    """
    random, rows = np.random.default_rng(3), trials(20_000)
    first = random.uniform(-1, 1, (rows, 3)) * (np.array(HALVES) + 0.1)
    seam = np.sign(first) * HALVES + random.normal(0, 1, (rows, 3)) * 10.0 ** random.uniform(
        -5, -1, (rows, 1)
    )
    first = np.where(random.random((rows, 3)) < 0.3, seam, first)
    if turned:
        first = first @ rotation().T
    first += CENTRE
    second = first + random.normal(0, 1, (rows, 3)) * 10.0 ** random.uniform(-5, 0, (rows, 1))
    pairs = (*touching(first, turned), *touching(second, turned))
    whole = np.isfinite(np.concatenate(pairs, axis=1)).all(axis=1)
    whole &= (pairs[1] * pairs[3]).sum(axis=1) > -0.99
    return tuple(part[whole] for part in pairs)


each_box = pytest.mark.parametrize("turned", [False, True], ids=["along the axes", "turned"])


def check_turn(bound: Floats, way: Floats, normals: tuple[Floats, Floats]) -> None:
    """Check that normals differ by no more than a bound on their turn along a way, and use it."""
    turn = np.linalg.norm(normals[1] - normals[0], axis=1)
    assert (turn <= bound * way * (1 + 1e-9) + 1e-12).all()
    assert (bound == 0).mean() > 0.1
    assert (bound > 0).mean() > 0.1


@each_box
def test_within_a_distance_the_normal_of_a_box_turns_no_more_than_its_bound(turned: bool) -> None:
    first, normal, second, other = neighbours(turned)
    apart = second - first
    bound = made(turned).curvature_within(REACH)
    found = evaluated(bound, **by_axis(POSITION, first), **by_axis(REACH, np.abs(apart)))
    check_turn(found, np.linalg.norm(apart, axis=1), (normal, other))


@each_box
def test_an_error_of_the_place_turns_the_normal_of_a_box_no_more_than_is_carried(
    turned: bool,
) -> None:
    first, normal, second, other = neighbours(turned)
    apart = second - first
    shift = np.abs(apart).max(axis=1)
    turn = propagation.normal_error(made(turned))["turn"]
    given = by_axis(POSITION, first) | {"shift": shift}
    found = evaluated(turn, **given)
    check_turn(found / shift, np.linalg.norm(apart, axis=1), (normal, other))


@each_box
def test_a_flight_back_to_a_box_turns_the_normal_no_more_than_its_bound(turned: bool) -> None:
    first, normal, second, other = neighbours(turned)
    random = np.random.default_rng(4)
    time = 10.0 ** random.uniform(-3, 0, (len(first), 1))
    # Places and velocities are off, and the bound holds for those where the ball truly is.
    off = random.normal(0, 1, first.shape) * 10.0 ** random.uniform(-7, -2, (len(first), 1))
    arriving = (second - first) / time - 0.5 * time * [0, 0, GRAVITY]
    bound = propagation.curving_along(made(turned), FLIGHT)
    given = by_axis(POSITION, second + off) | by_axis(VELOCITY, arriving) | {"t": time[:, 0]}
    given |= by_axis(dx, off) | by_axis(dv, np.zeros_like(off))
    found = evaluated(bound, **given)
    check_turn(found, np.linalg.norm(second - first, axis=1), (normal, other))


def test_on_a_face_the_normal_of_a_box_is_an_axis_whatever_the_rounding_of_the_place() -> None:
    first, normal, *_ = neighbours(turned=False)
    faces = (normal != 0).sum(axis=1) == 1
    assert faces.mean() > 0.1
    places = by_axis(POSITION, first[faces] * (1 + 2.0**-50))
    for component, own in zip(made(turned=False).normal, normal[faces].T, strict=True):
        np.testing.assert_array_equal(evaluated(component, **places), own)


@each_box
def test_an_error_across_a_face_does_not_turn_the_normal(turned: bool) -> None:
    """The change of a unit vector lies across it; on a face there is none."""
    first, normal, *_ = neighbours(turned)
    box = made(turned)
    errors = np.random.default_rng(5).normal(0, 1, first.shape)
    given = by_axis(POSITION, first) | by_axis(dx, errors) | {"shift": np.ones(len(first))}
    turns = propagation.normal_error(box)
    change = np.stack([evaluated(turns[f"dn{axis}"], **given) for axis in "xyz"], axis=1)
    along = np.abs((change * normal).sum(axis=1))
    assert along.max() < 1e-11
    if not turned:
        faces = (normal != 0).sum(axis=1) == 1
        assert faces.mean() > 0.1
        assert np.abs(change[faces]).max() < 1e-12
