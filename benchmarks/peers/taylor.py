"""heyoka.py: Taylor's method of order 20, with the contacts as terminal events on its series, some
shots side by side in batch mode."""

from functools import cache
from typing import Any

import numpy as np

from benchmarks.peers.flown import Flown
from benchmarks.peers.model import (
    Air,
    Array,
    Event,
    Log,
    Scene,
    air,
    contact_radius,
    inside_bounds,
    time_in_reach,
)

SURFACES = range(4)
LANES = 8
"""Shots side by side; more gain hardly anything: events are looked for lane by lane."""


PLACE = 5
"""Parameters of the scene's places; those of its air, and the spin, come after them."""
SPIN = PLACE + len(Air._fields) - 1


def _acceleration(hy: Any, velocity: Any, in_air: bool) -> tuple[Any, Any, Any]:
    """Return the ball's acceleration: the weight, and in air drag and the Magnus force."""
    vx, vy, vz = velocity
    weight = hy.par[PLACE - 1]
    if not in_air:
        return 0.0 * vx, 0.0 * vx, -weight
    drag, lift, smooth, wx, wy, wz = (hy.par[k] for k in range(PLACE, SPIN + 3))
    slowing = drag * hy.sqrt(vx * vx + vy * vy + vz * vz + smooth)
    return (
        lift * (wy * vz - wz * vy) - slowing * vx,
        lift * (wz * vx - wx * vz) - slowing * vy,
        lift * (wx * vy - wy * vx) - slowing * vz - weight,
    )


@cache
def _integrator(in_air: bool) -> Any:
    """The flight, and the four surfaces as events where they are reached from outside. Without air
    all are polynomials in time, and so is their series; the ring's is squared free of its root."""
    import heyoka as hy

    # Warnings go to standard output: of some grazes it says that it has not found the root.
    hy.set_logger_level_error()
    x, y, z, vx, vy, vz = hy.make_vars("x", "y", "z", "vx", "vy", "vz")
    ring, radius, front, depth = (hy.par[k] for k in range(PLACE - 1))
    rho2 = x * x + y * y
    total = rho2 + z * z + ring * ring - radius * radius
    surfaces = (total * total - 4.0 * ring * ring * rho2, x - front, z - radius, z + depth)
    faster = _acceleration(hy, (vx, vy, vz), in_air)
    return hy.taylor_adaptive_batch(
        list(zip((x, y, z, vx, vy, vz), (vx, vy, vz, *faster), strict=True)),
        np.zeros((6, LANES)),
        pars=np.zeros((SPIN + 3 if in_air else PLACE, LANES)),
        t_events=[
            hy.t_event_batch(surface, direction=hy.event_direction.negative) for surface in surfaces
        ],
    )


class _Lanes:
    """The integrator's lanes, each with a shot in flight: which (-1: none), for how long since the
    last event (s), how long it stays in reach (s), and its spin, which no flight changes."""

    def __init__(self, integrator: Any, states: Array, log: Log) -> None:
        self.integrator, self.log = integrator, log
        self.now = integrator.state
        self.waiting = iter(enumerate(states))
        self.shot = [-1] * LANES
        self.flying = [0.0] * LANES
        self.left = [0.0] * LANES
        self.spin = np.zeros((LANES, 3))
        for lane in range(LANES):
            self._next_shot(lane)

    def _start(self, lane: int, state: Array) -> None:
        self.now[:, lane], self.spin[lane] = state[:6], state[6:]
        self.integrator.pars[SPIN:, lane] = state[6 : 6 + len(self.integrator.pars[SPIN:])]
        self.flying[lane], self.left[lane] = 0.0, time_in_reach(state, self.log.scene)

    def _next_shot(self, lane: int) -> None:
        """Return the next waiting shot; an empty lane stands still."""
        self.shot[lane], state = next(self.waiting, (-1, None))
        self.left[lane] = 0.0
        if state is not None:
            self._start(lane, state)
            self.integrator.reset_cooldowns(lane)

    def step(self) -> None:
        """Fly all to their next events, or as far as the integrator steps at once."""
        self.integrator.step(self.left)
        for lane, (outcome, step) in enumerate(self.integrator.step_res):
            if self.shot[lane] >= 0:
                self.flying[lane] += step
                self.left[lane] -= step
                self._follow(lane, -int(outcome) - 1)

    def _follow(self, lane: int, surface: int) -> None:
        event = None
        if surface in SURFACES:
            state = np.concatenate([self.now[:, lane], self.spin[lane]])
            if inside_bounds(self.log.scene, surface, state):
                event = Event(surface, self.flying[lane], state)
        if event is None and self.left[lane] > 0:
            return  # past the edge of a plane, or in mid-air
        after = self.log.after(self.shot[lane], event)
        if after is None:
            self._next_shot(lane)
        else:
            self._start(lane, after)


def heyoka_events(
    states: Array, parameters: Scene, max_contacts: int = 40, record: bool = False
) -> Flown:
    """Fly by heyoka.py; bounds are looked at after the event, and where a shot has ended the next
    takes its lane."""
    states = np.atleast_2d(states)
    log = Log(len(states), parameters, max_contacts, record)
    forces = air(parameters)
    integrator = _integrator(forces is not None)
    places = (
        parameters["ring_radius"],
        contact_radius(parameters),
        parameters["ball_radius"] - parameters["board_distance"],
        parameters["end_depth"],
        *(forces or (parameters["gravity"],)),
    )
    integrator.pars[: len(places)] = np.array(places)[:, None]
    integrator.set_time(0.0)
    lanes = _Lanes(integrator, states, log)
    while max(lanes.shot) >= 0:
        lanes.step()
    return log.flown
