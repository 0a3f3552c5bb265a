"""A new result field: how many files must know of it, and where it is seen without being named."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path
from typing import get_args, get_type_hints

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import COURT
from hoopgen.results import shots
from tests.helpers import ROOT
from tests.packaging.test_layers import LINES

MAX_FILES = 3

CHANGES = {
    # the record, and the variable that a shot keeps
    "derive/state/fields.py": {
        '        Field("outcome", IN_FLIGHT,': "        Field("
        '"longest_flight", 0.0, "longest time between two events", True),\n'
        '        Field("outcome", IN_FLIGHT,',
        '            "a decision lies within its rounding-error bound",\n'
        "            is_diagnostic=True,\n"
        "            is_judged=True,\n"
        "        ),\n": '            "a decision lies within its rounding-error bound",\n'
        "            is_diagnostic=True,\n"
        "            is_judged=True,\n"
        "        ),\n"
        '        ResultField("longest_flight", "float64", ("longest_flight",),\n'
        '            "s, longest flight",\n'
        '            is_empty_if_invalid=True, is_diagnostic=True, units=("s",),\n'
        '            tally="moved", tally_summary="shots that moved"),\n',
    },
    # the decision that assigns it
    "derive/loop/predicates.py": {
        '{"clock": clock + when}': '{"clock": clock + when, "longest_flight": '
        'maximum(sp.Symbol("longest_flight", nonnegative=True), when)}',
    },
    # its type and its documentation
    "hoopgen/results/shots.py": {
        "    events: NDArray[np.void]\n": "    longest_flight: NDArray[np.float64]\n"
        "    events: NDArray[np.void]\n",
        "    events\n        With": "    longest_flight\n"
        "        float64 (n,), s: the longest time between two events.\n"
        "    events\n        With",
    },
}
"""Texts and their replacements by file, which add a field with a shot's number."""

# After ``-S`` hoopgen's own installation is not found: no .pth file is read.
_START = f"""
import sys
sys.path[:0] = [sys.argv[1]]
sys.path.append({sysconfig.get_paths()["purelib"]!r})
"""

_GENERATE = """
from pathlib import Path
from hoopgen.codegen.render import render_scene
from hoopgen.derive.scenes import HOOP
for name, text in render_scene(HOOP, page=False, targets=["numpy"]).items():
    Path(sys.argv[1], "generated", name).write_text(text, encoding="utf-8")
"""

_READ = """
import csv, json
from pathlib import Path
import numpy as np
from click.testing import CliRunner
import hoopgen
from hoopgen.cli import main
from hoopgen.judge import certify
from hoopgen.judge.settle import settle
from hoopgen.scene.names import check_name
from hoopgen.study.statistics.tally import Tally, fields_of

folder, file = Path(sys.argv[2]), sys.argv[3]
scene = hoopgen.compile(hoopgen.load_scene(file))
assert scene.library is not None, scene.found
generator = np.random.default_rng(5)
states = np.zeros((300, 9))
states[:, :3] = generator.uniform((-1, -1, 0.3), (1, 1, 2), (300, 3))
states[:, 3:6] = generator.uniform(-2, 2, (300, 3))

# engines: the same bits, and the numbers of the log; without it the path is the same
shots, other = (scene.simulate(states, backend=b, record=True) for b in ("c", "numpy"))
for name in scene.layout.fields:
    np.testing.assert_array_equal(getattr(shots, name), getattr(other, name), name)
plain = scene.simulate(states, fields=("outcome", "state"))
assert np.array_equal(plain.state, shots.state, equal_nan=True)
assert not hasattr(plain, "longest_flight")
valid = np.flatnonzero(shots.outcome != scene.outcomes["INVALID"])
assert len(valid) > 100 and np.isnan(np.delete(shots.longest_flight, valid)).all()
for row in valid:
    times = shots.events["time"][shots.events["shot"] == row]
    if len(times):
        # The difference of two rounded times is not the duration that one is the sum of.
        own = np.diff(times, prepend=0.0).max()
        assert abs(own - shots.longest_flight[row]) <= 4 * np.spacing(times[-1])

# Shots, frames, documentation
assert "longest_flight" in hoopgen.Shots.__doc__
assert "longest_flight_s" in shots.to_pandas().columns
assert shots.to_xarray()["longest_flight"].attrs["units"] == "s"
assert "longest_flight (s)" in shots._repr_html_()
assert "longest time between two events" in hoopgen.load_scene(file).explain()
try:
    scene.simulate(states, fields=("nothing",))
except ValueError as error:
    assert "longest_flight" in str(error)

# tables
names = ("x", "y", "z", "vx", "vy", "vz", "wx_rad_s", "wy_rad_s", "wz_rad_s")
np.savetxt(folder / "in.csv", states, delimiter=",", header=",".join(names), comments="")
hoopgen.batch(folder / "in.csv", folder / "out.csv", scene=scene)
with (folder / "out.csv").open() as out:
    lines = (line for line in out if not line.startswith("#"))
    column = [row["longest_flight_s"] for row in csv.DictReader(lines)]
assert [float(c or "nan") for c in np.array(column)[valid]] == shots.longest_flight[valid].tolist()

# tallies
assert "longest_flight" in fields_of(scene)
counts = Tally.from_shots(shots, 1).counts["moved"]
assert counts.tolist() == [np.count_nonzero(shots.longest_flight)]

# certificates: the judge does not know it, and a settled shot keeps it
assert not hasattr(certify(states[valid[:2]], scene=scene), "longest_flight")
settled = scene.simulate(states, settle=True)
assert np.array_equal(settled.longest_flight, shots.longest_flight, equal_nan=True)
doubted = {name: getattr(shots, name).copy() for name in scene.layout.fields}
doubted["uncertain"][valid[:40]] = True
assert len(settle(doubted, states, {}, scene=scene))
assert np.array_equal(doubted["longest_flight"], shots.longest_flight, equal_nan=True)

# command line
one = int(valid[0])
place, speed = (",".join(map(repr, states[one, k : k + 3].tolist())) for k in (0, 3))
options = ["--scene", file, f"--position={place}", f"--velocity={speed}", "--json"]
told = CliRunner().invoke(main, ["shot", *options])
assert told.exit_code == 0, told.output
assert json.loads(told.output)["longest_flight_s"] == shots.longest_flight[one]

# names of a stranger's scene
try:
    check_name("own", "parameter", "longest_flight")
except ValueError as error:
    assert "names a result" in str(error)
else:
    raise AssertionError("a parameter may have the name of a result")
"""


@pytest.fixture(scope="module")
def changed_copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Sources in which a shot has one more number, and the generated module of the hoop."""
    root = tmp_path_factory.mktemp("sources")
    for folder in ("hoopgen", "derive", "generated", "templates"):
        ignored = shutil.ignore_patterns("__pycache__", "_hoop.*", "_court.*")
        shutil.copytree(ROOT / folder, root / folder, ignore=ignored)
    shutil.copy(ROOT / "pyproject.toml", root)
    for name, replaced in CHANGES.items():
        text = (root / name).read_text(encoding="utf-8")
        for old, new in replaced.items():
            assert text.count(old) == 1, f"{name}: {old}"
            text = text.replace(old, new)
        (root / name).write_text(text, encoding="utf-8")
    _run(root, _GENERATE)
    return root


def _run(root: Path, code: str, *arguments: str | Path) -> None:
    done = subprocess.run(
        [sys.executable, "-S", "-c", _START + code, root, *arguments],
        cwd=root,
        env=os.environ | {"XDG_CACHE_HOME": str(root / "cache")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_a_new_field_leaves_no_file_too_long() -> None:
    for name, replaced in CHANGES.items():
        text = (ROOT / name).read_text(encoding="utf-8")
        for old, new in replaced.items():
            text = text.replace(old, new)
        if name.startswith("hoopgen/"):
            assert len(text.splitlines()) <= LINES, name


def test_a_new_field_is_known_to_three_files_at_most() -> None:
    assert len(CHANGES) <= MAX_FILES
    for name, replaced in CHANGES.items():
        text = (ROOT / name).read_text(encoding="utf-8")
        assert all(text.count(old) == 1 for old in replaced), name


def test_shots_have_the_types_of_the_record_and_describe_each_result() -> None:
    types = get_type_hints(hoopgen.Shots, {**vars(shots), "NDArray": NDArray})
    described = (hoopgen.Shots.__doc__ or "").partition("Attributes")[2]
    for result in COURT.layout.results.values():
        (_, inner) = get_args(types[result.name])
        assert get_args(inner) == (np.dtype(result.dtype).type,), result.name
        assert re.search(rf"^    (\w+, )*{result.name}(, \w+)*$", described, re.M), result.name


@pytest.mark.slow
def test_a_new_field_is_seen_wherever_results_are(changed_copy: Path, tmp_path: Path) -> None:
    _run(changed_copy, _READ, tmp_path, ROOT / "examples/scenes/netball.toml")
    knowing = {
        path.relative_to(changed_copy).as_posix()
        for folder in ("hoopgen", "derive", "templates")
        for path in (changed_copy / folder).rglob("*")
        if path.suffix in (".py", ".j2", ".md") and "longest_flight" in path.read_text("utf-8")
    }
    assert knowing == set(CHANGES)
