"""The tables of a study file and their keys."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Annotated, Any

from pydantic import Field, GetCoreSchemaHandler, ValidationError, model_validator
from pydantic_core import CoreSchema, core_schema

from hoopgen.hoop.releases import CATCHING_HEIGHT
from hoopgen.hoop.variables import VARIABLES
from hoopgen.study.aim import Arc
from hoopgen.study.margins import MARGINS
from hoopgen.study.player import BY, By
from hoopgen.study.reading import Reading

from .fields import Listed, Named, Table, Values
from .scene import (
    InScene,
    releasing,
    scattering,
    scene_keys,
)
from .single import Name, Quantity, Share, Text, Whole, Word, meant, show, wrong
from .values import (
    ByWay,
    Columns,
    Conditions,
    Contacts,
    Count,
    File,
    Format,
    Height,
    Measures,
    Names,
    Over,
    Search,
    YesNo,
    correlations,
    deviation,
    quantity,
    scene_or_size,
    values_of,
)

__all__ = [
    "KINDS",
    "Aim",
    "Bank",
    "Batch",
    "Compare",
    "Estimate",
    "Given",
    "Map",
    "Optimum",
    "Question",
    "Releases",
    "Solve",
    "Study",
    "StudyFile",
]


_PORTS = (f"{port}{number}" for port in ("com", "lpt") for number in range(10))

_TAKEN: Mapping[str, str] = MappingProxyType(
    dict.fromkeys(("con", "prn", "aux", "nul", *_PORTS), "on Windows it is a device")
)
"""What no question's folder can be called, and why; names of other files have a dot in them."""

_CAPPED = "A shot with so many is given up as capped; by default 40 at the hoop, elsewhere 1000."
_CAUGHT = "Of rebounds, above the floor: of the ball's centre when it is caught. A choice."


class Study(Table):
    """What all of the study has in common."""

    name: Annotated[str, Text()] = Field(description="Title of the report.")
    description: Annotated[str, Text(r"(?s:.*)", "text")] = Field(
        "", description="At the head of the report; Markdown, in which HTML is shown as text."
    )
    seed: Annotated[int, Whole(0, 64)] = Field(
        0, description="Of all random numbers: the same study gives the same results."
    )
    confidence: Annotated[float, Share()] = Field(0.95, description="Of all intervals.")
    formats: Annotated[list[str], Listed(Word(("svg", "pdf", "png")), 1)] = Field(
        ["svg", "pdf"], description="Of the figures."
    )


class TableFile(Table):
    """A file with a table of releases, and how it is read."""

    file: File = Field(
        description="CSV, Parquet, Arrow or .xlsx; relative to the study file. The columns' names "
        "say the variables and units: `speed_mph`, `elevation_deg`."
    )
    format: Format = Field(None, description="By default as the suffix says.")
    own: Names = Field(
        [], description="Columns that are not to be read, though they are named like variables."
    )
    columns: Columns = Field(
        {},
        description="Columns that are read as variables, whatever they are called: "
        '`columns.speed = "release_speed_mph"`.',
    )
    where: Conditions = Field(
        [], description="Rows that do not meet all of these are left out: `player == Ann`."
    )
    implausible: YesNo = Field(
        False,
        description="Whether rows with implausible numbers are simulated, too, such as an "
        "elevation of 500°.",
    )

    @property
    def reading(self) -> Reading:
        """Return how the table is read."""
        names = ("format", "own", "columns", "where", "implausible")
        return Reading.of(**{name: getattr(self, name) for name in names})


class Releases(TableFile):
    """Measured releases, whose rows are drawn at random.

    A map and a search move the mean of a column; how far the rows are from it stays as it was.

    The columns take the place of what is given above; `release` beside this table, in the same
    place of the file, takes the place of columns.
    """

    group: Annotated[str | None, Text(said="the name of a column")] = Field(
        None,
        description="The column that says which rows belong together, such as a game or a player: "
        "intervals of the sample take groups, not rows, to be independent.",
    )


class Given(Table):
    """Where shots come from."""

    scene: Annotated[dict[str, Any], InScene(Named(scene_keys, scene_or_size))] = Field(
        {}, description="The hoop and the ball; or, above the questions, another scene."
    )
    release: Annotated[dict[str, float], Named(releasing, quantity)] = Field(
        {}, description="The release aimed at."
    )
    scatter: Annotated[dict[str, float] | None, Named(scattering, deviation, none=True)] = Field(
        {}, description="Standard deviations about it."
    )
    correlation: Annotated[dict[str, dict[str, float]], Named(scattering, correlations)] = Field(
        {}, description="Of pairs that scatter."
    )
    releases: Releases | None = Field(None, description="Measured releases instead of scatter.")


class Question(Given):
    """What all questions have.

    The tables of where shots come from may stand in a question too, as `[question.release]`. What
    they say is for this question alone, key by key in place of what is said above.
    """

    kind: Annotated[str, Text(said="a kind")] = Field(description="What is asked: those below.")
    name: Annotated[
        str,
        Name(
            r"[a-z0-9][a-z0-9_-]{0,59}",
            "small letters, digits, - and _, at most 60",
            _TAKEN,
        ),
    ] = Field(description="Of its folder in the results.")
    title: Annotated[str, Text(r".*")] = Field(
        "", description="In the report and above figures; by default the name."
    )


class Estimate(Question):
    """How probably a shot is made; in a scene of one's own, how it ends."""

    shots: Annotated[int | None, Whole()] = Field(
        None, description="By default 100,000; with a precision the most, by default 1e9."
    )
    precision: Annotated[float | None, Share()] = Field(
        None, description="Stop when half the interval is no wider: 0.001 is a tenth of a point."
    )
    max_contacts: Contacts = Field(None, description=_CAPPED)
    measures: Measures = Field(
        [], description="How each is spread; of rebound_angle, how many rebounds go where."
    )
    catching_height: Height = Field(CATCHING_HEIGHT, description=_CAUGHT)
    figures: Annotated[list[str], Listed(Word(("fan", "landings", "rebounds")))] = Field(
        [],
        description="Paths of the first shots; where misses reach the floor; where they come down "
        "to the catching height.",
    )


class Compare(Question):
    """What a change adds to the probability, over the same random numbers."""

    versus: Given = Field(
        description="What changes, in the tables of where shots come from: "
        "`versus.release.backspin = 0`."
    )
    shots: Annotated[int | None, Whole()] = Field(None, description="As of an estimate.")
    precision: Annotated[float | None, Share()] = Field(
        None, description="As of an estimate, for the difference."
    )
    by: Annotated[str | None, Text(said="the name of an end")] = Field(
        None, description="In a scene of one's own the end that counts; by default the first."
    )
    max_contacts: Contacts = Field(None, description=_CAPPED)


class Solve(Question):
    """The factor times all of the scatter with which a wanted share of the shots is made."""

    share: Annotated[float, Share()] = Field(description="Wanted: 0.7 of somebody who makes 70%.")
    by: Annotated[str | None, Text(said="the name of an end")] = Field(
        None, description="As of a comparison."
    )
    shots: Count = Field(
        100_000, description="Thrown with each factor, and for the fresh estimate at the one found."
    )
    max_contacts: Contacts = Field(None, description=_CAPPED)


class Map(Question):
    """How probably a shot is made over its variables; without scatter, what becomes of it."""

    over: Over = Field(
        description="Variables and their values, in place of what is given: `over.elevation = "
        '{ from = "45 deg", to = "60 deg", count = 31 }`, or a list. The first is drawn across.'
    )
    shots: Annotated[int | None, Whole()] = Field(
        None, description="Of each cell, with scatter; by default 10,000."
    )
    max_contacts: Contacts = Field(None, description=_CAPPED)
    figures: Annotated[list[str], Listed(Word(("map",)))] = Field([], description="The map.")


class Optimum(Question):
    """The release with the greatest probability, and what it forgives."""

    over: Search = Field(
        description='Variables to search over: `["elevation", "aim"]` within the usual ends, or '
        '`over.elevation = ["45 deg", "60 deg"]`.'
    )
    by: ByWay = Field(
        "any",
        description="What counts: any made shot, not off the board, or off it. In a scene of one's "
        "own an end, by default the first.",
    )
    shots: Count = Field(
        100_000,
        description="Of the last step of the search, and of the fresh estimate. Of measured "
        "releases every row is judged once, by a release that was searched without it.",
    )
    tolerance: Annotated[float, Share()] = Field(
        0.01, description="The fall in probability that is still called flat."
    )
    margins: Annotated[list[str], Listed(Word(tuple(VARIABLES)))] = Field(
        list(MARGINS), description="Variables of which it is said how far off they may be."
    )


class Bank(Question):
    """The best bank shot against the best direct shot, from places on the court."""

    places: Annotated[
        dict[str, list[float]], Named(("distance", "angle", "x", "y"), values_of, least=2)
    ] = Field(description="Distance and angle, or x and y: every combination is a place.")
    over: Search = Field(
        {"elevation": None, "aim": None, "azimuth": None},
        description="Variables to search over, as of an optimum.",
    )
    shots: Count = Field(20_000, description="As of an optimum.")
    figures: Annotated[list[str], Listed(Word(("aim_points",)))] = Field(
        [], description="Where bank shots touch the board, and from where they are better."
    )


class Aim(Question):
    """The release through the ring's centre from each distance, and what it forgives: a table.

    Height, angle and spins are those of the release. Of `entry`, `elevation` and `speed` one may
    be given; without, it is the slowest release.
    """

    distance: Annotated[list[float], Values("length")] = Field(
        description="From the ring's centre on the floor plan."
    )
    entry: Annotated[float | None, Quantity("angle")] = Field(
        None, description="Wanted angle below the horizontal at the ring."
    )
    elevation: Annotated[float | None, Quantity("angle")] = Field(
        None, description="Wanted angle of the release."
    )
    speed: Annotated[float | None, Quantity("speed")] = Field(
        None, description="Wanted speed of the release."
    )
    arc: Annotated[Arc, Word(("high", "low"))] = Field(
        "high", description="Which of the two flights with that speed."
    )
    depth: Annotated[float, Quantity("length")] = Field(
        0.0, description="How far past the ring's centre is aimed."
    )
    by: Annotated[By, Word(tuple(BY))] = Field("any", description="What counts, as of an optimum.")


class Batch(Question, TableFile):
    """A table of releases, simulated row by row.

    Of where shots come from it takes the scene, and what its own `release` says, which all rows
    share.
    """

    measures: Measures = Field([], description="Columns to add.")
    catching_height: Height = Field(CATCHING_HEIGHT, description=_CAUGHT)
    prefix: Annotated[str, Text(r".*", "text")] = Field(
        "", description="Of the names of the results' columns."
    )
    max_contacts: Contacts = Field(None, description=_CAPPED)


KINDS: Mapping[str, type[Question]] = MappingProxyType(
    {
        "estimate": Estimate,
        "compare": Compare,
        "solve": Solve,
        "map": Map,
        "optimum": Optimum,
        "bank": Bank,
        "aim": Aim,
        "batch": Batch,
    }
)
"""The questions there are."""

_KIND = Word(tuple(KINDS))


class _OfKind:
    """A question of the kind that it says."""

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        kinds = {f"<{kind}>": handler.generate_schema(table) for kind, table in KINDS.items()}
        return core_schema.no_info_wrap_validator_function(
            self._read,
            core_schema.tagged_union_schema(
                kinds, discriminator=lambda given: f"<{given['kind']}>"
            ),
        )

    def _read(self, given: Any, handler: Callable[[Any], Any]) -> Any:
        if not isinstance(given, dict):
            raise ValueError(f"expected a table, [[question]]; got {show(given)}")
        if given.get("kind") not in _KIND.allowed:  # a list could be no key
            # Of what kind its keys are is not known.
            said = f"missing; expected {_KIND.words}"
            if "kind" in given:
                said = str(_KIND.refuse(given["kind"], meant(given["kind"], KINDS)))
            raise ValidationError.from_exception_data("question", [wrong(said, ("kind",))])
        return handler(given)


class StudyFile(Given):
    """All of a study."""

    study: Study = Field(description="What all of it has in common.")
    question: list[Annotated[Question, _OfKind()]] = Field(
        min_length=1, description="What is asked."
    )

    @model_validator(mode="after")
    def _named_once(self) -> StudyFile:
        names = [question.name for question in self.question]
        errors = [
            wrong(f"{show(name)} is another question's", ("question", place, "name"))
            for place, name in enumerate(names)
            if name in names[:place]
        ]
        if errors:
            raise ValidationError.from_exception_data("question", errors)
        return self
