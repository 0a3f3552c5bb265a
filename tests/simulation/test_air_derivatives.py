"""Derivatives of shots in air: to 35 digits, in both engines, in chains, and without the air."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.core.parameters import AIR_DEFAULTS
from hoopgen.core.variables import STATE
from hoopgen.scene import Box, End, Parameter, Plane, Scene, Sphere
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

pytest.importorskip("sympy")
pytest.importorskip("mpmath")
pytest.importorskip("flint")

from tests.helpers.precise_air import PreciseAir
from tests.simulation.test_change_distance import beside_changes, distances, throws
from tests.simulation.test_derivatives import FREE_THROW, check_against_truth

# One worker: each scene is compiled once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("air")]

OF_AIR = tuple(AIR_DEFAULTS)


@cache
def yard(air: bool = True) -> Engine:
    """Return a step, a globe and a floor that ends shots, in air or without."""
    scene = Scene(
        "yard_in_air" if air else "yard",
        parameters=[
            Parameter("ball_radius", 0.12, "m"),
            Parameter("gravity", 9.81, "m/s2"),
            Parameter("bounce", 0.75, "1"),
        ],
        bodies=[
            Box("step", size=(3.0, 3.0, 0.5), centre=(0.0, 0.0, 0.25)),
            Sphere("globe", centre=(1.0, 0.0, 1.2), radius=0.4),
            Plane("wall", axis="x", at=-3),
        ],
        ball_radius="ball_radius",
        gravity="gravity",
        restitution="bounce",
        friction=0.3,
        ends={"floor": End(at=-0.3)},
        air=air,
    )
    return hoopgen.compile(scene)


def free_throws(shots: int, seed: int = 7) -> Any:
    """Return free throws in air, with spin about every axis."""
    random = np.random.default_rng(seed)
    states = hoopgen.release(
        random.normal(7.5, 0.15, shots),
        random.normal(0.9, 0.05, shots),
        random.normal(0, 0.03, shots),
        backspin=random.normal(15, 5, shots),
        sidespin=random.normal(0, 5, shots),
        **FREE_THROW,
    )
    states[:, 6] += random.normal(0, 5, shots)
    return states


def yard_throws(shots: int, seed: int = 1) -> Any:
    """Return throws at the globe, with spin."""
    random = np.random.default_rng(seed)
    mean = np.array([-1.0, 0.0, 1.5, 3.0, 0.0, 2.0, 0.0, 0.0, 0.0])
    spread = np.array([0.3, 0.2, 0.3, 1.0, 0.3, 1.0, 20.0, 20.0, 20.0])
    return mean + spread * random.normal(size=(shots, 9))


@pytest.mark.slow
def test_derivatives_are_those_of_35_digits() -> None:
    names = (*STATE, *OF_AIR, "restitution", "ball_radius", "gravity", "ring_radius", "inertia")
    states = free_throws(30)
    shots = hoopgen.AIR.simulate(states)
    order = np.argsort(-shots.contacts, kind="stable")  # five contacts first, then few
    rows = order[[0, *range(5, 30, 5)]]
    most = trials(6, at_least=2)
    contacts = check_against_truth(hoopgen.AIR, states[rows], {}, names, most, PreciseAir)
    assert contacts.max() >= 5


@pytest.mark.slow
def test_derivatives_of_many_shots_are_those_of_35_digits() -> None:
    names = ("vx", "wy", *OF_AIR, "restitution", "board_distance", "end_depth", "inertia")
    most = trials(12, at_least=10)
    contacts = check_against_truth(hoopgen.AIR, free_throws(60, 11), {}, names, most, PreciseAir)
    assert len(contacts) == most
    assert {1, 2, 5} <= set(contacts)


@pytest.mark.slow
@pytest.mark.parametrize("inertia", [0.1, 2 / 5, 1.0])
def test_derivatives_by_the_inertia_are_those_of_35_digits(inertia: float) -> None:
    states, given = free_throws(60, 11), {"inertia": inertia}
    order = np.argsort(-hoopgen.AIR.simulate(states, given).contacts, kind="stable")
    most = trials(6, at_least=2)
    rows, names = order[[0, *range(5, 30, 5)]], ("vx", "vz", "wy", "inertia")
    contacts = check_against_truth(hoopgen.AIR, states[rows], given, names, most, PreciseAir)
    assert contacts.max() >= 3


@pytest.mark.slow
def test_derivatives_in_an_own_scene_are_those_of_35_digits() -> None:
    names = ("vx", "vz", "wy", *OF_AIR, "ball_radius", "gravity", "bounce")
    states = yard_throws(40)
    order = np.argsort(-yard().simulate(states).contacts, kind="stable")  # most contacts first
    most = trials(4, at_least=2)
    contacts = check_against_truth(yard(), states[order], {}, names, most, PreciseAir)
    assert contacts.max() >= 3


def test_both_engines_give_the_same_bits() -> None:
    states, names = free_throws(60), ("vx", "wz", "ball_mass", "ball_radius")
    found = [
        hoopgen.AIR.simulate(states, backend=backend, derivatives=names, record=True)
        for backend in ("c", "numpy")
    ]
    assert found[0].differentiable.sum() > 40
    for which in ("event_jacobian", "jacobian"):
        for one, other in zip(*(getattr(s, which).values() for s in found), strict=True):
            assert np.array_equal(one, other, equal_nan=True)
    assert np.array_equal(*(shots.differentiable for shots in found))


def test_without_air_derivatives_are_those_of_the_parabola() -> None:
    names = (*STATE, "restitution", "gravity", "ball_radius")
    states = free_throws(60)
    own = hoopgen.AIR.simulate(states, {"air_density": 0.0}, derivatives=names)
    plain = hoopgen.simulate(states, derivatives=names)
    same = own.differentiable & plain.differentiable
    assert same.sum() > 40
    for name, expected in plain.jacobian.items():
        size = np.abs(expected[same]).max(axis=(1, 2), keepdims=True)
        off = np.abs(own.jacobian[name][same] - expected[same]) / size
        growth = np.abs(plain.jacobian["state"][same]).max(axis=(1, 2), keepdims=True)
        assert np.all(off < 1e-13 * np.maximum(1.0, growth))


def test_of_little_air_derivatives_differ_in_proportion_to_it() -> None:
    names = ("vx", "vz", "wy", "gravity")
    states = free_throws(40)
    plain = hoopgen.simulate(states, derivatives=names)
    off = []
    for density in (1e-6, 1e-7):
        own = hoopgen.AIR.simulate(states, {"air_density": density}, derivatives=names)
        same = own.differentiable & plain.differentiable & (plain.contacts <= 1)
        assert same.sum() > 10
        off.append(np.abs(own.jacobian["state"] - plain.jacobian["state"])[same].max(axis=(1, 2)))
    np.testing.assert_allclose(off[0] / off[1], 10.0, rtol=1e-3, atol=0.0)


def test_products_with_tangents_and_cotangents_are_those_of_the_jacobian() -> None:
    states = free_throws(20)
    shots, changes = hoopgen.jvp(
        states, None, {"vx": 0.3, "drag_coefficient": -0.1}, scene=hoopgen.AIR
    )
    matrix = shots.jacobian["state"]
    np.testing.assert_allclose(
        changes["state"], matrix @ np.array([0.3, -0.1]), rtol=1e-12, atol=1e-12
    )
    _, gradients = hoopgen.vjp(states, None, {"time": 2.0}, scene=hoopgen.AIR)
    assert set(gradients) == {*STATE, *hoopgen.AIR.parameters}
    expected = 2.0 * shots.jacobian["time"][:, 0]
    for column, name in enumerate(("vx", "drag_coefficient")):
        np.testing.assert_allclose(gradients[name], expected[:, column], rtol=1e-12, atol=0.0)


def test_derivatives_chain_with_those_of_a_release() -> None:
    values = {"speed": 7.45, "elevation": 0.91, "azimuth": 0.02, "backspin": 12.0, "sidespin": 1.0}
    values |= {"height": 2.1, "distance": 4.2, "angle": 0.1}
    states, by_release = hoopgen.release(**values, jacobian=True)
    chained = hoopgen.AIR.simulate(states, derivatives=STATE).jacobian.chain(by_release)
    for column, name in enumerate(values):
        step = 1e-6
        ends = [
            hoopgen.AIR.simulate(
                hoopgen.release(**values | {name: values[name] + sign * step})
            ).state
            for sign in (1, -1)
        ]
        expected = (ends[0] - ends[1])[0] / (2 * step)
        np.testing.assert_allclose(chained["state"][0, :, column], expected, rtol=1e-5, atol=1e-5)


@pytest.mark.slow
def test_distances_to_changes_are_those_of_bisection() -> None:
    for values, known in beside_changes(hoopgen.AIR, {}, throws(30, speed=7.5), 1e-7):
        shots, distance = distances(hoopgen.AIR, {}, values)
        share = distance[known & shots.differentiable].min(axis=1) / 1e-7
        assert len(share) >= 5
        np.testing.assert_allclose(np.median(share), 1.0, rtol=0.02, atol=0.0)


def test_without_air_distances_to_changes_are_those_of_the_parabola() -> None:
    states, names = free_throws(60), ("vx", "vy", "vz")
    own = hoopgen.AIR.simulate(states, {"air_density": 0.0}, derivatives=names, record=True)
    plain = hoopgen.simulate(states, derivatives=names, record=True)
    assert own.decisions == plain.decisions
    same = own.differentiable & plain.differentiable
    assert same.sum() > 40
    # Above the bridge the height at a contact does not vary, apart from roundings.
    found, expected = (
        np.where(distance > 1e12, np.inf, distance)
        for distance in (own.change_distance()[same], plain.change_distance()[same])
    )
    np.testing.assert_allclose(found, expected, rtol=1e-7, atol=1e-12)


def test_parameters_by_shot_have_their_own_derivatives() -> None:
    states = np.repeat(free_throws(1), 3, axis=0)
    density = np.array([1.0, 1.1, 1.2])
    by = ("drag_coefficient", "wy")
    together = hoopgen.AIR.simulate(states, {"air_density": density}, derivatives=by)
    for index, value in enumerate(density):
        alone = hoopgen.AIR.simulate(states[index], {"air_density": value}, derivatives=by)
        np.testing.assert_array_equal(together.jacobian["state"][index], alone.jacobian["state"][0])
