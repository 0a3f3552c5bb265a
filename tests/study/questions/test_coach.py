"""`coach`: gains against direct estimates, units of players, and the uncertainty of fits."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

for _library in ("pyarrow", "scipy"):
    pytest.importorskip(_library)

import hoopgen  # noqa: E402
from hoopgen import NBA, Scatter  # noqa: E402
from hoopgen.core.units import DEGREE  # noqa: E402
from hoopgen.hoop.arguments import arguments_of  # noqa: E402
from hoopgen.study.questions.coach_result import say  # noqa: E402
from tests.helpers.commands import failure, output  # noqa: E402
from tests.helpers.effort import trials  # noqa: E402

SHOTS = 20_000
PLAYER = Scatter(
    {"height": 2.13, "elevation": 52 * DEGREE, "speed": 7.19, "distance": 4.191, "backspin": 18.0},
    {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": 1.0 * DEGREE},
)


@pytest.mark.slow
def test_the_default_player_makes_the_share_that_is_asked() -> None:
    found = hoopgen.coach(makes=0.6, place="left wing three", parameters=NBA, shots=SHOTS)
    assert found.made == pytest.approx(0.6, abs=0.01)
    assert found.place is not None
    assert found.place.name == "left wing three"
    assert found.player.release["angle"] == pytest.approx(-np.pi / 4)
    assert "assumed" in found.provenance
    assert "Slegers" in str(found)


def test_gains_are_those_of_the_changed_players() -> None:
    found = hoopgen.coach(PLAYER, parameters=NBA, shots=SHOTS)
    before = hoopgen.estimate(PLAYER, NBA, shots=SHOTS).probability
    # The speed is that through the point aimed at: equal but for its last digits.
    assert found.made == pytest.approx(before, abs=3 / SHOTS)
    parts = {one.variable: one for one in found.spreads}
    assert set(parts) == {"speed", "elevation", "azimuth"}
    for name, one in parts.items():
        steadier = replace(PLAYER, sd={**PLAYER.sd, name: PLAYER.sd[name] / 2})
        after = hoopgen.estimate(steadier, NBA, shots=SHOTS).probability
        assert one.made == pytest.approx(after, abs=3 / SHOTS)
        assert one.gain == pytest.approx(one.made - found.made, abs=1e-12)
        assert (one.before, one.after) == (PLAYER.sd[name], PLAYER.sd[name] / 2)
        assert one.low < one.gain < one.high
    assert found.spreads[0].name == "short or long (speed)"
    assert found.advice.startswith("Practise short or long (speed) most")
    gains = [one.gain for one in found.habits]
    assert gains == sorted(gains, reverse=True)


def test_a_higher_arc_leads_through_the_same_point() -> None:
    found = hoopgen.coach(PLAYER, parameters=NBA, shots=2_000)
    assert "speed" not in found.player.release
    released = replace(found.player, sd={}).draw(0, 1, 0, NBA)
    speed = float(np.linalg.norm(released.states[0, 3:6]))
    assert speed == pytest.approx(PLAYER.release["speed"], rel=1e-12)


@pytest.mark.slow
def test_the_intervals_of_a_fitted_player_contain_the_sample() -> None:
    released = arguments_of(PLAYER.draw(0, 60, 3, NBA).states)
    columns = {name: released[name] for name in ("speed", "elevation", "azimuth")}
    fitted = Scatter.fit({"height": 2.13, "distance": 4.191, "backspin": 18.0, **columns})
    found = hoopgen.coach(fitted, parameters=NBA, shots=5_000)
    plain = hoopgen.coach(fitted.model, parameters=NBA, shots=5_000)
    assert found.made == plain.made
    assert found.low < plain.low < plain.high < found.high
    widths = {one.name: one.high - one.low for one in found.spreads}
    assert all(widths[one.name] > one.high - one.low for one in plain.spreads)


def test_values_are_said_in_the_units_of_players() -> None:
    assert say("speed", 7.15264) == "16.00 mph"
    assert say("backspin", 6 * np.pi) == "180 rpm"
    assert say("aim", -0.0508) == "\N{MINUS SIGN}2.0 in"
    assert say("height", 2.1336) == "7.0 ft"
    assert say("elevation", 52 * DEGREE) == "52.00\N{DEGREE SIGN}"


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"player": PLAYER, "place": "elbow"}, "place: it is of the default player"),
        ({"player": 3}, "player: expected a Scatter"),
        ({"player": Scatter({"speed": 7.0, "height": 2.0})}, "player|missing"),
        ({"makes": 1.5}, "makes"),
        ({"place": "elbwo"}, "is elbow meant"),
    ],
)
def test_what_cannot_be_coached_is_refused(options: dict[str, object], said: str) -> None:
    with pytest.raises((TypeError, ValueError), match=said):
        hoopgen.coach(shots=100, **options)  # type: ignore[arg-type]


@pytest.mark.slow
def test_the_command_speaks_feet_and_draws(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    words = ("coach", "--makes", "70%", "--place", "free throw", "--preset", "nba", "--shots", 2000)
    text = output(*words, "--picture", tmp_path / "advice.svg")
    assert "free throw (NBA rules: the free-throw line, 15 ft from the board)" in text
    assert "mph" in text
    assert "rpm" in text
    assert "m/s" not in text.split("The default player")[0]
    assert (tmp_path / "advice.svg").stat().st_size > 1000
    found = json.loads(output(*words, "--json"))
    assert found["place"]["name"] == "free throw"
    assert len(found["spreads"]) == 4


@pytest.mark.slow
def test_the_page_has_each_part_before_and_after_and_loads_nothing(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    page = tmp_path / "coach.html"
    words = ("coach", "--makes", "70%", "--preset", "nba", "--shots", 2000)
    output(*words, "--out", page)
    text = page.read_text(encoding="utf-8")
    found = hoopgen.coach(makes=0.7, parameters=NBA, shots=2000)
    assert found.advice in text
    for one in (*found.spreads, *found.habits):
        assert f"<td>{one.name}</td><td>{say(one.variable, one.before)}</td>" in text
    assert text.count("<img") == 2
    assert "http" not in text.replace("http-equiv", "")
    output(*words, "--out", tmp_path / "again.html")
    assert (tmp_path / "again.html").read_bytes() == page.read_bytes()
    assert "expected a file .html" in failure(*words, "--out", tmp_path / "coach.svg")


@pytest.mark.slow
def test_the_page_escapes_how_a_table_was_read(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    found = hoopgen.coach(PLAYER, parameters=NBA, shots=500)
    text = found.page(tmp_path / "a.html", read="<script>alert(1)</script>").read_text("utf-8")
    assert "<script" not in text
    assert "&lt;script&gt;" in text
    assert "Your shots" in text


@pytest.mark.slow
def test_the_command_reads_measured_releases(tmp_path: Path) -> None:
    file = tmp_path / "shots.csv"
    released = arguments_of(PLAYER.draw(0, 80, 5, NBA).states)
    rows = [
        f"{'Ann' if row % 2 else 'Bea'},{released['speed'][row]},"
        f"{np.degrees(released['elevation'][row])},{np.degrees(released['azimuth'][row])},7,13.75"
        for row in range(80)
    ]
    head = "player,speed_m_s,elevation_deg,azimuth_deg,height_ft,distance_ft"
    file.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    words = ("coach", "--from", file, "--shots", trials(2000), "--preset", "nba")
    text = output(*words, "--where", "player == Ann")
    assert "40 releases, 0 outliers" in text
    assert "straight at the centre" in text
    assert "--from has the player's releases" in failure(*words, "--makes", "70%")
    assert "give --from" in failure("coach", "--where", "player == Ann")
    assert "give --from" in failure("coach", "--override")


@pytest.mark.parametrize("command", ["coach", "best"])
def test_results_are_coached_in_their_scene(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Options contradict it with --override alone."""
    file, results, given = tmp_path / "shots.csv", tmp_path / "results.csv", list[float]()
    released = arguments_of(PLAYER.draw(0, 20, 5, NBA).states)
    rows = [
        f"{released['speed'][row]},{np.degrees(released['elevation'][row])},7,13.75"
        for row in range(20)
    ]
    head = "speed_m_s,elevation_deg,height_ft,distance_ft"
    file.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    output("batch", file, "--out", results, "--preset", "nba", "--set", "restitution=0.61")

    def stop(*values: object, **options: object) -> None:
        parameters = options.get("parameters") or values[1]
        given.append(dict(parameters)["restitution"])  # type: ignore[call-overload]
        raise ValueError("enough")

    monkeypatch.setattr(hoopgen, {"best": "best_shots"}.get(command, command), stop)
    for options in ((), ("--preset", "fiba", "--override")):
        assert "enough" in failure(command, "--from", results, *options)
    assert given == [0.61, hoopgen.FIBA["restitution"]]
    said = failure(command, "--from", results, "--preset", "fiba")
    assert "expected NBA, restitution 0.61, got FIBA" in said


def test_advice_names_its_scene_shots_and_seed(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    found = hoopgen.coach(PLAYER, parameters=NBA | {"gravity": 9.8}, shots=1_500, seed=7)
    record = json.loads(json.dumps(found.as_dict()))
    assert (record["shots"], record["seed"]) == (1_500, 7)
    assert record["scene"] == "NBA, gravity 9.8 m/s²"
    assert record["parameters"]["gravity"] == 9.8
    said = {"scene": record["scene"], "shots": "1,500 before and after each change", "seed": "7"}
    assert found.origin == said
    assert str(found).endswith(
        "scene    NBA, gravity 9.8 m/s²\nshots    1,500 before and after each change\nseed     7"
    )
    sentences = "Scene: NBA, gravity 9.8 m/s². Shots: 1,500 before and after each change. Seed: 7."
    label = found.plot().axes[0].get_xlabel()
    assert sentences in label.replace("\n", " ").replace("\N{NO-BREAK SPACE}", " ")
    assert sentences in found.page(tmp_path / "a.html").read_text("utf-8")
