"""The pieces of a profile at the parameters' defaults, in doubles: where they run, and cross."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from math import atan2, cos, dist, hypot, pi, sin, sqrt

Place = tuple[float, float]

_APART = 1e-9
"""Distance between two points that are not the same, relative to the sizes of their pieces."""


def _difference(last: Place, first: Place) -> Place:
    return last[0] - first[0], last[1] - first[1]


def _dot(left: Place, right: Place) -> float:
    return left[0] * right[0] + left[1] * right[1]


def _cross(left: Place, right: Place) -> float:
    return left[0] * right[1] - left[1] * right[0]


@dataclass(frozen=True)
class Segment:
    """A straight piece from one point to another.

    Attributes
    ----------
    start, end
        Radius and height of its ends, m.
    """

    start: Place
    end: Place

    @cached_property
    def ways(self) -> tuple[Place, Place]:
        """The unit vectors along it at its start and at its end."""
        x, y = _difference(self.end, self.start)
        length = hypot(x, y)
        return ((x / length, y / length),) * 2

    def contains(self, point: Place) -> bool:
        """Return whether a point of its line is on it."""
        length = dist(self.start, self.end)
        away = _dot(_difference(point, self.start), self.ways[0])
        return -_APART * length <= away <= (1 + _APART) * length

    def samples(self, count: int) -> list[Place]:
        """Return so many points of it, and its end, evenly."""
        step = _difference(self.end, self.start)
        shares = [k / count for k in range(count + 1)]
        return [(self.start[0] + s * step[0], self.start[1] + s * step[1]) for s in shares]


@dataclass(frozen=True)
class Arc:
    """A circular arc from one point through another to a third one.

    Attributes
    ----------
    start, middle, end
        Radius and height of these points, m.
    """

    start: Place
    middle: Place
    end: Place

    @property
    def bend(self) -> float:
        """The distance of the middle point from the chord, to its right, over the chord."""
        chord = _difference(self.end, self.start)
        return _cross(_difference(self.middle, self.start), chord) / _dot(chord, chord)

    @property
    def turn(self) -> int:
        """1 if it turns to the left, from radii to heights, -1 if to the right."""
        return 1 if self.bend > 0 else -1

    @cached_property
    def centre(self) -> Place:
        """The centre of its circle."""
        u, v = (_difference(point, self.start) for point in (self.middle, self.end))
        double, (a, b) = 2.0 * _cross(u, v), (_dot(u, u), _dot(v, v))
        x, y = (a * v[1] - b * u[1]) / double, (b * u[0] - a * v[0]) / double
        return self.start[0] + x, self.start[1] + y

    @cached_property
    def radius(self) -> float:
        """The radius of its circle."""
        return dist(self.centre, self.start)

    @cached_property
    def ways(self) -> tuple[Place, Place]:
        """The unit vectors along it at its start and at its end."""
        first, last = (_difference(point, self.centre) for point in (self.start, self.end))
        scale = self.turn / self.radius
        return (-first[1] * scale, first[0] * scale), (-last[1] * scale, last[0] * scale)

    @cached_property
    def sweep(self) -> float:
        """The angle of it, above 0 and below a turn, rad."""
        return self._turned(self.end)

    def _turned(self, point: Place) -> float:
        """Return the angle from its start to a direction, from 0 to a turn, rad."""
        first, last = (_difference(p, self.centre) for p in (self.start, point))
        return (self.turn * atan2(_cross(first, last), _dot(first, last))) % (2.0 * pi)

    def contains(self, point: Place) -> bool:
        """Return whether a point of its circle is on it."""
        angle = self._turned(point)
        return angle <= self.sweep + _APART or angle >= 2.0 * pi - _APART

    def samples(self, count: int) -> list[Place]:
        """Return so many points of it, and its end, evenly."""
        x, y = _difference(self.start, self.centre)
        found = []
        for k in range(1, count):
            angle = self.turn * self.sweep * k / count
            c, s = cos(angle), sin(angle)
            found.append((self.centre[0] + c * x - s * y, self.centre[1] + s * x + c * y))
        return [self.start, *found, self.end]

    @property
    def least_radius(self) -> float:
        """The least distance from the axis of its points between its ends."""
        (first, _), (last, _) = self.ways
        through = (first < 0) and (last > 0) if self.sweep <= pi else (first < 0) or (last > 0)
        ends = min(self.start[0], self.end[0])
        return min(ends, self.centre[0] - self.radius) if through else ends


Curve = Segment | Arc


def ways_at(before: Curve, after: Curve) -> tuple[float, float]:
    """Return sine and cosine of the angle by which a line turns from one piece to the next.

    Parameters
    ----------
    before, after
        The pieces.
    """
    come, go = before.ways[1], after.ways[0]
    return _cross(come, go), _dot(come, go)


def meet(first: Curve, second: Curve, shared: Sequence[Place] = ()) -> bool:
    """Return whether two pieces have a point in common besides those that they share as ends.

    Parameters
    ----------
    first, second
        The pieces.
    shared
        The points that are ends of both.
    """
    if isinstance(first, Segment) and isinstance(second, Segment):
        return len(shared) == 2 or (not shared and _cut(first, second))
    size = max(dist(c.start, c.end) for c in (first, second))
    return any(
        first.contains(point)
        and second.contains(point)
        and all(dist(point, end) > _APART * size for end in shared)
        for point in _common(first, second, shared)
    )


def _cut(first: Segment, second: Segment) -> bool:
    """Return whether two straight pieces have a point in common, exactly."""

    def side(piece: Segment, point: Place) -> float:
        return _cross(_difference(piece.end, piece.start), _difference(point, piece.start))

    def between(piece: Segment, point: Place) -> bool:
        ends = zip(piece.start, piece.end, point, strict=True)
        return all(min(a, b) <= p <= max(a, b) for a, b, p in ends)

    sides = [side(first, p) for p in (second.start, second.end)]
    others = [side(second, p) for p in (first.start, first.end)]
    if sides[0] * sides[1] < 0 and others[0] * others[1] < 0:
        return True
    pairs = [*product([first], zip(sides, (second.start, second.end), strict=True))]
    pairs += [*product([second], zip(others, (first.start, first.end), strict=True))]
    return any(off == 0 and between(piece, point) for piece, (off, point) in pairs)


def _common(first: Curve, second: Curve, shared: Sequence[Place]) -> Iterator[Place]:
    """Yield points in which the whole lines or circles of two pieces meet, one being an arc.

    The second point besides a shared one is had without a root, so that pieces that are tangent to
    one another in the shared point are not taken to meet beside it.
    """
    if isinstance(first, Segment):
        first, second = second, first
    assert isinstance(first, Arc)
    centre, radius = first.centre, first.radius
    if isinstance(second, Segment):
        origin, way = (shared[0] if shared else second.start), second.ways[0]
        offset = _difference(origin, centre)
        half = _dot(offset, way)
        square = half * half - (_dot(offset, offset) - radius * radius)
        steps = [-2.0 * half] if shared else _roots(-half, square)
        yield from ((origin[0] + s * way[0], origin[1] + s * way[1]) for s in steps)
        return
    way = _difference(second.centre, centre)
    length = hypot(*way)
    if length <= _APART * max(radius, second.radius):
        if abs(radius - second.radius) <= _APART * radius:
            yield from (p for arc in (first, second) for p in arc.samples(2))
        return
    unit = (way[0] / length, way[1] / length)
    if shared:
        offset = _difference(shared[0], centre)
        across = _cross(unit, offset)
        yield shared[0][0] + 2.0 * across * unit[1], shared[0][1] - 2.0 * across * unit[0]
        return
    along = (length * length + radius * radius - second.radius * second.radius) / (2.0 * length)
    for across in _roots(0.0, radius * radius - along * along):
        x = centre[0] + along * unit[0] - across * unit[1]
        yield x, centre[1] + along * unit[1] + across * unit[0]


def _roots(middle: float, square: float) -> list[float]:
    return [middle - sqrt(square), middle + sqrt(square)] if square >= 0 else []
