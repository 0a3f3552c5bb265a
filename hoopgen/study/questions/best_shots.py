"""`best_shots`: from each place of the court the shot of a player that goes in most often.

At each place the best direct shot and the best bank shot are searched, as `bank_or_direct` does;
the better of the two is the place's best. Left and right mirror each other for a player whose
scatter does, so that half of the places are searched.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_number, check_count
from hoopgen.engine.elementary import hypotenuse
from hoopgen.hoop.court_lines import find_court
from hoopgen.hoop.releases import release
from hoopgen.hoop.variables import ARGUMENTS, VARIABLES
from hoopgen.report.provenance import describe_scene
from hoopgen.scene.lookup import SceneLike, check_hoop
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.models.fitted_scatter import FittedScatter
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.tally import check_scene, check_share

from .bank import WAYS, bank_or_direct
from .default_player import default_player

Floats = NDArray[np.float64]

STEP = 1.5
"""Distance of neighbouring places, m."""

_NEAREST, _FURTHEST = 1.2, 9.2
"""Distances from the ring's centre of the nearest and the furthest place, m."""

_HELD = ("height", "backspin", "sidespin")
_LABELS = {
    "bank": "whether the best shot is off the board",
    "decided": "whether the lead is certain to be above 0",
    "lead": "probability, less that of the other of bank and direct",
    "lead_low": "lower end of its interval",
    "lead_high": "upper end of its interval",
    "probability": "probability of a made shot",
    "low": "lower end of its interval",
    "high": "upper end of its interval",
}
_UNEVEN = ("azimuth", "sidespin", "angle", "y")


@check_arguments
def best_shots(
    player: Scatter | FittedScatter[Scatter] | None = None,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    makes: float | None = None,
    step: float = STEP,
    shots: int = 5_000,
    seed: int = 0,
    confidence: float = 0.95,
    threads: int | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Return from each place of the half court the shot that a player makes most often.

    Parameters
    ----------
    player
        What `Scatter.fit` returned for a player, or a `Scatter`: its height, its spins and its
        scatter are the same from every place, speed and angles are searched. None: the default
        player of `coach`.
    parameters
        Of the scene; their court, the NBA's or FIBA's, has the places.
    scene
        A hoop; None: `hoopgen.HOOP`. In `COURT` the search takes more than twice as long, in `AIR`
        some fifteen times.
    makes
        Share of free throws made by the default player; by default 0.7.
    step
        Distance of neighbouring places, m, from 0.5 to 3.
    shots
        Number of shots of the last step of each search, and of the fresh estimates.
    seed, confidence, threads, progress
        As for `hoopgen.bank_or_direct`.

    Returns
    -------
    xarray.Dataset
        Over ``place``, with `x` and `y` on the floor: `bank`, whether the best shot is off the
        board; its `speed`, `elevation`, `azimuth`, `aim` and `probability`, with the interval `low`
        and `high` of fresh shots; `lead`, by how much it is more than that of the other way, with
        the interval `lead_low` and `lead_high` of the same shots; and `decided`, whether
        `lead_low` is above 0. All is searched a second time with another seed, which chooses
        between bank and direct, so that the choice does not raise the share or the lead. With few
        shots it may choose the worse way: where `decided` is False the shots do not tell, and
        where `lead_high` is below 0 they speak against the choice. `speed_change`,
        `elevation_change`, `probability_change` and `lead_change` are the second result less the
        first, for a place whose way is the same, else NaN. Where the share hardly depends on the
        angle, the two angles may differ by degrees.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    engine = engine_of(scene)
    check_hoop("best_shots", engine)
    values = check_scene(parameters, engine)
    level, count = check_share("confidence", confidence), check_count("shots", shots)
    seed = check_count("seed", seed, least=0, most=2**64 - 6)
    if player is not None and makes is not None:
        raise ValueError("makes: it is of the default player; leave one out")
    given = player.model if isinstance(player, FittedScatter) else player
    made: dict[str, float] = {}
    if given is None:
        share = 0.7 if makes is None else makes
        given = default_player(share, values, scene=engine, seed=seed, threads=threads)
        made = {"makes": share}
    elif not isinstance(given, Scatter):
        raise TypeError("player: expected a Scatter or what Scatter.fit gives")
    held = {name: value for name, value in given.release.items() if name in _HELD}
    if "height" not in held:
        raise ValueError("player: it needs a release height")
    model = Scatter(held, given.sd, given.correlation)
    spots = court_places(step, values)
    even = not held.get("sidespin") and not any(
        name in pair for pair in given.correlation for name in _UNEVEN
    )
    searched = spots[spots[:, 1] >= 0.0] if even else spots
    options: dict[str, Any] = {"shots": count, "confidence": level, "threads": threads}
    options |= {"scene": engine, "progress": progress}
    if engine.kernels.PIECES:
        # Through air the speed of each aim is searched, too, which takes ten times as long.
        options["over"] = ("elevation", "speed", "azimuth")
    searches = [
        bank_or_direct(model, searched, values, seed=one, **options)
        for one in (seed, seed + 2)  # a search has two seeds, the second for fresh shots
    ]
    if engine.kernels.PIECES:
        searches = [_with_aim(one, engine, values) for one in searches]
    # The larger of two estimates is too large, so each search reports the way that the other chose.
    first, second = (_best(of_one, of_other) for of_one, of_other in (searches, searches[::-1]))
    same = first["bank"] == second["bank"]
    columns = dict(first)
    for name in ("speed", "elevation", "probability", "lead"):
        columns[f"{name}_change"] = np.where(same, second[name] - first[name], np.nan)
    if even:
        columns = _mirrored(columns, searched, spots)
    attributes = {
        "player": json.dumps(model.identity()),
        **made,
        "scene": describe_scene(engine, values),
        "parameters": json.dumps(values),
        "step": float(step),
        "shots": count,
        "confidence": level,
        "seed": str(seed),
        "interval": "of the simulation alone: fresh shots, other than those of the search",
    }
    data = {name: ("place", one, _described(name)) for name, one in columns.items()}
    places = {n: ("place", spots[:, k], _described(n)) for k, n in enumerate("xy")}
    return xr.Dataset(data, places, attributes)


def _described(name: str) -> dict[str, str]:
    """Return unit and description of a variable of the dataset."""
    of = name.removesuffix("_change")
    label = _LABELS.get(of) or VARIABLES[of].label
    if of != name:
        label = f"{label}: that of a second search less this"
    return {"units": VARIABLES[of].unit if of in VARIABLES else "1", "long_name": label}


def court_places(step: float, parameters: ParameterValues) -> Floats:
    """Return places of the half court, x and y, (n, 2), m, a step apart, the middle among them.

    Parameters
    ----------
    step
        The distance of neighbours, m.
    parameters
        Parameters of the hoop by name, SI.

    Raises
    ------
    ValueError
        If the step is not from 0.5 to 3 m.
    """
    apart = as_number("step", step, "a distance from 0.5 to 3 m")
    if not 0.5 <= apart <= 3.0:
        raise ValueError(f"step: expected a distance from 0.5 to 3 m, got {step}")
    court = find_court(None, parameters)
    across = int(court.half_width / apart - 0.5)
    y, x = np.meshgrid(apart * np.arange(-across, across + 1), apart * np.arange(20))
    spots = np.stack([x.ravel(), y.ravel()], axis=1)
    away = np.hypot(*spots.T)
    return np.asarray(spots[(away >= _NEAREST) & (away <= _FURTHEST)])


def _with_aim(dataset: xr.Dataset, engine: Engine, parameters: Mapping[str, float]) -> xr.Dataset:
    """Return the results with how far past the ring's centre the ball comes down, m."""
    released = {name: dataset[name].values for name in ARGUMENTS}
    states = release(**released)
    _, landed = engine.fall(states, 0.0, parameters)
    reach = hypotenuse(*(landed[..., k] - states[..., k] for k in (0, 1)))
    return dataset.assign(aim=(dataset["speed"].dims, reach - released["distance"]))


def _best(dataset: xr.Dataset, chosen: xr.Dataset) -> dict[str, Floats]:
    """Return the results of one search, of the way that is better in another search."""
    which = np.argmax(chosen["probability"].values, axis=0)
    names = ("speed", "elevation", "azimuth", "aim", "probability", "low", "high")
    columns = {n: np.take_along_axis(dataset[n].values, which[None], axis=0)[0] for n in names}
    bank = which == WAYS.index("bank")
    lead, low, high = (dataset[f"difference{end}"].values for end in ("", "_low", "_high"))
    return columns | {
        "bank": bank,
        "lead": np.where(bank, lead, -lead),
        "lead_low": (least := np.where(bank, low, -high)),
        "lead_high": np.where(bank, high, -low),
        "decided": least > 0.0,
    }


def _mirrored(columns: dict[str, Floats], searched: Floats, spots: Floats) -> dict[str, Floats]:
    """Return the columns at all places; to the left of the middle a shot is the mirror image."""
    rows = {(x, y): row for row, (x, y) in enumerate(searched.tolist())}
    order = np.array([rows[x, abs(y)] for x, y in spots.tolist()])
    whole = {name: one[order] for name, one in columns.items()}
    whole["azimuth"] = np.where(spots[:, 1] < 0.0, -whole["azimuth"], whole["azimuth"])
    return whole
