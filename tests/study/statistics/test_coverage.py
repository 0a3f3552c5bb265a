"""Intervals contain the truth as often as they say: a small sample of docs/validation.md."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from tests.helpers import ROOT

for needed in ("matplotlib", "pyarrow", "scipy", "xarray"):
    pytest.importorskip(needed)

from benchmarks import validation_coverage as validation  # noqa: E402
from benchmarks.report import with_section  # noqa: E402

CHEAP = {
    number: case.repetitions // 25
    for number, case in enumerate(validation.CASES)
    if case.repetitions == 2_000
}
"""The other cases take a second for each repetition and are run for the page."""


@cache
def intervals(number: int) -> list[validation.Interval]:
    return list(validation.CASES[number].intervals(CHEAP[number]))


@pytest.fixture(autouse=True, scope="module")
def smaller_truths() -> object:
    # The error of the truth is counted, so that a rougher one is as good for fewer repetitions.
    patch = pytest.MonkeyPatch()
    patch.setattr(validation, "TRUTH", 400_000)
    yield patch
    patch.undo()


@pytest.mark.parametrize("number", CHEAP)
@pytest.mark.sampled(1)
def test_an_interval_contains_the_truth_as_often_as_it_says(number: int) -> None:
    found = validation.coverage(validation.CASES[number], intervals(number))
    assert found.holds, f"{found.case.name}: {found.share:.1%}, P {found.probability:.2g}"


@pytest.mark.slow
@pytest.mark.parametrize("number", CHEAP)
def test_half_an_interval_does_not(number: int) -> None:
    halved = [one.halved() for one in intervals(number)]
    assert not validation.coverage(validation.CASES[number], halved).holds


def test_the_section_is_replaced_alone_and_says_what_does_not_hold() -> None:
    counts = [
        {"name": "", "of": "", "repetitions": 400, "covered": 380, "expected": 0.95, "width": 0.1}
        for _ in validation.CASES
    ]
    counts[0]["covered"] = 300
    page = f"# Validation\n\n{validation.HEADING}\n\nold\n\n## Sources\n\n- one\n"
    lines = with_section(page, validation.section(counts)).splitlines()
    assert (lines[0], lines[-3:]) == ("# Validation", ["## Sources", "", "- one"])
    assert "old" not in lines
    rows = [line for line in lines if line.startswith("| `estimate`")]
    assert rows[0].endswith("| 75.0% | 0.00 | **no** |")
    assert rows[1].endswith("| 95.0% | 1.00 | yes |")


@pytest.mark.slow
def test_the_page_says_how_often_the_test_finds_out_an_interval() -> None:
    # Of what claims 95% rightly it refuses a hundredth, or a little less since counts are whole.
    assert 0.002 < validation.found_out(400, validation.LEVEL) < validation.WORST
    case, refused = validation.CASES[0], 0
    drawn = np.random.default_rng(3).binomial(400, 0.9, 2_000)
    for covered in drawn.tolist():
        refused += not validation.Coverage(case, 400, covered, 0.95, 0.1).holds
    assert refused / 2_000 == pytest.approx(validation.found_out(400), abs=0.03)


def test_the_page_has_every_interval_and_none_fails() -> None:
    page = (ROOT / "docs" / "validation.md").read_text("utf-8")
    section = page.split(validation.HEADING)[1].split("\n## ")[0]
    ends = ("| yes |", "| too few to say |")
    rows = [line for line in section.splitlines() if line.endswith(ends)]
    assert len(rows) == len(validation.CASES)
    assert "**no**" not in section
    for case, row in zip(validation.CASES, rows, strict=True):
        assert row.startswith(f"| {case.name} | {case.of} | {case.claim} |")
