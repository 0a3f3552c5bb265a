"""`calibrate`: intervals that hold, and parameters that shots do not tell."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("scipy")

import hoopgen
from hoopgen import NBA, calibrate
from hoopgen.results.shots import SURFACES
from hoopgen.study.recovery.outcomes import Outcomes
from tests.helpers.commands import failure, output
from tests.helpers.effort import trials

ERRORS = {"speed": 0.03, "elevation": 0.008, "azimuth": 0.008}
PLACE = {"height": 2.1336, "distance": 4.191, "backspin": 18.0}


def shots(count: int, seed: int, restitution: float, wide: float = 0.12) -> dict[str, Any]:
    """Return measured releases, with how shots of the true ones end."""
    random = np.random.default_rng(seed)
    true = {
        "speed": random.normal(7.2, wide, count),
        "elevation": random.normal(0.9, 0.03, count),
        "azimuth": random.normal(0, 0.02, count),
    }
    ended = hoopgen.simulate(hoopgen.release(**true, **PLACE), NBA | {"restitution": restitution})
    measured = {name: one + ERRORS[name] * random.normal(size=count) for name, one in true.items()}
    return {**measured, **PLACE, "made": ended.made, "contacts": ended.contacts}


def find(table: Any, vary: Any = ("restitution",), **options: Any) -> Any:
    given = {"draws": 40, "errors": ERRORS, "parameters": NBA, **options}
    return calibrate(table, vary, **given)


def test_contacts_and_outcomes_find_the_restitution() -> None:
    found = find(shots(400, 1, 0.55)).values["restitution"]
    assert found.low < 0.55 < found.high
    assert found.high - found.low < 0.3
    assert found.bounded == (True, True)
    assert found.profile.max() == 0.0


@pytest.mark.slow
def test_outcomes_alone_say_less_than_contacts() -> None:
    table = shots(400, 2, 0.6)
    both = find(table).values["restitution"]
    del table["contacts"]
    alone = find(table).values["restitution"]
    assert alone.low < 0.6 < alone.high
    assert alone.high - alone.low > both.high - both.low


def test_a_parameter_that_no_shot_shows_is_not_identified() -> None:
    """Shots that swish say nothing of what they do not touch."""
    table = {**PLACE, "speed": np.full(20, 7.18), "elevation": 0.9, "made": np.ones(20)}
    result = find(table, errors={"speed": 0.001})
    found = result.values["restitution"]
    assert not found.identified
    assert (found.low, found.high) == (0.3, 0.95)
    assert "not identified" in str(result)


@pytest.mark.slow
def test_the_intervals_hold() -> None:
    count, inside = trials(40, 25), 0
    for seed in range(count):
        found = find(shots(120, 100 + seed, 0.65), draws=60).values["restitution"]
        inside += found.low <= 0.65 <= found.high
    assert inside / count > 0.95 - 0.02 - 3 * np.sqrt(0.05 * 0.95 / count)


def test_two_parameters_are_varied_together() -> None:
    table = shots(60, 3, 0.6)
    bounds = {"restitution": (0.5, 0.7), "board_distance": (0.37, 0.39)}
    found = find(table, bounds, draws=10)
    assert list(found.values) == list(bounds)
    assert found.parameters["restitution"] == found.values["restitution"].value
    one = find(table, {"restitution": (0.5, 0.7)}, draws=10)
    assert found.log_likelihood >= one.log_likelihood - 1e-9 - 3 * found.noise


def test_fitted_releases_bring_their_errors() -> None:
    random = np.random.default_rng(4)
    times = np.arange(0, 0.5, 1 / 60)
    # To the side too: shots in the plane of symmetry end as none beside it do.
    speed, azimuth = random.normal(7.2, 0.12, 40), random.normal(0.0, 0.02, 40)
    states = hoopgen.release(speed, 0.9, azimuth, **PLACE)
    fall = np.array([0, 0, -0.5 * NBA["gravity"]])
    path = states[:, None, :3] + states[:, None, 3:6] * times[:, None] + fall * times[:, None] ** 2
    noisy = path + random.normal(0, 0.01, path.shape)
    fitted = hoopgen.fit_release(times, noisy, parameters=NBA, noise=0.01, backspin=18.0)
    made = hoopgen.simulate(states, NBA).made
    found = calibrate(fitted, ("restitution",), made=made, parameters=NBA, draws=30)
    assert found.values["restitution"].low <= 0.7 <= found.values["restitution"].high
    with pytest.raises(ValueError, match="errors: fitted releases have their own"):
        calibrate(fitted, ("restitution",), made=made, errors={"speed": 0.1})


def ended(count: int, seed: int, restitution: float, error: float = 0.1) -> dict[str, Any]:
    """Return measured releases, with the body touched first and the place of rebounds."""
    random = np.random.default_rng(seed)
    true = {
        "speed": random.normal(7.2, 0.12, count),
        "elevation": random.normal(0.9, 0.03, count),
        "azimuth": random.normal(0, 0.02, count),
    }
    states = hoopgen.release(**true, **PLACE)
    hoop = NBA | {"restitution": restitution}
    shots = hoopgen.simulate(states, hoop)
    found = hoopgen.measure(states, shots, hoop, ["rebound_x", "rebound_y"])
    places = {n: one + error * random.normal(size=count) for n, one in found.items()}
    measured = {name: one + ERRORS[name] * random.normal(size=count) for name, one in true.items()}
    names = np.array(["ring", "backboard", "bridge", "none"], dtype=object)
    return {**measured, **PLACE, **places, "made": shots.made, "first": names[shots.first]}


@pytest.mark.slow
def test_rebounds_tell_more_than_outcomes() -> None:
    table = ended(300, 26, 0.6)
    with_places = find(table, rebound_error=0.1)
    assert with_places.used == ("made", "first", "rebound")
    assert "rebounds" in str(with_places)
    there = with_places.values["restitution"]
    alone = find({n: one for n, one in table.items() if "rebound" not in n}).values["restitution"]
    assert there.low < 0.6 < there.high
    assert there.high - there.low < 0.7 * (alone.high - alone.low)


def test_the_body_touched_first_tells_more_than_the_outcome() -> None:
    """A simulated shot agrees if it ends alike and touches the same body first."""
    table = {n: one for n, one in ended(200, 8, 0.6).items() if "rebound" not in n}
    draws = Outcomes.read(
        {"made": table["made"], "first": table["first"]}, 200, SURFACES, 2, 0, 1, 0
    )
    assert draws.used == ("made", "first")
    states = np.broadcast_to(
        hoopgen.release(**{n: table[n] for n in ERRORS}, **PLACE)[:, None], (200, 2, 9)
    )
    shots = hoopgen.simulate(states[:, 0], NBA)
    hits, valid = draws.hits(states, NBA, hoopgen.HOOP)
    assert draws.first is not None
    expected = (shots.made == table["made"]) & (shots.first == draws.first)
    assert (hits[:, 0] == expected).all()
    assert valid.all()
    assert 0 < expected.sum() < 200


def test_what_is_not_known_of_a_shot_is_left_out_of_its_likelihood() -> None:
    table = ended(60, 7, 0.6)
    dropped = {n: one for n, one in table.items() if n not in ("first", "rebound_x", "rebound_y")}
    nothing = {"first": np.full(60, ""), "rebound_x": np.full(60, np.nan)}
    nothing |= {"rebound_y": nothing["rebound_x"], "contacts": np.full(60, np.nan)}
    one, other = find(dropped, draws=10), find({**dropped, **nothing}, draws=10)
    profiles = [each.values["restitution"].profile for each in (one, other)]
    np.testing.assert_allclose(profiles[0], profiles[1], rtol=0, atol=1e-9)


@pytest.mark.slow
def test_the_intervals_hold_with_rebounds() -> None:
    count, inside = trials(40, 25), 0
    for seed in range(count):
        found = find(ended(120, 300 + seed, 0.65), draws=60, rebound_error=0.1)
        one = found.values["restitution"]
        inside += one.low <= 0.65 <= one.high
    assert inside / count > 0.95 - 0.02 - 3 * np.sqrt(0.05 * 0.95 / count)


def test_errors_may_differ_from_shot_to_shot() -> None:
    table = shots(60, 3, 0.6)
    same = {name: np.full(60, sd) for name, sd in ERRORS.items()}
    one, other = find(table, draws=10), find(table, draws=10, errors=same)
    assert one.log_likelihood == other.log_likelihood


def written(file: Path, table: dict[str, Any]) -> Path:
    """Write a table as a tracking system would: feet, mph, degrees and words."""
    rows = len(table["made"])
    columns = {
        "speed_mph": table["speed"] / 0.44704,
        "elevation_deg": np.degrees(table["elevation"]),
        "azimuth_deg": np.degrees(table["azimuth"]),
        "backspin_rpm": np.full(rows, 18.0 * 60 / (2 * np.pi)),
        "height_ft": np.full(rows, 7.0),
        "distance_ft": np.full(rows, 13.75),
        "made": np.where(table["made"], "made", "missed"),
        "first": table["first"],
        "rebound_x_ft": table["rebound_x"] / 0.3048,
        "rebound_y_ft": table["rebound_y"] / 0.3048,
    }
    lines = [",".join(columns)]
    for row in zip(*columns.values(), strict=True):
        lines.append(",".join("" if one != one else str(one) for one in row))
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return file


@pytest.mark.slow
def test_the_command_reads_outcomes_and_draws_profiles(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    pytest.importorskip("matplotlib")
    table = ended(80, 11, 0.6)
    file = written(tmp_path / "shots.csv", table)
    errors = [f"{name}={sd}{'rad' if name != 'speed' else ''}" for name, sd in ERRORS.items()]
    words = ["calibrate", file, "--vary", "restitution", "--preset", "nba", "--draws", 20]
    words += [word for one in errors for word in ("--instrument", one)]
    text = output(*words, "--rebound-error", "10cm", "--picture", tmp_path / "profile.svg")
    assert "of the outcomes, first bodies touched, rebounds of 80 shots" in text
    assert "rebound_x from rebound_x_ft" in text
    assert (tmp_path / "profile.svg").stat().st_size > 1000
    found = json.loads(output(*words, "--rebound-error", "10cm", "--json"))
    again = find(table, draws=20, rebound_error=0.1)
    value = again.values["restitution"]
    assert found["values"]["restitution"]["value"] == value.value
    assert found["log_likelihood"] == pytest.approx(again.log_likelihood, abs=0.5)
    assert json.loads(output(*words, "--ignore", "rebound", "--json"))["used"] == ["made", "first"]
    assert "no column result" in failure(*words, "--made", "result")
    assert "missing --vary" in failure("calibrate", file)
    none = failure(*words, "--where", "speed_mph > 99")
    assert f"--where: no row of {file} meets it" in none


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Return results of a batch: of a table that says what was seen, and of one that does not."""
    pytest.importorskip("pyarrow")
    folder = tmp_path_factory.mktemp("results")
    table = written(folder / "shots.csv", ended(trials(40, 20), 12, 0.6))
    rows = [row.split(",") for row in table.read_text(encoding="utf-8").splitlines()]
    made, first = (rows[0].index(name) for name in ("made", "first"))
    seen, unseen = folder / "seen.csv", folder / "unseen.csv"
    found = folder / "seen-results.csv", folder / "results.csv"
    for file, out in zip((seen, unseen), found, strict=True):
        kept = [row[:first] + row[first + 1 :] if file is seen else row[:made] for row in rows]
        file.write_text("".join(f"{','.join(row)}\n" for row in kept), encoding="utf-8")
        output("batch", file, "--out", out, "--preset", "fiba", "--set", "restitution=0.9")
    return found


VARIED = ("--vary", "restitution", "--instrument", "speed=3cm/s", "--draws", 2)


def test_simulated_results_are_no_observations(results: tuple[Path, Path]) -> None:
    """Only a result that is named is one, and what the command says it does not read it does not.

    The shots ended with a restitution of 0.6, and were simulated with 0.9.
    """
    seen, unseen = results
    said = failure("calibrate", unseen, *VARIED)
    assert "--made: the column outcome is a result of a simulation" in said
    text = output("calibrate", unseen, *VARIED, "--made", "outcome")
    assert "outcomes: made from outcome\n" in text
    assert "earlier results, not read: kind, contacts, ring_contacts" in text
    text = output("calibrate", seen, *VARIED, "--rebound-error", "10cm")
    first, *_ = (line for line in text.splitlines() if line.startswith("outcomes: "))
    assert first == (
        "outcomes: made from made, rebound_x from rebound_x_ft, rebound_y from rebound_y_ft"
    )
    assert "earlier results, not read: outcome, kind, contacts, ring_contacts" in text


def test_a_calibration_is_in_the_scene_of_the_results(results: tuple[Path, Path]) -> None:
    """Options contradict it in what varies alone; --override asks for another scene."""
    words = ("calibrate", results[1], *VARIED, "--made", "outcome")
    text = output(*words)
    assert "\nscene FIBA; restitution varied\n" in text
    assert output(*words, "--preset", "fiba") == text
    assert output(*words, "--preset", "nba", "--override") != text
    assert json.loads(output(*words, "--json"))["scene"] == "FIBA"
    said = failure(*words, "--preset", "nba")
    assert "expected FIBA, restitution 0.9, got NBA, restitution 0.9" in said
    assert "--override" in said


@pytest.mark.parametrize(
    ("changes", "options", "said"),
    [
        ({"made": None}, {}, "made"),
        ({"made": np.full(5, 2)}, {}, "made: expected true or false"),
        ({"speed": None}, {}, "table: missing speed"),
        ({}, {"errors": None}, "errors: expected standard errors"),
        ({}, {"vary": ("bounce",)}, "vary: .*bounce"),
        ({}, {"vary": ("board_distance",)}, "vary: board_distance has no usual bounds"),
        ({}, {"vary": {"restitution": (0.9, 0.2)}}, "vary: restitution: expected low below high"),
        ({}, {"vary": ()}, "vary: expected one to three"),
        ({"first": np.array(["ring", "net", "", "none", ""])}, {}, "first: expected ring.*net"),
        ({"contacts": np.full(5, 0.5)}, {}, "contacts: expected whole numbers"),
        ({"rebound_x": np.ones(5)}, {}, "rebound_x: a rebound has a place"),
        (
            {"rebound_x": np.ones(5), "rebound_y": np.ones(5)},
            {"rebound_error": -1.0},
            "rebound_error: expected a number",
        ),
        ({}, {"catching_height": 0.0}, "catching_height"),
        ({"contacts": np.zeros(3)}, {}, "contacts: expected a value for each"),
    ],
)
def test_what_cannot_be_calibrated_is_refused(changes: Any, options: Any, said: str) -> None:
    table = {name: one for name, one in (shots(5, 5, 0.7) | changes).items() if one is not None}
    with pytest.raises(ValueError, match=said):
        find(table, options.pop("vary", ("restitution",)), **options)
