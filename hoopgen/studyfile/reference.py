"""The reference of the study file, of which ``docs/study.md`` is the text.

Its tables are those of the specifications by which study files are read.
"""

from __future__ import annotations

import inspect
import json
from collections.abc import Iterator
from dataclasses import MISSING
from importlib.resources import files
from typing import Any

from hoopgen.core.units import UNITS
from hoopgen.hoop.presets import NAMES, PRESETS
from hoopgen.hoop.variables import ARGUMENTS, VARIABLES
from hoopgen.study.questions.settings import MeasuredReleases, settings
from hoopgen.study.questions.specification import QUESTIONS

from .scene import in_file
from .schema import Given, Question, Study

_TABLES = {
    "scene": "Ball and hoop: `preset`, one of {presets} (by default the scene that a file of "
    'results says, else "paper"), and parameters. Or another scene, above the questions: see '
    "below.",
    "release": "The release aimed at: height, a place, an elevation or `entry`, a speed or `aim`.",
    "scatter": 'Standard deviations about it; `scatter = "none"` for none.',
    "correlation": "Of pairs that scatter: `speed.elevation = -0.3`.",
    "releases": "Measured releases, in place of `scatter`; see below.",
}


def reference() -> str:
    """Return the reference, Markdown."""
    presets = ", ".join(f'"{name}"' for name in PRESETS)
    tables = [_row(f"`[{name}]`", said.format(presets=presets)) for name, said in _TABLES.items()]
    variables = [
        _row(f"`{name}`", variable.label, variable.kind, _where(name))
        for name, variable in VARIABLES.items()
    ]
    units = [
        _row(kind, " ".join(f"`{unit}`" for unit in units if unit) or "none")
        for kind, units in UNITS.items()
    ]
    text = (files(__package__) / "reference.md").read_text("utf-8")
    for name, rows in (("tables", tables), ("variables", variables), ("units", units)):
        text = text.replace(f"{{{name}}}", "".join(rows))
    return "".join(
        [
            text,
            *_section("## `[releases]`", MeasuredReleases),
            *_section("## `[study]`", Study),
            *_section("## `[[question]]`", Question, Given),
            *(
                line
                for kind, specification in QUESTIONS.items()
                for line in _section(f'### `kind = "{kind}"`', specification)
            ),
        ]
    )


def _where(name: str) -> str:
    """Return the tables that a variable may stand in."""
    if name in NAMES:
        return "scene, scatter"
    return "release, scatter" if name in ARGUMENTS else "release"


def _section(title: str, specification: type, apart: type | None = None) -> Iterator[str]:
    """Yield the keys of a table, without those of one that is elsewhere."""
    yield f"\n{title}\n\n{inspect.cleandoc(specification.__doc__ or '')}\n\n"
    yield _row("key", "what it may be", "default", "what it says") + _row(*["---"] * 4)
    elsewhere = [] if apart is None else [name for name, *_ in settings(apart)]
    for name, _, one, default in settings(specification):
        if name not in elsewhere:
            text = f"{one.help} {one.file}".strip()
            yield _row(f"`{name}`", _words(in_file(one.value).words), _default(default), text)


def _words(said: str) -> str:
    """Return the allowed values; of a long list the first ones."""
    return said if len(said) < 120 else f"{said[: said.index(' ', 40)]} …"


def _default(value: Any) -> str:
    if value is MISSING:
        return "needed"
    return "" if value is None else f"`{json.dumps(value)}`"


def _row(*cells: str) -> str:
    return f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |\n"
