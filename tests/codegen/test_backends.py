"""Targets: one registry lists them, and what runs in this process is among them."""

from __future__ import annotations

import ctypes
from dataclasses import replace
from pathlib import Path

import click
import numpy as np
import pytest
from hoopgen.derive import scenes
from hoopgen.generated.numpy import hoop

from benchmarks.workloads import bouncing, free_throw, swirl
from hoopgen import HOOP
from hoopgen.cli.shot import shot
from hoopgen.codegen import render
from hoopgen.codegen.c import C_BACKEND
from hoopgen.codegen.registry import BACKENDS, register
from hoopgen.core.validation import BACKEND_NAMES, RUNTIME_BACKENDS
from hoopgen.engine import numpy_backend
from hoopgen.engine.result_arrays import Layout
from tests.helpers import ROOT
from tests.helpers.compiled import needs_compiler, same_bits, shared_library
from tests.helpers.toy_target import ToyBackend


def test_a_target_is_a_folder_of_the_generator_and_one_of_the_templates() -> None:
    folders = {p.parent.name for p in (ROOT / "hoopgen/codegen").glob("*/__init__.py")}
    assert folders - {"derivation"} == set(BACKENDS)
    others = {"__pycache__", "package"}  # the package's files go with a target's, and are none
    assert {p.name for p in (ROOT / "templates").iterdir() if p.is_dir()} - others == set(BACKENDS)
    for name, backend in BACKENDS.items():
        own = {p.name for p in (ROOT / "templates" / name).glob("*.j2")}
        assert {f"{name}/{template}" for template in own} == set(backend.files)
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
        ValueError, match=r"target 'd' would write files of 'c': c/environment.h, c/exact.h, "
    ):
        register(replace(C_BACKEND, name="d"))
    assert "d" not in BACKENDS


def test_only_the_targets_asked_for_are_written() -> None:
    assert set(render.outputs(["js"])) == {"js/flight.js.j2"}
    assert list(render.outputs()) == [t for b in BACKENDS.values() for t in b.files]


@needs_compiler
def test_a_toy_target_flies_with_the_bits_of_numpy(tmp_path: Path) -> None:
    """A thousand shots: a target is a folder that implements `Backend`, and nothing else."""
    register(ToyBackend())
    try:
        (text,) = render.render_scene(scenes.HOOP, page=False, targets=["toy"]).values()
    finally:
        del BACKENDS["toy"]
    (tmp_path / "hoop.c").write_text(text, encoding="utf-8")
    fly = ctypes.CDLL(str(shared_library(tmp_path / "hoop.c", "-O1"))).fly
    states = np.concatenate([make(334) for make in (free_throw, bouncing, swirl)])[:1000]
    sizes = np.array([default for default, _, _ in hoop.PARAMETERS.values()])
    fields = {field.name: k for k, field in enumerate(hoop.FIELDS)}
    found = np.empty((len(states), len(fields)))
    given = (np.ascontiguousarray(each).ctypes.data_as(ctypes.c_void_p) for each in (states, sizes))
    out = found.ctypes.data_as(ctypes.c_void_p)
    fly(ctypes.c_long(len(states)), *given, ctypes.c_double(40), out)
    layout = Layout(hoop)
    wanted = layout.allocate(len(states), list(layout.results))
    numpy_backend.run(hoop, states, list(map(float, sizes)), None, 40, wanted)
    assert wanted.contacts is not None
    assert wanted.contacts.max() == 40
    for result in hoop.RESULTS:
        columns = [found[:, fields[name]] for name in result.columns]
        own = np.stack(columns, 1) if result.row else columns[0]
        assert same_bits(own.astype(result.dtype), wanted.arrays[result.name]).all(), result.name
