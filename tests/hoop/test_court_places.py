"""Named places: the rule books' distances, sides, and everywhere that a place is asked."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import hoopgen
from hoopgen import FIBA, NBA, PAPER
from hoopgen.core.units import FOOT
from hoopgen.hoop.court_lines import COURTS, lines_of
from hoopgen.hoop.court_places import PLACES, find_place
from tests.helpers.commands import failure, output


@pytest.mark.parametrize(
    ("name", "court", "x", "y"),
    [
        ("free throw", "NBA", 13.75 * FOOT, 0.0),
        ("free throw", "FIBA", 4.6 - FIBA["board_distance"], 0.0),
        ("top of the key", "NBA", 19.75 * FOOT, 0.0),
        ("elbow", "NBA", 13.75 * FOOT, 8 * FOOT),
        ("left elbow", "NBA", 13.75 * FOOT, -8 * FOOT),
        ("top three", "NBA", 23.75 * FOOT, 0.0),
        ("top three", "FIBA", 6.75, 0.0),
        ("corner three", "NBA", 0.0, 22 * FOOT),
        ("left corner three", "FIBA", 0.0, -6.6),
        ("wing three", "FIBA", 6.75 * 2**-0.5, 6.75 * 2**-0.5),
        ("half court", "NBA", 41.75 * FOOT, 0.0),
        ("half court", "FIBA", 12.8 - FIBA["board_distance"], 0.0),
    ],
)
def test_places_are_where_the_rule_books_say(name: str, court: str, x: float, y: float) -> None:
    found = find_place(name, {"NBA": NBA, "FIBA": FIBA}[court])
    assert found.court == court
    assert (found.x, found.y) == pytest.approx((x, y), rel=1e-12, abs=1e-12)
    polar = {"distance": np.hypot(x, y), "angle": np.arctan2(y, x)}
    assert found.variables == pytest.approx(polar, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("court", list(COURTS))
def test_places_on_lines_lie_on_the_lines_that_are_drawn(court: str) -> None:
    hoop = FIBA if court == "FIBA" else NBA
    lines = lines_of(COURTS[court], hoop["board_distance"])

    def away(name: str, line: str) -> float:
        """Return the distance of a place from the corners of a line and the pieces between."""
        one = find_place(name, hoop)
        point, points = np.array([one.x, one.y]), lines[line]
        start, step = points[:-1], np.diff(points, axis=0)
        along = np.clip(np.sum((point - start) * step, axis=1) / np.sum(step**2, axis=1), 0, 1)
        return float(np.min(np.hypot(*(start + along[:, None] * step - point).T)))

    for name in ("top three", "left wing three", "corner three", "left corner three"):
        assert away(name, "three") < 1e-3, name
    for name in ("free throw", "elbow", "left elbow"):
        assert away(name, "lane") < 1e-12, name
    assert away("top of the key", "circle") < 1e-3
    assert away("half court", "middle") < 1e-12


def test_names_are_read_as_people_write_them() -> None:
    corner = hoopgen.place("corner three", NBA)
    for name in ("Corner Three", "right corner 3", "corner-three", "right_corner_three", "corner"):
        assert hoopgen.place(name, NBA) == corner
    assert hoopgen.place("left corner three", NBA)["angle"] == -corner["angle"]
    assert hoopgen.place("foul line") == hoopgen.place("free-throw line", PAPER)
    assert hoopgen.place("top three", court="FIBA")["distance"] == 6.75
    assert hoopgen.place("elbow", court="FIBA") == hoopgen.place("elbow", FIBA)
    assert find_place("elbow").name == "right elbow"


@pytest.mark.parametrize("name", PLACES)
@pytest.mark.parametrize("court", COURTS)
def test_every_place_says_its_source(name: str, court: str) -> None:
    source = find_place(name, court=court).source
    assert source.startswith(f"{court} rules: ")
    assert (" m" if court == "FIBA" else " ft") in source


@pytest.mark.parametrize(
    ("name", "court", "said"),
    [
        ("corner tree", None, "is corner three meant"),
        ("left free throw", None, "left or right before elbow"),
        ("", None, "expected one of free throw"),
        ("elbow", "NCAA", "court: expected NBA or FIBA"),
        (3, None, "place: expected the name"),
    ],
)
def test_other_names_are_refused(name: str, court: str | None, said: str) -> None:
    with pytest.raises((TypeError, ValueError), match=said):
        hoopgen.place(name, court=court)


PLAYER = ("--speed", "9.3", "--elevation", "51deg", "--height", "7ft")


def test_commands_take_a_place_for_distance_and_angle() -> None:
    pytest.importorskip("scipy")
    here = hoopgen.place("left corner three", FIBA)
    for command, more in (("shot", ()), ("estimate", ("--shots", 500, "--scatter", "speed=0.1"))):
        words = (command, *PLAYER, "--preset", "fiba", "--json", *more)
        there = ("--distance", repr(here["distance"]), "--angle", f"{here['angle']!r}rad")
        named, plain = (
            json.loads(output(*words, *place)) for place in (("--place", "left corner 3"), there)
        )
        assert named == plain
    words = ("--height", "7ft", "--preset", "fiba")
    distance = repr(hoopgen.place("free throw", FIBA)["distance"])
    text = output("aim", "--place", "free throw", *words)
    assert text == output("aim", "--distance", distance, *words)


def test_commands_refuse_two_places_and_unknown_ones() -> None:
    words = ("shot", *PLAYER, "--place")
    assert "--place says where; leave out --angle" in failure(*words, "elbow", "--angle", "3deg")
    assert "is elbow meant" in failure(*words, "elbwo")
    assert "missing --distance (or --place" in failure("estimate", *PLAYER)


def test_a_table_takes_its_own_rule_book(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    table = tmp_path / "shots.csv"
    table.write_text("speed_m_s,elevation_deg\n9.3,51\n9.4,52\n", encoding="utf-8")
    words = ("--release", "height=7ft", "--place", "top three", "--preset", "fiba")
    text = output("batch", table, "--out", tmp_path / "out.csv", *words)
    assert "distance 6.75 m" in text
    again = ("estimate", "--from", tmp_path / "out.csv", "--place", "top three", "--shots", 100)
    assert "distance 6.75 m" in output(*again)


def test_a_study_file_takes_a_place(tmp_path: Path) -> None:
    for library in ("pydantic", "pyarrow", "xarray", "matplotlib"):
        pytest.importorskip(library)
    file = tmp_path / "study.toml"
    head = '[study]\nname = "places"\n[scene]\npreset = "{}"\n'
    release = '[release]\nheight = "7 ft"\nspeed = "7.2 m/s"\nelevation = "52 deg"\n'
    question = '[[question]]\nkind = "estimate"\nname = "made"\nshots = 100\n'
    other = (
        '[[question]]\nkind = "estimate"\nname = "other"\nshots = 100\n'
        '[question.release]\nplace = "left elbow"\n'
    )
    for preset, distance in (("nba", 4.191), ("fiba", 4.222)):
        text = head.format(preset) + release + 'place = "free throw"\n' + question + other
        file.write_text(text, encoding="utf-8")
        hoopgen.run_study(file, tmp_path / preset)
        answer = json.loads((tmp_path / preset / "made" / "answer.json").read_text("utf-8"))
        assert f"distance {distance} m" in answer["text"]
        other_text = (tmp_path / preset / "other" / "answer.json").read_text("utf-8")
        assert "left elbow" not in other_text
        assert "angle \\u2212" in other_text or "angle \u2212" in other_text
    file.write_text(text.replace("free throw", "free thow"), encoding="utf-8")
    with pytest.raises(Exception, match="is free throw meant"):
        hoopgen.run_study(file, tmp_path / "wrong")


def test_a_place_is_of_one_hoop() -> None:
    with pytest.raises(ValueError, match=r"parameters\['board_distance'\]: a place needs one num"):
        hoopgen.place("free throw", {"board_distance": [0.3, 0.4]})
