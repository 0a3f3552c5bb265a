"""Noise and states of releases: the same bits in NumPy and in C of every width."""

from __future__ import annotations

import itertools
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.engine import draws, elementary
from hoopgen.engine.c_build import FLAGS
from hoopgen.engine.draws import ARGUMENTS, Noise
from hoopgen.engine.elementary import Library
from tests.helpers import ROOT
from tests.helpers.compiled import COMPILER, WARNINGS, needs_compiler
from tests.helpers.effort import trials
from tests.helpers.engines import elementary_library

WIDTHS = (0, 2, 4, 8)
FACTOR = np.array([[1.0, 0, 0, 0], [-0.6, 0.8, 0, 0], [0, 0, 1.0, 0], [0.1, 0, -0.7, 0.7]])
NOISE = Noise((0, 7, 2**63 + 9, 2**64 - 1), FACTOR, np.array([0.1, 1e-300, 2.0, 1e306]))


def bits(array: np.ndarray) -> Any:
    return array.view(np.uint64).tolist()


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("start", [0, 1, 2**40 + 3, 2**64 - 40_000])
def test_c_of_every_width_draws_the_noise_of_numpy(width: int, start: int) -> None:
    shape = (len(NOISE.streams), trials(30_001, at_least=10_001))
    noise, expected = np.empty((2, *shape))
    given = (np.array(NOISE.streams, np.uint64), NOISE.factor, NOISE.deviations)
    if elementary_library().noise(*given, 2**64 - 1, start, noise, width) < 0:
        pytest.skip(f"this processor has no vectors of {width} doubles")
    NOISE.draw_in_numpy(2**64 - 1, start, expected)
    assert np.isinf(noise[3]).any() == np.isinf(expected[3]).any()
    assert bits(noise) == bits(expected)


@pytest.mark.parametrize("count", [0, 1, 3, 127, 128, 129, 300])
@pytest.mark.parametrize("start", range(5))
def test_a_shot_has_the_same_noise_whatever_is_drawn_with_it(count: int, start: int) -> None:
    whole = NOISE.draw(3, 0, 400)
    assert bits(NOISE.draw(3, start, start + count)) == bits(whole[:, start : start + count].copy())


def test_shots_that_c_cannot_count_are_drawn_in_numpy() -> None:
    noise = NOISE.draw(1, 2**64 - 3, 2**64 + 3)
    parts = [NOISE.draw(1, shot, shot + 1) for shot in range(2**64 - 3, 2**64 + 3)]
    assert bits(noise) == bits(np.concatenate(parts, axis=1))


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("options", [(), ("-U__SIZEOF_INT128__",)], ids=["wide", "halves"])
def test_words_are_the_same_where_no_integer_has_128_bits(
    options: tuple[str, ...], tmp_path: Path
) -> None:
    """The compiler has no complaint, either."""
    file = tmp_path / "elementary.so"
    source = str(ROOT / "generated" / "c" / "elementary.c")
    build = [*COMPILER, *FLAGS, *WARNINGS, *options, "-fPIC", "-shared", source, "-o", str(file)]
    subprocess.run(build, check=True, timeout=300)
    noise, expected = np.empty((2, 4, 5_000))
    NOISE.draw_compiled(Library(file), 11, 6, noise)
    NOISE.draw_in_numpy(11, 6, expected)
    assert bits(noise) == bits(expected)


def releases(count: int, shared: tuple[str, ...]) -> dict[str, np.ndarray]:
    """Arguments of all sizes, some no numbers and some zeros; a few are the same for all shots."""
    random = np.random.default_rng(count)
    values = random.normal(size=(len(ARGUMENTS), count)) * 10.0 ** random.uniform(
        -12.0, 7.0, (len(ARGUMENTS), count)
    )
    for wrong in (np.nan, np.inf, 0.0, -0.0):
        values[random.random(values.shape) < 0.02] = wrong
    columns = dict(zip(ARGUMENTS, values, strict=True))
    return {name: np.array(0.7) if name in shared else one for name, one in columns.items()}


def shared_arguments() -> Iterator[tuple[str, ...]]:
    """Sets of arguments that all shots share: none, each one, angles in pairs, and all but one."""
    yield ()
    for name in ARGUMENTS:
        yield (name,)
        yield tuple(other for other in ARGUMENTS if other != name)
    yield from itertools.combinations(("elevation", "azimuth", "angle"), 2)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("shared", list(shared_arguments()))
def test_c_of_every_width_makes_the_states_of_numpy(width: int, shared: tuple[str, ...]) -> None:
    given = releases(1001, shared)
    states = np.empty((1001, 9))
    columns = [given[name] for name in ARGUMENTS]
    if elementary_library().release_states(columns, 3.048, states, width) < 0:
        pytest.skip(f"this processor has no vectors of {width} doubles")
    with np.errstate(all="ignore"):
        expected = draws.states_in_numpy(given, (1001,), 3.048)
    np.testing.assert_array_equal(states, expected)
    assert (np.signbit(states) == np.signbit(expected))[~np.isnan(states)].all()


def test_a_width_that_there_is_not_writes_nothing() -> None:
    library, states, noise = elementary_library(), np.full((1, 9), 7.0), np.full((1, 3), 7.0)
    assert library.release_states([np.zeros(1)] * len(ARGUMENTS), 3.0, states, 3) == -1
    assert library.noise(np.zeros(1, np.uint64), np.eye(1), np.ones(1), 0, 0, noise, 3) == -1
    assert (states == 7.0).all()
    assert (noise == 7.0).all()


def test_releases_of_any_shape_are_those_of_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    given: dict[str, Any] = {
        "speed": np.linspace(6.0, 8.0, 12).reshape(3, 4)[:, ::-1],
        "elevation": np.array([[0.8], [0.9], [1.0]]),
        "azimuth": np.array([0.0, 0.1, -0.1, 0.2]),
        "height": 2.1,
        "distance": np.array([4.2]),
    }
    made = hoopgen.release(**given)
    monkeypatch.setattr(elementary, "library", lambda: None)
    assert made.shape == (3, 4, 9)
    assert bits(made) == bits(hoopgen.release(**given))
    assert hoopgen.release(**(given | {"azimuth": np.empty((2, 0, 1, 4))})).shape == (2, 0, 3, 4, 9)


def test_the_library_that_draws_serves_where_it_was_built() -> None:
    """Otherwise releases are drawn in NumPy, which takes longer and nobody would notice."""
    elementary_library()
    assert draws._library() is not None


def test_a_library_that_draws_something_else_does_not_serve(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    library = elementary_library()

    class Another(Library):
        def __init__(self) -> None:
            self.__dict__ |= library.__dict__

        def noise(self, *arguments: Any, **options: Any) -> int:
            width = super().noise(*arguments, **options)
            arguments[-1][0, 7] *= 1.0 + 2.0**-52
            return width

    another = Another()
    monkeypatch.setattr(elementary, "library", lambda: another)
    assert draws._library() is None
