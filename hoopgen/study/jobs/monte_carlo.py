"""Shots in one setting or in two, counted in chunks."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.backend_names import BackendName
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.variables import STATE, Releases, is_state
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.results.shots import Outcome, Shots
from hoopgen.scene.lookup import SceneLike, variables_of
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.lookup import engine_of
from hoopgen.simulation.simulate import simulate
from hoopgen.study.measures.measures import MEASURES
from hoopgen.study.measures.rebounds import CATCHING_HEIGHT, caught_at
from hoopgen.study.models.grid import Grid
from hoopgen.study.models.release_model import ReleaseModel
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.models.scores import score_sums
from hoopgen.study.statistics.distributions import counts_of
from hoopgen.study.statistics.sample import Rows, sampled_rows
from hoopgen.study.statistics.tally import Tally, blocks, check_scene, fields_of, width_of
from hoopgen.text.shorten import brief

from .chunks import ShotsJob
from .differences import Differences, difference_counts, differences_in

CHUNK = 1 << 17
"""Shots in a chunk: after each one the precision is looked at, and a folder has one file."""

SHOTS = 100_000
"""Without a precision."""

SettingLike: TypeAlias = ReleaseModel | tuple[ReleaseModel, ParameterValues]
"""A release model in the article's scene, or with parameters of its own."""


@dataclass(frozen=True)
class ResolvedSetting:
    """A release model, and its scene with the parameters."""

    model: ReleaseModel
    parameters: Mapping[str, float]
    scene: Engine

    def identity(self) -> dict[str, object]:
        """Return the identity of the setting, in types that JSON knows."""
        parameters = dict(self.parameters)
        return {**self.model.identity(), "parameters": parameters, **scene_identity(self.scene)}

    def differences(self, name: str) -> Differences:
        """Return the differences by a parameter of the scene."""
        return differences_in(name, self.parameters, self.scene)


def scene_identity(scene: CompiledScene) -> dict[str, Any]:
    """Return the scene's part of an identity, which is empty for the article's scene."""
    return {} if scene is HOOP else {"scene": scene.identity}


@dataclass(frozen=True)
class MonteCarloJob(ShotsJob):
    """A job of `chunks.run`: the tallies of one or two settings, and how their shots pair.

    How many shots there are only cuts the last chunk, so that a folder can be asked for more.

    Attributes
    ----------
    measures
        Names of those of which it is counted, of one setting, how they are spread.
    gradient
        Names of the variables by which the probability of one setting is differentiated.
    """

    settings: tuple[ResolvedSetting, ...]
    shots: int
    seed: int
    max_contacts: int
    backend: BackendName
    by: int = Outcome.MADE  # the outcome by which they pair
    measures: tuple[str, ...] = ()
    catching_height: float = CATCHING_HEIGHT  # of rebounds
    gradient: tuple[str, ...] = ()

    @property
    def scene(self) -> Engine:
        """The scene of the settings."""
        return self.settings[0].scene

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return chunks_of(self.shots)

    def identity(self) -> dict[str, object]:
        """Return the identity of the chunks: everything that they depend on."""
        setting = self.settings[0]
        differences = {name: setting.differences(name).identity() for name in self.differenced}
        return {
            # First, so that what differs names it.
            **scene_identity(self.scene),
            "settings": [setting.identity() for setting in self.settings],
            "seed": self.seed,
            "max_contacts": self.max_contacts,
            **({} if self.by == Outcome.MADE else {"by": int(self.by)}),
            **({"measures": list(self.measures)} if self.measures else {}),
            **caught_at(self.measures, self.catching_height),
            **({"gradient": list(self.gradient)} if self.gradient else {}),
            **({"differences": differences} if differences else {}),
        }

    def shots_in(self, kept: pa.Table) -> int:
        """Return the number of shots of a stored chunk."""
        return int(tally_of(numbers_of(kept), 0, self.scene).shots)

    def shots_of(self, chunk: int) -> tuple[int, int]:
        """Return the first shot of a chunk, and the one after its last."""
        start = chunk * CHUNK
        return start, min(start + CHUNK, self.shots)

    def counted(
        self, chunk: int, start: int, stop: int, before: pa.Table | None = None
    ) -> pa.Table:
        """Return the numbers of some shots, one row, and of those before them.

        Parameters
        ----------
        chunk
            The number of the chunk, from 0; the numbers do not depend on it.
        start, stop
            The first shot to simulate and the one after the last.
        before
            The row of the chunk's earlier shots, which were stored; None if there are none.

        Returns
        -------
        pyarrow.Table
            One row with the column ``numbers``, a list of counts; see `numbers_of`.
        """
        counts = [self.count(*block) for block in blocks(start, stop)]
        counts += [] if before is None else [numbers_of(before)]
        return pa.table({"numbers": pa.array([np.sum(counts, axis=0)], pa.list_(pa.int64()))})

    def count(self, start: int, stop: int) -> NDArray[np.int64]:
        """Return the tally of each setting, and of two the pairs, of some shots.

        Parameters
        ----------
        start, stop
            The first shot and the one after the last.

        Returns
        -------
        array of int64
            The counts, one after the other: each setting's tally, the four of pairs, and those of
            measures, scores and differences, where they are asked for.
        """
        sampled = [self._simulate(setting, start, stop) for setting in self.settings]
        results = [shots for _, shots in sampled]
        rows = [Tally.from_shots(shots, 1).row()[0] for shots in results]
        rows += [self._pairs(*results)] if len(results) == 2 else []
        if self.measures:
            rows.append(counts_of(*sampled[0], self.measures, self.catching_height))
        if self.scored:
            model, outcome = self.settings[0].model, results[0].outcome
            assert isinstance(model, Scatter)
            valid, made = outcome != self.scene.outcomes["INVALID"], outcome == self.by
            rows.append(score_sums(model, self.scored, (start, stop), self.seed, valid, made))
        rows += [self._differences(name, start, stop) for name in self.differenced]
        return np.concatenate(rows)

    @property
    def scored(self) -> tuple[str, ...]:
        """The names of `gradient` of which the scores are summed."""
        return tuple(name for name in self.gradient if name not in self.settings[0].parameters)

    @property
    def differenced(self) -> tuple[str, ...]:
        """The names of `gradient` by which shots are differenced."""
        return tuple(name for name in self.gradient if name in self.settings[0].parameters)

    def _differences(self, name: str, start: int, stop: int) -> NDArray[np.int64]:
        """Return the counts of the differences of some shots by a parameter."""
        setting = self.settings[0]

        def moved(value: float) -> Shots:
            parameters = {**setting.parameters, name: value}
            return self._simulate(replace(setting, parameters=parameters), start, stop)[1]

        invalid = self.scene.outcomes["INVALID"]
        return difference_counts(moved, setting.differences(name), self.by, invalid)

    def rows(self, which: int, threads: int | None) -> Rows | None:
        """Return the result of each measured release of a setting; None for another model.

        Parameters
        ----------
        which
            The number of the setting, 0 or 1.
        threads
            The number of threads; None for one per processor.

        Returns
        -------
        Rows or None
            One entry for each row of the measured releases, each simulated once.
        """
        setting = self.settings[which]
        if not isinstance(setting.model, Resample):
            return None
        return sampled_rows(
            setting,
            self.max_contacts,
            self.backend,
            threads,
            self.measures,
            self.catching_height,
        )

    def _simulate(self, setting: ResolvedSetting, start: int, stop: int) -> tuple[Releases, Shots]:
        releases = setting.model.draw(start, stop, self.seed, setting.parameters)
        contacts, scene = self.max_contacts, setting.scene
        return releases, simulated(releases, contacts, self.backend, scene, self.measures)

    def _pairs(self, first: Shots, second: Shots) -> NDArray[np.int64]:
        """Return the numbers of pairs that end so in both, only first, only second, or neither."""
        outcomes = np.stack([first.outcome, second.outcome])
        invalid = self.scene.outcomes["INVALID"]
        others = (outcomes != self.by)[:, (outcomes != invalid).all(axis=0)]
        return np.bincount(2 * others[0] + others[1], minlength=4)


def numbers_of(table: pa.Table) -> NDArray[np.int64]:
    """Return the numbers of a chunk."""
    numbers: NDArray[np.int64] = table["numbers"][0].values.to_numpy()
    return numbers


def chunks_of(shots: int) -> int:
    """Return in how many chunks so many shots are."""
    return -(-shots // CHUNK)


def simulated(
    releases: Releases,
    max_contacts: int,
    backend: BackendName,
    scene: Engine,
    measures: Sequence[str] = (),
) -> Shots:
    """Simulate releases, as far as a tally and measures need it; the chunks have the threads.

    Parameters
    ----------
    releases
        The states (n, 9) and parameters of the shots.
    max_contacts
        The number of contacts after which a shot is capped.
    backend
        The engine, ``"auto"``, ``"c"``, ``"numpy"`` …
    scene
        The scene that the shots are flown in.
    measures
        Names of measures whose fields are needed, too.

    Returns
    -------
    Shots
        Of n shots, with these fields alone.
    """
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


def tally_of(total: NDArray[np.int64], which: int, scene: Engine) -> Tally:
    """Return the tally of one setting.

    Parameters
    ----------
    total
        Sums of the numbers of chunks, one tally of the scene's width after the other.
    which
        The number of the setting, 0 or 1.
    scene
        The scene, which decides how many numbers a tally has.

    Returns
    -------
    Tally
        The counts by outcome and kind of that setting.
    """
    columns = width_of(scene)
    return Tally.read(total[which * columns : (which + 1) * columns], scene)


def setting_of(
    model: ReleaseModel,
    parameters: ParameterValues | None,
    scene: SceneLike = None,
    argument: str = "model",
) -> ResolvedSetting:
    """Return a setting; refuse a model that does not draw at random, or not in this scene.

    Parameters
    ----------
    model
        The model of the releases.
    parameters
        Those that differ from the defaults of the scene; None for none.
    scene
        As for `hoopgen.estimate`.
    argument
        The argument of the model, for the error message.

    Raises
    ------
    TypeError
        If the model does not draw at random.
    ValueError
        If its releases are those of a hoop and the scene has none, or a parameter is not allowed.
    """
    if isinstance(model, Grid) or not isinstance(model, ReleaseModel):
        raise TypeError(
            f"{argument}: expected a Scatter, a Resample, or what else draws at random (it has "
            f"draw and identity), got {brief(model)}"
        )
    engine = engine_of(scene)
    check_states(model, engine)
    return ResolvedSetting(model, check_scene(parameters, engine), engine)


def check_states(model: Any, scene: Engine, over: Iterable[str] = ()) -> None:
    """Refuse releases at a hoop in a scene that has none.

    Parameters
    ----------
    over
        Variables that are given apart from the model.
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

    Parameters
    ----------
    scene
        The scene that the shots are flown in.
    by
        The name of the end that counts; None for the first one, at a hoop a made shot.

    Returns
    -------
    int
        The code of the outcome, from 0.

    Raises
    ------
    ValueError
        If the scene has no end of this name, or none at all.
    """
    ends: tuple[str, ...] = scene.kernels.ENDS
    if not ends:
        raise ValueError(f"by: the scene {scene.name} has no ends, so none can count")
    if by is None:
        return 0
    if by not in ends:
        raise ValueError(f"by: expected {' or '.join(ends)}, got {brief(by)}")
    return ends.index(by)
