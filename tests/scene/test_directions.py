"""Bodies along any direction: how they are written, and what the judge and pictures make of them.

No scene is compiled here: `test_oblique_bodies.py` does that.
"""

from __future__ import annotations

import math
from itertools import permutations
from typing import Any

import mpmath
import numpy as np
import pytest
from mpmath import mpf

import hoopgen
from hoopgen.scene import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Parameter,
    Plane,
    Scene,
    SceneError,
    Surface,
    Torus,
)
from hoopgen.scene.files import parse_scene
from hoopgen.scene.geometry import SceneGeometry
from tests.helpers.effort import trials

BALL, GRAVITY, BOUNCE = 0.0625, 9.75, 0.75
LEAN = Parameter("lean", 0.5, "1", sign="any")


def scene(*bodies: Any, **given: Any) -> Scene:
    """Return a scene of these bodies."""
    usual: dict[str, Any] = {
        "parameters": [LEAN],
        "ball_radius": BALL,
        "gravity": GRAVITY,
        "restitution": BOUNCE,
    }
    return Scene("leaning", bodies=bodies, **(usual | given))


def sizes(made: Scene, **given: Any) -> dict[str, Any]:
    """Return the inputs of a scene by name."""
    return {i.name: v for i, v in zip(made.inputs, made.values(given), strict=True)}


def direction(made: Scene, body: str = "a") -> list[float]:
    found = sizes(made)
    return [float(found.get(f"{body}_direction_{axis}", 0.0)) for axis in "xyz"]


# -- How they are written


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (Plane("a", normal=(0, 0, 0)), "body a: normal: has no direction: all three sizes are 0"),
        (Plane("a", normal=(0, 0, "lean - 1/2")), "all three sizes are 0 at the defaults"),
        (Plane("a", normal=(0, 1, math.nan)), "body a: normal z: expected a finite number"),
        (Plane("a", normal=(0, 1)), "body a: normal: expected three sizes, or tilt and towards"),
        (Plane("a", normal="z"), "body a: normal: expected three sizes, or tilt and towards"),
        (Plane("a", normal=(0, 1, "tilt")), "body a: normal z: 'tilt': unknown name"),
        (Plane("a", axis="z", normal=(0, 1, 1)), "body a: normal: expected axis or normal, got"),
        (Plane("a", at=1, point=(0, 1, 1)), "body a: point: expected at or point, got both"),
        (Plane("a", point=(0, 1)), "body a: point: expected three sizes"),
        (Plane("a", normal={}), "body a: normal tilt: missing"),
        (Plane("a", normal={"tilt": "12"}), "body a: normal tilt: '12'"),
        (Plane("a", normal={"tilt": 12}), "body a: normal tilt: expected text with a unit"),
        (Plane("a", normal={"tilt": "1deg", "to": "2deg"}), "body a: normal: unknown to"),
        (Cylinder("a", radius=1, axis=(0, 0, 0)), "body a: axis: has no direction"),
        (Cylinder("a", radius=1, axis=(1, 2)), "body a: axis: expected three sizes"),
        (Cylinder("a", radius=1, axis="w"), "body a: axis: expected one of x"),
        (Cylinder("a", radius=0.01, axis=(1, 0, 1), inside=True), "the ball does not fit inside"),
        (Cylinder("a", radius=1, axis=(1, 0, 1), span=(1, 0)), "it ends at 0 before 1"),
        (Disc("a", radius=0), "body a: radius: expected a number above 0"),
        (Disc("a", radius=1, axis=(0, 0, 0)), "body a: axis: has no direction"),
        (Torus("a", radius=1, axis=(0, 0, 0)), "body a: axis: has no direction"),
        (Torus("a", radius=1, axis=(1, 2)), "body a: axis: expected three sizes"),  # type: ignore[arg-type]
        (Torus("a", radius=0.06, axis=(1, 2, 2)), "body a: radius: the ball does not fit through"),
        (Cone("a"), "body a: half_angle: expected half_angle or slope, got neither"),
        (Cone("a", half_angle="9deg", slope=1), "expected half_angle or slope, got both"),
        (Cone("a", half_angle="0deg"), "half_angle: expected an angle above 0deg and below 90deg"),
        (Cone("a", half_angle="90deg"), "half_angle: expected an angle above 0deg and below"),
        (Cone("a", half_angle="-9deg"), "half_angle: expected an angle above 0deg and below"),
        (Cone("a", half_angle="nandeg"), "body a: half_angle: "),
        (Cone("a", half_angle=0.5), "body a: half_angle: expected text with a unit"),  # type: ignore[arg-type]
        (Cone("a", slope=0), "body a: slope: expected a number above 0"),
        (Cone("a", slope=1, span=(-1, 1)), "of at least 0, from the apex; got -1"),
        (Cone("a", slope=1, span=(0, 0)), "expected a number above 0, from the apex; got 0"),
        (Cone("a", slope=1, span=1), "body a: span: expected two ends"),  # type: ignore[arg-type]
        (
            Cone("a", slope=1, span=(0, 0.04), inside=True),
            "span to: the ball does not fit so far inside: expected more than 0.0441942, got 0.04",
        ),
        (Cone("a", slope=1, within=["1"]), "body a: within 1: 1 has none of x, y, z"),
    ],
)
def test_what_is_wrong_with_a_body_is_said(body: Any, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        scene(body)
    assert str(refusal.value).startswith("scene 'leaning': body a: ")
    assert said in str(refusal.value)


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (
            Plane("a", normal=(0, 1, 1), within=["x**3"]),
            "body a: within 1: no ball",
        ),
        (
            Cylinder("a", radius=1, axis=(0, 1, 1), within=["x**3"]),
            "body a: within 1: no ball",
        ),
        (Cone("a", slope=1, within=["x", "x**3"]), "body a: within 2: no ball"),
        (
            Torus("a", radius=1, within=["x*y*z"]),
            "body a: within: no ball is known to roll up to an edge of a torus",
        ),
        (
            Box("a", size=(1, 1, 1), within=["x**3"]),
            "body a: within 1: no ball is known to roll up to an edge of degree 3",
        ),
        (
            Surface("a", condition="z - x**2"),
            "body a: no ball is known to roll beside a surface of your own",
        ),
    ],
)
def test_where_no_ball_rolls_is_said(body: Any, said: str) -> None:
    scene(body)
    with pytest.raises(SceneError) as refusal:
        scene(body, rolls=True)
    assert said in str(refusal.value)


def test_the_apex_of_a_cone_has_its_name() -> None:
    with pytest.raises(SceneError, match="the apex of the cone spike is called"):
        scene(Cone("spike", slope=1), Plane("spike_apex"))


def test_the_length_of_a_direction_does_not_matter() -> None:
    made = [scene(Plane("a", normal=(0.0, -k, 2 * k))) for k in (1, 3.0, 1e-99, 1e99)]
    assert len({one.key for one in made}) == 1
    assert direction(made[0]) == pytest.approx([0, -(5**-0.5), 2 * 5**-0.5], rel=1e-15)


def test_a_normal_along_an_axis_is_that_axis() -> None:
    """Constants, and angles: such a plane is searched as it was, and a ball rolls on it."""
    for way, vector, tilt in [
        ("z", (0, 0, 5), {"tilt": "0deg", "towards": "30deg"}),
        ("-y", (0, -0.1, 0), {"tilt": "90deg", "towards": "270deg"}),
        ("-z", (0, 0, -1), {"tilt": "180deg"}),
        ("x", (7, 0, 0), {"tilt": "90deg"}),
    ]:
        keys = {
            scene(body).key
            for body in (
                Plane("a", axis=way, at=0.5),
                Plane("a", normal=vector, at=0.5),
                Plane("a", normal=tilt, at=0.5),
            )
        }
        assert len(keys) == 1, way


def test_a_tilt_leans_towards_a_direction_on_the_floor_plan() -> None:
    made = scene(Plane("a", normal={"tilt": "30deg", "towards": "90deg"}))
    assert direction(made) == pytest.approx([0.0, 0.5, 0.75**0.5], rel=1e-15)
    made = scene(Plane("a", normal={"tilt": "60deg", "towards": "0.5rad"}))
    turned = [0.75**0.5 * math.cos(0.5), 0.75**0.5 * math.sin(0.5), 0.5]
    assert direction(made) == pytest.approx(turned, rel=4e-15)


def test_a_point_gives_the_place_of_a_plane() -> None:
    made = scene(
        Plane("a", normal=(3, 0, 4), point=(1, 7, 2)), Plane("b", axis="-y", point=(1, 7, 2))
    )
    assert sizes(made)["a_at"] == pytest.approx(2.2, rel=1e-15)
    assert sizes(made)["b_at"] == -7


def test_a_parameter_turns_a_body() -> None:
    """Each shot has its own direction, of length 1; where it has none it is no number."""
    made = scene(Plane("a", normal=(0, "lean", "2*lean")))
    found = sizes(made, lean=np.array([1.0, -3.0, 0.0, math.inf]))
    assert found["a_direction_y"][:2] == pytest.approx([5**-0.5, -(5**-0.5)], rel=1e-15)
    assert np.isnan(found["a_direction_z"][2:]).all()


def test_a_file_has_the_same_arguments() -> None:
    content = b"""
name = "leaning"
ball_radius = 0.0625
gravity = 9.75
restitution = 0.75
parameters = { lean = { default = 0.5, unit = "1", sign = "any" } }

[bodies.ramp]
kind = "plane"
normal = [0.0, "-lean", 2.0]

[bodies.slope]
kind = "plane"
normal = { tilt = "12deg", towards = "30deg" }
point = [0, 0, 1]

[bodies.rod]
kind = "cylinder"
radius = 0.1
axis = [1, "lean", 0]
span = ["", 0.5]

[bodies.funnel]
kind = "cone"
half_angle = "30deg"
inside = true
span = [0.1, ""]

[bodies.plate]
kind = "disc"
radius = "2*lean"
axis = { tilt = "12deg" }
"""
    bodies = (
        Plane("ramp", normal=(0.0, "-lean", 2.0)),
        Plane("slope", normal={"tilt": "12deg", "towards": "30deg"}, point=(0, 0, 1)),
        Cylinder("rod", radius=0.1, axis=(1, "lean", 0), span=(None, 0.5)),
        Cone("funnel", half_angle="30deg", inside=True, span=(0.1, None)),
        Disc("plate", radius="2*lean", axis={"tilt": "12deg"}),
    )
    assert parse_scene(content).key == scene(*bodies).key


# -- Against closed forms


def shot(place: Any, velocity: Any = (0, 0, 0)) -> np.ndarray[Any, Any]:
    return np.array([[*place, *velocity, 0, 0, 0]], dtype=float)


def test_the_first_two_bounces_on_an_inclined_plane_are_those_of_the_closed_form() -> None:
    """Without spin a shell keeps 3/5 of the velocity along the plane, and then bounces again."""
    made = scene(Plane("ramp", normal=(0.25, -0.5, 2), at=-0.25))
    start, thrown = (0.125, 0.25, 0.75), (0.5, -0.25, 1.0)
    proof = hoopgen.certify(shot(start, thrown), scene=made, max_contacts=2)[0]
    with mpmath.workdps(40):
        found = sizes(made)
        n = mpmath.matrix([mpf(float(found[f"ramp_direction_{axis}"])) for axis in "xyz"])
        unit = n / mpmath.norm(n)
        fall = mpmath.matrix([0, 0, -mpf(GRAVITY)])
        place, velocity = mpmath.matrix(start), mpmath.matrix(thrown)

        def dot(a: Any, b: Any) -> Any:
            return sum(p * q for p, q in zip(a, b, strict=True))

        times = []
        for bounce in range(2):
            a, b = dot(n, fall) / 2, dot(n, velocity)
            c = dot(n, place) - mpf(float(found["ramp_at"])) - mpf(BALL)
            t = -b / a if bounce else (-b - mpmath.sqrt(b**2 - 4 * a * c)) / (2 * a)
            times.append((times[-1] if bounce else 0) + t)
            place = place + velocity * t + fall * t**2 / 2
            velocity = velocity + fall * t
            off = dot(unit, velocity)
            velocity = (velocity - off * unit) * mpf(3) / 5 - mpf(BOUNCE) * off * unit
        assert proof.times == pytest.approx([float(t) for t in times], rel=1e-15)
        assert abs(times[0] - mpf(proof.times[0])) <= mpf(proof.time_radii[0])
        assert abs(times[1] - mpf(proof.times[1])) <= mpf(proof.time_radii[1])


def distance_from_cone(point: Any, apex: Any, axis: Any, half: Any) -> Any:
    """Return the distance of a point from a solid cone: from a generator, or from the apex."""
    off = [p - a for p, a in zip(point, apex, strict=True)]
    unit = [u / mpmath.norm(mpmath.matrix(axis)) for u in axis]
    height = sum(o * u for o, u in zip(off, unit, strict=True))
    width = mpmath.sqrt(sum(o**2 for o in off) - height**2)
    foot = height * mpmath.cos(half) + width * mpmath.sin(half)
    if foot <= 0:
        return mpmath.hypot(height, width)
    return width * mpmath.cos(half) - height * mpmath.sin(half)


@pytest.mark.parametrize(("aside", "part"), [(0.25, "side"), (0.015625, "apex")])
@pytest.mark.parametrize("inside", [False, True])
def test_a_ball_first_touches_a_cone_at_its_radius_from_it(
    aside: float, part: str, inside: bool
) -> None:
    """The root of the distance itself, which knows no cone of centres, in 40 digits."""
    axis = (0.25, 0.5, 2.0) if inside else (0.25, 0.5, -2.0)
    apex, slope = (0.125, 0.0, 0.25), 0.75
    made = scene(Cone("cone", slope=slope, axis=axis, apex=apex, inside=inside))
    place = (0.125 + aside, 0.0, 1.75)
    thrown = (-0.0625 if inside else 0.0, 0.03125, 0.0)
    proof = hoopgen.certify(shot(place, thrown), scene=made, max_contacts=1)[0]
    with mpmath.workdps(40):
        half = mpmath.atan(mpf(slope))

        def gap(t: Any) -> Any:
            there = [mpf(p) + mpf(v) * t for p, v in zip(place, thrown, strict=True)]
            there[2] -= mpf(GRAVITY) * t**2 / 2
            if not inside:
                return distance_from_cone(there, apex, axis, half) - mpf(BALL)
            off = [p - a for p, a in zip(there, apex, strict=True)]
            unit = [u / mpmath.norm(mpmath.matrix(axis)) for u in axis]
            height = sum(o * u for o, u in zip(off, unit, strict=True))
            width = mpmath.sqrt(sum(o**2 for o in off) - height**2)
            return height * mpmath.sin(half) - width * mpmath.cos(half) - mpf(BALL)

        root = mpmath.findroot(gap, mpf(proof.times[0]) * (1 + mpf(2) ** -20))
        # The axis and the apex for the ball's centre are doubles.
        assert abs(root - mpf(proof.times[0])) < 1e-14
        contact = [mpf(p) + mpf(v) * root for p, v in zip(place, thrown, strict=True)]
        contact[2] -= mpf(GRAVITY) * root**2 / 2
        if not inside:
            off = [p - a for p, a in zip(contact, apex, strict=True)]
            near = mpmath.norm(mpmath.matrix(off)) - mpf(BALL)
            assert (abs(near) < 1e-12) == (part == "apex")
    assert proof.surfaces == [0]


def test_a_ball_first_touches_a_turned_ring_at_its_radius_from_the_wire() -> None:
    """The root of the distance from the wire's circle in 40 digits; the axis is of any length."""
    axis, centre, radius, wire = (0.25, 0.5, 2.0), (0.125, 0.0, 0.25), 0.5, 0.0625
    made = scene(Torus("ring", radius=radius, wire=wire, axis=axis, centre=centre))
    place, thrown = (0.625, 0.0, 1.75), (0.0, 0.03125, 0.0)
    proof = hoopgen.certify(shot(place, thrown), scene=made, max_contacts=1)[0]
    with mpmath.workdps(40):
        length = mpmath.norm(mpmath.matrix(axis))

        def gap(t: Any) -> Any:
            there = [mpf(p) + mpf(v) * t for p, v in zip(place, thrown, strict=True)]
            there[2] -= mpf(GRAVITY) * t**2 / 2
            off = [p - c for p, c in zip(there, centre, strict=True)]
            height = sum(o * u for o, u in zip(off, axis, strict=True)) / length
            width = mpmath.sqrt(sum(o**2 for o in off) - height**2)
            return mpmath.hypot(width - radius, height) - wire - mpf(BALL)

        root = mpmath.findroot(gap, mpf(proof.times[0]) * (1 + mpf(2) ** -20))
        assert abs(root - mpf(proof.times[0])) < 1e-14  # the axis is rounded to doubles
    assert proof.surfaces == [0]


def test_a_direction_that_a_row_does_not_have_is_invalid() -> None:
    made = scene(Plane("floor", at=-1), Plane("a", normal=(0, "lean", "2*lean"), at=-1))
    states = np.repeat(shot((0, 0, 1)), 2, axis=0)
    proofs = hoopgen.certify(states, {"lean": np.array([1.0, 0.0])}, scene=made, max_contacts=1)
    assert proofs.contacts.tolist() == [1, 0]
    assert np.isnan(proofs.time).tolist() == [False, True]


def negative(vector: Any) -> tuple[float, ...]:
    return tuple(-part for part in vector)


BODIES = (
    ("ramp", lambda u, c: Plane("ramp", normal=u, point=c)),
    ("rod", lambda u, c: Cylinder("rod", radius=0.5, axis=u, centre=c, span=(-0.5, 0.625))),
    ("spike", lambda u, c: Cone("spike", slope=4, axis=negative(u), apex=c, span=(None, 1))),
    ("ring", lambda u, c: Torus("ring", radius=0.2, wire=0.125, axis=u, centre=c)),
    ("plate", lambda u, c: Disc("plate", radius=0.5, axis=u, centre=c)),
)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("name", "make"), BODIES, ids=[name for name, _ in BODIES])
def test_a_scene_whose_axes_change_places_gives_the_same_shot(name: str, make: Any) -> None:
    """Gravity goes along: the judge encloses the same contact, at the same time."""
    vector, centre = (1.0, -0.5, 1.0), (0.125, 0.0625, -0.25)
    place, thrown = (0.125, 0.25, 1.0), (0.0625, -0.25, 1.0)
    found = []
    for order in permutations(range(3)):

        def moved(v: Any, order: Any = order) -> tuple[float, ...]:
            return tuple(v[k] for k in order)

        made = scene(make(moved(vector), moved(centre)), down="-" + "xyz"[order.index(2)])
        proof = hoopgen.certify(shot(moved(place), moved(thrown)), scene=made, max_contacts=1)[0]
        assert proof.surfaces == [0]
        state = np.array(proof.state)
        back = [order.index(k) for k in range(3)]
        found.append([proof.times[0], *state[:3][back], *state[3:6][back]])
    # The doubles of direction and place differ by a rounding of their sums.
    assert np.ptp(found, axis=0).max() < 1e-14


# -- Pictures


def geometry(*bodies: Any) -> SceneGeometry:
    made = scene(*bodies)
    return SceneGeometry(made, {name: float(value) for name, value in sizes(made).items()})


ROOM = (np.full(3, -1.0), np.full(3, 1.0))


@pytest.mark.slow
def test_bodies_are_drawn_where_the_ball_touches_them() -> None:
    """At random directions: points are on the body, their centres a ball's radius away from it."""
    chance = np.random.default_rng(3)
    for _ in range(trials(20, at_least=5)):
        u = chance.normal(size=3)
        u /= np.linalg.norm(u)
        c = chance.uniform(-0.2, 0.2, 3)
        vector, place = tuple(u.tolist()), tuple(c.tolist())
        drawn = geometry(
            Plane("a", normal=vector, point=place),
            Disc("b", radius=0.5, axis=vector, centre=place),
            Cylinder("c", radius=0.2, axis=vector, centre=place, span=(-0.3, 0.4), inside=True),
            Cone("d", slope=0.5, axis=vector, apex=place, span=(0.1, 0.4), inside=True),
        ).bodies(ROOM)
        for body in drawn:
            corners = body.mesh.corners
            assert len(corners)
            points, centres = corners[..., :3], corners[..., 3:]
            assert np.abs(points).max() < 1 + 1e-8
            assert np.linalg.norm(centres - points, axis=-1) == pytest.approx(BALL, rel=1e-9)
            height = (points - c) @ u
            width = np.linalg.norm(points - c - height[..., None] * u, axis=-1)
            turned = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
            out = np.einsum("ij,ij->i", turned, (centres - points).mean(axis=1))
            assert (out > -1e-12).all(), body.name  # counterclockwise as seen by the ball
            if body.name in "ab":
                assert np.abs(height).max() < 1e-12
                assert body.name == "a" or width.max() < 0.5 + 1e-3
            elif body.name == "c":
                # On chords of 48 pieces.
                assert width.max() < 0.2 + 1e-9
                assert width.min() > 0.2 * math.cos(math.pi / 24) - 1e-9
                assert height.min() == pytest.approx(-0.3)
                assert height.max() == pytest.approx(0.4)
            else:
                assert np.abs(width - 0.5 * height).max() < 0.2 * 0.01
                assert height.min() == pytest.approx(0.1)
            assert len(body.mesh.rims) or body.name == "a"


def test_the_room_holds_bodies_with_ends() -> None:
    seen = geometry(
        Cylinder("rod", radius=0.1, axis=(1, 0, 1), span=(0, 1)),
        Cone("cone", slope=1, axis=(0, 1, 1), span=(0, 0.5)),
        Plane("ramp", normal=(0, 1, 1), at=-5),
    )
    low, high = seen.room(np.zeros(3), np.ones(3))
    assert (low < [-0.07, -0.07, -0.07]).all()
    assert (high > [0.77, 0.6, 0.77]).all()
    assert np.isfinite([low, high]).all()


@pytest.mark.parametrize("inside", [False, True])
def test_bodies_without_ends_are_drawn_as_far_as_the_room_goes(inside: bool) -> None:
    chance = np.random.default_rng(5)
    for _ in range(trials(20, at_least=5)):
        vector = tuple(chance.normal(size=3).tolist())
        for body in geometry(
            Cylinder("rod", radius=0.2, axis=vector, inside=inside),
            Cone("cone", slope=0.5, axis=vector, inside=inside),
        ).bodies(ROOM):
            points = body.mesh.corners[..., :3]
            assert np.abs(points).max() > 0.7
            assert np.abs(points).max() < 1 + 1e-8
