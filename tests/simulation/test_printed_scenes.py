"""Scenes that a wheel brings along: found, refused if they are others, and served without tools."""

from __future__ import annotations

import gzip
import json
import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.scene.cache import SOURCES
from hoopgen.scene.compilers import library_name
from hoopgen.simulation.compile import find_entry, scene_store
from hoopgen.simulation.printed_scenes import shipped_scene, source_digest
from tests.helpers import ROOT

SITE = sysconfig.get_paths()["purelib"]


def write(folder: Path, files: dict[str, str], **changed: str) -> None:
    folder.mkdir(exist_ok=True)
    record = {"source_digest": source_digest(), "files": files} | changed
    (folder / "air.json.gz").write_bytes(gzip.compress(json.dumps(record).encode()))


def test_a_scene_that_came_along_is_found_with_its_library(tmp_path: Path) -> None:
    write(tmp_path, {"c/air.c": "text"})
    found = shipped_scene("hoopgen.AIR", tmp_path)
    assert found is not None
    assert (found.scene, found.files, found.library) == ("air", {"c/air.c": "text"}, None)
    (tmp_path / "_air.so").write_bytes(b"library")
    again = shipped_scene("hoopgen.AIR", tmp_path)
    assert again is not None
    assert again.library == b"library"


def test_a_scene_of_other_sources_or_damaged_is_not_used(tmp_path: Path) -> None:
    assert shipped_scene("hoopgen.AIR", tmp_path) is None
    write(tmp_path, {"c/air.c": "text"}, source_digest="of an older hoopgen")
    assert shipped_scene("hoopgen.AIR", tmp_path) is None
    write(tmp_path, {"c/air.c": "text"})
    whole = (tmp_path / "air.json.gz").read_bytes()
    for part in (whole[:-9], b"", b"text", gzip.compress(b"text")):
        (tmp_path / "air.json.gz").write_bytes(part)
        assert shipped_scene("hoopgen.AIR", tmp_path) is None
    write(tmp_path, {})
    assert shipped_scene("../hoopgen.AIR", tmp_path) is None


def fly(**options: Any) -> str:
    shots = hoopgen.simulate(
        hoopgen.release(7.4, 0.9, backspin=18.0, height=2.13, distance=np.linspace(4, 5, 50)),
        scene=hoopgen.AIR,
        **options,
    )
    return bytes(shots.state.tobytes() + shots.time.tobytes()).hex()


SERVED = """
import sys
sys.path[:0] = [sys.argv[1]]
sys.path.append(sys.argv[2])
sys.modules["sympy"] = sys.modules["jinja2"] = None
import hoopgen, numpy as np
print(hoopgen.AIR.backend)
states = hoopgen.release(7.4, 0.9, backspin=18.0, height=2.13, distance=np.linspace(4, 5, 50))
shots = hoopgen.simulate(states, scene=hoopgen.AIR)
print(bytes(shots.state.tobytes() + shots.time.tobytes()).hex())
"""


@pytest.mark.slow
@pytest.mark.parametrize("with_library", [True, False])
def test_it_serves_without_sympy_and_without_a_compiler(tmp_path: Path, with_library: bool) -> None:
    pytest.importorskip("sympy")
    if hoopgen.AIR.library is None:
        pytest.skip("no C compiler")
    from hoopgen.derive.scenes.air import AIR

    entry = find_entry(lambda: AIR, "hoopgen.AIR", scene_store())
    here = tmp_path / "checkout"
    for folder in ("hoopgen", "derive", "generated", "templates"):
        shutil.copytree(
            ROOT / folder, here / folder, ignore=shutil.ignore_patterns("__pycache__", "shipped")
        )
    shutil.copy(ROOT / "pyproject.toml", here)
    shipped = here / "hoopgen" / "shipped"
    write(shipped, json.loads(gzip.decompress(entry.files[SOURCES])))
    if with_library:
        (shipped / "_air.so").write_bytes(entry.files[library_name()])
    environment = {**os.environ, "HOME": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path)}
    # Without zig, too, which is a package of Python.
    environment |= {"PATH": "", "CC": "/bin/false"}
    done = subprocess.run(
        [sys.executable, "-S", "-c", SERVED, here, SITE],
        env=environment,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["c" if with_library else "numpy", fly()]
