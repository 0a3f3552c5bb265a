"""A player throws candidates with common random numbers: what differs is the release alone."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from math import nan
from typing import Any, Literal

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.parameters import complete
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import check_names
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.hoop.presets import NAMES, PAPER
from hoopgen.hoop.variables import ARGUMENTS, VARIABLES, check_angles, release_arguments
from hoopgen.results.shots import SURFACES, Outcome, Shots
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.simulate import simulate
from hoopgen.study.models.resample import EachRow, Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.intervals import newcombe_interval
from hoopgen.study.statistics.tally import check_scene
from hoopgen.text.shorten import brief

from .monte_carlo import outcome_by
from .task_runner import TaskRunner, run_serially

Bounds = tuple[float, float]
"""Bounds of a variable: low, high."""

By = Literal["any", "direct", "bank"]

BY: Mapping[str, str] = {
    "any": "made",
    "direct": "made, the board not touched first",
    "bank": "made, the board touched first",
}
"""The definitions of success."""

WAYS_IN = ("swish", "rim", "bank")
"""Ways in which a made shot goes in: it touches nothing, the ring or the bridge first, the board
first."""

_BACKBOARD = SURFACES.index("backboard")

TASK = 1 << 14
"""Shots of a task: some hundredths of a second."""


@dataclass(frozen=True)
class Successes:
    """The successes among shots.

    Attributes
    ----------
    kind
        Of single shots, where there is a hoop: the `Kind` of each.
    """

    made: NDArray[Any]  # how many succeeded, or of single shots which did
    valid: NDArray[Any]  # how many could be simulated, or which. An invalid shot is no trial
    kind: NDArray[np.uint8] = field(default_factory=lambda: np.zeros(0, np.uint8))

    @property
    def share(self) -> NDArray[np.float64]:
        """Share of the valid shots that succeeded; NaN if there are none."""
        share = np.full(self.valid.shape, np.nan)
        np.divide(self.made, self.valid, out=share, where=self.valid > 0)
        return share


@dataclass(frozen=True)
class Player:
    """A scatter, the scene, and what counts.

    Attributes
    ----------
    model
        How shots lie about a candidate; without scatter it is one shot.
    parameters
        Of the scene, one number each.
    by
        One of `BY`; where there is no hoop, an end of the scene.
    runner
        Runs the tasks that simulate.
    scene
        The scene itself.
    moving
        Velocity of the place of the releases in the scene's x and y, m/s, added to theirs.

    Raises
    ------
    TypeError, ValueError
        If one is not as described.
    """

    model: Scatter | Resample = field(default_factory=lambda: Scatter({}))
    parameters: Mapping[str, Any] = field(default_factory=lambda: PAPER)
    by: str = "any"
    runner: TaskRunner = field(default=run_serially, compare=False)
    scene: Engine = HOOP
    moving: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        if not self.scene.has_hoop:
            outcome_by(self.scene, self.by)
        elif self.by not in BY:
            raise ValueError(f"by: expected {', '.join(BY)}, got {brief(self.by)}")
        check_scene(self.parameters, self.scene)
        object.__setattr__(self, "parameters", complete(self.parameters, self.scene.table))

    def at(self, values: Mapping[str, float]) -> Player:
        """Return the player in the scene whose parameters are among the values, or as they were."""
        scene = {name: value for name, value in values.items() if name in self.parameters}
        return replace(self, parameters={**self.parameters, **scene})

    def sampled(self, values: Mapping[str, ArrayLike], shots: int, seed: int = 0) -> Successes:
        """Return the numbers of successes and of valid shots among the first shots of a seed.

        Parameters
        ----------
        values
            Variables of the candidates, one number or (m,).

        Returns
        -------
        Successes
            Counts, (m,). The shots of each are those that the model's `draw` gives; of an
            `EachRow` no more than it has.
        """
        shots = self._at_most(shots)
        given = {name: np.atleast_1d(as_doubles(name, value)) for name, value in values.items()}
        names, columns = tuple(given), np.broadcast_arrays(*given.values())
        count, many = columns[0].size, min(shots, TASK)
        few = TASK // many
        worker, work = replace(self, runner=run_serially), []
        for low in range(0, count, few):
            some = {n: c[low : low + few] for n, c in zip(names, columns, strict=True)}
            work += [
                partial(worker.count, some, start, min(start + many, shots), seed)
                for start in range(0, shots, many)
            ]
        # One alone is done in less time than it takes to keep it.
        tables = self.runner(work) if len(work) > 1 else run_serially(work)
        total = np.zeros((2, count), np.int64)
        blocks = len(range(0, shots, many))
        for place, table in enumerate(tables):
            low = place // blocks * few
            counts = [table[name].to_numpy() for name in ("made", "valid")]
            total[:, low : low + few] += np.stack(counts)
        return Successes(*total)

    def count(
        self, values: Mapping[str, NDArray[np.float64]], start: int, stop: int, seed: int
    ) -> pa.Table:
        """Return successes and valid shots among shots `start` to `stop` - 1 of candidates (m,).

        Parameters
        ----------
        values
            The variables of the candidates, (m,) each.
        start, stop
            The number of the first shot, and of the one after the last.
        seed
            The seed of the random numbers, common to all candidates.

        Returns
        -------
        Table
            A row for each candidate, with the columns "made" and "valid".
        """
        made, valid = self._judged(self._simulated(values, start, stop, seed))
        counts = [one.reshape(-1, stop - start).sum(axis=-1) for one in (made, valid)]
        return pa.table(dict(zip(("made", "valid"), counts, strict=True)))

    def scored(self, values: Mapping[str, float], shots: int = 1, seed: int = 0) -> Successes:
        """Return which shots of one candidate succeed, which are valid, their kinds, (shots,).

        Parameters
        ----------
        values
            The variables of the candidate, one number each.
        shots
            The number of shots; of measured releases at most all of them.
        seed
            The seed of the random numbers.
        """
        shots = self._at_most(shots)
        blocks = [
            self._scored(values, start, min(start + TASK, shots), seed)
            for start in range(0, shots, TASK)
        ]
        columns = [(one.made, one.valid, one.kind) for one in blocks]
        return Successes(*map(np.concatenate, zip(*columns, strict=True)))

    def tally(
        self, values: Mapping[str, float], shots: int, seed: int = 0
    ) -> tuple[Successes, dict[str, int]]:
        """Return the numbers of one candidate's successes, valid shots, and successes by kind.

        The ways are those of `ways_of`; there are none without a hoop.

        Parameters
        ----------
        values, shots, seed
            As for `scored`.

        Returns
        -------
        tuple
            The two numbers, and the numbers of successes by the names of the ways.
        """
        worker, shots = replace(self, runner=run_serially), self._at_most(shots)
        starts = range(0, shots, TASK)
        work = [
            partial(worker.count_task, values, one, min(one + TASK, shots), seed) for one in starts
        ]
        total = pa.concat_tables(self.runner(work) if len(work) > 1 else run_serially(work))
        sums = {name: int(np.sum(total[name].to_numpy())) for name in total.column_names}
        successes = Successes(np.array(sums.pop("made")), np.array(sums.pop("valid")))
        return successes, sums

    def count_task(self, values: Mapping[str, float], start: int, stop: int, seed: int) -> pa.Table:
        """Return the row of a table of what `tally` counts of shots `start` to `stop` - 1.

        Parameters
        ----------
        values
            The variables that are searched over and their values, SI.
        start, stop
            The first shot and the one after the last.
        seed
            The seed of the random numbers.

        Returns
        -------
        pyarrow.Table
            One row: the numbers of shots that succeed and that are valid, and at a hoop those made
            by each way in.
        """
        one = self._scored(values, start, stop, seed)
        found = {"made": int(one.made.sum()), "valid": int(one.valid.sum())}
        found |= ways_of(one.made, one.kind) if self.scene.has_hoop else {}
        return pa.table({name: [count] for name, count in found.items()})

    def _scored(self, values: Mapping[str, float], start: int, stop: int, seed: int) -> Successes:
        """Return which of shots `start` to `stop` - 1 succeed, are valid, and their kinds."""
        one = {name: np.atleast_1d(as_doubles(name, value)) for name, value in values.items()}
        simulated = self._simulated(one, start, stop, seed, ("counts",))
        kind = np.zeros(stop - start, np.uint8)
        if self.scene.has_hoop:
            kind = kinds(simulated.outcome, simulated.counts, simulated.first)
        return Successes(*self._judged(simulated), kind)

    def _at_most(self, shots: int) -> int:
        """Return the number of shots to simulate; of measured releases at most all, in order."""
        return min(shots, self.model.most) if isinstance(self.model, EachRow) else shots

    def _judged(self, shots: Shots) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Return which shots succeed, and which are valid."""
        if self.scene.has_hoop:
            made = shots.outcome == Outcome.MADE
            if self.by != "any":
                made &= (shots.first == _BACKBOARD) == (self.by == "bank")
        else:
            made = shots.outcome == outcome_by(self.scene, self.by)
        return made, np.asarray(shots.outcome != self.scene.outcomes["INVALID"])

    def _simulated(
        self,
        values: Mapping[str, NDArray[np.float64]],
        start: int,
        stop: int,
        seed: int,
        more: tuple[str, ...] = (),
    ) -> Shots:
        """Simulate shots `start` to `stop` - 1 of each candidate, one candidate after the other."""
        releases = self.model.around(
            {name: value[:, None] for name, value in values.items()},
            self.model.noise(start, stop, seed),
            self.parameters,
            stop - start,
        )
        states = releases.states
        if self.moving is not None:
            states = states + np.array([0.0, 0.0, 0.0, *self.moving, 0.0, 0.0, 0.0, 0.0])
        return simulate(
            states,
            releases.parameters,
            scene=self.scene,
            threads=1,
            fields=("outcome", "first", *(more if self.scene.has_hoop else ())),
        )


def ways_of(made: NDArray[np.bool_], kind: NDArray[np.uint8]) -> dict[str, int]:
    """Return the numbers of made shots that touch nothing, the board first, and others.

    Parameters
    ----------
    made
        Which count, (n,).
    kind
        The `Kind` of each, (n,).
    """
    swish, bank = kind == Kind.SWISH, np.isin(kind, (Kind.BANK, Kind.BANK_RIM))
    found = made & swish, made & ~swish & ~bank, made & bank
    return dict(zip(WAYS_IN, (int(one.sum()) for one in found), strict=True))


def paired(mine: Successes, others: Successes, confidence: float) -> tuple[float, float, float]:
    """Return by how much the share of the first shots is above that of the second, and interval.

    Of the pairs in which both are valid; the difference is NaN if there are none.

    Parameters
    ----------
    mine, others
        The results of the same random numbers, shot by shot, as of `Player.scored`.
    confidence
        The confidence of the interval.

    Returns
    -------
    tuple
        The difference of the shares, and the lower and upper end of its interval (Newcombe).
    """
    valid = mine.valid & others.valid
    first, second = mine.made[valid], others.made[valid]
    both, only_first, only_second, neither = (
        int((a & b).sum()) for a in (first, ~first) for b in (second, ~second)
    )
    difference = (only_first - only_second) / len(first) if len(first) else nan
    return difference, *newcombe_interval(both, only_first, only_second, neither, confidence)


def one_each(
    argument: str, values: Mapping[str, Any], among: Iterable[str] = VARIABLES
) -> dict[str, float]:
    """Return the values of variables, each one number.

    Parameters
    ----------
    argument
        The name of the argument, for errors.
    values
        By name.
    among
        The names that there are.
    """
    check_names(argument, values, among)
    plain = {}
    for name, value in values.items():
        number = as_doubles(f"{argument}[{name!r}]", value)
        if number.ndim:
            raise ValueError(f"{argument}[{name!r}]: expected one number, got {brief(value)}")
        plain[name] = float(number)
    check_angles(argument, plain)
    return plain


def arguments_of(
    values: Mapping[str, float], parameters: Mapping[str, float] = PAPER
) -> dict[str, float]:
    """Return variables of one release as arguments of `hoopgen.release`.

    The parameters of the scene are not taken from the values; see `Player.at`.

    Parameters
    ----------
    values
        The variables, such as `aim` and `entry`, by name.
    parameters
        Those of the scene, on which the speed for an aim depends.
    """
    own = (*NAMES, *parameters)
    given = {name: as_doubles(name, value) for name, value in values.items() if name not in own}
    columns = release_arguments(given, parameters)
    return {name: columns[name].item() for name in ARGUMENTS}
