"""`calibrate`: restitution, friction and other parameters from shots whose ends are known.

Each measured release is thrown many times with its measuring errors. The share of these that end as
the shot did, in as many contacts where the table has them, is the probability of what was seen; the
product over the shots is the likelihood of the parameters. It is computed on a grid, with the same
random numbers at each point. The interval of a parameter is that of the profile likelihood: the
values at which the largest log-likelihood over all other parameters is no more than half the
quantile of chi-square below the maximum (S. S. Wilks (1938), The large-sample distribution of the
likelihood ratio, The Annals of Mathematical Statistics 9).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import inf
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtri

from hoopgen.core.parameters import ParameterValues, resolve
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.core.variables import check_names
from hoopgen.hoop.releases import release
from hoopgen.hoop.variables import ARGUMENTS, check_angles
from hoopgen.scene.lookup import SceneLike, check_hoop
from hoopgen.simulation.lookup import engine_of
from hoopgen.simulation.simulate import simulate
from hoopgen.study.models.random import POSTERIOR, normals
from hoopgen.study.result import Result
from hoopgen.study.statistics.tally import check_share
from hoopgen.text.numbers import format_count, format_percent
from hoopgen.text.shorten import brief, join_names
from hoopgen.text.tables import table as text_table

from .fitted_releases import FittedReleases

Floats = NDArray[np.float64]

_POINTS = {1: 41, 2: 21, 3: 11}
"""Points of the grid in each direction, by the number of parameters."""

_CONTACTS = 3
"""So many contacts, and more, are told apart no further."""

_STREAM = POSTERIOR + 2_000
_TOGETHER = 1 << 19  # shots that are simulated together

_USUAL = {"restitution": (0.3, 0.95), "friction": (0.0, 1.2), "tangential_restitution": (0.0, 0.6)}


@dataclass(frozen=True)
class Calibrated:
    """A parameter and its interval.

    Attributes
    ----------
    value
        Where the likelihood is largest.
    low, high
        Ends of the interval; those of the grid where the likelihood does not bound it.
    bounded
        Whether the likelihood bounds it from below, and from above.
    grid, profile
        Values, and the largest log-likelihood over the other parameters less the maximum.
    """

    value: float
    low: float
    high: float
    bounded: tuple[bool, bool]
    grid: Floats
    profile: Floats

    @property
    def identified(self) -> bool:
        """True if the shots bound the parameter on a side, so that they say something of it."""
        return any(self.bounded)


@dataclass(frozen=True, repr=False)
class CalibratedScene(Result):
    """Parameters of a scene that make the ends of measured shots likeliest.

    Attributes
    ----------
    values
        By name.
    parameters
        All parameters of the scene, with the likeliest values.
    log_likelihood
        The maximum.
    noise
        Standard error of the log-likelihood from the number of draws, by halves; the intervals
        are widened by twice that.
    shots, draws
        Shots, and draws of each.
    contacts
        Whether the numbers of contacts were used, too.
    confidence
        Of the intervals.
    """

    values: Mapping[str, Calibrated]
    parameters: Mapping[str, Any]
    log_likelihood: float
    noise: float
    shots: int
    draws: int
    contacts: bool
    confidence: float

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        return {
            "values": {
                name: {
                    "value": one.value,
                    "low": one.low,
                    "high": one.high,
                    "bounded": list(one.bounded),
                    "grid": one.grid.tolist(),
                    "profile": one.profile.tolist(),
                }
                for name, one in self.values.items()
            },
            "log_likelihood": self.log_likelihood,
            "noise": self.noise,
            "shots": self.shots,
            "draws": self.draws,
            "contacts": self.contacts,
            "confidence": self.confidence,
        }

    def __str__(self) -> str:
        level = format_percent(self.confidence, None)
        rows = []
        for name, one in self.values.items():
            ends = "".join(
                [
                    "" if one.bounded[0] else "below ",
                    f"{one.low:.3g} to {one.high:.3g}",
                    "" if one.bounded[1] else " and above",
                ]
            )
            rows.append([name, f"{one.value:.3g}" if one.identified else "not identified", ends])
        what = "outcomes and contacts" if self.contacts else "outcomes"
        lines = [
            text_table(["parameter", "likeliest", f"{level} interval"], rows, right=[1]),
            "",
            f"log-likelihood {self.log_likelihood:.2f} ± {self.noise:.2f} of the {what} of "
            f"{format_count(self.shots, 'shot')}, {self.draws:,} draws of each",
        ]
        if self.noise > 0.5:
            lines.append("the draws are too few for narrow intervals: give more")
        return "\n".join(lines)


def calibrate(
    table: Mapping[str, ArrayLike] | FittedReleases,
    vary: Sequence[str] | Mapping[str, tuple[float, float]],
    *,
    made: ArrayLike | None = None,
    scene: SceneLike = None,
    parameters: ParameterValues | None = None,
    errors: Mapping[str, float] | None = None,
    draws: int = 200,
    seed: int = 0,
    confidence: float = 0.95,
) -> CalibratedScene:
    """Find the parameters of a scene with which measured shots most likely end as they did.

    Parameters
    ----------
    table
        Columns by name, SI: arguments of `hoopgen.release`, (n,) each or one number; `made`, true
        or false; and if they were counted, `contacts`, the impacts before the end. Or what
        `hoopgen.fit_release` returned, whose errors are known; then `made` is given beside it.
    vary
        Names of one to three parameters, such as ("restitution",); of other than restitutions and
        frictions with their bounds, {"board_distance": (0.37, 0.39)}.
    made
        Whether each shot was made, (n,), if it is no column of the table.
    scene, parameters
        As for `hoopgen.simulate`; the scene has a hoop.
    errors
        Standard errors of the measurement by variable, SI. Without any, a release that is off by
        less than its digits would be impossible, so they are needed.
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
    states, seen, contacts = _drawn(table, made, errors, count, seed)
    base = resolve(parameters, len(states), engine.table)
    bounds = _bounds(vary, engine)
    grids = {n: np.linspace(*ends, _POINTS[len(bounds)]) for n, ends in bounds.items()}
    shape = tuple(len(one) for one in grids.values())
    surface, halves = np.empty(shape), np.empty((2, *shape))
    for place in product(*map(range, shape)):
        point = {name: float(one[k]) for (name, one), k in zip(grids.items(), place, strict=True)}
        hits, valid = _hits(states, seen, contacts, {**base, **point}, engine)
        cells = 2 * (_CONTACTS + 1) if contacts is not None else 2
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
        contacts is not None,
        level,
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
    table: Any,
    made: Any,
    errors: Mapping[str, float] | None,
    draws: int,
    seed: int,
) -> tuple[Floats, NDArray[np.bool_], Any]:
    """Return states (n, draws, 9), whether each shot was made, and its contacts or None."""
    if isinstance(table, FittedReleases):
        if errors is not None:
            raise ValueError("errors: fitted releases have their own; leave it out")
        states, contacts = table.draw(draws, seed), None
        good = table.credible
    elif isinstance(table, Mapping) or hasattr(table, "items"):
        given = dict(table.items())
        made = given.pop("made") if made is None and "made" in given else made
        contacts = given.pop("contacts", None)
        check_names("table", given, (*ARGUMENTS, "made", "contacts"))
        check_angles("table", given)
        missing = [n for n in ("speed", "elevation", "height", "distance") if n not in given]
        if missing:
            raise ValueError(f"table: missing {join_names(missing)}")
        columns = {n: as_doubles(f"table[{n!r}]", one) for n, one in given.items()}
        rows = max((len(one) for one in columns.values() if one.ndim), default=0)
        if not rows:
            raise ValueError("table: expected columns of shots, got single numbers")
        if not errors or not any(errors.values()):
            raise ValueError("errors: expected standard errors of the measurement, such as speed")
        check_names("errors", errors, ARGUMENTS)
        full: dict[str, Any] = {
            n: np.broadcast_to(one, rows)[:, None] for n, one in columns.items()
        }
        for name, sd in errors.items():
            if not 0.0 <= float(sd) < inf:
                raise ValueError(f"errors[{name!r}]: expected a number from 0, got {brief(sd)}")
            stream = _STREAM + list(ARGUMENTS).index(name)
            noise = float(sd) * normals(seed, stream, 0, rows * draws).reshape(rows, draws)
            full[name] = full.get(name, 0.0) + noise
        states = np.broadcast_to(release(**full), (rows, draws, 9))
        good = np.asarray(np.isfinite(states).all(axis=(1, 2)))
    else:
        raise TypeError(f"table: expected columns by name or fitted releases, got {brief(table)}")
    if made is None:
        raise ValueError("made: whether each shot was made is neither a column nor given")
    seen = np.asarray(made)
    if seen.shape != (len(states),) or not np.isin(seen, (0, 1)).all():
        raise ValueError(f"made: expected true or false for each of {len(states)} shots")
    counted = None if contacts is None else np.asarray(contacts)
    if counted is not None and counted.shape != seen.shape:
        raise ValueError(f"contacts: expected a number for each of {len(states)} shots")
    if not good.any():
        raise ValueError("table: no shot has a release")
    return states[good], seen[good].astype(bool), None if counted is None else counted[good]


def _hits(
    states: Floats, seen: NDArray[np.bool_], contacts: Any, parameters: Any, engine: Any
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return which draws end as the shots did, and which are valid, (n, draws)."""
    n, draws = states.shape[:2]
    hits, valid = np.empty((n, draws), bool), np.empty((n, draws), bool)
    step = max(1, _TOGETHER // draws)
    for first in range(0, n, step):
        part = slice(first, min(first + step, n))
        own = {
            name: np.repeat(np.asarray(one)[part], draws) if np.ndim(one) else one
            for name, one in parameters.items()
        }
        flat = states[part].reshape(-1, 9)
        shots = simulate(flat, own, scene=engine, fields=("outcome", "contacts"))
        same = np.asarray(shots.made).reshape(-1, draws) == seen[part, None]
        if contacts is not None:
            found = np.minimum(shots.contacts.reshape(-1, draws), _CONTACTS)
            same = same & (found == np.minimum(contacts[part, None], _CONTACTS))
        hits[part] = np.asarray(same)
        valid[part] = (shots.outcome != engine.outcomes["INVALID"]).reshape(-1, draws)
    return hits & valid, valid


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
