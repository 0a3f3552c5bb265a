"""Studies on the command line: options that say what is shot, with what scatter, and who works."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.flown import READING, flown, reading_of, say_lines
from hoopgen.cli.options import (
    VARIABLE_HELP,
    backend_option,
    confidence_option,
    folder_option,
    max_contacts_option,
    override_option,
    reading_options,
    scene_options,
    scheduler_option,
    seed_option,
    threads_option,
    together,
    variable_option,
)
from hoopgen.cli.own import (
    engine_of,
    given,
    max_contacts_of,
    no_scene_option,
    own_needs,
    own_options,
    state_given,
    state_is_given,
)
from hoopgen.cli.types import CORRELATION, DEVIATION, FILE, once
from hoopgen.scenes import BUILT_IN

if TYPE_CHECKING:
    from hoopgen.engines import Engine
    from hoopgen.study.reading import Interpreted, Reading
    from hoopgen.study.reasons import InvalidRows
    from hoopgen.study.resample import Resample
    from hoopgen.study.scatter import Scatter

__all__ = [
    "Releasing",
    "from_option",
    "hoop_release_options",
    "place_needs",
    "release_needs",
    "release_options",
    "work_options",
]


_INSTEAD: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "speed": ("aim", "entry"),
        "elevation": ("entry",),
        "height": (),
        "distance": ("x",),
    }
)
"""What a release needs, and what may be given in its place."""

_ALTERNATIVES: Mapping[str, str] = MappingProxyType(
    {
        "speed": "--speed (or --aim)",
        "elevation": "--elevation (or --entry)",
        "distance": "--distance (or --x and --y)",
    }
)


def release_needs(typed: Mapping[str, Any]) -> list[str]:
    """Return what is missing of a release, of a hoop's or one's own scene, without ``--from``."""
    if "file" in typed or "override" in typed:
        return []  # a file says it; without one, that is said first
    varied = {text.partition("=")[0].strip() for text in typed.get("over", ())}
    if typed.get("scene_name", "hoop") not in BUILT_IN:
        return own_needs(typed, varied)
    if state_is_given(typed):
        return []  # of a shot in a scene of one's own, which is said first
    given = {*typed, *varied}
    return [
        _ALTERNATIVES.get(name, f"--{name}")
        for name, others in _INSTEAD.items()
        if not given.intersection((name, *others))
    ]


def place_needs(typed: Mapping[str, Any]) -> list[str]:
    """Return what is missing of the places from which both ways in are searched."""
    searched = {"over": ("speed", "elevation"), **({"distance": ""} if "places" in typed else {})}
    return release_needs({**typed, **searched})


@dataclass(frozen=True)
class Releasing:
    """What the options say is shot.

    Attributes
    ----------
    values
        Variables of the release that were given; SI.
    sd
        Their standard deviations, ``--scatter``.
    correlation
        Of pairs of those.
    parameters
        Of the scene.
    engine
        The scene itself.
    measured
        Columns of measured releases, ``--from``; empty without.
    group
        Label of each of them, ``--group``; None without.
    """

    values: Mapping[str, float]
    sd: Mapping[str, float]
    correlation: Mapping[tuple[str, str], float]
    parameters: Mapping[str, float]
    engine: Engine
    measured: Mapping[str, Any] = field(default_factory=dict)
    group: Sequence[str | None] | None = None

    def model(
        self, changes: Mapping[str, float] = MappingProxyType({}), over: Iterable[str] = ()
    ) -> tuple[Scatter | Resample, Mapping[str, float]]:
        """Return the release model, of measured releases where there are some, and the scene.

        Of some variables changed, the scene's parameters among them. Of a state, what is varied
        `over` some of its components is left out: they are given together.
        """
        from hoopgen.hoop.variables import change_variables
        from hoopgen.study.resample import Resample
        from hoopgen.study.scatter import Scatter

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
        if self.measured:
            return Resample(values, self.group), scene
        return Scatter(values, self.sd, self.correlation), scene

    def read(
        self,
        file: Path,
        reading: Reading,
        asked: Mapping[str, Any],
        override: bool,
        group: str | None = None,
    ) -> tuple[Releasing, Interpreted, InvalidRows]:
        """Return this with what a file says; how it is read; and its rows that are invalid.

        The column `group` has the labels of the rows' groups.
        """
        if self.sd:
            raise click.UsageError(
                "--scatter is about a release, and --from has many; leave one out"
            )
        source, labels = reading.source(file), None
        if group is not None:
            labels = source.labels(source.whole(), group)
            reading = replace(reading, own=(*reading.own, group))
        read = reading.interpreted(
            source, release=self.values, **asked, override=override, scene=self.engine
        )
        measured, invalid = read.measured(source)
        scene, values = read.origin.parameters, read.origin.release
        found = replace(self, values=values, parameters=scene, measured=measured, group=labels)
        return found, read, invalid


_FROM = together(
    click.option(
        "--from",
        "file",
        type=FILE,
        help="Draw from measured releases, .csv, .parquet, .arrow or .xlsx; the options above fill "
        "in.",
    ),
    click.option(
        "--group",
        metavar="COLUMN",
        help="With --from: the column that says which rows belong together, such as a game or a "
        "player. Intervals of the sample take groups, not rows, to be independent.",
    ),
    override_option,
    reading_options,
)


def from_option(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--from``, measured releases in place of scatter; below `release_options`.

    Results are flown in their own scene, to as many contacts as they were, where the command has
    an option of those.
    """

    @functools.wraps(command)
    def collected(
        *arguments: Any,
        releasing: Releasing,
        file: Path | None,
        group: str | None,
        override: bool,
        **options: Any,
    ) -> Any:
        said = {name: options.pop(name) for name in READING}
        if file is None:
            if group is not None:
                raise click.UsageError("--group: it is a column of --from; leave it out")
            if override:
                raise click.UsageError("--override: there is no file of results; leave it out")
            stray = [name for name, value in said.items() if value]
            if stray:
                raise click.UsageError(f"{_spelled(stray[0])}: there is no table; give --from")
            return command(*arguments, releasing=releasing, **options)
        reading = reading_of(said)
        asked, assumed = flown(releasing.engine, file, reading)
        releasing, read, invalid = releasing.read(file, reading, asked, override, group)
        if "max_contacts" in options:
            options["max_contacts"] = read.origin.max_contacts
        result = command(*arguments, releasing=releasing, **options)
        say_lines(f"\n{read.interpretation}\n{invalid}", err=bool(options.get("as_json")))
        if assumed:
            click.echo(assumed, err=True)
        return result

    decorated: Callable[..., Any] = _FROM(collected)
    return decorated


def _spelled(name: str) -> str:
    """Return an option as it is written."""
    options = click.get_current_context().command.params
    return next(option.opts[0] for option in options if option.name == name)


def release_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options of a release, its scatter and the scene; give `releasing` to the command."""
    return _release_options(command, own_options)


def hoop_release_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add those of `release_options`, for a command whose question is a hoop's."""
    return _release_options(command, no_scene_option)


def _release_options(command: Callable[..., Any], scene: Any) -> Callable[..., Any]:

    @functools.wraps(command)
    def collected(*arguments: Any, parameters: Mapping[str, float], **options: Any) -> Any:
        engine = engine_of()
        given = {name: options.pop(name) for name in VARIABLE_HELP}
        state = {name: options.pop(name, None) for name in ("position", "velocity", "spin")}
        if engine.has_hoop:
            values = {name: value for name, value in given.items() if value is not None}
        else:
            values = state_given(tuple(given), state)
        if "max_contacts" in options and not engine.is_hoop:
            options["max_contacts"] = max_contacts_of(options["max_contacts"])
        releasing = Releasing(
            values=values,
            sd=options.pop("scatter"),
            correlation=options.pop("correlation"),
            parameters=parameters,
            engine=engine,
        )
        return command(*arguments, releasing=releasing, **options)

    options = (*map(variable_option, VARIABLE_HELP), scene, *_SCATTER, scene_options)
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
        help="Of two that scatter, speed,elevation=-0.3; may be repeated.",
    ),
)

work_options = together(
    seed_option,
    confidence_option,
    max_contacts_option,
    backend_option,
    threads_option,
    folder_option,
    scheduler_option,
)
"""What `hoopgen.estimate` and `hoopgen.map` have too, under the same names."""
