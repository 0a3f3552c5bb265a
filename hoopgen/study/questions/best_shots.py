"""`best_shots`: from each place of the court the shot of a player that goes in most often.

At each place the best direct shot and the best bank shot are searched, as `bank_or_direct` does;
the better of the two is the place's best. Left and right mirror each other for a player whose
scatter does, so that half of the places are searched.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.hoop.court_lines import find_court
from hoopgen.hoop.presets import PAPER
from hoopgen.scene.lookup import SceneLike, check_article
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.monte_carlo import Progress
from hoopgen.study.models.fitted_scatter import FittedScatter
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.tally import check_share
from hoopgen.text.numbers import format_percent

from .bank import WAYS, bank_or_direct
from .coach import default_player
from .coach_result import PARTS, say

Floats = NDArray[np.float64]

STEP = 1.5
"""Distance of neighbouring places, m."""

_NEAREST, _FURTHEST = 1.2, 9.2
"""Distances from the ring's centre of the nearest and the furthest place, m."""

_HELD = ("height", "backspin", "sidespin")
_UNEVEN = ("azimuth", "sidespin", "angle", "y")


def best_shots(
    player: Scatter | FittedScatter[Scatter] | None = None,
    parameters: ParameterValues = PAPER,
    *,
    makes: float | None = None,
    step: float = STEP,
    shots: int = 5_000,
    seed: int = 0,
    confidence: float = 0.95,
    threads: int | None = None,
    progress: Progress | None = None,
    scene: SceneLike = None,
) -> xr.Dataset:
    """Return from each place of the half court the shot that a player makes most often.

    Parameters
    ----------
    player
        What `Scatter.fit` returned for a player, or a `Scatter`: its height, its spins and its
        scatter are the same from every place, speed and angles are searched. None: the default
        player of `coach`.
    parameters
        Of the article's hoop; their court, the NBA's or FIBA's, has the places.
    makes
        Share of free throws made by the default player; by default 0.7.
    step
        Distance of neighbouring places, m, from 0.5 to 3.
    shots
        Number of shots of the last step of each search, and of the fresh estimates.
    seed, confidence, threads, progress
        As for `hoopgen.bank_or_direct`.
    scene
        None or `hoopgen.HOOP`, the article's hoop; in air this would take hours.

    Returns
    -------
    xarray.Dataset
        Over ``place``, with `x` and `y` on the floor: `bank`, whether the best shot is off the
        board; its `speed`, `elevation`, `azimuth`, `aim` and `probability`, with the interval `low`
        and `high` of fresh shots; and `decided`, whether the interval of the difference between
        bank and direct shot has no 0 in it. All is searched a second time with another seed, which
        chooses between bank and direct, so that the choice does not raise the share:
        `speed_change`, `elevation_change` and `probability_change` are the second result less the
        first, for a place whose way is the same, else NaN. Where the share hardly depends on the
        angle, the two angles may differ by degrees.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    check_article("best_shots", scene)
    if not engine_of(scene).is_hoop:
        raise ValueError(
            "best_shots: it is computed for HOOP, the article's hoop; in air it would take hours, "
            "so ask bank_or_direct from the places that matter"
        )
    level, count = check_share("confidence", confidence), check_count("shots", shots)
    seed = check_count("seed", seed, least=0, most=2**64 - 6)
    if player is not None and makes is not None:
        raise ValueError("makes: it is of the default player; leave one out")
    given = player.model if isinstance(player, FittedScatter) else player
    provenance = "The player is as measured."
    if given is None:
        share = 0.7 if makes is None else makes
        given = default_player(share, parameters, seed=seed, threads=threads)
        provenance = (
            f"A player who makes {format_percent(share, None)} of free throws: a release "
            f"{say('height', given.release['height'])} up with "
            f"{say('backspin', given.release['backspin'])} of backspin; the spread is "
            + ", ".join(f"{say(name, sd)} of {PARTS[name]}" for name, sd in given.sd.items())
            + ", of which left or right and spin are assumed, as is that it is alike everywhere."
        )
    elif not isinstance(given, Scatter):
        raise TypeError("player: expected a Scatter or what Scatter.fit gives")
    held = {name: value for name, value in given.release.items() if name in _HELD}
    if "height" not in held:
        raise ValueError("player: it needs a release height")
    model = Scatter(held, given.sd, given.correlation)
    spots = court_places(step, parameters)
    even = not held.get("sidespin") and not any(
        name in pair for pair in given.correlation for name in _UNEVEN
    )
    searched = spots[spots[:, 1] >= 0.0] if even else spots
    options: dict[str, Any] = {"shots": count, "confidence": level, "threads": threads}
    options["progress"] = progress
    searches = [
        bank_or_direct(model, searched, parameters, seed=one, **options)
        for one in (seed, seed + 2)  # a search has two seeds, the second for fresh shots
    ]
    # The larger of two estimates is too large, so each search reports the way that the other chose.
    first, second = (_best(of_one, of_other) for of_one, of_other in (searches, searches[::-1]))
    same = first["bank"] == second["bank"]
    columns = dict(first)
    for name in ("speed", "elevation", "probability"):
        columns[f"{name}_change"] = np.where(same, second[name] - first[name], np.nan)
    if even:
        columns = _mirrored(columns, searched, spots)
    attributes = {
        "player": json.dumps(model.identity()),
        "provenance": provenance,
        "parameters": json.dumps(
            {n: as_doubles(n, value).item() for n, value in parameters.items()}
        ),
        "step": float(step),
        "shots": count,
        "confidence": level,
        "seed": str(seed),
        "interval": "of the simulation alone: fresh shots, other than those of the search",
    }
    data = {name: ("place", one) for name, one in columns.items()}
    return xr.Dataset(data, {n: ("place", spots[:, k]) for k, n in enumerate("xy")}, attributes)


def court_places(step: float, parameters: ParameterValues) -> Floats:
    """Return places of the half court, x and y, (n, 2), m, a step apart, the middle among them.

    Raises
    ------
    ValueError
        If the step is not from 0.5 to 3 m.
    """
    apart = float(np.asarray(as_doubles("step", step)))
    if not 0.5 <= apart <= 3.0:
        raise ValueError(f"step: expected a distance from 0.5 to 3 m, got {step}")
    court = find_court(None, parameters)
    across = int(court.half_width / apart - 0.5)
    y, x = np.meshgrid(apart * np.arange(-across, across + 1), apart * np.arange(20))
    spots = np.stack([x.ravel(), y.ravel()], axis=1)
    away = np.hypot(*spots.T)
    return np.asarray(spots[(away >= _NEAREST) & (away <= _FURTHEST)])


def _best(dataset: xr.Dataset, chosen: xr.Dataset) -> dict[str, Floats]:
    """Return the results of one search, of the way that is better in another search."""
    which = np.argmax(chosen["probability"].values, axis=0)
    names = ("speed", "elevation", "azimuth", "aim", "probability", "low", "high")
    columns = {n: np.take_along_axis(dataset[n].values, which[None], axis=0)[0] for n in names}
    low, high = dataset["difference_low"].values, dataset["difference_high"].values
    bank = which == WAYS.index("bank")
    return columns | {"bank": bank, "decided": (low > 0.0) | (high < 0.0)}


def _mirrored(columns: dict[str, Floats], searched: Floats, spots: Floats) -> dict[str, Floats]:
    """Return the columns at all places; to the left of the middle a shot is the mirror image."""
    rows = {(x, y): row for row, (x, y) in enumerate(searched.tolist())}
    order = np.array([rows[x, abs(y)] for x, y in spots.tolist()])
    whole = {name: one[order] for name, one in columns.items()}
    whole["azimuth"] = np.where(spots[:, 1] < 0.0, -whole["azimuth"], whole["azimuth"])
    return whole
