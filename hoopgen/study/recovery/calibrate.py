"""`calibrate`: restitution, friction and other parameters from shots whose ends are known.

Each measured release is thrown many times with its measuring errors. The share of these that end as
the shot did, as `outcomes` compares them, is the probability of what was seen; the product over the
shots is the likelihood of the parameters. It is computed on a grid, with the same
random numbers at each point. The interval of a parameter is that of the profile likelihood: the
values at which the largest log-likelihood over all other parameters is no more than half the
quantile of chi-square below the maximum (S. S. Wilks (1938), The large-sample distribution of the
likelihood ratio, The Annals of Mathematical Statistics 9).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from math import inf
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtri

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues, resolve
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.core.variables import check_names
from hoopgen.hoop.releases import release
from hoopgen.hoop.variables import ARGUMENTS, check_angles
from hoopgen.scene.lookup import SceneLike, check_hoop
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.measures.rebounds import CATCHING_HEIGHT, check_height
from hoopgen.study.models.random import POSTERIOR, normals
from hoopgen.study.statistics.tally import check_share
from hoopgen.text.shorten import brief, join_names

from .calibrated_scene import Calibrated, CalibratedScene
from .fitted_releases import FittedReleases
from .outcomes import OUTCOMES, Outcomes

Floats = NDArray[np.float64]

_POINTS = {1: 41, 2: 21, 3: 11}
"""Points of the grid in each direction, by the number of parameters."""

_STREAM = POSTERIOR + 2_000
_TOGETHER = 1 << 19  # shots that are simulated together

_USUAL = {"restitution": (0.3, 0.95), "friction": (0.0, 1.2), "tangential_restitution": (0.0, 0.6)}


@check_arguments
def calibrate(
    table: Mapping[str, ArrayLike] | FittedReleases,
    vary: Sequence[str] | Mapping[str, tuple[float, float] | None],
    *,
    made: ArrayLike | None = None,
    outcomes: Mapping[str, ArrayLike] | None = None,
    scene: SceneLike = None,
    parameters: ParameterValues | None = None,
    errors: Mapping[str, ArrayLike] | None = None,
    rebound_error: float = 0.0,
    catching_height: float = CATCHING_HEIGHT,
    draws: int = 200,
    seed: int = 0,
    confidence: float = 0.95,
) -> CalibratedScene:
    """Find the parameters of a scene with which measured shots most likely end as they did.

    Parameters
    ----------
    table
        Columns by name, SI: arguments of `hoopgen.release`, (n,) each or one number; `made`, true
        or false; and where they are known, `contacts`, the impacts before the end; `first`, the
        name of the body touched first, or "none"; `rebound_x` and `rebound_y`, where a miss came
        down to the catching height, m from the ring's centre. NaN or "" is a shot of which that is
        not known. Or what `hoopgen.fit_release` returned, whose errors are known.
    vary
        Names of one to three parameters, such as ("restitution",); of other than restitutions and
        frictions with their bounds, {"board_distance": (0.37, 0.39)}.
    made
        Whether each shot was made, (n,), if it is no column of the table.
    outcomes
        The other columns of outcomes, if they are no columns of the table.
    scene, parameters
        As for `hoopgen.simulate`; the scene has a hoop.
    errors
        Standard errors of the measurement by variable, SI, one number or one for each shot. Without
        any, a release that is off by less than its digits would be impossible, so they are needed.
    rebound_error
        Standard error of each coordinate of a rebound, m.
    catching_height
        Of rebounds: of the ball's centre above the floor, m; for a ball on the floor its radius.
    draws
        Number of shots of each release at each point of the grid.
    seed
        From 0 to 2^64 - 1.
    confidence
        Of the intervals.

    Returns
    -------
    CalibratedScene
        The likeliest value of each with its interval. A parameter that the shots do not bound is
        called not identified. The intervals hold if the model is right but for these parameters.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    engine = engine_of(scene)
    check_hoop("scene", engine)
    level, count = check_share("confidence", confidence), check_count("draws", draws, least=2)
    height = check_height(catching_height)
    states, good, ends = _drawn(table, errors, count, seed)
    ends |= dict(outcomes or {}) | ({} if made is None else {"made": made})
    bodies = tuple(engine.surfaces)
    seen = Outcomes.read(ends, len(states), bodies, count, rebound_error, height, seed)
    if not good.any():
        raise ValueError("table: no shot has a release")
    states, seen, cells = states[good], seen[good], seen.cells(len(bodies))
    base = resolve(parameters, len(states), engine.table)
    bounds = _bounds(vary, engine)
    grids = {n: np.linspace(*ends, _POINTS[len(bounds)]) for n, ends in bounds.items()}
    shape = tuple(len(one) for one in grids.values())
    surface, halves = np.empty(shape), np.empty((2, *shape))
    for place in product(*map(range, shape)):
        point = {name: float(one[k]) for (name, one), k in zip(grids.items(), place, strict=True)}
        hits, valid = _hits(states, seen, {**base, **point}, engine)
        surface[place] = _log_likelihood(hits.sum(axis=1), valid.sum(axis=1), cells)
        for half in range(2):
            part = np.arange(count) % 2 == half
            halves[(half, *place)] = _log_likelihood(
                hits[:, part].sum(axis=1), valid[:, part].sum(axis=1), cells
            )
    best = np.unravel_index(int(np.argmax(surface)), shape)
    off = (halves[0] - halves[0][best]) - (halves[1] - halves[1][best])
    near = surface > surface[best] - 4.0
    noise = 0.5 * float(np.sqrt(np.mean(off[near] ** 2)))
    drop = 0.5 * float(chdtri(1.0, 1.0 - level)) + 2.0 * noise
    found = {}
    for axis, (name, grid) in enumerate(grids.items()):
        others = tuple(k for k in range(len(shape)) if k != axis)
        profile = surface.max(axis=others) - surface[best]
        found[name] = _interval(grid, profile, drop)
    likeliest = {name: one.value for name, one in found.items()}
    known = {name: value for name, value in base.items() if not np.ndim(value)}
    return CalibratedScene(
        found,
        {**known, **likeliest},
        float(surface[best]),
        noise,
        len(states),
        count,
        seen.used,
        level,
        engine,
    )


def _bounds(vary: Any, engine: Any) -> dict[str, tuple[float, float]]:
    """Return the bounds of the parameters to vary."""
    names = [vary] if isinstance(vary, str) else list(vary)
    check_names("vary", names, tuple(engine.table.defaults))
    if not 1 <= len(names) <= len(_POINTS) or len(set(names)) < len(names):
        raise ValueError(f"vary: expected one to three different parameters, got {brief(names)}")
    found = {}
    for name in names:
        ends = vary[name] if isinstance(vary, Mapping) else None
        if ends is None:
            usual = name if name in _USUAL else name.rpartition("_")[2]
            if usual not in _USUAL:
                raise ValueError(f"vary: {name} has no usual bounds; give {{name: (low, high)}}")
            ends = _USUAL[usual]
        low, high = (float(end) for end in ends)
        least, most = engine.table.limits.get(name, (-inf, inf))
        if not (least <= low < high <= most and np.isfinite([low, high]).all()):
            raise ValueError(f"vary: {name}: expected low below high within its limits, got {ends}")
        found[name] = (low, high)
    return found


def _drawn(
    table: Any, errors: Mapping[str, ArrayLike] | None, draws: int, seed: int
) -> tuple[Floats, NDArray[np.bool_], dict[str, Any]]:
    """Return states (n, draws, 9), which rows have them all, and the columns of outcomes."""
    if isinstance(table, FittedReleases):
        if errors is not None:
            raise ValueError("errors: fitted releases have their own; leave it out")
        return table.draw(draws, seed), table.credible, {}
    if not (isinstance(table, Mapping) or hasattr(table, "items")):
        raise TypeError(f"table: expected columns by name or fitted releases, got {brief(table)}")
    given = dict(table.items())
    ends = {name: given.pop(name) for name in OUTCOMES if name in given}
    check_names("table", given, (*ARGUMENTS, *OUTCOMES))
    check_angles("table", given)
    missing = [n for n in ("speed", "elevation", "height", "distance") if n not in given]
    if missing:
        raise ValueError(f"table: missing {join_names(missing)}")
    columns = {n: as_doubles(f"table[{n!r}]", one) for n, one in given.items()}
    rows = max((len(one) for one in columns.values() if one.ndim), default=0)
    if not rows:
        raise ValueError("table: expected columns of shots, got single numbers")
    check_names("errors", errors or (), ARGUMENTS)
    sizes = {n: as_doubles(f"errors[{n!r}]", one) for n, one in (errors or {}).items()}
    if not any(np.any(one) for one in sizes.values()):
        raise ValueError(
            "errors: expected standard errors of the measurement, such as speed=0.03, in m/s"
        )
    full: dict[str, Any] = {n: np.broadcast_to(one, rows)[:, None] for n, one in columns.items()}
    for name, sd in sizes.items():
        if sd.shape not in ((), (rows,)) or np.any(sd < 0.0):
            raise ValueError(
                f"errors[{name!r}]: expected a number from 0, or one for each of {rows} shots, got "
                f"{brief(sd)}"
            )
        stream = _STREAM + list(ARGUMENTS).index(name)
        noise = normals(seed, stream, 0, rows * draws).reshape(rows, draws)
        full[name] = full.get(name, 0.0) + np.broadcast_to(sd, rows)[:, None] * noise
    states = np.broadcast_to(release(**full), (rows, draws, 9))
    return states, np.asarray(np.isfinite(states).all(axis=(1, 2))), ends


def _hits(
    states: Floats, seen: Outcomes, parameters: Any, engine: Any
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return which draws end as the shots did, and which are valid, (n, draws)."""
    n, draws = states.shape[:2]
    step = max(1, _TOGETHER // draws)
    parts = []
    for first in range(0, n, step):
        rows = slice(first, min(first + step, n))
        own = {name: one[rows] if np.ndim(one) else one for name, one in parameters.items()}
        parts.append(seen[rows].hits(states[rows], own, engine))
    hits, valid = (np.concatenate(one) for one in zip(*parts, strict=True))
    return hits, valid


def _log_likelihood(hits: Any, valid: Any, cells: int) -> float:
    """Return the log-likelihood; half a hit for each possible end keeps it finite."""
    return float(np.sum(np.log((hits + 0.5) / (valid + 0.5 * cells))))


def _interval(grid: Floats, profile: Floats, drop: float) -> Calibrated:
    """Return the interval of the profile, with its ends between points of the grid."""
    inside = np.flatnonzero(profile >= -drop)
    first, last = int(inside[0]), int(inside[-1])
    low, high = float(grid[first]), float(grid[last])
    if first > 0:
        low = float(np.interp(-drop, profile[first - 1 : first + 1], grid[first - 1 : first + 1]))
    if last < len(grid) - 1:
        ends = profile[last : last + 2][::-1], grid[last : last + 2][::-1]
        high = float(np.interp(-drop, *ends))
    best = float(grid[int(np.argmax(profile))])
    return Calibrated(best, low, high, (first > 0, last < len(grid) - 1), grid, profile)
