"""The slow true answer: a shot to 50 digits, by a method that shares nothing with the engines."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

Vector = list[Decimal]


@dataclass(frozen=True)
class Flown:
    """A shot to 50 digits: outcome, (surface, time) of every event, and the state at the last."""

    outcome: str
    events: tuple[tuple[str, Decimal], ...]
    time: Decimal
    state: tuple[Decimal, ...]


def _norm(vector: Sequence[Decimal]) -> Decimal:
    return sum((c * c for c in vector), Decimal(0)).sqrt()


def _dot(left: Sequence[Decimal], right: Sequence[Decimal]) -> Decimal:
    return sum((a * b for a, b in zip(left, right, strict=True)), Decimal(0))


def _cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class March:
    """The article's method, to 50 digits: march until a distance changes its sign, then bisect.

    The distances are those of Table 2 as they stand, with their roots. A stride is the longest
    that can reach no surface: with d the distance, d' its rate and d'' >= -K, that is the root of
    d + d' s - K s²/2. Contacts go through the frame of Eqs. 7-10. The engines do none of this.
    """

    SURFACES = ("ring", "backboard", "bridge", "end")
    SHORTEST = Decimal("1e-20")
    NARROW = Decimal("1e-45")

    def __init__(self, parameters: Mapping[str, float]) -> None:
        self.given = {name: Decimal(float(value)) for name, value in parameters.items()}
        self.reach = self.given["ball_radius"] + self.given["wire_radius"]

    def distance(self, surface: str, at: Vector) -> Decimal:
        given = self.given
        if surface == "ring":
            return _norm([_norm(at[:2]) - given["ring_radius"], at[2]]) - self.reach
        if surface == "backboard":
            return at[0] + given["board_distance"] - given["ball_radius"]
        return at[2] - self.reach if surface == "bridge" else at[2] + given["end_depth"]

    def normal(self, surface: str, at: Vector) -> Vector:
        if surface != "ring":
            return [Decimal(c) for c in ((1, 0, 0) if surface == "backboard" else (0, 0, 1))]
        rho = _norm(at[:2])
        centre = [self.given["ring_radius"] * c / rho for c in at[:2]]
        out = [at[0] - centre[0], at[1] - centre[1], at[2]]
        return [c / _norm(out) for c in out]

    def counts(self, surface: str, at: Vector) -> bool:
        x, y, z = at
        given = self.given
        if surface == "backboard":
            return abs(y) <= given["board_half_width"] and (
                given["board_bottom"] <= z <= given["board_top"]
            )
        if surface == "bridge":
            outside = _norm(at[:2]) >= given["ring_radius"]
            on = -given["board_distance"] <= x <= 0
            return abs(y) <= given["bridge_half_width"] and outside and on
        return True

    def bounce(self, normal: Vector, velocity: Vector, spin: Vector) -> tuple[Vector, Vector]:
        radius = self.given["ball_radius"]
        axis = min(range(3), key=lambda k: abs(normal[k]))
        tangent = [int(k == axis) - normal[axis] * normal[k] for k in range(3)]
        first = [c / _norm(tangent) for c in tangent]
        frame = (first, _cross(normal, first), normal)
        (v1, v2, v3), (w1, w2, w3) = ([_dot(n, u) for n in frame] for u in (velocity, spin))
        v1, v2 = (3 * v1 + 2 * radius * w2) / 5, (3 * v2 - 2 * radius * w1) / 5
        local = ([v1, v2, -self.given["restitution"] * v3], [-v2 / radius, v1 / radius, w3])
        after = [[_dot(row, u) for row in zip(*frame, strict=True)] for u in local]
        return after[0], after[1]

    def next_event(
        self, position: Vector, velocity: Vector, last: str | None
    ) -> tuple[str, Decimal] | None:
        gravity = self.given["gravity"]
        bottom = 1 + max(self.reach, -self.given["board_bottom"], self.given["end_depth"])
        room = velocity[2] ** 2 + 2 * gravity * (position[2] + bottom)
        if room <= 0:
            return None
        latest = (velocity[2] + room.sqrt()) / gravity
        fastest = _norm([*velocity[:2], max(abs(velocity[2]), abs(velocity[2] - gravity * latest))])
        bends = dict.fromkeys(self.SURFACES, gravity) | {"backboard": Decimal(0)}
        # Round the ring's hole the distance bends down by 1/rho at most, rho >= R_H - R.
        bends["ring"] += fastest**2 / (self.given["ring_radius"] - self.reach)

        def there(t: Decimal) -> Vector:
            x, y, z = (p + v * t for p, v in zip(position, velocity, strict=True))
            return [x, y, z - gravity * t * t / 2]

        now, at = Decimal(0), position
        gaps = {surface: self.distance(surface, at) for surface in self.SURFACES}
        if last is not None:
            gaps[last] = Decimal(0)
        while now < latest:
            moving = [velocity[0], velocity[1], velocity[2] - gravity * now]
            stride = latest
            for surface, gap in gaps.items():
                on_axis = surface == "ring" and not _norm(at[:2])
                rate = -_norm(moving) if on_axis else _dot(self.normal(surface, at), moving)
                bend = bends[surface]
                if gap >= 0 and bend:
                    stride = min(stride, (rate + (rate * rate + 2 * bend * gap).sqrt()) / bend)
                elif gap * rate < 0:
                    stride = min(stride, -gap / rate)
            then = now + max(stride if now else stride / 2, self.SHORTEST)
            at = there(then)
            ahead = {surface: self.distance(surface, at) for surface in self.SURFACES}
            found = []
            for surface in self.SURFACES:
                assert not (now == 0 and surface == last and ahead[surface] < 0), "rests"
                if ahead[surface] <= 0 < gaps[surface]:
                    low, high = now, then
                    while high - low > self.NARROW:
                        middle = (low + high) / 2
                        outside = self.distance(surface, there(middle)) > 0
                        low, high = (middle, high) if outside else (low, middle)
                    if self.counts(surface, there(high)):
                        found.append((high, surface))
            if found:
                time, surface = min(found)
                return surface, time
            now, gaps = then, ahead
        return None

    def fly(self, state: Sequence[float], max_contacts: int) -> Flown:
        position, velocity, spin = (
            [Decimal(float(c)) for c in state[k : k + 3]] for k in (0, 3, 6)
        )
        gravity, clock, last = self.given["gravity"], Decimal(0), None
        events: list[tuple[str, Decimal]] = []
        outcome = ""
        while not outcome:
            event = self.next_event(position, velocity, last)
            if event is None:
                outcome = "SHORT"
                break
            last, t = event
            clock += t
            events.append((last, clock))
            position = [p + v * t for p, v in zip(position, velocity, strict=True)]
            position[2] -= gravity * t * t / 2
            velocity = [velocity[0], velocity[1], velocity[2] - gravity * t]
            if last == "end":
                inside = _norm(position[:2]) <= self.given["ring_radius"]
                outcome = "MADE" if inside else "MISSED"
            else:
                velocity, spin = self.bounce(self.normal(last, position), velocity, spin)
                outcome = "CAPPED" if len(events) == max_contacts else ""
        return Flown(outcome, tuple(events), clock, (*position, *velocity, *spin))
