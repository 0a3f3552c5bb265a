"""The reference of the study file, from the schema that reads it; ``docs/study.md`` is its text."""

from __future__ import annotations

import inspect
import json
from collections.abc import Container, Iterator

from pydantic.fields import FieldInfo

from hoopgen.hoop.presets import NAMES, PRESETS
from hoopgen.hoop.variables import ARGUMENTS, VARIABLES
from hoopgen.units import UNITS

from .fields import Table
from .schema import KINDS, Given, Question, Releases, Study

__all__ = ["reference"]

_HEAD = """\
# The study file

`hoopgen study spin.toml` answers the questions of one file, in [TOML](https://toml.io), and keeps
the answers in a folder. Such a file:

```toml
[study]
name = "Does backspin help?"

[release]              # the release aimed at
height = "7 ft"
distance = "13.75 ft"
elevation = "52 deg"
aim = "2 in"           # past the ring's centre, in place of a speed
backspin = "3 Hz"

[scatter]              # the player's standard deviations about it
speed = "0.063 m/s"
elevation = "1.3 deg"
azimuth = "1 deg"

[[question]]
name = "no-spin"
kind = "compare"
versus.release.backspin = 0
precision = 0.002
```

[examples/free-throw.toml](../examples/free-throw.toml) asks more. `hoopgen study --check` says what
is wrong with a file, with lines and keys; `hoopgen study --reference` prints this page.

## The folder

By default `spin-results`, beside the file; `--out` names another.

| file | what is in it |
|---|---|
| `report.md` | what was asked, and the answers with their intervals |
| `study.toml` | the study file, as it was given |
| `scene.toml` | the scene file, as it was, where the study names one |
| `versions.json` | of hoopgen, Python and the libraries; the platform |
| `<name>/answer.json` | the answer to a question, in full |
| `<name>/question.json` | all that it depends on |
| `<name>/…` | its tables (`.nc`, `.csv`, `.parquet`) and figures |
| `<name>/chunks` | of an estimate, a comparison, a map: it goes on from them when asked for more |
| `hoopgen.json` | in each of these folders: the files of it that hoopgen replaces and removes |

Numbers in files are SI; their units are in the names of columns and keys, `speed_m_s`,
`elevation_rad`, and in a `.nc` file beside its variables. The `.csv` of an `aim` has degrees and
Hz.

Interrupted or killed, the same command goes on where it was: finished questions stay, and of the
one at work the finished chunks, in `<name>.unfinished`. A question that fails leaves the others
alone. However often it was interrupted, and by however many threads it is computed, a study gives
the same bytes with the same versions; `versions.json` alone tells of the machine. Questions may be
added to the file later. If one that is in the folder has changed, or is no longer asked, the folder
is refused, and what differs is said.

Files of your own in these folders stay as they are. A folder that has other files and no
`hoopgen.json` is not used: give one that is empty or does not exist. That holds for `--folder` of
the other commands, too.

An estimate, a comparison or a map may be asked for other `shots`, and the first two for another
`precision`. For more only the rest is thrown, and the folder is that of a study which asked for as
much from the start; for fewer the answer is that of a study which asked for so many, and all chunks
stay. The old answer stays until the new one is finished. Other cells of a map are another question.
Searches (optimum, solve, bank) begin anew: what is thrown next hangs on all shots so far.

With `--report page.html` the report is written as a page too: one file with all pictures in it, to
read, to print and to pass on, which says what was asked in words, how it was made, and the digests
of the study file and the answers.

With `--scheduler tcp://…` the workers of a Dask cluster compute the chunks.

## Where shots come from

These tables stand above the questions; in a question, `[question.release]` or `release.speed = …`,
they change for this question alone what they name.

| table | what it says |
|---|---|
"""

_SCENES = """
`scene = "netball.toml"` makes the study one of a scene of one's own: a scene file, relative to the
study file, or the name of one that comes with hoopgen, `"hoop"`. As a table, `[scene]` has
`file = "netball.toml"` and parameters of the scene. Nothing in that file is evaluated either. Then
`release` is a state, `x y z vx vy vz` and, if it spins, `wx wy wz`; these and the scene's
parameters are what scatters and what is mapped and searched over. Questions are estimate, compare,
solve, map, optimum and batch; the others are a hoop's. If the scene file changes, the folder is
refused.
"""

_QUANTITIES = """
A quantity is text with its unit, or a bare number in SI. An angle or a spin needs its unit, but for
0: the rule of the command line and of columns' names. Units may be spelled in full, `feet`,
`degrees`, `revolutions per minute`, in capital letters or small ones. Nothing in the file is
evaluated.

| quantity | units |
|---|---|
"""

_VARIABLES = """
| variable | what it is | quantity | tables |
|---|---|---|---|
"""

_TABLES = {
    "scene": "Ball and hoop: `preset`, one of {presets} (by default the scene that a file of "
    'results says, else "paper"), and parameters. Or another scene, above the questions: see '
    "below.",
    "release": "The release aimed at: height, a place, an elevation or `entry`, a speed or `aim`.",
    "scatter": 'Standard deviations about it; `scatter = "none"` for none.',
    "correlation": "Of pairs that scatter: `speed.elevation = -0.3`.",
}


def reference() -> str:
    """Return the reference, Markdown."""
    presets = ", ".join(f'"{name}"' for name in PRESETS)
    return "".join(
        [
            _HEAD,
            *(_row(f"`[{name}]`", said.format(presets=presets)) for name, said in _TABLES.items()),
            _row("`[releases]`", "Measured releases, in place of `scatter`; see below."),
            _VARIABLES,
            *(
                _row(f"`{name}`", variable.label, variable.kind, _where(name))
                for name, variable in VARIABLES.items()
            ),
            _SCENES,
            _QUANTITIES,
            *(
                _row(kind, " ".join(f"`{unit}`" for unit in units if unit) or "none")
                for kind, units in UNITS.items()
            ),
            *_section("## `[releases]`", Releases),
            *_section("## `[study]`", Study),
            *_section("## `[[question]]`", Question, Given.model_fields),
            *(
                line
                for kind, table in KINDS.items()
                for line in _section(f'### `kind = "{kind}"`', table, Question.model_fields)
            ),
        ]
    )


def _where(name: str) -> str:
    """Return the tables that a variable may stand in."""
    if name in NAMES:
        return "scene, scatter"
    return "release, scatter" if name in ARGUMENTS else "release"


def _section(title: str, table: type[Table], apart: Container[str] = ()) -> Iterator[str]:
    """Yield the keys of a table, apart from those that are elsewhere."""
    yield f"\n{title}\n\n{inspect.cleandoc(table.__doc__ or '')}\n\n"
    yield _row("key", "what it may be", "default", "what it says") + _row(*["---"] * 4)
    for name, field in table.model_fields.items():
        if name not in apart:
            yield _row(f"`{name}`", _words(field), _default(field), field.description or "")


def _words(field: FieldInfo) -> str:
    """Say what a key may be given."""
    found = [each.words for each in field.metadata if hasattr(each, "words")]
    said = found[0] if found else "tables"
    # That one of very many words is meant is said once.
    return said if len(said) < 120 else f"{said[: said.index(' ', 40)]} …"


def _default(field: FieldInfo) -> str:
    if field.is_required():
        return "needed"
    value = field.default
    if isinstance(value, dict) and value:  # variables to search over, within their usual ends
        value = list(value)
    return "" if value is None else f"`{json.dumps(value)}`"


def _row(*cells: str) -> str:
    return f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |\n"
