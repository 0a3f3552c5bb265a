"""Scenes of one's own are compiled for the lanes of any processor, with the same bits."""

from __future__ import annotations

from pathlib import Path

import pytest

from hoopgen.engine import native, verification
from hoopgen.scene import End, Parameter, Plane, Scene, Torus, compilers
from hoopgen.scene.trial_shots import trial_batches
from hoopgen.simulation.printed_scenes import generate_scene
from tests.helpers.compiled import WARNINGS, load_module, needs_compiler, shared_library

HOOP_ABOVE_A_FLOOR = Scene(
    "hoop_above_a_floor",
    parameters=[
        Parameter("ball", 0.11),
        Parameter("rim", 0.22),
        Parameter("bounce", 0.7, "1", upper=1.0),
    ],
    ball_radius="ball",
    gravity=9.81,
    restitution="bounce",
    bodies=[Torus("ring", radius="rim"), Plane("floor", at=-1, within=["x**2 - 4"])],
    ends={"below": End(at=-2)},
)
"""A ring, the first search on which is in single precision, and a body with a bound."""


@pytest.mark.slow
@needs_compiler
def test_lanes_of_every_kind_give_numpys_bits(tmp_path: Path) -> None:
    """All that this processor has, of one native vector to a value and of two."""
    printed = generate_scene(HOOP_ABOVE_A_FLOOR)
    name = printed.scene
    for file, text in printed.files.items():
        path = tmp_path / file
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    kernels = load_module(tmp_path / "numpy" / f"{name}.py")
    assert "EACH(LOAD_SINGLE" in printed.files[f"c/{name}_loop.h"]
    shots = verification.expected(kernels, trial_batches(kernels))
    # At -O1 GCC takes a lane that a loop fills for one that nothing does.
    flags = (*WARNINGS, "-Wno-maybe-uninitialized", "-O1")
    seen = []
    for lanes in compilers.available_lanes():
        built = shared_library(tmp_path / "c" / f"{name}.c", *flags, *lanes.options(name))
        # A library of the same path would be the one that is loaded.
        library = native.Library(
            built.rename(tmp_path / f"{lanes.width}_{lanes.vectors}.so"), kernels
        )
        assert verification.available_widths(library, kernels) == [lanes.width]
        assert verification.differences(library, kernels, shots) == ""
        seen.append(lanes)
    assert compilers.Lanes(4, 2) in seen
