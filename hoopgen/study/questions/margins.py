"""Margins of a release: how far each variable may be off, and the ball still goes in."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import check_count
from hoopgen.core.variables import check_names
from hoopgen.hoop.search_range import search_range
from hoopgen.report.provenance import describe_scene
from hoopgen.report.quantities import for_json, format_range, format_variable
from hoopgen.scene.lookup import SceneLike, check_hoop, variables_of
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.jobs.monte_carlo import scene_identity
from hoopgen.study.jobs.objective import Bounds, By, Player, arguments_of, one_each
from hoopgen.study.jobs.task_runner import task_runner
from hoopgen.study.models.random import check_seed
from hoopgen.study.models.requirements import check_model
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.models.smoothed import smoothed
from hoopgen.study.result import Result
from hoopgen.study.statistics.tally import check_scene, check_share
from hoopgen.text.numbers import format_count

from .specification import MARGINS

_EXACT = (2000, 40)
"""Steps of the look to each side of the release, without scatter, and halvings of one at its end:
intervals narrower than a step may be overlooked, and ends are found to the twelfth digit of it."""

_SMOOTH = (24, 12)
"""The same with scatter, where the probability changes smoothly."""


@dataclass(frozen=True, repr=False)
class Margin(Result):
    """The range in which one variable may be off, the others as they are.

    Attributes
    ----------
    name
        The variable.
    value
        At the release; SI.
    low, high
        Ends of the connected interval about it in which the shot without scatter succeeds; NaN if
        it does not succeed itself. Inside, only the steps of the look were tried.
    elsewhere
        Further intervals in which it succeeds, from low to high: by another bounce.
    searched
        Where was looked; an end that is one of these may lie further out.
    steady
        Ends of the interval in which the probability with scatter stays within the tolerance of
        that at the release; None without scatter. It is an estimate, not a confidence interval; of
        measured releases it is that of these rows, smoothed, and others of the player give another.
    scene
        In words: the preset, and what differs from it.
    """

    name: str
    value: float
    low: float
    high: float
    elsewhere: tuple[Bounds, ...]
    searched: Bounds
    steady: Bounds | None = None
    scene: str = ""

    def __str__(self) -> str:
        return f"{self.line}; {self.scene}" if self.scene else self.line

    @property
    def line(self) -> str:
        """The margin without its scene."""
        others = format_count(len(self.elsewhere), "further interval")
        more = f", and in {others}" if self.elsewhere else ""
        return f"{self.name} {self.describe_range(self.low, self.high)}{more}"

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; SI. What is not a number is None."""
        return {name: for_json(value) for name, value in asdict(self).items()}

    def describe_range(self, low: float, high: float) -> str:
        """Return an interval as text, open where it reaches the end of the searched range.

        Parameters
        ----------
        low
            The lower end, SI and rad.
        high
            The upper end, SI and rad.
        """
        least, most = self.searched
        if math.isnan(low):
            return "does not succeed"
        if low <= least and high >= most:
            return f"anywhere from {format_range(self.name, low, high)}"
        if low <= least:
            return f"up to {format_variable(self.name, high)}"
        if high >= most:
            return f"from {format_variable(self.name, low)} up"
        return format_range(self.name, low, high)


@check_arguments
def margins(
    model: Scatter | Resample,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    names: Sequence[str] = MARGINS,
    by: By = "any",
    shots: int = 10_000,
    seed: int = 0,
    tolerance: float = 0.01,
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> dict[str, Margin]:
    """Return the margin of each variable of a release, with the others fixed.

    Parameters
    ----------
    model
        The release, and a player's scatter about it for `Margin.steady`; of a `Resample` the
        release is the mean of its columns. With `aim` in the release it is the speed that stays as
        it is when another variable is off, unless that is `aim` or `entry`.
    parameters
        Of the scene, one number each; None: the usual ones.
    scene
        A hoop: `hoopgen.HOOP`, `COURT`, `AIR` or `COURT_AIR`; None: `HOOP`.
    names
        Variables that are off.
    by
        What counts: "any" shot made, "direct" if the board is not touched first, "bank" if it is.
    shots, seed, tolerance
        Of the probability with scatter: shots for each trial, their random numbers, and how far it
        may fall.
    threads, folder, scheduler, progress
        As for `hoopgen.estimate`. How many chunks there will be is not known.

    Returns
    -------
    dict
        By name.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    check_hoop("margins", scene)
    engine = engine_of(scene)
    names = check_names("names", names, variables_of(engine))
    check_count("shots", shots)
    check_seed(seed)
    check_share("tolerance", tolerance)
    given = one_each("release", check_model(model, ()).centre, variables_of(engine))
    of_scene = check_scene(parameters, engine)
    player = Player(model.apart()[1], of_scene, by, scene=engine).at(given)
    if isinstance(model, Resample):
        player = replace(player, model=smoothed(model, seed))
    for name in names:
        _held(given, name, player.parameters)  # what is wrong shows before a folder is made
    identity = {
        "margins": {"model": model.identity(), "parameters": dict(player.parameters)},
        **scene_identity(engine),
        "names": list(names),
        "by": by,
        "shots": shots,
        "seed": seed,
        "tolerance": tolerance,
    }
    with task_runner(
        identity, folder, scheduler=scheduler, threads=threads, progress=progress
    ) as together:
        player = replace(player, runner=together)
        return margins_about(given, names, player, shots, seed, tolerance)


def margins_about(
    release: Mapping[str, float],
    names: Sequence[str],
    player: Player,
    shots: int,
    seed: int,
    tolerance: float,
) -> dict[str, Margin]:
    """Return the margins, as `margins` does, for a player in the scene of a release.

    Parameters
    ----------
    release
        The release by variable, SI and rad.
    names
        The variables whose margins are wanted.
    player
        The player, in a scene.
    shots, seed, tolerance
        As for `hoopgen.study.questions.search.flat_about`.
    """
    found = {}
    exact = replace(player, model=Scatter({}))
    for name in names:
        values = _held(release, name, player.parameters)
        line = _Line(name, values, exact, 1, 1.0, 0)
        searched = search_range(name, values[name])
        (low, high), elsewhere = line.intervals(searched, *_EXACT)
        steady = None
        if not player.model.still:
            least = player.sampled(values, shots, seed).share[0] - tolerance
            line = _Line(name, values, player, shots, least, seed)
            steady, _ = line.intervals(searched, *_SMOOTH)
        others = {k: v for k, v in exact.parameters.items() if k != name}
        scene = describe_scene(player.scene, others)
        found[name] = Margin(name, values[name], low, high, elsewhere, searched, steady, scene)
    return found


@dataclass(frozen=True)
class _Line:
    """A release along one of its variables: where enough of its shots succeed."""

    name: str
    values: Mapping[str, float]
    player: Player
    shots: int
    least: float
    seed: int

    def enough(self, at: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return, for each value, whether enough shots succeed."""
        moved: dict[str, ArrayLike] = {**self.values, self.name: at}
        return self.player.sampled(moved, self.shots, self.seed).share >= self.least

    def intervals(
        self, searched: Bounds, steps: int, halvings: int
    ) -> tuple[Bounds, tuple[Bounds, ...]]:
        """Return the interval about the release, NaN if there is none, and the others."""
        value = self.values[self.name]
        runs = self._runs(_steps(value, searched, steps), halvings)
        about = [run for run in runs if run[0] <= value <= run[1]]
        others = tuple(run for run in runs if run not in about)
        return about[0] if about else (math.nan, math.nan), others

    def _runs(self, steps: NDArray[np.float64], halvings: int) -> list[Bounds]:
        """Return the intervals in which it is enough at every step, their ends bisected."""
        enough = self.enough(steps)
        change = np.flatnonzero(enough[1:] != enough[:-1])
        # From the last that is enough to the first that is not, or the other way round.
        inside = np.where(enough[change], steps[change], steps[change + 1])
        outside = np.where(enough[change], steps[change + 1], steps[change])
        for _ in range(halvings if len(change) else 0):
            middle = (inside + outside) / 2
            is_enough = self.enough(middle)
            inside = np.where(is_enough, middle, inside)
            outside = np.where(is_enough, outside, middle)
        ends = inside.tolist()
        ends = [steps[0].item()] * bool(enough[0]) + ends + [steps[-1].item()] * bool(enough[-1])
        return list(zip(ends[::2], ends[1::2], strict=True))


def _steps(value: float, searched: Bounds, count: int) -> NDArray[np.float64]:
    """Return the values to try, the release's own among them."""
    low, high = searched
    return np.concatenate(
        [np.linspace(low, value, count, endpoint=False), np.linspace(value, high, count + 1)]
    )


def _held(
    given: Mapping[str, float], name: str, parameters: Mapping[str, float]
) -> dict[str, float]:
    """Return the release in such variables that the others stay as they are when one is off."""
    if name in ("aim", "entry") and name in given:
        return dict(given)
    values = arguments_of(given, parameters)
    if name in parameters:
        values.setdefault(name, float(parameters[name]))
    if name not in values:
        raise ValueError(f"names: {name} is no variable of this release; {', '.join(values)} are")
    return values
