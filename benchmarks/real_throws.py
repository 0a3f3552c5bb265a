"""Real free throws as the model simulates them, for the numbers of `benchmarks.real_shots`.

They are those of a copy of SPL-Open-Data of Maple Leaf Sports & Entertainment (CC BY-NC-SA 4.0),
which is not part of hoopgen: `git clone https://github.com/mlsedigital/SPL-Open-Data.git`. Nothing
of the data is kept.

Of each throw the data give the place and the angle at which the ball comes down through the plane
of the ring, and its result. The track of the ball ends near the hand. With the place where the ball
leaves the hand these determine a parabola: with the horizontal way L and the rise h to the plane,
and the slope m = tan(entry), the slope at release is 2 h / L + m, and the square of the horizontal
speed g L / (2 h / L + 2 m).
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from hoopgen import COURT, NBA, NBA_COURT, NBA_COURT_AIR
from hoopgen.core.units import DEGREE, FOOT, INCH, TURN
from hoopgen.hoop.aiming import aimed
from hoopgen.hoop.flights import Flights
from hoopgen.text.numbers import MINUS

Floats = NDArray[np.float64]

RING = 41.75 * FOOT
"""Distance of the ring's centre from the middle of an NBA court, m."""

HAND = 0.45 * FOOT
"""The ball is in the hand while its centre is so near to the base of the thumb."""

ERRORS = {"landing": 0.5 * INCH, "entry": 1.0 * DEGREE, "release": 2.0 * INCH}
"""Standard errors that are assumed of the data, which say none."""

BACKSPIN = 2.0 * TURN
DRAWS = 400
RESTITUTIONS = np.arange(0.30, 0.951, 0.025)


@dataclass(frozen=True)
class Throws:
    """Throws of a folder, in hoopgen's axes.

    Attributes
    ----------
    release
        Where the ball leaves the hand, (n, 3), m.
    landing
        Where its centre comes through the plane of the ring, x and y, (n, 2), m.
    entry
        Angle below the horizontal there, (n,), rad.
    made
        (n,).
    fall
        Vertical acceleration of the frames after the hand, (n,), m/s²; NaN of fewer than five.
    times, frames
        The frames from the release on, by throw, s and m, padded with NaN, (n, m) and (n, m, 3).
    """

    release: Floats
    landing: Floats
    entry: Floats
    made: NDArray[np.bool_]
    fall: Floats
    times: Floats
    frames: Floats


def read(folder: Path) -> Throws:
    """Return the throws of a copy of the data."""
    files = sorted(folder.glob("**/BB_FT_P*_T*.json"))
    if not files:
        raise SystemExit(f"{folder}: no files BB_FT_P…_T….json; give a copy of SPL-Open-Data")
    release, landing, entry, made, fall = [], [], [], [], []
    times, frames = [], []
    for file in files:
        trial = json.loads(file.read_text(encoding="utf-8"))
        seen = [one["data"] for one in trial["tracking"]]
        ball = np.array([data["ball"] for data in seen], dtype=np.float64) * FOOT
        finger = [data["player"]["R_1STFINGER"] for data in seen]
        hand = np.array(finger, dtype=np.float64) * FOOT
        near = np.linalg.norm(ball - hand, axis=1) < HAND
        held = np.flatnonzero(near & (ball[:, 2] > 5.5 * FOOT))
        if not len(held):
            continue
        x, y, z = ball[held[-1]]
        release.append((RING - x, -y, z - 10.0 * FOOT))
        landing.append((NBA["ring_radius"] - trial["landing_y"] * INCH, trial["landing_x"] * INCH))
        entry.append(trial["entry_angle"] * DEGREE)
        made.append(trial["result"] == "made")
        times.append([0.001 * one["time"] for one in trial["tracking"][held[-1] :]])
        frames.append(np.array([RING, 0.0, -10.0 * FOOT]) + ball[held[-1] :] * [-1.0, -1.0, 1.0])
        after = np.arange(len(ball)) > held[-1] + 1
        after &= np.isfinite(ball).all(axis=1)
        time = np.array([one["time"] for one in trial["tracking"]])[after] / 1000.0
        height = ball[after, 2]
        bend = np.polyfit(time - time[0], height, 2)[0] if len(time) >= 5 else np.nan
        fall.append(2.0 * bend)
    most = max(map(len, times))
    clock, path = np.full((len(times), most), np.nan), np.full((len(times), most, 3), np.nan)
    for row, (t, x) in enumerate(zip(times, frames, strict=True)):
        clock[row, : len(t)], path[row, : len(t)] = t, x
    return Throws(
        np.array(release),
        np.array(landing),
        np.array(entry),
        np.array(made),
        np.array(fall),
        clock,
        path,
    )


def fitted(throws: Throws) -> tuple[int, int, int, float, float]:
    """Return the results of fits of the tracks at the ring's height, where they come down to it.

    The releases are found by `hoopgen.fit_release`.

    Returns
    -------
    tuple
        The number of credible fits, of those that come down, and of these the number within 4 in
        of the measured place; the median distance from it, m; and the median speed, m/s.
    """
    found = hoopgen.fit_release(throws.times, throws.frames, parameters=NBA, release_time="detect")
    _, end = hoopgen.HOOP.fall(found.states, 0.0, {**hoopgen.HOOP.parameters, **NBA})
    off = np.hypot(*(end[:, :2] - throws.landing).T)
    good = found.credible & np.isfinite(off)
    speed = np.linalg.norm(found.states[good, 3:6], axis=1)
    near = int((off[good] < 4.0 * INCH).sum())
    middle = float(np.median(off[good])), float(np.median(speed))
    return int(found.credible.sum()), int(good.sum()), near, *middle


def states(
    throws: Throws, draws: int, backspin: float, size: float = 1.0, air: bool = False
) -> Floats:
    """Return releases with the assumed errors, times `size`, (n, draws, 9).

    Without air they are the parabolas of the head of this file; in air `hoopgen.hoop.aiming`
    finds the flights with that place and angle at the ring.
    """
    random = np.random.default_rng(0)
    n = len(throws.made)

    def noise(name: str, *more: int) -> Floats:
        return size * ERRORS[name] * random.normal(size=(n, draws, *more))

    start = throws.release[:, None] + noise("release", 3)
    end = throws.landing[:, None] + noise("landing", 2)
    slope = np.tan(throws.entry[:, None] + noise("entry"))
    way = end - start[..., :2]
    length = np.hypot(*np.moveaxis(way, -1, 0))
    rise = -start[..., 2]
    level = np.sqrt(NBA["gravity"] * length / (2.0 * rise / length + 2.0 * slope))
    up = level * (2.0 * rise / length + slope)
    if air:
        turning = np.full(length.shape, backspin)
        wanted = {"entry": np.arctan(slope)}
        flights = Flights.at_hoop(NBA_COURT_AIR)
        flown = aimed(wanted, length, rise, flights, backspin=turning)
        level, up = (flown["speed"] * part(flown["elevation"]) for part in (np.cos, np.sin))
    ahead = way / length[..., None]
    spin = np.stack([backspin * ahead[..., 1], -backspin * ahead[..., 0], 0 * level], axis=-1)
    velocity = np.concatenate([ahead * level[..., None], up[..., None]], axis=-1)
    return np.concatenate([start, velocity, spin], axis=-1)


def shares(released: Floats, parameters: Mapping[str, Any], scene: Any) -> Floats:
    """Return the share of the draws of each throw that is made, never 0 or 1."""
    n, draws = released.shape[:2]
    shots = hoopgen.simulate(released.reshape(-1, 9), parameters, scene=scene, fields=("outcome",))
    return np.asarray((shots.made.reshape(n, draws).sum(axis=1) + 0.5) / (draws + 1.0))


def log_terms(p: Floats, made: NDArray[np.bool_]) -> Floats:
    """Return the logarithms of the probabilities of what happened."""
    return np.asarray(np.log(np.where(made, p, 1.0 - p)))


def logistic(throws: Throws) -> Floats:
    """Return probabilities by a logistic regression that never saw the throw itself.

    Of the squares of how far left or right, and past a best depth, the ball comes down.
    """
    x, y = throws.landing.T / INCH
    design = np.stack([np.ones_like(x), x, x * x, y * y], axis=1)
    design[:, 1:] /= design[:, 1:].std(axis=0)
    found = np.empty(len(x))
    for out in range(len(x)):
        rows = np.arange(len(x)) != out
        a, b = design[rows], throws.made[rows]
        beta = np.zeros(4)
        for _ in range(50):
            p = 1.0 / (1.0 + np.exp(-a @ beta))
            hessian = (a * (p * (1.0 - p))[:, None]).T @ a + 0.01 * np.eye(4)
            beta += np.linalg.solve(hessian, a.T @ (b - p) - 0.01 * beta)
        found[out] = 1.0 / (1.0 + np.exp(-design[out] @ beta))
    return found


def always(throws: Throws) -> Floats:
    """Return for each throw the share made among the others."""
    made = throws.made
    return np.asarray((made.sum() - made + 0.5) / len(made))


def profile(throws: Throws, name: str, values: Floats, released: Floats) -> tuple[Floats, Floats]:
    """Return the log-likelihood at values of a parameter of COURT, and the terms, (k, n)."""
    terms = []
    for value in values:
        own = {name: float(value)} | (
            {"bridge_restitution": float(value)} if name == "ring_restitution" else {}
        )
        terms.append(log_terms(shares(released, NBA_COURT | own, COURT), throws.made))
    stacked = np.array(terms)
    return stacked.sum(axis=1), stacked


def interval(values: Floats, likelihood: Floats, drop: float = 1.92) -> str:
    """Return the likeliest value and the ends of its 95% interval as text.

    The ends are those of the grid just outside of the interval, which is no narrower than it.
    """
    inside = np.flatnonzero(likelihood >= likelihood.max() - drop)
    first, last = int(inside[0]), int(inside[-1])
    low = f"{values[first - 1]:.3g}" if first else f"below {values[0]:.3g}"
    high = f"{values[last + 1]:.3g}" if last + 1 < len(values) else f"above {values[-1]:.3g}"
    return f"{values[int(np.argmax(likelihood))]:.3g} ({low} to {high})"


def row(label: str, p: Floats, made: NDArray[np.bool_]) -> str:
    """Return a row of the table of predictions."""
    found = hoopgen.assess(p, made)
    right = int(np.sum((p > 0.5) == made))
    total = found.total
    return (
        f"| {label} | {right} | {total.predicted:.1f} ({total.low}–{total.high}) | "
        f"{MINUS}{-found.log_likelihood:.1f} | {found.brier:.3f} |"
    )
