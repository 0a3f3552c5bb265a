"""A slow reference for scenes of pieces or of faces: it steps along flights, and sees distances.

It shares nothing with hoopgen but the pieces a user writes: Python evaluates sizes, distances
are geometry, a step is no longer than the nearest body allows, and where a distance changes its
sign Brent's method finds the time. In doubles, so times agree to rounding errors that each bounce
multiplies; where a decision is closer than `CLOSE`, the shot is said to be close.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from hoopgen.scene import Box, Cone, Cylinder, Disc, End, Plane, Revolution, Scene, Sphere, Torus
from hoopgen.scene.pieces import Body

Vector = NDArray[np.float64]

CLOSE = 1e-7
"""Metres within which the reference trusts no decision of its own."""

SHORTEST, LONGEST = 1e-4, 0.05
"""Steps, s. What begins and ends within the shortest is seen as a root of the distance over time,
or as close."""


@dataclass
class Flown:
    """The path of a shot: body and time of each contact, its end, and whether it was ever close."""

    contacts: list[tuple[int, float]] = field(default_factory=list)
    outcome: str = "capped"
    time: float = 0.0
    close: bool = False
    state: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Face:
    """Distance from the ball to a whole surface, the point of it that is nearest, its bounds.

    The bounds are those of that point, or, with `of_centre`, functions of the ball's centre.
    """

    index: int
    distance: Callable[[Vector], float]
    nearest: Callable[[Vector], Vector]
    within: Callable[[Vector], float]
    restitution: float
    of_centre: bool = False


EndPlane = tuple[str, Callable[[Vector], float], Callable[[Vector], float]]
"""Name, distance of the ball's centre, and bounds of it."""


@dataclass(frozen=True)
class Straight:
    """A straight piece of a profile, in the half-plane of radius and height."""

    start: Vector
    end: Vector

    @property
    def ways(self) -> tuple[Vector, Vector]:
        """The unit vector along it, twice."""
        step = self.end - self.start
        return (step / np.linalg.norm(step),) * 2

    def foot(self, place: Vector) -> Vector:
        """Return the nearest point of its whole line."""
        way = self.ways[0]
        return np.asarray(self.start + ((place - self.start) @ way) * way)

    def beyond(self, place: Vector) -> float:
        """Return how far a place is beyond its ends, negative between them."""
        way = self.ways[0]
        return float(max((self.start - place) @ way, (place - self.end) @ way))

    def nearest(self, radius: float, height: float) -> tuple[float, float]:
        """Return its nearest point."""
        (x, y), (a, b) = self.start.tolist(), (self.end - self.start).tolist()
        share = ((radius - x) * a + (height - y) * b) / (a * a + b * b)
        share = min(max(share, 0.0), 1.0)
        return x + share * a, y + share * b


@dataclass(frozen=True)
class Curved:
    """A circular arc of a profile: its centre, its radius, and its angles, counterclockwise."""

    start: Vector
    end: Vector
    centre: Vector
    radius: float
    turn: float
    first: float
    sweep: float

    @classmethod
    def through(cls, start: Vector, middle: Vector, end: Vector) -> Curved:
        """Return the arc from one point through another to a third one."""
        rows = 2 * np.array([middle - start, end - start])
        centre = np.linalg.solve(rows, [middle @ middle - start @ start, end @ end - start @ start])
        angle = [math.atan2(p[1] - centre[1], p[0] - centre[0]) for p in (start, middle, end)]
        whole = 2 * math.pi
        turn = 1.0 if (angle[1] - angle[0]) % whole < (angle[2] - angle[0]) % whole else -1.0
        sweep = (turn * (angle[2] - angle[0])) % whole
        radius = float(np.linalg.norm(start - centre))
        return cls(start, end, centre, radius, turn, angle[0], sweep)

    @property
    def ways(self) -> tuple[Vector, Vector]:
        """The unit vectors along it at its ends."""
        first, last = ((p - self.centre) / self.radius for p in (self.start, self.end))
        return tuple(self.turn * np.array([-v[1], v[0]]) for v in (first, last))  # type: ignore[return-value]

    def foot(self, place: Vector) -> Vector:
        """Return the nearest point of its whole circle."""
        offset = place - self.centre
        return np.asarray(self.centre + offset * (self.radius / np.linalg.norm(offset)))

    def beyond(self, place: Vector) -> float:
        """Return the angle by which a place is beyond its ends as a length, negative between."""
        x, y = place - self.centre
        angle = (self.turn * (math.atan2(y, x) - self.first)) % (2 * math.pi)
        late = angle - self.sweep
        gap = 2 * math.pi - angle
        return self.radius * (min(late, gap) if late > 0 else max(late, -angle))

    def nearest(self, radius: float, height: float) -> tuple[float, float]:
        """Return its nearest point."""
        place = np.array([radius, height])
        inside = self.beyond(place) <= 0
        points = [self.foot(place)] if inside else [self.start, self.end]
        x, y = min(points, key=lambda point: math.dist(point, place)).tolist()
        return x, y


class SlowFaces:
    """Shots that meet faces, one at a time.

    Parameters
    ----------
    faces, ends
        What the ball meets, and where a shot ends.
    ball, inertia
        The ball's radius, and its moment of inertia over mass and radius squared.
    fall
        The acceleration of free fall, (3,).
    """

    def __init__(
        self,
        faces: Sequence[Face],
        ends: Sequence[EndPlane],
        ball: float,
        inertia: float,
        fall: Vector,
    ) -> None:
        self.faces, self._ends = faces, ends
        self._ball, self._inertia, self._fall = ball, inertia, fall

    def fly(self, start: Sequence[float], max_contacts: int, time_limit: float = 60.0) -> Flown:
        """Return what a shot does."""
        x, v, w = (np.array(start[k : k + 3], float) for k in (0, 3, 6))
        flown, last = Flown(), -1
        while len(flown.contacts) < max_contacts:
            found = self._next(x, v, last, time_limit - flown.time, flown)
            if found is None:
                flown.outcome = "endless"
                return flown
            time, what = found
            flown.time += time
            x, v = self._there(time, x, v)
            flown.state = [*x, *v, *w]
            if isinstance(what, str):
                flown.outcome = what
                return flown
            last = what
            flown.contacts.append((self.faces[what].index, flown.time))
            v, w = self._bounce(self.faces[what], x, v, w)
        flown.state = [*x, *v, *w]
        return flown

    def overlap(self, place: Vector) -> tuple[float, float]:
        """Return the distance from the first body, and the largest of its bounds there."""
        face = self.faces[0]
        return face.distance(place), face.within(face.nearest(place))

    def _there(self, t: float, x: Vector, v: Vector) -> tuple[Vector, Vector]:
        return x + v * t + self._fall * (t * t / 2), v + self._fall * t

    def _next(
        self, x: Vector, v: Vector, last: int, room: float, flown: Flown
    ) -> tuple[float, int | str] | None:
        """Return time and body, or name, of the first contact or end."""
        time = 0.0
        gaps = [*(f.distance for f in self.faces), *(gap for _, gap, _ in self._ends)]
        before = [1.0 if k == last else gap(x) for k, gap in enumerate(gaps)]
        while time < room:
            place, velocity = self._there(time, x, v)
            speed = np.linalg.norm(velocity) + np.linalg.norm(self._fall) * LONGEST
            free = min(abs(gap(place)) for gap in gaps) / speed
            step = min(max(SHORTEST, free), LONGEST)
            after = [gap(self._there(time + step, x, v)[0]) for gap in gaps]
            found = []
            for k, (gap, was, now) in enumerate(zip(gaps, before, after, strict=True)):
                if was > 0.0 >= now:
                    begin = 1e-9 if k == last and time == 0.0 else time
                    at = lambda t, gap=gap: gap(self._there(t, x, v)[0])  # noqa: E731
                    if at(begin) <= 0.0:
                        flown.close = True
                        continue
                    found.append((brentq(at, begin, time + step, xtol=1e-15, rtol=1e-14), k))
                elif 0.0 < now < CLOSE or (0.0 < was < CLOSE and k != last):
                    flown.close = True
            arrival = self._first(sorted(found), x, v, flown)
            if arrival is not None:
                return arrival
            time, before = time + step, after
        return None

    def _first(
        self, found: list[tuple[float, int]], x: Vector, v: Vector, flown: Flown
    ) -> tuple[float, int | str] | None:
        """Return the first arrival that is within its bounds."""
        for place, (time, k) in enumerate(found):
            there, velocity = self._there(time, x, v)
            ends = k >= len(self.faces)
            whole = ends or self.faces[k].of_centre
            point = there if whole else self.faces[k].nearest(there)
            within = self._ends[k - len(self.faces)][2] if ends else self.faces[k].within
            side = within(point)
            # A bound that is square changes faster than a length, or slower.
            flown.close |= abs(side) < CLOSE
            if side <= 0.0:
                later = [t for t, other in found[place + 1 :] if not (ends and other > k)]
                flown.close |= any((t - time) * np.linalg.norm(velocity) < CLOSE for t in later)
                return time, self._ends[k - len(self.faces)][0] if ends else k
        return None

    def _bounce(self, face: Face, x: Vector, v: Vector, w: Vector) -> tuple[Vector, Vector]:
        """Return velocity and spin after the impulse that stops the slip."""
        normal = (x - face.nearest(x)) / self._ball
        slip = v - (v @ normal) * normal + np.cross(w, -self._ball * normal)
        push = -self._inertia / (1 + self._inertia) * slip
        turn = -1 / (self._inertia * self._ball) * np.cross(normal, push)
        return v + push - (1 + face.restitution) * (v @ normal) * normal, w + turn


class Slow(SlowFaces):
    """Shots of a scene, one at a time.

    Parameters
    ----------
    scene
        Of pieces.
    parameters
        Names and numbers; what is left out has its default.
    """

    def __init__(self, scene: Scene, parameters: Mapping[str, float] | None = None) -> None:
        defaults = {p.name: p.default for p in scene.parameters}
        self._values = defaults | dict(parameters or {})
        self._ball, self._scene = self._size(scene.ball_radius), scene
        super().__init__(
            [face for k, body in enumerate(scene.bodies) for face in self._faces_of(k, body)],
            [(name, *self._end(end)) for name, end in scene.ends.items()],
            self._ball,
            self._size(scene.inertia),
            self._unit(scene.down) * self._size(scene.gravity),
        )

    def _size(self, written: Any, **place: float) -> float:
        """Return what a test's own text says: it is Python's to evaluate."""
        return float(
            eval(str(written), {"sqrt": math.sqrt, "inf": math.inf, **self._values, **place})
        )

    def _within(self, written: Sequence[Any]) -> Callable[[Vector], float]:
        """Return the largest of the bounds at a point: not above 0 where the body is there."""

        def worst(point: Vector) -> float:
            place = dict(zip("xyz", point.tolist(), strict=True))
            return max((self._size(one, **place) for one in written), default=-math.inf)

        return worst

    def _faces_of(self, index: int, body: Body) -> list[Face]:
        """Return the faces of a body: of a wall that is partly not there, each piece and edge.

        A ball that passes through a part that is not there, and so is nearest to it, still meets
        the pieces that are.
        """
        whole = self._face(index, body)
        if not isinstance(body, Revolution) or not body.within:
            return [whole]
        unit, centre = self._unit(body.axis), self._vector(body.centre)
        pieces = self._pieces(body)
        points = np.array([pieces[0].start, *(piece.end for piece in pieces)])

        def flat(p: Vector) -> Vector:
            height = (p - centre) @ unit
            return np.array([np.linalg.norm(p - centre - height * unit), height])

        def face(foot: Callable[[Vector], Vector], beyond: Callable[[Vector], float]) -> Face:
            def nearest(p: Vector) -> Vector:
                height, (radius, there) = (p - centre) @ unit, foot(flat(p))
                across = p - centre - height * unit
                return np.asarray(centre + there * unit + across * (radius / flat(p)[0]))

            away = lambda p: np.linalg.norm(foot(flat(p)) - flat(p)) - self._ball  # noqa: E731
            within = lambda p: max(beyond(flat(p)), whole.within(nearest(p)))  # noqa: E731
            return Face(index, away, nearest, within, whole.restitution, of_centre=True)

        faces = [face(piece.foot, piece.beyond) for piece in pieces]
        for k, point in enumerate(points):
            ends = [-pieces[k].ways[0]] if k < len(pieces) else []
            ends += [pieces[k - 1].ways[1]] if k > 0 else []
            faces.append(
                face(
                    lambda c, point=point: point,
                    lambda c, point=point, ends=ends: max((point - c) @ end for end in ends),
                )
            )
        return faces

    def _face(self, index: int, body: Body) -> Face:
        distance, nearest = self._geometry(body)
        within = self._within(body.within)
        if isinstance(body, Cylinder | Cone):
            low, high = (
                way * math.inf if end is None else self._size(end)
                for way, end in zip((-1, 1), body.span, strict=True)
            )
            unit, origin = self._unit(body.axis), np.zeros(3)
            if isinstance(body, Cone):
                low, origin = max(low, 0.0), self._vector(body.apex)
            elif isinstance(body.axis, str):
                unit = np.abs(unit)
            else:
                origin = self._vector(body.centre)
            flat = within
            within = lambda q: max(  # noqa: E731
                low - (q - origin) @ unit, (q - origin) @ unit - high, flat(q)
            )
        if isinstance(body, Disc):
            middle, radius = self._vector(body.centre), self._size(body.radius)
            beside = within
            within = lambda q: max(np.linalg.norm(q - middle) - radius, beside(q))  # noqa: E731
        own = self._scene.restitution if body.restitution is None else body.restitution
        return Face(index, distance, nearest, within, self._size(own))

    def _geometry(self, body: Body) -> tuple[Callable[[Vector], float], Callable[[Vector], Vector]]:
        """Return the ball's distance from a body's surface, and the point of it that is nearest."""
        ball = self._ball
        if isinstance(body, Plane | Disc):
            way = body.axis if isinstance(body, Disc) else body.normal or body.axis or "z"
            unit = self._unit(way)
            point = body.centre if isinstance(body, Disc) else body.point
            at = self._size(getattr(body, "at", None) or 0)
            if point is not None:
                at = float(self._vector(point) @ unit)
            return (lambda p: p @ unit - at - ball), (lambda p: p - (p @ unit - at) * unit)
        if isinstance(body, Box):
            middle, size = (np.array([*map(self._size, v)]) for v in (body.centre, body.size))
            turn = _rotation(body.orientation and self._vector(body.orientation))
            nearest = lambda p: (  # noqa: E731
                middle + turn @ np.clip(turn.T @ (p - middle), -size / 2, size / 2)
            )
            return (lambda p: np.linalg.norm(p - nearest(p)) - ball), nearest
        if isinstance(body, Cone):
            return self._cone(body)
        if isinstance(body, Revolution):
            return self._revolution(body)
        if isinstance(body, Cylinder) and not isinstance(body.axis, str):
            return self._cylinder(body)
        assert isinstance(body, Sphere | Cylinder | Torus)
        centre = np.array([*map(self._size, body.centre)])
        radius = self._size(body.radius)
        kept = np.ones(3)
        if isinstance(body, Cylinder):
            kept["xyz".index(body.axis[-1])] = 0.0
        if isinstance(body, Torus):
            wire, unit = self._size(body.wire), self._unit(body.axis)

            def on_circle(p: Vector) -> Vector:
                across = p - centre - ((p - centre) @ unit) * unit
                return centre + across * (radius / np.linalg.norm(across))

            def on_wire(p: Vector) -> Vector:
                core = on_circle(p)
                return core + (p - core) * (wire / np.linalg.norm(p - core))

            return (lambda p: np.linalg.norm(p - on_circle(p)) - wire - ball), on_wire
        side = -1 if body.inside else 1

        def on_side(p: Vector) -> Vector:
            across = (p - centre) * kept
            return p - across + across * (radius / np.linalg.norm(across))

        return (lambda p: side * (np.linalg.norm((p - centre) * kept) - radius) - ball), on_side

    def _vector(self, written: Any) -> Vector:
        return np.array([self._size(one) for one in written])

    def _unit(self, written: Any) -> Vector:
        if isinstance(written, str):
            axis, way = _axis(written)
            return np.eye(3)[axis] * way
        if isinstance(written, Mapping):
            tilt, towards = (
                math.radians(float(written.get(name, "0deg").removesuffix("deg")))
                for name in ("tilt", "towards")
            )
            flat = np.array([math.cos(towards), math.sin(towards), 0.0])
            return math.sin(tilt) * flat + math.cos(tilt) * np.array([0.0, 0.0, 1.0])
        vector = self._vector(written)
        return np.asarray(vector / np.linalg.norm(vector))

    def _cylinder(
        self, body: Cylinder
    ) -> tuple[Callable[[Vector], float], Callable[[Vector], Vector]]:
        """Return distance and nearest point of a cylinder along any direction."""
        unit, centre, radius = self._unit(body.axis), self._vector(body.centre), body.radius
        size, side, ball = self._size(radius), -1 if body.inside else 1, self._ball

        def on_axis(p: Vector) -> Vector:
            return np.asarray(centre + ((p - centre) @ unit) * unit)

        def on_side(p: Vector) -> Vector:
            across = p - on_axis(p)
            return np.asarray(on_axis(p) + across * (size / np.linalg.norm(across)))

        return (lambda p: side * (np.linalg.norm(p - on_axis(p)) - size) - ball), on_side

    def _cone(self, body: Cone) -> tuple[Callable[[Vector], float], Callable[[Vector], Vector]]:
        """Return distance and nearest point of one nappe: on a generator, or the apex."""
        unit, apex, ball = self._unit(body.axis), self._vector(body.apex), self._ball
        half = math.atan(self._size(body.slope)) if body.half_angle is None else math.nan
        if body.half_angle is not None:
            half = math.radians(float(body.half_angle.removesuffix("deg")))
        side = -1 if body.inside else 1

        def on_side(p: Vector) -> Vector:
            height = (p - apex) @ unit
            across = p - apex - height * unit
            out = across / np.linalg.norm(across)
            way = math.cos(half) * unit + math.sin(half) * out
            return np.asarray(apex + max((p - apex) @ way, 0.0) * way)

        def distance(p: Vector) -> float:
            height = (p - apex) @ unit
            width = float(np.linalg.norm(p - apex - height * unit))
            outside = width * math.cos(half) > height * math.sin(half)
            away = float(np.linalg.norm(p - on_side(p)))
            return (away if outside else -away) * side - ball

        return distance, on_side

    def _revolution(
        self, body: Revolution
    ) -> tuple[Callable[[Vector], float], Callable[[Vector], Vector]]:
        """Return distance and nearest point of a thin wall: of all its pieces, in a half-plane."""
        unit, centre, ball = self._unit(body.axis), self._vector(body.centre), self._ball
        pieces = self._pieces(body)

        def beside(p: Vector) -> tuple[float, Vector, float, float]:
            """Return how far the wall is, the way off the axis, and radius and height there."""
            height = float((p - centre) @ unit)
            across = p - centre - height * unit
            out = math.sqrt(across @ across)
            places = [piece.nearest(out, height) for piece in pieces]
            radius, at = min(places, key=lambda place: math.dist(place, (out, height)))
            return math.dist((radius, at), (out, height)), across / out, radius, at

        def nearest(p: Vector) -> Vector:
            _, way, radius, at = beside(p)
            return np.asarray(centre + at * unit + radius * way)

        return (lambda p: beside(p)[0] - ball), nearest

    def _pieces(self, body: Revolution) -> list[Straight | Curved]:
        """Return the pieces of a profile: straight ones, and arcs through three points."""
        found: list[Straight | Curved] = []
        last = None
        for point in body.profile:
            arc = isinstance(point, Mapping)
            here = self._vector(point["to"] if arc else point)
            if last is not None:
                found.append(
                    Curved.through(last, self._vector(point["through"]), here)
                    if arc
                    else Straight(last, here)
                )
            last = here
        return found

    def _end(self, end: End) -> tuple[Callable[[Vector], float], Callable[[Vector], float]]:
        axis, way = _axis(end.axis)
        at = self._size(end.at)
        return (lambda p: p[axis] * way - at), self._within(end.within)


def _axis(written: str) -> tuple[int, int]:
    return "xyz".index(written[-1]), -1 if written[0] == "-" else 1


def _rotation(quaternion: Vector | None) -> Vector:
    """Return the rotation by a quaternion: of each axis v, q v q* over |q|²."""
    if quaternion is None:
        return np.eye(3)
    real, vector = quaternion[0], quaternion[1:]
    axes = np.eye(3)
    across = 2 * np.cross(vector, axes)
    square = quaternion @ quaternion
    return np.asarray((axes + (real * across + np.cross(vector, across)) / square).T)
