"""Flights past the ring: hits, grazes, bounces off the rim; how far single precision gets."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from types import ModuleType

import numpy as np
from mpmath import mp, mpf
from numpy.typing import NDArray

from hoopgen import PAPER

Floats = NDArray[np.float64]
Columns = dict[str, Floats]

STATE = ("x", "y", "z", "vx", "vy", "vz")
KINDS = 6
"""Kinds of flights, which take turns: free throws, grazes, vertical ones, shots that rise through
the ring's level, bounces off the rim, rolls about it."""
LATEST = 1.5
"""No event later than this is wanted, s."""
DIGITS = 50


def flights(seed: int, rows: int, parameters: Mapping[str, Floats | float]) -> Columns:
    """Return flights that come to the ring's wire, or near to it, or begin there.

    A place on the torus is drawn, a normal and a tangential velocity there, and how far off the
    torus it passes; then the flight is drawn backwards, or begins there where it leaves.
    """
    rng = np.random.default_rng(seed)
    kind = np.arange(rows) % KINDS
    leaving = kind >= 4
    about, around = rng.uniform(0, 2 * np.pi, (2, rows))
    # Balls come from above more often, and roll about the inner side.
    about = np.where(rng.random(rows) < 0.6, rng.uniform(0.2, 3.0, rows), about)
    normal = np.stack(
        [np.cos(about) * np.cos(around), np.cos(about) * np.sin(around), np.sin(about)]
    )
    along = np.stack([-np.sin(around), np.cos(around), 0 * around])
    across = np.cross(normal, along, axis=0)
    speeds = 10 ** rng.uniform(-3, 1, (2, rows)) * rng.choice([-1, 1], (2, rows))
    toward = np.where(kind == 1, 10 ** rng.uniform(-9, -1, rows), 10 ** rng.uniform(-3, 1, rows))
    away = np.where(leaving, 10 ** rng.uniform(-8, 0.6, rows), -toward)
    velocity = away * normal + speeds[0] * along + speeds[1] * across
    velocity[:2, kind == 2] = 0
    velocity[:2, (kind == 2) & (np.arange(rows) % 12 < 6)] = 1e-10
    velocity[2, kind == 3] = np.abs(velocity[2, kind == 3])
    reach, radius = (
        _of(parameters, "ball_radius") + _of(parameters, "wire_radius"),
        parameters["ring_radius"],
    )
    off = np.where(kind == 1, 10 ** rng.uniform(-12, -3, rows) * rng.choice([-1, 1], rows), 0.0)
    place = (reach + off) * normal + radius * np.stack([np.cos(around), np.sin(around), 0 * around])
    time = np.where(leaving, 0.0, 10 ** rng.uniform(-2, 0, rows))
    gravity = _of(parameters, "gravity")
    place -= velocity * time
    place[2] -= gravity * time**2 / 2
    velocity[2] += gravity * time
    columns = dict(zip(STATE, (*place, *velocity), strict=True))
    columns |= {"leaving": leaving.astype(float), "horizon": np.full(rows, LATEST)}
    columns["extent"] = np.abs(place).sum(axis=0)
    columns["speed"] = np.abs(velocity).sum(axis=0)
    return columns


def _of(parameters: Mapping[str, Floats | float], name: str) -> Floats:
    return np.asarray(parameters[name], np.float64)


def call(kernels: ModuleType, name: str, columns: Mapping[str, Floats | float]) -> Columns:
    """Return the outputs of a kernel of NumPy, by name, as doubles."""
    public = {own: name for name, own in kernels.VARIABLES.items()}
    given = [columns[public.get(a, a)] for a in kernels.ARGUMENTS[name]]
    rows = len(columns["x"])  # type: ignore[arg-type]
    with np.errstate(all="ignore"):
        found = getattr(kernels, name)(*given)
    doubles = (np.broadcast_to(np.asarray(one, np.float64), (rows,)).copy() for one in found)
    return dict(zip(kernels.OUTPUTS[name], doubles, strict=True))


def begun(kernels: ModuleType, columns: Mapping[str, Floats | float]) -> Columns:
    """Return what a search in single precision is given, as the event loop gives it.

    Besides, `since`, when its flight begins, and whether it is `single_precision`.
    """
    opened = call(kernels, "ring_opened", columns)
    since = opened["t"]
    there = call(kernels, "flight", {**columns, "t": since})
    begins = call(kernels, "ring_started", columns)
    place = {name: there[name] for name in STATE}
    given = {**columns, **opened, **begins, **place, "horizon": opened["latest"]}
    grain = call(kernels, "ring_resolution", given)
    served = opened["searching"] * opened["representable"] * grain["fits"]
    return grain | {"since": since, "single_precision": served, "searching": opened["searching"]}


def leap(kernels: ModuleType, given: Columns, turns: int) -> tuple[Columns, list[Floats]]:
    """Return where searches come to in so many steps, and on their ways where they were."""
    now = dict(given)
    going, way = now["single_precision"] > 0, []
    certain = np.zeros(len(going))
    for _ in range(turns):
        way.append(np.where(going, now["t"], np.nan))
        next_ = call(kernels, "ring_step", now)
        for name in ("t", "end"):
            now[name] = np.where(going, next_[name], now[name])
        certain = np.where(going, next_["certain"], certain)
        going = going & (next_["stepping"] > 0)
    return now | {"certain": certain}, way


# What is true of them


def gap(shots: Columns, t: Floats) -> Floats:
    """Return F at times, in doubles; of a flight that begins on the ring F/t times t."""
    x, y, z, vx, vy, vz = (shots[name] for name in STATE)
    radius, reach = shots["ring_radius"], shots["ball_radius"] + shots["wire_radius"]
    upward = vz - shots["gravity"] * t / 2
    rho, start = np.hypot(x + vx * t, y + vy * t), np.hypot(x, y)
    outward = 2 * (x * vx + y * vy) + (vx**2 + vy**2) * t
    inward = (rho - radius) + (start - radius)
    with np.errstate(invalid="ignore"):  # on the axis, where no ball leaves the ring
        since = t * (outward * inward / (rho + start) + upward * (2 * z + upward * t))
    return np.where(
        shots["leaving"] > 0, since, (rho - radius) ** 2 + (z + upward * t) ** 2 - reach**2
    )


def exact_gap(shots: Columns, row: int, t: mpf) -> tuple[mpf, mpf]:
    """Return F and F'; F of a flight that begins on the ring less what it is there."""
    x, y, z, vx, vy, vz = (mpf(float(shots[name][row])) for name in STATE)
    names = ("ring_radius", "ball_radius", "wire_radius", "gravity")
    radius, ball, wire, gravity = (mpf(float(shots[name][row])) for name in names)
    px, py, pz = x + vx * t, y + vy * t, z + vz * t - gravity * t**2 / 2
    rho = mp.sqrt(px**2 + py**2)
    rate = 2 * ((rho - radius) * (px * vx + py * vy) / rho + pz * (vz - gravity * t))
    if shots["leaving"][row]:
        start = (mp.sqrt(x**2 + y**2) - radius) ** 2 + z**2
    else:
        start = (ball + wire) ** 2
    return (rho - radius) ** 2 + pz**2 - start, rate


def first_roots(shots: Columns) -> Floats:
    """Return when F is first zero, to 1e-9 of that, or infinity: no later than `LATEST`."""
    grid = np.concatenate([np.geomspace(1e-12, 1e-3, 250)[:-1], np.linspace(1e-3, LATEST, 1500)])
    values = gap(shots, grid[:, None])
    # Minima between three times of the grid, of which it would not see two roots.
    low = (values[1:-1] > 0) & (values[1:-1] <= values[:-2]) & (values[1:-1] <= values[2:])
    at, who = np.nonzero(low)
    left, right = grid[at], grid[at + 2]
    picked = {name: column[who] for name, column in shots.items()}
    for _ in range(60):
        third = (right - left) / 3
        lower = gap(picked, left + third) < gap(picked, right - third)
        left, right = np.where(lower, left, left + third), np.where(lower, right - third, right)
    dips, least = (left + right) / 2, gap(picked, (left + right) / 2)
    with mp.workdps(DIGITS):
        for k in np.flatnonzero(np.abs(least) < 1e-13):
            least[k] = float(exact_gap(shots, int(who[k]), mpf(float(dips[k])))[0])
    after = np.where((values <= 0).any(axis=0), np.argmax(values <= 0, axis=0), len(grid))
    ends = np.append(grid, np.inf)[after]
    starts = np.append(0.0, grid)[after]
    for k in np.argsort(-dips):
        if least[k] <= 0 and dips[k] < ends[who[k]]:
            ends[who[k]], starts[who[k]] = dips[k], grid[at[k]]
    for _ in range(60):
        middle = (starts + ends) / 2
        below = gap(shots, middle) <= 0
        starts, ends = np.where(below, starts, middle), np.where(below, middle, ends)
    return ends


@cache
def known(seed: int, rows: int) -> tuple[Columns, Floats]:
    """Return flights about the article's hoop, and when they first meet the ring."""
    parameters = {name: np.full(rows, value) for name, value in PAPER.items()}
    shots = flights(seed, rows, PAPER) | parameters
    outside = (gap(shots, np.zeros(rows)) > 0) | (shots["leaving"] > 0)
    shots = {name: column[outside] for name, column in shots.items()}
    return shots, first_roots(shots)


def _error_sizes(kernels: ModuleType, shots: Columns, rng: np.random.Generator) -> list[Floats]:
    """Return sizes of the errors of place and velocity that a search just allows for.

    Some are errors of the place alone, some of the velocity alone.
    """
    rows = len(shots["x"])
    first = begun(kernels, shots)
    latest = call(kernels, "ring_opened", shots)["latest"]
    fastest = shots["speed"] + shots["gravity"] * latest
    furthest = shots["extent"] + latest * fastest
    part = np.clip(rng.uniform(-0.5, 1.5, rows), 0.0, 1.0)
    sizes = part * furthest, (1 - part) * np.maximum(fastest, furthest)
    low, high = np.zeros(rows), np.ones(rows)
    for _ in range(50):
        middle = (low + high) / 2
        names = ("position_error", "velocity_error")
        errors = {name: middle * size for name, size in zip(names, sizes, strict=True)}
        given = {**shots, **errors, "horizon": latest, "share": first["share"]}
        over = call(kernels, "ring_coarse_excess", given)["excess"] > 0
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    return [low * size for size in sizes]


def erring(kernels: ModuleType, shots: Columns, roots: Floats, seed: int) -> Columns:
    """Return the flights as they are known: off by all that a search allows for.

    Half of them are moved and turned away from the ring, so that steps become too long.
    """
    rng = np.random.default_rng((seed, 4))
    sizes = _error_sizes(kernels, shots, rng)
    when = np.where(np.isfinite(roots), roots, 0.0)
    x, y = (shots[name] + shots["v" + name] * when for name in "xy")
    z = shots["z"] + (shots["vz"] - shots["gravity"] * when / 2) * when
    rho = np.hypot(x, y)
    inward = rho - shots["ring_radius"]
    away = np.sign([x * inward, y * inward, z])
    signs = np.where(rng.random(len(x)) < 0.5, away, rng.choice([-1.0, 1.0], (3, len(x))))
    off = [0.99 * size * signs for size in sizes]
    return shots | {n: shots[n] + by for n, by in zip(STATE, (*off[0], *off[1]), strict=True)}


def complaints(kernels: ModuleType, turns: int, seed: int = 1, rows: int = 4000) -> list[str]:
    """Return what a search in single precision does that it must not.

    It passes the first root, or is certain of one and Newton's method does not come to it.
    """
    shots, roots = known(seed, rows)
    seen = erring(kernels, shots, roots, seed)
    given = seen | begun(kernels, seen)
    found, _ = leap(kernels, given, turns)
    came = given["since"] + found["t"]
    served = given["single_precision"] > 0
    with np.errstate(invalid="ignore"):
        near = np.abs(came - roots) < 1e-6 * roots  # known better by F itself
    said = [
        f"{row}: at {came[row]!r}, past the root at {roots[row]!r}"
        for row in np.flatnonzero(served & (came > roots) & ~near)
    ]
    said += [
        f"{row}: a root at {roots[row]!r} in no window"
        for row in np.flatnonzero((given["searching"] == 0) & (roots < LATEST))
    ]
    with mp.workdps(DIGITS):
        for row in map(int, np.flatnonzero(served & near)):
            if exact_gap(shots, row, mpf(float(came[row])))[0] <= 0:
                said.append(f"{row}: at {came[row]!r}, past the root at {roots[row]!r}")
        for row in map(int, np.flatnonzero(served & (found["certain"] > 0))):
            said += _of_newton(shots, row, float(came[row]), float(roots[row]))
    return said


def _of_newton(shots: Columns, row: int, begins: float, root: float) -> list[str]:
    """Return complaints about where Newton's method comes to."""
    value, rate = exact_gap(shots, row, mpf(begins))
    if value <= 0 or rate >= 0:
        return [f"{row}: certain at {begins!r}, where F = {mp.nstr(value)}, F' = {mp.nstr(rate)}"]
    t = _newton(shots, row, mpf(begins))
    if not exact_gap(shots, row, t)[1] < 0:
        return [f"{row}: Newton's method does not converge from {begins!r}"]
    if t > LATEST and root == np.inf:
        return []
    if root == np.inf or not abs(t - _newton(shots, row, mpf(root))) < mpf(10) ** -20 * t:
        return [f"{row}: certain of {float(t)!r}, and not of {root!r}"]
    return []


def _newton(shots: Columns, row: int, t: mpf) -> mpf:
    """Return the root that Newton's method comes to in eight steps, NaN if it does not."""
    for _ in range(8):
        value, rate = exact_gap(shots, row, t)
        if rate == 0:
            break
        t -= value / rate
        if abs(value / rate) < mpf(10) ** -22 * t:
            return t
    return mp.nan
