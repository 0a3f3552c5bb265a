"""Shots thrown in one setting or in two: tallied in chunks, until their number or a precision."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from math import ceil, sqrt
from os import PathLike
from typing import Any, TypeAlias

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.brief import brief
from hoopgen.engines import HOOP, Engine
from hoopgen.inputs import Backend, check_count
from hoopgen.results import Outcome, Shots
from hoopgen.scenes import engine_of, variables_of
from hoopgen.simulation import simulate
from hoopgen.sizes import in_short
from hoopgen.variables import STATE, Releases, is_state

from .chunks import Rest, run
from .grid import Grid
from .intervals import least_shots
from .measures import MEASURES
from .models import ReleaseModel
from .rebounds import CATCHING_HEIGHT, caught_at
from .resample import Resample
from .sample import Rows, thrown_rows
from .scatter import Scatter
from .spread import counts_of
from .tallies import Tally, blocks, check_scene, check_share, fields_of, width_of

__all__ = [
    "CHUNK",
    "Progress",
    "Setting",
    "Until",
    "Work",
    "check_states",
    "chunks_of",
    "flown",
    "most_shots",
    "outcome_by",
    "scene_identity",
    "setting_of",
    "tally_of",
]

CHUNK = 1 << 17
"""Shots in a chunk: after each one the precision is looked at, and a folder has one file."""

SHOTS = 100_000
"""Without a precision."""

MOST = 1_000_000_000
"""With a precision."""

Setting: TypeAlias = ReleaseModel | tuple[ReleaseModel, Mapping[str, Any]]
"""A release model in the article's scene, or with parameters of its own."""

Progress = Callable[[int, int | None], None]


@dataclass(frozen=True)
class _Set:
    """A release model, and its scene with the parameters."""

    model: ReleaseModel
    parameters: Mapping[str, float]
    scene: Engine

    def identity(self) -> dict[str, Any]:
        parameters = dict(self.parameters)
        return {**self.model.identity(), "parameters": parameters, **scene_identity(self.scene)}


def scene_identity(scene: Engine) -> dict[str, Any]:
    """Return what an identity has of a scene: nothing of the article's, which has always been."""
    return {} if scene is HOOP else {"scene": scene.identity}


@dataclass(frozen=True)
class Work:
    """A job of `chunks.run`: the tallies of one or two settings, and how their shots pair.

    How many shots there are only cuts the last chunk, so that a folder can be asked for more.

    Attributes
    ----------
    by
        The outcome by which they pair.
    measures
        Names of those of which it is counted, of one setting, how they are spread.
    catching_height
        Of rebounds.
    """

    settings: tuple[_Set, ...]
    shots: int
    seed: int
    max_contacts: int
    backend: Backend
    by: int = Outcome.MADE
    measures: tuple[str, ...] = ()
    catching_height: float = CATCHING_HEIGHT

    @property
    def scene(self) -> Engine:
        """In which the settings are thrown."""
        return self.settings[0].scene

    @property
    def chunks(self) -> int:
        """How many."""
        return chunks_of(self.shots)

    def identity(self) -> dict[str, Any]:
        """Return what the chunks depend on."""
        return {
            # First, so that what differs names it.
            **scene_identity(self.scene),
            "settings": [setting.identity() for setting in self.settings],
            "seed": self.seed,
            "max_contacts": self.max_contacts,
            **({} if self.by == Outcome.MADE else {"by": int(self.by)}),
            **({"measures": list(self.measures)} if self.measures else {}),
            **caught_at(self.measures, self.catching_height),
        }

    def compute(self, chunk: int) -> pa.Table:
        """Return the numbers of a chunk: one row."""
        return self.counted(*self._shots_of(chunk))

    def rest(self, chunk: int, kept: pa.Table) -> Rest | None:
        """Return what goes on with a chunk that has fewer shots, or counts fewer of them."""
        start, stop = self._shots_of(chunk)
        numbers = kept["numbers"][0].values.to_numpy()
        there = start + int(tally_of(numbers, 0, self.scene).shots)
        if there == stop:
            return None
        if there > stop:
            return Rest(partial(self.counted, start, stop), more=False)
        return Rest(partial(self.counted, there, stop, numbers), more=True)

    def _shots_of(self, chunk: int) -> tuple[int, int]:
        """Return the first shot of a chunk, and the one after its last."""
        start = chunk * CHUNK
        return start, min(start + CHUNK, self.shots)

    def counted(self, start: int, stop: int, before: NDArray[np.int64] | None = None) -> pa.Table:
        """Return the numbers of some shots, and of those before them."""
        counts = [self.count(*block) for block in blocks(start, stop)]
        total = np.sum(counts if before is None else [before, *counts], axis=0)
        return pa.table({"numbers": pa.array([total], pa.list_(pa.int64()))})

    def count(self, start: int, stop: int) -> NDArray[np.int64]:
        """Return the tally of each setting, and of two the pairs, of some shots."""
        thrown = [self._simulate(setting, start, stop) for setting in self.settings]
        results = [shots for _, shots in thrown]
        rows = [Tally.of(shots, 1).row()[0] for shots in results]
        rows += [self._pairs(*results)] if len(results) == 2 else []
        if self.measures:
            rows.append(counts_of(*thrown[0], self.measures, self.catching_height))
        return np.concatenate(rows)

    def rows(self, which: int, threads: int | None) -> Rows | None:
        """Return what becomes of each measured release of a setting; None of another model."""
        setting = self.settings[which]
        if not isinstance(setting.model, Resample):
            return None
        return thrown_rows(
            setting.model,
            setting.parameters,
            setting.scene,
            self.max_contacts,
            self.backend,
            threads,
            self.measures,
            self.catching_height,
        )

    def _simulate(self, setting: _Set, start: int, stop: int) -> tuple[Releases, Shots]:
        releases = setting.model.draw(start, stop, self.seed, setting.parameters)
        contacts, scene = self.max_contacts, setting.scene
        return releases, flown(releases, contacts, self.backend, scene, self.measures)

    def _pairs(self, first: Shots, second: Shots) -> NDArray[np.int64]:
        """Return how many pairs end so both, the first only, the second only, neither."""
        outcomes = np.stack([first.outcome, second.outcome])
        invalid = self.scene.outcomes["INVALID"]
        others = (outcomes != self.by)[:, (outcomes != invalid).all(axis=0)]
        return np.bincount(2 * others[0] + others[1], minlength=4)


def chunks_of(shots: int) -> int:
    """Return in how many chunks so many shots are."""
    return -(-shots // CHUNK)


def flown(
    releases: Releases,
    max_contacts: int,
    backend: Backend,
    scene: Engine,
    measures: Sequence[str] = (),
) -> Shots:
    """Simulate releases, as far as a tally and measures need it; the chunks have the threads."""
    needed = {*fields_of(scene), *(field for name in measures for field in MEASURES[name].fields)}
    return simulate(
        releases.states,
        releases.parameters,
        scene=scene,
        max_contacts=max_contacts,
        backend=backend,
        threads=1,
        fields=sorted(needed),
    )


@dataclass(frozen=True)
class Until:
    """Sums chunks in their order until the precision is reached."""

    precision: float | None
    half_width: Callable[[NDArray[np.int64]], float]
    progress: Progress | None

    def total(
        self,
        work: Work,
        folder: str | PathLike[str] | None,
        scheduler: str | None,
        threads: int | None,
    ) -> NDArray[np.int64]:
        """Return the sum of as many chunks as it takes."""
        total = work.count(0, 1) * 0  # what is wrong shows before a folder is made
        note = self.progress or (lambda done, of: None)
        note(0, None if self.precision else work.chunks)
        tables = run(work, folder, scheduler=scheduler, threads=threads)
        with closing(tables):
            for done, table in enumerate(tables, 1):
                total += table["numbers"][0].values.to_numpy()
                needed = self._needed(done, total, work)
                note(done, needed)
                if done == needed:
                    break
        return total

    def _needed(self, done: int, total: NDArray[np.int64], work: Work) -> int:
        """Return how many chunks it will take, as far as can be told."""
        most = work.chunks
        if self.precision is None:
            return most
        tallies = (tally_of(total, which, work.scene) for which in range(len(work.settings)))
        if done == 1 and not all(tally.valid for tally in tallies):
            raise ValueError(
                f"model: none of the first {CHUNK:,} shots is valid, so no precision is reached: "
                "they are not finite, start inside a surface, or have parameters out of range"
            )
        # The width falls with the square root of the shots.
        half_width = self.half_width(total)
        if half_width <= self.precision:
            return min(most, done)
        # More than all: the quotient of doubles may be larger than any.
        if half_width >= self.precision * sqrt(most / done):
            return most
        return min(most, max(done + 1, ceil(done * (half_width / self.precision) ** 2)))


def tally_of(total: NDArray[np.int64], which: int, scene: Engine) -> Tally:
    """Return the tally of one setting."""
    columns = width_of(scene)
    return Tally.read(total[which * columns : (which + 1) * columns], scene)


def setting_of(
    model: ReleaseModel, parameters: Mapping[str, Any] | None, scene: Any = None
) -> _Set:
    """Return a setting; refuse a model that does not draw at random, or not in this scene."""
    if isinstance(model, Grid) or not isinstance(model, ReleaseModel):
        raise TypeError(
            "model: expected a Scatter, a Resample, or what else draws at random (it has draw and "
            f"identity), got {brief(model)}"
        )
    engine = engine_of(scene)
    check_states(model, engine)
    return _Set(model, check_scene(parameters, engine), engine)


def check_states(model: Any, scene: Engine, over: Iterable[str] = ()) -> None:
    """Refuse releases at a hoop in a scene that has none.

    Parameters
    ----------
    over
        Variables that are given apart from the model.

    Raises
    ------
    ValueError
        If they are; or a parameter of the scene has a name that a study cannot use.
    """
    variables_of(scene)
    if scene.has_hoop or not isinstance(model, Scatter | Resample):
        return
    if not (model.is_state or is_state(over)):
        raise ValueError(
            f"model: the scene {scene.name} has no hoop at which shots are released; give states, "
            f"{' '.join(STATE)}, and what scatters of them"
        )


def outcome_by(scene: Engine, by: str | None) -> int:
    """Return the outcome that counts: made, or in a scene of one's own an end, the first one.

    Raises
    ------
    ValueError
        If the scene has no such end.
    """
    ends: tuple[str, ...] = scene.kernels.ENDS
    if not ends:
        raise ValueError(f"by: the scene {scene.name} has no ends, so none can count")
    if by is None:
        return 0
    if by not in ends:
        raise ValueError(f"by: expected {' or '.join(ends)}, got {brief(by)}")
    return ends.index(by)


def most_shots(
    shots: int | None, precision: float | None, level: float, *, paired: bool = False
) -> int:
    """Return the number of shots, or the most of them.

    Raises
    ------
    ValueError
        If one is not as described for `estimate`, or that precision cannot be reached.
    """
    if precision is not None:
        check_share("precision", precision)
    if shots is not None:
        return check_count("shots", shots)
    if precision is None:
        return SHOTS
    if (least := least_shots(precision, level, paired=paired)) > MOST:
        raise ValueError(
            f"precision: {precision} takes {in_short(least)} shots at least, whatever becomes of "
            f"them, and no more than {in_short(MOST)} are thrown unless shots says so"
        )
    return MOST
