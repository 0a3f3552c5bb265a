"""WebAssembly: what is committed is of the committed C sources, and no other is used."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tomllib
from importlib.util import find_spec
from pathlib import Path

import pytest

from hoopgen.engine import web_assembly
from hoopgen.engine.web_assembly import MODULES, ZIG, build, module_bytes, stale_modules
from tests.helpers import ROOT
from tests.helpers.commands import run

FOLDER = ROOT / "generated"


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    """A copy of the C sources and the modules."""
    for name in ("c", "wasm"):
        shutil.copytree(FOLDER / name, tmp_path / name)
    return tmp_path


def test_the_committed_modules_are_of_the_committed_sources() -> None:
    """Otherwise: `make generate`, with the extra `compile`."""
    assert stale_modules(FOLDER) == []


def test_a_module_of_other_sources_is_stale(copied: Path) -> None:
    assert stale_modules(copied) == []
    (copied / "wasm" / "hoop.wasm").unlink()
    assert stale_modules(copied) == ["hoop.wasm"]
    header = copied / "c" / "court_kernels.h"
    header.write_text(header.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert stale_modules(copied) == ["hoop.wasm", "court.wasm", "court_simd.wasm"]
    header = copied / "c" / "elementary_functions.h"
    header.write_text(header.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert stale_modules(copied) == list(MODULES)


def test_a_module_of_other_options_is_stale(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(web_assembly, "_OPTIONS", (*web_assembly._OPTIONS, "-mrelaxed-simd"))
    assert stale_modules(FOLDER) == list(MODULES)


def test_a_stale_module_is_not_used(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(web_assembly, "ZIG", "0.0.1")
    with pytest.raises(RuntimeError, match=r"hoop\.wasm is missing, or of other sources"):
        module_bytes("hoop.wasm")


def test_modules_are_small_and_import_nothing() -> None:
    sizes = {name: len(module_bytes(name)) for name in MODULES}
    assert sizes["hoop.wasm"] < 130_000
    assert sizes["hoop_simd.wasm"] < 260_000
    assert sizes["court.wasm"] < 400_000
    assert sizes["court_simd.wasm"] < 900_000
    for name in MODULES:
        module = module_bytes(name)
        assert module.startswith(b"\0asm\1\0\0\0")
        assert 2 not in sections(module), "the section of imports"


def sections(module: bytes) -> list[int]:
    """Return the numbers of a module's sections."""
    found, at = [], 8
    while at < len(module):
        found.append(module[at])
        size, shift, at = 0, 0, at + 1
        while True:
            byte = module[at]
            size, shift, at = size | (byte & 127) << shift, shift + 7, at + 1
            if byte < 128:
                break
        at += size
    return found


def test_check_names_a_stale_module(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("hoopgen.codegen.check", lambda root: [])
    assert run("check", "--root", ROOT).exit_code == 0
    monkeypatch.setattr(web_assembly, "ZIG", "0.0.1")
    found = run("check", "--root", ROOT)
    assert found.exit_code == 1
    assert "stale or missing file: generated/wasm/hoop.wasm" in found.output


def test_without_the_compiler_generate_says_what_brings_it(
    monkeypatch: pytest.MonkeyPatch, copied: Path
) -> None:
    monkeypatch.setitem(sys.modules, "ziglang", None)
    with pytest.raises(ImportError, match=f"needs zig {ZIG}: pip install ziglang=={ZIG}"):
        build(copied, ["hoop.wasm"])
    assert build(copied, []) == []


def test_generate_asks_for_the_compiler_before_it_writes_c_sources(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    committed = pytest.importorskip("hoopgen.codegen.committed")
    shutil.copytree(FOLDER, tmp_path / "generated")
    for name in ("derive", "templates"):  # which a source checkout has
        (tmp_path / name).mkdir()
    files = {
        file.relative_to(FOLDER).as_posix(): file.read_text(encoding="utf-8")
        for file in FOLDER.rglob("*")
        if file.is_file() and file.suffix not in (".wasm", ".pyc")
    }
    monkeypatch.setattr(committed, "render_all", lambda: dict(files))
    monkeypatch.setitem(sys.modules, "ziglang", None)
    files["derivation.md"] += "\n"
    assert "derivation.md" in run("generate", "--root", tmp_path).stdout
    files["derivation.md"] += "\n"
    files["c/court_kernels.h"] += "\n"
    before = (tmp_path / "generated/derivation.md").read_bytes()
    failed = run("generate", "--root", tmp_path)
    assert failed.exit_code == 2
    assert f"needs zig {ZIG}" in failed.output
    assert (tmp_path / "generated/derivation.md").read_bytes() == before


def test_the_extra_that_generating_needs_has_the_version_of_the_modules() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert f"ziglang=={ZIG}" in project["optional-dependencies"]["compile"]
    makefile = (ROOT / "Makefile").read_text("utf-8")
    assert "\ngenerate: $(VENV)/with-compile " in makefile


@pytest.mark.slow
def test_compiling_again_gives_the_same_bytes(copied: Path) -> None:
    if find_spec("ziglang") is None:
        pytest.skip("needs ziglang")
    command = [sys.executable, "-m", "ziglang", "version"]
    version = subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    if version != ZIG:
        pytest.skip(f"needs ziglang {ZIG}")
    before = (copied / "wasm" / "hoop.wasm").read_bytes()
    shutil.rmtree(copied / "wasm")
    (file,) = build(copied, ["hoop.wasm"])
    assert file.read_bytes() == before
