"""The article's seven shots: the releases of Table 3, and the sequences its figures show."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import hoopgen
from hoopgen.simulation.article import CASES, ArticleResult, Case, release_states, run


@pytest.fixture(scope="module")
def results() -> dict[str, ArticleResult]:
    return {result.case.slug: result for result in run()}


def test_every_shot_of_table_3_is_there_and_6b_for_both_readings_of_its_spin() -> None:
    figures = [case.figure for case in CASES]
    assert figures == ["5a", "5b", "5c", "5d", "6a", "6b", "6b", "7"]
    assert [case.spin for case in CASES if case.figure == "6b"] == [(0, 0, 0), (0, 0, 2)]


def test_names_of_files_are_one_for_each_case() -> None:
    assert [case.slug for case in CASES] == ["5a", "5b", "5c", "5d", "6a", "6b-wz0", "6b-wz2", "7"]


@pytest.mark.parametrize(
    ("slug", "metres"),
    # As printed, where print is right.
    [
        ("5a", (2.438, 0, -0.6096, -2.8956, 0, 4.8768)),
        ("5b", (2.438, 0, -0.6096, -3.0876, 0, 4.8768)),
        ("5d", (2.438, 0, -0.6096, -2.7063, 0, 4.8768)),
        ("6a", (0.2286, -0.9144, -0.6096, -1.143, 1.4478, 4.2672)),
        ("6b-wz2", (0.2286, -0.94488, -0.6096, -0.8382, 2.1336, 3.8557)),
        ("7", (4.191, 0, -0.6096, -4.4998, 0, 5.5769)),
    ],
)
def test_feet_give_the_metres_of_the_article(slug: str, metres: tuple[float, ...]) -> None:
    (case,) = (case for case in CASES if case.slug == slug)
    # Print has four decimals, three of them for 2.438.
    np.testing.assert_allclose(case.state[:6], metres, rtol=0, atol=5e-4)


def test_releases_are_one_row_a_case_with_backspin_as_positive_wy() -> None:
    states = release_states()
    assert states.shape == (8, 9)
    assert states.dtype == np.float64
    np.testing.assert_array_equal(states[-1, 6:], [0.0, 6.0 * math.pi, 0.0])


@pytest.mark.parametrize(
    ("slug", "sequence", "outcome"),
    [
        ("5a", (), "MADE"),
        ("5c", ("backboard",), "MADE"),
        ("6a", ("backboard",), "MADE"),
        ("7", ("ring", "backboard"), "MISSED"),
    ],
)
def test_the_sequence_and_the_outcome_are_those_of_the_figure(
    results: dict[str, ArticleResult], slug: str, sequence: tuple[str, ...], outcome: str
) -> None:
    assert results[slug].sequence == sequence
    assert results[slug].outcome.name == outcome


def test_5b_touches_the_ring_twice_and_ends(results: dict[str, ArticleResult]) -> None:
    assert results["5b"].sequence == ("ring", "ring")
    assert results["5b"].events["surface"][-1] == len(hoopgen.SURFACES)


def test_5d_touches_ring_bridge_and_backboard_and_ends(results: dict[str, ArticleResult]) -> None:
    assert set(results["5d"].sequence) == {"ring", "bridge", "backboard"}
    assert results["5d"].events["surface"][-1] == len(hoopgen.SURFACES)


def test_6a_meets_the_board_near_the_top_of_its_flight(results: dict[str, ArticleResult]) -> None:
    contact = results["6a"].events[0]
    top = results["6a"].case.state[5] ** 2 / (2 * hoopgen.PAPER["gravity"])
    height = contact["before"][2] - results["6a"].case.state[2]
    assert 0 <= top - height < 0.01  # m


@pytest.mark.parametrize("slug", ["6b-wz0", "6b-wz2"])
def test_6b_swirls_on_the_ring_alone_ever_faster(
    results: dict[str, ArticleResult], slug: str
) -> None:
    result = results[slug]
    assert set(result.sequence) == {"ring"}
    assert len(result.sequence) >= 6
    contacts = result.events["time"][: len(result.sequence)]
    assert np.diff(contacts)[:6].max() == np.diff(contacts)[0]


def test_all_agree_and_only_a_capped_one_is_uncertain(results: dict[str, ArticleResult]) -> None:
    assert len(results) == 8
    for result in results.values():
        assert result.agrees, (result.case.name, result.differences)
        assert not result.uncertain or result.outcome is hoopgen.Outcome.CAPPED


@pytest.mark.parametrize("backend", ["numpy", "c"])
def test_every_backend_gives_the_same_events(
    results: dict[str, ArticleResult], backend: str
) -> None:
    try:
        again = run(backend=backend)
    except (ImportError, RuntimeError, ValueError):
        pytest.skip(f"no backend {backend} here")
    for result in again:
        np.testing.assert_array_equal(result.events, results[result.case.slug].events)


def _otherwise(result: ArticleResult, **changes: object) -> ArticleResult:
    shown = dataclasses.replace(result.case.shown, **changes)  # type: ignore[arg-type]
    return dataclasses.replace(result, case=dataclasses.replace(result.case, shown=shown))


@pytest.mark.parametrize(
    ("slug", "changes", "difference"),
    [
        ("5a", {"sequence": ("ring",)}, "another sequence"),
        ("5a", {"made": False}, "another outcome"),
        ("5d", {"touches": frozenset({"ring", "bridge"})}, "other surfaces"),
        ("5d", {"at_least": 9}, "fewer than 9 contacts"),
        ("5c", {"near_top": True, "sequence": None}, "contact not near the top"),
    ],
)
def test_what_a_figure_does_not_show_is_said(
    results: dict[str, ArticleResult], slug: str, changes: dict[str, object], difference: str
) -> None:
    changed = _otherwise(results[slug], **changes)
    assert not changed.agrees
    assert changed.differences == (difference,)


def test_another_hoop_may_disagree() -> None:
    (result,) = run(
        [case for case in CASES if case.figure == "5a"],
        parameters=hoopgen.PAPER | {"ring_radius": 0.16},
    )
    assert "another sequence" in result.differences


def test_a_case_is_frozen_and_its_parts_are_plain_data() -> None:
    case = Case("9z", "Test", (1, 2, 3, 4, 5, 6), CASES[0].shown)
    assert hash(case) == hash(Case("9z", "Test", (1, 2, 3, 4, 5, 6), CASES[0].shown))
    with pytest.raises(dataclasses.FrozenInstanceError):
        case.title = "other"  # type: ignore[misc]
