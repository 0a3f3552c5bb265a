"""The tables of a study file and their keys: questions, and what all of them share."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, dataclass, replace
from functools import cache
from typing import Annotated, Any, cast

from pydantic import GetCoreSchemaHandler, ValidationError, create_model
from pydantic_core import CoreSchema, core_schema

from hoopgen.study.questions.settings import (
    MeasuredReleases,
    Sampling,
    TableSettings,
    setting,
    settings,
)
from hoopgen.study.questions.specification import QUESTIONS
from hoopgen.study.questions.values import BOUNDS, CHANGE, Choice, Listed, Text, Value, show
from hoopgen.study.tables.reading import ReadingOptions
from hoopgen.text.shorten import suggestion

from .fields import Named, Table, error_at
from .scene import (
    InScene,
    correlations,
    deviation,
    in_file,
    release_keys,
    release_value,
    scattering,
    scene_keys,
    scene_or_size,
)

_PORTS = (f"{port}{number}" for port in ("com", "lpt") for number in range(10))

_RESERVED: Mapping[str, str] = dict.fromkeys(
    ("con", "prn", "aux", "nul", *_PORTS), "on Windows it is a device"
)
"""Names that no question's folder can have, and why; names of other files have a dot in them."""


@dataclass(frozen=True, kw_only=True)
class Study(Sampling):
    """Settings of the study as a whole."""

    name: str = setting("Title of the report.", Text())
    description: str = setting(
        "Text at the head of the report; Markdown, in which HTML is shown as text.",
        Text(r"(?s:.*)", "text"),
        "",
    )
    formats: Sequence[str] = setting(
        "Formats of the figures.", Listed(Choice(("svg", "pdf", "png")), 1), ("svg", "pdf")
    )


class _Tables(Value):
    """Tables of keys and values."""

    words = "tables"

    def __init__(self, specification: type) -> None:
        self.specification = specification

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return handler.generate_schema(table_of(self.specification))


@dataclass(frozen=True, kw_only=True)
class Given:
    """The source of the shots."""

    scene: Mapping[str, Any] = setting(
        "The hoop and the ball; or, above the questions, another scene.",
        InScene(Named(scene_keys, scene_or_size)),
        {},
    )
    release: Mapping[str, Any] = setting(
        "The release aimed at.",
        Named(release_keys, release_value),
        {},
        file='`place = "free throw"` takes the place of distance and angle.',
    )
    scatter: Mapping[str, float] | None = setting(
        "Standard deviations about it.", Named(scattering, deviation, none=True), {}
    )
    correlation: Mapping[str, Mapping[str, float]] = setting(
        "Correlations of pairs that scatter.", Named(scattering, correlations), {}
    )
    releases: MeasuredReleases | None = setting(
        "Measured releases instead of scatter.", _Tables(MeasuredReleases), None
    )


@dataclass(frozen=True, kw_only=True)
class Question(Given):
    """Settings of every question.

    A question may have the tables of the source of shots, too, as `[question.release]`. Their keys
    replace those of the study for this question alone.
    """

    kind: str = setting("What is asked: those below.", Text(words="a kind"))
    name: str = setting(
        "Name of its folder in the results.",
        Text(
            r"[a-z0-9][a-z0-9_-]{0,59}",
            "small letters, digits, - and _, at most 60",
            reserved=_RESERVED,
        ),
    )
    title: str = setting(
        "Title in the report and above figures; by default the name.", Text(r".*"), ""
    )


@cache
def table_of(*specifications: Any) -> type[Table]:
    """Return the table of a study file whose keys are the settings of specifications."""
    fields: dict[str, Any] = {}
    for specification in specifications:
        for name, kind, one, default in settings(specification):
            value = _Tables(Given) if one.value == CHANGE else in_file(one.value)
            needed = ... if default is MISSING else default
            if one.value == BOUNDS and default is not MISSING:
                needed = dict.fromkeys(default)
            fields[name] = (Annotated[kind, replace(one, value=value)], needed)
    first = specifications[-1]
    made: type[Table] = create_model(
        first.__name__, __base__=(Table, *specifications[::-1]), __doc__=first.__doc__, **fields
    )
    return made


def reading(table: TableSettings) -> ReadingOptions:
    """Return the options with which a table of releases is read."""
    return ReadingOptions.from_options(
        **{name: getattr(table, name) for name, *_ in settings(TableSettings)}
    )


KINDS: Mapping[str, type[Table]] = {
    kind: table_of(Question, specification) for kind, specification in QUESTIONS.items()
}
"""The questions there are."""

_KIND = Choice(tuple(KINDS))


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
            text = f"missing; expected {_KIND.words}"
            if "kind" in given:
                text = str(_KIND.refusal(given["kind"], suggestion(given["kind"], KINDS)))
            raise ValidationError.from_exception_data("question", [error_at(text, ("kind",))])
        return handler(given)


class _Questions(Value):
    """Questions, each of the kind that it says, whose names differ."""

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        each = handler.generate_schema(Annotated[Any, _OfKind()])
        return core_schema.no_info_after_validator_function(
            self._named_once, core_schema.list_schema(each, min_length=1)
        )

    @staticmethod
    def _named_once(questions: list[Question]) -> list[Question]:
        names = [question.name for question in questions]
        errors = [
            error_at(f"{show(name)} is another question's", (place, "name"))
            for place, name in enumerate(names)
            if name in names[:place]
        ]
        if errors:
            raise ValidationError.from_exception_data("question", errors)
        return questions


@dataclass(frozen=True, kw_only=True)
class StudyFile(Given):
    """All of a study."""

    study: Study = setting("What all of it has in common.", _Tables(Study))
    question: Sequence[Question] = setting("What is asked.", _Questions())


def read_document(document: Mapping[str, Any]) -> StudyFile:
    """Return the content of a study file's document, in SI units."""
    return cast(StudyFile, table_of(StudyFile).model_validate(document))
