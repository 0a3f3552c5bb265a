"""The bouncing ball in other programs, each as its manual recommends; derivatives by the height.

A peer returns for each time the derivative of the ball's height by the height of the release.
Packages are imported where they are used: those that are not installed are left out.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from importlib.util import find_spec
from typing import Any

import numpy as np

from benchmarks.gradients.ball import BALL, Ball

WIDE = 0.03
"""Step (m) of the differences that are wide enough to see past the time steps."""


@dataclass(frozen=True)
class Peer:
    """A program and a way to use it.

    Attributes
    ----------
    prepare
        Function of the ball and a time (s) to a function without arguments, which returns the
        derivative; what is compiled once is compiled before that is called again.
    limits
        What it cannot do, or needs, in a sentence.
    """

    key: str
    label: str
    package: str
    prepare: Callable[[Ball, float], Callable[[], float]]
    limits: str


def _heyoka(by_hand: bool, ball: Ball, time: float) -> Callable[[], float]:
    import heyoka as hy

    z, v = hy.make_vars("z", "v")
    system = hy.var_ode_sys([(z, v), (v, 0.0 * z - ball.gravity)], hy.var_args.vars, order=1)

    def bounce(integrator: Any, direction: int) -> bool:
        state = integrator.state
        if by_hand:  # the saltation matrix of a plane, on the rows of z and v
            before = state[1]
            for column in (2, 3):
                place, speed = state[column], state[column + 2]
                later = -place / before
                speed -= ball.gravity * later
                state[column] = ball.restitution * before * later
                state[column + 2] = -ball.restitution * speed + ball.gravity * later
        state[1] = -ball.restitution * state[1]
        return True

    event = hy.t_event(z - ball.radius, callback=bounce, direction=hy.event_direction.negative)
    integrator = hy.taylor_adaptive(system, [ball.height + ball.radius, 0.0], t_events=[event])
    start = integrator.state.copy()

    def call() -> float:
        integrator.time = 0.0
        integrator.state[:] = start
        integrator.reset_cooldowns()
        integrator.propagate_until(time)
        return float(integrator.state[2])

    return call


@cache
def _diffrax_slope(root_finder: bool, ball: Ball, contacts: int) -> Callable[[float, float], Any]:
    import diffrax
    import jax
    import optimistix

    jax.config.update("jax_enable_x64", True)
    jnp = jax.numpy
    finder = optimistix.Newton(1e-12, 1e-12) if root_finder else None
    event = diffrax.Event(lambda t, y, args, **_: y[0] - ball.radius, finder)
    falling = diffrax.ODETerm(lambda t, y, args: jnp.array([y[1], -ball.gravity]))
    steps = diffrax.PIDController(rtol=1e-10, atol=1e-12)

    def solve(t0: Any, y0: Any, until: Any, event: Any) -> Any:
        return diffrax.diffeqsolve(
            falling,
            diffrax.Tsit5(),
            t0,
            until,
            1e-2,
            y0,
            event=event,
            stepsize_controller=steps if root_finder else diffrax.ConstantStepSize(),
            adjoint=diffrax.ForwardMode(),
            max_steps=4096,
        )

    def height(start: Any, until: Any) -> Any:
        t, y = jnp.asarray(0.0), jnp.array([start, 0.0])
        for _ in range(contacts):
            flight = solve(t, y, until, event)
            t = flight.ts[-1]
            # A hair above the floor: an event function that starts at 0 may trigger at once.
            y = jnp.array([ball.radius + 1e-15, -ball.restitution * flight.ys[-1, 1]])
        return solve(t, y, until, None).ys[-1, 0]

    return jax.jit(jax.jacfwd(height))


def _diffrax(root_finder: bool, ball: Ball, time: float) -> Callable[[], float]:
    slope = _diffrax_slope(root_finder, ball, ball.truth(time)[2])
    return lambda: float(slope(ball.height + ball.radius, time))


def _warp(ball: Ball, time: float) -> Callable[[], float]:
    import warp as wp

    wp.config.quiet = True
    wp.init()
    from benchmarks.gradients.warp_steps import advance

    steps = round(time / ball.step)
    states = [
        wp.zeros(2, dtype=wp.float64, requires_grad=True, device="cpu") for _ in range(steps + 1)
    ]
    seed = wp.array([1.0, 0.0], dtype=wp.float64, device="cpu")
    states[0].assign(np.array([ball.height + ball.radius, 0.0]))
    tape = wp.Tape()
    inputs = [ball.radius, ball.restitution, ball.gravity, ball.step]
    with tape:
        for old, new in itertools.pairwise(states):
            wp.launch(advance, 1, [old, new, *map(wp.float64, inputs)], device="cpu")

    def call() -> float:
        tape.zero()
        for old, new in itertools.pairwise(states):
            wp.launch(advance, 1, [old, new, *map(wp.float64, inputs)], device="cpu")
        tape.backward(grads={states[-1]: seed})
        return float(states[0].grad.numpy()[0])

    return call


@cache
def mujoco_model(ball: Ball) -> Any:
    """Return MuJoCo's model of the ball; its damping gives the restitution of the first bounce."""
    import mujoco

    def model(damping: float) -> Any:
        contact = f'solref="{-ball.stiffness} {-damping}"'
        return mujoco.MjModel.from_xml_string(
            f"""<mujoco><option timestep="{ball.step}" gravity="0 0 {-ball.gravity}"/><worldbody>
            <geom type="plane" size="9 9 .1" {contact}/><body pos="0 0 0">
            <joint type="slide" axis="0 0 1"/><geom type="sphere" size="{ball.radius}" mass="1"
            {contact}/></body></worldbody></mujoco>"""
        )

    def excess(damping: float) -> float:
        made = model(damping)
        data, apex = mujoco.MjData(made), 0.0
        data.qpos[0] = ball.height + ball.radius
        while data.time < 1.1:
            mujoco.mj_step(made, data)
            if data.time > 0.6:
                apex = max(apex, float(data.qpos[0]))
        return apex - ball.radius - ball.restitution**2 * ball.height

    if ball.restitution == 1:
        return model(0.0)
    low, high = 0.0, 60.0
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if excess(middle) > 0 else (low, middle)
    return model(low)


def mujoco_extremes(ball: Ball, time: float) -> tuple[float, float]:
    """Return the least height of MuJoCo's ball until a time (s), and the greatest after it (m)."""
    import mujoco

    model = mujoco_model(ball)
    data = mujoco.MjData(model)
    data.qpos[0] = ball.height + ball.radius
    heights = []
    for _ in range(round(time / ball.step)):
        mujoco.mj_step(model, data)
        heights.append(float(data.qpos[0]))
    lowest = min(heights)
    return lowest, max(heights[heights.index(lowest) :])


def _mujoco(ball: Ball, time: float) -> Callable[[], float]:
    import mujoco

    model = mujoco_model(ball)
    data = mujoco.MjData(model)
    step = np.zeros((2, 2))

    def call() -> float:
        mujoco.mj_resetData(model, data)
        data.qpos[0] = ball.height + ball.radius
        total = np.eye(2)
        for _ in range(round(time / ball.step)):
            mujoco.mjd_transitionFD(model, data, 1e-6, True, step, None, None, None)
            total = step @ total
            mujoco.mj_step(model, data)
        return float(total[0, 0])

    return call


def _mujoco_wide(ball: Ball, time: float) -> Callable[[], float]:
    import mujoco

    model = mujoco_model(ball)
    data = mujoco.MjData(model)

    def height(start: float) -> float:
        mujoco.mj_resetData(model, data)
        data.qpos[0] = start
        for _ in range(round(time / ball.step)):
            mujoco.mj_step(model, data)
        return float(data.qpos[0])

    middle = ball.height + ball.radius
    return lambda: (height(middle + WIDE) - height(middle - WIDE)) / (2 * WIDE)


@cache
def _mjx_slope(ball: Ball) -> Callable[[float, int], Any]:
    import jax
    from mujoco import mjx

    jax.config.update("jax_enable_x64", True)
    model = mjx.put_model(mujoco_model(ball))
    data = mjx.make_data(model)

    def height(start: Any, steps: Any) -> Any:
        own = data.replace(qpos=data.qpos.at[0].set(start))
        return jax.lax.fori_loop(0, steps, lambda _, d: mjx.step(model, d), own).qpos[0]

    return jax.jit(jax.jacfwd(height))


def _mjx(ball: Ball, time: float) -> Callable[[], float]:
    slope = _mjx_slope(ball)
    return lambda: float(slope(ball.height + ball.radius, round(time / ball.step)))


EVERYBODY = (
    Peer(
        "heyoka_jump",
        "heyoka.py, variational equations, jump by hand",
        "heyoka",
        partial(_heyoka, True),
        "The jump of the variations at a contact must be derived and written by its user.",
    ),
    Peer(
        "heyoka",
        "heyoka.py, variational equations, callback sets v",
        "heyoka",
        partial(_heyoka, False),
        "The variations go through the event unchanged, without a warning.",
    ),
    Peer(
        "diffrax",
        "diffrax, segments, event with a root finder",
        "diffrax",
        partial(_diffrax, True),
        "Its user writes the segments and the contact law; here it is told the contacts.",
    ),
    Peer(
        "diffrax_steps",
        "diffrax, segments, event without a root finder",
        "diffrax",
        partial(_diffrax, False),
        "The flight ends at a step, whose time does not depend on the release.",
    ),
    Peer(
        "warp",
        "Warp, tape over time steps",
        "warp",
        _warp,
        "The step of a contact does not depend on the release, unless its user divides it at the "
        "time of impact.",
    ),
    Peer(
        "mujoco",
        "MuJoCo, mjd_transitionFD, product over steps",
        "mujoco",
        _mujoco,
        "Contacts are soft: a spring and a damper over many steps.",
    ),
    Peer(
        "mujoco_wide",
        "MuJoCo, difference over 0.03 m to either side",
        "mujoco",
        _mujoco_wide,
        "The step must be found by trial, and lies far above the usual ones.",
    ),
    Peer(
        "mjx",
        "MJX, forward mode over steps",
        "mujoco.mjx",
        _mjx,
        "Contacts are soft; reverse mode does not go through the loop of its solver, which must "
        "then have one iteration.",
    ),
)


def _installed(package: str) -> bool:
    try:
        return find_spec(package) is not None
    except ModuleNotFoundError:
        return False


def taking_part(
    peers: Sequence[Peer] = EVERYBODY, find: Callable[[str], bool] = _installed
) -> tuple[tuple[Peer, ...], tuple[str, ...]]:
    """Return the peers whose packages are installed, and a line on each of the others."""
    there = tuple(peer for peer in peers if find(peer.package))
    absent = dict.fromkeys(peer.package for peer in peers if peer not in there)
    return there, tuple(f"{package}: absent, it is not installed here" for package in absent)


def slope(peer: Peer, time: float, ball: Ball = BALL) -> float:
    """Return a peer's derivative at a time (s)."""
    return peer.prepare(ball, time)()
