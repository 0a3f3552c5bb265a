"""Balls whose derivatives are known in closed form, and what hoopgen gives for them.

The time is fixed: the ball drifts along y at 1 m/s without friction, so that the shot ends at the
plane y = -T, and the derivative of the state at the end is the one at the time T.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from hoopgen.scene import End, Plane, Scene

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Ball:
    """A ball over a floor, dropped from rest.

    Attributes
    ----------
    restitution, gravity
        Of the floor, and in m/s^2.
    height
        Of the lowest point of the ball at the release (m).
    radius
        Of the ball (m).
    stiffness
        Of the spring that stands for the floor in programs whose contacts are soft (1/s^2).
    step
        Time step (s) of the programs that take steps.
    """

    restitution: float = 0.8
    gravity: float = 9.81
    height: float = 1.0
    radius: float = 0.1
    stiffness: float = 1e4
    step: float = 5e-4

    def truth(self, time: float) -> tuple[float, float, int]:
        """Return height (m), its derivative by the height of the release, and contacts, at a time.

        With t_0 the first contact, contact k is at t_0 (1 + 2 e (1 - e^k) / (1 - e)), and the speed
        after it is e^(k+1) g t_0; all are proportional to the root of the height.
        """
        first = (2 * self.height / self.gravity) ** 0.5
        later = first / (2 * self.height)
        contact, slope, speed, rise = first, later, self.gravity * first, self.gravity * later
        if time < first:
            return self.radius + self.height - self.gravity * time**2 / 2, 1.0, 0
        contacts = 1
        while True:
            speed, rise = self.restitution * speed, self.restitution * rise
            since = time - contact
            if since < 2 * speed / self.gravity:
                place = self.radius + speed * since - self.gravity * since**2 / 2
                return place, rise * since - slope * (speed - self.gravity * since), contacts
            contact += 2 * speed / self.gravity
            slope += 2 * rise / self.gravity
            contacts += 1


BALL = Ball()
"""Its steps are a 250th part of the shortest flight here; a soft contact takes some sixty."""
TIMES = (0.6, 1.2, 1.6, 1.9)
"""Times (s) at which the height is wanted, after one, two, two and three contacts."""

SPRING_BALL = Ball(restitution=1.0, height=0.88, radius=0.12, stiffness=1e3, step=2e-3)
"""The ball of google-deepmind/mujoco, issue 1668, without its air; the floor takes no energy."""
SPRING_TIMES = (0.7, 1.0, 1.2)
"""Times (s), between its first contact and its second."""


@cache
def floor(time: float, ball: Ball, wall: float | None = None) -> Any:
    """Return the compiled scene that ends at a time (s): a floor, and a wall at x = `wall` (m)."""
    bodies = [Plane("floor", at=0.0, friction=0.0)]
    if wall is not None:
        bodies.append(Plane("wall", axis="-x", at=-wall, friction=0.0))
    return hoopgen.compile(
        Scene(
            "floor",
            bodies=bodies,
            ball_radius=ball.radius,
            gravity=ball.gravity,
            restitution=ball.restitution,
            ends={"clock": End(axis="y", at=-time)},
        )
    )


def hoopgen_slopes(
    ball: Ball = BALL, times: Sequence[float] = TIMES, shots: int = 1
) -> list[float]:
    """Return the derivative of the height at each time by the height of the release."""
    state = np.zeros((shots, 9))
    state[:, 2], state[:, 4] = ball.radius + ball.height, -1.0
    found = []
    for time in times:
        scene = floor(time, ball)
        ends = hoopgen.simulate(state, scene=scene, derivatives=["z"])
        found.append(float(ends.jacobian["state"][0, 2, 0]))
    return found


LOSSLESS = Ball(restitution=1.0, gravity=0.0)
"""The ball of task 1 of diff_sim_grads."""


def task_1() -> tuple[Floats, Floats]:
    """Return the derivatives of task 1 of diff_sim_grads: height at 1 s by z, vz; hoopgen, truth.

    No gravity, no loss: z = 2 r - z0 - v0 T after the bounce.
    """
    state = [-1, 0, 1, 2, -1, -2, 0, 0, 0]
    shots = hoopgen.simulate(state, scene=floor(1.0, LOSSLESS), derivatives=["z", "vz"])
    return shots.jacobian["state"][0, 2], np.array([-1.0, -1.0])


TARGET = np.array([-2.0, 1.5])
"""The target of task 2, x and z (m)."""


def task_2() -> tuple[Floats, Floats]:
    """Return the derivatives of task 2: squared distance at 0.6 s by x, z, vx, vz.

    The distance is that to `TARGET`. In x the ball meets a wall, in z a floor; e = 0.92, g = 9.8
    m/s^2. hoopgen, truth.
    """
    time, gravity, e, radius = 0.6, 9.8, 0.92, 0.1
    names = ("x", "z", "vx", "vz")
    (x, z, vx, vz) = start = (-0.5, 1.0, 5.0, -5.0)
    state = [x, 0, z, vx, -1, vz, 0, 0, 0]
    scene = floor(time, Ball(e, gravity), wall=1.75)
    shots = hoopgen.simulate(state, scene=scene, derivatives=names)
    away = shots.state[0, [0, 2]] - TARGET
    found = 2 * away @ shots.jacobian["state"][0, [0, 2]]

    # x turns at the wall: x = w - e (x0 + vx T - w), w where the centre is.
    wall = 1.75 - radius
    at_x = wall - e * (start[0] + vx * time - wall)
    # z turns at t = (vz + s) / g, s = sqrt(vz^2 + 2 g (z0 - r)) the speed of arrival.
    speed = (vz**2 + 2 * gravity * (z - radius)) ** 0.5
    met, since = (vz + speed) / gravity, time - (vz + speed) / gravity
    at_z = radius + e * speed * since - gravity * since**2 / 2
    falling = gravity * since - e * speed
    slopes = [
        e * changed * since + falling * (own + changed) / gravity
        for changed, own in ((gravity / speed, 0.0), (vz / speed, 1.0))
    ]
    assert 0 < met < time
    far_x, far_z = 2 * (at_x - TARGET[0]), 2 * (at_z - TARGET[1])
    truth = [-e * far_x, slopes[0] * far_z, -e * time * far_x, slopes[1] * far_z]
    return np.asarray(found), np.array(truth)
