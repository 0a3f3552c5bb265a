"""Beside another commit: what is not equal is found, in every engine, field and event."""

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.helpers import ROOT

pytest.importorskip("scipy")

from benchmarks import base
from benchmarks.against import (
    Engines,
    Equality,
    Pair,
    Wanted,
    compare,
    differing,
    turn_about,
)
from benchmarks.families import FAMILIES

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("against")]  # HEAD is built once

BY_KEY = {family.key: family for family in FAMILIES}

ALTERED = """
from hoopgen.simulation.simulate import simulate as _simulate


def simulate(*arguments, backend, record, **options):
    import numpy

    shots = _simulate(*arguments, backend=backend, record=record, **options)
    if backend == "numpy":
        shots.state[7, 4] = numpy.nextafter(shots.state[7, 4], 9)
    elif record:
        shots.events["after"][shots.events["shot"] == 5, 8] += 1
    return shots
"""


@pytest.fixture(scope="module")
def home() -> Iterator[Path]:
    """Yield the folder in which HEAD was built."""
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("no git checkout")
    head = base.commit("HEAD")
    if not base.shares(head):
        pytest.skip("the C library of HEAD would take a minute to compile")
    with base.built(head) as (home, _):
        yield home


def test_a_commit_is_equal_to_itself_on_every_engine(home: Path, tmp_path: Path) -> None:
    with base.Process("base", home) as one, base.Process("tree", home) as other:
        pair = Pair(one, other)
        engines, same = pair.ask("engines")
        assert engines == same
        assert {"numpy", "c", "c 1"} <= set(engines)
        compare = Equality(pair, tmp_path)
        for key in ("W3", "hoops"):
            for verdict in compare.of(BY_KEY[key], 300, engines).values():
                assert str(verdict) == "== 300, log 300"
        ratios = turn_about(pair, 100, 2, engine="c", threads=1, fields=("time",))
        assert ratios.cpu.lower > 0
        assert ratios.rate > 0


def test_one_bit_and_one_event_are_found(home: Path, tmp_path: Path) -> None:
    shutil.copytree(home, tmp_path / "other")
    with (tmp_path / "other/hoopgen/__init__.py").open("a") as file:
        file.write(ALTERED)
    with base.Process("base", home) as one, base.Process("tree", tmp_path / "other") as other:
        (tmp_path / "out").mkdir()
        compare = Equality(Pair(one, other), tmp_path / "out")
        verdicts = compare.of(BY_KEY["W3"], 300, ("numpy", "c"))
        assert {engine: of.wrong for engine, of in verdicts.items()} == {"numpy": {7}, "c": {5}}
        what, *rows = verdicts["numpy"].examples[0].replace("tree", "base").split("    base")
        assert what == "numpy, state: 1 shots, the first is 7\n"
        assert rows[0].split() != rows[1].split()
        assert verdicts["c"].examples[0].startswith("c, events: 1 shots, the first is 5\n")


def test_a_width_that_is_not_there_is_not_among_the_engines(home: Path) -> None:
    with base.Process("base", home) as one:
        assert "c 2" not in one.ask("engines")


def test_a_width_that_was_given_up_is_not_compared_and_one_that_is_missing_is_lost() -> None:
    base = ("numpy", "c", "c 1", "c 2", "c 4", "c 8")
    engines = Engines.of(base, ("numpy", "c", "c 1", "c 8", "c 16"), widths=(1, 4, 8, 16))
    assert engines == Engines(("numpy", "c", "c 1", "c 8"), ("c 2",), ("c 4",))
    assert Engines.of(base[:2], ("numpy",), widths=(1,)) == Engines(("numpy",), (), ("c",))


@pytest.mark.parametrize(
    ("before", "after", "same"),
    [
        (["c", "c 2"], ["c"], True),
        (["c", "c 4"], ["c"], False),
        (["c"], ["c", "c 4"], True),
    ],
)
def test_only_what_should_be_there_and_is_not_fails(
    capsys: pytest.CaptureFixture[str],
    before: list[str],
    after: list[str],
    same: bool,
) -> None:
    class Has(list[str]):
        """A contender that says which engines it has."""

        def send(self, do: str) -> None:
            assert do == "engines"

        def receive(self) -> list[str]:
            return self

    assert compare(Pair(Has(before), Has(after)), Wanted(equality=False, speed=False)) is same
    said = capsys.readouterr().out
    assert re.match(r"engines: c(;|\n)", said)
    assert ("given up, not compared: c 2" in said) is ("c 2" in before)
    assert ("LOST: c 4" in said) is ("c 4" in before)


def test_a_contender_comes_from_its_own_folder(home: Path, tmp_path: Path) -> None:
    with base.Process("elsewhere", tmp_path) as process, pytest.raises(RuntimeError) as caught:
        process.ask("engines")
    assert "elsewhere: " in str(caught.value)
    assert "hoopgen" in str(caught.value)


def test_nan_is_equal_to_nan_and_zero_to_zero() -> None:
    one = np.array([[np.nan, 0.0], [np.nan, 1.0], [2.0, 3.0]])
    other = np.array([[np.nan, -0.0], [1.0, 1.0], [2.0, np.nextafter(3, 4)]])
    assert differing(one, other).tolist() == [1, 2]
    assert differing(np.array([1, 2]), np.array([1, 3])).tolist() == [1]


def test_a_ref_that_is_not_there_is_one_clear_error() -> None:
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("no git checkout")
    with pytest.raises(base.CannotBuild, match="no-such-branch"):
        base.commit("no-such-branch")
