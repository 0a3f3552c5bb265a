"""Studies in one file: every complaint at its line, the same answers however they come about."""

from __future__ import annotations

import builtins
import codecs
import json
import os
import pickle
import re
import signal
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers import ROOT
from tests.helpers.commands import run, succeed
from tests.helpers.killed import run_until_sync

for _library in ("matplotlib", "pyarrow", "pydantic", "scipy", "xarray"):
    pytest.importorskip(_library)

import xarray as xr  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen.study.jobs import monte_carlo  # noqa: E402
from hoopgen.study.named_units import in_units, named  # noqa: E402
from hoopgen.study.questions import sweep  # noqa: E402
from hoopgen.study.questions.bank import bank_or_direct  # noqa: E402
from hoopgen.study.questions.settings import settings  # noqa: E402
from hoopgen.studyfile import check_study, run_study, sweeps  # noqa: E402
from hoopgen.studyfile import lines as toml_lines  # noqa: E402
from hoopgen.studyfile.context import Context  # noqa: E402
from hoopgen.studyfile.reading import StudyError, parse  # noqa: E402
from hoopgen.studyfile.reference import reference  # noqa: E402
from hoopgen.studyfile.report import _text as report_text  # noqa: E402
from hoopgen.studyfile.schema import KINDS, Question  # noqa: E402

pytestmark = pytest.mark.xdist_group("studyfile")  # the study is run once

DEGREE = np.pi / 180

EXAMPLE = ROOT / "examples" / "free-throw.toml"

HEAD = """\
[study]
name = "Free throws"
seed = 5
formats = ["png"]

[release]
height = "7 ft"
distance = "13.75 ft"
elevation = "52 deg"
aim = "2 in"
backspin = "3 Hz"

[scatter]
speed = "0.063 m/s"
elevation = "1.3 deg"
azimuth = "1 deg"
"""

ESTIMATE = """
[[question]]
kind = "estimate"
name = "probability"
shots = 2000
"""

ALL = (
    HEAD
    + """
[[question]]
kind = "estimate"
name = "probability"
shots = 300_000
figures = ["fan", "landings"]

[[question]]
kind = "compare"
name = "backspin"
release.backspin = 0
versus.release.backspin = "3 Hz"
shots = 2000

[[question]]
kind = "map"
name = "map"
title = "Where to aim"
over.elevation = { from = "48 deg", to = "56 deg", count = 3 }
over.aim = ["0 in", "2 in"]
shots = 200
figures = ["map"]

[[question]]
kind = "map"
name = "outcomes"
scatter = "none"
over = { speed = [6.9, 7.1, 7.3], elevation = ["50 deg", "52 deg"] }

[[question]]
kind = "bank"
name = "bank"
places = { x = [1.5, 2], y = [1, -1] }
shots = 100
figures = ["aim_points"]

[[question]]
kind = "aim"
name = "table"
distance = [3, "13.75 ft"]
entry = "45 deg"

[[question]]
kind = "optimum"
name = "best"
over.elevation = "usual"
over.aim = ["0 in", "4 in"]
shots = 500
margins = ["speed"]

[[question]]
kind = "estimate"
name = "measured"
scatter = "none"
releases.file = "measured.csv"
shots = 1000

[[question]]
kind = "batch"
name = "rows"
file = "measured.csv"
release = { height = "7 ft", distance = "13.75 ft" }
measures = ["depth"]

[[question]]
kind = "solve"
name = "scatter"
share = 0.5
shots = 300
"""
)
"""A question of every kind, and of those with more than one way to be asked more than one."""

MEASURED = (
    "player,speed_mph,elevation_deg,azimuth_deg\na,15.9,52,0.5\nb,16.1,51,-0.5\na,15.8,53,0\n"
)


def written(folder: Path, text: str) -> Path:
    """Write a study file, and the measured releases beside it."""
    folder.mkdir(exist_ok=True)
    (folder / "measured.csv").write_text(MEASURED, encoding="utf-8")
    file = folder / "study.toml"
    file.write_text(text, encoding="utf-8")
    return file


def contents(folder: Path) -> dict[str, bytes]:
    """Every file of a folder but the versions, by its path there."""
    found = (file for file in sorted(folder.rglob("*")) if file.is_file())
    here = {file.relative_to(folder).as_posix(): file.read_bytes() for file in found}
    del here["versions.json"]
    return here


def loaded(folder: Path, name: str) -> Any:
    return json.loads((folder / name / "answer.json").read_bytes())["numbers"]


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The results of a run that nothing disturbed."""
    folder = tmp_path_factory.mktemp("whole")
    run_study(written(folder, ALL), folder / "results", threads=1)
    return folder / "results"


# Where a key is

PLACES = '''\
# head = 1
[head]                          # head
text = """                      # head.text
[[table]]
key = "look-alike"
"""
after = 1                       # head.after
dotted.keys.here = 1            # head.dotted | head.dotted.keys | head.dotted.keys.here
dotted.keys.there = 2           # head.dotted.keys.there
inline = { one = 1, two.three = 2 }  # head.inline.one | head.inline.two.three
"quoted key" = 1                # head.quoted key
literal = \'\'\'                   # head.literal
[head.after]
\'\'\'
array = [                       # head.array
  "]",                          # head.array.0
  # "not a value",
  "[[table]]",                  # head.array.1
  { key = 1 },                  # head.array.2.key
  [ 1,                          # head.array.3 | head.array.3.0
    2 ], 3,                     # head.array.3.1 | head.array.4
]
mixed = { list = [ 1,           # head.mixed.list | head.mixed.list.0
  2 ], last = 5 }               # head.mixed.list.1 | head.mixed.last

[[table]]                       # table | table.0
key = 1                         # table.0.key
[table.sub]                     # table.0.sub
key = 2                         # table.0.sub.key
[[table]]                       # table.1
[table.sub]                     # table.1.sub
key = 2                         # table.1.sub.key
[[table.inner]]                 # table.1.inner.0
[[table.inner]]                 # table.1.inner.1
key = 3                         # table.1.inner.1.key
[head.late]                     # head.late
'''


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_every_key_is_found_on_its_line(ending: str) -> None:
    text = PLACES.replace("\n", ending)
    for number, line in enumerate(PLACES.splitlines(), 1):
        said = line.partition("   # ")[2] or line.partition("}  # ")[2]
        for key in said.split(" | ") if said else ():
            steps = key.strip().split(".")
            path = tuple(int(step) if step.isdecimal() else step for step in steps)
            assert toml_lines.line_of(text, path) == number, key


def test_a_key_that_is_not_there_is_in_the_table_where_it_would_be() -> None:
    assert toml_lines.line_of(PLACES, ("table", 1, "sub", "missing")) == 31
    assert toml_lines.line_of(PLACES, ("table", 7)) == 26
    assert toml_lines.line_of(PLACES, ("missing",)) == 1


def test_every_path_of_the_example_is_found_at_a_line_that_has_its_key() -> None:
    text = EXAMPLE.read_text(encoding="utf-8")

    def paths(value: Any, path: toml_lines.Path = ()) -> Iterator[toml_lines.Path]:
        pairs = {list: enumerate, dict: dict.items}.get(type(value), lambda _: ())
        for key, inner in pairs(value):
            yield (*path, key)
            yield from paths(inner, (*path, key))

    found = list(paths(tomllib.loads(text)))
    assert len(found) > 50
    for path in found:
        name = next(step for step in reversed(path) if isinstance(step, str))
        assert name in text.splitlines()[toml_lines.line_of(text, path) - 1]


# What is wrong with a file

BEGIN = '[study]\nname = "x"\n'
ASKED = '[[question]]\nkind = "estimate"\nname = "a"\n'
HERE = "[release]\nheight = 2\ndistance = 4\nspeed = 7\nelevation = '52 deg'\n"

WRONG = {
    "syntax": (BEGIN + "seed = \n", 3, "this is not TOML, column 8"),
    "syntax at the end": (BEGIN + 'seed = "', 3, "this is not TOML, at the end"),
    "twice": (BEGIN + 'name = "y"\n', 3, "this is not TOML"),
    "no text": ("\n\xff = 1\n", 2, "expected text in UTF-8; got the byte 0xff"),
    "no questions": (BEGIN, 1, "question: missing"),
    "no study": (ASKED, 1, "study: missing"),
    "unknown table": (
        BEGIN + ASKED + "[scather]\nspeed = 1\n",
        6,
        "scather: unknown key; is scatter meant? One of scene, release, scatter",
    ),
    "unknown key": (BEGIN + "sed = 1\n" + ASKED, 3, "study.sed: unknown key; is seed meant?"),
    "of another kind": (
        BEGIN + ASKED + "over = 3\n",
        6,
        "question #1, over: unknown key. One of scene, release",
    ),
    "wrong unit": (
        BEGIN + "[release]\nspeed = 7\nheight = '7 kg'\n" + ASKED,
        5,
        "release.height: expected a length such as \"7 ft\"; '7 kg': 'kg' is not a unit of length",
    ),
    "implausible": (
        BEGIN + "[release]\nspeed = 7\nheight = '72 ft'\n" + ASKED,
        5,
        "release.height: implausible: expected 0 to 5 m, got '72 ft'",
    ),
    "angle without unit": (
        BEGIN + "[release]\nentry = '52'\n" + ASKED,
        4,
        "release.entry: expected an angle such as \"45 deg\"; '52' has no unit: write 52deg or 52",
    ),
    "bare angle": (
        BEGIN + "[release]\nelevation = 52\n" + ASKED,
        4,
        'release.elevation: expected an angle such as "45 deg"; got 52, which has no unit: '
        'write "52 deg" or "52 rad"',
    ),
    "bare spin": (
        BEGIN + "[release]\nbackspin = 3.0\n" + ASKED,
        4,
        'release.backspin: expected a spin such as "1 Hz"; got 3.0, which has no unit: '
        'write "3.0 Hz", "3.0 rpm", "3.0 rad/s" or "3.0 deg/s"',
    ),
    "wrong type": (
        BEGIN + "seed = 'five'\n" + ASKED,
        3,
        'study.seed: expected a whole number from 0; got "five"',
    ),
    "true is no number": (
        BEGIN + "[scatter]\nspeed = true\n" + ASKED,
        4,
        'scatter.speed: expected a speed such as "7.1 m/s", not below 0; got true',
    ),
    "a date": (
        BEGIN + "[release]\nspeed = 2001-01-01\n" + ASKED,
        4,
        'release.speed: expected a speed such as "7.1 m/s"; got "2001-01-01"',
    ),
    "no table": (BEGIN + ASKED + "scene = 3\n", 6, "question #1, scene: expected a table"),
    "missing name": (
        BEGIN + ASKED + "[[question]]\nkind = 'map'\n[question.over]\nspeed = 7\n",
        6,
        "question #2, name: missing",
    ),
    "missing kind": (
        BEGIN + ASKED + "[[question]]\nname = 'map'\n",
        6,
        'question #2, kind: missing; expected "estimate", "compare"',
    ),
    "wrong kind": (
        BEGIN + ASKED + "[[question]]\nname = 'm'\nkind = 'maps'\n",
        8,
        'question #2, kind: expected "estimate", "compare", "solve", "map", "optimum", "bank", '
        '"aim" or "batch"; got "maps"; is map meant?',
    ),
    "below the range": (
        BEGIN + "[scatter]\nspeed = '-1 m/s'\n" + ASKED,
        4,
        'scatter.speed: expected a speed such as "7.1 m/s", not below 0; got "-1 m/s"',
    ),
    "above the range": (
        BEGIN + "[scene]\npreset = 'nba'\nrestitution = 1.5\n" + ASKED,
        5,
        "scene.restitution: expected a number from 0 to 1; got 1.5",
    ),
    "not finite": (BEGIN + "[release]\nspeed = inf\n" + ASKED, 4, "got Infinity"),
    "too large": (BEGIN + "[release]\nspeed = 1" + 400 * "0" + "\n" + ASKED, 4, "got 1000"),
    "percents": (
        BEGIN + "confidence = 95\n" + ASKED,
        3,
        "study.confidence: expected a number above 0 and below 1; got 95",
    ),
    "not whole": (
        BEGIN + ASKED + "shots = 1.5\n",
        6,
        "question #1, shots: expected a whole number from 1; got 1.5",
    ),
    "none": (
        BEGIN + ASKED + "shots = 0\n",
        6,
        "question #1, shots: expected a whole number from 1",
    ),
    "another word": (
        BEGIN + "[scene]\npreset = 'nbl'\n" + ASKED,
        4,
        'scene.preset: expected "paper", "nba" or "fiba"; got "nbl"; is nba meant?',
    ),
    "name of a folder": (
        BEGIN + "[[question]]\nkind = 'estimate'\nname = '../up'\n",
        5,
        'question #1, name: expected small letters, digits, - and _, at most 60; got "../up"',
    ),
    "name of a device": (
        BEGIN + ASKED + "[[question]]\nkind = 'estimate'\nname = 'com1'\n",
        8,
        'question #2, name: "com1" cannot be a name: on Windows it is a device',
    ),
    "control characters in the name": (
        BEGIN.replace("x", r"a\u001b[31m") + ASKED,
        2,
        r'study.name: expected a line of text; got "a\u001b[31m", with control characters',
    ),
    "control characters in a title": (
        BEGIN + ASKED + 'title = "a\\u009b2J"\n',
        6,
        r'question #1, title: expected a line of text; got "a\x9b2J", with control characters',
    ),
    "control characters in a key": (
        BEGIN + ASKED + '"\\u001b[31m" = 1\n',
        6,
        r"question #1, \x1b[31m: unknown key",
    ),
    "a seed too large": (
        BEGIN + "seed = 18446744073709551616\n" + ASKED,
        3,
        "study.seed: expected a whole number from 0; got 18446744073709551616, more than 2^64 - 1",
    ),
    "a seed without another": (
        BEGIN + "seed = 18446744073709551615\n" + HERE + "[scatter]\nspeed = 1\n"
        "[[question]]\nkind = 'optimum'\nname = 'a'\nover = ['elevation']\n",
        11,
        "question #1: seed: expected 2**64 - 2 at most",
    ),
    "too many shots": (
        BEGIN + ASKED + "shots = 9223372036854775808\n",
        6,
        "shots: expected a whole number from 1; got 9223372036854775808, more than 2^63 - 1",
    ),
    "name taken": (
        BEGIN + ASKED + ASKED,
        8,
        'question #2, name: "a" is another question\'s',
    ),
    "in an inline table": (
        BEGIN + ASKED + "scene = { preset = 'nba', gravty = 9 }\n",
        6,
        "question #1, scene.gravty: unknown key; is gravity meant?",
    ),
    "in a dotted key": (
        BEGIN + ASKED + "\nrelease.height = 2\nrelease.angle = '9 m'\n",
        8,
        'question #1, release.angle: expected an angle such as "45 deg"; ',
    ),
    "in an array of tables": (
        BEGIN + ASKED + 3 * "# a\n" + ASKED.replace('"a"', '"b"') + "shots = 'x'\n",
        12,
        'question #2, shots: expected a whole number from 1; got "x"',
    ),
    "in a table of the second question": (
        BEGIN + ASKED + "[question.release]\nspeed = 1\n"
        "[[question]]\nkind = 'compare'\nname = 'b'\n[question.versus.release]\nspeed = '1 m'\n",
        12,
        "question #2, versus.release.speed: expected a speed",
    ),
    "after look-alikes": (
        BEGIN + 'description = """\n[scene]\npreset = 5\n"""\n' + ASKED + "[scene]\npreset = 5\n",
        11,
        "scene.preset: expected",
    ),
    "in an array over lines": (
        BEGIN + "[[question]]\nkind = 'map'\nname = 'a'\nover.speed = [\n  7,\n  # 8,\n  'x',\n]\n",
        9,
        'question #1, over.speed #2: expected a speed such as "7.1 m/s"; ',
    ),
    "of a range": (
        BEGIN + "[[question]]\nkind = 'map'\nname = 'a'\n[question.over.speed]\nfrom = 7\nto = 8\n",
        6,
        "question #1, over.speed.count: missing",
    ),
    "ends": (
        BEGIN + "[[question]]\nkind = 'optimum'\nname = 'a'\nover.aim = [1, 0]\n",
        6,
        'question #1, over.aim: expected two lengths, ["7 ft", "8 ft"], or "usual", the lower one '
        "first; got [1, 0]",
    ),
    "variables to search over": (
        BEGIN + "[[question]]\nkind = 'optimum'\nname = 'a'\nover = ['aim', 'spin']\n",
        6,
        'question #1, over #2: expected "speed", "elevation"',
    ),
    "no variables": (
        BEGIN + "[[question]]\nkind = 'map'\nname = 'a'\nover = {}\n",
        6,
        "question #1, over: expected 1 or more of speed, elevation",
    ),
    # What only all of it tells
    "release": (BEGIN + ASKED, 3, "question #1: variables: missing height, distance"),
    "aim and speed": (BEGIN + HERE + "aim = 1\n" + ASKED, 9, "aim takes the place of speed"),
    "correlations": (
        BEGIN + HERE + "[scatter]\nspeed = 1\n[correlation]\nspeed.azimuth = 0.5\n" + ASKED,
        12,
        "question #1: correlation: ('speed', 'azimuth') is no pair of speed",
    ),
    "shots of one": (
        BEGIN + HERE + "[[question]]\nkind = 'map'\nname = 'a'\nover.speed = 1\nshots = 2\n",
        8,
        "question #1: shots: without scatter all shots of a cell are one",
    ),
    "no usual ends": (
        BEGIN + HERE + "[scatter]\nspeed = 1\n"
        "[[question]]\nkind = 'optimum'\nname = 'a'\nover = ['height']\n",
        10,
        "question #1: over['height']: expected (low, high); there are no usual bounds",
    ),
    "places": (
        BEGIN + HERE + "[scatter]\nspeed = 1\n"
        "[[question]]\nkind = 'bank'\nname = 'a'\nplaces = { x = 1, distance = 2 }\n",
        10,
        "question #1: places: expected distance and angle, or x and y; got x, distance",
    ),
    "two wanted": (
        BEGIN + HERE + "[[question]]\nkind = 'aim'\nname = 'a'\ndistance = 1\nspeed = 2\n"
        "entry = '1 deg'\n",
        8,
        "question #1: aim: expected entry, elevation or speed",
    ),
    "scatter of many": (
        BEGIN + HERE + "[scatter]\nspeed = 1\n" + ASKED + "releases.file = 'measured.csv'\n",
        10,
        "question #1: scatter: it is about one release, and releases has many",
    ),
    "column": (
        BEGIN + "[[question]]\nkind = 'batch'\nname = 'a'\nfile = 'measured.csv'\n",
        3,
        "measured.csv: variables: missing height, distance. The columns are player, speed_mph",
    ),
    "no file": (
        BEGIN + HERE + ASKED + "[question.releases]\nfile = 'other.csv'\n",
        12,
        "question #1, releases.file: there is no file ",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_said_with_its_line_and_key(case: str, tmp_path: Path) -> None:
    text, line, said = WRONG[case]
    file = written(tmp_path, "")
    file.write_bytes(text.encode("latin-1"))
    with pytest.raises(StudyError) as raised:
        check_study(file)
    (complaint,) = raised.value.complaints
    assert complaint.startswith(f"{file}:{line}: ")
    assert said in complaint


def test_all_that_is_wrong_is_said_in_the_order_of_the_lines(tmp_path: Path) -> None:
    file = written(tmp_path, BEGIN + "seed = -1\n" + ASKED + "shots = 0\n[scatter]\nspin = 1\n")
    result = run("study", file, "--check")
    assert result.exit_code == 2
    assert result.stdout == ""
    starts = [f"hoopgen: error: {file}:{line}: " for line in (3, 7, 9)]
    said = result.stderr.splitlines()
    assert len(said) == len(starts)
    assert all(line.startswith(start) for line, start in zip(said, starts, strict=True))


PAYLOADS = [
    "__import__('os').system('touch evaluated')",
    "${7*7}",
    "{0.__class__}",
    "!!python/object/apply:os.system ['touch evaluated']",
    "$(touch evaluated)",
    "7 ft; import os",
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("payload", PAYLOADS)
def test_nothing_that_is_written_is_evaluated(
    payload: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object, **__: object) -> None:
        raise AssertionError("evaluated")

    monkeypatch.chdir(tmp_path)
    codecs.lookup("utf-8-sig")  # a codec is a module, which is imported when it is first needed
    parse((BEGIN + ASKED).encode(), Path("x"))  # and so are annotations resolved
    with monkeypatch.context() as patch:
        for name in ("eval", "exec", "compile"):
            patch.setattr(builtins, name, refused)
        for key in ("seed", "confidence", "formats", f"{json.dumps(payload)}"):
            with pytest.raises(StudyError):
                parse(f"[study]\n{key} = {json.dumps(payload)}\n".encode(), Path("x"))
        for key in ("release.height", "release.azimuth", "scene.restitution", "scatter.speed"):
            text = BEGIN + ASKED + f"{key} = {json.dumps(payload)}\n"
            with pytest.raises(StudyError):
                parse(text.encode(), Path("x"))
    text = ALL.replace("Where to aim", payload.replace('"', "'"))
    file = written(tmp_path, text.replace("Free throws", payload.replace('"', "'")))
    check_study(file)
    assert not (tmp_path / "evaluated").exists()


# Where shots come from


def setting(tmp_path: Path, text: str, which: int = 0) -> Context:
    return check_study(written(tmp_path, text))[which]


def test_a_question_changes_key_by_key_what_is_given_above(tmp_path: Path) -> None:
    text = HEAD.replace("[scatter]", "[scene]\npreset = 'nba'\nrestitution = 0.75\n[scatter]")
    own = "release.height = 2\nscene.preset = 'fiba'\nscatter.azimuth = 0\n"
    asked = setting(tmp_path, text + ESTIMATE + own).setting
    assert asked.parameters == dict(hoopgen.FIBA | {"restitution": 0.75})
    assert asked.release == {
        "height": 2.0,
        "distance": 13.75 * 0.3048,
        "elevation": 52 * DEGREE,
        "aim": 2 * 0.0254,
        "backspin": 3 * 2 * np.pi,
    }
    assert asked.sd == {"speed": 0.063, "elevation": 1.3 * DEGREE, "azimuth": 0.0}


@pytest.mark.parametrize(
    ("own", "gone", "there"),
    [
        ("speed = 7", {"aim"}, {"speed", "elevation"}),
        ("entry = '45 deg'", {"elevation"}, {"aim", "entry"}),
        ("x = 3\nrelease.y = 1", {"distance"}, {"x", "y"}),
    ],
)
def test_what_says_the_same_in_another_way_gives_way(
    own: str, gone: set[str], there: set[str], tmp_path: Path
) -> None:
    names = set(setting(tmp_path, HEAD + ESTIMATE + f"release.{own}\n").setting.release)
    assert there <= names
    assert not gone & names


def test_no_scatter_takes_the_correlations_with_it(tmp_path: Path) -> None:
    text = HEAD + "[correlation]\nspeed.elevation = -0.3\n" + ESTIMATE
    asked = setting(tmp_path, text).setting
    assert asked.correlation == {("speed", "elevation"): -0.3}
    asked = setting(tmp_path, text + "correlation.elevation.speed = 0.2\n").setting
    assert asked.correlation == {("elevation", "speed"): 0.2}
    asked = setting(tmp_path, text + "scatter = 'none'\n").setting
    assert (asked.sd, asked.correlation) == ({}, {})


# The answers


SCATTER = {"speed": 0.063, "elevation": 1.3 * DEGREE, "azimuth": DEGREE}
RELEASE = {
    "height": 7 * 0.3048,
    "distance": 13.75 * 0.3048,
    "elevation": 52 * DEGREE,
    "aim": 2 * 0.0254,
    "backspin": 3 * 2 * np.pi,
}


def without(*names: str) -> dict[str, float]:
    return {name: value for name, value in RELEASE.items() if name not in names}


@pytest.mark.slow
def test_estimates_and_comparisons_are_those_of_the_library(whole: Path) -> None:
    model = hoopgen.Scatter(RELEASE, SCATTER)
    found = hoopgen.estimate(model, shots=300_000, seed=5).as_dict()
    assert loaded(whole, "probability") == in_units(found)
    first = hoopgen.Scatter(RELEASE | {"backspin": 0.0}, SCATTER)
    found = hoopgen.compare(first, model, shots=2000, seed=5).as_dict()
    assert loaded(whole, "backspin") == in_units(found)


@pytest.mark.slow
def test_measured_releases_are_drawn_from(whole: Path) -> None:
    mile = 1609.344 / 3600
    columns = {
        "speed": np.array([15.9, 16.1, 15.8]) * mile,
        "elevation": np.array([52.0, 51.0, 53.0]) * DEGREE,
        "azimuth": np.array([0.5, -0.5, 0.0]) * DEGREE,
    }
    here = hoopgen.estimate(
        hoopgen.Resample({**without("aim", "elevation"), **columns}), shots=1000, seed=5
    )
    found = loaded(whole, "measured")
    assert [found[name] for name in ("made", "missed", "kinds")] == [
        here.made,
        here.missed,
        here.kinds,
    ]


def test_columns_take_the_place_of_what_is_above_and_give_way_to_what_is_beside(
    tmp_path: Path,
) -> None:
    text = HEAD + "[[question]]\nkind = 'estimate'\nname = 'a'\nscatter = 'none'\n"
    text += "releases.file = 'measured.csv'\n"

    def columns(own: str) -> dict[str, int]:
        model = setting(tmp_path, text + own).setting.model()
        assert isinstance(model, hoopgen.Resample)
        return {name: np.ndim(column) for name, column in model.columns.items()}

    fixed = {"height": 0, "distance": 0, "backspin": 0}
    angles = {"elevation": 1, "azimuth": 1}
    assert columns("") == fixed | angles | {"speed": 1}
    assert columns("release.aim = 0.1\n") == fixed | angles | {"aim": 0}
    assert columns("release.azimuth = 0\n") == fixed | {"speed": 1, "elevation": 1, "azimuth": 0}


@pytest.mark.slow
def test_maps_are_those_of_the_library(whole: Path) -> None:
    over = {
        "elevation": np.linspace(48 * DEGREE, 56 * DEGREE, 3),
        "aim": [0.0, 2 * 0.0254],
    }
    dataset = hoopgen.map(
        hoopgen.Scatter(without("elevation", "aim"), SCATTER), over, shots=200, seed=5
    )
    with xr.open_dataset(whole / "map" / "map.nc", engine="scipy") as there:
        for name in ("elevation", "aim", "probability", "low", "high", "made"):
            assert there[name].equals(dataset[name])
            assert there[name].attrs["units"] == dataset[name].attrs["units"]
    best = loaded(whole, "map")["best"]
    assert best["probability"] == dataset["probability"].max()
    over = {"speed": [6.9, 7.1, 7.3], "elevation": np.array([50, 52]) * DEGREE}
    dataset = hoopgen.map(hoopgen.Scatter(without("aim", "elevation")), over)
    with xr.open_dataset(whole / "outcomes" / "map.nc", engine="scipy") as there:
        assert np.array_equal(there["outcome"], dataset["outcome"])
    shares = loaded(whole, "outcomes")["shares"]
    assert sum(shares.values()) == pytest.approx(1.0, abs=1e-15, rel=0)  # rounding of six sums
    assert shares["made"] == np.mean(dataset["outcome"] == hoopgen.Outcome.MADE)


@pytest.mark.slow
def test_bank_shots_are_those_of_the_library(whole: Path) -> None:
    places = [(1.5, 1.0), (1.5, -1.0), (2.0, 1.0), (2.0, -1.0)]
    release = without("distance", "elevation", "aim")
    dataset = bank_or_direct(hoopgen.Scatter(release, SCATTER), places, shots=100, seed=5)
    with xr.open_dataset(whole / "bank" / "bank.nc", engine="scipy") as there:
        for name in dataset.data_vars:
            assert np.array_equal(there[name], dataset[name]), name
        assert list(zip(there["x"].values, there["y"].values, strict=True)) == places


@pytest.mark.slow
def test_aims_and_optima_are_those_of_the_library(whole: Path) -> None:
    from hoopgen.study.questions.aim_table import aim_table

    table = aim_table(
        [3.0, 13.75 * 0.3048],
        height=RELEASE["height"],
        entry=45 * DEGREE,
        backspin=RELEASE["backspin"],
    )
    columns = {named(name): column.tolist() for name, column in table.items()}
    assert loaded(whole, "table") == columns
    assert (whole / "table" / "table.csv").read_text().startswith("distance_m,angle_deg,")
    over = {"elevation": None, "aim": (0.0, 4 * 0.0254)}
    fixed = without("elevation", "aim")
    best = hoopgen.optimum(
        hoopgen.Scatter(fixed, SCATTER), over, shots=500, seed=5, margins=["speed"]
    )
    assert loaded(whole, "best") == json.loads(json.dumps(in_units(best.as_dict())))


def test_a_table_is_simulated_as_by_batch(whole: Path, tmp_path: Path) -> None:
    written(tmp_path, "")
    fixed = {"height": RELEASE["height"], "distance": RELEASE["distance"]}
    counts = hoopgen.batch(
        tmp_path / "measured.csv", tmp_path / "out.parquet", release=fixed, measures=["depth"]
    )
    assert loaded(whole, "rows") == counts
    there = (whole / "rows" / "results.parquet").read_bytes()
    assert there == (tmp_path / "out.parquet").read_bytes()


def test_the_report_lists_what_was_asked_and_every_answer(whole: Path) -> None:
    text = (whole / "report.md").read_text(encoding="utf-8")
    for name in tomllib.loads(ALL)["question"]:
        line = json.loads((whole / name["name"] / "answer.json").read_bytes())["line"]
        assert f"| [{name.get('title', name['name'])}](#{name['name']}) | {line} |" in text
    assert 'versus.release.backspin = "3 Hz"' in text
    found = loaded(whole, "probability")
    for share in ("probability", "low", "high"):
        assert f"{100 * found[share]:.2f}%" in text
    links = re.findall(r"\]\(([^#)]+)\)", text)
    assert len(links) > 20
    assert all((whole / link).is_file() for link in links)
    files = {name.partition("/")[0] + "/" + name.partition("/")[2] for name in contents(whole)}
    files -= {name for name in files if "/chunks/" in name}  # from which it may go on
    files -= {name for name in files if name.endswith("hoopgen.json")}
    assert {name for name in files if not name.endswith("/")} <= {*links, "report.md"}


def test_a_report_holds_titles_as_text_and_a_description_as_markdown(tmp_path: Path) -> None:
    head = HEAD.replace(
        'name = "Free throws"',
        'name = "<b>Free</b> *throws*"\n'
        'description = "See <https://a.b/c>, *all* of <img src=x onerror=alert(1)>, 1 < 2"',
    )
    title = r"<script>alert(1)</script> | [a](b) `c` $d$ # e"
    text = f'{head}{ESTIMATE}title = "{title}"\n'
    run_study(written(tmp_path, text))
    report = (tmp_path / "study-results" / "report.md").read_text(encoding="utf-8")
    lines = report.splitlines()
    assert lines[0] == r"# &lt;b&gt;Free&lt;/b&gt; \*throws\*"
    assert lines[2] == "See <https://a.b/c>, *all* of &lt;img src=x onerror=alert(1)>, 1 < 2"
    said = r"&lt;script&gt;alert(1)&lt;/script&gt; \| \[a\](b) \`c\` \$d\$ \# e"
    assert f"## {said}" in lines
    assert sum(line.startswith(f"| [{said}](#probability) | ") for line in lines) == 1
    assert not re.findall(r"<(?!a id=|/a>|https:)\w", report)
    assert report_text("one\r# two\x1b[31m") == r"one \# two\\x1b\[31m"


def test_the_report_holds_errors_as_text(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lost = "[[question]]\nkind = 'optimum'\nname = 'lost'\nshots = 100\nover.elevation = {}\n"
    file = written(tmp_path, HEAD + lost.format("['1 deg', '2 deg']") + ESTIMATE)
    monkeypatch.setattr(sweeps, "optimum", _fails)
    with pytest.raises(ExceptionGroup):
        run_study(file)
    report = (tmp_path / "study-results" / "report.md").read_text(encoding="utf-8")
    assert r"| not answered: &lt;b&gt; \| \*x\* |" in report
    assert "Not answered: &lt;b&gt; \\| \\*x\\*\n" in report


def _fails(*_: Any, folder: Path | None = None, **__: Any) -> None:
    if folder is not None:  # not where the question is checked alone
        raise ValueError("<b> |\n*x*")


def test_the_folder_has_the_file_as_it_was_and_the_versions(whole: Path) -> None:
    assert (whole / "study.toml").read_text(encoding="utf-8") == ALL
    versions = json.loads((whole / "versions.json").read_bytes())
    assert versions["hoopgen"] == hoopgen.__version__
    assert versions["numpy"] == np.__version__
    assert {"python", "scipy", "pyarrow", "platform"} <= set(versions)
    names = {question["name"] for question in tomllib.loads(ALL)["question"]}
    assert {path.name for path in whole.iterdir()} == names | {
        "study.toml",
        "versions.json",
        "report.md",
        "hoopgen.json",
    }


def test_what_is_not_a_number_is_null(tmp_path: Path) -> None:
    text = HEAD + "[[question]]\nkind = 'aim'\nname = 'a'\ndistance = 1\nspeed = 1\n"
    run_study(written(tmp_path, text))
    assert loaded(tmp_path / "study-results", "a")["elevation_rad"] == [None]


# The same bytes


@pytest.mark.slow
def test_the_same_study_gives_the_same_bytes_by_any_number_of_threads(
    whole: Path, tmp_path: Path
) -> None:
    run_study(written(tmp_path / "other", ALL), tmp_path / "results", threads=2)
    assert contents(tmp_path / "results") == contents(whole)


@pytest.mark.slow
def test_a_study_that_was_killed_goes_on_to_the_same_bytes(whole: Path, tmp_path: Path) -> None:
    """Killed again and again: when it begins, among chunks, and with a question finished."""
    file, results = written(tmp_path / "other", ALL), tmp_path / "results"

    def killed_at(sync: int) -> set[str]:
        killed = run_until_sync(file, results, sync)
        assert killed.returncode == -signal.SIGKILL, killed.stderr
        return {path.relative_to(results).as_posix() for path in results.rglob("*")}

    assert "versions.json" not in killed_at(3)
    there = killed_at(22)
    assert "probability.unfinished/chunks/chunk-000000001.arrow" in there
    assert "probability.unfinished/answer.json" not in there
    there = killed_at(38)
    assert "probability/answer.json" in there
    assert "report.md" not in there
    run_study(file, results)
    assert contents(results) == contents(whole)


# The folder


def test_a_question_that_has_changed_is_refused_with_what_differs(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    run_study(file)
    results = tmp_path / "study-results"
    before = contents(results)
    written(tmp_path, HEAD.replace("0.063", "0.07") + ESTIMATE + "max_contacts = 30\n")
    with pytest.raises(ValueError, match="holds another study: question probability: ") as raised:
        run_study(file)
    assert "max_contacts is 40 there and 30 here" in str(raised.value)
    assert "setting.sd.speed is 0.063 there and 0.07 here" in str(raised.value)
    assert contents(results) == before
    written(tmp_path, HEAD + ESTIMATE.replace("probability", "other"))
    with pytest.raises(ValueError, match="it has the question probability, which the study has"):
        run_study(file)
    assert contents(results) == before


def test_so_is_one_that_was_not_finished(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    run_study(file)
    results = tmp_path / "study-results"
    (results / "probability").rename(results / "probability.unfinished")
    written(tmp_path, HEAD + ESTIMATE + "max_contacts = 30\n")
    with pytest.raises(ValueError, match="max_contacts is 40 there and 30 here"):
        run_study(file)


MORE = {
    "more shots": ("shots = 1700", "shots = 2600"),
    "shots for once": ("shots = 99_999\nprecision = 0.02", "shots = 100_000\nprecision = 0.015"),
    "a narrower precision": ("precision = 0.02", "precision = 0.015"),
}
"""Settings of an estimate or a comparison, before and after a change."""


@pytest.mark.sampled(2)
@pytest.mark.parametrize("unfinished", [False, True])
@pytest.mark.parametrize("more", MORE)
@pytest.mark.parametrize("kind", ["estimate", "compare"])
def test_a_question_may_be_asked_for_more_and_only_the_rest_is_thrown(
    kind: str, more: str, unfinished: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = HEAD + f"[[question]]\nname = 'q'\nkind = '{kind}'\n"
    text += "versus.release.backspin = 0\n" * (kind == "compare")
    monkeypatch.setattr(monte_carlo, "CHUNK", 1000)
    few, many = MORE[more]
    whole, results = tmp_path / "whole", tmp_path / "results"
    run_study(written(tmp_path / "at-once", text + many), whole)
    file = written(tmp_path, text + few)
    run_study(file, results, threads=2)
    if unfinished:
        (results / "q").rename(results / "q.unfinished")
    thrown: list[int] = []
    count = monte_carlo.MonteCarloJob.count
    monkeypatch.setattr(
        monte_carlo.MonteCarloJob,
        "count",
        lambda work, *ends: (thrown.extend(range(*ends)), count(work, *ends))[1],
    )
    written(tmp_path, text + many)
    run_study(file, results, threads=1)
    kept = 1700 if more == "more shots" else 1000
    assert thrown
    assert not {*range(1, kept)} & {*thrown}
    assert contents(results) == contents(whole)


@pytest.mark.sampled(1)
@pytest.mark.parametrize("interrupted", [False, True])
@pytest.mark.parametrize("kind", ["estimate", "compare"])
@pytest.mark.parametrize(
    "less", ["shots = 999", "precision = 0.03", "shots = 2700\nprecision = 0.02"]
)
def test_a_question_may_be_asked_for_less_and_what_was_thrown_stays(
    kind: str, less: str, interrupted: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The folder of a study behaves as that of an estimate alone."""
    text = HEAD + f"[[question]]\nname = 'q'\nkind = '{kind}'\n"
    text += "versus.release.backspin = 0\n" * (kind == "compare")
    monkeypatch.setattr(monte_carlo, "CHUNK", 500)
    results, many = tmp_path / "results", "shots = 2700"
    file = written(tmp_path / "study", text + many)
    run_study(file, results)
    before = contents(results)
    written(file.parent, text + less)
    if interrupted:
        with pytest.raises(KeyboardInterrupt):
            run_study(file, results, progress=_stopped)
    (answer,) = run_study(file, results).values()
    assert answer == run_study(file, tmp_path / "at-once")["q"]
    chunks = {name: content for name, content in before.items() if "chunks/" in name}
    assert len(chunks) >= 6
    assert chunks.items() <= contents(results).items()
    assert not (results / "q" / "kept.json").exists()
    # And back again: nothing is thrown.
    written(file.parent, text + many)
    with monkeypatch.context() as patch:
        patch.setattr(monte_carlo.MonteCarloJob, "counted", None)
        run_study(file, results)
    assert contents(results) == before


@pytest.mark.slow
def test_a_map_may_be_asked_for_other_shots_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sweep, "BLOCK", 256)
    monkeypatch.setattr(sweep, "CHUNK", 600)
    text = HEAD + "[[question]]\nname = 'q'\nkind = 'map'\nfigures = ['map']\n"
    text += "over.elevation = { from = '48 deg', to = '56 deg', count = 5 }\n"
    few, many = text + "shots = 300", text + "shots = 700"
    run_study(written(tmp_path / "at-once", many), tmp_path / "whole")
    file, results = written(tmp_path / "study", few), tmp_path / "results"
    (first,) = run_study(file, results).values()
    written(file.parent, many)
    run_study(file, results)
    whole = contents(results)
    assert whole == contents(tmp_path / "whole")
    written(file.parent, few)
    assert run_study(file, results) == {"q": first}
    chunks = {name: content for name, content in whole.items() if "chunks/" in name}
    assert chunks.items() <= contents(results).items()
    with pytest.raises(ValueError, match="over"):  # other cells are another question
        run_study(written(file.parent, few.replace("count = 5", "count = 6")), results)


def _stopped(*_: Any) -> Any:
    raise KeyboardInterrupt


@pytest.mark.slow
def test_a_figure_that_fewer_shots_do_not_have_does_not_stay(tmp_path: Path) -> None:
    figures = 'figures = ["landings"]\nrelease.speed = 7.2\nscatter.azimuth = "0.3 deg"\n'
    question = ESTIMATE.replace("shots = 2000\n", "") + figures
    file = written(tmp_path, HEAD.replace('aim = "2 in"\n', "") + question + "shots = 2000\n")
    (answer,) = run_study(file).values()
    assert answer.numbers["missed"] > 0
    there = tmp_path / "study-results" / "probability" / "landings.png"
    assert there.exists()
    file.write_text(file.read_text().replace("shots = 2000", "shots = 1"))
    (answer,) = run_study(file).values()
    assert answer.line.endswith("so there is no picture of where")
    assert not there.exists()


def test_nothing_else_of_a_question_may_change(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    run_study(file)
    before = contents(tmp_path / "study-results")
    written(tmp_path, HEAD + ESTIMATE.replace("2000", "3000") + "max_contacts = 30\n")
    with pytest.raises(ValueError, match="holds another study: question probability: "):
        run_study(file)
    assert contents(tmp_path / "study-results") == before


@pytest.mark.parametrize("package", ["hoopgen", "numpy", "elementary functions"])
def test_answers_by_other_versions_are_another_study(package: str, tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    run_study(file)
    asked = tmp_path / "study-results" / "probability" / "question.json"
    others = json.loads(asked.read_bytes()) | {package: "9.9"}
    asked.write_text(json.dumps(others), encoding="utf-8")
    with pytest.raises(ValueError, match=rf'probability: {package} is "9\.9" there and "[^"]*" h'):
        run_study(file)


def test_measured_releases_that_have_changed_are_another_study(tmp_path: Path) -> None:
    text = (
        ALL[: ALL.index("[[question]]")]
        + ALL[ALL.index('[[question]]\nkind = "estimate"\nname = "measured"') :]
    )
    file = written(tmp_path, text)
    run_study(file)
    (tmp_path / "measured.csv").write_text(MEASURED.replace("15.9", "15.7"), encoding="utf-8")
    with pytest.raises(
        ValueError, match=r"question measured: setting\.sha256 is .* question rows: "
    ):
        run_study(file)


def test_questions_may_be_added_and_words_changed(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    first = run_study(file)
    more = ESTIMATE.replace("probability", "more").replace("2000", "1000")
    written(tmp_path, "# better\n" + HEAD.replace("Free throws", "Throws") + more + ESTIMATE)
    asked = set[str]()
    again = run_study(file, progress=lambda name, *_: asked.add(name))
    assert asked == {"more"}
    assert list(again) == ["more", "probability"]
    assert again["probability"] == first["probability"]
    results = tmp_path / "study-results"
    assert (results / "study.toml").read_bytes() == file.read_bytes()
    assert (results / "report.md").read_text(encoding="utf-8").startswith("# Throws\n")


def test_a_folder_with_something_else_is_left_alone(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    with pytest.raises(ValueError, match=r"did not make: measured\.csv, study\.toml; give"):
        run_study(file, tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["measured.csv", "study.toml"]


@pytest.mark.sampled(4)
@pytest.mark.parametrize("content", ["{", "[1]", "null", '"text"', "[" * 100_000])
def test_a_damaged_question_is_named(content: str, tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    run_study(file)
    damaged = tmp_path / "study-results" / "probability" / "question.json"
    whole = damaged.read_bytes()
    damaged.write_text(content)
    with pytest.raises(ValueError, match=r"question\.json cannot be read; move .*probability out"):
        run_study(file)
    damaged.write_bytes(whole)
    damaged.with_name("answer.json").write_text(content)
    with pytest.raises(ExceptionGroup) as raised:
        run_study(file)
    (error,) = raised.value.exceptions
    assert re.search(
        r"answer\.json cannot be read; move .*probability out of the study", str(error)
    )


def test_an_error_that_was_not_foreseen_is_told_with_its_type(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: Any) -> None:
        raise KeyError("wrong")

    file = written(tmp_path, HEAD + ESTIMATE)
    monkeypatch.setattr("hoopgen.studyfile.question_folders.answer", broken)
    result = run("study", file)
    assert result.exit_code == 70
    first, second = result.stderr.splitlines()
    assert first == "hoopgen: error: question probability: KeyError: 'wrong'"
    assert second.startswith("hoopgen: error: hoopgen study: 1 of 1 question could not be answered")
    assert "HOOPGEN_TRACEBACK=1" in second


@pytest.mark.skipif(sys.platform == "win32", reason="there are no pipes")
@pytest.mark.parametrize("name", ["question.json", "answer.json"])
def test_a_pipe_in_place_of_a_file_is_named_and_not_waited_for(name: str, tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    run_study(file)
    place = tmp_path / "study-results" / "probability" / name
    place.unlink()
    os.mkfifo(place)
    result = run("study", file)
    assert result.exit_code == 2
    assert f"{place}" in result.stderr
    assert "this is no file; move it away" in result.stderr


def test_a_file_in_place_of_a_question_is_named_before_the_work(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    run_study(file)
    results = tmp_path / "study-results"
    (results / "more").touch()
    written(tmp_path, HEAD + ESTIMATE + ESTIMATE.replace("probability", "more"))
    with pytest.raises(ExceptionGroup) as raised:
        run_study(file)
    (error,) = raised.value.exceptions
    assert isinstance(error, FileExistsError)
    assert error.filename == str(results / "more")
    assert not (results / "more.unfinished").exists()


def test_what_cannot_be_is_said_once_and_before_a_folder_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("distributed")
    file = written(tmp_path / "study", HEAD + ESTIMATE)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ValueError, match="scheduler: expected an address such as tcp://10"):
        run_study(file, scheduler="10.0.0.1")
    with pytest.raises(ValueError, match="out: expected the name of a folder, got ''"):
        run_study(file, "")
    assert sorted(path.name for path in tmp_path.rglob("*")) == [
        "measured.csv",
        "study",
        "study.toml",
    ]


def test_a_seed_is_as_large_as_the_library_takes(tmp_path: Path) -> None:
    text = HEAD.replace("seed = 5", "seed = 18446744073709551615") + ESTIMATE
    run_study(written(tmp_path, text))
    assert loaded(tmp_path / "study-results", "probability")["seed"] == 2**64 - 1


def test_a_question_that_fails_leaves_the_others_alone(tmp_path: Path) -> None:
    far = "[[question]]\nkind = 'optimum'\nname = 'far'\nshots = 100\n"
    far += "over.elevation = ['1 deg', '2 deg']\n"  # so flat that none comes down into the ring
    file = written(tmp_path, HEAD + far + ESTIMATE)
    with pytest.raises(ExceptionGroup, match="1 of 2 questions could not be answered") as raised:
        run_study(file)
    (error,) = raised.value.exceptions
    assert isinstance(error, ValueError)
    assert error.__notes__ == ["question far"]
    results = tmp_path / "study-results"
    text = (results / "report.md").read_text(encoding="utf-8")
    assert f"| [far](#far) | not answered: {error} |" in text
    assert loaded(results, "probability")["shots"] == 2000
    assert not (results / "hoopgen.lock").exists()
    result = run("study", file)
    assert result.exit_code == 2
    assert result.stderr.splitlines()[0] == f"hoopgen: error: question far: {error}"
    assert result.stderr.count("\n") == 2


def test_progress_is_told_of_each_question(tmp_path: Path) -> None:
    seen: list[tuple[str, int, int | None]] = []
    run_study(
        written(tmp_path, HEAD + ESTIMATE.replace("2000", "300_000")),
        progress=lambda *said: seen.append(said),
    )
    assert seen == [("probability", done, 3) for done in range(4)]


def test_work_goes_to_a_scheduler_in_pieces_that_travel(tmp_path: Path) -> None:
    asked = setting(tmp_path, ALL, 4)
    assert isinstance(asked.question, KINDS["bank"])
    job = sweeps._Places(((1.5, 1.0),), {}, asked.setting.parameters, asked.arguments)
    assert pickle.loads(pickle.dumps(job)) == job


# The command


def test_the_command_says_every_answer_and_where_the_report_is(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE)
    result = succeed("study", file, "--out", tmp_path / "out", "--threads", "1")
    assert result.stderr == ""
    line = json.loads((tmp_path / "out" / "probability" / "answer.json").read_bytes())["line"]
    report = tmp_path / "out" / "report.md"
    assert result.stdout == f"probability  {line}\nreport       {report}\n"
    assert report.is_file()


def test_check_reads_and_computes_nothing(tmp_path: Path) -> None:
    file = written(tmp_path, ALL)
    result = succeed("study", file, "--check")
    assert result.stdout.startswith(f"{file}: 10 questions, probability, backspin, map")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["measured.csv", "study.toml"]


def test_a_precision_that_was_not_reached_is_said(tmp_path: Path) -> None:
    file = written(tmp_path, HEAD + ESTIMATE + "precision = 0.001\n")
    assert "the precision was not reached" in run_study(file)["probability"].line


# The example and the reference


@pytest.mark.slow
def test_the_example_runs_reduced(tmp_path: Path) -> None:
    text = EXAMPLE.read_text(encoding="utf-8")
    check_study(EXAMPLE)
    text = re.sub(r"shots = \S+", "shots = 300", text)
    text = re.sub(r"count = \d+", "count = 3", text).replace("precision = 0.002", "shots = 300")
    found = run_study(written(tmp_path, text))
    assert list(found) == ["probability", "backspin", "map", "best"]
    files = {path.name for path in (tmp_path / "study-results").rglob("*.svg")}
    assert files == {"fan.svg", "landings.svg", "map.svg"}


def test_the_page_of_the_study_file_is_what_the_schema_says() -> None:
    """`hoopgen study --reference > docs/study.md` writes it."""
    page = ROOT / "docs" / "study.md"
    assert page.read_text(encoding="utf-8") == reference() == run("study", "--reference").stdout


def test_the_study_on_that_page_can_be_run(tmp_path: Path) -> None:
    (text,) = re.findall(r"```toml\n(.*?)```", reference(), re.DOTALL)
    (asked,) = check_study(written(tmp_path, text))
    assert asked.question.name == "no-spin"


def test_every_key_is_on_that_page() -> None:
    text = reference()
    for kind, table in KINDS.items():
        _, _, section = text.partition(f'### `kind = "{kind}"`')
        assert section
        for name in set(table.model_fields) - {shared for shared, *_ in settings(Question)}:
            assert f"| `{name}` | " in section.partition("###")[0], (kind, name)


@pytest.mark.slow
def test_a_scatter_is_fitted_to_measured_releases(tmp_path: Path) -> None:
    """With the known errors of the instrument, and the interval of the fit; also in a search."""
    random, mile = np.random.default_rng(9), 1609.344 / 3600
    speeds, angles = random.normal(16.0, 0.2, 60), random.normal(52.0, 1.5, 60)
    rows = [f"Ann,{speed},{angle}" for speed, angle in zip(speeds, angles, strict=True)]
    text = HEAD + "[[question]]\nkind = 'estimate'\nname = 'a'\nscatter = 'none'\nshots = 2000\n"
    text += "[question.releases]\nfile = 'many.csv'\nfitted = true\n"
    text += "instrument.speed = '0.05 mph'\n"
    file = written(tmp_path, text)
    (tmp_path / "many.csv").write_text(
        "\n".join(["player,speed_mph,elevation_deg", *rows]) + "\n", encoding="utf-8"
    )
    fitted = hoopgen.Scatter.fit(
        {**without("aim", "elevation"), "speed": speeds * mile, "elevation": angles * DEGREE},
        measurement_covariance={"speed": (0.05 * mile) ** 2},
    )
    run_study(file)
    found = loaded(tmp_path / "study-results", "a")
    here = hoopgen.estimate(fitted, shots=2000, seed=5)
    assert found == in_units(here.as_dict())
    source = setting(tmp_path, text).setting
    moved = source.model(("elevation",))
    assert isinstance(moved, hoopgen.Scatter)
    assert "elevation" not in moved.release
    assert moved.sd == fitted.model.sd
    assert source.identity()["fitted"] == fitted.as_dict()
    for wrong, said in (
        ("group = 'player'\n", "releases.group: with fitted there is one scatter"),
        ("fitted = false\n", "releases.instrument: it is of fitted"),
    ):
        changed = text.replace("fitted = true\n", "") if "false" in wrong else text
        with pytest.raises(ValueError, match=said):
            setting(tmp_path, changed + wrong).setting.model()
