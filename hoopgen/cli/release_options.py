"""Options of releases: the release aimed at and its scatter, or measured releases."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import click

from hoopgen.hoop.court_places import find_place
from hoopgen.hoop.variables import change_variables
from hoopgen.simulation.lookup import BUILT_IN
from hoopgen.study.questions.settings import MeasuredReleases

from .messages import echo_lines
from .options import (
    VARIABLE_HELP,
    instrument_option,
    override_option,
    reading_options,
    scene_options,
    variable_option,
)
from .path_types import FILE
from .place_option import PLACE, place_option
from .question_options import setting_options, together
from .scene_option import engine_of, given, own_needs, own_options, state_given, state_is_given
from .shot_files import (
    READING,
    names_table,
    option_of,
    reading_of,
    simulation_options,
    with_its_scene,
)
from .types import CORRELATION, DEVIATION, once

if TYPE_CHECKING:
    from hoopgen.simulation.engine import Engine
    from hoopgen.study.models.fitted_scatter import FittedScatter, FittedScatters
    from hoopgen.study.models.resample import Resample
    from hoopgen.study.models.scatter import Scatter
    from hoopgen.study.tables.invalid_rows import InvalidRows
    from hoopgen.study.tables.reading import Interpreted, ReadingOptions

_ALTERNATIVES: Mapping[str, tuple[str, ...]] = {
    "speed": ("aim", "entry"),
    "elevation": ("entry",),
    "height": (),
    "distance": ("x",),
}
"""Options that a release requires, and the alternatives to each."""

_REQUIRED: Mapping[str, str] = {
    "speed": "--speed (or --aim)",
    "elevation": "--elevation (or --entry)",
    "distance": "--distance (or --place, or --x and --y)",
}
"""Texts of those that have alternatives."""


def release_needs(typed: Mapping[str, Any]) -> list[str]:
    """Return the missing options of a release, at a hoop or in any scene, without ``--from``."""
    if "file" in typed or "override" in typed:
        return []  # a file says it; without one, that is said first
    varied = {text.partition("=")[0].strip() for text in typed.get("over", ())}
    if typed.get("scene_name", "hoop") not in BUILT_IN:
        return own_needs(typed, varied)
    if state_is_given(typed):
        return []  # of a shot in a scene of one's own, which is said first
    known = {*typed, *varied}
    return [
        _REQUIRED.get(name, f"--{name}")
        for name, others in _ALTERNATIVES.items()
        if not known.intersection((name, *others))
    ]


def place_needs(typed: Mapping[str, Any]) -> list[str]:
    """Return the missing options of the places from which both kinds of shots are searched."""
    searched = {"over": ("speed", "elevation"), **({"distance": ""} if "places" in typed else {})}
    return release_needs({**typed, **searched})


@dataclass(frozen=True)
class Releasing:
    """The releases that the options describe."""

    values: Mapping[str, float]  # variables of the release that were given, SI
    sd: Mapping[str, float]  # their standard deviations, --scatter
    correlation: Mapping[tuple[str, str], float]
    parameters: Mapping[str, float]
    engine: Engine
    measured: Mapping[str, Any] = field(default_factory=dict)  # columns of --from
    group: Sequence[str | None] | None = None  # label of each row, --group
    fitted: bool = False  # a scatter is fitted to the columns, --fitted
    errors: Mapping[str, Any] = field(default_factory=dict)  # of the measurement: variances
    file: Path | None = None  # the table of the columns

    def fit(self) -> FittedScatter[Scatter] | FittedScatters[Scatter]:
        """Return the scatter fitted to the measured releases; with labels, of each player."""
        from hoopgen.study.models.scatter import Scatter

        columns: dict[str, Any] = {**self.measured, **self.values}
        errors: Any = self.errors
        with names_table("--fitted", self.file):
            return Scatter.fit(columns, self.group, errors)

    def model(
        self, changes: Mapping[str, float] = MappingProxyType({}), over: Iterable[str] = ()
    ) -> tuple[Scatter | Resample, Mapping[str, float]]:
        """Return the release model, of measured releases where there are some, and the scene.

        `changes` may hold variables and parameters of the scene. The components of a state that
        vary `over` some values are left out.

        Parameters
        ----------
        changes
            Variables and parameters of the scene in place of those of the options, SI.
        over
            Names of variables that a map or a search varies; components of a state among them are
            left out of the model.

        Returns
        -------
        tuple
            The model, and the parameters of the scene by name.

        Raises
        ------
        click.UsageError
            If options contradict each other or one is missing.
        """
        from hoopgen.study.models.fitted_scatter import FittedScatters
        from hoopgen.study.models.resample import Resample
        from hoopgen.study.models.scatter import Scatter

        over = tuple(over)
        values = {**self.measured, **self.values}
        if self.engine.has_hoop and (twice := [name for name in over if given(name)]):
            raise click.UsageError(f"--{twice[0]} and --over {twice[0]}: leave one out")
        if self.engine.has_hoop:
            values = change_variables(values, changes)
        else:
            varied = set() if self.measured else set(over)
            values = {n: v for n, v in (values | dict(changes)).items() if n not in varied}
        scene = dict(self.parameters)
        scene |= {name: values.pop(name) for name in scene if name in changes}
        if self.fitted:
            found = self.fit()
            if isinstance(found, FittedScatters):
                raise click.UsageError(
                    "--fitted with --group gives a scatter for each player, which only estimate "
                    "takes, without --versus and --solve; choose one by --where 'player == Ann'"
                )
            known = {n: v for n, v in changes.items() if n not in scene}
            moved = change_variables(found.model.release, known | dict.fromkeys(over, 0.0))
            moved = {name: value for name, value in moved.items() if name not in over}
            return replace(found.model, release=moved), scene
        if self.measured:
            return Resample(values, self.group), scene
        return Scatter(values, self.sd, self.correlation), scene

    def read(
        self,
        file: Path,
        reading: ReadingOptions,
        asked: Mapping[str, Any],
        override: bool,
        group: str | None = None,
    ) -> tuple[Releasing, Interpreted, InvalidRows]:
        """Return this with the values of a file, its interpretation, and its invalid rows.

        The column `group` has the labels of the rows' groups.

        Parameters
        ----------
        file
            The table of measured releases.
        reading
            The format, columns and rows that the options ask for.
        asked
            `parameters` and `max_contacts`, as `simulation_options` gives them.
        override
            True if options may contradict the file.
        group
            The name of the column with the labels of the rows' groups; None for no groups.

        Returns
        -------
        tuple
            The values with those of the file, its interpretation, and its invalid rows.

        Raises
        ------
        click.UsageError
            If ``--scatter`` is given, too.
        ValueError
            If the table cannot be read as releases; the message names the column.
        """
        from hoopgen.study.models.measured_columns import measuring_errors

        if self.sd:
            raise click.UsageError(
                "--scatter is about a release, and --from has many; leave one out"
            )
        source, labels = reading.source(file), None
        if group is not None:
            labels = source.labels(source.whole(), group)
            reading = replace(reading, own=(*reading.own, group))
        release = dict(self.values)
        if (place := click.get_current_context().meta.get(PLACE)) is not None:
            # The table may name its scene, and with it another rule book.
            from hoopgen.study.tables.provenance import origin_of

            origin = None if override else origin_of(source, self.engine)
            named = self.parameters if origin is None else origin.parameters
            release |= find_place(place, asked.get("parameters") or named).variables
        table = reading.interpreted(
            source, release=release, **asked, override=override, scene=self.engine
        )
        measured, invalid = table.measured(source)
        scene, values = table.origin.parameters, table.origin.release
        of_table = table.error_variances(source)
        errors = measuring_errors({**measured, **values}, of_table, self.errors)
        model = replace(self, values=values, parameters=scene, measured=measured, group=labels)
        return replace(model, file=file, errors=errors), table, invalid


_FROM = together(
    click.option(
        "--from",
        "file",
        type=FILE,
        is_eager=True,
        callback=with_its_scene,
        help="Draw from measured releases, .csv, .parquet, .arrow or .xlsx; the options above fill "
        "in.",
    ),
    setting_options(MeasuredReleases, only="group"),
    setting_options(MeasuredReleases, only="fitted"),
    instrument_option(", with --fitted"),
    override_option,
    reading_options,
)


def from_option(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--from``, measured releases in place of scatter; below `release_options`.

    Releases of a file of results are simulated in its scene and to its limit of contacts.
    """

    @functools.wraps(command)
    def collected(
        *arguments: Any,
        releasing: Releasing,
        file: Path | None,
        group: str | None,
        fitted: bool,
        instrument: Mapping[str, float],
        override: bool,
        **options: Any,
    ) -> Any:
        reading_values = {name: options.pop(name) for name in READING}
        if instrument and not fitted:
            raise click.UsageError("--instrument: it is of --fitted; leave it out, or give both")
        errors = {name: sd**2 for name, sd in instrument.items()}
        releasing = replace(releasing, fitted=fitted, errors=errors)
        if file is None:
            if group is not None:
                raise click.UsageError("--group: it is a column of --from; leave it out")
            if fitted:
                raise click.UsageError("--fitted: there are no measured releases; give --from")
            if override:
                raise click.UsageError("--override: there is no file of results; leave it out")
            stray = [name for name, value in reading_values.items() if value]
            if stray:
                raise click.UsageError(f"{option_of(stray[0])}: there is no table; give --from")
            return command(*arguments, releasing=releasing, **options)
        reading = reading_of(reading_values)
        asked, assumption = simulation_options(releasing.engine, file, reading)
        releasing, table, invalid = releasing.read(file, reading, asked, override, group)
        if "max_contacts" in options:
            options["max_contacts"] = table.origin.max_contacts
        result = command(*arguments, releasing=releasing, **options)
        lines = f"\n{table.interpretation}\n{invalid}"
        if fitted:
            known = ", ".join(f"{n} (given)" if n in errors else n for n in releasing.errors)
            lines += f"\nmeasuring errors: {known or 'none known, so the spread contains them'}"
        echo_lines(lines, err=bool(options.get("as_json")))
        if assumption:
            click.echo(assumption, err=True)
        return result

    decorated: Callable[..., Any] = _FROM(collected)
    return decorated


def release_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options of a release, its scatter and the scene; give `releasing` to the command."""

    @functools.wraps(command)
    def collected(*arguments: Any, parameters: Mapping[str, float], **options: Any) -> Any:
        engine = engine_of()
        variables = {name: options.pop(name) for name in VARIABLE_HELP}
        state = {name: options.pop(name, None) for name in ("position", "velocity", "spin")}
        if engine.has_hoop:
            values = {name: value for name, value in variables.items() if value is not None}
        else:
            values = state_given(tuple(variables), state)
        sd, correlation = options.pop("scatter"), options.pop("correlation")
        releasing = Releasing(values, sd, correlation, parameters, engine)
        return command(*arguments, releasing=releasing, **options)

    variables = map(variable_option, VARIABLE_HELP)
    options = (*variables, place_option, own_options, *_SCATTER, scene_options)
    decorated: Callable[..., Any] = together(*options)(collected)
    return decorated


_SCATTER = (
    click.option(
        "--scatter",
        type=DEVIATION,
        multiple=True,
        callback=once,
        help="Standard deviation of a variable, speed=0.07, elevation=1.3deg; may be repeated.",
    ),
    click.option(
        "--correlation",
        type=CORRELATION,
        multiple=True,
        callback=once,
        help="Correlation of two variables that scatter, speed,elevation=-0.3; may be repeated.",
    ),
)
