"""The peers in Python: companion-matrix eigenvalues, and SciPy's integrator with events. Both fly
one shot at a time through the event loop below (Table 1)."""

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from benchmarks.peers.flown import Flown
from hoopgen import Outcome

Array = NDArray[np.float64]
Scene = Mapping[str, float]

RING, BACKBOARD, BRIDGE, END = range(4)


class Event(NamedTuple):
    """A surface, the time to it (s), and the state there, shape (9,)."""

    surface: int
    time: float
    state: Array


NextEvent = Callable[[Array, Scene, int | None], Event | None]
"""From a state and the surface it has just left, to the next event, or None if nothing is ahead."""


def _contact_radius(scene: Scene) -> float:
    return scene["ball_radius"] + scene["wire_radius"]


def _flight(state: Array, gravity: float, t: float) -> Array:
    """Eq. 3."""
    later = state.copy()
    later[:3] += state[3:6] * t
    later[2] -= 0.5 * gravity * t * t
    later[5] -= gravity * t
    return later


def _inside_bounds(scene: Scene, surface: int, state: Array) -> bool:
    """The inequality constraints of Table 2, and the sense of arrival that it leaves out."""
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


def _normal(scene: Scene, surface: int, state: Array) -> Array:
    """Table 2's normals."""
    if surface == BACKBOARD:
        return np.array([1.0, 0.0, 0.0])
    if surface == BRIDGE:
        return np.array([0.0, 0.0, 1.0])
    x, y, z = state[:3].tolist()
    rho = math.hypot(x, y)
    across = (rho - scene["ring_radius"]) / rho
    normal = np.array([x * across, y * across, z])
    return normal / math.sqrt(normal @ normal)


def _cross(a: Array, b: Array) -> Array:
    """`np.cross` for two vectors of three, without its overhead."""
    (a0, a1, a2), (b0, b1, b2) = a.tolist(), b.tolist()
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])


def _rebound(scene: Scene, surface: int, state: Array) -> Array:
    """Eqs. 11-17 solved: the ball leaves rolling, with restitution."""
    normal = _normal(scene, surface, state)
    velocity, spin = state[3:6], state[6:9]
    radius = scene["ball_radius"]
    speed = velocity @ normal
    tangential = (3 * (velocity - speed * normal) + 2 * radius * _cross(spin, normal)) / 5
    after = state.copy()
    after[3:6] = tangential - scene["restitution"] * speed * normal
    after[6:9] = _cross(normal, tangential) / radius + (spin @ normal) * normal
    # On the plane exactly, so that the next flight starts outside it.
    if surface == BACKBOARD:
        after[0] = radius - scene["board_distance"]
    elif surface == BRIDGE:
        after[2] = _contact_radius(scene)
    return after


def _fly(
    next_event: NextEvent, states: Array, scene: Scene, max_contacts: int, record: bool
) -> Flown:
    states = np.atleast_2d(states)
    n = len(states)
    outcome = np.full(n, Outcome.CAPPED, np.uint8)
    contacts = np.zeros(n, np.int32)
    time = np.zeros(n)
    surfaces = np.full((n, max_contacts if record else 0), -1, np.int8)
    for shot, state in enumerate(states):
        elapsed, left = 0.0, None
        while contacts[shot] < max_contacts:
            event = next_event(state, scene, left)
            if event is None:
                outcome[shot] = Outcome.SHORT
                break
            elapsed += event.time
            time[shot] = elapsed
            if event.surface == END:
                x, y = event.state[:2]
                made = x * x + y * y <= scene["ring_radius"] ** 2
                outcome[shot] = Outcome.MADE if made else Outcome.MISSED
                break
            if record:
                surfaces[shot, contacts[shot]] = event.surface
            contacts[shot] += 1
            left = event.surface
            state = _rebound(scene, left, event.state)
    return Flown(outcome, contacts, time, surfaces)


def _polynomials(state: Array, scene: Scene) -> tuple[Array, Array, Array, Array]:
    """Each surface's function along the flight, highest power first; the ring's squared free of its
    root."""
    x, y, z, vx, vy, vz = state[:6].tolist()
    radius, ring = _contact_radius(scene), scene["ring_radius"]
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
            at = _flight(state, scene["gravity"], t)
            if _inside_bounds(scene, surface, at):
                nearest = Event(surface, t, at)
                break
    return nearest


def companion_matrix(
    states: Array, parameters: Scene, max_contacts: int = 40, record: bool = False
) -> Flown:
    """Fly by the eigenvalues of each polynomial's companion matrix (the article's other method)."""
    return _fly(_companion_event, states, parameters, max_contacts, record)


EventFunction = Callable[[float, Array], float]


def _event_functions(scene: Scene) -> tuple[EventFunction, ...]:
    """Distances to the four surfaces, each ending the integration where it falls through zero."""
    radius, ring_radius = _contact_radius(scene), scene["ring_radius"]
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


def _time_in_reach(state: Array, scene: Scene) -> float:
    """Time until the ball has fallen below every surface, 0 if it has (s)."""
    lowest = min(-scene["end_depth"], scene["board_bottom"], -_contact_radius(scene)) - 1e-3
    gravity, vz = scene["gravity"], float(state[5])
    square = vz * vz + 2 * gravity * (float(state[2]) - lowest)
    return max(0.0, (vz + math.sqrt(square)) / gravity) if square > 0 else 0.0


def solve_ivp_events(
    states: Array,
    parameters: Scene,
    max_contacts: int = 40,
    record: bool = False,
    longest: float = 1e-2,
) -> Flown:
    """Fly by `scipy.integrate.solve_ivp` with terminal events, steps up to `longest` (s)."""
    functions = _event_functions(parameters)
    gravity = parameters["gravity"]

    def motion(_: float, s: Array) -> list[float]:
        return [s[3], s[4], s[5], 0.0, 0.0, -gravity]

    def next_event(state: Array, scene: Scene, left: int | None) -> Event | None:
        if left == RING:
            # Rounding may leave the ball inside, and then the next fall through zero goes unseen.
            depth = functions[RING](0.0, state)
            if depth < 0:
                state = state.copy()
                state[:3] += (1e-15 - depth) * _normal(scene, RING, state)
        watched = list(range(4))
        start, end = 0.0, _time_in_reach(state, scene)
        while start < end:
            flight = solve_ivp(
                motion,
                (start, end),
                state[:6],
                rtol=1e-9,
                atol=1e-12,
                max_step=longest,
                events=[functions[surface] for surface in watched],
            )
            if flight.status != 1:
                return None
            found = next(k for k, times in enumerate(flight.t_events) if len(times))
            surface, start = watched[found], float(flight.t_events[found][0])
            state = np.concatenate([flight.y_events[found][0], state[6:]])
            if _inside_bounds(scene, surface, state):
                return Event(surface, start, state)
            # Past the edge of a plane; no flight comes back through it this way.
            del watched[found]
        return None

    return _fly(next_event, states, parameters, max_contacts, record)
