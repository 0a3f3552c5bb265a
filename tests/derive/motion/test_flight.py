"""Flights: their paths, and which search a surface has along them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.errors import propagation
from hoopgen.derive.events import event_polynomials, root_finder_for, search_for
from hoopgen.derive.events.plane import PlaneSearch
from hoopgen.derive.events.polynomial import PolynomialRootFinder
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.motion.flight import Flight
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import AXES
from hoopgen.derive.surfaces import Surface
from hoopgen.derive.symbolic import error_terms
from hoopgen.derive.symbolic.polynomials import Coefficients, horner
from hoopgen.derive.symbolic.rounding import Rounded
from hoopgen.derive.symbolic.symbols import NORMAL, POSITION, VELOCITY, t
from mpmath import cos, findroot, mpf, sin

from tests.derive.test_evaluation import PARAMETERS, digits, exactly
from tests.helpers.effort import trials

RING, BOARD, BRIDGE = HOOP.surfaces
FLIGHTS = {str(axis): replace(HOOP, gravity_axis=axis).flight for axis in AXES}
SIDEWAYS = [name for name, flight in FLIGHTS.items() if not flight.upright]
flights = pytest.mark.parametrize("axis", AXES, ids=str)


# -- Paths


@flights
def test_a_parabola_solves_newtons_equations_from_the_state(axis: tuple[int, int, int]) -> None:
    flight = FLIGHTS[str(axis)]
    place, motion = flight.at()
    assert sp.expand(sp.diff(place, t) - motion) == sp.zeros(3, 1)
    assert list(sp.diff(motion, t)) == [HOOP.gravity * component for component in axis]
    assert list(place.subs(t, 0)) == list(POSITION)
    assert list(motion.subs(t, 0)) == list(VELOCITY)
    for symbol, component in zip(POSITION, place, strict=True):
        assert sp.expand(horner(flight.path[symbol], t) - component) == 0
    assert flight.exact
    assert flight.strength == HOOP.gravity
    assert flight.upright == (axis == (0, 0, -1))


def test_the_size_of_gravity_is_that_of_its_vector() -> None:
    for fall, size in (((1, -4, 8), 9), ((0, 3, -4), 5), ((0, -2, 0), 2), ((0, 0, 0), 0)):
        ax, ay, az = map(sp.Integer, fall)
        assert exactly(Parabola((ax, ay, az)).gravity, {}) == size


def test_free_fall_askew_is_no_stronger_than_its_largest_component() -> None:
    slant = Parabola((sp.Integer(1), sp.Integer(0), sp.Integer(-3)))
    assert exactly(slant.strength, {}) == 3
    assert slant.at()[1][2] == VELOCITY[2] - 3 * t


def test_a_flight_without_acceleration_is_straight() -> None:
    straight = Parabola((sp.Integer(0), sp.Integer(0), sp.Integer(0)))
    assert not straight.falls
    assert straight.strength == 0
    place, motion = straight.at()
    assert list(motion) == list(VELOCITY)
    for component, start, v in zip(place, POSITION, VELOCITY, strict=True):
        assert sp.expand(component - start - v * t) == 0


def test_a_flight_falls_only_if_its_acceleration_cannot_be_zero() -> None:
    some = sp.Symbol("some", nonnegative=True)
    assert HOOP.flight.falls
    assert not Parabola((sp.Integer(0), sp.Integer(0), -some)).falls
    assert not Parabola((sp.Integer(0), sp.Symbol("any", real=True), sp.Integer(0))).falls


# -- What is carried along them


def test_bounds_ask_how_strong_free_fall_is_not_where_it_goes() -> None:
    lengths = [p.symbol for p in HOOP.parameters if p.unit == "m"]
    for flight in FLIGHTS.values():
        assert event_polynomials.displacement(flight, lengths) == event_polynomials.displacement(
            HOOP.flight, lengths
        )
        assert event_polynomials.error_budget(flight) == event_polynomials.error_budget(HOOP.flight)
        assert event_polynomials.padded_horizon(flight) == event_polynomials.padded_horizon(
            HOOP.flight
        )


@pytest.mark.parametrize("steps", [1, 2])
def test_errors_are_carried_along_any_axis_as_along_z(steps: int) -> None:
    """x, y, z renamed in turn, everywhere: the same numbers, under other names."""

    def renamed(vector: Sequence[sp.Symbol]) -> dict[str, str]:
        return {s.name: vector[(k + steps) % 3].name for k, s in enumerate(vector)}

    vectors = (POSITION, VELOCITY, NORMAL, error_terms.dx, error_terms.dv)
    names = {old: new for vector in vectors for old, new in renamed(vector).items()}
    x, y, z = (AXES[5][(k - steps) % 3] for k in range(3))
    usual = propagation.errors_at_contact(HOOP.flight)
    other = propagation.errors_at_contact(FLIGHTS[str((x, y, z))])
    rng = np.random.default_rng(steps)
    symbols = {s.name for e in (*usual.values(), *other.values()) for s in e.free_symbols}
    with digits(40):
        for _ in range(trials(20)):
            values: dict[str, Any] = {name: mpf(rng.normal()) for name in sorted(symbols)}
            values |= {
                name: abs(values[name]) for name in ("earliest_delay", "clock", "contacts", "t")
            }
            values |= {"curving": mpf(3), "gravity": mpf(PARAMETERS["gravity"])}
            moved = {names.get(name, name): value for name, value in values.items()}
            for name, e in usual.items():
                same, wanted = exactly(other[names.get(name, name)], moved), exactly(e, values)
                assert abs(same - wanted) <= mpf(10) ** -30 * (1 + abs(wanted))


def _hop(place: list[Any], velocity: list[Any]) -> tuple[Any, list[Any]]:
    """Return when a ball is as far from the origin again as it was, and where; free fall is -z."""
    g = mpf(PARAMETERS["gravity"])

    def at(t: Any) -> list[Any]:
        return [
            p + v * t - (g * t * t / 2 if k == 2 else 0)
            for k, (p, v) in enumerate(zip(place, velocity, strict=True))
        ]

    def off(t: Any) -> Any:
        return sum((p * p - q * q for p, q in zip(at(t), place, strict=True)), mpf(0)) / t

    # The speed off the unit sphere by half of what presses the ball onto it.
    press = g * place[2] - sum((v * v for v in velocity), mpf(0))
    rate = sum((p * v for p, v in zip(place, velocity, strict=True)), mpf(0))
    t = findroot(off, 2 * rate / press)
    return t, at(t)


@pytest.mark.parametrize("small", [2, 4, 6])
def test_errors_of_a_hop_are_those_of_the_ball_that_comes_back_to_where_it_was(small: int) -> None:
    """On a unit sphere, with a speed V off it: by differences, whatever V; off the sphere, too."""
    with digits(60):
        slope = mpf(1) / 5
        place = [mpf(0), sin(slope), cos(slope)]
        over = [mpf(1) / 3, cos(slope), -sin(slope)]
        bounce = mpf(10) ** -small
        velocity = [v + bounce * p for v, p in zip(over, place, strict=True)]
        t, there = _hop(place, velocity)
        g = mpf(PARAMETERS["gravity"])
        moving = [*velocity[:2], velocity[2] - g * t]
        values = dict(zip(("x", "y", "z"), there, strict=True))
        values |= dict(zip(("vx", "vy", "vz"), moving, strict=True))
        values |= {f"n{axis}": p for axis, p in zip("xyz", there, strict=True)}
        values |= {f"left_n{axis}": p for axis, p in zip("xyz", place, strict=True)}
        values |= {name: mpf(0) for name in ("earliest_delay", "clock")}
        values |= {"t": t, "gravity": g, "contacts": mpf(9), "curving": mpf(1)}
        # What V is off by is as small as V, which is v·n: n turns as the place does.
        dx = [mpf(1), mpf(2), mpf(1) / 2]
        flat = sum((d * v for d, v in zip(dx, velocity, strict=True)), mpf(0))
        dv = [mpf(3), -mpf(1), mpf(2)]
        turned = sum((d * p for d, p in zip(dv, place, strict=True)), mpf(0))
        dv = [d - (turned + flat - bounce) * p for d, p in zip(dv, place, strict=True)]
        values |= {f"d{axis}": d for axis, d in zip("xyz", dx, strict=True)}
        values |= {f"dv{axis}": d for axis, d in zip("xyz", dv, strict=True)}
        step = mpf(10) ** -25
        moved = [p + step * d for p, d in zip(place, dx, strict=True)]
        _, beside = _hop(moved, [v + step * d for v, d in zip(velocity, dv, strict=True)])
        carried = propagation.errors_at_contact(HOOP.flight, returning=True)
        for axis, one, other in zip("xyz", beside, there, strict=True):
            wanted = (one - other) / step
            # Roundings of a hop count as u |v|²/g: of what an error of one part is nothing.
            assert abs(exactly(carried[f"d{axis}"], values) - wanted) < mpf(10) ** -13


# -- Which search


def test_the_ring_is_searched_by_its_own_search_where_free_fall_is_down() -> None:
    assert isinstance(root_finder_for(RING, HOOP.flight), RingRootFinder)
    for name in SIDEWAYS:
        assert isinstance(root_finder_for(RING, FLIGHTS[name]), PolynomialRootFinder)


@pytest.mark.parametrize("name", SIDEWAYS)
def test_the_rings_own_search_refuses_any_other(name: str) -> None:
    with pytest.raises(ValueError, match=r"surface ring: .* expects free fall along -z, got"):
        RingRootFinder(FLIGHTS[name], RING)


@flights
def test_planes_have_a_closed_form_along_every_axis(axis: tuple[int, int, int]) -> None:
    for plane in (BOARD, BRIDGE):
        assert isinstance(search_for(plane, FLIGHTS[str(axis)]), PlaneSearch)
    with pytest.raises(TypeError, match="surface backboard: its arrival is a closed form"):
        root_finder_for(BOARD, FLIGHTS[str(axis)])


@dataclass(frozen=True)
class Jerked(Flight):
    """A flight of degree 3, which may end, or be off its path."""

    until: sp.Expr = sp.oo
    beside: sp.Expr = sp.Integer(0)

    @property
    def path(self) -> dict[sp.Symbol, Coefficients]:
        parabola = Parabola(self.acceleration).path
        return parabola | {POSITION[2]: [*parabola[POSITION[2]], sp.Integer(1)]}

    @property
    def span(self) -> sp.Expr:
        return self.until

    @property
    def remainder(self) -> sp.Expr:
        return self.beside

    def size(self, latest: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        raise NotImplementedError

    def rounding(self, latest: sp.Expr) -> tuple[Rounded, Rounded]:
        raise NotImplementedError

    def mean_velocity(self, time: sp.Expr = t) -> list[sp.Expr]:
        return [(horner(self.path[p], time) - p) / time for p in POSITION]

    def mean_rounding(self, latest: sp.Expr) -> Rounded:
        raise NotImplementedError

    @property
    def present_acceleration(self) -> tuple[sp.Expr, ...]:
        return self.acceleration

    def along(self) -> tuple[list[sp.Expr], list[sp.Expr]]:
        raise NotImplementedError

    def path_lengths(self) -> list[sp.Expr]:
        raise NotImplementedError


@pytest.mark.parametrize("surface", HOOP.surfaces, ids=lambda surface: surface.name)
def test_a_flight_of_another_kind_has_the_general_search_if_its_path_is_exact(
    surface: Surface,
) -> None:
    falls = HOOP.flight.acceleration
    assert isinstance(root_finder_for(surface, Jerked(falls)), PolynomialRootFinder)
    degree = len(event_polynomials.event_coefficients(BRIDGE, Jerked(falls))) - 1
    assert degree == 3
    wanted = f"surface {surface.name}: no search for a .* along a Jerked; the general one expects"
    for flight in (Jerked(falls, until=sp.Integer(2)), Jerked(falls, beside=sp.Rational(1, 8))):
        with pytest.raises(TypeError, match=wanted):
            search_for(surface, flight)
