"""docs/validation.md: its closed forms, and that these sources wrote it."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

from tests.helpers import ROOT

for needed in ("matplotlib", "pyarrow", "scipy", "xarray"):
    pytest.importorskip(needed)

import hoopgen  # noqa: E402
from benchmarks import (  # noqa: E402
    validation_contacts,
    validation_court,
    validation_further,
    validation_page,
)
from benchmarks import validation_results as validation  # noqa: E402
from benchmarks.free_throw import LINE  # noqa: E402
from benchmarks.report import section_of, with_section  # noqa: E402
from hoopgen.core.units import DEGREE  # noqa: E402
from hoopgen.plots import save  # noqa: E402
from hoopgen.study.questions.aim_points import on_board  # noqa: E402

pytestmark = pytest.mark.sampled(1)


EPS = float(np.finfo(float).eps)


def test_the_slowest_free_throw_is_that_of_the_closed_form() -> None:
    angle, speed, entry, depth = validation.closed_forms()
    # A minimum is flat: its place is known to the root of the rounding unit, in degrees here.
    assert abs(angle.ours - angle.closed) < math.sqrt(EPS) * 180 / math.pi
    # A dozen operations, each within half a unit.
    assert abs(speed.ours - speed.closed) < 8 * EPS * speed.closed
    assert abs(entry.ours - entry.closed) < 8 * EPS * entry.closed
    assert abs(depth.ours) < 8 * EPS * LINE["distance"]


def test_the_smallest_entry_angle_is_that_of_a_round_wire() -> None:
    for one in validation.smallest_entries():
        # Bisected to 1e-9; the flight falls by less than a rounding of its path.
        assert one.straight == pytest.approx(one.wire, abs=2e-9)
        assert one.thrown < one.edge < one.wire


@pytest.mark.parametrize("restitution", [0.5, 0.7, 1.0])
@pytest.mark.parametrize("azimuth", [-0.12, 0.02])
def test_bank_releases_through_the_middle_point_at_the_axis(
    restitution: float, azimuth: float
) -> None:
    scene = hoopgen.PAPER | {"restitution": restitution}
    arguments = {"speed": 6.75, "elevation": 0.97, "azimuth": azimuth, "backspin": 18.0}
    arguments |= {"sidespin": 0.0, "height": 2.1, "distance": 3.0, "angle": 0.9}
    state = hoopgen.release(**arguments)
    events = hoopgen.simulate(state, scene, record=True).events
    assert events["surface"][0] == hoopgen.SURFACES.index("backboard")
    x, y, _, vx, vy = events["after"][0][:5]
    # Seen from above, the ball crosses x = 0 here; the whole shot is moved along the board, so
    # that it is in the middle of the ring.
    aside = y - x * vy / vx
    start = state[:2] - [0.0, aside]
    sight = np.array([-scene["board_distance"], on_board(arguments, scene)["sight_y"] - aside])
    behind = sight[1] / (start[1] - sight[1]) * (start[0] - sight[0])
    expected = _axis(restitution)
    # Errors of eps at some metres, over the sine of the angle to the axis.
    assert behind == pytest.approx(expected, abs=1e-13)


def _axis(restitution: float) -> float:
    assert validation.restitution_of_axis(validation.axis_behind(restitution)) == pytest.approx(
        restitution, rel=8 * EPS, abs=0.0
    )
    return validation.axis_behind(restitution)


@pytest.mark.parametrize("kind", validation_court.KINDS)
def test_every_shot_that_changes_on_the_whole_hoop_has_a_reason(kind: str) -> None:
    found = validation_court.changes(validation_court.KINDS[kind](4000))
    assert 0 < found.changed == sum(found.reasons.values()) < found.shots


def test_shots_that_the_hoop_gives_up_are_followed_to_their_end_on_the_whole_hoop() -> None:
    states = validation_court.KINDS["swirls"](4000)
    given_up = hoopgen.simulate(states, hoopgen.PAPER).outcome == hoopgen.Outcome.CAPPED
    assert 0 < np.count_nonzero(given_up) <= validation_court.changes(states).changed


def test_the_whole_hoops_table_on_file_is_of_these_sources() -> None:
    text = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
    assert "\n".join(validation_court.section()) in text


def test_the_page_on_file_is_of_these_sources() -> None:
    text = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
    said = validation_page.closed_forms(validation.closed_forms(), validation.smallest_entries())
    assert "\n".join(said) in text
    for picture in ("throws", "bank", "bounces", "contacts"):
        picture = f"validation-{picture}.svg"
        assert f"({picture})" in text
        assert (ROOT / "docs" / picture).exists()


def test_the_probabilities_on_file_are_those_of_the_engine() -> None:
    text = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
    theirs = validation.recipe(50_000)
    said = validation_page.share(theirs.probability, theirs.low, theirs.high)
    assert f"| their release, 52° and 5.4 cm | 70%, assumed in 2011 | {said} |" in text
    assert f"({theirs.capped} of the 50,000 shots below" in text
    # The release of the tables of scatter is written above them, to the digits it is thrown with.
    given = re.search(r"rounded as in the table above \((\S+)°, (\S+) cm\)", text)
    assert given is not None
    best = validation.free_throw(*(float(number.replace("−", "-")) for number in given.groups()))
    for name, sds, said_sd in (
        ("speed", (0.05, 0.13), lambda sd: f"{sd:.2f} m/s"),
        ("elevation", (1.04 * DEGREE,), lambda sd: f"{sd / DEGREE:.2f}°"),
    ):
        curve = validation.success(best, name, sds, 50_000)
        rows = zip(sds, curve.probability, curve.low, curve.high, strict=True)
        for sd, *chance in rows:
            assert f"| {said_sd(sd)} | {validation_page.share(*chance)} |" in text


def test_only_a_zero_loses_its_minus_sign() -> None:
    checks = [
        validation.Check("below", -1.5, -1.5, "m"),
        validation.Check("nothing", -8.9e-16, 0.0, "m"),
    ]
    below, nothing = validation_page.closed_forms(checks, validation.smallest_entries())[6:8]
    assert below.startswith("| below | −1.500000000 m | −1.500000000 m |")
    assert nothing.startswith("| nothing | 0.000000000 m | 0.000000000 m |")


def test_a_small_run_fills_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fewer = {"BACKSPINS": (0, 3), "HEIGHTS": (6.0, 8.0), "RESTITUTIONS": (0.7,), "ANGLES": (0, 60)}
    for name, values in fewer.items():
        monkeypatch.setattr(validation, name, values)
    monkeypatch.setattr(validation_page, "ANGLES", validation.ANGLES)
    results = validation.everything(300, 150, (9, 11))
    lines = validation_page.page(results, ["## Coverage", ""], ["## Further", ""]).splitlines()
    assert "## Coverage" in lines
    assert not [line for line in lines if "nan" in line]
    cells = [line for line in lines if line.startswith(("| 9 ft", "| 11 ft"))]
    assert [line.count("±") for line in cells] == [len(validation.ANGLES)] * 2
    save(validation_page.throw_picture(results), tmp_path / "throws.png")
    # Steadier players make more, and backspin helps: trends that a few hundred shots show.
    chance = results.by_speed.probability
    assert chance[0] > chance[-1] + 0.15
    spins = results.line.by_spin
    assert spins[3].probability > spins[0].probability


def test_steady_rolls_are_stable_where_the_page_says() -> None:
    """By integration of the rolling ball's equations from near them."""
    integrate = pytest.importorskip("scipy.integrate")
    low, high, speed = validation_further._steady_rolls()
    assert speed == pytest.approx(0.924, abs=5e-4)  # at 135 degrees, derived elsewhere
    ring = hoopgen.NBA["ring_radius"]
    radius = hoopgen.NBA["ball_radius"] + hoopgen.NBA["wire_radius"]
    for a, stays in (
        (low + 0.02, True),
        (0.5 * (low + high), True),
        (high - 0.02, True),
        (low - 0.05, False),
    ):
        away = ring + radius * math.cos(a)
        steady = math.sqrt(-0.6 * hoopgen.PAPER["gravity"] * away / math.tan(a))
        path = integrate.solve_ivp(
            lambda _, y: validation_further.roll(*y),
            (0.0, 3.0),
            [a + 1e-4, 0.0, steady, 0.0],
            rtol=1e-10,
            atol=1e-12,
            events=_left,
        )
        far = float(np.max(np.abs(path.y[0] - a)))
        assert (far < 2e-2) == stays


def _left(_: float, y: np.ndarray) -> float:
    """Return 0 when the ball is a radian off."""
    return float(np.sin(y[0]))


_left.terminal = True  # type: ignore[attr-defined]


def test_noahs_depth_is_past_the_middle_of_an_eighteen_inch_hoop() -> None:
    past = validation_further.NOAH_DEPTH - 0.5 * validation_further.HOOP
    assert past == pytest.approx(0.0508)


def test_the_page_has_the_further_results() -> None:
    page = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
    lines = section_of(page, validation_further.HEADING)
    assert with_section(page, lines) == page
    assert all(f"- {source}" in page for source in validation_further.SOURCES)
    first, last, speed = validation_further._steady_rolls()
    said = f"stable and in contact from {math.degrees(first):.1f}° to {math.degrees(last):.1f}°"
    assert any(said in line and f"{speed:.3f} m/s" in line for line in lines)


def test_the_map_of_first_contacts_is_that_of_single_shots() -> None:
    found = validation_contacts.first_contacts(21)
    names = np.array(validation_contacts.NAMES)
    assert set(names[found.first].ravel()) == set(names)
    for row, column in np.ndindex(found.first.shape):
        release = LINE | {"speed": found.speed[column]}
        state = hoopgen.release(**release, elevation=found.angle[row] * DEGREE)
        shots = hoopgen.simulate(state, hoopgen.NBA_COURT, scene=hoopgen.COURT, record=True)
        first = shots.events[:1]
        name = "nothing"
        if first["surface"][0] < len(hoopgen.COURT.surfaces):
            name = hoopgen.COURT.surfaces[first["surface"][0]]
        if name == "ring":
            name = f"{'front' if first['before'][0, 0] > 0.0 else 'back'} of the ring"
        assert names[found.first[row, column]] == name
        assert found.made[row, column] == shots.made[0]
        assert np.isfinite(found.landing[row, column]) == (shots.outcome[0] == 1)
    shares = validation_contacts.first_contacts().shares()
    page = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
    assert f"nothing {100 * shares['nothing']:.1f}%, front of the ring" in page
    assert f"bridge {100 * shares['bridge']:.1f}%; " in page


def test_one_or_two_factors_differ_for_most_players() -> None:
    """As the page says."""
    found = validation_further.differing_factors()
    page = (ROOT / "docs" / "validation.md").read_text(encoding="utf-8")
    counts = [f"{said} {found[name].sum()}" for name, said in validation_further.FACTORS.items()]
    assert ", ".join(counts) in page
    few = np.sum(list(found.values()), axis=0)
    assert f"one or two factors differ for {np.sum((few == 1) | (few == 2))} players" in page
    assert found["speed"].sum() > 3 * found["height"].sum()
