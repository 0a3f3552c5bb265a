"""The source of a question's shots: the file's tables, and its own in place of them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import reduce
from pathlib import Path
from typing import Any

import numpy as np

from hoopgen.core.variables import is_state
from hoopgen.hoop.court_places import find_place
from hoopgen.hoop.variables import change_variables
from hoopgen.simulation.engine import Engine
from hoopgen.study.models.fitted_scatter import FittedScatter
from hoopgen.study.models.measured_columns import measuring_errors
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.questions.settings import MeasuredReleases
from hoopgen.study.tables.columns import variable_of
from hoopgen.study.tables.provenance import origin_of
from hoopgen.study.tables.reading import error_variances
from hoopgen.study.tables.source import Source
from hoopgen.text.shorten import join_names

from .scene import FILE
from .schema import Given, reading

_PLACES = ({"x", "y"}, {"distance", "angle"}, {"place"})
"""Three ways to say a place."""


@dataclass(frozen=True)
class ShotSource:
    """The source of shots; SI.

    Attributes
    ----------
    above, own
        Variables of the release aimed at: those that columns of `releases` take the place of, and
        those that take the place of columns; `place` may be among them, the name of one.
    sd, correlation
        The scatter about it, as of `Scatter`.
    """

    scene: Mapping[str, Any]  # the preset, and the parameters that differ from it
    above: Mapping[str, Any]
    own: Mapping[str, Any]
    sd: Mapping[str, float]
    correlation: Mapping[tuple[str, str], float]
    releases: MeasuredReleases | None  # measured releases; None without
    folder: Path  # that their file is relative to
    engine: Engine  # the scene itself

    @classmethod
    def from_tables(cls, given: Iterable[Given], folder: Path, engine: Engine) -> ShotSource:
        """Return the source of shots of merged tables; each key replaces the earlier ones.

        Parameters
        ----------
        given
            The tables, the outermost first, such as those of the study and then of the question.
        folder
            The folder at which relative names of files begin.
        engine
            The scene of the study.

        Returns
        -------
        ShotSource
            Its release, scatter, measured releases and parameters, SI.

        Raises
        ------
        ValueError
            If keys contradict each other; the message names them.
        """
        return reduce(ShotSource._changed, given, cls({}, {}, {}, {}, {}, None, folder, engine))

    def _changed(self, given: Given) -> ShotSource:
        correlation = {
            (one, other): value
            for one, others in given.correlation.items()
            for other, value in others.items()
        }
        kept = {
            pair: value
            for pair, value in self.correlation.items()
            if pair[::-1] not in correlation and given.scatter is not None
        }
        above, own = self.above, _change(self.own, given.release)
        if given.releases is not None:
            above, own = self.release, dict(given.release)
        return ShotSource(
            {**self.scene, **given.scene},
            above,
            own,
            {**self.sd, **given.scatter} if given.scatter is not None else {},
            {**kept, **correlation},
            given.releases or self.releases,
            self.folder,
            self.engine,
        )

    @property
    def release(self) -> dict[str, float]:
        """Return the variables of the release aimed at."""
        return placed(_change(self.above, self.own), self.parameters)

    @property
    def parameters(self) -> dict[str, float]:
        """Return those of the scene; where no preset is named, that of a file of results."""
        return self.parameters_of(None if self.releases is None else self._source(self.releases))

    def parameters_of(self, source: Source | None) -> dict[str, float]:
        """Return those of the scene of a table; what the study says comes before the table."""
        changed = {
            name: value for name, value in self.scene.items() if name not in ("preset", FILE)
        }
        if "preset" in self.scene:
            return {**self.engine.presets[self.scene["preset"]], **changed}
        origin = None if source is None else origin_of(source, self.engine)
        return {**(self.engine.parameters if origin is None else origin.parameters), **changed}

    @property
    def scatters(self) -> bool:
        """True if a deviation is above 0."""
        return any(self.sd.values())

    def model(self, over: Iterable[str] = ()) -> Scatter | Resample:
        """Return the release model, without numbers that some variables take the place of."""
        if self.releases is None:
            release = _given_without(self.release, over)
            return (
                Scatter(release, self.sd, self.correlation) if self.scatters else Scatter(release)
            )
        if self.scatters:
            raise ValueError(
                "scatter: it is about one release, and releases has many; leave one out, or give "
                'scatter = "none"'
            )
        if self.releases.instrument and not self.releases.fitted:
            raise ValueError("releases.instrument: it is of fitted = true; leave it out, or both")
        if self.releases.fitted:
            fitted = self.fit(self.releases).model
            return replace(fitted, release=_given_without(fitted.release, over))
        groups, measured = self._groups(self.releases), self._measured(self.releases)
        alike = {name: value for name, value in measured.items() if not np.ndim(value)}
        left = _given_without(alike, over)
        columns = {n: v for n, v in measured.items() if n not in alike or n in left}
        return Resample(columns, groups)

    def player(self) -> Scatter | Resample | FittedScatter[Scatter]:
        """Return the release model; of a fitted scatter with the uncertainty of the fit."""
        model = self.model()
        return self.fit(self.releases) if self.releases and self.releases.fitted else model

    def fit(self, releases: MeasuredReleases) -> FittedScatter[Scatter]:
        """Return the scatter of measured releases, without the errors of the measurement."""
        if releases.group is not None:
            raise ValueError(
                "releases.group: with fitted there is one scatter; choose a player by where"
            )
        columns = self._measured(releases)
        of_table = error_variances(self._source(releases), columns, self.engine)
        given = {name: sd**2 for name, sd in releases.instrument.items()}
        errors: Any = measuring_errors(columns, of_table, given)
        found = Scatter.fit(columns, measurement_covariance=errors)
        assert isinstance(found, FittedScatter)
        return found

    def _measured(self, releases: MeasuredReleases) -> dict[str, Any]:
        """Return the columns of measured releases, and what is the same for all."""
        source = self._source(releases)
        origin = origin_of(source, self.engine)
        shared = {} if origin is None else origin.release
        names = source.schema().names
        own = {*releases.own, *(() if origin is None else origin.passed)}
        own |= set() if releases.group is None else {releases.group}
        mapped = {**({} if origin is None else origin.columns), **(releases.columns or {})}
        spelled = {column: name for name, column in mapped.items()}
        said = {
            name: variable_of(spelled.get(name, name), self.engine)[0]
            for name in names
            if name not in own
        }
        said = {name: variable for name, variable in said.items() if variable}
        above, here = (placed(one, self.parameters) for one in (self.above, self.own))
        kept = _change(dict.fromkeys(said.values(), math.nan) | dict(shared), here)
        passed = [name for name, one in said.items() if one in here or one not in kept]
        state = is_state(said.values())
        given = {
            **({} if state else _given_without(above, kept)),
            **{name: value for name, value in shared.items() if name in kept},
            **here,
        }
        columns = source.columns(
            sorted({*own, *passed}),
            given,
            self.engine,
            {name: one for name, one in mapped.items() if one not in passed},
            implausible=releases.implausible,
        )
        return {**source.values(source.whole(), columns), **given}

    def _groups(self, releases: MeasuredReleases) -> list[str | None] | None:
        """Return the label of each measured release; None where no column says them."""
        if releases.group is None:
            return None
        source = self._source(releases)
        return source.labels(source.whole(), releases.group)

    def _source(self, releases: MeasuredReleases) -> Source:
        return reading(releases).source(self.folder / releases.file)

    def identity(self) -> dict[str, Any]:
        """Return the identity of the setting, in types that JSON knows."""
        identity = {**self.model().identity(), "parameters": self.parameters}
        if self.releases is not None and self.releases.fitted:
            identity["fitted"] = self.fit(self.releases).as_dict()
        return identity


def _change(release: Mapping[str, float], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return variables with some changed; what says the same in another way is dropped."""
    said = [way for way in _PLACES if not way.isdisjoint(changes)]
    gone = {name for way in said for other in _PLACES if other is not way for name in other}
    if is_state({*release, *changes}):
        return {**release, **changes}
    return change_variables({n: v for n, v in release.items() if n not in gone}, changes)


def placed(release: Mapping[str, Any], parameters: Mapping[str, Any]) -> dict[str, Any]:
    """Return variables with the distance and the angle of a place of the court that is named.

    Parameters
    ----------
    release
        Variables of a release and their values, SI; ``place`` may be the name of a place.
    parameters
        Parameters of the scene, whose court has the places.

    Returns
    -------
    dict
        The variables by name; without ``place``.

    Raises
    ------
    ValueError
        If there is no such place, or distance, angle, x or y are given beside it.
    """
    others = {name: value for name, value in release.items() if name != "place"}
    if "place" not in release:
        return others
    if both := [name for name in ("distance", "angle", "x", "y") if name in others]:
        raise ValueError(f"release: place says where; leave out {join_names(both)}")
    return {**others, **find_place(release["place"], parameters).variables}


def _given_without(release: Mapping[str, float], names: Iterable[str]) -> dict[str, float]:
    """Return variables without some, and without what says the same as those in another way.

    Parameters
    ----------
    release
        Variables and their values, SI.
    names
        The variables to leave out; of alternatives, such as aim and speed, the other goes, too.

    Returns
    -------
    dict
        The others, by name.
    """
    names = tuple(names)
    left = _change(release, dict.fromkeys(names))
    return {name: value for name, value in left.items() if name not in names}
