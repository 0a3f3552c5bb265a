"""The model every peer in Python flies: flight (Eq. 3), surfaces (Table 2), contact (Eqs. 11-17) in
closed form, and the event loop of Table 1. It is model.h and loop.h in Python, and nothing of
hoopgen's: a peer is how it finds the next contact. In air the flight is another: `air`."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.peers.flown import Flown
from hoopgen import Outcome

Array = NDArray[np.float64]
Scene = Mapping[str, float]
Vector = tuple[float, float, float]

RING, BACKBOARD, BRIDGE, END = range(4)


class Event(NamedTuple):
    """A surface, the time to it (s), and the state there, shape (9,)."""

    surface: int
    time: float
    state: Array


NextEvent = Callable[[Array, Scene, int | None], Event | None]
"""Function of a state and the surface just left to the next event, None if there is none."""


IN_AIR = 60.0
"""Seconds after which a ball in air has long come down."""


class Air(NamedTuple):
    """A ball's forces per unit mass: the weight less the buoyancy (m/s^2), drag over squared speed
    and lift over spin and speed (1/m, 1), and the square of the smoothing speed (m^2/s^2)."""

    weight: float
    drag: float
    lift: float
    smooth: float


def air(scene: Scene) -> Air | None:
    """Return the forces in a scene's air, None if it has none."""
    if "air_density" not in scene:
        return None
    radius, mass, density = (scene[key] for key in ("ball_radius", "ball_mass", "air_density"))
    half = density * math.pi * radius**2 / (2 * mass)
    buoyancy = density * 4 / 3 * math.pi * radius**3 / mass
    return Air(
        scene["gravity"] * (1 - buoyancy),
        half * scene["drag_coefficient"],
        half * radius * scene["lift_coefficient"],
        scene["drag_smoothing_speed"] ** 2,
    )


def contact_radius(scene: Scene) -> float:
    return scene["ball_radius"] + scene["wire_radius"]


def flown(state: Array, gravity: float, t: float) -> Array:
    """Eq. 3."""
    later = state.copy()
    later[:3] += state[3:6] * t
    later[2] -= 0.5 * gravity * t * t
    later[5] -= gravity * t
    return later


def inside_bounds(scene: Scene, surface: int, state: Array) -> bool:
    """Return whether Table 2's inequality constraints hold, and the sense of arrival."""
    x, y, z, vx, _, vz = map(float, state[:6])
    if surface == BACKBOARD:
        return (
            vx < 0
            and abs(y) <= scene["board_half_width"]
            and scene["board_bottom"] <= z <= scene["board_top"]
        )
    if surface == BRIDGE:
        return (
            vz < 0
            and abs(y) <= scene["bridge_half_width"]
            and -scene["board_distance"] <= x <= 0
            and x * x + y * y >= scene["ring_radius"] ** 2
        )
    return surface == RING or vz < 0


def outward_normal(scene: Scene, surface: int, position: Sequence[float]) -> Vector:
    """Table 2's normals."""
    if surface == BACKBOARD:
        return 1.0, 0.0, 0.0
    if surface == BRIDGE:
        return 0.0, 0.0, 1.0
    x, y, z = position
    rho = math.hypot(x, y)
    across = rho - scene["ring_radius"]
    length = math.hypot(across, z)
    return x * across / (rho * length), y * across / (rho * length), z / length


def _cross(a: Vector, b: Vector) -> Vector:
    (a0, a1, a2), (b0, b1, b2) = a, b
    return a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0


def rebound(scene: Scene, surface: int, state: Array) -> Array:
    """Eqs. 11-17 solved: the ball leaves rolling, with restitution."""
    x, y, z, vx, vy, vz, wx, wy, wz = state.tolist()
    n0, n1, n2 = normal = outward_normal(scene, surface, (x, y, z))
    radius = scene["ball_radius"]
    speed = vx * n0 + vy * n1 + vz * n2
    spin = wx * n0 + wy * n1 + wz * n2
    c0, c1, c2 = _cross((wx, wy, wz), normal)
    t0, t1, t2 = tangential = (
        (3 * (vx - speed * n0) + 2 * radius * c0) / 5,
        (3 * (vy - speed * n1) + 2 * radius * c1) / 5,
        (3 * (vz - speed * n2) + 2 * radius * c2) / 5,
    )
    away = -scene["restitution"] * speed
    r0, r1, r2 = _cross(normal, tangential)
    # On the plane exactly, so that the next flight starts outside it.
    if surface == BACKBOARD:
        x = radius - scene["board_distance"]
    elif surface == BRIDGE:
        z = contact_radius(scene)
    velocity = (t0 + away * n0, t1 + away * n1, t2 + away * n2)
    rolling = (r0 / radius + spin * n0, r1 / radius + spin * n1, r2 / radius + spin * n2)
    return np.array((x, y, z, *velocity, *rolling))


def time_in_reach(state: Array, scene: Scene) -> float:
    """Time until the ball has fallen below every surface, 0 if it has (s)."""
    lowest = min(-scene["end_depth"], scene["board_bottom"], -contact_radius(scene)) - 1e-3
    if "air_density" in scene:
        return IN_AIR if state[2] > lowest or state[5] > 0 else 0.0
    gravity, vz = scene["gravity"], float(state[5])
    square = vz * vz + 2 * gravity * (float(state[2]) - lowest)
    return max(0.0, (vz + math.sqrt(square)) / gravity) if square > 0 else 0.0


class Log:
    """Table 1's bookkeeping for n shots: what each has met, and how it ended."""

    def __init__(self, n: int, scene: Scene, max_contacts: int, record: bool) -> None:
        self.scene, self.max_contacts, self.record = scene, max_contacts, record
        self.flown = Flown(
            np.full(n, Outcome.CAPPED, np.uint8),
            np.zeros(n, np.int32),
            np.zeros(n),
            np.full((n, max_contacts if record else 0), -1, np.int8),
        )

    def after(self, shot: int, event: Event | None) -> Array | None:
        """Enter the next event of a shot, None if nothing is ahead; return the state in which it
        flies on, None if it is over."""
        flown = self.flown
        if event is None:
            flown.outcome[shot] = Outcome.SHORT
            return None
        flown.time[shot] += event.time
        if event.surface == END:
            x, y = event.state[:2]
            made = x * x + y * y <= self.scene["ring_radius"] ** 2
            flown.outcome[shot] = Outcome.MADE if made else Outcome.MISSED
            return None
        if self.record:
            flown.surfaces[shot, flown.contacts[shot]] = event.surface
        flown.contacts[shot] += 1
        if flown.contacts[shot] == self.max_contacts:
            return None
        return rebound(self.scene, event.surface, event.state)


def fly(
    next_event: NextEvent, states: Array, scene: Scene, max_contacts: int, record: bool
) -> Flown:
    """Fly one shot after the other."""
    states = np.atleast_2d(states)
    log = Log(len(states), scene, max_contacts, record)
    for shot, start in enumerate(states):
        state: Array | None = start
        left = None
        while state is not None:
            event = next_event(state, scene, left)
            left = event.surface if event else None
            state = log.after(shot, event)
    return log.flown
