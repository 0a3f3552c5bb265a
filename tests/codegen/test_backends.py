"""Targets: one registry lists them, and what runs in this process is among them."""

from __future__ import annotations

from dataclasses import replace

import click
import pytest

from hoopgen import HOOP
from hoopgen.cli.shot import shot
from hoopgen.codegen import render
from hoopgen.codegen.c import C_BACKEND
from hoopgen.codegen.elementary import FILES as ELEMENTARY_FILES
from hoopgen.codegen.registry import BACKENDS, register
from hoopgen.codegen.studies import FILES as STUDIES_FILES
from hoopgen.core.backend_names import BACKEND_NAMES, RUNTIME_BACKENDS
from tests.helpers import ROOT


def test_a_target_is_a_folder_of_the_generator_and_one_of_the_templates() -> None:
    folders = {p.parent.name for p in (ROOT / "hoopgen/codegen").glob("*/__init__.py")}
    assert folders - {"derivation"} == set(BACKENDS)
    # The package's files go with a target's, and the page is for readers.
    others = {"__pycache__", "package", "derivation"}
    assert {p.name for p in (ROOT / "templates").iterdir() if p.is_dir()} - others == set(BACKENDS)
    for name, backend in BACKENDS.items():
        own = {p.name for p in (ROOT / "templates" / name).glob("*.j2")}
        sceneless = {t for t in ELEMENTARY_FILES | STUDIES_FILES if t.startswith(f"{name}/")}
        assert {f"{name}/{template}" for template in own} == set(backend.files) | sceneless
        assert all(file.startswith(f"{name}/") for file in backend.files.values())


def test_what_runs_in_this_process_is_a_target() -> None:
    assert set(RUNTIME_BACKENDS) < set(BACKENDS)
    assert ("auto", *RUNTIME_BACKENDS) == BACKEND_NAMES

    (option,) = (one for one in shot.params if one.name == "backend")
    assert isinstance(option.type, click.Choice)
    assert tuple(option.type.choices) == BACKEND_NAMES
    for name in RUNTIME_BACKENDS:
        files = {f.format(scene="hoop") for f in BACKENDS[name].files.values()}
        assert {f"{name}/{file}" for file in HOOP.source(name)} == files


def test_two_targets_of_one_name_or_file_are_refused() -> None:
    with pytest.raises(ValueError, match="target 'c' is registered already"):
        register(C_BACKEND)
    with pytest.raises(
        ValueError, match=r"target 'd' would write files of 'c': c/arithmetic.h, c/environment.h, "
    ):
        register(replace(C_BACKEND, name="d"))
    assert "d" not in BACKENDS


def test_only_the_targets_asked_for_are_written() -> None:
    assert set(render.outputs(["js"])) == {"js/flight.js.j2"}
    assert list(render.outputs()) == [t for b in BACKENDS.values() for t in b.files]
