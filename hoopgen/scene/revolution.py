"""Reading of surfaces of revolution: a profile is expanded into the faces that it sweeps.

With the distance rho of the ball's centre from the axis and its height h along it, a straight piece
from (r₁, h₁) to (r₂, h₂) sweeps the side of a cone or of a cylinder, or a flat ring, and a circular
arc sweeps a part of a torus or of a sphere. A piece leaves its first point along the unit vector
(c₁, s₁) and arrives at its last one along (c₂, s₂). The ball touches it where

    0 <= (rho - r₁) c₁ + (h - h₁) s₁   and   (rho - r₂) c₂ + (h - h₂) s₂ <= 0.

On an arc these are the directions from its centre between those of its ends; one that is longer
than half a circle is touched where either of the two holds. A point of the profile sweeps an edge,
which the ball touches where, of each piece that ends there, it is beyond that end. Both ask the
same formula for the sign, so that no gap is between them. Where an arc continues its neighbour
without a corner both have one vector, and there is no edge.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import hypot, pi

from . import pieces
from .directions import Reader, Vector, axis_or_direction, dot, settled, vector_inputs
from .formulas import ONE, ZERO, Formula, constant
from .profile import Arc, Line, Profile, Sizes, Vertex, Way
from .profile_curves import Arc as Curve
from .profile_curves import ways_at
from .profile_points import ProfilePiece, ProfilePoint, read_profile

ON_AXIS = 1e-9
"""Distance of an arc's centre from the axis, relative to the arc's radius, up to which it is on it:
roundings of the three points leave so little."""

LEAST_OFFSET = 0.01
"""Least distance of an arc's centre from the axis if it is not on it, relative to the arc's radius:
nearer to it the circle and its mirror image are almost the same, and little is certain."""

SMOOTH = 1e-9
"""Largest angle between pieces that continue one another without a corner, rad."""


def read_revolution(
    reader: Reader, owner: str, body: pieces.Revolution, ball: Formula
) -> tuple[Sizes, Profile]:
    """Return the sizes of a surface of revolution, and its profile.

    Parameters
    ----------
    reader, owner, body, ball
        As for `hoopgen.scene.oblique_bodies.read_disc`.

    Raises
    ------
    SceneError
        As of `read_profile`, or if the centre of an arc is almost on the axis.
    """
    inputs = reader.inputs
    points, found = read_profile(reader, owner, body.profile)
    vector = axis_or_direction(reader, owner, "axis", body.axis)
    centre = tuple(reader.point(owner, "centre", body.centre).values())
    sizes = vector_inputs(inputs, owner, "direction", vector, "1")
    sizes |= vector_inputs(inputs, owner, "centre", centre)
    radius = inputs.number(owner, "", ball)
    placed = _Placed(reader, owner, vector, centre, ball, radius, points, found)
    lines = [placed.piece(k) for k in range(len(found))]
    used = [formula for point in points for formula in point.formulas]
    used += [formula for one in found if one.middle for formula in one.middle.formulas]
    profile = Profile(
        tuple(placed.vertex(k) for k in range(len(points))),
        tuple(lines),
        fixed=not any(formula.names for formula in (*used, ball)),
    )
    return tuple(sizes.items()), profile


@dataclass(frozen=True, eq=False)
class _Placed:
    """A profile with its axis, and the ball that touches it."""

    reader: Reader
    owner: str
    vector: Vector
    centre: Sequence[Formula]
    ball: Formula
    ball_radius: float
    points: Sequence[ProfilePoint]
    pieces: Sequence[ProfilePiece]

    def _axis_point(self, argument: str, height: Formula) -> dict[str, Formula]:
        """Return the point of the axis at a height as inputs."""
        there = [
            settled(own + height * part) for own, part in zip(self.centre, self.vector, strict=True)
        ]
        return vector_inputs(self.reader.inputs, self.owner, argument, there)

    def vertex(self, number: int) -> Vertex:
        """Return a point of the profile, as inputs."""
        inputs, own, point = self.reader.inputs, f"point {number + 1}", self.points[number]
        radius, height = point.formulas
        x, y, z = self._axis_point(own, height).values()
        sign = "nonnegative" if radius == ZERO else "positive"
        return Vertex(
            inputs.add(self.owner, f"{own} radius", radius, sign=sign),
            inputs.add(self.owner, f"{own} height", height),
            (x, y, z),
            narrow=point.values[0] <= self.ball_radius,
            smooth=number in self._joints,
        )

    def piece(self, number: int) -> Line | Arc:
        """Return a piece of the profile: its kind and sizes."""
        return self._line(number) if self.pieces[number].middle is None else self._arc(number)

    # The vectors along pieces

    @cached_property
    def _joints(self) -> dict[int, tuple[int, int]]:
        """The pieces that come and go at points without a corner, by the number of the point.

        Those are points of which one piece or both are arcs, all of it numbers: what changes from
        shot to shot may have a corner in any.
        """
        found = {}
        for come, before in enumerate(self.pieces):
            for go, after in enumerate(self.pieces):
                if before.end != after.start or not (before.middle or after.middle):
                    continue
                sine, cosine = ways_at(before.curve, after.curve)
                fixed = not any(f.names for one in (before, after) for f in self._formulas(one))
                if fixed and cosine > 0 and abs(sine) <= SMOOTH:
                    found[before.end] = (come, go)
        return found

    def _formulas(self, piece: ProfilePiece) -> list[Formula]:
        ends = [self.points[piece.start], self.points[piece.end]]
        return [f for point in (*ends, piece.middle) if point for f in point.formulas]

    def _way(self, number: int, last: bool) -> Way:
        """Return the vector along a piece at its start or its end, as inputs.

        At a point without a corner it is that of a straight neighbour, or of the piece before.
        """
        piece = self.pieces[number]
        come, go = self._joints.get(piece.end if last else piece.start, (number, number))
        owner = go if self.pieces[go].middle is None else come
        if owner != number:
            return self._way(owner, owner == come)
        own = f"piece {number + 1}"
        first, final = self.points[piece.start].formulas, self.points[piece.end].formulas
        if piece.middle is None:
            steps = [b - a for a, b in zip(first, final, strict=True)]
            length = (steps[0] ** 2 + steps[1] ** 2).sqrt()
            signs = self._signs(piece)
            shares = [
                constant(sign) if other == ZERO else settled(step / length)
                for step, other, sign in zip(steps, reversed(steps), signs, strict=True)
            ]
        else:
            own += " end" if last else " start"
            (a, b), radius = self._circle(piece)
            x, y = final if last else first
            turn = constant(piece.curve.turn)  # type: ignore[union-attr]
            shares = [_share(turn * (b - y) / radius), _share(turn * (x - a) / radius)]
        return self._unit(own, shares)

    def _unit(self, own: str, shares: Sequence[Formula]) -> Way:
        found = []
        for name, share in zip("rh", shares, strict=True):
            whole = share in (ZERO, ONE, constant(-1))
            made = self.reader.inputs.add
            argument = f"{own} along {name}"
            found.append(share if whole else made(self.owner, argument, share, unit="1"))
        return found[0], found[1]

    @staticmethod
    def _signs(piece: ProfilePiece) -> tuple[int, int]:
        x, y = piece.curve.ways[0]
        return (x > 0) - (x < 0), (y > 0) - (y < 0)

    # Straight pieces

    def _line(self, number: int) -> Line:
        piece, own = self.pieces[number], f"piece {number + 1}"
        first, last = self.points[piece.start], self.points[piece.end]
        steps = [b - a for a, b in zip(first.formulas, last.formulas, strict=True)]
        values = [b - a for a, b in zip(first.values, last.values, strict=True)]
        signs, ways = self._signs(piece), (self._way(number, False), self._way(number, True))
        kind = "cylinder" if steps[0] == ZERO else "disc" if steps[1] == ZERO else "cone"
        widest = max(first.values[0], last.values[0])
        upright = abs(values[1]) / hypot(*values)
        return Line(
            piece.start,
            piece.end,
            kind,
            ways,
            signs,
            tuple(self._sizes(own, kind, first, steps, signs)),
            inner=kind == "disc" or widest > self.ball_radius * upright,
        )

    def _sizes(
        self,
        own: str,
        kind: str,
        first: ProfilePoint,
        steps: Sequence[Formula],
        signs: Sequence[int],
    ) -> Iterator[tuple[str, Formula]]:
        """Yield the inputs that the faces of a piece need, by argument."""
        inputs, (radius, height) = self.reader.inputs, first.formulas
        if kind == "cylinder":
            yield "radius", inputs.add(self.owner, f"{own} radius", radius, sign="positive")
            way = dot(self.vector, self.centre)
            near = [
                settled(c - way * part) for c, part in zip(self.centre, self.vector, strict=True)
            ]
            found = vector_inputs(inputs, self.owner, f"{own} axis", near)
            yield from (
                (f"axis {axis}", part) for axis, part in zip("xyz", found.values(), strict=True)
            )
        elif kind == "disc":
            at = settled(dot(self.vector, self.centre) + height)
            yield "at", inputs.add(self.owner, f"{own} at", at)
        else:
            slope = settled(constant(signs[0] * signs[1]) * steps[0] / steps[1])
            yield (
                "slope",
                inputs.add(self.owner, f"{own} slope", slope, sign="positive", unit="1"),
            )
            apex = height - radius * steps[1] / steps[0]
            away = self.ball * (ONE + slope**2).sqrt() / slope
            for side, sign in (("outside", -1), ("inside", 1)):
                shifted = apex + constant(sign * signs[0] * signs[1]) * away
                found = self._axis_point(f"{own} {side} apex", settled(shifted))
                parts = zip("xyz", found.values(), strict=True)
                yield from ((f"{side} apex {axis}", part) for axis, part in parts)

    # Arcs

    def _circle(self, piece: ProfilePiece) -> tuple[Way, Formula]:
        """Return the centre of an arc's circle, and its radius, as formulas."""
        assert piece.middle is not None
        (x, y), (p, q), (v, w) = (
            self.points[piece.start].formulas,
            piece.middle.formulas,
            self.points[piece.end].formulas,
        )
        p, q, v, w = p - x, q - y, v - x, w - y
        double, near, far = constant(2) * (p * w - q * v), p**2 + q**2, v**2 + w**2
        across, up = (near * w - far * q) / double, (far * p - near * v) / double
        return (x + across, y + up), (across**2 + up**2).sqrt()

    def _arc(self, number: int) -> Arc:
        piece, own, inputs = self.pieces[number], f"piece {number + 1}", self.reader.inputs
        curve, sizes = piece.curve, {}
        assert isinstance(curve, Curve)
        assert piece.middle is not None
        ((offset, height), radius), away = self._circle(piece), curve.centre[0]
        on_axis = abs(away) <= ON_AXIS * curve.radius
        if not on_axis and abs(away) < LEAST_OFFSET * curve.radius:
            least = LEAST_OFFSET * curve.radius
            said = f"its centre is {away:g} m from the axis; expected on the axis, or at least "
            said += f"{least:g} m away"
            raise inputs.wrong(self.owner, f"profile {own}", said)
        ways = (self._way(number, False), self._way(number, True))
        sizes["radius"] = inputs.add(self.owner, f"{own} radius", settled(radius), sign="positive")
        fixed = not any(formula.names for formula in self._formulas(piece))
        if not (on_axis and fixed):
            sizes["offset"] = inputs.add(self.owner, f"{own} offset", settled(offset))
        there = self._axis_point(f"{own} centre", height)
        sizes |= {f"centre {axis}": p for axis, p in zip("xyz", there.values(), strict=True)}
        if not fixed:
            # The middle point is on that side of the chord on which it is at the defaults.
            sizes["bend"] = inputs.add(self.owner, f"{own} bend", self._bend(piece), unit="m²")
        clear = abs(away) / (1.0 + ON_AXIS) if fixed and not self.ball.names else 0.0
        round_side, hollow_side = (curve.radius + w * self.ball_radius for w in (1, -1))
        return Arc(
            piece.start,
            piece.end,
            "sphere" if on_axis else "torus",
            ways,
            tuple(sizes.items()),
            piece.middle.formulas,
            0 if on_axis else 1 if away > 0 else -1,
            curve.turn,
            long=curve.sweep > pi + SMOOTH,
            hollow=hollow_side > 0,
            across=(round_side >= clear, hollow_side >= clear),
            inner=self._touches_inside(curve),
        )

    def _bend(self, piece: ProfilePiece) -> Formula:
        """Return twice the area between an arc's three points, on the side where it is."""
        assert piece.middle is not None
        assert isinstance(piece.curve, Curve)
        (x, y), (p, q), (v, w) = (
            self.points[piece.start].formulas,
            piece.middle.formulas,
            self.points[piece.end].formulas,
        )
        return constant(piece.curve.turn) * ((p - x) * (w - y) - (q - y) * (v - x))

    def _touches_inside(self, curve: Curve) -> bool:
        """Return whether the ball touches the side of an arc that faces the axis."""
        rise = curve.end[1] - curve.start[1]
        if rise == 0:
            return False
        facing_hollow = curve.turn * rise > 0
        if facing_hollow and curve.radius <= self.ball_radius:
            return False
        reach = curve.radius + (-1 if facing_hollow else 1) * self.ball_radius
        away = curve.centre[0]
        return any(away + (x - away) * reach / curve.radius > 0 for x, _ in curve.samples(48))


def _share(formula: Formula) -> Formula:
    """Return a component of a unit vector; what is a whole number up to roundings is that one."""
    found = settled(formula)
    if found.number is not None:
        nearest = round(found.number)
        if abs(found.number - nearest) < _ROUNDED:
            return constant(nearest)
    return found


_ROUNDED = 2.0**-50
"""Largest difference between a component of a vector and a whole number that is a rounding."""
