"""Fingerprints: every backend has the hashes of tests/golden_hashes.json.

`hoopgen hash hoop court air court-air examples/scenes/*.toml --json` prints what it holds.
A commit that changes it changes bits on purpose and says so.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import hoopgen
from hoopgen.core.backend_names import BackendName
from hoopgen.simulation import lookup
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.fingerprint import canonical_bytes, fingerprint, fixed_releases
from hoopgen.simulation.lookup import BUILT_IN, engine_of, scene_from
from tests.helpers import ROOT
from tests.helpers.commands import failure, run, succeed

GOLDEN = json.loads((ROOT / "tests" / "golden_hashes.json").read_text(encoding="utf-8"))
FILES = sorted((ROOT / "examples" / "scenes").glob("*.toml"))
SCENES = (*BUILT_IN, *map(str, FILES))
QUICK = [("hoop", "c"), ("hoop", "numpy"), ("court", "c")]


def test_every_scene_has_a_golden_hash() -> None:
    assert list(GOLDEN) == [Path(scene).stem.replace("-", "_") for scene in SCENES]


@pytest.mark.parametrize(
    ("scene", "backend"),
    [
        pytest.param(
            *(scene, backend),
            id=f"{Path(scene).stem}-{backend}",
            marks=() if (scene, backend) in QUICK else pytest.mark.slow,
        )
        for backend in ("c", "numpy")
        for scene in SCENES
    ],
)
def test_every_backend_has_the_golden_hash(scene: str, backend: BackendName) -> None:
    engine = engine_of(scene_from(scene))
    if backend == "c" and engine.library is None:
        pytest.skip("no C compiler")
    assert fingerprint(engine, backend) == GOLDEN[engine.name]


@pytest.mark.parametrize(
    "scene",
    [
        pytest.param(
            scene, id=Path(scene).stem, marks=() if (scene, "c") in QUICK else pytest.mark.slow
        )
        for scene in SCENES
    ],
)
def test_the_fixed_shots_meet_every_body(scene: str) -> None:
    engine = engine_of(scene_from(scene))
    shots = engine.simulate(fixed_releases(engine), max_contacts=40, time_limit=5.0)
    assert (shots.counts.sum(0) > 100).all()
    assert len(np.unique(shots.outcome)) >= 3


def test_one_bit_changes_the_hash() -> None:
    engine = hoopgen.HOOP
    releases = fixed_releases(engine, 800)
    before = fingerprint(engine, releases=releases)
    releases[400, 4] = np.nextafter(releases[400, 4], 1.0)
    assert fingerprint(engine, releases=releases) != before


def test_the_hash_has_one_pattern_for_nan() -> None:
    """Invalid shots have NaN, whose sign and payload differ between processors."""
    patterns = np.array([0x7FF8000000000000, 0xFFF8000000000000, 0x7FF8000000000001], np.uint64)
    assert canonical_bytes(patterns.view(np.float64)) == patterns[:1].tobytes() * 3
    narrow = np.array([0xFFC00000], np.uint32).view(np.float32)
    assert canonical_bytes(narrow) == b"\0\0\xc0\x7f"
    assert canonical_bytes(np.array([-0.0])) != canonical_bytes(np.array([0.0]))


def test_two_scenes_of_one_name_are_refused() -> None:
    said = failure("hash", "hoop", "hoop")
    assert "SCENES: two are called hoop" in said


def test_a_scene_has_the_name_by_which_it_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("hoopgen.simulation.fingerprint.fingerprint", lambda *_: "digest")
    assert succeed("hash", "court-air", "hoop").stdout == "digest  court-air\ndigest  hoop\n"


def test_the_scenes_that_can_be_run_are_hashed(monkeypatch: pytest.MonkeyPatch) -> None:
    def needs_sympy() -> Engine:
        raise ImportError("No module named 'sympy'", name="sympy")

    scenes = {"air": needs_sympy, "court-air": needs_sympy, "hoop": BUILT_IN["hoop"]}
    monkeypatch.setattr(lookup, "BUILT_IN", scenes)
    for as_json in ((), ("--json",)):
        result = run("hash", *as_json)
        assert result.exit_code == 2
        assert result.stderr.startswith(
            "hoopgen: error: no hash of air, court-air: this needs sympy: pip install "
        )
        hashes = json.loads(result.stdout) if as_json else dict([result.stdout.split()[::-1]])
        assert hashes == {"hoop": GOLDEN["hoop"]}
