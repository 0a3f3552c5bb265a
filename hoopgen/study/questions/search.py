"""The search for the best release: over bounds, with common random numbers, without derivatives.

The share of a candidate's shots that succeeds is a surface of small steps. A Sobol sequence finds
where it is not zero, differential evolution the best hill, and Nelder and Mead's simplex its top,
with more and more shots.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import differential_evolution, minimize
from scipy.stats import qmc

from hoopgen.core.units import DEGREE, TURN
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import check_names
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.hoop.variables import check_angles
from hoopgen.scene.lookup import variables_of
from hoopgen.study.jobs.objective import Bounds, Player
from hoopgen.text.shorten import brief

Floats = NDArray[np.float64]


def searched_variables(
    over: Mapping[str, Bounds | None] | Iterable[str] | str,
) -> Mapping[str, Bounds | None] | tuple[str, ...]:
    """Return the variables to search over, with their bounds if any are given; one name is one."""
    if isinstance(over, Mapping):
        return over
    return (over,) if isinstance(over, str) else tuple(over)


def bounds_of(
    over: Mapping[str, Bounds | None] | Sequence[str], centre: Mapping[str, float], player: Player
) -> dict[str, Bounds]:
    """Return the bounds to search within: those given, or the usual ones about a release.

    Parameters
    ----------
    over
        The variables to search over, with their bounds, SI and rad; None is the usual bounds.
    centre
        A release by variable, SI and rad, about which the usual bounds are.
    player
        The player, whose scene sets bounds, too.
    """
    names = check_names("over", over, variables_of(player.scene))
    wanted = dict(over) if isinstance(over, Mapping) else dict.fromkeys(names)
    if not wanted:
        raise ValueError("over: expected at least one variable")
    bounds, player = {}, player.at(centre)
    for name, ends in wanted.items():
        given = as_doubles(
            f"over[{name!r}]", _usual(name, centre, player) if ends is None else ends
        )
        if given.shape != (2,) or not np.all(np.isfinite(given)) or not given[0] < given[1]:
            raise ValueError(
                f"over[{name!r}]: expected (low, high), low below high, got {brief(ends)}"
            )
        bounds[name] = (float(given[0]), float(given[1]))
    if player.scene.has_hoop:
        check_angles("over", bounds)
    return bounds


def _usual(name: str, fixed: Mapping[str, float], player: Player) -> Bounds:
    """Return the bounds of a variable for which none were given."""
    if not player.scene.has_hoop:
        raise ValueError(f"over[{name!r}]: expected (low, high); there are no usual bounds")
    direct = player.by == "direct"
    away = fixed["distance"] if "distance" in fixed else math.hypot(*map(fixed.get, "xy", (0, 0)))
    placed = "height" in fixed and ("distance" in fixed or {"x", "y"} <= fixed.keys())
    if name in ("elevation", "speed") and placed:
        if not away:
            raise ValueError(
                f"distance: expected above 0 where over[{name!r}] has no (low, high): its usual "
                "bounds are about the slowest release through the ring's centre; got 0"
            )
        # About the slowest release through the centre: an error of its angle hardly matters.
        rise, gravity = RING_HEIGHT - fixed["height"], player.parameters["gravity"]
        with np.errstate(all="ignore"):  # bounds that are not finite are refused
            slope, speed = hoop.least_speed(away, rise, gravity)
        if name == "speed":
            return 0.95 * float(speed), (1.2 if direct else 1.4) * float(speed)
        easiest = math.atan(slope)
        return easiest - 15 * DEGREE, min(easiest + 20 * DEGREE, 85 * DEGREE)
    bounds: dict[str, Bounds] = {
        "aim": (-0.25, 0.35) if direct else (-0.25, 2.0),
        "entry": (25 * DEGREE, 70 * DEGREE),
        "azimuth": (-5 * DEGREE, 5 * DEGREE) if direct else (-25 * DEGREE, 25 * DEGREE),
        "backspin": (0.0, 6 * TURN),
        "sidespin": (-3 * TURN, 3 * TURN),
    }
    if name not in bounds:
        raise ValueError(f"over[{name!r}]: expected (low, high); there are no usual bounds")
    return bounds[name]


def search(
    player: Player, bounds: Mapping[str, Bounds], fixed: Mapping[str, float], shots: int, seed: int
) -> dict[str, float] | None:
    """Return the best values within the bounds; None if no release tried succeeds.

    Parameters
    ----------
    player
        The player, who scatters.
    bounds
        The bounds of each variable, SI and rad.
    fixed
        The other variables of the release, SI and rad.
    shots
        The number of shots thrown at each release that is tried.
    seed
        The seed of the random numbers.
    """
    surface = _Surface(player, bounds, fixed, seed)
    # Shots go in directly or off the board: two hills, too alike for few shots to choose between.
    ways: Sequence[str] = ("direct", "bank") if player.by == "any" else (player.by,)
    hills = [replace(surface, player=replace(player, by=way)).hill(shots) for way in ways]
    tops = [surface.top(hill, _some(shots, 2), 0.05) for hill in hills if hill is not None]
    if not tops:
        return None
    highest = tops[int(surface.failures(np.array(tops).T, shots).argmin())]
    best = surface.values(surface.top(highest, shots, 0.01))
    return {name: float(value) for name, value in best.items()}


@dataclass(frozen=True)
class _Surface:
    """The share of a player's shots that fails, over the unit cube between the bounds."""

    player: Player
    bounds: Mapping[str, Bounds]
    fixed: Mapping[str, float]
    seed: int

    def values(self, point: Floats) -> dict[str, Any]:
        """Return the variables at points, (k,) or (k, m)."""
        ends = zip(self.bounds.items(), point, strict=True)
        return {name: low + (high - low) * at for (name, (low, high)), at in ends}

    def failures(self, points: Floats, shots: int) -> Floats:
        """Return the share that fails, (m,), at points (k, m)."""
        successes = self.player.sampled({**self.fixed, **self.values(points)}, shots, self.seed)
        # Where no shot is valid, none succeeds.
        return np.asarray(1.0 - np.nan_to_num(successes.share))

    def hill(self, shots: int) -> Floats | None:
        """Return a point near the top of the highest hill; None if there is none."""
        size = len(self.bounds)
        tried = qmc.Sobol(size, scramble=False).random_base2(min(12, 4 + 3 * size))
        failed = self.failures(tried.T, _some(shots, 512))
        if failed.min() == 1.0:
            return None
        evolved = differential_evolution(
            lambda points: self.failures(points, _some(shots, 32)),
            [(0.0, 1.0)] * size,
            init=tried[np.argsort(failed, kind="stable")[: max(16, 8 * size)]],
            maxiter=20,
            tol=0.005,  # all of them fail as often: they are in one flat place
            polish=False,
            vectorized=True,
            updating="deferred",
            seed=np.random.default_rng(self.seed),
        )
        return np.asarray(evolved.x)

    def top(self, point: Floats, shots: int, step: float) -> Floats:
        """Return the top of the hill that a point is on."""
        size = len(self.bounds)
        corners = np.vstack([point, point + step * np.eye(size)])
        climbed = minimize(
            lambda at: self.failures(at[:, None], shots)[0],
            point,
            method="Nelder-Mead",
            bounds=[(0.0, 1.0)] * size,
            # Much closer than a step of the simplex the surface has steps of its own.
            options={
                "initial_simplex": np.where(corners > 1.0, 2 * point - corners, corners),
                "maxfev": 20 * size,
                "xatol": step / 20,
                "fatol": 0.0,
            },
        )
        return np.asarray(climbed.x)


def _some(shots: int, part: int) -> int:
    """Return a part of the shots, though enough to tell a hill from none."""
    return min(shots, max(64, shots // part))


def flat_about(
    player: Player,
    bounds: Mapping[str, Bounds],
    fixed: Mapping[str, float],
    point: Mapping[str, float],
    shots: int,
    seed: int,
    tolerance: float,
) -> dict[str, Bounds]:
    """Return the extent of the region about a point in which the probability hardly falls.

    Points are drawn in an ellipsoid that takes its shape from those that were in the region, so
    that a narrow ridge is followed to its ends.

    Of shots that chose the point the region would be too narrow: they flatter it.

    Parameters
    ----------
    player, bounds, fixed, shots, seed
        As for `search`.
    point
        The values about which the region is, SI and rad.
    tolerance
        By how much the probability may fall, from 0 to 1.
    """
    names, size = tuple(bounds), len(bounds)
    low, high = np.array(list(bounds.values())).T
    centre = np.array([[point[name] for name in names]])

    def share(points: Floats) -> Floats:
        values = dict(zip(names, points.T, strict=True))
        return player.sampled({**fixed, **values}, shots, seed).share

    random, shape = np.random.default_rng(seed), np.diag((high - low) / 20)
    least, found = share(centre)[0] - tolerance, [centre]
    for _ in range(6):
        drawn = np.clip(centre + 1.4 * _ball(random, 32 * size, size) @ shape.T, low, high)
        inside = drawn[share(drawn) >= least]
        found.append(inside)
        if len(inside) <= size:
            shape = shape / 2
        else:
            # A full ellipsoid has the covariance of its matrix over size + 2.
            away = inside - centre
            spread = (size + 2) * away.T @ away / len(away)
            shape = np.linalg.cholesky(spread + np.diag((1e-6 * (high - low)) ** 2))
    inside = np.concatenate(found)
    ends = zip(inside.min(axis=0).tolist(), inside.max(axis=0).tolist(), strict=True)
    return dict(zip(names, ends, strict=True))


def _ball(random: np.random.Generator, count: int, size: int) -> Floats:
    """Return points of the unit ball, (count, size), uniformly."""
    towards = random.standard_normal((count, size))
    away = random.random((count, 1)) ** (1 / size)
    return np.asarray(away * towards / np.linalg.norm(towards, axis=1, keepdims=True))
