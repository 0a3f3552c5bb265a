"""Bank shots against direct ones from places on the court, and where on the board they aim."""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from os import PathLike

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.extras import version
from hoopgen.core.memory import check_room
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.elementary import sine_cosine
from hoopgen.hoop.variables import ARGUMENTS, change_variables
from hoopgen.report.provenance import describe_scene, describe_setting, model_attributes
from hoopgen.scene.lookup import SceneLike, check_hoop, variables_of
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.jobs.monte_carlo import scene_identity
from hoopgen.study.jobs.objective import Bounds, By, Player, Successes, arguments_of, paired
from hoopgen.study.jobs.task_runner import task_runner
from hoopgen.study.models.random import check_two_seeds
from hoopgen.study.models.requirements import alike, scene_by_row
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.models.smoothed import smoothed
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.study.statistics.sample import difference_of_rows, share_of_rows
from hoopgen.study.statistics.tally import check_share
from hoopgen.text.numbers import format_count

from .aim_points import NOWHERE, on_board, window
from .held_out import check_folds, held_out, with_choice
from .optimum import scattering
from .search import bounds_of, search, searched_variables

WAYS: tuple[By, By] = ("direct", "bank")
"""Ways in, in the order of the results."""

_OVER = ("elevation", "aim", "azimuth")

_PLACE = 400
"""Bytes that a place takes as one of a list."""

_ENDS = {
    "touch_y_low": "lower end of y on the board",
    "touch_y_high": "upper end of y on the board",
    "touch_z_low": "lower end of the height on the board from the ring",
    "touch_z_high": "upper end of the height on the board from the ring",
}

_INTERVAL = (
    "of the simulation alone: fresh shots, other than those of the search",
    "contains the uncertainty of the sample: measured releases held out of the search",
)
"""Descriptions of the intervals: for scatter, and for measured releases."""

_SHOT = 48
"""Bytes that what became of a shot takes, both ways, until it is counted."""

Floats = NDArray[np.float64]


@check_arguments
def bank_or_direct(
    model: Scatter | Resample,
    places: ArrayLike,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    over: Mapping[str, Bounds | None] | Sequence[str] | str = _OVER,
    shots: int = 20_000,
    seed: int = 0,
    confidence: float = 0.95,
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Return the best bank shot and the best direct shot from each place, and which is better.

    Parameters
    ----------
    model
        The player, as for `optimum`; the places take the place of its own.
    places
        x and y on the floor, (n, 2), m; the ring's centre at 0, 0, the board at negative x.
    scene
        As for `optimum`: a scene with a hoop.
    parameters, over, shots, seed, confidence, threads, folder, scheduler, progress
        As for `optimum`.

    Returns
    -------
    xarray.Dataset
        Over ``way`` ("direct", "bank") and ``place``: `probability` with its Wilson interval, `low`
        and `high`, of the fresh shots that are valid; how many are `invalid`; and the release, each
        argument of `hoopgen.release`, and `aim` and what parameters were searched over. Where no
        shot tried succeeds that way, the probability is 0 and the release NaN. Of measured releases
        the shots are the rows, held out of the search as for `optimum`; then all intervals contain
        the uncertainty of the sample and how much the releases that were found differ, as those of
        `optimum` do, and the attribute ``interval`` says so.

        Over ``place``: `difference`, bank less direct, with the interval of the paired shots,
        `difference_low` and `difference_high`; where the ball of the best bank shot touches the
        board, `touch_y` and `touch_z` (m; z from the ring's height), and the range of those of its
        fresh shots that are made, nine tenths of them, `touch_y_low`, `touch_y_high`,
        `touch_z_low` and `touch_z_high`; and `sight_y` (m), where the vertical plane of its release
        meets the board.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    engine = engine_of(scene)
    check_hoop("bank_or_direct", engine)
    spots = as_doubles("places", places)
    if spots.ndim != 2 or spots.shape[1] != 2 or not len(spots):
        raise ValueError(f"places: expected x and y, shape (n, 2), got shape {spots.shape}")
    check_two_seeds(seed)
    # The end of each is kept, to pair them.
    check_room("shots", check_count("shots", shots), "shots", _SHOT)
    over = searched_variables(over)
    players = [scattering(model, over, parameters, way, engine) for way in WAYS]
    if isinstance(model, Resample):
        check_folds(model)
    question = _Question(
        players,
        model,
        over,
        check_count("shots", shots),
        seed,
        check_share("confidence", confidence),
    )
    question.try_first(*spots[0].tolist())  # what is wrong shows before a folder is made
    identity = {
        "bank": {
            "places": spots.tolist(),
            "model": model.identity(),
            "over": over if isinstance(over, Mapping) else dict.fromkeys(over),
            "parameters": players[0].parameters,
        },
        **scene_identity(engine),
        "shots": question.shots,
        "seed": seed,
    }
    with task_runner(
        identity, folder, scheduler=scheduler, threads=threads, progress=progress
    ) as together:
        question = replace(question, players=[replace(one, runner=together) for one in players])
        answers = [question.answer(x, y) for x, y in spots.tolist()]
    columns = {name: np.stack([answer[name] for answer in answers], axis=-1) for name in answers[0]}
    return _dataset(spots, columns, question)


def places_of(axes: Mapping[str, ArrayLike]) -> Floats:
    """Return every combination of distances and angles, or of x and y, as x and y, (n, 2), m."""
    if set(axes) not in ({"x", "y"}, {"distance", "angle"}):
        raise ValueError(f"places: expected distance and angle, or x and y; got {', '.join(axes)}")
    names = ("x", "y") if "x" in axes else ("distance", "angle")
    lists = [as_doubles(f"places[{name!r}]", axes[name]).ravel().tolist() for name in names]
    check_room("places", math.prod(map(len, lists)), "places", _PLACE)
    first, second = np.array(list(itertools.product(*lists))).reshape(-1, 2).T
    if "distance" in axes:
        sine, cosine = sine_cosine(second)
        first, second = first * cosine, first * sine
    return np.stack([first, second], axis=-1)


def verdict(dataset: xr.Dataset) -> tuple[NDArray[np.bool_], NDArray[np.bool_], str]:
    """Return from which places the bank shot is better, and the direct one; and it in words.

    A difference counts whose interval has no 0 in it.
    """
    better, worse = (dataset["difference_low"] > 0).values, (dataset["difference_high"] < 0).values
    places = dataset.sizes["place"]
    undecided = places - better.sum() - worse.sum()
    line = (
        f"{format_count(places, 'place')}: the bank shot is better from {better.sum()}, the direct "
        f"one from {worse.sum()}, {undecided} undecided"
    )
    return better, worse, line


@dataclass(frozen=True)
class _Question:
    """The question at each place."""

    players: Sequence[Player]
    model: Scatter | Resample
    over: Mapping[str, Bounds | None] | Sequence[str]
    shots: int
    seed: int
    confidence: float

    def try_first(self, x: float, y: float) -> None:
        """Throw a shot from a place."""
        here = {"distance": math.hypot(x, y), "angle": math.atan2(y, x)}
        player = self.players[0]
        bounds = bounds_of(self.over, {**self.model.centre, **here}, player)
        lowest = {name: low for name, (low, _) in bounds.items()}
        player.sampled({**self.model.apart()[0], **here, **lowest}, 1, self.seed)

    def answer(self, x: float, y: float) -> dict[str, Floats]:
        """Return the results of one place, (2,) for both ways or ()."""
        here = {"distance": math.hypot(x, y), "angle": math.atan2(y, x)}
        found = [self._best(player, here) for player in self.players]
        (direct, straight, by_direct), (bank, banked, by_bank) = found
        both = Successes(*np.array([[t.made.sum(), t.valid.sum()] for t in (straight, banked)]).T)
        if isinstance(self.model, Resample):
            cluster, level = self.model.cluster, self.confidence
            ends = [
                with_choice(share_of_rows(t.made, t.valid, cluster, level), shares, level)
                for _, t, shares in found
            ]
            low, high = (np.array([getattr(one, end) for one in ends]) for end in ("low", "high"))
            valid = straight.valid & banked.valid
            lead = difference_of_rows(banked.made, straight.made, valid, cluster, level)
            lead = with_choice(lead, by_bank - by_direct, level, -1.0)
            difference, least, most = lead.value, lead.low, lead.high
        else:
            low, high = wilson_interval(both.made, both.valid, self.confidence)
            difference, least, most = paired(banked, straight, self.confidence)
        own = self.players[0].parameters
        released = (*ARGUMENTS, *(name for name in self.over if name in ("aim", *own)))
        answer = {name: np.array([direct[name], bank[name]]) for name in released}
        answer |= {"probability": both.share, "low": low, "high": high}
        answer |= {"invalid": len(straight.made) - both.valid}
        single = {
            "difference": difference,
            "difference_low": least,
            "difference_high": most,
            **on_board(bank, {name: bank[name] for name in own}, self.players[0].scene),
            **{name: bank[name] for name in NOWHERE},
        }
        return answer | {name: np.asarray(value) for name, value in single.items()}

    def _best(
        self, player: Player, here: Mapping[str, float]
    ) -> tuple[dict[str, float], Successes, Floats]:
        """Return arguments and scene of the best release, and what became of fresh shots.

        And of measured releases the shares of `HeldOut.shares`; of scatter nothing, (0,).
        """
        fixed = {**self.model.apart()[0], **here}
        centre = {**self.model.centre, **here}
        bounds = bounds_of(self.over, centre, player)
        measured = self.model if isinstance(self.model, Resample) else None
        searcher = player
        if measured is not None:
            searcher = replace(player, model=smoothed(measured, self.seed))
        point, shares = search(searcher, bounds, fixed, self.shots, self.seed), np.zeros(0)
        if point is None:
            if measured is not None:
                shares = np.zeros(check_folds(measured) + 1)
            nothing = np.zeros(self.shots if measured is None else measured.rows, np.bool_)
            unknown = dict.fromkeys((*ARGUMENTS, *self.over), math.nan)
            return {**player.parameters, **unknown, **NOWHERE}, Successes(nothing, ~nothing), shares
        best = change_variables(centre, point)
        player = player.at(best)
        banked = player.by == "bank"
        touched = window(player, fixed | point, self.shots, self.seed + 1) if banked else NOWHERE
        if measured is None:
            successes = player.scored(fixed | point, self.shots, self.seed + 1)
        else:
            without = held_out(player, measured, bounds, fixed, self.shots, self.seed)
            successes = without.scored(measured, player, fixed)
            shares = without.shares(measured, player, fixed, point, self.seed)
        return (
            {**best, **player.parameters, **arguments_of(best, player.parameters), **touched},
            successes,
            shares,
        )


def _dataset(spots: Floats, columns: Mapping[str, Floats], question: _Question) -> xr.Dataset:
    named = {
        "probability": ("1", "probability of success"),
        "low": ("1", "lower end of its interval"),
        "high": ("1", "upper end of its interval"),
        "invalid": ("1", "shots that could not be simulated"),
        "difference": ("1", "probability, bank less direct"),
        "difference_low": ("1", "lower end of its interval"),
        "difference_high": ("1", "upper end of its interval"),
        "touch_y": ("m", "where the ball touches the board, y"),
        "touch_z": ("m", "where the ball touches the board, height from the ring"),
        **{name: ("m", f"of made shots, nine tenths: {said}") for name, said in _ENDS.items()},
        "sight_y": ("m", "where the release points on the board, y"),
    } | {
        name: (variable.unit or "1", variable.label)
        for name, variable in variables_of(question.players[0].scene).items()
    }
    data = {
        name: (("way", "place")[-column.ndim :], column, _attributes(*named[name]))
        for name, column in columns.items()
    }
    coordinates = {"way": list(WAYS)} | {
        name: ("place", spots[:, k], _attributes(*named[name])) for k, name in enumerate("xy")
    }
    engine, own = question.players[0].scene, question.players[0].parameters
    same, by_row = alike(question.model), scene_by_row(question.model, own)
    parameters = question.players[0].at(same).parameters
    scene = {n: v for n, v in parameters.items() if n not in (*question.over, *by_row)}
    attributes = {
        "source": f"hoopgen {version()}",
        "scene": describe_scene(engine, scene, by_row),
        "parameters": json.dumps(scene),
        "release": json.dumps({n: v for n, v in same.items() if n not in own}),
        **model_attributes(question.model.identity()),
        **_own_scene(question, engine, scene),
        "confidence": question.confidence,
        "interval": _INTERVAL[isinstance(question.model, Resample)],
        "shots": question.shots,
        "seed": str(question.seed),
    }
    return xr.Dataset(data, coordinates, attributes)


def _own_scene(
    question: _Question, engine: CompiledScene, scene: Mapping[str, float]
) -> dict[str, str]:
    """Return the attributes that a scene other than the article's is described by."""
    if engine.is_hoop:
        return {}
    said = describe_setting({**question.model.identity(), "parameters": scene}, engine)
    named = {f"said_{name}": said[name] for name in ("release", "scatter") if said.get(name)}
    return {"scene_sha256": engine.identity["sha256"], **named}


def _attributes(units: str, long_name: str) -> dict[str, str]:
    return {"units": units, "long_name": long_name}


@dataclass(frozen=True)
class Crossing:
    """The point of the floor plan that is nearest to lines.

    Attributes
    ----------
    x, y
        m.
    spread
        Root mean square distance of the lines from it, m.
    """

    x: float
    y: float
    spread: float


def crossing(start: ArrayLike, through: ArrayLike) -> Crossing:
    """Return the point where lines on the floor plan cross, by least squares of their distances.

    Parameters
    ----------
    start, through
        Two points of each line, x and y, (n, 2), m.

    Raises
    ------
    ValueError
        If the shapes are not as described, or all lines are parallel.
    """
    first, second = as_doubles("start", start), as_doubles("through", through)
    if first.ndim != 2 or first.shape[1] != 2 or first.shape != second.shape:
        raise ValueError(
            f"start, through: expected shapes (n, 2), got {first.shape} and {second.shape}"
        )
    along = second - first
    normals = np.stack([-along[:, 1], along[:, 0]], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    offsets = np.einsum("ij,ij->i", normals, first)
    solved, _, rank, _ = np.linalg.lstsq(normals, offsets)
    if rank < 2:
        raise ValueError("start, through: the lines are parallel")
    spread = np.sqrt(np.mean((normals @ solved - offsets) ** 2))
    return Crossing(float(solved[0]), float(solved[1]), float(spread))
