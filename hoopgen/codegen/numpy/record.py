"""The record of the results, as the module of a scene carries it."""

from __future__ import annotations

from dataclasses import MISSING, dataclass, fields
from typing import Any

from hoopgen.derive.model import Model
from hoopgen.derive.state.fields import ResultField

from ..identifiers import python_string
from .spelling import NUMPY


@dataclass(frozen=True)
class ResultRecord:
    """A view of the results of a model for the template."""

    model: Model

    @property
    def summary(self) -> str:
        """The first line of the docstring of `ResultField`."""
        return (ResultField.__doc__ or "").partition("\n")[0]

    @property
    def attributes(self) -> list[str]:
        """The attributes of a result, with their types and defaults."""
        return [
            f"{own.name}: {own.type}"
            + ("" if own.default is MISSING else f" = {_literal(own.default)}")
            for own in fields(ResultField)
        ]

    @property
    def results(self) -> list[str]:
        """The arguments of each result that a shot of the scene has."""
        return [_arguments(result) for result in self.model.results]

    @property
    def absent_results(self) -> list[str]:
        """The arguments of each result that the scene lacks."""
        return [_arguments(result) for result in self.model.absent_results]


def _arguments(result: ResultField) -> str:
    """Return the attributes of a result as arguments, those with their defaults left out."""
    own = ((f.name, getattr(result, f.name), f.default) for f in fields(result))
    return ", ".join(f"{name}={_literal(value)}" for name, value, usual in own if value != usual)


def _literal(value: Any) -> str:
    """Return an attribute in Python."""
    match value:
        case str():
            return python_string(value)
        case tuple():
            return f"({', '.join(map(_literal, value))}{',' if len(value) == 1 else ''})"
        case float():
            return NUMPY.number_text(value)
    return repr(value)
