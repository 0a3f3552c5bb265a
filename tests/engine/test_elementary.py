"""Elementary functions: the same bits in NumPy and in C of every width, whatever the shape."""

from __future__ import annotations

import hashlib
import shutil
from pathlib import Path

import numpy as np
import pytest
from hoopgen.generated.numpy import elementary as generated

import hoopgen
from hoopgen.engine import elementary
from hoopgen.engine.elementary import Library
from tests.helpers import ROOT
from tests.helpers.effort import trials
from tests.helpers.engines import elementary_library

NAMES = list(generated.FUNCTIONS)


def given(name: str, count: int) -> list[np.ndarray]:
    """Arguments of all sizes, some of which are no numbers."""
    random = np.random.default_rng(len(name))
    arguments = []
    for _ in generated.FUNCTIONS[name][0]:
        values = random.normal(size=count) * 10.0 ** random.uniform(-12.0, 7.0, count)
        if name == "normal_quantile":
            # Half of them have any number of leading zeros or ones: tails of all lengths.
            whole = random.integers(0, 2**52, count) >> random.integers(0, 53, count) * (
                random.random(count) < 0.5
            )
            values = (whole + 0.5) * 2.0**-52
            values = np.where(random.random(count) < 0.5, values, 1.0 - values)
        values[random.random(count) < 0.01] = np.nan
        arguments.append(values)
    return arguments


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("width", [0, 2, 4, 8])
def test_c_of_every_width_gives_the_bits_of_numpy(name: str, width: int, without_c: None) -> None:
    library = Library(Path(elementary.__file__).with_name("_elementary.so"))
    arguments = given(name, trials(100_000, at_least=20_000))
    results = [np.empty(len(arguments[0])) for _ in generated.FUNCTIONS[name][1]]
    if library.compute(name, arguments, results, width) < 0:
        pytest.skip(f"this processor has no vectors of {width} doubles")
    in_numpy = elementary._in_numpy(name, arguments)
    for result, expected in zip(results, in_numpy, strict=True):
        np.testing.assert_array_equal(result, expected)
        assert (np.signbit(result) == np.signbit(expected))[~np.isnan(result)].all()


def test_a_width_that_there_is_not_writes_nothing() -> None:
    result = np.full(3, 7.0)
    assert elementary_library().compute("tangent", [np.zeros(3)], [result], 3) == -1
    assert (result == 7.0).all()


def test_the_library_serves_where_it_was_built() -> None:
    """Otherwise releases are drawn in NumPy, which takes longer and nobody would notice."""
    if hoopgen.HOOP.backend != "c":
        pytest.skip("no C engine was built")
    assert elementary.library() is not None


def test_a_library_of_other_sources_does_not_serve(tmp_path: Path) -> None:
    elementary_library()
    sources = tmp_path / "c"
    shutil.copytree(ROOT / "generated" / "c", sources)
    (sources / "elementary.c").write_text("/* another */", encoding="utf-8")
    assert elementary.library(sources) is None


@pytest.mark.parametrize("count", [0, 1, 8191, 8192, 8193])
def test_the_bits_do_not_depend_on_the_number_of_values(count: int, without_c: None) -> None:
    angles = np.linspace(-40.0, 40.0, 20_000)
    whole, part = elementary.sine_cosine(angles), elementary.sine_cosine(angles[:count])
    for all_of_them, some in zip(whole, part, strict=True):
        assert (all_of_them[:count] == some).all()


def test_arguments_broadcast_and_a_number_gives_a_number() -> None:
    table = elementary.arc_tangent(np.ones((3, 1)), [1.0, 2.0])
    assert table.shape == (3, 2)
    assert isinstance(elementary.tangent(0.5), float)
    assert table[2, 1] == elementary.arc_tangent(1.0, 2.0)


def releases() -> str:
    """Return the SHA-256 of the releases of a player."""
    player = hoopgen.Scatter(
        {"aim": 0.05, "entry": 0.8, "backspin": 19.0, "height": 2.1, "x": 4.0, "y": 1.5},
        {"speed": 0.1, "elevation": 0.03, "azimuth": 0.02, "backspin": 2.0, "restitution": 0.02},
        {("speed", "elevation"): -0.5, ("elevation", "backspin"): 0.25},
    )
    drawn = player.draw(0, 20_000, seed=7)
    content = drawn.states.tobytes() + drawn.parameters["restitution"].tobytes()
    return hashlib.sha256(content).hexdigest()


GOLDEN = "75534bd022bc4e0f05f5083fa1ee03f6cab173a145608cbc289dbe8ffda68a59"
"""A commit that changes it changes what seeds draw: studies that are kept are then refused."""


def test_a_seed_draws_the_same_releases_on_every_processor() -> None:
    assert releases() == GOLDEN


def test_a_seed_draws_the_same_releases_without_c(without_c: None) -> None:
    assert releases() == GOLDEN
