"""The bounces before a ball rolls, once more with 400 bits: how far the engine is off by then.

The sequence of bodies is the engine's; a search of one's own would find the same contacts. What is
computed again is when each comes, from the engine's time by Newton's method on the distance, and
the motion after it, by the article's law.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from flint import arb, ctx

from benchmarks.ring_roll import BOARD, RING, Floats, boxes

BITS = 400
"""Working precision; each smaller bounce takes a few bits of it."""
NEWTON = 12
"""Steps, each with twice the digits."""
SHARE = arb(2) / 5
"""Share of the slip that a gripping contact removes."""
Vector = list[arb]


def _dot(left: Vector, right: Vector) -> arb:
    return sum((a * b for a, b in zip(left, right, strict=True)), arb(0))


def _cross(left: Vector, right: Vector) -> Vector:
    return [left[k - 2] * right[k - 1] - left[k - 1] * right[k - 2] for k in range(3)]


def _middle(vector: Vector) -> Vector:
    return [part.mid() for part in vector]


class Bounced:
    """A ball in flight between contacts, with perfect grip and one restitution."""

    def __init__(self, release: Floats, scene: Mapping[str, float], restitution: float) -> None:
        self.state = [arb(float(part)) for part in release]
        self.clock = arb(0)
        self.e, self.g = arb(restitution), arb(scene["gravity"])
        self.ring, self.ball = arb(scene["ring_radius"]), arb(scene["ball_radius"])
        self.reach = self.ball + arb(scene["wire_radius"])
        self.boxes = [
            tuple([arb(float(part)) for part in corner] for corner in box) for box in boxes(scene)
        ]

    def meet(self, surface: int, time: float) -> float:
        """Fly to a contact that is near a time, and give the ball its motion after it.

        Returns
        -------
        float
            How far the ball is off the surface then, m: zero but for the last bits.
        """
        t = arb(time) - self.clock
        for _ in range(NEWTON):
            place, velocity = self._at(t)
            normal, gap = self._beside(surface, place)
            t = (t - gap / _dot(normal, velocity)).mid()
        place, velocity = (_middle(part) for part in self._at(t))
        normal, gap = self._beside(surface, place)
        spin = self.state[6:]
        off = _dot(normal, velocity)
        turned = _cross(spin, normal)
        slip = [
            v - off * n - self.ball * u for v, n, u in zip(velocity, normal, turned, strict=True)
        ]
        twist = _cross(normal, slip)
        velocity = [
            v - SHARE * u - (1 + self.e) * off * n
            for v, u, n in zip(velocity, slip, normal, strict=True)
        ]
        spin = [w + SHARE * 3 / (2 * self.ball) * m for w, m in zip(spin, twist, strict=True)]
        self.state = _middle([*place, *velocity, *spin])
        self.clock = (self.clock + t).mid()
        return float(gap)

    def _at(self, t: arb) -> tuple[Vector, Vector]:
        place, velocity = self.state[:3], self.state[3:6]
        moved = [p + v * t for p, v in zip(place, velocity, strict=True)]
        moved[2] -= self.g * t * t / 2
        return moved, [*velocity[:2], velocity[2] - self.g * t]

    def _beside(self, surface: int, place: Vector) -> tuple[Vector, arb]:
        """Return the normal at a place, and how far the ball is off the surface there."""
        if surface == RING:
            near = 1 - self.ring / (place[0] ** 2 + place[1] ** 2).sqrt()
            arm, reach = [place[0] * near, place[1] * near, place[2]], self.reach
        else:
            low, high = self.boxes[surface - BOARD]
            arm = [
                p - min(max(p, least, key=float), most, key=float)
                for p, least, most in zip(place, low, high, strict=True)
            ]
            reach = self.ball
        size = _dot(arm, arm).sqrt()
        return _middle([part / size for part in arm]), size - reach


def bounced(
    release: Floats, impacts: Any, scene: Mapping[str, float], restitution: float
) -> tuple[Floats, float]:
    """Follow a shot through its contacts.

    Returns
    -------
    tuple
        The errors of the engine's position, velocity and spin after the last of them, the largest
        of each's components; and that of its time, s.

    Raises
    ------
    ValueError
        If a contact of the log is none: the ball comes to no surface near that time.
    """
    with ctx.workprec(BITS):
        ball = Bounced(release, scene, restitution)
        for row in impacts:
            off = ball.meet(int(row["surface"]), float(row["time"]))
            if not abs(off) < 2.0**-300:
                raise ValueError(f"no contact at {row['time']} s: the ball is off by {off} m")
        there = impacts[-1]["after"]
        offs = [abs(float(a - arb(float(b)))) for a, b in zip(ball.state, there, strict=True)]
        late = abs(float(ball.clock - arb(float(impacts[-1]["time"]))))
        return np.array([max(offs[k : k + 3]) for k in (0, 3, 6)]), late
