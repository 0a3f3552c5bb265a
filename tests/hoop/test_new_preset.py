"""A new preset of the hoop: how many files must know of it, and where it is seen without them."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

import hoopgen
from hoopgen.hoop import air, court, court_air, presets
from tests.helpers import ROOT

SCENES = {"": "presets", "_COURT": "court", "_AIR": "air", "_COURT_AIR": "court_air"}
"""Files of presets by the end of the presets' names."""

ADDED = {
    "": 'NBA | {"ring_radius": 0.25}',
    "_COURT": "_real(SCHOOL, **_rough(0.6))",
    "_AIR": 'Parameters({**PAPER_AIR, **SCHOOL, "ball_mass": 0.6})',
    "_COURT_AIR": "_in_air(SCHOOL_COURT, SCHOOL_AIR)",
}
"""The new preset of each scene."""


def with_preset(text: str, end: str) -> str:
    """Return the text of a file of presets with the new preset."""
    name = f"SCHOOL{end}"
    text = text.replace("PRESETS: Mapping", f"{name} = {ADDED[end]}\n\nPRESETS: Mapping")
    text = text.replace(f'"nba": NBA{end},', f'"nba": NBA{end}, "school": {name},')
    for imported in ("NBA_AIR", "NBA_COURT", "NBA"):
        old = rf"^(from \.\w+ import .*)\b{imported}\b"
        text = re.sub(old, rf"\1{imported}, {imported.replace('NBA', 'SCHOOL')}", text, flags=re.M)
    return text


def with_export(text: str) -> str:
    """Return a text in which a line is repeated for the new preset wherever there is NBA's."""
    lines = text.splitlines(keepends=True)
    added = (re.sub(r"\bNBA", "SCHOOL", line) for line in lines)
    pairs = zip(lines, added, strict=True)
    return "".join(line if line == new else line + new for line, new in pairs)


READ = """
import sys
sys.path[:0] = [sys.argv[1]]
sys.path.append({site!r})
import json
from click.testing import CliRunner
import hoopgen
from hoopgen.cli import main
from hoopgen.hoop import court_lines
from hoopgen.report.provenance import describe_scene
from hoopgen.studyfile.reference import reference

names = ("SCHOOL", "SCHOOL_COURT", "SCHOOL_AIR", "SCHOOL_COURT_AIR")
assert set(names) <= set(hoopgen.__all__) & set(dir(hoopgen))
assert describe_scene(hoopgen.HOOP, hoopgen.SCHOOL) == "SCHOOL"
assert describe_scene(hoopgen.COURT, hoopgen.SCHOOL_COURT) == "court, SCHOOL"
assert court_lines.court_of(hoopgen.SCHOOL) == "NBA"
assert hoopgen.SCHOOL_COURT_AIR["ring_friction"] == 0.6
assert hoopgen.SCHOOL_COURT_AIR["ball_mass"] == 0.6
assert '"school"' in reference()
shot = ["shot", "--speed", "7.17", "--elevation", "52deg", "--height", "2.13", "--distance", "4.2"]
for scene in ("hoop", "court"):
    done = CliRunner().invoke(main, [*shot, "--scene", scene, "--preset", "school"])
    assert done.exit_code == 0, done.output
    assert "SCHOOL" in done.output, done.output
file, out = sys.argv[2:]
done = CliRunner().invoke(main, ["study", file, "--out", out])
assert done.exit_code == 0, done.output
"""

STUDY = """
[study]
name = "A gym"
[scene]
preset = "school"
[release]
speed = "7.17 m/s"
elevation = "52 deg"
distance = "4.191 m"
height = "2.1336 m"
[scatter]
speed = "0.07 m/s"
[[question]]
name = "player"
kind = "estimate"
shots = 200
"""


@pytest.mark.sampled(1)
def test_a_new_preset_is_seen_wherever_presets_are(tmp_path: Path) -> None:
    for missing in ("pydantic", "pyarrow", "scipy"):
        pytest.importorskip(missing)
    root = tmp_path / "sources"
    for folder in ("hoopgen", "derive", "generated", "templates"):
        ignored = shutil.ignore_patterns("__pycache__", "_hoop.*", "_court.*")
        shutil.copytree(ROOT / folder, root / folder, ignore=ignored)
    shutil.copy(ROOT / "pyproject.toml", root)
    public = root / "hoopgen" / "__init__.py"
    public.write_text(with_export(public.read_text("utf-8")), encoding="utf-8")
    for end, name in SCENES.items():
        file = root / "hoopgen" / "hoop" / f"{name}.py"
        file.write_text(with_preset(file.read_text("utf-8"), end), encoding="utf-8")
    (tmp_path / "study.toml").write_text(STUDY, encoding="utf-8")
    code = READ.format(site=sysconfig.get_paths()["purelib"])
    done = subprocess.run(
        [sys.executable, "-S", "-c", code, root, tmp_path / "study.toml", tmp_path / "out"],
        cwd=root,
        env=os.environ | {"XDG_CACHE_HOME": str(root / "cache")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("end", SCENES)
def test_every_scene_of_a_hoop_has_the_same_presets_which_are_public(end: str) -> None:
    of_scene = {"": presets, "_COURT": court, "_AIR": air, "_COURT_AIR": court_air}[end].PRESETS
    assert list(of_scene) == list(presets.PRESETS)
    page = (ROOT / "docs/reference/shots.md").read_text("utf-8")
    for name, values in of_scene.items():
        public = f"{name.upper()}{end}"
        assert getattr(hoopgen, public) is values
        assert public in hoopgen.__all__
        assert f".. py:data:: {public}\n" in page


def test_the_instructions_name_every_file_of_a_preset() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    section = text.partition("### A preset\n")[2].partition("\n### ")[0]
    named = [f"{name}.py" for name in SCENES.values()]
    for name in (*named, "hoopgen/__init__.py", "docs/reference/shots.md", "docs/study.md"):
        assert name in section, name
