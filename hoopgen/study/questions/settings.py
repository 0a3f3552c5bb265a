"""A setting of a question: its text of help and the kind of its values; and those that are shared.

A setting is a field of a dataclass, made by `setting`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, dataclass, field, fields
from functools import cache, partial
from os import PathLike
from typing import Any, TypeAlias, get_type_hints

from hoopgen.core.backend_names import BACKEND_NAMES, BackendName
from hoopgen.hoop.releases import CATCHING_HEIGHT

from .values import (
    DEVIATIONS,
    FOLDER,
    MEMORY,
    Choice,
    Each,
    Flag,
    Listed,
    Names,
    Quantity,
    Share,
    Success,
    Text,
    Value,
    Whole,
)

ASKED = "What is asked"
RELEASE = "The release"
MEASURED = "Its scatter, or measured releases"
COMPUTED = "The computation"
RESULTS = "The results"


@dataclass(frozen=True)
class Setting:
    """The definition of one setting for Python, the command line and study files.

    Attributes
    ----------
    option
        Name of the option, if it is not that of the argument; None if no command has it.
    check
        Raises a ValueError for a value of a study file that its kind alone allows.
    command, file
        How it is written on the command line, and in a study file: the end of the help there.
    """

    help: str  # what it sets
    value: Value  # the kind of its values
    option: str | None = ""
    heading: str = ASKED  # heading of the options among which a long help lists it
    check: Callable[[Any], Any] | None = None
    argument: bool = True  # false if no Python function has it
    command: str = ""
    file: str = ""

    @property
    def words(self) -> str:
        """The values that are allowed in a study file."""
        return self.value.words

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        from pydantic_core import core_schema

        schema = self.value.__get_pydantic_core_schema__(source, handler)
        if self.check is None:
            return schema
        return core_schema.no_info_after_validator_function(self.check, schema)


def setting(help: str, value: Value, default: Any = MISSING, **attributes: Any) -> Any:
    """Return the field of a dataclass that is a setting; `attributes` as of `Setting`.

    Parameters
    ----------
    help
        The text of help.
    value
        The kind of its values.
    default
        The value that it has if none is given.
    **attributes
        Further attributes of `Setting`.
    """
    metadata = {"setting": Setting(help, value, **attributes)}
    if isinstance(default, dict):
        return field(default_factory=default.copy, metadata=metadata)
    return field(default=default, metadata=metadata)


@cache
def settings(specification: Any) -> Sequence[tuple[str, Any, Setting, Any]]:
    """Return name, type, setting and default (MISSING if it is needed) of each field."""
    hints, found = get_type_hints(specification), []
    for one in fields(specification):
        default = one.default if one.default_factory is MISSING else one.default_factory()
        found.append((one.name, hints[one.name], one.metadata["setting"], default))
    return tuple(found)


def arguments(question: Any, *specifications: type) -> dict[str, Any]:
    """Return the settings of a question that its Python function takes, by name."""
    found = (one for each in specifications for one in settings(each))
    return {name: getattr(question, name) for name, _, one, _ in found if one.argument}


# ------------------------------------------------------------------------------------ shared ones

SUCCESSES = ("any", "direct", "bank")
"""The shots that may count: all made ones, or those of a kind."""

Path: TypeAlias = str | PathLike[str]


# What needs other packages imports them when it is called, so that the help of commands is quick.


def _measures() -> Mapping[str, str]:
    from hoopgen.study.measures.measures import MEASURES

    return {name: one.label for name, one in MEASURES.items()}


def _check_height(height: float) -> float:
    from hoopgen.study.measures.rebounds import check_height

    return check_height(height)


def _check_conditions(where: Sequence[str]) -> Sequence[str]:
    from hoopgen.study.tables.filters import parse_conditions

    parse_conditions(where)
    return where


max_contacts = partial(
    setting,
    "Number of contacts after which a shot ends as capped; by default 40 at the hoop and 1000 "
    "elsewhere.",
    Whole(high=2**31 - 1),
    None,
    heading=COMPUTED,
)
measures = partial(
    setting,
    value=Listed(Names(_measures)),
    default=(),
    option="measure",
    command="Among them are depth, entry_angle, apex, rebound_distance ...",
)
catching_height = partial(
    setting,
    "Height of the ball's centre above the floor when a rebound is caught; the default is assumed.",
    Quantity("length", 0.0),
    CATCHING_HEIGHT,
    check=_check_height,
)
end = partial(
    setting,
    "End that counts: at a hoop made or missed, by default made; in a scene of your own one of its "
    "ends, by default the first.",
    Text(words="the name of an end", metavar="END"),
    None,
)
success = partial(
    setting,
    "Shots that count: any made shot, a direct shot, or a bank shot. In a scene of your own: "
    "an end, by default the first.",
    Success(SUCCESSES),
    "any",
)
precision = partial(
    setting,
    "Stop when the half width of the interval is at most this: 0.001 is a tenth of a "
    "percentage point.",
    Share(),
    None,
)
shots = partial(
    setting,
    "Number of shots, by default 100,000; with a precision the largest number, by default 1e9.",
    Whole(),
    None,
)
tolerance = partial(
    setting, "Fall in probability within which a range counts as flat.", Share(), 0.01, option=None
)

table_format = partial(
    setting,
    "Format of the table; by default that of the file's suffix.",
    Choice(("csv", "parquet", "arrow", "xlsx")),
    None,
    heading=MEASURED,
)
table_where = partial(
    setting,
    "Condition that a row must meet to be read, such as 'speed_mph >= 15' or 'player == Ann'.",
    Listed(Text(words="a comparison", metavar="CONDITION")),
    (),
    heading=MEASURED,
    check=_check_conditions,
)
table_units = partial(
    setting,
    "Units of the columns of results: metres and m/s, or feet, mph and degrees.",
    Choice(("si", "us")),
    "si",
    heading=RESULTS,
)


@dataclass(frozen=True, kw_only=True)
class Seeded:
    """The random numbers."""

    seed: int = setting(
        "Seed of the random numbers; the same seed gives the same results.",
        Whole(0, 2**64 - 1, "NUMBER"),
        0,
        heading=COMPUTED,
    )


@dataclass(frozen=True, kw_only=True)
class Sampling(Seeded):
    """The settings that all questions of a study file share."""

    confidence: float = setting("Confidence of the intervals.", Share(percent=True), 0.95)


@dataclass(frozen=True, kw_only=True)
class Engines:
    """The engine that computes, which changes no result."""

    backend: BackendName = setting(
        "Engine that computes; all give the same bits.",
        Choice(BACKEND_NAMES),
        "auto",
        heading=COMPUTED,
    )


@dataclass(frozen=True, kw_only=True)
class Threads:
    """The processors of this machine that compute, which changes no result."""

    threads: int | None = setting(
        "Number of threads; by default one per processor.", Whole(), None, heading=COMPUTED
    )


@dataclass(frozen=True, kw_only=True)
class Workers(Threads):
    """The threads of this machine or the Dask workers that compute; they change no result."""

    scheduler: str | None = setting(
        "Address of a Dask scheduler whose workers compute, tcp://host:8786.",
        Text(metavar="ADDRESS"),
        None,
        heading=COMPUTED,
    )


@dataclass(frozen=True, kw_only=True)
class Computation(Workers):
    """The executor that computes, and the folder of its finished chunks."""

    folder: Path | None = setting(
        "Folder of finished chunks: the same command continues from them, and with more "
        "--shots it computes only the missing ones.",
        FOLDER,
        None,
        heading=COMPUTED,
    )


@dataclass(frozen=True, kw_only=True)
class TableSettings:
    """Settings for reading a table of releases."""

    format: str | None = table_format()
    own: Sequence[str] = setting(
        "Column not to be read although it is named like a variable.",
        Listed(Text(words="a column name", metavar="COLUMN")),
        (),
        heading=MEASURED,
    )
    columns: Mapping[str, str] | None = setting(
        "Column of any name to read as a variable,",
        Each(Text(words="a column name")),
        None,
        option="column",
        heading=MEASURED,
        command="such as speed=release_speed_mph; the unit is at the end of either name: "
        "azimuth_deg='Side angle'.",
        file='`columns.speed = "release_speed_mph"`.',
    )
    where: Sequence[str] = table_where()
    implausible: bool = setting(
        "Also simulate rows with implausible numbers, such as an elevation of 500 degrees.",
        Flag(),
        False,
        option="keep-implausible",
        heading=MEASURED,
    )


@dataclass(frozen=True, kw_only=True)
class Parsing:
    """Settings for parsing a table, which a study file leaves to the table."""

    delimiter: str | None = setting(
        "Delimiter of the cells of CSV: ; or tab. By default the first line determines it.",
        Text(metavar="CHARACTER"),
        None,
        heading=MEASURED,
    )
    memory: int = setting(
        "Largest memory for the rows that are read at once, such as 4GB; by default 1 GB.",
        MEMORY,
        1 << 30,
        heading=MEASURED,
    )


table_file = partial(
    setting,
    "CSV, Parquet, Arrow or .xlsx; relative to the study file. The names of the columns give "
    "variables and units: `speed_mph`, `elevation_deg`.",
    Text(words="the name of a file"),
    option=None,
    argument=False,
)


@dataclass(frozen=True, kw_only=True)
class MeasuredReleases(TableSettings):
    """Measured releases, whose rows are drawn at random.

    A map or a search moves the mean of a column and keeps each row's distance from the mean.

    Columns replace values given above. A `release` table at the same place of the file as
    `releases` replaces columns.
    """

    file: str = table_file()
    group: str | None = setting(
        "Column that names the rows that belong together, such as a game or a player: "
        "intervals of the sample assume that groups, not rows, are independent.",
        Text(words="the name of a column", metavar="COLUMN"),
        None,
        heading=MEASURED,
        command="With --from.",
    )
    fitted: bool = setting(
        "Fit a normal scatter to the rows, without the measuring errors and robust to outliers, "
        "and draw from it in place of the rows.",
        Flag(),
        False,
        heading=MEASURED,
        command="With --from; of estimate, --group is the player of each row.",
        file="Of an estimate the interval of the sample is that of the fit. One player: choose by "
        "`where`.",
    )
    instrument: Mapping[str, float] = setting(
        "Standard errors of the measurement, with `fitted`; by default columns `sd_speed_m_s` ... "
        "of the table, as `hoopgen fit` writes them.",
        DEVIATIONS,
        {},
        option=None,
        file='`instrument.speed = "2 cm/s"`.',
    )
