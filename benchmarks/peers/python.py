"""The peers in Python: companion-matrix eigenvalues, and SciPy's integrator with events."""

import math
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.peers.flown import Flown
from benchmarks.peers.model import (
    RING,
    Array,
    Event,
    Scene,
    air,
    contact_radius,
    flown,
    fly,
    inside_bounds,
    outward_normal,
    time_in_reach,
)


def _polynomials(state: Array, scene: Scene) -> tuple[Array, Array, Array, Array]:
    """Each surface's function along the flight, highest power first; the ring's squared free of its
    root."""
    x, y, z, vx, vy, vz = state[:6].tolist()
    radius, ring = contact_radius(scene), scene["ring_radius"]
    height = np.array([-0.5 * scene["gravity"], vz, z])
    rho2 = np.array([vx * vx + vy * vy, 2 * (x * vx + y * vy), x * x + y * y])
    total = np.convolve(height, height)
    total[2:] += rho2
    total[4] += ring * ring - radius * radius
    octic = np.convolve(total, total)
    octic[6:] -= 4 * ring * ring * rho2
    backboard = np.array([vx, x + scene["board_distance"] - scene["ball_radius"]])
    bridge = height - [0.0, 0.0, radius]
    end = height + [0.0, 0.0, scene["end_depth"]]
    return octic, backboard, bridge, end


def _companion_event(state: Array, scene: Scene, left: int | None) -> Event | None:
    nearest: Event | None = None
    for surface, polynomial in enumerate(_polynomials(state, scene)):
        # At a surface just left, t = 0 is a root: divided out.
        deflated = polynomial[:-1] if surface == left else polynomial
        roots = np.roots(deflated)
        # Grazing pairs come out as complex by the square root of eps.
        real = np.sort(roots.real[np.abs(roots.imag) < 1e-8])
        real = real[real > 0]
        arriving = real[np.polyval(np.polyder(polynomial), real) < 0]
        for t in arriving.tolist():
            if nearest is not None and t >= nearest.time:
                break
            at = flown(state, scene["gravity"], t)
            if inside_bounds(scene, surface, at):
                nearest = Event(surface, t, at)
                break
    return nearest


def companion_matrix(
    states: Array, parameters: Scene, max_contacts: int = 40, record: bool = False
) -> Flown:
    """Fly by the eigenvalues of each polynomial's companion matrix (the article's other method)."""
    return fly(_companion_event, states, parameters, max_contacts, record)


EventFunction = Callable[[float, Array], float]


def _event_functions(scene: Scene) -> tuple[EventFunction, ...]:
    """Distances to the four surfaces, each ending the integration where it falls through zero."""
    radius, ring_radius = contact_radius(scene), scene["ring_radius"]
    front = scene["ball_radius"] - scene["board_distance"]
    depth = scene["end_depth"]

    def ring(_: float, s: Array) -> float:
        return math.hypot(math.hypot(s[0], s[1]) - ring_radius, s[2]) - radius

    def backboard(_: float, s: Array) -> float:
        return float(s[0]) - front

    def bridge(_: float, s: Array) -> float:
        return float(s[2]) - radius

    def end(_: float, s: Array) -> float:
        return float(s[2]) + depth

    functions = (ring, backboard, bridge, end)
    for function in functions:
        vars(function).update(terminal=True, direction=-1)
    return functions


def _motion(scene: Scene, spin: list[float]) -> Callable[[float, Array], list[float]]:
    """Return the rates of place and velocity of a ball with a spin, as a function of both."""
    gravity, forces = scene["gravity"], air(scene)
    if forces is None:
        return lambda _, s: [s[3], s[4], s[5], 0.0, 0.0, -gravity]
    weight, drag, lift, smooth = forces
    wx, wy, wz = spin

    def motion(_: float, s: Array) -> list[float]:
        vx, vy, vz = s[3:].tolist()
        slowing = drag * math.sqrt(vx * vx + vy * vy + vz * vz + smooth)
        return [
            vx,
            vy,
            vz,
            lift * (wy * vz - wz * vy) - slowing * vx,
            lift * (wz * vx - wx * vz) - slowing * vy,
            lift * (wx * vy - wy * vx) - slowing * vz - weight,
        ]

    return motion


def solve_ivp_events(
    states: Array,
    parameters: Scene,
    max_contacts: int = 40,
    record: bool = False,
    longest: float = 1e-2,
) -> Flown:
    """Fly by `scipy.integrate.solve_ivp` with terminal events, steps up to `longest` (s): without
    air by RK45 to 1e-9, in air by DOP853 to 1e-12."""
    functions = _event_functions(parameters)
    in_air = air(parameters) is not None
    solver = {"method": "DOP853", "rtol": 1e-12} if in_air else {"method": "RK45", "rtol": 1e-9}

    def next_event(state: Array, scene: Scene, left: int | None) -> Event | None:
        if left == RING:
            # Rounding may leave the ball inside, and then the next fall through zero goes unseen.
            depth = functions[RING](0.0, state)
            if depth < 0:
                state = state.copy()
                up = np.array(outward_normal(scene, RING, state[:3].tolist()))
                state[:3] += (1e-15 - depth) * up
        motion = _motion(scene, state[6:].tolist())
        watched = list(range(4))
        start, end = 0.0, time_in_reach(state, scene)
        while start < end:
            flight = solve_ivp(
                motion,
                (start, end),
                state[:6],
                **solver,
                atol=1e-12,
                max_step=longest,
                events=[functions[surface] for surface in watched],
            )
            if flight.status != 1:
                return None
            found = next(k for k, times in enumerate(flight.t_events) if len(times))
            surface, start = watched[found], float(flight.t_events[found][0])
            state = np.concatenate([flight.y_events[found][0], state[6:]])
            if inside_bounds(scene, surface, state):
                return Event(surface, start, state)
            # Past the edge of a plane; no flight comes back through it this way.
            del watched[found]
        return None

    return fly(next_event, states, parameters, max_contacts, record)
