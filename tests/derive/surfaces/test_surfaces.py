"""Surfaces (Table 2) and their event polynomials: distance, normal, octic, degree in time."""

from __future__ import annotations

import pytest
import sympy as sp
from hoopgen.derive.events.event_polynomials import deflated_coefficients, event_coefficients
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.surfaces import Plane, Ring, Sphere, Surface
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.polynomials import horner
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY, position, t

x, y, z = POSITION
gravity = HOOP.gravity
reach, excess = sp.symbols("reach excess", positive=True)
SPHERE = Sphere("ball", tuple(sp.symbols("cx cy cz", real=True)), sp.Symbol("r", positive=True))
RING = next(s for s in HOOP.surfaces if isinstance(s, Ring))
PLANES = [s for s in (*HOOP.surfaces, *HOOP.end_planes) if isinstance(s, Plane)]
EVERY = [*HOOP.surfaces, *HOOP.end_planes, SPHERE]
surfaces = pytest.mark.parametrize("surface", EVERY, ids=lambda s: s.name)


def general_ring() -> Ring:
    """Return a ring of any size with R < R_H: R_H = R + excess."""
    return Ring("ring", reach + excess, reach)


def gap(ring: Ring) -> sp.Expr:
    """Return F = (rho - R_H)² + z² - R², Table 2's condition with its root kept."""
    return (ring.rho - ring.ring_radius) ** 2 + z**2 - ring.reach**2


def other(ring: Ring) -> sp.Expr:
    """Return the other factor of the octic."""
    return (ring.rho + ring.ring_radius) ** 2 + z**2 - ring.reach**2


def on_the_ring(ring: Ring) -> dict[sp.Symbol, sp.Expr]:
    """Return every point of contact: the angles along the ring and around its wire."""
    along, around = sp.symbols("along around", real=True)
    out = ring.ring_radius + ring.reach * sp.cos(around)
    return {x: out * sp.cos(along), y: out * sp.sin(along), z: ring.reach * sp.sin(around)}


# -- Flight, Eq. 3


def test_the_flight_solves_newtons_equations_from_the_state() -> None:
    place, motion = HOOP.flight.at()
    assert sp.expand(sp.diff(place, t) - motion) == sp.zeros(3, 1)
    assert sp.diff(motion, t) == sp.Matrix([0, 0, -gravity])
    assert list(place.subs(t, 0)) == list(POSITION)
    assert list(motion.subs(t, 0)) == list(VELOCITY)


def test_the_flights_coefficients_are_the_flight() -> None:
    place, _ = HOOP.flight.at()
    coefficients = HOOP.flight.path
    for symbol, component in zip(POSITION, place, strict=True):
        assert sp.expand(horner(coefficients[symbol], t) - component) == 0


# -- The ring's octic


def test_the_octic_is_the_gap_times_a_second_factor() -> None:
    ring = general_ring()
    assert sp.expand(ring.condition - gap(ring) * other(ring)) == 0


def test_the_octics_second_factor_has_no_real_root_where_the_ball_fits_the_ring() -> None:
    """For rho >= 0 and R_H = R + excess the factor is a sum of terms that are not negative."""
    ring = general_ring()
    terms = sp.expand(other(ring).subs(ring.rho, sp.Symbol("rho", nonnegative=True))).args
    assert all(term.is_nonnegative for term in terms)
    assert any(term.is_positive for term in terms)


def test_ring_condition_and_distance_vanish_together_and_have_the_same_sign() -> None:
    """They differ by the factors (distance + 2 R) and the octic's second, both positive."""
    ring = general_ring()
    assert (
        sp.expand(ring.condition - ring.distance * (ring.distance + 2 * reach) * other(ring)) == 0
    )
    assert (ring.distance + reach).is_nonnegative


@pytest.mark.slow
def test_the_octics_constant_term_vanishes_at_every_contact_with_the_ring() -> None:
    constant = event_coefficients(RING, HOOP.flight)[0]
    assert sp.simplify(constant.subs(on_the_ring(RING), simultaneous=True)) == 0


def test_the_rings_distance_is_finite_on_its_axis() -> None:
    ring = general_ring()
    at_centre = ring.distance.subs({x: 0, y: 0, z: 0})
    assert sp.simplify(at_centre - (ring.ring_radius - reach)) == 0


def test_the_ring_normal_is_that_of_table_2() -> None:
    centre = RING.ring_radius / RING.rho * sp.Matrix([x, y, 0])
    expected = (position - centre) / RING.reach
    assert sp.simplify(release(RING.normal) - expected) == sp.zeros(3, 1)


# -- Every surface


@pytest.mark.parametrize("plane", PLANES, ids=lambda s: s.name)
def test_a_planes_normal_is_the_unit_gradient_of_its_distance(plane: Plane) -> None:
    assert sp.Matrix([sp.diff(release(plane.distance), c) for c in POSITION]) == plane.normal
    assert plane.normal.dot(plane.normal) == 1


@pytest.mark.parametrize(("surface", "radius"), [(RING, RING.reach), (SPHERE, SPHERE.radius)])
def test_a_round_surfaces_normal_is_the_unit_gradient_of_its_distance_at_every_contact(
    surface: Surface, radius: sp.Expr
) -> None:
    """The distance is a root less a radius, and a contact is where the two are equal."""
    root = surface.distance + radius
    gradient = sp.Matrix([sp.diff(surface.distance, c) for c in POSITION])
    normal = release(surface.normal)
    assert sp.simplify(gradient.subs(root, radius) - normal) == sp.zeros(3, 1)
    assert sp.simplify(normal.dot(normal) - root**2 / radius**2) == 0


DEGREES = {"ring": 8, "backboard": 1, "bridge": 2, "end": 2, "ball": 4}


@surfaces
def test_the_event_polynomial_is_the_flight_put_into_the_condition(surface: Surface) -> None:
    coefficients = event_coefficients(surface, HOOP.flight)
    place, _ = HOOP.flight.at()
    substituted = release(surface.condition).subs(
        dict(zip(POSITION, place, strict=True)), simultaneous=True
    )
    brute_force = sp.Poly(sp.expand(substituted), t).all_coeffs()[::-1]
    assert len(coefficients) - 1 == DEGREES[surface.name]
    assert [sp.expand(release(c)) for c in coefficients] == brute_force


@surfaces
def test_deflated_times_t_plus_the_constant_is_the_event_polynomial(surface: Surface) -> None:
    coefficients = event_coefficients(surface, HOOP.flight)
    deflated = deflated_coefficients(surface, HOOP.flight)
    whole = horner(coefficients, t)
    assert sp.expand(release(horner(deflated, t) * t + coefficients[0] - whole)) == 0
    assert release(coefficients[0] - surface.condition).expand() == 0


@pytest.mark.parametrize("plane", PLANES, ids=lambda s: s.name)
def test_a_plane_is_inside_within_its_reach_on_either_side(plane: Plane) -> None:
    front, back, *limits = plane.inside
    assert front == plane.distance
    assert sp.expand(release(front + back) + 2 * plane.reach) == 0
    assert tuple(limits) == plane.bounds


def test_the_hoop_is_that_of_table_2() -> None:
    p = {s.name: s for s in HOOP.symbols}
    ring, backboard, bridge = HOOP.surfaces
    (end,) = HOOP.end_planes
    both = p["ball_radius"] + p["wire_radius"]
    assert (ring.name, backboard.name, bridge.name, end.name) == tuple(DEGREES)[:4]
    assert (RING.ring_radius, RING.reach) == (p["ring_radius"], both)
    front = x + p["board_distance"] - p["ball_radius"]
    assert sp.expand(release(backboard.distance) - front) == 0
    assert sp.expand(release(bridge.distance) - (z - both)) == 0
    assert sp.expand(release(end.distance) - (z + p["end_depth"])) == 0
    assert list(backboard.normal) == [1, 0, 0]
    assert list(bridge.normal) == [0, 0, 1]
    # |y| <= y_B, z_B1 <= z <= z_B2;  |y| <= y_BR, x² + y² >= R_H², -a_0 <= x <= 0.
    half, narrow = p["board_half_width"], p["bridge_half_width"]
    low, high = p["board_bottom"], p["board_top"]
    rho = sp.sqrt(x**2 + y**2)
    assert set(backboard.bounds) == {y - half, -y - half, low - z, z - high}
    assert set(bridge.bounds) == {
        y - narrow,
        -y - narrow,
        p["ring_radius"] - rho,
        x,
        -p["board_distance"] - x,
    }
    assert [e.name for e in HOOP.ends] == ["made", "missed"]
    assert end.parts == ((rho - p["ring_radius"],), ())
