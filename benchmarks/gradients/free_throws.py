"""Free throws of some contacts in `HOOP`: errors of derivatives, against 70-digit differences.

The derivatives are those of the state at the end, by vx and vz of the release. An error is the
largest one of the entries, divided by the largest entry.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from hoopgen.core.event_log import Event
from hoopgen.core.variables import STATE
from tests.helpers.precise_path import PreciseScene

Floats = NDArray[np.float64]

CONTACTS = (1, 2, 3, 5, 9)
NAMES = ("vx", "vz")
STEPS = tuple(10.0**-k for k in range(4, 13))
"""Steps of differences (m/s); the one that happens to be the best is the one that is reported."""
END = 3
"""Number of the end among the surfaces, after ring, backboard and bridge."""
MODEL = hoopgen.HOOP.parameters


@dataclass(frozen=True)
class Throw:
    """A free throw: its release, the surfaces that it meets, and the truth, (9, 2)."""

    contacts: int
    state: Floats
    surfaces: tuple[int, ...]
    truth: Floats


def releases(n: int = 4000) -> Floats:
    """Return free throws with backspin that scatter about the ring, always the same."""
    random = np.random.default_rng(7)
    return hoopgen.release(
        random.normal(7.2, 0.15, n),
        random.normal(0.9, 0.05, n),
        random.normal(0, 0.03, n),
        backspin=random.normal(15, 5, n),
        height=2.1336,
        distance=4.191,
    )


def truth(state: Floats) -> tuple[Floats, tuple[int, ...]]:
    """Return the derivatives at the end to 70 digits, (9, 2), and the surfaces that were met."""
    engine = hoopgen.HOOP
    shot = hoopgen.simulate(state, record=True)
    precise = PreciseScene(engine.scene)
    inputs = list(map(float, engine.table.inputs(dict(engine.parameters))))
    events = []
    for event in shot.events:
        body = None if event["kind"] == Event.END else engine.scene.bodies[event["surface"]]
        faces = engine.scene.end_planes if body is None else body.faces
        place = list(event["before"][:3])
        gaps = [abs(precise.gap(face, place, inputs)) for face in faces]
        law = None if body is None else body.law
        events.append((faces[gaps.index(min(gaps))], law, float(event["time"])))
    zeros = [0.0] * len(inputs)
    changes = {name: [*(float(name == one) for one in STATE), *zeros] for name in NAMES}
    found = precise.derivatives(state, inputs, events, changes)[-1]
    return found[9:18], tuple(int(surface) for surface in shot.events["surface"][:-1])


@cache
def throws(each: int = 3, contacts: Sequence[int] = CONTACTS) -> tuple[Throw, ...]:
    """Return the first shots of each number of contacts that have derivatives, `each` at most."""
    states = releases()
    shots = hoopgen.simulate(states, derivatives=NAMES)
    found = []
    for count in contacts:
        rows = np.flatnonzero((shots.contacts == count) & shots.differentiable)[:each]
        for row in rows:
            right, surfaces = truth(states[row])
            found.append(Throw(count, states[row], surfaces, right))
    return tuple(found)


def error(found: Floats, right: Floats) -> float:
    """Return the largest error as a share of the largest derivative."""
    return float(np.abs(found - right).max() / np.abs(right).max())


def by_hoopgen(throw: Throw) -> Floats:
    """Return hoopgen's derivatives, (9, 2)."""
    shots = hoopgen.simulate(throw.state, derivatives=NAMES)
    return np.asarray(shots.jacobian["state"][0])


def by_differences(throw: Throw) -> Floats:
    """Return central differences of hoopgen's ends, with the step that has the smallest error."""
    columns = [STATE.index(name) for name in NAMES]
    tried = []
    for step in STEPS:
        moved = np.repeat(throw.state[None], 4, axis=0)
        for row, column in enumerate(columns):
            moved[2 * row, column] += step
            moved[2 * row + 1, column] -= step
        ends = hoopgen.simulate(moved).state
        widths = [moved[2 * k, c] - moved[2 * k + 1, c] for k, c in enumerate(columns)]
        slopes = [(ends[2 * k] - ends[2 * k + 1]) / widths[k] for k in range(len(columns))]
        tried.append(np.array(slopes).T)
    return min(tried, key=lambda found: error(found, throw.truth))


APART = 1e-3
"""Time (s) that diffrax flies before it looks for a contact: at 0 its event would trigger."""


@cache
def _diffrax_slopes() -> Callable[..., Any]:
    """Return the compiled derivatives of a shot that meets given surfaces of `HOOP` in order."""
    import diffrax
    import jax
    import optimistix

    jax.config.update("jax_enable_x64", True)
    jnp = jax.numpy
    ball, ring = MODEL["ball_radius"], MODEL["ring_radius"]
    wide = ball + MODEL["wire_radius"]
    distances = (
        lambda y: jnp.hypot(jnp.hypot(y[0], y[1]) - ring, y[2]) - wide,
        lambda y: y[0] - (ball - MODEL["board_distance"]),
        lambda y: y[2] - wide,
        lambda y: y[2] + MODEL["end_depth"],
    )
    falling = diffrax.ODETerm(
        lambda t, y, args: jnp.concatenate([y[3:], jnp.array([0.0, 0.0, -MODEL["gravity"]])])
    )

    def fly(y: Any, surface: Any, event: Any, until: float) -> Any:
        solved = diffrax.diffeqsolve(
            falling,
            diffrax.Tsit5(),
            0.0,
            until,
            1e-3,
            y,
            surface,
            event=event,
            stepsize_controller=diffrax.PIDController(rtol=1e-11, atol=1e-13, dtmax=1e-2),
            adjoint=diffrax.ForwardMode(),
        )
        return solved.ys[-1]

    def distance(y: Any, surface: Any) -> Any:
        return jax.lax.switch(surface, distances, y)

    event = diffrax.Event(
        lambda t, y, args, **_: distance(y, args), optimistix.Newton(1e-13, 1e-13), False
    )

    def step(state: Any, surface: Any) -> Any:
        after = fly(fly(state[:6], surface, None, APART), surface, event, 5.0)
        normal = jax.grad(distance)(after, surface)[:3]
        v, spin = after[3:], state[6:]
        away, about = v @ normal, spin @ normal
        # The ball leaves without slip: a thin shell keeps 3/5 of the velocity and 2/5 of the spin.
        along = (3 * (v - away * normal) + 2 * ball * jnp.cross(spin, normal)) / 5
        velocity = along - MODEL["restitution"] * away * normal
        turned = jnp.cross(normal, along) / ball + about * normal
        left = jnp.concatenate([after[:3], velocity, turned])
        return jnp.where(surface == END, jnp.concatenate([after, spin]), left)

    def end(speeds: Any, state: Any, surfaces: Any, count: Any) -> Any:
        start = state.at[jnp.array([3, 5])].set(speeds)
        return jax.lax.fori_loop(0, count, lambda k, now: step(now, surfaces[k]), start)

    return jax.jit(jax.jacfwd(end))


def by_diffrax(throw: Throw) -> Floats:
    """Return the derivatives of diffrax, whose program is told the sequence of contacts, (9, 2)."""
    surfaces = np.full(max(CONTACTS) + 1, END)
    surfaces[: throw.contacts] = throw.surfaces
    slopes = _diffrax_slopes()(throw.state[[3, 5]], throw.state, surfaces, throw.contacts + 1)
    found = np.array(slopes)
    if not np.isfinite(found).all():
        raise ArithmeticError("diffrax: the derivative is not finite")
    return found
